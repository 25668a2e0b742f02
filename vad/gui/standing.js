// What stands on the page: a lesson, and the mechanism that a hand moves in it. A lesson of the pose
// in which the hand rests, the fair copy, takes the place of what the hand has drawn.

const stands = () => standing && standing.mechanism === set.mechanism;
const parsed = (html) => new DOMParser().parseFromString(html, "text/html").querySelector("main");

// The inputs, dimensions and the assembly of a pose.
const poseNow = () => {
  const { body } = standing, { data, state } = body;
  return [body.place, ...state.slice(1, data.own.length), body.key(state)].join();
};

// Where the number of a further point is, as "P.angle".
const pointOf = (name) => [set.points[name.split(".")[0]], name.endsWith(".distance") ? 1 : 2];

function resize(name, value) {
  if (name in set.parameters) set.parameters[name] = value;
  else pointOf(name)[0][pointOf(name)[1]] = value;
}

function poseOf({ input, parameters }) {
  const { data, turns } = standing.body, within = (degrees) => degrees % 360 + (degrees % 360 < 0 ? 360 : 0);
  const own = data.inputs.slice(0, data.own.length).map((name, i) => i || !turns ? input[name] : within(input[name]));
  const sizes = data.dimensions.map(([name]) => parameters[name] ?? pointOf(name)[0][pointOf(name)[1]]);
  return [...own, ...sizes, ...data.sides.map(() => 1)].join();
}

// The places of points in the assembly that the page shows.
function placesNow() {
  const { body } = standing, [name] = body.data.assemblies[body.assembly()];
  return typeof name === "string" ? { "": name } : name ?? {};
}

// The settings follow the hand; a fair copy of another pose gives way.
function followed() {
  if (!stands()) return;
  const { body, copied } = standing, { data, state } = body;
  data.inputs.slice(0, data.own.length).forEach((name, i) => (set.inputs[name] = i ? state[i] : body.place));
  for (const [name, , , , , index] of data.dimensions) resize(name, state[index]);
  if (data.sides.length) placed(placesNow());
  // Who passes by its pose does not see it.
  const same = poseNow() === copied && !standing.dock.busy;
  root.classList.toggle("copied", same);
  if (!same) want();
}

// The classes whose rules the page has: a class has the name of its rule.
const known = new Set();
function rules(looks) {
  const named = (rule) => rule.slice(1, rule.indexOf("{"));
  const fresh = looks.split("\n").filter((rule) => rule && !known.has(named(rule)));
  fresh.forEach((rule) => known.add(named(rule)));
  const { sheet } = document.getElementById("looks");
  fresh.forEach((rule) => sheet.insertRule(rule, sheet.cssRules.length));
}

// Puts a page in the place of the one that stands; what was open in that is open in this.
function stand(answer) {
  const again = stands(), made = parsed(answer.html);
  if (again && standing.dock.busy) standing.dock.commit(); // else what was done last could not be undone
  const was = again && memory();
  leave();
  rules(answer.looks);
  root.className = "vad page window moving";
  find(".board")?.remove();
  rail.before(made.querySelector(".board"));
  for (const place of [".steps", ".set"]) {
    find(place)?.remove();
    form().before(made.querySelector(place));
  }
  const svgs = root.querySelectorAll(".drawing > svg");
  answer.layers.forEach((layer, i) => svgs[i].insertAdjacentHTML("beforeend", layer));
  const all = answer.data.times.length, at = was?.x ?? step ?? all;
  standing = { mechanism: set.mechanism, key: answer.key, strokes: all, ...playing(root, { ...answer.data, start: Math.min(at, all) }) };
  standing.copied = poseOf(answer.results);
  globalThis.vad = standing.outside;
  standing.body.reads(followed);
  standing.dock.beyond = (name, value) => { resize(name, value); blamed = name; want(true); };
  standing.body.show();
  if (was ? was.held : step === null) standing.dock.enter();
  if (was) recalled(was);
  step = null;
  spare();
  root.classList.toggle("copied", poseNow() === standing.copied);
  globalThis.stood?.();
}

const form = () => find(".settings");

// What of a page is kept when another of the same mechanism takes its place.
function memory() {
  const { player, dock, body } = standing, all = [...root.querySelectorAll("button, input, select, summary, a")];
  return { x: player.x, held: dock.held, running: root.classList.contains("turning"), kept: dock.kept, past: dock.history,
    staged: player.staged, shows: [...root.querySelectorAll(".shows button")].map((each) => each.getAttribute("aria-pressed")),
    closed: rail.classList.contains("closed"), scrolled: rail.scrollTop, focus: all.indexOf(document.activeElement), count: all.length,
    inputs: body.data.inputs.join(), sides: body.data.sides.map((at) => body.state[at]), open: [...root.querySelectorAll(".set details")].map((each) => each.open) };
}

function recalled(was) {
  const { dock, body } = standing, all = root.querySelectorAll("button, input, select, summary, a");
  // The assembly that was taken is the page's own now.
  const turned = (state) => state.map((value, i) => value * (was.sides[body.data.sides.indexOf(i)] ?? 1));
  if (was.inputs === body.data.inputs.join()) dock.history = was.past.map((states) => states.map(turned));
  rail.classList.toggle("closed", was.closed);
  root.querySelectorAll(".shows button").forEach((each, i) => { if (was.shows[i] && each.getAttribute("aria-pressed") !== was.shows[i]) each.click(); });
  root.querySelectorAll(".set details").forEach((each, i) => (each.open = was.open[i] ?? false));
  if (was.count === all.length && was.focus >= 0) all[was.focus].focus({ preventScroll: true });
  rail.scrollTop = was.scrolled;
  if (was.held) standing.player.stage(was.staged, true);
  if (was.running) find("[data-do=play]").click();
}

// Puts the lesson of the pose in which the hand rests in the place of the lesson that stands; what
// the hand moves stays. False where they differ by more than their pose.
function copy(answer) {
  const { player, body, dock } = standing, { data } = body, made = parsed(answer.html);
  const both = (selector) => [root, made].map((each) => [...each.querySelectorAll(selector)]);
  const pairs = (selector) => { const [old, fresh] = both(selector); return old.map((each, i) => [each, fresh[i]]); };
  const [cells, others] = both(".results .cell");
  if (answer.data.times.length !== standing.strokes || cells.length !== others.length) return false;
  rules(answer.looks);
  for (const [old, fresh] of pairs(".panel")) {
    old.querySelector(".scale:not(.hand)")?.remove();
    const scale = fresh.querySelector(".scale");
    if (scale) old.querySelector(".top").append(scale);
    old.querySelector(".foot").replaceWith(fresh.querySelector(".foot"));
    const [svg, drawn] = [old, fresh].map((each) => each.querySelector(".drawing > svg"));
    svg.parentNode.style.cssText = drawn.parentNode.style.cssText;
    for (const each of [...svg.children]) if (!each.matches(".hand, .grip")) each.remove();
    svg.prepend(...drawn.childNodes);
  }
  cells.forEach((cell, i) => cell.replaceChildren(...others[i].childNodes));
  for (const place of [".chapters", ".lists"]) find(place).replaceChildren(...made.querySelector(place).childNodes);
  const { input } = answer.results;
  data.inputs.slice(0, data.own.length).forEach((name, i) => (data.start[i] = input[name]));
  for (const [name, values] of Object.entries(answer.scales)) {
    const first = data.inputs.indexOf(`${name} x`);
    if (first >= 0) data.start.splice(first, 3, ...values);
  }
  standing.copied = poseOf(answer.results);
  const said = player.status.textContent;
  for (const each of root.querySelectorAll(".other")) each.remove(); // the player adds them
  player.load(answer.data, player.x);
  player.status.textContent = said;
  dock.renew();
  if (poseNow() !== standing.copied) body.set(data.start);
  root.classList.add("copied");
  return true;
}

// Lets the page that stands do nothing more.
function leave() {
  standing?.dock?.begin();
  standing?.body.dispose();
  standing?.player.dispose();
}

// Removes all that belongs to another mechanism.
function clear() {
  leave();
  standing = null;
  root.className = "vad page window";
  find(".board")?.remove();
  for (const place of [".steps", ".set"]) find(place)?.replaceChildren();
  const empty = element("div", { class: "board empty" }), title = element("h1", {});
  title.textContent = entry().title;
  empty.append(element("header", {}));
  empty.firstChild.append(title);
  rail.before(empty);
  spare();
}
