// The player of a lesson. Its state is x, from 0 to the number of strokes: the whole part of x is
// the number of complete strokes, the rest is the share of the next one. What is visible depends
// on x alone: paint(x).
//
// mount(root, data) -> {load, seek, play, stop, place, where, does, take, dispose, x}. The root has
// the places that vad/page/document.py writes; data is that of vad/page/parts.py. After each change
// the root gets an event "vad:step" with x as its detail. What buttons and keys do is in "does";
// take(others) lets others answer in their stead, until take(null).

const smooth = (t) => t * t * (3 - 2 * t);
const ray = (degrees) => [Math.cos(degrees * Math.PI / 180), Math.sin(degrees * Math.PI / 180)];
// After a step that was asked for, a number is read for so many seconds before it flies.
const READ = .3;
// What fades hides nothing beneath it, when it has so little ink.
const NEARLY_GONE = .3;
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

// Called again and again, it lets something be done once, when no call has come for some milliseconds.
function rested(what, span) {
  let due = 0, timer = 0;
  const ring = () => {
    const left = due - performance.now();
    timer = left > 1 ? setTimeout(ring, left) : 0;
    if (!timer) what();
  };
  return () => {
    due = performance.now() + span;
    timer ||= setTimeout(ring, span);
  };
}

// The numbers at a share: linear between knots, constant beyond them.
function between(knots, share) {
  const next = knots.findIndex((knot) => knot[0] > share);
  if (next <= 0) return knots.at(next).slice(1);
  const low = knots[next - 1], high = knots[next], way = (share - low[0]) / (high[0] - low[0]);
  return low.slice(1).map((from, i) => from + way * (high[i + 1] - from));
}

// The first part of lines "Mx yldx dy…", piece after piece.
function trimmed(data, part) {
  const pieces = data.split("M").slice(1).map((piece) => piece.match(/-?(\d+\.?\d*|\.\d+)/g).map(Number));
  const lengths = pieces.map((n) => n.map((_, i) => i > 1 && i % 2 ? Math.hypot(n[i - 1], n[i]) : 0));
  let left = part * lengths.flat().reduce((sum, each) => sum + each, 0), drawn = "";
  pieces.forEach((n, k) => {
    if (left > 0) drawn += `M${n[0]} ${n[1]}l`;
    for (let i = 3; i < n.length && left > 0; i += 2) {
      const share = Math.min(1, left / (lengths[k][i] || 1));
      drawn += ` ${n[i - 1] * share} ${n[i] * share}`;
      left -= lengths[k][i];
    }
  });
  return drawn;
}

// Scales a vector (right, down) by a factor across an axis, whose direction is given in degrees
// clockwise.
function narrowed(right, down, factor, degrees) {
  const [cos, sin] = ray(degrees), more = (factor - 1) * (down * cos - right * sin);
  return [right - more * sin, down + more * cos];
}

// Scales lines "Mx yldx dy…" by a factor across an axis through a point.
function squeezed(data, factor, x, y, degrees) {
  const place = (right, down) => narrowed(right, down, factor, degrees);
  return data.split("M").slice(1).map((piece) => {
    const n = piece.match(/-?(\d+\.?\d*|\.\d+)/g).map(Number), first = place(n[0] - x, n[1] - y);
    const ways = n.map((_, i) => i > 1 && i % 2 ? place(n[i - 1], n[i]).join(" ") : "").join(" ");
    return `M${first[0] + x} ${first[1] + y}l${ways}`;
  }).join("");
}

function arc(part, x, y, radius, start, sweep, degrees = 0, narrow = 1) {
  const ways = (angle) => narrowed(...ray(-angle), narrow, degrees);
  const at = (angle) => ways(angle).map((way, i) => [x, y][i] + radius * way).join(" ");
  const turn = part * sweep, flags = `${+(Math.abs(turn) > 180)} ${+(turn < 0)}`;
  return part > 0 ? `M${at(start)}A${radius} ${narrow * radius} ${degrees} ${flags} ${at(start + turn)}` : "";
}

// Shows a growing mark at a share; at 1 it has its final state. See vad/page/ink.py.
function growing(mark, [kind, knots, x, y, ...bow]) {
  const elements = mark.localName === "g" ? [...mark.children] : [mark];
  const data = elements.map((each) => each.getAttribute("d")), radii = elements.map((each) => +each.getAttribute("r"));
  const draw = (path) => elements.forEach((each, i) => each.setAttribute("d", path(data[i])));
  const shows = {
    trim: ([part]) => draw((whole) => trimmed(whole, part)),
    bow: ([part]) => draw(() => arc(part, x, y, ...bow)),
    slide: ([right, down]) => mark.setAttribute("transform", `translate(${right} ${down})`),
    lead: ([part]) => {
      const size = Math.min(1, part / bow[0]), [u, v] = data[0].match(/-?(\d+\.?\d*|\.\d+)/g), at = (z, by) => z * (1 - size) + by * (1 - part);
      mark.setAttribute("transform", `translate(${at(u, x)} ${at(v, y)}) scale(${size})`);
    },
    turn: ([degrees]) => mark.setAttribute("transform", `rotate(${degrees} ${x} ${y})`),
    scale: ([factor]) => elements.forEach((each, i) => each.setAttribute("r", factor * radii[i])),
    swing: ([factor]) => draw((whole) => squeezed(whole, factor, x, y, ...bow)),
    // A halo repeats its text with <use>, and stays until that is nearly gone, as in vad/painting/painter.py.
    fade: ([alpha]) => {
      const text = mark.querySelector("text"), last = elements.at(-1);
      last.setAttribute(text ? "fill-opacity" : "opacity", alpha);
      if (text) last.setAttribute("stroke-opacity", +(alpha > NEARLY_GONE));
    },
  };
  const restore = () => elements.concat(mark).forEach((each, i) => {
    for (const name of ["transform", "opacity", "fill-opacity", "stroke-opacity"]) each.removeAttribute(name);
    if (data[i]) each.setAttribute("d", data[i]);
    if (radii[i]) each.setAttribute("r", radii[i]);
  });
  return (share) => share < 1 ? shows[kind](between(knots, share)) : restore();
}

// The beats between which an element is visible: "3 5 7 9", or "9" for all from that one on.
function spans(element) {
  const beats = (element.dataset.b ?? element.dataset.s).split(" ").map(Number), pairs = [];
  for (let i = 0; i < beats.length; i += 2) pairs.push([beats[i], beats[i + 1] ?? Infinity]);
  return pairs;
}

export function mount(root, data, { address = true } = {}) {
  const one = (selector) => root.querySelector(selector);
  const all = (selector) => [...root.querySelectorAll(selector)];
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const over = new AbortController();
  // Where it is wide, what stands beside the board is open, unless the drawings need that room.
  const wide = matchMedia("(min-width: 64rem) and (min-height: 35rem)"), broad = matchMedia("(min-aspect-ratio: 3/2)"), rail = one(".rail") ?? one(".steps");
  const open = () => wide.matches && (broad.matches || root.matches(".window")) && rail !== one(".steps");
  const scrub = one(".scrub"), status = one("[role=status]"), speed = one(".speed");
  const caption = one(".caption p"), count = one(".count"), dialog = one("dialog");
  const air = flights(root), scene = staging(root, calm), sends = sending(root);
  let lesson, x = 0, mode = "", goal = 0, rest = 0, beat, spoken, aloft = null;
  let frame = 0, then = 0, timer = 0, letters = true, kept = 0, others = null;

  const strokes = () => lesson.times.length;
  const length = (panel) => (lesson.first[panel + 1] ?? strokes()) - lesson.first[panel];
  const panelOf = (stroke) => Math.max(0, lesson.first.findLastIndex((first) => first <= stroke));

  function load(next, at = 0) {
    stop();
    lesson = { ...next, links: all(".steps a"), chapters: all(".chapters button"), pictures: all(".drawing > svg"), panel: 0 };
    scene.load(lesson);
    near(1);
    if (rail !== one(".steps")) lesson.pictures.forEach((picture, i) => lesson.panels.forEach(([, title], k) => {
      if (i > 0 && k > 0 && k !== i) link(picture.closest(".panel").querySelector("h2"), k, title);
    }));
    // Of several strokes with one caption the page has it once.
    lesson.links.forEach((link, i) => {
      const panel = panelOf(i);
      if (!link.innerHTML) link.innerHTML = lesson.links[i - 1].innerHTML;
      link.href = `#step=${lesson.panels[panel][0]}:${i - lesson.first[panel] + 1}`;
    });
    lesson.timed = all("[data-s], [data-b]").map((element) => [element, spans(element)]);
    lesson.growing = all("[data-g]").map((mark) =>
      [spans(mark.parentNode)[0][0], growing(mark, lesson.grow[mark.dataset.g]), mark]);
    scrub.max = strokes();
    beat = spoken = null;
    paint(at);
  }

  function paint(to) {
    x = clamp(to, 0, strokes());
    const shown = calm.matches ? Math.ceil(x) : x, done = Math.floor(shown), fresh = beat === null;
    const now = shown === strokes() ? 2 * done + 1 : shown ? 2 * done + (shown > done) : 2 * lesson.opens;
    if (now !== beat) {
      sends.stop();
      turn(now);
    }
    scrub.value = x;
    scrub.style.setProperty("--share", x / strokes());
    say(Math.ceil(x) - 1);
    // The hand keeps the arrangement of the moment.
    if (fresh || !others) stage(others ? scene.panel : x < strokes() || rest > 0 ? lesson.panel : -1, fresh);
    const grown = lesson.growing.filter(([since]) => since === now), marks = grown.map(([, , mark]) => mark).filter(scene.shows);
    const flight = shown > done && flown(done) && air.flight(lesson.flights[done], marks, lesson.pictures, now);
    for (const [, show] of grown) show(flight ? 1 : smooth(shown - done));
    if (flight || aloft) air.draw(flight, shown - done, lesson.trails);
    aloft = flight;
    root.dispatchEvent(new CustomEvent("vad:step", { detail: x }));
  }

  function turn(now) {
    const was = beat;
    beat = now;
    for (const [element, times] of lesson.timed) {
      const shows = times.some(([since, until]) => since <= now && now < until);
      element.classList.toggle("off", !shows);
      element.classList.toggle("on", shows);
      element.classList.toggle("new", times[0][0] === now);
    }
    for (const [since, show] of lesson.growing) if (since === was) show(1);
    lesson.pictures.forEach((picture, i) => {
      const first = lesson.first[i], whole = length(i);
      const label = { panel: lesson.panels[i][1], done: clamp((now >> 1) - first, 0, whole), count: whole };
      picture.setAttribute("aria-label", lesson.words.drawn.replace(/{(\w+)}/g, (_, key) => label[key]));
    });
  }

  // Whether a stroke flies, if its reader likes it, and the seconds that it takes.
  const flown = (stroke) => lesson.flights[stroke] && one(".travels").checked && !calm.matches;

  function timesOf(stroke) {
    const [grow, hold, ...starts] = lesson.times[stroke] ?? [0, 0], long = flown(stroke) ? lesson.flights[stroke][0] : grow;
    return [long, grow + hold - long, ...starts];
  }

  // The caption of a stroke is shown, and read out, from the beginning of the stroke.
  function say(stroke) {
    if (stroke === spoken) return;
    spoken = stroke;
    let shown = stroke;
    while (shown > 0 && lesson.links[shown].parentNode.className === "same") shown -= 1; // Each round goes one entry back.
    const panel = panelOf(stroke), words = lesson.spoken[shown] ?? lesson.words.begin;
    lesson.panel = panel;
    near(Math.max(1, panel));
    if (stroke < 0) caption.textContent = words;
    else caption.innerHTML = lesson.links[stroke].innerHTML;
    const first = lesson.first[panel], whole = length(panel);
    count.textContent = stroke < 0 ? "" : `${stroke - first + 1} / ${whole}`;
    scrub.setAttribute("aria-valuetext", words);
    status.textContent = document.activeElement === scrub ? "" : words;
    lesson.links.forEach((link, i) => i === shown ? link.setAttribute("aria-current", "step") : link.removeAttribute("aria-current"));
    follow();
    const chapter = lesson.chapters.findLast((each) => each.dataset.x <= Math.max(stroke, 0));
    lesson.chapters.forEach((each) => each.setAttribute("aria-current", each === chapter));
    clearTimeout(timer);
    if (address) timer = setTimeout(write, 250);
  }

  // The list of strokes moves, within its own frame, so that the one of now is in sight.
  function follow() {
    const link = lesson.links.find((each) => each.hasAttribute("aria-current")) ?? lesson.links[0];
    if (!link?.checkVisibility()) return;
    const frame = rail.getBoundingClientRect(), own = link.getBoundingClientRect();
    if (own.top < frame.top || own.bottom > frame.bottom) rail.scrollTop += (own.top + own.bottom - frame.top - frame.bottom) / 2;
  }

  // A chapter that was chosen is current before its first stroke, and its panel is seen.
  function opened(at) {
    const panel = lesson.panel = panelOf(at), chapter = lesson.chapters.findLast((each) => each.dataset.x <= at);
    near(panel);
    stage(panel);
    lesson.chapters.forEach((each) => each.setAttribute("aria-current", each === chapter));
    caption.textContent = status.textContent = chapter.title || chapter.textContent;
    count.textContent = `${at - lesson.first[panel]} / ${length(panel)}`;
    spoken = null;
  }

  // A rate that a stroke has found flies to the arrow of its sense, or to its row: when its number is said.
  function sent(stroke) {
    const [wait, long] = lesson.sent[stroke] ?? [], number = caption.querySelector("data");
    if (!long || !number || !one(".travels").checked || calm.matches) return;
    const seen = all(`.drawing [data-s="${2 * stroke + 2}"]`).filter((each) => scene.shows(each) && !each.closest(".hand") && panelOf(stroke) !== lesson.pictures.indexOf(each.ownerSVGElement));
    const goals = seen.length ? seen : all(".results .new .cell").filter((each) => each.offsetWidth);
    if (goals.length) sends.send(number, goals, (mode === "play" ? Math.max(0, wait) : READ) / speed.value, long / speed.value);
  }

  // While it is played, a caption that calculates is said in beats.
  function beats(at) {
    const stroke = rest > 0 ? at - 1 : Math.floor(at), [grow, hold, ...starts] = timesOf(stroke);
    const past = rest > 0 ? grow + hold - rest : (at - stroke) * grow;
    caption.dataset.said = 1 + starts.filter((start) => start <= past).length;
  }

  const stage = (panel, atOnce) => scene.to(panel, atOnce, lesson.move[0] / speed.value);

  // After the last stroke the answer is said in words.
  function conclude() {
    stage(-1);
    if (!lesson.answer?.length) return;
    [caption.innerHTML, status.textContent] = lesson.answer;
    count.textContent = "";
    spoken = null;
  }

  function link(heading, panel, title) {
    const other = document.createElement("button");
    Object.assign(other, { className: "other", textContent: title });
    other.dataset.panel = panel;
    heading.parentNode.insertBefore(other, heading.nextSibling);
  }

  // A narrow window shows the first panel and one other.
  function near(panel) {
    lesson.pictures.forEach((picture, i) => picture.closest(".panel")?.classList.toggle("far", i > 0 && i !== panel));
    all(".results tr").forEach((row) => [...row.children].slice(1).forEach((cell, i) =>
      cell.classList.toggle("far", i > 0 && i !== panel)));
  }

  function write() {
    if (place(location.hash) === Math.ceil(x) || !/^(#(step=|hand).*)?$/.test(location.hash)) return;
    try { history.replaceState(null, "", `#step=${Math.ceil(x)}`); } catch { /* a frame without an address */ }
  }

  // "#step=7" or "#step=velocity:4": so many strokes done, of all or of a panel.
  function place(hash) {
    const [, panel, digits] = /^#step=(?:([^:]+):)?(\d{1,6})$/.exec(hash) ?? [];
    if (!digits) return null;
    if (!panel) return +digits <= strokes() ? +digits : null;
    const index = lesson.panels.findIndex(([name]) => name === panel);
    const whole = length(index);
    return index >= 0 && +digits >= 1 && +digits <= whole ? lesson.first[index] + +digits : null;
  }

  function stop() {
    mode = "";
    delete caption.dataset.said;
    cancelAnimationFrame(frame);
    one("[data-do=play]").classList.remove("on");
    label(lesson?.words.play);
  }

  function label(words) {
    const button = one("[data-do=play]");
    if (words) ["aria-label", "title"].forEach((key) => button.setAttribute(key, words));
  }

  function run(how, to) {
    stop();
    if (x === strokes()) x = 0;
    const panel = panelOf(Math.floor(x)), moves = lesson.move.length && panel !== scene.panel;
    [mode, goal, rest, then] = [how, to, moves ? lesson.move[1] : 0, performance.now()];
    if (moves) stage(panel);
    if (how === "play") {
      one("[data-do=play]").classList.add("on");
      label(lesson.words.pause);
    }
    frame = requestAnimationFrame(tick);
  }

  function tick(time) {
    // A page that was hidden goes on from where it stopped.
    let left = clamp(time - then, 0, 250) / 1000 * speed.value, at = x;
    then = time;
    // Each round uses up time or goes on by a stroke.
    while (left > 0 && (rest > 0 || at < goal)) {
      const stroke = Math.floor(at), [grow, hold] = timesOf(stroke);
      const need = rest > 0 ? rest : (stroke + 1 - at) * grow, used = Math.min(left, need);
      left -= used;
      if (rest > 0) rest -= used;
      else if (used < need) at += used / grow;
      else [at, rest] = [stroke + 1, mode === "play" ? hold : 0];
    }
    if (at !== x) {
      paint(at);
      if (Number.isInteger(at)) sent(at - 1);
    }
    if (rest > 0 || at < goal) {
      if (mode === "play") beats(at);
      if (at < goal && rest > 0 && rest <= lesson.move[1]) stage(panelOf(at));
      frame = requestAnimationFrame(tick);
    } else {
      const played = mode === "play";
      stop();
      if (played) conclude();
    }
  }

  function seek(to, atOnce) {
    stop();
    paint(to);
    if (atOnce) stage(scene.panel, true);
  }

  const play = () => run("play", strokes());
  const next = () => Math.min(Math.floor(x) + 1, strokes());
  const does = {
    first: () => seek(0),
    last: () => seek(strokes()),
    back: () => seek(Math.ceil(x) - 1),
    chapter: (to) => { seek(to); if (to && to < strokes()) opened(to); },
    onward: () => does.forward(false),
    forward: (atOnce) => x === strokes() ? conclude() : atOnce || mode === "step" ? seek(next()) : run("step", next()),
    play: () => mode === "play" ? stop() : play(),
    strokes: () => unfold(rail.classList.contains("closed")),
    theme: () => {
      const themes = root.dataset.themes.split(" ");
      root.dataset.theme = themes.find((each) => each !== root.dataset.theme) ?? themes[0];
    },
    // One panel alone, as large as the window has room for; again, all of them.
    large: () => {
      const { panel } = lesson, large = !root.classList.contains("large");
      root.classList.toggle("large", large);
      lesson.pictures.forEach((picture, i) => picture.closest(".panel").classList.toggle("big", large && i === panel));
      // What stands beside its drawing, and a hair.
      const beside = all(".board > header, .big > .top, .big > .foot").reduce((sum, each) => sum + each.offsetHeight, 4);
      root.style.setProperty("--large", `${beside}px`);
      scene.draw();
    },
    full: () => document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen?.().catch(() => {}),
    keys: () => dialog.showModal(),
    close: () => dialog.close(),
  };

  const act = (name, shift) => (others?.[name] ?? does[name])?.(shift);

  function measure() {
    root.style.setProperty("--wide", `${one(".ruler").offsetWidth}px`);
  }

  function unfold(open) {
    rail.classList.toggle("closed", !open);
    if (one(".ruler")) measure();
    one("[data-do=strokes]").setAttribute("aria-expanded", open);
    if (lesson) follow();
    if (open && rail === one(".steps")) rail.scrollIntoView({ block: "nearest", behavior: calm.matches ? "auto" : "smooth" });
  }

  const KEYS = { ArrowRight: "forward", PageDown: "forward", ArrowLeft: "back", PageUp: "back", Home: "first", End: "last" };
  const LETTERS = { " ": "play", k: "play", s: "strokes", t: "theme", f: "full", h: "hand", z: "large", "?": "keys" };

  function key(event) {
    const target = event.composedPath()[0], name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey || dialog.open) return;
    if (!target.matches?.(".scrub, .turner") && target.closest?.("input, select, textarea, [contenteditable], [role=slider]")) return;
    if ((name === " " || name === "Enter") && target.closest?.("button, a, summary")) return;
    const what = KEYS[name] ?? (name === " " || letters ? LETTERS[name] : undefined);
    const chapter = letters && /^[1-9]$/.test(name) ? lesson.first[name - 1] : undefined;
    if (others?.shortcuts[name] && (letters || name.length > 1)) others.shortcuts[name](event.shiftKey);
    else if (what) act(what, event.shiftKey || target === scrub);
    else if (chapter !== undefined) act("chapter", chapter);
    else if (letters && "+-−=".includes(name)) faster("+=".includes(name) ? 1 : -1);
    else return;
    event.preventDefault();
  }

  function faster(by) {
    speed.selectedIndex = clamp(speed.selectedIndex + by, 0, speed.length - 1);
  }

  function click(event) {
    const button = event.target.closest("button[data-do]"), chapter = event.target.closest("[data-x]");
    const link = event.target.closest(".steps a");
    if (button) act(button.dataset.do, event.shiftKey);
    else if (chapter) act("chapter", +chapter.dataset.x);
    else if (event.target.matches(".other")) near(+event.target.dataset.panel);
    else if (link && !event.ctrlKey && !event.metaKey && !event.shiftKey) {
      event.preventDefault();
      seek(lesson.links.indexOf(link) + 1);
    } else if (event.target.closest(".drawing") && getSelection().isCollapsed) act("onward", false);
  }

  const on = (target, name, what) => target.addEventListener(name, what, { signal: over.signal });
  on(root, "click", click);
  on(document, "keydown", key);
  on(scrub, "input", () => seek(+scrub.value));
  on(scrub, "change", () => seek(Math.round(x)));
  on(scrub, "focus", () => (status.textContent = ""));
  on(one(".letters"), "change", (event) => (letters = event.target.checked));
  on(window, "beforeprint", () => { kept = x; seek(strokes(), true); });
  on(window, "afterprint", () => seek(kept, true));
  on(calm, "change", () => { beat = null; paint(x); });
  if (address) on(window, "hashchange", () => { const to = place(location.hash); if (to !== null) seek(to); });

  one(".control").hidden = false;
  unfold(open());
  // How high the dock is, and what stands above it beside two drawings: whichever the second is.
  const own = one(".control"), head = one(".board > header"), sized = new ResizeObserver(() => {
    root.classList.add("sizing");
    const [first, ...others] = all(".panel").map((panel) => [...panel.querySelectorAll(".top, .foot")].reduce((sum, each) => sum + each.offsetHeight, 0));
    root.classList.remove("sizing");
    root.style.setProperty("--dock", `${own.offsetHeight}px`);
    root.style.setProperty("--beside", `${head.offsetHeight + first + Math.max(0, ...others)}px`);
  });
  for (const each of [own, head, ...all(".foot")]) sized.observe(each);
  // How wide the board is, by a line in it that has no height, which no size within the board moves.
  const ruler = one(".board").appendChild(document.createElement("div"));
  ruler.className = "ruler";
  const measured = new ResizeObserver(measure);
  measured.observe(ruler);
  measure();
  root.classList.add("sized");
  on(wide, "change", () => unfold(open()));
  one("[data-do=full]").hidden = !document.fullscreenEnabled;
  one("[data-do=theme]").hidden = !root.dataset.themes?.includes(" ");
  load(data, data.start);
  if (address) seek(place(location.hash) ?? x, true);
  return {
    load, seek, play, stop, place, does, on, speed, status, stage,
    take: (mode) => { stop(); others = mode; label(lesson.words.play); follow(); },
    fit: scene.draw, settle: scene.settle,
    // The last stroke that is drawn: its panel, and its number there.
    where: () => { const last = Math.max(0, Math.ceil(x) - 1), panel = panelOf(last); return [panel, last - lesson.first[panel] + 1]; },
    strokes,
    // Whether a chapter was chosen, and nothing of it is drawn yet.
    get begins() { return x > 0 && x === lesson.first[lesson.panel]; },
    // Whether all of a panel is drawn.
    whole: (panel) => x >= lesson.first[panel] + length(panel),
    dispose: () => { stop(); sends.stop(); scene.dispose(); sized.disconnect(); measured.disconnect(); root.classList.remove("sized"); over.abort(); },
    get x() { return x; },
    get staged() { return scene.panel; },
    // The panel that is drawn large, -1 for none, and by how much it differs from that of the sheet.
    get large() { return [scene.large, ...(lesson.large[scene.large] ?? []).slice(1, 4)]; },
  };
}
