// Where the links close: the stretches of the driver's way, by a test of single places.

const POSES = 721, HALVINGS = 60;

// The last place that closes on the way from one that does to one that does not.
function edge(closes, inside, outside) {
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (inside + outside) / 2;
    if (closes(middle)) inside = middle;
    else outside = middle;
  }
  return inside;
}

// All stretches between two places; that of a turn which runs through 0 begins below 0.
function stretches(closes, low, high, turns) {
  const at = (i) => low + (high - low) * i / (POSES - 1), found = [];
  for (let i = 0, open = false; i < POSES; i++) {
    const here = closes(at(i));
    if (here && !open) found.push([i ? edge(closes, at(i), at(i - 1)) : low, high]);
    if (!here && open) found.at(-1)[1] = edge(closes, at(i - 1), at(i));
    open = here;
  }
  const last = found.at(-1);
  if (!turns || found.length < 2 || found[0][0] > low || last[1] < high) return found;
  return [[last[0] - 360, found[0][1]], ...found.slice(1, -1)];
}

// Stretches that are known, but for rounding: their ends close.
function trimmedTo(closes, known) {
  return known.map(([low, high]) => {
    const middle = (low + high) / 2;
    return [closes(low) ? low : edge(closes, middle, low), closes(high) ? high : edge(closes, middle, high)];
  });
}

// The stretch in which a place lies, and the place in it; of a place beyond all the nearest end.
function placed(ranges, place, turns) {
  let best = null;
  if (turns) place %= 360; // exact, however many turns it is
  for (const range of ranges) {
    const whole = turns ? -360 * Math.round((place - (range[0] + range[1]) / 2) / 360) : 0;
    for (const more of turns ? [whole, whole + 360, whole - 360] : [0]) {
      const at = clamp(place + more, ...range), off = Math.abs(at - place - more);
      if (!best || off < best.off) best = { range, at, off };
    }
  }
  return best;
}
