// What is set: the boxes, sliders and choices of what the player does not move itself.

function choose(mechanism, given = {}) {
  const values = (list) => Object.fromEntries(list.map(({ name, default: value }) => [name, given[name] ?? value]));
  const { parameters, inputs, assemblies, unit } = catalogue[mechanism];
  const places = Object.fromEntries(assemblies.map(([point, , choices]) =>
    [point, (choices.find(([name]) => name === given.places?.[point]) ?? choices[0])[0]]));
  const own = mechanism === start.mechanism; // points, loads and some panels are those of one mechanism
  set = { mechanism, parameters: values(parameters), inputs: values(inputs), places, length_unit: given.unit ?? unit,
    points: given.points ?? (own ? structuredClone(start.points) : {}), burden: own ? start.burden : {},
    panels: own ? start.panels : start.panels.filter((name) => usual.includes(name)) };
  step = given.step ?? null;
  find("#mechanism").value = mechanism;
  fields.clear();
  find("#parameters").replaceChildren(...parameters.map(row));
  find("#inputs").replaceChildren(...inputs.map(row));
  find("#assemblies").hidden = !assemblies.length;
  find("#places").replaceChildren(...assemblies.map(choice));
  spare();
}

function choice([point, text, choices]) {
  const place = element("div", { class: "choices" }), name = element("span", {}), ways = element("div", { class: "choice" });
  if (point) {
    place.setAttribute("role", "radiogroup");
    place.setAttribute("aria-label", text);
    name.textContent = text;
    place.append(name);
  }
  ways.append(...choices.map(([way, words]) => {
    const label = element("label", {}), input = element("input", { type: "radio", name: `place-${point}`, value: way });
    input.checked = way === set.places[point];
    input.addEventListener("change", () => { set.places[point] = way; assembled(); });
    label.append(input, words);
    return label;
  }));
  place.append(ways);
  return place;
}

// Shows what is set of the places of points; of a page that has such an assembly, or by a new one.
function assembled() {
  const ways = stands() ? standing.body.data.assemblies : [];
  const number = ways.findIndex(([name]) => typeof name === "string" ? name === set.places[""]
    : name && Object.entries(name).every(([point, way]) => way === set.places[point]));
  if (number < 0) want(true);
  else standing.dock.assemble(number);
}

function placed(places) {
  Object.assign(set.places, places);
  for (const input of root.querySelectorAll("#places input")) input.checked = set.places[input.name.slice(6)] === input.value;
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
    "aria-label": gaps(words.slider, { name: label }) });
  const side = element("span", { class: "unit" });
  text.textContent = label;
  side.textContent = entry().unit === set.length_unit ? unit : unit.replace(entry().unit, set.length_unit);
  slider.addEventListener("input", () => { put(name, +slider.value); want(true); });
  box.addEventListener("change", () => {
    const typed = box.value.trim();
    if (typed === shortened(group(name)[name])) return;
    put(name, typed === "" ? null : plain(typed) ?? typed, true);
    want(true);
  });
  box.addEventListener("keydown", (event) => { if (event.key === "Enter") box.dispatchEvent(new Event("change")); });
  fields.set(name, { place, box, slider });
  place.append(text, box, side, slider);
  show(name, group(name)[name]);
  return place;
}

function show(name, value) {
  const { box, slider } = fields.get(name);
  if (document.activeElement !== box || box.value.trim() !== value) box.value = shortened(value);
  if (typeof value === "number") slider.value = value;
  slider.setAttribute("aria-valuetext", box.value);
}

function put(name, value, typed = false) {
  group(name)[name] = value;
  if (typed) { if (typeof value === "number") fields.get(name).slider.value = value; } else show(name, value);
}

// What the page itself moves has no second box; all have one while no page stands.
function spare() {
  const data = stands() ? standing.body.data : { inputs: [], dimensions: [], own: [] };
  const own = [...data.inputs.slice(0, data.own.length), ...data.dimensions.map(([name]) => name)];
  for (const [name, { place }] of fields) place.hidden = own.includes(name);
  for (const each of root.querySelectorAll(".settings fieldset:not(#assemblies)"))
    each.hidden = ![...each.querySelectorAll(".row")].some((place) => !place.hidden);
}

// What is typed into a box of the page, and is no number there: a quantity with its unit.
rail.closest(".vad").addEventListener("change", (event) => {
  const { name, value } = event.target, typed = value?.trim();
  if (!name || !fields.has(name) || event.target.type === "range") return;
  const row = standing?.body.data.dimensions.find(([each]) => each === name), own = standing?.body.data.inputs.indexOf(name);
  const unit = row ? row[4] : standing?.body.data.units[own] ?? "";
  if (!typed || !standing || standing.dock.read(typed, unit) !== null) {
    if (broken) complain(null); // what it says is of another number
    return;
  }
  event.stopPropagation();
  group(name)[name] = typed;
  want(true);
}, true);
