// The hand: what is driven is taken and turned, and the picture follows.
//
// turn(root, solve, data) -> what a page offers as window.vad. The data has beside those of
// picture.js the grip, which is dragged, and the ranges in which the links close.

function turn(root, solve, data) {
  const { state, out, paint, x, y, unit } = picture(root, solve, data);
  const ring = root.querySelector("[data-vad-grip]"), listeners = new Set();

  function show() {
    paint();
    if (!ring) return;
    ring.setAttribute("cx", x(data.grip.at[0]).toFixed(2));
    ring.setAttribute("cy", y(data.grip.at[1]).toFixed(2));
  }

  // The driver's place is kept where the links close.
  function within(value) {
    if (data.grip?.kind !== "angle") return held(value, 0);
    for (const turns of [0, 360, -360]) {
      const moved = value + turns;
      if (data.ranges.some(([low, high]) => low <= moved && moved <= high)) return moved;
    }
    return held(value, 360);
  }

  function held(value) {
    const ends = data.ranges.flat(), inside = data.ranges.some(([low, high]) => low <= value && value <= high);
    return inside ? value : ends.reduce((best, end) => Math.abs(end - value) < Math.abs(best - value) ? end : best);
  }

  function pose(given) {
    for (const [name, value] of Object.entries(given)) {
      const index = data.inputs.indexOf(name);
      if (index >= 0) state[index] = index ? value : within(value);
    }
    root.classList.add("turned");
    show();
    for (const listener of listeners) listener(Object.fromEntries(data.inputs.map((name, i) => [name, state[i]])));
  }

  // The pointer moves what is driven by as much as it moves itself.
  if (ring) {
    let from = null;
    const svg = ring.ownerSVGElement;
    const at = (event) => {
      const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return [point.x, point.y];
    };
    const measure = ([u, v]) => {
      const { kind, about, way, factor } = data.grip, du = u - x(about[0]), dv = v - y(about[1]);
      if (kind === "angle") return Math.atan2(-dv, du) * 180 / Math.PI;
      return kind === "length" ? Math.hypot(du, dv) / factor / unit : (du * way[0] + dv * way[1]) / factor / unit;
    };
    ring.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    ring.addEventListener("pointerdown", (event) => {
      ring.setPointerCapture(event.pointerId);
      solve(...state, out, 2);
      from = measure(at(event));
      event.preventDefault();
    });
    ring.addEventListener("pointermove", (event) => {
      if (from === null) return;
      const now = measure(at(event));
      let by = now - from;
      if (data.grip.kind === "angle") by -= 360 * Math.round(by / 360);
      from = now;
      pose({ [data.inputs[0]]: state[0] + by });
    });
    for (const name of ["pointerup", "pointercancel"]) ring.addEventListener(name, () => (from = null));
  }

  show();
  return {
    pose,
    get state() { return Object.fromEntries(data.inputs.map((name, i) => [name, state[i]])); },
    back: () => { state.splice(0, state.length, ...data.start); root.classList.remove("turned"); },
    addEventListener: (_, listener) => listeners.add(listener),
  };
}
