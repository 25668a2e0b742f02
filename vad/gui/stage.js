// What is shown: poses while something moves, lessons when it rests, and errors.

const GLIDE = 150;

function move({ panels, rows, looks, scales: fresh, ways: sides }) {
  rules(looks);
  const sections = find(".panels").children, lines = find(".results tbody")?.children ?? [];
  if (panels.length === names.length) root.classList.remove("bare");
  names.forEach((name, i) => sections[i].classList.toggle("stale", !panels.some(([each]) => each === name)));
  for (const [name, scale, drawing] of panels) {
    const section = sections[names.indexOf(name)];
    if (!section) continue;
    update(section.querySelector(".top"), 1, scale);
    update(section, 1, drawing);
    glide(name, scales[name], fresh[name]);
  }
  if (lines.length === rows.length)
    rows.forEach((cells, i) => cells.forEach((html, j) => update(lines[i], 1 + names.indexOf(panels[j][0]), html)));
  [scales, ways] = [{ ...scales, ...fresh }, { ...ways, ...sides }];
}

const htmlOf = new WeakMap();

// Changes a child element to what the HTML says. From pose to pose only the differences are
// changed, because a browser lays out and paints whatever is touched. An element of a lesson
// belongs to the player, and is replaced.
function update(place, index, html) {
  const old = place.children[index], made = document.createElement(place.localName);
  if (old && htmlOf.get(old) === html) return;
  made.innerHTML = html;
  const fresh = made.firstElementChild;
  if (!fresh) return old?.remove();
  if (htmlOf.has(old)) match(old, fresh);
  else if (old) old.replaceWith(fresh);
  else place.append(fresh);
  htmlOf.set(place.children[index], html);
}

function match(old, fresh) {
  if (old.isEqualNode(fresh)) return;
  if (old.nodeName !== fresh.nodeName) return old.replaceWith(fresh);
  if (old.nodeType !== Node.ELEMENT_NODE) return old.data = fresh.data;
  for (const name of fresh.getAttributeNames()) {
    const value = fresh.getAttribute(name);
    if (old.getAttribute(name) !== value) old.setAttribute(name, value);
  }
  for (const name of old.getAttributeNames()) if (!fresh.hasAttribute(name)) old.removeAttribute(name);
  const before = [...old.childNodes], after = [...fresh.childNodes];
  after.forEach((node, i) => before[i] ? match(before[i], node) : old.append(node));
  before.slice(after.length).forEach((node) => node.remove());
}

// Removes all that belongs to another mechanism.
function clear() {
  const title = element("h1", {});
  title.textContent = entry().title;
  find("header").replaceChildren(title);
  for (const place of [".panels", ".results", ".chapters", ".lists"]) find(place).replaceChildren();
  find(".control").hidden = true;
  [names, grip, shown] = [[], null, set.mechanism];
}

function play({ head, panels, table, chapters, steps, data, looks, scales: fresh }) {
  const playing = retry === "play";
  rules(looks);
  root.classList.remove("bare");
  const before = scales;
  [names, shown] = [data.panels.map(([name]) => name), set.mechanism];
  find("header").innerHTML = head;
  find(".panels").innerHTML = panels;
  find(".results").innerHTML = table;
  find(".chapters").innerHTML = chapters;
  find(".lists").innerHTML = steps;
  const at = playing ? 0 : step ?? data.times.length;
  find(".control").hidden = false;
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
  const { sheet } = document.getElementById("looks");
  fresh.forEach((rule) => sheet.insertRule(rule, sheet.cssRules.length));
}

const classes = () => [...known].map((rule) => rule.slice(1, rule.indexOf("{")));

// A polygon whose scale has changed grows or shrinks from the size that it had.
function glide(name, old, fresh) {
  if (!old || !fresh || String(old) === String(fresh) || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  if (scales[`${name}.below`]) return; // two polygons, each at its scale
  const unit = 720, most = 3, place = ([x, y]) => [x * unit, (1 - y) * unit], factor = old[2] / fresh[2];
  if (factor > most || factor < 1 / most) return; // it would flash across the page
  const svg = find(".panels").children[names.indexOf(name)]?.querySelector("svg");
  if (!svg) return;
  const [from, to] = [place(old), place(fresh)], { x, y, width, height } = svg.viewBox.baseVal;
  const part = (corner, i, size) => `${100 * (from[i] - factor * to[i] + (factor - 1) * corner) / size}%`;
  const transform = [`translate(${part(x, 0, width)}, ${part(y, 1, height)}) scale(${factor})`, "none"];
  // The whole drawing moves without being painted again; the handle follows at the end.
  svg.animate({ transform }, { duration: GLIDE, easing: "ease-out" }).onfinish = placeHandle;
}

function complain(error) {
  broken = Boolean(error);
  const dead = error?.kind === "dead-centre";
  root.classList.toggle("stale", broken && !dead);
  root.classList.toggle("dead", dead);
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
