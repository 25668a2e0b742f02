// The hand: what is driven is moved, the picture follows, and stops where the links part.
//
// driven(root, solve, data) -> the mechanism in the hand. The data has beside those of picture.js:
//   grip         what is dragged, null where nothing can be
//   ranges       the stretches in which the links close, with the page's dimensions
//   closes       outputs that exist wherever they close
//   guards       outputs that are truth values, and what they are while the picture holds
//   rates        for each rate an output that exists wherever it does
//   fastest      the largest rate of the driver that is taken
//   dimensions   of each its name, value, ends, unit, its place among the inputs, and what is taken
//   assemblies   of each its name, and the factors of its loops, which are the inputs "sides"
//   limits       outputs that are zero where links part, and how they stand there
// Listeners hear of every pose: on(listener).  What is text follows less often, so that it can be
// read: reads(listener), written with the table.  said() lets all text and labels be those of the pose
// at once, and the text of the next one, too.  dispose() lets no more text come when another page takes
// the place of this one.

// Of the size of a mechanism: two places that are nearer are one.
const MEETING = 1e-4;
// Of a stretch: what is nearer to its end is there.
const END = 1e-11;
// In so many poses of a stretch the size of a mechanism is looked up.
const POSES_WHOLE = 48;
// Milliseconds from one text to the next while a pose follows the other: nobody reads more of them.
const LEGIBLE = 160;

// Does something when it is called, and in a row of calls so often that this many milliseconds lie
// between; the last call counts, too. now() does what is left at once, and so the next call; over()
// leaves it undone.
function paced(what, span) {
  let timer = 0, left = false;
  const call = () => {
    left = timer > 0;
    if (left) return;
    timer = setTimeout(ring, span);
    what();
  };
  const ring = () => {
    clearTimeout(timer);
    timer = 0;
    if (left) call();
  };
  call.now = () => { ring(); ring(); };
  call.over = () => clearTimeout(timer);
  return call;
}

function driven(root, solve, data) {
  const view = picture(root, solve, data), { state, out } = view;
  const turns = data.inputs[0] === "angle", listeners = [], readers = [];
  const full = (range) => turns && range[1] - range[0] >= 360;
  const span = data.ranges.length ? data.ranges.at(-1)[1] - data.ranges[0][0] : 1;
  const ends = turns ? [0, 360] : [data.ranges[0][0] - span, data.ranges.at(-1)[1] + span];
  const own = trimmedTo(closes, data.ranges);
  const begun = home();
  let ranges = own, { range } = begun, known = key(data.start);
  if (!full(range)) state[0] = begun.at;
  let wanted = state[0];

  function closes(place) {
    solve(place, ...state.slice(1), out, 0);
    return data.closes.every((at) => out[at] - out[at] === 0);
  }

  // The stretch of the lesson's pose, and its place there: that of a turn may be a turn from it.
  function home() {
    return placed(own, data.start[0], turns) ?? { range: own[0], at: data.start[0] };
  }

  // Whether the program is right for these dimensions.
  function holds(values) {
    solve(...values, out, 0);
    return data.guards.every(([at, value]) => out[at] === value);
  }

  // The word that says why an input cannot have a value, and what it takes; no word where it can.
  function refused(index, value) {
    const rate = index && index < data.own.length ? data.fastest : Infinity;
    const [least, most] = data.dimensions.find((each) => each[5] === index)?.[6] ?? [-rate, rate];
    return [value >= least && value <= most ? "" : least > 0 && value <= 0 ? "positive" : "beyond", least, most];
  }

  // What does not move with the driver: the dimensions, and the factors of the loops.
  function key(values) {
    return [...data.dimensions.map((each) => values[each[5]]), ...data.sides.map((at) => values[at])].join();
  }

  // A state in another assembly, by its number.
  function assembled(number, values = state) {
    const found = [...values];
    data.assemblies[number][1].forEach((factor, i) => (found[data.sides[i]] = factor));
    return found;
  }

  const assembly = (values = state) => data.assemblies.findIndex(([, factors]) => factors.every((factor, i) => factor === values[data.sides[i]]));

  // The assembly into which this one goes over at a limit: there all points are at one place in both.
  function beyond() {
    const places = () => data.closes.map((at) => out[at]);
    const here = places(), size = Math.max(...here.map(Math.abs)), now = assembly();
    const away = data.assemblies.map((_, number) => {
      if (number === now) return Infinity;
      solve(...assembled(number), out, 0);
      return Math.max(...places().map((at, i) => (at - at === 0 ? Math.abs(at - here[i]) : Infinity)));
    });
    solve(...state, out, 0);
    const nearest = away.indexOf(Math.min(...away));
    return away[nearest] < MEETING * size ? nearest : -1;
  }

  // How the links stand where they part.
  const parting = () => data.limits.reduce((least, each) => Math.abs(out[each[0]]) < Math.abs(out[least[0]]) ? each : least, data.limits[0])?.[1];

  // The stretches for the dimensions of now.
  function search() {
    const now = key(state);
    if (now === known) return;
    known = now;
    ranges = now === key(data.start) ? trimmedTo(closes, data.ranges) : stretches(closes, ...ends, turns);
    view.whole(among(POSES_WHOLE));
  }

  // Places of the driver over its stretches, so many in each.
  const among = (count) => ranges.flatMap(([low, high]) => [...Array(count).keys()].map((n) => low + (high - low) * (n + 0.5) / count));

  // What is so near to an end is there: in the assembly beyond, the end is another by rounding, and
  // rates there would have a scale from which no other one is found.
  const atEnd = () => !full(range) && Math.min(state[0] - range[0], range[1] - state[0]) <= END * (range[1] - range[0]);

  // Paints the state. At a limit rates have no value: they grow without end towards it.
  function show(inRow) {
    root.classList.toggle("resized", known !== key(data.start));
    drawn(inRow);
    for (const listener of listeners) listener();
    say();
  }

  const say = paced(() => {
    view.write();
    for (const reader of readers) reader();
  }, LEGIBLE);

  function drawn(inRow) {
    view.paint(atEnd() ? [state[0], NaN, NaN, ...state.slice(3)] : state, inRow);
    held();
  }

  // Another panel is drawn large, or none: see picture.js. The pose stays.
  function arrange(...large) {
    view.arrange(...large);
    if (root.classList.contains("turned")) drawn();
    else held();
  }

  // The ring stands where it is to be taken.
  const ring = root.querySelector("[data-vad-grip]");
  function held() {
    if (!ring) return;
    const x = view.x(data.grip.at[0]).toFixed(2), y = view.y(data.grip.at[1]).toFixed(2);
    if (ring.getAttribute("cx") !== x) ring.setAttribute("cx", x);
    if (ring.getAttribute("cy") !== y) ring.setAttribute("cy", y);
  }
  view.glides(held);

  // Sets the state; the driver goes to the nearest place that closes. False where there is none.
  function set(values) {
    const before = [...state];
    state.splice(0, state.length, ...values);
    search();
    const found = ranges.length && holds(state) ? placed(ranges, state[0], turns) : null;
    if (!found) {
      state.splice(0, state.length, ...before);
      search();
      return false;
    }
    range = found.range;
    state[0] = wanted = found.at;
    show();
    return true;
  }

  // Moves the driver within its stretch; near a limit it may snap to it, and elsewhere to a tenth of
  // that. What was wanted beyond the limit is not lost, so that a pointer that comes back meets what
  // it left. Of many moves in a row, not each has its labels at once.
  function move(by, snap = 0, inRow = false) {
    wanted += by;
    let at = full(range) ? wanted : clamp(wanted, ...range);
    if (snap) at = clamp(+at.toFixed(Math.max(0, Math.ceil(-Math.log10(snap / 10) - 1e-9))), ...(full(range) ? [-Infinity, Infinity] : range));
    if (!full(range)) for (const end of range) if (Math.abs(at - end) < snap) at = end;
    if (full(range)) [at, wanted] = [within(at), within(wanted)];
    const round = +at.toPrecision(13); // as sums of round steps are
    state[0] = full(range) ? round : clamp(round, ...range);
    show(inRow);
  }

  const within = (degrees) => (degrees % 360 + (degrees % 360 < 0 ? 360 : 0));

  return {
    data, turns, ends, state, out, view, home, solve, closes, holds, refused, set, move, show, arrange, key, among, assembly, assembled, beyond, parting,
    on: (listener) => listeners.push(listener),
    reads: (reader) => readers.push(reader),
    said: () => { view.settle(); say.now(); },
    dispose: say.over,
    rest: () => { wanted = state[0]; },
    get ranges() { return ranges; },
    get range() { return range; },
    get bounded() { return !full(range); },
    get atEnd() { return atEnd(); },
    get dead() { return data.rates.some((at) => out[at] - out[at] !== 0); },
    get place() { return turns ? within(state[0]) : state[0]; },
  };
}

// The ring is dragged: what is driven moves by as much as the pointer. take() begins a gesture, and
// gone() ends it.
function dragged(root, body, take, gone) {
  const { data, view } = body, ring = root.querySelector("[data-vad-grip]");
  if (!ring) return;
  const svg = ring.ownerSVGElement, { kind, about, way, factor } = data.grip;
  let from = null, within = null;
  // Where the picture is in the window is asked once, until it may have moved.
  for (const name of ["scroll", "resize"]) addEventListener(name, () => { within = null; }, { capture: true, passive: true });
  const at = (event) => {
    within ??= ring.getScreenCTM().inverse();
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(within);
    const du = point.x - view.x(about[0]), dv = point.y - view.y(about[1]);
    if (kind === "angle") return Math.atan2(-dv, du) * 180 / Math.PI;
    return (kind === "length" ? Math.hypot(du, dv) : du * way[0] + dv * way[1]) / factor / view.unit;
  };
  // A browser would else scroll the page with the finger, whatever touch-action says.
  ring.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  ring.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    ring.setPointerCapture(event.pointerId);
    root.classList.add("gripped");
    take();
    body.rest();
    within = null;
    from = at(event);
    event.preventDefault();
  });
  ring.addEventListener("pointermove", (event) => {
    if (from === null) return;
    const now = at(event), by = now - from, snap = kind === "angle" ? 1 : (body.range[1] - body.range[0]) / 360;
    from = now;
    body.move(kind === "angle" ? by - 360 * Math.round(by / 360) : by, snap, true);
  });
  for (const name of ["pointerup", "pointercancel"])
    ring.addEventListener(name, () => { if (from !== null) { from = null; root.classList.remove("gripped"); gone(); } });
}
