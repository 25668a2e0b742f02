// What a page carries packed: text as UTF-8, deflated (RFC 1951), 13 bits in two signs, the lowest bits
// first. The signs are the 91 printable ones of ASCII, in their order, that need not be escaped
// anywhere in HTML. Browsers unpack deflated text only in their own time, and a page is to be whole
// when it has loaded.

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
  let bit = 0;

  function bits(count) {
    let value = 0;
    for (let i = 0; i < count; i++, bit++) value |= (bytes[bit >> 3] >> (bit & 7) & 1) << i;
    return value;
  }

  // A code by the lengths of its words: how many words have each length, and what they stand for.
  function code(lengths) {
    const counts = Array(16).fill(0), words = [];
    for (const length of lengths) counts[length]++;
    counts[0] = 0;
    let sum = 0;
    const starts = counts.map((count) => (sum += count) - count);
    lengths.forEach((length, word) => { if (length) words[starts[length]++] = word; });
    return [counts, words];
  }

  function next([counts, words]) {
    let value = 0, first = 0, index = 0;
    for (let length = 1; length < 16; length++) {
      value |= bits(1);
      if (value - counts[length] < first) return words[index + value - first];
      index += counts[length];
      first = (first + counts[length]) << 1;
      value <<= 1;
    }
    throw new Error("the page is damaged");
  }

  const ORDER = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
  const times = (count, value) => Array(count).fill(value);

  function codes() {
    const literals = bits(5) + 257, distances = bits(5) + 1, own = times(19, 0);
    for (let i = 0, count = bits(4) + 4; i < count; i++) own[ORDER[i]] = bits(3);
    const lengths = [], of = code(own);
    while (lengths.length < literals + distances) { // each word adds a length or more
      const word = next(of);
      if (word < 16) lengths.push(word);
      else if (word === 16) lengths.push(...times(3 + bits(2), lengths.at(-1)));
      else lengths.push(...times(word === 17 ? 3 + bits(3) : 11 + bits(7), 0));
    }
    return [code(lengths.slice(0, literals)), code(lengths.slice(literals))];
  }

  const usual = () => [code([...times(144, 8), ...times(112, 9), ...times(24, 7), ...times(8, 8)]), code(times(30, 5))];

  for (let last = 0; !last;) { // each block takes three bits or more
    last = bits(1);
    const kind = bits(2);
    if (!kind) {
      bit = (bit + 7) & ~7;
      for (let left = bits(16) + 0 * bits(16); left; left--) out.push(bits(8));
      continue;
    }
    const [literals, distances] = kind === 1 ? usual() : codes();
    for (let word = next(literals); word !== 256; word = next(literals)) {
      if (word < 256) { out.push(word); continue; }
      const more = word < 265 || word > 284 ? 0 : (word - 261) >> 2;
      const length = word > 284 ? 258 : word < 265 ? word - 254 : ((4 + (word - 265 & 3)) << more) + 3 + bits(more);
      const way = next(distances), far = way < 4 ? 0 : (way >> 1) - 1;
      const back = way < 4 ? way + 1 : ((2 + (way & 1)) << far) + 1 + bits(far);
      for (let i = 0; i < length; i++) out.push(out[out.length - back]);
    }
  }
  return new TextDecoder().decode(new Uint8Array(out));
}
