// The labels of a picture that a hand moves: each stands beside what it names, on the side on which
// it stood before, while it can.
//
// labels(texts, data, out) -> a function that places all texts for the outputs of a pose.

const APART = [0.02, 0.01], CLEAR = 0.006, WAYS = 32;

function labels(texts, data, out) {
  const [unit] = data.page, pixels = (value) => Math.round(value * unit * 100) / 100;
  const all = data.labels.map(([panel, name, half, at, near, way], i) =>
    ({ panel, name, half, at, near, text: texts[i], way: Math.atan2(way[1], way[0]) }));

  function place() {
    const lines = data.rooms.map(() => []), boxes = data.rooms.map(() => []);
    for (const [panel, a, b, c, d, half] of data.blocks) {
      const u = (out[a] + out[c]) / 2, v = (out[b] + out[d]) / 2;
      if (u - u === 0 && v - v === 0) lines[panel].push([u, v, (out[c] - out[a]) / 2, (out[d] - out[b]) / 2, half]);
    }
    for (const label of all) {
      const [u, v] = label.at.map((each) => out[each]), [wide, high] = label.half;
      if (u - u !== 0 || v - v !== 0) { label.text.style.display = "none"; continue; }
      const spot = (gap, way) => {
        const p = Math.cos(way), q = Math.sin(way), far = gap + Math.min(wide / Math.abs(p), high / Math.abs(q));
        return [u + far * p, v + far * q];
      };
      const free = ([p, q]) => isFree(p, q, wide, high, data.rooms[label.panel], lines[label.panel], boxes[label.panel]);
      let found = null, chosen = label.way;
      search: for (let turned = 0; turned <= WAYS / 2; turned++)
        for (const side of turned && turned < WAYS / 2 ? [1, -1] : [1])
          for (const gap of label.near) {
            const way = label.way + side * turned * 2 * Math.PI / WAYS, at = spot(gap, way);
            if (free(at)) { found = at; chosen = way; break search; }
          }
      label.text.style.display = found ? "" : "none";
      if (!found) continue;
      label.way = chosen;
      boxes[label.panel].push([...found, wide, high]);
      label.text.setAttribute("transform", `translate(${pixels(found[0])} ${pixels(-found[1])})`);
    }
  }

  function isFree(u, v, wide, high, room, lines, boxes) {
    const w = wide + CLEAR, h = high + CLEAR;
    if (u - w < room[0] || v - h < room[1] || u + w > room[2] || v + h > room[3]) return false;
    for (const [p, q, a, b] of boxes)
      if (Math.abs(u - p) < wide + a + APART[0] && Math.abs(v - q) < high + b + APART[1]) return false;
    for (const [p, q, dx, dy, half] of lines) {
      const aside = u - p, above = v - q, long = Math.abs(dx), tall = Math.abs(dy);
      if (Math.abs(aside) <= w + half + long && Math.abs(above) <= h + half + tall &&
        Math.abs(aside * dy - above * dx) <= (w + half) * tall + (h + half) * long) return false;
    }
    return true;
  }

  return place;
}
