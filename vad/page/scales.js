// The scales of polygons: each keeps its scale while it fits its room and is not too small there,
// as in vad/plan/scale.py, and glides to a new one. A bar states it. A mechanism keeps its scale until
// a dimension changes; then all of its poses are to fit.
//
// scales(root, data, out, state) -> {choose, steady, whole, arrange}. arrange(panel) is told which panel
// is drawn large: there its polygons have other rooms and scales. choose(calm) moves all scales, which are
// inputs in the state, a step on their way, and tells whether any is still on it.

// A mechanism may take this share of the size that would fit.
const SMALL = 0.75;
// A peak is so many times as large as three in four poses of a turn, which come close to their room.
const PEAK = 3.5, ABOUT = 1.15, SHARE = 0.5, THERE = 2e-3, NO_SIZE = 1e-9;

function scales(root, data, out, state) {
  const svgs = [...root.querySelectorAll(".drawing > svg")], tops = [...root.querySelectorAll(".panel .top")];
  const [unit, left, top] = data.page;
  const all = data.polygons.map(({ half, input, corners, inner, bar, mechanism, large }) => {
    const below = svgs[data.halves[half][0]].querySelector(`[data-bar="${half}"]`);
    const made = { input, corners, inner, bar, below, now: state.slice(input, input + 3), half, mechanism };
    if (!below && bar) {
      const place = document.createElement("p");
      place.className = "scale hand";
      place.innerHTML = '<span><span class="bar"></span><span> </span></span>';
      tops[data.halves[half][0]].append(place);
      made.top = place.firstChild;
    }
    if (below) made.base = +below.querySelector("text").getAttribute("y") + bar.at[1] * unit;
    made.to = made.now;
    if (large) made.sides = [{ inner, bar, start: made.now }, { ...large, bar: bar && { ...bar, ...large.bar } }];
    return made;
  });

  function arrange(panel) {
    for (const polygon of all) {
      const { start, ...own } = polygon.sides?.[+(data.halves[polygon.half][0] === panel)] ?? {};
      if (!start) continue;
      Object.assign(polygon, own, { now: start, to: start, shown: 0 });
      data.start.splice(polygon.input, 3, ...start);
      state.splice(polygon.input, 3, ...start);
    }
  }

  // The least box about what is shown, in the polygon's own unit; null where nothing is.
  function box({ input, corners }) {
    const [x, y, factor] = state.slice(input, input + 3);
    let [a, b, c, d] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let n = 0; n < corners.length; n += 2) {
      const u = (out[corners[n]] - x) / factor, v = (out[corners[n + 1]] - y) / factor;
      if (u - u !== 0 || v - v !== 0) continue;
      [a, b, c, d] = [Math.min(a, u), Math.min(b, v), Math.max(c, u), Math.max(d, v)];
    }
    return c - a > 0 || d - b > 0 ? [a, b, c, d] : null;
  }

  const filling = ([l, b, r, t], [x, y, u, v]) => Math.min((r - l) / (u - x), (t - b) / (v - y));

  const centred = ([l, b, r, t], [x, y, u, v], factor) =>
    [(l + r) / 2 - factor * (x + u) / 2, (b + t) / 2 - factor * (y + v) / 2, factor];

  const fitted = (inner, found) => centred(inner, found, filling(inner, found));

  function calm(polygon, found) {
    const { inner, to: [x, y, factor] } = polygon, fitting = filling(inner, found);
    const fits = x + factor * found[0] >= inner[0] - 1e-6 && y + factor * found[1] >= inner[1] - 1e-6 &&
      x + factor * found[2] <= inner[2] + 1e-6 && y + factor * found[3] <= inner[3] + 1e-6;
    const lost = factor < (polygon.mechanism ? SMALL : data.least) * fitting;
    if (fits && !lost) return;
    const spared = fitting / (1 + data.spare);
    polygon.to = centred(inner, found, lost ? spared : Math.min(spared, factor));
  }

  const resized = () => [...data.dimensions.map((each) => each[5]), ...data.sides].some((at) => state[at] !== data.start[at]);

  function choose(still) {
    let moving = false;
    for (const polygon of all) {
      const found = polygon.most ?? box(polygon), { input, inner } = polygon, set = state.slice(input, input + 3);
      if (set.some((each, n) => each !== polygon.now[n])) polygon.now = polygon.to = set;
      const none = found && Math.max(found[2] - found[0], found[3] - found[1]) * filling(inner, found) < NO_SIZE;
      if (polygon.mechanism && !resized()) polygon.to = data.start.slice(input, input + 3);
      else if (found && !none && polygon.steady) polygon.to = fitted(inner, joined(found, polygon.steady));
      else if (found && !none) calm(polygon, found);
      const { now, to } = polygon;
      if (now.every((each, n) => each === to[n])) continue;
      const outgrown = polygon.steady && to[2] < now[2];
      const near = still || outgrown || Math.abs(now[2] / to[2] - 1) + Math.hypot(now[0] - to[0], now[1] - to[1]) < THERE;
      polygon.now = to.map((each, n) => (near ? each : now[n] + SHARE * (each - now[n])));
      state.splice(input, 3, ...polygon.now);
      moving = true;
    }
    return moving;
  }

  const joined = (one, other) => one.map((each, k) => (k < 2 ? Math.min : Math.max)(each, other[k]));

  // The boxes about what is shown in several poses, of each polygon.
  function boxes(among, poses, solve, upto) {
    const kept = [...state], found = among.map(() => []);
    for (const pose of poses) {
      solve(...kept.with(0, pose), out, upto);
      among.forEach((polygon, n) => { const own = box(polygon); if (own) found[n].push(own); });
    }
    return found;
  }

  // These are all poses of the mechanism with the dimensions of now.
  function whole(poses, solve) {
    const own = all.filter(({ mechanism }) => mechanism), found = boxes(own, poses, solve, 0);
    own.forEach((polygon, n) => { polygon.most = found[n].reduce(joined, found[n][0]); });
  }

  // One scale for all poses of a turn, which fits the largest. It gives way only to peaks of others
  // than the velocities, as near dead centres: no vector leaves its room. steady(null) ends that.
  function steady(poses, solve) {
    boxes(all, poses ?? [], solve, 2).forEach((found, n) => {
      const polygon = all[n], sizes = found.map((each) => filling(polygon.inner, each));
      const usual = [...sizes].sort((a, b) => a - b)[Math.floor(sizes.length / 4)];
      const peak = data.halves[polygon.half][0] !== data.fast && PEAK * Math.min(...sizes) < usual;
      polygon.steady = found.length && found.filter((_, k) => !peak || ABOUT * sizes[k] > usual).reduce(joined);
    });
  }

  // The longest bar of 1, 2 or 5 that there is room for.
  function bars() {
    for (const polygon of all) {
      const factor = state[polygon.input + 2];
      if (!polygon.bar || polygon.shown === factor) continue;
      polygon.shown = factor;
      const [value, words] = stated(polygon.bar, factor), long = value * factor * unit;
      if (polygon.below) {
        const [line, text] = [polygon.below.querySelector("path"), polygon.below.querySelector("text")];
        const [x, y] = polygon.bar.at, u = (x - left) * unit, v = (top - y - data.signs.rise) * unit, tick = data.signs.tick * unit;
        line.setAttribute("d", `M${u} ${v - tick}v${2 * tick}m0 ${-tick}h${long}m0 ${-tick}v${2 * tick}`);
        text.setAttribute("x", u + long + data.signs.gap * unit);
        text.setAttribute("y", polygon.base - y * unit);
        if (text.textContent !== words) text.textContent = words;
      } else {
        polygon.top.firstChild.style.setProperty("--n", long.toFixed(2));
        const text = polygon.top.lastChild.firstChild;
        if (text.data !== words) text.data = words;
      }
    }
  }

  const wide = (words) => [...words].reduce((sum, sign) => sum + (data.signs.wide[sign] ?? data.signs.wide[0]), 0);

  function stated({ room, unit: name, unitWide, factor: scaled }, factor) {
    let value = longest(factor, data.signs.longest);
    for (let n = 0; ; n++) { // at most four lengths lie between the longest and the shortest
      const number = written(value * scaled, "", true, data.point), length = value * factor;
      const shorter = longest(factor, 0.9 * length);
      if (n > 2 || wide(number) + unitWide + data.signs.gap + length <= room || shorter * factor < data.signs.shortest)
        return [value, number + "\u00a0" + name];
      value = shorter;
    }
  }

  function longest(factor, length) {
    const most = length / factor * (1 + 1e-9), power = Math.floor(Math.log10(most));
    return Number(`${[5, 2].find((step) => step * 10 ** power <= most) ?? 1}e${power}`);
  }

  return { choose, steady, whole, arrange, state: bars };
}
