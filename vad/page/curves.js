// What a whole turn leaves behind: the curves of the table's values over the driver's place, the
// hodographs on which the vertices of polygons run, and the paths of the points of a mechanism.
//
// curved(root, body, dock, showing). A switch among what is shown turns each on. The data of
// vad/page/curves.py:
//   columns   of each panel the values: row, output, factor, unit, symbol
//   tracks    of each panel the points: row, outputs of x and y, and of polygons the place of the
//             scale among the inputs
//   on        what is shown from the start
// A drag in a curve moves what is driven.

// A curve whose highest places are so many times as high as all but a few has no end. One that
// changes by less than this part of its largest value is level.
const SAMPLES = 361, MOST = 0.98, ENDLESS = 4, LEVEL = 1e-9;

function curved(root, body, dock, showing) {
  const { data, solve, view } = body, { columns, tracks } = data.curves;
  const out = new Float64Array(data.size), shows = { curves: false, hodographs: false, paths: false };
  const svgs = [...root.querySelectorAll(".drawing > svg")], [unit, left, top] = data.page;
  const home = document.createElement("div"), plots = [];
  let places = [], values = [], points = [], known = "";

  const made = (parent, name, attributes = {}) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    parent.append(element);
    return element;
  };

  // All poses of the driver's stretches, with the rates and dimensions of now.
  function solved() {
    const now = [...body.state.slice(1, 3), body.key(body.state), ...body.ranges.flat()].join();
    if (now === known) return;
    known = now;
    const whole = body.ranges.reduce((sum, [low, high]) => sum + high - low, 0) || 1;
    // A stretch through 0° has a part at each end of the curve.
    const parts = body.ranges.flatMap(([low, high]) => body.turns && low < 0 && high > 0 ? [[low, 0], [0, high]] : [[low, high]]);
    places = parts.flatMap(([low, high]) => {
      const count = Math.max(2, Math.round(SAMPLES * (high - low) / whole));
      return [...Array(count).keys()].map((i) => low + (high - low) * (i + 0.0005) / (count - 0.999)).concat(NaN);
    });
    values = columns.map((column) => column.map(() => []));
    points = tracks.map((each) => each.map(() => []));
    for (const place of places) {
      solve(place, ...body.state.slice(1), out, 2);
      const gap = place !== place;
      columns.forEach((column, i) => column.forEach(([, at, factor], k) => values[i][k].push(gap ? NaN : factor * out[at])));
      tracks.forEach((each, i) => each.forEach(([, x, y], k) => points[i][k].push(gap ? [NaN, NaN] : [out[x], out[y]])));
    }
    for (const plot of plots) plot.draw();
    draw();
  }

  // A line through points, which begins anew after what does not exist.
  function line(spots) {
    let path = "", pen = false;
    for (const [x, y] of spots) {
      const there = x - x === 0 && y - y === 0;
      if (there) path += `${pen ? "L" : "M"}${+x.toPrecision(6)} ${+y.toPrecision(6)}`;
      pen = there;
    }
    return path;
  }

  // ---- curves ----

  function plot(column, i) {
    const units = [...new Set(column.map((each) => each[3]))], figure = document.createElement("figure");
    const svg = made(figure, "svg", { viewBox: "0 0 360 100", preserveAspectRatio: "none" });
    const zero = made(svg, "path", { class: "zero" }), paths = column.map(([row]) => made(svg, "path", { style: `stroke:var(--ink${row})` }));
    const cursor = made(svg, "path", { class: "cursor" }), words = document.createElement("figcaption");
    const high = document.createElement("span"), low = document.createElement("span"), button = document.createElement("button");
    let shown = 0;
    words.append(high, button, low);
    figure.append(words);
    figure.style.setProperty("--w", data.rooms[i][2] - data.rooms[i][0]);
    home.append(figure);
    button.onclick = () => { shown = (shown + 1) % units.length; each.draw(); };

    const each = {
      draw() {
        const own = column.map((each, k) => each[3] === units[shown] ? k : -1).filter((k) => k >= 0);
        const all = own.flatMap((k) => values[i][k]).filter((value) => value - value === 0).sort((a, b) => a - b);
        // Where rates grow without end the ends of a stretch do not tell the scale.
        const usual = [all[Math.floor((1 - MOST) * (all.length - 1))] ?? 0, all[Math.ceil(MOST * (all.length - 1))] ?? 1];
        const [least, most] = all.at(-1) - all[0] < ENDLESS * (usual[1] - usual[0]) ? [all[0], all.at(-1)] : usual;
        const [from, to] = most - least > LEVEL * Math.max(most, -least) ? [least, most] : [least - 1, least + 1];
        const y = (value) => 96 - 92 * (clamp(value, from - (to - from), to + (to - from)) - from) / (to - from);
        paths.forEach((path, k) => path.setAttribute("d", own.includes(k)
          ? line(jumped(values[i][k], units[shown]).map((value, n) => [x(places[n]), y(value)])) : ""));
        zero.setAttribute("d", from < 0 && to > 0 ? `M0 ${y(0)}H360` : "");
        // A whole turn ends at 360°, which is elsewhere written as 0°.
        const said = (value) => units[shown] === "°" ? `${dock.number(value, 1)}°` : view.written(value, units[shown]);
        high.textContent = said(to);
        low.textContent = said(from);
        button.textContent = units.length > 1 ? units[shown] : "";
        button.hidden = units.length < 2;
        each.move();
      },
      move: () => cursor.setAttribute("d", `M${x(body.place).toFixed(2)} 0V100`),
    };

    let held = false;
    const drag = (event) => {
      const box = svg.getBoundingClientRect(), share = clamp((event.clientX - box.left) / box.width, 0, 1);
      const [from, to] = span();
      dock.point(from + share * (to - from));
    };
    svg.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    svg.addEventListener("pointerdown", (event) => {
      if (event.button) return;
      svg.setPointerCapture(event.pointerId);
      held = true;
      dock.begin();
      drag(event);
    });
    svg.addEventListener("pointermove", (event) => { if (held) drag(event); });
    for (const name of ["pointerup", "pointercancel"]) svg.addEventListener(name, () => { if (held) dock.commit(); held = false; });
    return each;
  }

  const span = () => body.turns ? [0, 360] : [data.ranges[0][0], data.ranges.at(-1)[1]];
  const x = (place) => {
    const [from, to] = span(), within = body.turns && place < 0 ? place + 360 : place;
    return 360 * (within - from) / (to - from);
  };
  // An angle that passes 0° does not cross the picture.
  const jumped = (list, units) => units !== "°" ? list : list.map((value, i) => Math.abs(value - list[i - 1]) > 180 ? NaN : value);

  // ---- hodographs and paths ----

  const ways = svgs.map((svg, i) => {
    const layer = svg.querySelector(".hand"), group = document.createElementNS("http://www.w3.org/2000/svg", "g");
    const clip = made(group, "clipPath", { id: `way${i}` }), [from, low, to, high] = data.rooms[i];
    made(clip, "rect", { x: (from - left) * unit, y: (top - high) * unit, width: (to - from) * unit, height: (high - low) * unit });
    group.setAttribute("class", "hand ways");
    layer.before(group);
    return made(group, "g", { "clip-path": `url(#way${i})` });
  });
  const drawn = tracks.map((each, i) => each.map(([row, , , scale]) => made(ways[i], "path", {
    class: data.halves[0][0] === i ? "path" : "hodograph", style: `stroke:var(--${row === null ? "grey" : `ink${row}`})` })));

  function draw() {
    drawn.forEach((each, i) => each.forEach((path, k) => path.setAttribute("d", line(points[i][k]))));
    placed();
  }

  // The points of polygons are in their own unit, and follow the scale.
  function placed() {
    tracks.forEach((each, i) => each.forEach(([, , , scale], k) => {
      const [x, y, factor] = scale === null ? [0, 0, 1] : body.state.slice(scale, scale + 3);
      const along = factor * unit;
      drawn[i][k].setAttribute("transform", `matrix(${along} 0 0 ${-along} ${(x - left) * unit} ${(top - y) * unit})`);
    }));
  }

  function toggle(name, on) {
    shows[name] = on;
    root.classList.toggle(name, on);
    if (on) solved();
  }

  home.className = "plots";
  root.querySelector(".results").after(home);
  plots.push(...columns.map(plot));
  body.on(() => {
    if (!Object.values(shows).some((on) => on)) return;
    solved();
    placed();
    if (shows.curves) for (const each of plots) each.move();
  });
  view.glides(() => { if (shows.hodographs) placed(); });
  for (const [name, key] of [["curves", "c"], ["hodographs", "o"], ["paths", "p"]]) {
    const button = showing(data.words[name], data.curves.on.includes(name), (on) => toggle(name, on));
    button.setAttribute("aria-keyshortcuts", key.toUpperCase());
    dock.shortcuts[key] = () => button.click();
  }
}
