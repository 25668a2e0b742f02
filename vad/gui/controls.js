// What is set: the boxes, sliders and choices on the left.

const CALM = 260; // milliseconds after the last change, until the fair copy is asked for

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
