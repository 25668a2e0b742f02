// Vectors that travel, as in films (vad/plan/pictures/flights.py): a copy of a link, or of a velocity,
// turns, is stretched, and flies to its place in a polygon, in another panel of the page.  The image of a link
// that lands larger flies first, and grows there, as does a vector that is longer than the picture that it leaves; one
// that is too short to be seen flies first, and shrinks.
// Its way is dotted, and where its head docks there is a ring.
//
// flights(root) -> {flight, draw}. flight(data, marks, svgs, beat) is one, by what vad/page/travels.py says
// of it, by the marks that grow in its beat and by the pictures of all panels; null where its source is not
// seen. draw(flight, share) shows it at a share of its time, draw(null) none.

// In units of a page 720 high: how far a copy of a vector lifts off, how long one is at least that turns, and
// how short it becomes only where it lands.
const LIFT = 28.8, SEEN = 64.8, SHRINKS = 25.2;
// How high it flies, of its way; how much ink its traces have, and how long before the end they are gone.
const ARCH = .08, GHOSTS = [.2, .28, .36], VANISHING = .92;
// Of a head: its length, that of its side by it, how much of a short vector, where the shaft ends in it.
const HEAD = 18.7, SIDE = 1.077, HEAD_SHARE = .6, NECK = .66;

// In how many parts the way is drawn.
const PARTS_OF_WAY = 10;

function flights(root) {
  const air = root.querySelector(".air") ?? root.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "svg"));
  air.setAttribute("class", "air");
  air.setAttribute("aria-hidden", true);
  const filled = (mark) => getComputedStyle(mark).fill !== "none";
  let hidden = [], pale = [], shown = null;

  function flight([, kind, phases, from, turn, lift, ...places], marks, svgs, beat) {
    const to = marks[0]?.ownerSVGElement, source = svgs[from], { width, height } = source.getBoundingClientRect();
    if (!to || !width || !to.getBoundingClientRect().width) return null;
    const at = (svg, n) => {
      const k = svg.closest(".grand") ? n + 8 : n;
      return new DOMPoint(places[k], places[k + 1]).matrixTransform(svg.getScreenCTM());
    };
    const tail = at(source, 0), head = at(source, 2), start = at(to, 4), end = at(to, 6);
    const unit = to.getScreenCTM().a, way = [end.x - start.x, end.y - start.y], whole = Math.hypot(...way);
    // An area shows when its stroke is done, an arrow grows.
    const area = kind === "area", all = area ? [...to.querySelectorAll(`[data-s="${beat + 1}"] > path`)].filter((each) => each.closest(".scene") === marks[0].closest(".scene")) : marks;
    const tip = all.find((each) => each.localName === "path" && filled(each)), shaft = !area && tip?.previousElementSibling;
    if (!tip) return null;
    const [x, y] = [head.x - tail.x, head.y - tail.y], length = Math.hypot(x, y);
    const size = length / whole, seen = area ? size : Math.max(size, SEEN * unit / whole), up = lift * unit / length;
    const lifts = {
      tangential: () => [x, y],
      coriolis: () => way.map((each) => LIFT * unit * each / whole),
      normal: () => [up * y, -up * x],
    };
    Object.assign(lifts, { turned: lifts.coriolis, axial: lifts.normal, point: lifts.tangential });
    const [p, q] = lifts[kind]?.() ?? [0, 0], place = [tail.x + p, tail.y + q];
    const legs = [[tail.x, tail.y, size, turn]];
    if (lifts[kind]) legs.push([...place, seen, turn]);
    if (lifts[kind] !== lifts.normal) legs.push([...place, seen, 0]);
    const short = whole < SHRINKS * unit, [stretch, fly] = phases.slice(-2);
    const last = area ? seen < 1 : short || whole > Math.max(width, height);
    // A head that docks stays there.
    const [u, v] = way.map((each) => kind === "coriolis" ? (1 - seen) * each : 0);
    legs.push(last ? [start.x + u, start.y + v, seen, 0] : [...place, 1, 0], [start.x, start.y, 1, 0]);
    const times = last ? [...phases.slice(0, -2), fly, stretch] : phases, flies = times.length - (last ? 2 : 1);
    return { kind, source, to, start, way, unit, short, legs, phases: times, flies, marks, tip, shaft };
  }

  // Where its start is after some time, its factor, and by how much it is turned clockwise.
  function leg({ legs, phases, flies }, time) {
    let n = 0;
    while (n < phases.length - 1 && time > phases[n]) time -= phases[n++];
    const part = smooth(Math.min(1, time / phases[n])), [from, to] = [legs[n], legs[n + 1]];
    const found = from.map((each, i) => each + part * (to[i] - each));
    if (n === flies) found[1] -= 4 * part * (1 - part) * ARCH * Math.hypot(to[0] - from[0], to[1] - from[1]);
    return found;
  }

  // That, kept within the panels, and how far from its tail its head then is.
  function placed(flight, time) {
    const { to, way } = flight, room = to.closest(".panels").getBoundingClientRect(), [x, y, factor, turn] = leg(flight, time);
    const [cos, sin] = ray(turn), dx = factor * (way[0] * cos - way[1] * sin), dy = factor * (way[0] * sin + way[1] * cos);
    const inside = (low, high, at, by) => at + Math.max(0, low - Math.min(at, at + by)) + Math.min(0, high - Math.max(at, at + by));
    return [inside(room.left, room.right, x, dx), inside(room.top, room.bottom, y, dy), factor, turn, dx, dy];
  }

  function drawn(flight, time, ink) {
    const { to, start, unit, tip, shaft, short } = flight, [x, y, factor, turn, dx, dy] = placed(flight, time);
    if (!shaft) {
      const { a, b, c, d, e, f } = to.getScreenCTM();
      return `<g opacity="${ink}" style="stroke:var(--grey)" transform="translate(${x} ${y}) rotate(${turn}) scale(${factor}) translate(${-start.x} ${-start.y}) matrix(${a} ${b} ${c} ${d} ${e} ${f})">${tip.outerHTML}</g>`;
    }
    const long = Math.hypot(dx, dy), [, , u, v] = tip.getAttribute("d").match(/-?(\d+\.?\d*|\.\d+)/g);
    const head = Math.min((short ? HEAD : Math.hypot(u, v) / SIDE) * unit, HEAD_SHARE * long), neck = 1 - NECK * head / long;
    const wide = parseFloat(getComputedStyle(shaft).strokeWidth) * unit, angle = Math.atan2(dy, dx) * 180 / Math.PI;
    return `<g opacity="${ink}"><path class="${shaft.getAttribute("class")}" style="stroke-width:${wide}px" d="M${x} ${y}l${neck * dx} ${neck * dy}"/>` +
      `<path class="${tip.getAttribute("class")}" transform="translate(${x + dx} ${y + dy}) rotate(${angle}) scale(${head})" d="M0 0-1-.4-.76 0-1 .4z"/></g>`;
  }

  // When it begins to fly to its place.
  function begins({ phases, flies }) {
    return phases.slice(0, flies).reduce((sum, each) => sum + each, 0);
  }

  // The way of the tail as it flies, or of the head that docks in a ring: in the picture's units, as
  // their lines are.
  function trail(flight, [path, ring, radius]) {
    const { kind, unit, phases, flies } = flight, docks = kind === "coriolis", spots = [];
    for (let n = 0; n <= PARTS_OF_WAY; n++) {
      const [x, y, , , dx, dy] = placed(flight, begins(flight) + phases[flies] * n / PARTS_OF_WAY);
      spots.push([x + docks * dx, y + docks * dy]);
    }
    const line = spots.map((spot) => spot.map((each) => (each / unit).toFixed(2)).join(" ")).join("L"), [x, y] = spots.at(-1);
    return `<g transform="scale(${unit})"><path class="${path}" d="M${line}"/>${docks ? `<circle class="${ring}" cx="${x / unit}" cy="${y / unit}" r="${radius}"/>` : ""}</g>`;
  }

  // While something flies, the links that it does not come from are pale.
  function light({ source, tip, shaft } = {}) {
    if (tip === shown) return;
    pale.forEach((each) => each.classList.remove("pale"));
    [pale, shown] = [[], tip];
    if (!tip) return;
    const ink = (mark) => ["stroke", "fill"].map((each) => getComputedStyle(mark)[each]), [own] = ink(shaft || tip);
    const inks = [...root.querySelectorAll(".key path")].flatMap((each) => ink(each)[0]).filter((each) => each !== own);
    pale = [...source.querySelectorAll(`:scope > ${source.closest(".grand") ? ".scene" : "g:not(.scene, .hand, .grip)"} :is(path, circle, text)`)].filter((mark) => ink(mark).some((each) => inks.includes(each)));
    pale.forEach((each) => each.classList.add("pale"));
  }

  function draw(flight, share, looks) {
    light(flight ?? {});
    hidden.forEach((each) => each.classList.remove("aloft"));
    hidden = flight ? flight.marks.map((each) => each.parentNode) : [];
    hidden.forEach((each) => each.classList.add("aloft"));
    if (!flight) return air.replaceChildren();
    const { phases } = flight, all = phases.reduce((sum, each) => sum + each);
    let time = 0, text = "";
    phases.slice(0, -1).forEach((each, n) => {
      time += each;
      if (share * all > time && share < VANISHING) text += drawn(flight, time, GHOSTS[n]);
    });
    if (share * all > begins(flight)) text = trail(flight, looks) + text;
    air.innerHTML = text + drawn(flight, share * all, 1);
  }

  return { flight, draw };
}
