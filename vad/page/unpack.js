// What a page carries packed: text as UTF-8, compressed by LZMA without a header, as document.py sets
// it (lc 3, lp 0, pb 0), 13 bits in two signs, the lowest bits first. The signs are the 91 printable
// ones of ASCII, in their order, that need not be escaped anywhere in HTML. Browsers unpack nothing
// of this kind, and what they do unpack only in their own time: a page is to be whole when it has
// loaded.
//
// Each bit is one of two parts of a range, as large as it is likely, which is learnt on the way.

function unpack(packed) {
  const bytes = [], out = [];
  const digit = (at) => {
    const code = packed.charCodeAt(at);
    return code - 32 - (code > 34) - 2 * (code > 39) - (code > 60);
  };
  for (let i = 0, kept = 0, many = 0; i < packed.length; i += 2) {
    kept |= (91 * digit(i) + digit(i + 1)) << many;
    for (many += 13; many > 7; many -= 8, kept >>= 8) bytes.push(kept & 255);
  }

  let range = 2 ** 32 - 1, code = 0, at = 1;
  const shift = () => {
    if (at > bytes.length) throw new Error("the page is damaged");
    code = 256 * code + bytes[at++];
  };
  for (let i = 0; i < 4; i++) shift();

  function bit(table, i) {
    const bound = (range >>> 11) * table[i], is = code < bound ? 0 : 1;
    if (is) {
      code -= bound;
      range -= bound;
      table[i] -= table[i] >> 5;
    } else {
      range = bound;
      table[i] += (2048 - table[i]) >> 5;
    }
    if (range < 2 ** 24) { range *= 256; shift(); }
    return is;
  }

  // A number of so many bits, the highest first: each is as likely as after those before it.
  function number(table, count, first = 0) {
    let node = 1;
    for (let i = 0; i < count; i++) node = 2 * node + bit(table, first + node);
    return node - 2 ** count;
  }

  // The same, the lowest first.
  function reversed(table, count, first = 0) {
    let node = 1, value = 0;
    for (let i = 0; i < count; i++) {
      const is = bit(table, first + node);
      node = 2 * node + is;
      value += is << i;
    }
    return value;
  }

  const table = (size) => new Uint16Array(size).fill(1024);
  const isCopy = table(12), isOld = table(12), isNotLast = table(12), isLong = table(12);
  const isThird = table(12), isFourth = table(12);
  const signs = table(8 * 768), slots = [0, 1, 2, 3].map(() => table(64)), near = table(128), low = table(16);

  const lengths = () => ({ more: table(2), parts: [table(8), table(8), table(256)] });
  const newLengths = lengths(), oldLengths = lengths();
  function length({ more, parts }) {
    if (!bit(more, 0)) return 2 + number(parts[0], 3);
    return bit(more, 1) ? 18 + number(parts[2], 8) : 10 + number(parts[1], 3);
  }

  // How many signs lie between a copy and what it repeats.
  function distance(long) {
    const slot = number(slots[Math.min(long - 2, 3)], 6), count = (slot >> 1) - 1;
    if (slot < 4) return slot;
    let value = 2 + (slot & 1);
    if (slot < 14) return (value << count) + reversed(near, count, (value << count) - slot);
    for (let i = 4; i < count; i++) {
      const half = Math.floor(range / 2);
      range = half;
      value = 2 * value;
      if (code >= half) { code -= half; value++; }
      if (range < 2 ** 24) { range *= 256; shift(); }
    }
    return 16 * value + reversed(low, 4);
  }

  // A sign, which is likely to be another one than would follow a copy that has just ended.
  function sign(other) {
    const first = 768 * ((out.at(-1) ?? 0) >> 5);
    let node = 1;
    for (let i = 7; i >= 0 && other !== undefined; i--) {
      const was = other >> i & 1, is = bit(signs, first + 256 * (1 + was) + node);
      node = 2 * node + is;
      if (is !== was) break;
    }
    while (node < 256) node = 2 * node + bit(signs, first + node); // each round doubles it
    return node - 256;
  }

  // The last distances, the newest first; `after` tells of what kinds the last few steps were.
  const last = [0, 0, 0, 0];
  let after = 0;
  while (true) { // each round writes a sign, or ends
    const next = out.length - last[0] - 1;
    if (!bit(isCopy, after)) {
      out.push(sign(after < 7 ? undefined : out[next]));
      after = after < 4 ? 0 : after - (after < 10 ? 3 : 6);
      continue;
    }
    let long = 1;
    if (!bit(isOld, after)) {
      long = length(newLengths);
      last.pop();
      last.unshift(distance(long));
      if (last[0] === 2 ** 32 - 1) return new TextDecoder().decode(new Uint8Array(out));
      after = after < 7 ? 7 : 10;
    } else {
      const which = !bit(isNotLast, after) ? 0 : !bit(isThird, after) ? 1 : 2 + bit(isFourth, after);
      last.unshift(...last.splice(which, 1));
      const alone = !which && !bit(isLong, after);
      if (!alone) long = length(oldLengths);
      after = (alone ? 9 : 8) + (after < 7 ? 0 : alone ? 2 : 3);
    }
    for (let i = 0; i < long; i++) out.push(out[out.length - last[0] - 1]);
  }
}
