// The dock while a hand holds the mechanism: its track is the driver's way, its buttons are steps on
// it, and its line says what happens.
//
// docked(root, body, player) -> {begin, commit, settle, enter, leave, say, number, read, fault, on,
// renew, history}.
// A gesture is what one undo takes back: begin() before it, commit() when it is over, settle() when
// it is over unless more of it follows soon.

const GLIDE = 300, REST = 700, TURN = 6, PAST = 100;

// The largest of 1, 2, 5, 10 … that is not above a number.
function round125(most) {
  const ten = 10 ** Math.floor(Math.log10(most));
  return (most >= 5 * ten ? 5 : most >= 2 * ten ? 2 : 1) * ten;
}

const filled = (words, gaps) => words.replace(/{(\w+)}/g, (_, gap) => gaps[gap]);

function docked(root, body, player) {
  const one = (selector) => root.querySelector(selector);
  const { data, turns, state } = body, { words } = data, [unit] = data.units, [symbol] = data.symbols;
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const track = one(".turner"), box = one(".said input"), text = one(".said p"), ticks = one(".ticks");
  const back = one("[data-do=return]"), all = one("[data-do=all]"), other = one("[data-do=other]"), { status } = player;
  const running = () => root.classList.contains("turning");
  const [low, high] = turns ? [0, 360] : [data.ranges[0][0], data.ranges.at(-1)[1]];
  const little = turns ? 1 : round125((high - low) / 100), far = turns ? 90 : (high - low) / 4;
  const digits = turns ? 1 : Math.max(0, 1 - Math.floor(Math.log10(little)));
  const listeners = [];
  let held = false, gliding = false, kept = 0, past = [], future = [], before = null, frame = 0, timer = 0, way = 1, mishap = "", spoken = "", scaled = null, begins = false;

  // Numbers are written and read as the page's language does.
  const number = (value, places = digits) => value.toFixed(places).replace("-", "−").replace(".", data.point);
  const read = (typed, own) => {
    const plain = typed.trim().replace(/[−–]/g, "-").replace(data.point, ".");
    const [, digits, other] = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*)$/i.exec(plain) ?? [];
    const value = digits * (!other || other === own ? 1 : data.readable[own]?.[other]);
    return Number.isFinite(value) ? value : null;
  };
  // As the table writes it, but as many decimals as a step has are there always.
  const here = () => {
    const [, decimals = ""] = typed(body.place).split(".");
    return number(body.place, Math.max(digits, decimals.includes("e") ? 0 : decimals.length));
  };
  const placed = () => turns ? `${here()}°` : `${here()} ${unit}`;
  const share = (place) => (place - low) / (high - low);

  // ---- what is seen and said ----

  function span(kind, words) {
    const made = document.createElement("span");
    made.className = kind;
    made.textContent = words;
    return made;
  }

  function sentence() {
    if (mishap) return [mishap, ""];
    if (body.atEnd) return [filled(words.limit, { place: placed(), why: body.parting() ?? words.parted }), ""];
    if (body.dead) return [filled(words.dead, { place: placed() }), ""];
    const [panel, step] = player.where(), whole = player.x >= player.strokes();
    return [words[running() ? "runs" : data.turn], whole ? "" : filled(words.shown, { panel: data.panels[panel], step })];
  }

  function say() {
    const [said, more] = sentence(), now = `${said} ${more}`.trim(), away = Boolean(mishap || !body.atEnd || running() || body.beyond() < 0);
    if (now !== text.textContent.trim()) text.replaceChildren(said, span("more", more && ` ${more}`));
    root.classList.toggle("limited", body.atEnd || body.dead);
    if (other.hidden !== away) other.hidden = away;
    track.setAttribute("aria-valuetext", turns ? filled(words.degrees, { value: here() }) : placed());
    if (body.atEnd && spoken !== now) speak();
  }

  function speak() {
    spoken = text.textContent;
    if (held) status.textContent = document.activeElement === track && !body.atEnd ? "" : `${spoken} ${placed()}`;
  }

  function shown() {
    if (!held) return;
    if (scaled !== body.ranges) scale();
    track.value = body.place;
    if (mark.past() || document.activeElement !== box) box.value = here();
    say();
    for (const listener of listeners) listener();
  }

  // Marks a box, or not, as one whose number is refused. past() takes the mark off, and tells so, once
  // something else was done.
  function marking(box) {
    let refused = false;
    const mark = (wrong) => { box.ariaInvalid = (refused = wrong) ? "true" : null; };
    mark.past = () => {
      const past = refused && !mishap;
      if (past) mark(false);
      return past;
    };
    return mark;
  }
  const mark = marking(box);

  function fault(said) {
    mishap = said;
    say();
    speak();
  }

  // The ticks of the track, the lesson's place, and where the links do not close.
  function scale() {
    const step = turns ? 15 : round125((high - low) / 20), named = turns ? 90 : 5 * step;
    const at = (place) => `calc(9px + (100% - 18px) * ${share(place).toFixed(5)})`;
    ticks.replaceChildren();
    scaled = body.ranges;
    const add = (kind, place, words = "") => {
      const tick = document.createElement(kind);
      tick.style.left = at(place);
      tick.textContent = words;
      ticks.append(tick);
      return tick;
    };
    // At most some hundred ticks: a step is at least a fiftieth of the way.
    for (let n = Math.ceil(low / step); n * step <= high; n++) {
      const label = Math.abs(n * step / named - Math.round(n * step / named)) < 1e-9;
      add("i", n * step, label ? number(n * step, Math.max(0, -Math.floor(Math.log10(step)))) + (turns ? "°" : "") : "");
    }
    add("b", turns ? data.start[0] - 360 * Math.floor(data.start[0] / 360) : data.start[0]);
    let from = low;
    const gap = (to) => { if (to - from > 1e-6 * (high - low)) add("s", from).style.width = `calc((100% - 18px) * ${share(to) - share(from)})`; };
    const open = body.ranges.flatMap(([a, b]) => turns && a < 0 ? [[0, b], [a + 360, 360]] : [[a, b]]).sort((a, b) => a[0] - b[0]);
    for (const [a, b] of open) { gap(clamp(a, low, high)); from = Math.max(from, b); }
    gap(high);
  }

  // ---- gestures ----

  function begin() {
    halt();
    if (!held) enter();
    clearTimeout(timer);
    mishap = "";
    if (before) return;
    before = [...state];
    body.said();
  }

  function commit() {
    clearTimeout(timer);
    if (before?.some((value, i) => value !== state[i])) {
      past = [...past, before].slice(-PAST);
      future = [];
    }
    before = null;
    body.said();
    able();
    timer = setTimeout(speak, REST);
  }

  function settle() {
    clearTimeout(timer);
    timer = setTimeout(() => { commit(); speak(); }, REST);
  }

  function able() {
    one("[data-do=undo]").disabled = !past.length;
    one("[data-do=redo]").disabled = !future.length;
  }

  function redone(back) {
    halt();
    if (before) commit();
    const [from, to] = back ? [past, future] : [future, past];
    if (!from.length) return;
    to.push([...state]);
    body.set(from.pop());
    body.said();
    able();
    timer = setTimeout(speak, REST);
  }

  function go(by) {
    begin();
    body.rest();
    body.move(by);
    body.said();
    settle();
  }

  // Takes another assembly, with the driver where it is, or at the nearest place that closes; then it
  // may go on.
  function assemble(number, by = 0) {
    begin();
    body.set(body.assembled(number));
    body.move(by);
    commit();
  }

  // At a limit the driver turns back while the links go on, in the other assembly.
  function further() {
    const [low, high] = body.range;
    assemble(body.beyond(), 2 * state[0] < low + high ? little : -little);
    track.focus({ preventScroll: true });
  }

  // ---- the two modes ----

  function enter() {
    if (gliding) halt();
    if (held) return;
    held = true;
    begins = player.begins;
    player.take(acts);
    player.seek(Math.ceil(player.x));
    kept = player.x;
    if (!player.x || one(".grip.off")) {
      // All is shown, and no panel is larger than another.
      player.seek(player.strokes());
      player.stage(-1, true);
    }
    root.classList.add("turned");
    player.fit();
    for (const [name, word] of Object.entries(RENAMED)) name_(name, words[word]);
    one("[data-do=lesson]").setAttribute("aria-pressed", false);
    one("[data-do=hand]").setAttribute("aria-pressed", true);
    offer();
    body.show();
  }

  const renamed = turns ? ["far-back", "little-back", "little-on", "far-on"] : ["more-back", "step-back", "step-on", "more-on"];
  const RENAMED = Object.fromEntries(["first", "back", "forward", "last", "strokes"].map((name, i) => [name, renamed[i] ?? "settings"]));
  const named = Object.fromEntries(Object.keys(RENAMED).map((name) => [name, one(`[data-do=${name}]`).title]));

  function name_(name, said) {
    for (const key of ["aria-label", "title"]) one(`[data-do=${name}]`).setAttribute(key, said);
  }

  function offer() {
    const whole = kept >= player.strokes() || !kept, [panel, step] = player.where();
    const hint = document.createElement("kbd");
    hint.textContent = words["key-escape"];
    const long = whole || begins || player.x !== kept ? words["return-lesson"] : filled(words.return, { panel: data.panels[panel], step });
    back.replaceChildren(span("long", long), span("short", words["return-short"]), " ", hint);
    all.hidden = player.x >= player.strokes();
  }

  // What is driven glides to the lesson's pose, the shorter way.
  function glide(then) {
    const from = body.assembled(0), to = body.bounded ? data.start.with(0, body.home().at) : data.start;
    let turn = to[0] - from[0];
    if (turns && !body.bounded) turn -= 360 * Math.round(turn / 360);
    const begun = performance.now(), still = calm.matches || from.every((value, i) => value === to[i]);
    const step = (time) => {
      const part = still ? 1 : clamp((time - begun) / GLIDE, 0, 1), soft = smooth(part);
      body.set(part < 1 ? from.map((value, i) => value + soft * (i ? to[i] - value : turn)) : to);
      if (part < 1) frame = requestAnimationFrame(step);
      else then();
    };
    gliding = !still;
    if (still) step(begun);
    else frame = requestAnimationFrame(step);
  }

  function leave(atOnce) {
    if (!held) return;
    halt();
    if (before) commit();
    const over = () => {
      held = gliding = false;
      [past, future, mishap] = [[], [], ""];
      mark(false);
      clearTimeout(timer);
      able();
      const lost = document.activeElement?.closest?.(".said, .dial, .set, .own");
      root.classList.remove("turned", "limited");
      player.fit();
      if (lost) one("[data-do=hand]").focus({ preventScroll: true });
      for (const [cell, html] of written) cell.innerHTML = html;
      for (const [name, said] of Object.entries(named)) name_(name, said);
      one("[data-do=lesson]").setAttribute("aria-pressed", true);
      one("[data-do=hand]").setAttribute("aria-pressed", false);
      player.take(null);
      if (begins) player.does.chapter(kept);
      else player.seek(kept);
      for (const listener of listeners) listener();
    };
    if (atOnce === true) { body.set(data.start); over(); }
    else glide(over);
  }

  // What a hand overwrites.
  const said = () => [...root.querySelectorAll(".cell")].map((each) => [each, each.innerHTML]);
  let written = said();

  // ---- turning by itself ----

  function halt() {
    cancelAnimationFrame(frame);
    gliding = false;
    if (running()) {
      root.classList.remove("turning");
      one("[data-do=play]").classList.remove("on");
      name_("play", words.play);
      body.view.steady(null);
      commit();
    }
  }

  function play() {
    if (running()) return halt();
    begin();
    body.rest();
    way = Math.sign(state[1]) || 1;
    root.classList.add("turning");
    one("[data-do=play]").classList.add("on");
    name_("play", words.pause);
    body.view.steady(body.among(72));
    let then = performance.now();
    const tick = (time) => {
      // A page that was hidden goes on from where it stopped.  The driver goes in round steps, so that
      // its number can be read; the rest of the time counts for the next picture.
      const pace = player.speed.value / TURN * (turns ? 360 : 2 * (high - low)) / 1000, due = pace * clamp(time - then, 0, 250);
      const by = Math.floor(due * 10 ** digits) / 10 ** digits;
      then = time - (due - by) / pace;
      body.rest();
      if (by) body.move(way * by, 0, true);
      if (body.atEnd) way = state[0] <= body.range[0] ? 1 : -1;
      frame = requestAnimationFrame(tick);
    };
    frame = requestAnimationFrame(tick);
  }

  // The page of a turn: the mechanism runs, unless its reader wants no motion.
  function run() {
    enter();
    for (const name of ["c", "o"]) acts.shortcuts[name]?.();
    if (!calm.matches) play();
  }

  // ---- what answers in the lesson's stead ----

  const acts = {
    first: () => go(-far),
    last: () => go(far),
    back: (fine) => go(fine ? -little / 10 : -little),
    forward: (fine) => go(fine ? little / 10 : little),
    play,
    onward: () => {},
    chapter: (to) => { leave(true); player.does.chapter(to); },
    shortcuts: {
      PageUp: () => go(-15 * little),
      PageDown: () => go(15 * little),
      Escape: () => leave(),
      h: () => gliding ? enter() : leave(),
    },
  };
  Object.assign(player.does, {
    hand: enter,
    lesson: () => leave(),
    return: () => leave(),
    all: () => { player.seek(player.strokes()); player.stage(-1); offer(); body.show(); back.focus(); },
    other: further,
    undo: () => redone(true),
    redo: () => redone(false),
  });

  player.on(document, "keydown", (event) => {
    if (!held || !(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || event.target.matches?.("input:not([type])")) return;
    redone(!event.shiftKey);
    event.preventDefault();
  });
  // Sets what is driven where a pointer is, in round numbers.
  const point = (place) => body.set([+place.toFixed(digits), ...state.slice(1)]);

  player.on(track, "input", () => {
    begin();
    point(+track.value);
    settle();
  });
  player.on(box, "change", () => {
    const value = read(box.value, unit);
    mark(value === null);
    if (value === null) return fault(filled(words["no-number"], { name: one(".place span").textContent, value: box.value || "–" }));
    begin();
    body.set([value, ...state.slice(1)]);
    box.value = here();
    commit();
  });
  player.on(box, "keydown", (event) => { if (event.key === "Escape") { box.value = here(); leave(); } });

  Object.assign(track, { min: low, max: high });
  track.setAttribute("aria-label", words[data.turns]);
  one(".place span").innerHTML = symbol;
  box.setAttribute("aria-label", words[data.turns]);
  box.name = data.inputs[0];
  one(".place span:last-child").textContent = turns ? "°" : `\u00a0${unit}`;
  for (const drawing of root.querySelectorAll(".panel:not(:first-child) .drawing")) drawing.dataset.none = words["no-polygon"];
  // Where a panel is drawn large or small again, its scales are others in all states, too.
  function arranged() {
    body.arrange(...player.large);
    for (const each of [...past, ...future, before ?? []]) for (const { input } of data.polygons) each.splice(input, 3, ...state.slice(input, input + 3));
  }
  player.on(root, "vad:stage", arranged);
  if (player.large[0] >= 0) arranged();
  body.reads(shown);
  player.on(window, "beforeprint", body.said);
  dragged(root, body, begin, () => { commit(); player.settle(); });
  for (const each of root.querySelectorAll(".switch, dl.own")) each.hidden = false;

  return {
    run, shortcuts: acts.shortcuts, point, assemble, begin, commit, settle, enter, leave, say, number, read, fault, marking,
    on: (listener) => listeners.push(listener),
    // Whom to ask for what this page's program does not hold for: beyond(name, value).
    beyond: null,
    // The lesson is now that of another pose, and its cells are as they stand.
    renew: () => { written = said(); if (held) { scale(); offer(); } },
    get held() { return held; },
    // Whether a gesture is not yet over.
    get busy() { return before !== null; },
    get history() { return [past, future]; },
    set history(both) { [past, future] = both; able(); },
  };
}
