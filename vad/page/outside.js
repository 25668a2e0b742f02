// A page for programs: what scripts on it ask of window.vad, and what a page around it sends.
//
// outside(root, body, dock, player) -> {solve, pose, step, back, state, addEventListener, …}. All
// that comes from outside passes one gate, which answers with a sentence, and a hint where it has one.

const REM = 16;

function outside(root, body, dock, player) {
  const { data, turns, state } = body, { words } = data, own = new Float64Array(data.size);
  const listeners = { pose: new Set(), step: new Set() };
  const names = [...data.inputs.slice(0, data.own.length), ...data.dimensions.map(([name]) => name)];
  const places = [...data.own.map((_, i) => i), ...data.dimensions.map((each) => each[5])];
  const wrong = (said, hint) => hint ? { error: said, hint } : { error: said };
  const quoted = (value) => { try { return String(JSON.stringify(value)).slice(0, 60); } catch { return typeof value; } };

  // The number of an assembly by its name, or by the places of some points; -1 for none. Where there
  // is but one, its name has no effect.
  const ways = data.assemblies.map(([name]) => name), any = ["open", "crossed"];
  function wayOf(value) {
    const own = ways[body.assembly()];
    if (own === null) return value === null || any.includes(value) ? 0 : -1;
    if (typeof own === "string" || value === null || typeof value !== "object") return ways.indexOf(value);
    const points = Object.keys(own), known = Object.keys(value).every((point) => points.includes(point));
    return known ? ways.findIndex((way) => points.every((point) => way[point] === (value[point] ?? own[point]))) : -1;
  }

  // The state that is asked for, or what is wrong with it.
  function gate(asked) {
    if (asked === null || typeof asked !== "object" || Array.isArray(asked)) return wrong(words.request, "{angle: 40}");
    const found = [...state];
    for (const [name, value] of Object.entries(asked)) {
      if (name === "assembly") {
        const number = wayOf(value), known = ways[0] === null ? any : ways;
        if (number < 0) return wrong(filled(words.assembly, { names: known.map(quoted).join(words.or), value: quoted(value) }),
          data.elsewhere.includes(value) && filled(words["other-page"], { value }));
        found.splice(0, found.length, ...body.assembled(number, found));
        continue;
      }
      const index = names.indexOf(name);
      if (index < 0) return wrong(filled(words.unknown, { name: name.slice(0, 60) }), filled(words.known, { names: names.join(", ") }));
      if (typeof value !== "number" || !Number.isFinite(value)) return wrong(filled(words["no-number"], { name, value: typeof value === "number" ? value : quoted(value) }));
      const [word, low, high] = body.refused(places[index], value);
      const unit = index < data.own.length ? data.units[index] : data.dimensions[index - data.own.length][4];
      if (word) return wrong(filled(words[word], { name, value, low, high, unit }), word === "positive" && value ? filled(words.try, { name, value: -value }) : "");
      found[places[index]] = value;
    }
    return found;
  }

  const exists = (all) => all.every((at) => own[at] - own[at] === 0);

  // The place of the driver, as it was asked for or as the page shows it.
  const degree = turns ? "°" : ` ${data.units[0]}`, said = ([place]) => `${place === state[0] ? body.place : place}${degree}`;

  // Where the links close, in words, and a place near by that does.
  function unclosed(values) {
    const [name] = names, place = said(values);
    const closes = (at) => { body.solve(at, ...values.slice(1), own, 0); return exists(data.closes); };
    const same = body.key(values) === body.key(data.start);
    const ranges = same ? data.ranges : stretches(closes, ...body.ends, turns);
    if (!ranges.length) return wrong(filled(words["unclosed-nowhere"], { name, place }));
    const { range: [low, high], at, off } = placed(ranges, values[0], turns);
    if (!off) return wrong(filled(words.dead, { place })); // a pin upon the pivot of its lever
    const written = ranges.map((ends) => ends.map((end) => `${+end.toPrecision(6)}${degree}`).join(" … ")).join(words.and);
    const inside = clamp(at, low + (high - low) / 50, high - (high - low) / 50);
    return wrong(filled(words.unclosed, { name, place, ranges: written }), filled(words.try, { name, value: +inside.toPrecision(4) }));
  }

  // Fills a part of the results with numbers.
  const read = (part) => typeof part === "number" ? own[part] + 0
    : Array.isArray(part) ? part.map(read)
    : typeof part === "string" ? part
    : Object.fromEntries(Object.entries(part).map(([name, each]) => [name, read(each)]));

  // The results of a pose as "vad solve --json" has them; nothing on the page changes.
  function solve(asked = {}) {
    const values = gate(asked);
    if (!Array.isArray(values)) return values;
    body.solve(...values, own, 2);
    if (!exists(data.closes)) return unclosed(values);
    if (!body.holds(values)) return wrong(words.unheld);
    if (!exists(data.rates)) return wrong(filled(words.dead, { place: said(values) }));
    const { solved } = data, found = {};
    for (const [name, part] of Object.entries(solved))
      if (name === "input") found.input = Object.fromEntries(part.map((each, i) => [each, values[i]]));
      else if (name === "parameters") found.parameters = { ...part, ...Object.fromEntries(data.dimensions.filter(([each]) => each in part).map((each) => [each[0], values[each[5]]])) };
      else if (name === "assembly") found.assembly = ways[body.assembly(values)];
      else found[name] = ["links", "joints", "points", "slides", "forces"].includes(name) ? read(part) : part;
    return found;
  }

  const now = () => ({
    ...Object.fromEntries(names.map((name, i) => [name, i ? state[places[i]] : body.place])),
    ...(ways.length > 1 && { assembly: ways[body.assembly()] }),
  });

  // Shows a pose, as if a hand had set it.
  function pose(asked = {}) {
    const values = gate(asked);
    if (!Array.isArray(values)) return values;
    body.solve(...values, own, 0);
    if (!exists(data.closes)) return unclosed(values);
    if (!body.holds(values)) return wrong(words.unheld);
    dock.begin();
    body.set(values);
    dock.commit();
    return now();
  }

  // Goes to a step of the lesson: 7, or "velocity:4".
  function step(to) {
    const found = ["number", "string"].includes(typeof to) ? player.place(`#step=${to}`) : null;
    if (found === null) return wrong(filled(words.step, { value: quoted(to) }), filled(words["steps-are"], { count: player.strokes() }));
    dock.leave(true);
    player.seek(found);
    return found;
  }

  // ---- the page around this one ----

  let due = 0, last = "", height = 0;
  const [board, control, panels] = [".board", ".control", ".panels"].map((each) => root.querySelector(each));

  // How high a frame should be, so that the board is as wide as it: what is above the dock grows with
  // the board, but for what panels in a lesson take of a higher frame. Where the rail stands beside the
  // board, the frame is so high that it stays there. A pixel more or less is none.
  function wanted() {
    const dock = control.offsetHeight, taken = panels.offsetHeight - parseFloat(getComputedStyle(panels).flexBasis);
    const spare = (parseFloat(getComputedStyle(control).marginTop) || 0) + Math.max(0, taken || 0);
    // On a phone drawings are smaller where the frame is low, and else as wide as their panels.
    const narrow = [...panels.querySelectorAll(".drawing")].map((each) => [each, each.firstElementChild.clientWidth]).filter(([, width]) => width);
    const more = narrow.reduce((sum, [each, width]) => sum + each.clientHeight * (each.clientWidth / width - 1), 0);
    const wide = board.offsetWidth + 2 * board.offsetLeft, above = board.offsetHeight - dock - spare + more;
    const found = Math.max(dock + above * wide / board.offsetWidth, innerWidth >= 64 * REM ? 35 * REM : 0);
    return Math.abs(found - height) < 3 ? height : Math.ceil(found);
  }

  function tell() {
    due = 0;
    height = wanted();
    const news = { height, step: player.x, pose: dock.held ? now() : null }, text = JSON.stringify(news);
    if (text !== last) parent.postMessage({ vad: news }, "*");
    last = text;
  }

  const later = () => { if (parent !== window && board.isConnected && !due) due = setTimeout(tell, 50); };

  function heard({ data: message, source }) {
    const asked = message?.vad;
    if (parent === window || source !== parent || asked === null || typeof asked !== "object") return;
    const answers = [];
    if ("pose" in asked) answers.push(asked.pose === null ? dock.leave() : pose(asked.pose));
    if ("step" in asked) answers.push(step(asked.step));
    const fault = answers.find((answer) => answer?.error);
    if (fault) parent.postMessage({ vad: fault }, "*");
  }

  const tellAll = (kind, news) => { for (const listener of listeners[kind]) listener(news); };
  player.on(window, "message", heard);
  body.on(() => { if (dock.held) tellAll("pose", now()); later(); });
  player.on(root, "vad:step", (event) => { if (!dock.held) tellAll("step", event.detail); later(); });
  dock.on(later);
  player.on(window, "resize", later);
  new ResizeObserver(later).observe(board);

  return {
    solve, pose, step,
    back: () => dock.leave(),
    get state() { return now(); },
    // How much work moves were: the attributes that they set, and the places tried for labels.
    get counts() { return { ...body.view.counts }; },
    addEventListener: (kind, listener) => { if (typeof listener === "function") listeners[kind]?.add(listener); },
    removeEventListener: (kind, listener) => listeners[kind]?.delete(listener),
  };
}
