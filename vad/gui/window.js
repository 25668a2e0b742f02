
// The window of vad gui: what is set goes to Python, what is answered is shown. It knows no
// mechanism. One question is asked at a time, and the newest wins.

const CALM = 260, GLIDE = 150, INSIDE = 0.002;
const root = document.querySelector(".vad"), find = (selector) => root.querySelector(selector);
const { start, catalogue, words } = JSON.parse(document.getElementById("data").textContent);
const handle = find(".handle"), message = find(".message"), mend = find(".message button");
const fields = new Map();
let set = {}, player = null, names = [], scales = {}, ways = {}, grip = null, ranges = [], broken = false;
let wanted = null, asking = false, timer = 0, step = null, retry = null;

const entry = () => catalogue[set.mechanism];
const settable = () => [...entry().parameters, ...entry().inputs];
const group = (name) => entry().inputs.some((each) => each.name === name) ? set.inputs : set.parameters;
const written = (value) => typeof value === "number" ? String(+value.toPrecision(12)) : value ?? "";
const filled = (text, values) => text.replace(/{(\w+)}/g, (_, key) => values[key]);

// ---- what is set -------------------------------------------------------------------------------

function choose(mechanism, given = {}) {
  const values = (list) => Object.fromEntries(list.map(({ name, default: value }) => [name, given[name] ?? value]));
  const { parameters, inputs, assemblies, unit } = catalogue[mechanism];
  const assembly = assemblies.find(([name]) => name === given.assembly) ?? assemblies[0];
  set = { mechanism, parameters: values(parameters), inputs: values(inputs), assembly: assembly?.[0] ?? null,
    length_unit: given.unit ?? unit };
  [scales, ways, step] = [{}, {}, given.step ?? null];
  root.classList.add("moving");
  find("#mechanism").value = mechanism;
  fields.clear();
  find("#parameters").replaceChildren(...parameters.map(row));
  find("#inputs").replaceChildren(...inputs.map(row));
  find(".choice").replaceChildren(...assemblies.map(([name, text]) => {
    const label = element("label", {}), input = element("input", { type: "radio", name: "assembly", value: name });
    input.checked = name === set.assembly;
    input.addEventListener("change", () => { set.assembly = name; changed(); });
    label.append(input, text);
    return label;
  }));
}

function element(name, attributes) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

function row({ name, label, unit, low, high, step: by }) {
  const place = element("div", { class: "row" }), id = `field-${name}`;
  const text = element("label", { for: id }), box = element("input", { id, inputmode: "decimal" });
  const slider = element("input", { type: "range", min: low, max: high, step: by,
    "aria-label": filled(words.slider, { name: label }) });
  const side = element("span", { class: "unit" });
  text.textContent = label;
  side.textContent = entry().unit === set.length_unit ? unit : unit.replace(entry().unit, set.length_unit);
  slider.addEventListener("input", () => { put(name, +slider.value); changed(); });
  box.addEventListener("change", () => {
    const plain = box.value.trim();
    put(name, plain === "" ? null : Number.isFinite(+plain) ? +plain : plain, true);
    changed();
  });
  box.addEventListener("keydown", (event) => { if (event.key === "Enter") box.dispatchEvent(new Event("change")); });
  fields.set(name, { box, slider });
  place.append(text, box, side, slider);
  show(name, group(name)[name]);
  return place;
}

function show(name, value) {
  const { box, slider } = fields.get(name);
  box.value = written(value);
  if (typeof value === "number") slider.value = value;
  slider.setAttribute("aria-valuetext", box.value);
}

function put(name, value, typed = false) {
  group(name)[name] = value;
  if (typed) { if (typeof value === "number") fields.get(name).slider.value = value; } else show(name, value);
}

function changed() {
  if (player && !root.classList.contains("moving")) player.seek(Infinity);
  root.classList.add("moving");
  [step, retry] = [null, null];
  want("pose");
  clearTimeout(timer);
  timer = setTimeout(() => want("lesson"), CALM);
}

// ---- questions and answers ---------------------------------------------------------------------

function question(kind) {
  const present = (values) => Object.fromEntries(Object.entries(values).filter(([, value]) => value !== null));
  const asked = { mechanism: set.mechanism, parameters: present(set.parameters), inputs: present(set.inputs),
    assembly: set.assembly, length_unit: set.length_unit, panels: start.panels, language: start.language, style: start.style };
  if (kind === "pose") return { ...asked, scales, ways };
  if (kind === "lesson") return { ...asked, scales: find("#lock").checked ? scales : {} };
  const style = root.dataset.theme, speed = +find(".speed").value;
  return { ...asked, style: start.style === "print" ? "print" : style, size: start.size, fps: start.fps, speed };
}

const post = globalThis.ask ?? ((path, body) => fetch(`/api/${path}`, { method: "POST", headers: { "content-type": "application/json" },
  body: JSON.stringify(body) }));

function want(kind) {
  wanted = kind;
  if (!asking) pump();
}

function send() {
  const kind = wanted, asked = question(kind);
  wanted = null;
  asking = true;
  return post(kind, asked).then((answer) => answer.json(), () => ({ error: { kind: "stopped", message: words.stopped } }))
    .then((answer) => [kind, asked, answer]);
}

async function pump() {
  let pending = send();
  while (pending) {
    const [kind, asked, answer] = await pending;
    asking = false;
    pending = wanted ? send() : null; // the next question goes out before this answer is painted
    if (asked.mechanism === set.mechanism) take(kind, asked, answer);
  }
}

function take(kind, asked, answer) {
  if (answer.ranges) [ranges, grip] = [answer.ranges, answer.handle];
  if (answer.panels) (kind === "pose" ? move : play)(answer);
  complain(answer.error);
  if (kind === "lesson") {
    root.classList.remove("moving");
    if (!answer.error) remember();
    else if (answer.error.kind === "dead-centre") want("pose"); // the position is there
  }
  if (answer.results) settle(answer.results, { ...asked.parameters, ...asked.inputs });
  hold();
}

// Boxes in which a text with a unit was written show what it came to.
function settle({ parameters, input, assembly }, asked) {
  for (const [name, value] of Object.entries({ ...parameters, ...input })) {
    const { box } = fields.get(name), own = group(name);
    if (typeof own[name] !== "string" || own[name] !== asked[name]) continue;
    own[name] = value;
    if (box.value.trim() === asked[name]) show(name, value);
  }
  find("#assemblies").disabled = assembly === null;
}

function move({ panels, rows, looks, scales: fresh, ways: sides }) {
  rules(looks);
  const sections = find(".panels").children, lines = find(".results tbody")?.children ?? [];
  names.forEach((name, i) => sections[i].classList.toggle("stale", !panels.some(([each]) => each === name)));
  for (const [name, scale, drawing] of panels) {
    const section = sections[names.indexOf(name)];
    if (!section) continue;
    section.querySelector(".scale")?.remove();
    section.querySelector(".top").insertAdjacentHTML("beforeend", scale);
    section.querySelector(".drawing").outerHTML = drawing;
    glide(name, scales[name], fresh[name]);
  }
  if (panels.length === names.length && lines.length === rows.length)
    rows.forEach((cells, i) => lines[i].replaceChildren(lines[i].firstElementChild, ...cells.map(cell)));
  [scales, ways] = [{ ...scales, ...fresh }, { ...ways, ...sides }];
}

function cell(html) {
  const row = document.createElement("tr");
  row.innerHTML = html;
  return row.firstElementChild;
}

function play({ head, panels, table, chapters, steps, data, looks, scales: fresh }) {
  const playing = retry === "play";
  rules(looks);
  const before = scales;
  names = data.panels.map(([name]) => name);
  find("header").innerHTML = head;
  find(".panels").innerHTML = panels;
  find(".results").innerHTML = table;
  find(".chapters").innerHTML = chapters;
  find(".lists").innerHTML = steps;
  const at = playing ? 0 : step ?? data.times.length;
  if (player) player.load(data, at);
  else player = mount(root, { ...data, start: at }, { address: false });
  names.forEach((name) => glide(name, before[name], fresh[name]));
  [scales, retry] = [fresh, null];
  if (playing) player.play();
}

const known = new Set();
function rules(looks) {
  const fresh = looks.split("\n").filter((rule) => rule && !known.has(rule));
  fresh.forEach((rule) => known.add(rule));
  if (fresh.length) document.getElementById("looks").append(`${fresh.join("\n")}\n`);
}

// A polygon whose scale has changed comes from the size that it had.
function glide(name, old, fresh) {
  if (!old || !fresh || String(old) === String(fresh) || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const unit = 720, place = ([x, y]) => [x * unit, (1 - y) * unit], factor = old[2] / fresh[2];
  const [from, to] = [place(old), place(fresh)], shift = [0, 1].map((i) => from[i] - factor * to[i]);
  const groups = find(".panels").children[names.indexOf(name)]?.querySelectorAll("svg > g") ?? [];
  const transform = [`matrix(${factor}, 0, 0, ${factor}, ${shift[0]}, ${shift[1]})`, "none"];
  for (const each of groups) each.animate({ transform }, { duration: GLIDE, easing: "ease-out" });
}

function complain(error) {
  broken = Boolean(error);
  root.classList.toggle("stale", broken && error.kind !== "dead-centre");
  find(".results").classList.toggle("stale", error?.kind === "dead-centre");
  message.classList.toggle("wrong", broken);
  for (const [name, { box }] of fields) box.setAttribute("aria-invalid", error?.field === name);
  const text = error ? error.message : catalogue[set.mechanism].title;
  if (find(".message span").textContent !== text) find(".message span").textContent = text;
  const tries = error?.try && Object.entries(error.try);
  mend.hidden = !tries && !["stopped", "refused", "busy"].includes(error?.kind);
  if (tries) {
    const label = (name) => settable().find((each) => each.name === name)?.label ?? name;
    mend.textContent = filled(words.try, { values: tries.map(([name, value]) => `${label(name)} ${written(value)}`).join(", ") });
    mend.onclick = () => { for (const [name, value] of tries) put(name, value); changed(); };
  } else {
    mend.textContent = words.retry;
    mend.onclick = () => changed();
    if (error?.hint) find(".message span").textContent = `${error.message} (${error.hint})`;
  }
}

// ---- by hand -----------------------------------------------------------------------------------

const picture = () => find(".panels").children[names.indexOf("position")]?.querySelector("svg");

function hold() {
  const svg = picture(), matrix = svg?.getScreenCTM();
  handle.hidden = !grip || !matrix;
  if (handle.hidden) return;
  const at = new DOMPoint(...grip.at).matrixTransform(matrix), stage = find(".stage").getBoundingClientRect();
  handle.style.left = `${at.x - stage.left}px`;
  handle.style.top = `${at.y - stage.top}px`;
  const [low, high] = [ranges[0]?.[0] ?? 0, ranges[ranges.length - 1]?.[1] ?? 360], now = set.inputs[grip.name];
  const { label, unit } = settable().find((each) => each.name === grip.name);
  const says = { "aria-valuemin": low, "aria-valuemax": high, "aria-valuenow": now,
    "aria-valuetext": `${written(now)} ${unit}`, "aria-label": filled(words.handle, { name: label }) };
  for (const [key, value] of Object.entries(says)) handle.setAttribute(key, value);
}

function measured({ clientX, clientY }) {
  const at = new DOMPoint(clientX, clientY).matrixTransform(picture().getScreenCTM().inverse());
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
  put(grip.name, +within(value).toFixed(digits));
  changed();
  hold();
}

handle.addEventListener("pointerdown", (event) => {
  if (event.button) return;
  handle.setPointerCapture(event.pointerId);
  handle.focus({ preventScroll: true });
  event.preventDefault();
});
handle.addEventListener("pointermove", (event) => {
  if (handle.hasPointerCapture(event.pointerId) && grip) turn(measured(event));
});
handle.addEventListener("keydown", (event) => {
  if (!grip || event.ctrlKey || event.altKey || event.metaKey) return;
  const [low, high] = [ranges[0][0], ranges[ranges.length - 1][1]], angle = grip.kind === "angle";
  const fine = angle ? 1 : (high - low) / 100, now = set.inputs[grip.name], by = event.shiftKey ? fine / 10 : fine;
  const to = { ArrowUp: now + by, ArrowRight: now + by, ArrowDown: now - by, ArrowLeft: now - by,
    PageUp: now + 15 * fine, PageDown: now - 15 * fine, Home: low, End: high }[event.key];
  if (to === undefined) return;
  event.preventDefault();
  turn(angle ? (to + 360) % 360 : to);
});
new ResizeObserver(hold).observe(find(".board"));

// ---- buttons, files and the address ------------------------------------------------------------

const does = {
  draw: () => { clearTimeout(timer); [retry, step] = ["play", null]; want("lesson"); },
  reset: () => { choose(set.mechanism); changed(); },
  link: () => { remember(); navigator.clipboard?.writeText(location.href).then(() => tell(words.linked), () => {}); },
};

function tell(text) {
  find(".message span").textContent = text;
}

async function save(extension) {
  const asked = question("export");
  tell(words.saving);
  const answer = await post(`export/${extension}`, asked).catch(() => null);
  if (!answer) return complain({ kind: "stopped", message: words.stopped });
  if (answer.headers.get("content-type").startsWith("application/json") && !answer.headers.get("content-disposition"))
    return complain((await answer.json()).error);
  const name = `${asked.mechanism}.${extension}`, address = URL.createObjectURL(await answer.blob());
  element("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
  tell(filled(words.saved, { name }));
}

function remember() {
  if (location.protocol === "about:") return; // in a cell of a notebook
  const kept = new URLSearchParams({ m: set.mechanism });
  for (const { name, default: value } of settable()) {
    const own = group(name)[name];
    if (own !== value) kept.set(name, own ?? "");
  }
  if (set.assembly !== entry().assemblies[0]?.[0]) kept.set("assembly", set.assembly);
  if (set.length_unit !== entry().unit) kept.set("unit", set.length_unit);
  const x = Math.ceil(player?.x ?? 0), all = +find(".scrub").max;
  if (player && x !== all) kept.set("step", x);
  if (start.language !== "en") kept.set("lang", start.language);
  history.replaceState(null, "", `${location.pathname}${location.search}#${kept}`);
}

function recall() {
  const kept = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
  if (!(kept.m in catalogue)) return false;
  const given = {};
  for (const { name } of [...catalogue[kept.m].parameters, ...catalogue[kept.m].inputs])
    if (kept[name]) given[name] = Number.isFinite(+kept[name]) ? +kept[name] : kept[name];
  choose(kept.m, { ...given, assembly: kept.assembly, unit: kept.unit, step: /^\d+$/.test(kept.step) ? +kept.step : null });
  return true;
}

root.addEventListener("click", ({ target }) => {
  const button = target.closest("[data-what]"), file = target.closest("[data-save]");
  if (button) does[button.dataset.what]();
  if (file) save(file.dataset.save);
});
find(".settings").addEventListener("submit", (event) => event.preventDefault());
find("#mechanism").addEventListener("change", (event) => { choose(event.target.value); want("lesson"); });
find("#language").value = start.language;
find("#language").addEventListener("change", ({ target }) => {
  remember();
  location.assign(`/?lang=${target.value}${location.hash.replace(/&lang=\w+/, "")}&lang=${target.value}`);
});
let writing = 0;
root.addEventListener("vad:step", () => {
  clearTimeout(writing);
  writing = setTimeout(() => { if (!root.classList.contains("moving") && !broken) remember(); }, 250);
});
addEventListener("hashchange", () => { if (recall()) want("lesson"); });

const lang = /[#&]lang=(\w\w)/.exec(location.hash)?.[1];
if (lang && lang !== start.language) location.replace(`/?lang=${lang}${location.hash}`);
if (!recall()) choose(start.mechanism, { ...start.parameters, ...start.inputs, assembly: start.assembly, unit: start.length_unit });
want("lesson");
