// The window of vad gui: settings go to Python, and its answers are shown. It knows no mechanism.
// One question is asked at a time; of several that wait only the newest is asked. The files are
// joined to one script, in the order of vad/gui/window.py; this part is shared by all.

const DIGITS = 7; // as many as a box has room for; what is set keeps them all
const root = document.querySelector(".vad"), find = (selector) => root.querySelector(selector);
const { start, catalogue, words } = JSON.parse(document.getElementById("data").textContent);
const handle = find(".handle"), message = find(".message"), mend = find(".message button");
const fields = new Map();
let set = {}, player = null, shown = null, names = [], scales = {}, ways = {}, stands = null, grip = null, ranges = [], broken = false;
let wanted = null, aside = {}, asking = false, timer = 0, step = null, retry = null;

const entry = () => catalogue[set.mechanism];
const settable = () => [...entry().parameters, ...entry().inputs];
const group = (name) => entry().inputs.some((each) => each.name === name) ? set.inputs : set.parameters;
const written = (value) => typeof value === "number" ? String(+value.toPrecision(DIGITS)) : value ?? "";
const filled = (text, values) => text.replace(/{(\w+)}/g, (_, key) => values[key]);
// What is set: the boxes, sliders and choices on the left.

const CALM = 260; // milliseconds after the last change, until the lesson is asked for

function choose(mechanism, given = {}) {
  const values = (list) => Object.fromEntries(list.map(({ name, default: value }) => [name, given[name] ?? value]));
  const { parameters, inputs, assemblies, unit } = catalogue[mechanism];
  const places = Object.fromEntries(assemblies.map(([point, , choices]) =>
    [point, (choices.find(([name]) => name === given.places?.[point]) ?? choices[0])[0]]));
  set = { mechanism, parameters: values(parameters), inputs: values(inputs), places, length_unit: given.unit ?? unit };
  [scales, ways, stands, grip, step] = [{}, {}, null, null, given.step ?? null];
  root.classList.add("moving");
  find("#mechanism").value = mechanism;
  fields.clear();
  find("#parameters").replaceChildren(...parameters.map(row));
  find("#inputs").replaceChildren(...inputs.map(row));
  find("#assemblies").hidden = !assemblies.length;
  find("#places").replaceChildren(...assemblies.map(choice));
}

function choice([point, text, choices]) {
  const place = element("div", { class: "place" }), name = element("span", {}), ways = element("div", { class: "choice" });
  if (point) {
    place.setAttribute("role", "radiogroup");
    place.setAttribute("aria-label", text);
    name.textContent = text;
    place.append(name);
  }
  ways.append(...choices.map(([way, words]) => {
    const label = element("label", {}), input = element("input", { type: "radio", name: `place-${point}`, value: way });
    input.checked = way === set.places[point];
    input.addEventListener("change", () => { set.places[point] = way; changed(); });
    label.append(input, words);
    return label;
  }));
  place.append(ways);
  return place;
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
    if (plain === written(group(name)[name])) return;
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
// Questions to Python, and what is done with its answers.

function question(kind) {
  const present = (values) => Object.fromEntries(Object.entries(values).filter(([, value]) => value !== null));
  const asked = { mechanism: set.mechanism, parameters: present(set.parameters), inputs: present(set.inputs),
    assembly: "" in set.places ? set.places[""] : set.places, points: set.mechanism === start.mechanism ? start.points : {},
    length_unit: set.length_unit, panels: start.panels, language: start.language, style: start.style };
  if (kind === "pose") return { ...asked, scales, ways, known: classes(), ...(stands && { stands }) };
  if (kind === "beside") return { ...asked, inputs: { ...asked.inputs, ...aside } };
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
  return post(kind === "beside" ? "lesson" : kind, asked).then((answer) => answer.json(), () => ({ error: { kind: "stopped", message: words.stopped } }))
    .then((answer) => [kind, asked, answer]);
}

async function pump() {
  let pending = send();
  // Each round takes the answer to one question.
  while (pending) {
    const [kind, asked, answer] = await pending;
    asking = false;
    pending = wanted ? send() : null; // the next question goes out before this answer is painted
    if (asked.mechanism === set.mechanism) take(kind, asked, answer);
  }
}

function take(kind, asked, answer) {
  if (kind === "beside") return showBehind(answer);
  if (answer.ranges) [ranges, grip] = [answer.ranges, answer.handle];
  if (answer.error && shown !== set.mechanism) clear();
  if (answer.panels) (kind === "pose" ? move : play)(answer);
  complain(answer.error);
  if (kind === "lesson") {
    root.classList.remove("moving");
    stands = answer.error ? stands : asked.parameters;
    if (!answer.error) remember();
    else if (answer.error.kind === "dead-centre") showPosition(answer.error);
  }
  if (answer.results) showValues(answer.results, { ...asked.parameters, ...asked.inputs });
  placeHandle();
}

// At a dead centre only the position is drawn. If nothing is shown yet, the lesson of a pose near
// by is asked for first, because it has all panels.
function showPosition(error) {
  if (names.length) return want("pose");
  if (!error.try) return;
  aside = error.try;
  want("beside");
}

function showBehind(answer) {
  if (!answer.panels) return;
  play(answer);
  root.classList.add("bare");
  want("pose");
}

// A box in which a text with a unit was written shows its value in the unit of the box.
function showValues({ parameters, input, assembly }, asked) {
  for (const [name, value] of Object.entries({ ...parameters, ...input })) {
    const { box } = fields.get(name), own = group(name);
    if (typeof own[name] !== "string" || own[name] !== asked[name]) continue;
    own[name] = value;
    if (box.value.trim() === asked[name]) show(name, value);
  }
  find("#assemblies").disabled = assembly === null;
}
