// A recorded calculation, played: solver(data) -> (inputs…, out, upto) => …. The data are those of
// vad/page/solver.py. The function writes the outputs to out, an array of floats, of all stages up
// to the given one; a truth value becomes 1 or 0.

const DIGITS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
// How many operands each operation has.
const OPERANDS = COUNTS;
const { abs, atan2, sqrt } = Math;

const copysign = (size, sign) => (sign < 0 || 1 / sign < 0 ? -abs(size) : abs(size));

// The same angle within ±180°, of two the one that an even number of turns leads to: the remainder
// of IEEE 754.  No step rounds.  No zero is negative.
const fold = (degrees) => {
  const rest = degrees % 720;
  const size = abs(rest);
  const turn = size >= 540 ? 720 : size > 180 ? 360 : 0;
  return (rest < 0 ? rest + turn : rest - turn) + 0;
};

function solver({ inputs, constants, code, outputs, ends }) {
  const first = inputs + constants.length, size = first + ends.at(-1);
  const v = new Float64Array(size), [does, as, bs, cs] = [0, 1, 2, 3].map(() => new Int32Array(size));
  let at = 0;
  const digit = (text) => DIGITS.indexOf(text[at++]);
  const place = (text, from) => {
    let number = 0, bits = 0, more;
    do {
      more = digit(text);
      number += (more & 31) << bits;
      bits += 5;
    } while (more > 31); // the last digit is less
    return number & 1 ? number >> 1 : from - (number >> 1);
  };
  v.set(constants.map(Number), inputs);
  for (let i = first; i < size; i++) {
    does[i] = digit(code);
    for (let k = 0; k < OPERANDS[does[i]]; k++) [as, bs, cs][k][i] = place(code, i);
  }
  at = 0;
  const places = [];
  while (at < outputs.length) places.push(place(outputs, size)); // each takes a digit or more
  return (...given) => {
    const upto = given.pop(), out = given.pop(), end = first + ends[Math.min(upto, ends.length - 1)];
    v.set(given);
    for (let i = first; i < end; i++) {
      const a = as[i], b = bs[i], c = cs[i];
      switch (does[i]) { OPERATIONS }
    }
    for (let i = 0; i < places.length; i++) if (places[i] < end) out[i] = v[places[i]];
  };
}
