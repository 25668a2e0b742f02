// The rail while a hand holds the mechanism: sliders and boxes for its rates and its dimensions, and
// what is shown.
//
// railed(root, body, dock): each row has a name, a box, a unit and a slider with a notch at the
// lesson's value. What does not go is not done: the slider stops, and the dock says why.

const SOME = 5, FOLDED = 4, STEPS = 32;

function railed(root, body, dock) {
  const { data, state } = body, { words } = data, rows = [];
  const place = root.querySelector(".set"), items = [...root.querySelectorAll("header p span")].map((span) => [span, span.textContent]);
  if (!place) return;

  function element(kind, properties, ...inside) {
    const made = Object.assign(document.createElement(kind), properties);
    made.append(...inside);
    return made;
  }

  const section = (title, ...inside) => {
    const made = element("fieldset", {}, element("legend", { textContent: title }), ...inside);
    place.append(made);
    return made;
  };

  // A number with as many digits as a step of the slider tells.
  const digits = (step) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const tidy = (value, step) => +value.toPrecision(12) === +value.toFixed(digits(step)) ? value.toFixed(digits(step)).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "") : `${+value.toPrecision(6)}`;
  const written = (text) => text.replace("-", "−").replace(".", data.point);

  function row(name, html, index, [low, high], unit) {
    const step = round125((high - low) / 200), start = data.start[index];
    const slider = element("input", { type: "range", min: low, max: high, step: "any" });
    const box = element("input", { name, inputMode: "decimal", autocomplete: "off" });
    const label = element("span", { className: "name" });
    label.innerHTML = html;
    for (const each of [slider, box]) each.setAttribute("aria-label", `${label.textContent}${unit && ", "}${unit}`);
    slider.style.setProperty("--notch", clamp((start - low) / (high - low), 0, 1));
    const made = element("div", { className: "size" }, label, box, element("span", { className: "unit", textContent: unit }), slider);
    // Most of a mechanism's numbers stay while its driver moves.
    const mark = dock.marking(box);
    let shown = "";
    const show = () => {
      const past = mark.past(), typing = document.activeElement === box && !past;
      const says = written(tidy(state[index], step)), now = `${state[index]} ${typing ? box.value : says}`;
      if (!past && now === shown) return;
      shown = now;
      slider.value = state[index];
      if (!typing) box.value = says;
      slider.setAttribute("aria-valuetext", `${box.value} ${unit}`);
    };
    const change = (value) => {
      dock.begin();
      dock.say();
      if (dock.beyond && (body.refused(index, value)[0] || !body.holds(state.map((each, i) => (i === index ? value : each))))) return dock.beyond(name, value);
      const said = reached(index, value, step / STEPS);
      dock.settle();
      show();
      const [asked, kept] = [value, state[index]].map((each) => written(tidy(each, step)));
      const active = box === document.activeElement;
      mark(active && said !== "");
      if (said) dock.fault(filled(words[said], { name: label.textContent, place: `${asked} ${unit}`, value: `${kept} ${unit}` }));
      else if (active) box.value = asked;
    };
    const typed = () => {
      const value = dock.read(box.value, unit), [word, ...ends] = value === null ? ["no-number"] : body.refused(index, value);
      mark(false);
      if (!word || (word === "beyond" && dock.beyond)) return change(value);
      dock.begin();
      const [least, most] = ends.map((each) => written(tidy(each, step)));
      dock.fault(filled(words[word], { name: label.textContent, value: box.value || "–", low: least, high: most, unit }));
      mark(true);
    };
    slider.addEventListener("input", () => change(Math.round(slider.value / step) * step));
    slider.addEventListener("change", dock.commit);
    slider.addEventListener("dblclick", () => { change(start); dock.commit(); });
    box.addEventListener("change", typed);
    box.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      mark(false);
      box.blur();
      show();
      event.stopPropagation();
    });
    rows.push({ show, name, index, step, unit });
    return made;
  }

  // Sets an input; where the links then close nowhere, or the picture does not hold, as near to it
  // as it goes, to a length that does not matter. If that is not all the way, the words that say why.
  function reached(index, value, near) {
    const was = [...state], to = (share) => was.map((each, i) => i === index ? (share < 1 ? each + share * (value - each) : value) : each);
    if (body.set(to(1))) return "";
    const why = body.holds(to(1)) ? "unclosed-nowhere" : "guarded";
    let inside = 0, outside = 1;
    // Each round halves what is in question: after 53 of them nothing lies between.
    for (let round = 0; round < 53 && (outside - inside) * Math.abs(value - was[index]) > near; round++) {
      const middle = (inside + outside) / 2;
      if (body.set(to(middle))) inside = middle;
      else outside = middle;
    }
    body.set(to(inside));
    return why;
  }

  // The rates reach to both sides, as far as the lesson's own or a usual one.
  const rates = data.own.slice(1).map((_, i) => {
    const own = Math.abs(data.start[i + 1]), speed = Math.abs(data.start[1]);
    return 2 * (own || (i && body.turns ? speed ** 2 / 2 : speed) || 10);
  });
  const motion = rates.map((most, i) => row(data.inputs[i + 1], data.symbols[i + 1], i + 1, [-most, most], data.units[i + 1]));
  const sizes = data.dimensions.map(([name, , low, high, unit, index]) => row(name, (data.names ?? {})[name] ?? name, index, [low, high], unit));
  if (data.sliders) {
    section(words.motion, ...motion);
    const first = sizes.length > SOME ? FOLDED : sizes.length;
    if (sizes.length) {
      const made = section(words.dimensions, ...sizes.slice(0, first));
      if (first < sizes.length)
        made.append(element("details", {}, element("summary", { textContent: filled(words.more, { count: sizes.length - first }) }), ...sizes.slice(first)));
    }
  }

  // In which way it is assembled: of each point that is placed, or of the whole mechanism, a choice.
  const taken = () => data.assemblies[body.assembly()][0];
  const choices = data.places.map(([point, ways]) => {
    const buttons = ways.map(([word, text]) => {
      const input = element("input", { type: "radio", name: `place ${point}`, value: word });
      input.addEventListener("change", () => {
        const wanted = point ? { ...taken(), [point]: word } : word;
        dock.assemble(data.assemblies.findIndex(([name]) => point ? Object.entries(wanted).every(([each, way]) => name[each] === way) : name === wanted));
      });
      return [input, element("label", {}, input, text)];
    });
    const row = element("div", {}, element("span", { textContent: point }), ...buttons.map(([, label]) => label));
    row.setAttribute("role", "radiogroup");
    row.setAttribute("aria-label", point || words.assemblies);
    const show = () => {
      const now = taken();
      for (const [input] of buttons) {
        input.checked = input.value === (point ? now[point] : now);
        input.disabled = point && !data.assemblies.some(([name]) => Object.entries({ ...now, [point]: input.value }).every(([each, way]) => name[each] === way));
      }
    };
    return { row, show };
  });
  if (choices.length) section(words.assemblies, ...choices.map(({ row }) => row)).className = "assembly";

  // What is shown, each by a button.
  const shows = section(words.show);
  shows.className = "shows";
  function showing(name, on, change) {
    const button = element("button", { type: "button", textContent: name });
    const press = (now) => { button.setAttribute("aria-pressed", now); change(now); };
    button.addEventListener("click", () => press(button.getAttribute("aria-pressed") !== "true"));
    shows.append(button);
    press(on);
    return button;
  }
  showing(words.names, true, (on) => root.classList.toggle("unlettered", !on));

  // The line beside the title has the dimensions of now, and those that it left out as usual once they
  // are others.
  const called = ({ name }) => `${(data.names ?? {})[name] ?? name} `.replaceAll(" ", "\u00a0");
  const valued = ({ index, step, unit }) => `${written(tidy(state[index], step))}${unit && unit !== "°" ? "\u00a0" : ""}${unit}`;
  const changed = ({ index }) => dock.held && state[index] !== data.start[index];
  const listed = items.map(([span, text]) => {
    const rest = (each) => text.replaceAll(" ", "\u00a0").split(called(each));
    const own = rows.find((each) => each.index >= data.own.length && !rest(each)[0] && /^[−\d]/.test(rest(each)[1]));
    return [span, text, own ? [own, ...rows.filter(({ name }) => text.includes("∠") && name === `${own.name}_twist`)] : []];
  });
  const left = rows.filter((each) => each.index >= data.own.length && !listed.some(([, , both]) => both.includes(each)));
  const more = element("span", {});
  items.at(-1)?.[0].after(more);
  function follow() {
    for (const each of [...rows, ...choices]) each.show();
    for (const [span, text, both] of listed) {
      const says = both.some(changed) ? called(both[0]) + both.map(valued).join(" ∠ ") : text;
      if (span.textContent !== says) span.textContent = says;
    }
    const says = left.filter(changed).map((each) => `, ${called(each)}${valued(each)}`).join("");
    if (more.textContent !== says) more.textContent = says;
  }

  dock.on(follow);
  follow();
  return showing;
}
