// The handle: a pointer or a key becomes an angle, a length or a place along a guide.

const INSIDE = 0.002; // of a range, how far from its end
const RING = 34; // its width on a page 1280 wide; labels keep at this distance

const picture = () => find(".panels").children[names.indexOf("position")]?.querySelector("svg");

let view = null; // from the drawing's pixels to the window's; null if there is no handle

// Puts the handle in its place. It is called only after an answer and when the window changes,
// because the browser must lay out the page to tell where the drawing is.
function placeHandle() {
  if (grip) write();
  view = grip && picture()?.getScreenCTM();
  handle.hidden = !view;
  if (!view) return;
  const at = new DOMPoint(...grip.at).matrixTransform(view), stage = find(".stage").getBoundingClientRect();
  const ring = `${RING * view.a}px`;
  if (handle.style.getPropertyValue("--ring") !== ring) handle.style.setProperty("--ring", ring);
  handle.style.transform = `translate(${at.x - stage.left}px, ${at.y - stage.top}px)`;
}

function write() {
  const [low, high] = [ranges[0]?.[0] ?? 0, ranges[ranges.length - 1]?.[1] ?? 360], now = set.inputs[grip.name];
  const { label, unit } = settable().find((each) => each.name === grip.name);
  const says = { "aria-valuemin": low, "aria-valuemax": high, "aria-valuenow": now,
    "aria-valuetext": `${written(now)} ${unit}`, "aria-label": filled(words.handle, { name: label }) };
  for (const [key, value] of Object.entries(says)) handle.setAttribute(key, value);
  if (document.activeElement !== fields.get(grip.name).box) show(grip.name, now);
}

function measured({ clientX, clientY }) {
  const at = new DOMPoint(clientX, clientY).matrixTransform(view.inverse());
  const x = at.x - grip.about[0], y = at.y - grip.about[1];
  if (grip.kind === "angle") return (Math.atan2(-y, x) * 180 / Math.PI + 360) % 360;
  if (grip.kind === "length") return Math.hypot(x, y) / grip.factor;
  return (x * grip.way[0] + y * grip.way[1]) / grip.factor;
}

// The value nearest to what the hand asks for at which the links close.
function within(value) {
  const turns = grip.kind === "angle" ? [-360, 0, 360] : [0];
  if (!ranges.length || ranges.some(([low, high]) => turns[2] && high - low >= 359.999)) return value;
  let best = value, least = Infinity;
  for (const [low, high] of ranges) {
    const slack = INSIDE * (high - low);
    for (const turn of turns) {
      const near = Math.min(Math.max(value + turn, low + slack), high - slack), away = Math.abs(near - value - turn);
      if (away < least) [best, least] = [near, away];
    }
  }
  return grip.kind === "angle" ? (best + 360) % 360 : best;
}

function turn(value) {
  const size = Math.max(...ranges.flat().map(Math.abs), 1e-9);
  const digits = grip.kind === "angle" ? 1 : Math.max(0, 3 - Math.floor(Math.log10(size)));
  const to = +within(value).toFixed(digits);
  if (to === set.inputs[grip.name]) return;
  set.inputs[grip.name] = to;
  changed();
}

handle.addEventListener("pointerdown", (event) => {
  if (event.button) return;
  handle.setPointerCapture(event.pointerId);
  handle.focus({ preventScroll: true });
  event.preventDefault();
});
// A "pointermove" event waits for the next frame, a raw update does not, and so the question goes out
// earlier. The box and the handle are written when its answer comes.
const moves = "onpointerrawupdate" in handle ? "pointerrawupdate" : "pointermove";
handle.addEventListener(moves, (event) => {
  if (grip && view && handle.hasPointerCapture(event.pointerId)) turn(measured(event));
});
handle.addEventListener("keydown", (event) => {
  if (!grip || !view || event.ctrlKey || event.altKey || event.metaKey) return;
  const [low, high] = [ranges[0][0], ranges[ranges.length - 1][1]], angle = grip.kind === "angle";
  const fine = angle ? 1 : (high - low) / 100, now = set.inputs[grip.name], by = event.shiftKey ? fine / 10 : fine;
  const to = { ArrowUp: now + by, ArrowRight: now + by, ArrowDown: now - by, ArrowLeft: now - by,
    PageUp: now + 15 * fine, PageDown: now - 15 * fine, Home: low, End: high }[event.key];
  if (to === undefined) return;
  event.preventDefault();
  turn(angle ? (to + 360) % 360 : to);
  write();
});
const sized = new ResizeObserver(placeHandle);
for (const place of [".stage", ".board"]) sized.observe(find(place));
addEventListener("scroll", placeHandle, { capture: true, passive: true });
