// The bar: mechanism, files, the address, and the settings with which the window opens.

const placeKey = (point) => point ? `assembly.${point}` : "assembly";

// The address has all settings that differ from the defaults.  While the reader goes to another
// address, by the browser's buttons or a link, nothing is written until it has been read: what was
// written then would be a new entry of the history, and the entries after it would be lost.
let addressed = location.hash;
function remember() {
  if (location.protocol === "about:" || broken) return; // in a cell of a notebook there is none
  if (location.hash !== addressed) return;
  const kept = new URLSearchParams({ m: set.mechanism });
  for (const { name, default: value } of settable()) {
    const own = group(name)[name];
    if (own !== value) kept.set(name, own ?? "");
  }
  for (const [point, , [[usual]]] of entry().assemblies)
    if (set.places[point] !== usual) kept.set(placeKey(point), set.places[point]);
  if (set.length_unit !== entry().unit) kept.set("unit", set.length_unit);
  if (stands() && !standing.dock.held) kept.set("step", Math.ceil(standing.player.x));
  if (root.dataset.theme !== (dark && matchMedia("(prefers-color-scheme: dark)").matches ? dark : start.style)) kept.set("theme", root.dataset.theme);
  if (start.language !== "en") kept.set("lang", start.language);
  // Another mechanism is a new entry of the browser's history.
  const other = /^#m=([^&]*)/.exec(location.hash)?.[1], to = `${location.pathname}${location.search}#${kept}`;
  history[other && decodeURIComponent(other) !== set.mechanism ? "pushState" : "replaceState"](null, "", to);
  addressed = location.hash;
}

async function recall(hash = location.hash) {
  const kept = Object.fromEntries(new URLSearchParams(hash.slice(1)));
  if (!kept.m || !await listed(kept.m)) return false;
  const given = {};
  for (const { name } of [...catalogue[kept.m].parameters, ...catalogue[kept.m].inputs])
    if (kept[name]) given[name] = Number.isFinite(+kept[name]) ? +kept[name] : kept[name];
  const places = Object.fromEntries(catalogue[kept.m].assemblies.map(([point]) => [point, kept[placeKey(point)]]));
  if (root.dataset.themes.split(" ").includes(kept.theme)) root.dataset.theme = kept.theme;
  choose(kept.m, { ...given, places, unit: kept.unit, step: /^\d+$/.test(kept.step) ? +kept.step : null });
  return true;
}

// Makes sure that it is known what can be set of a mechanism; examples and files are asked for.
async function listed(name) {
  if (name in catalogue) return true;
  const answer = await asked("entry", { mechanism: name, language: start.language });
  if (answer.entry) offer(name, answer.entry);
  return name in catalogue;
}

// Keeps what can be set of a mechanism, which the list has from now on.
function offer(name, entry) {
  catalogue[name] = entry;
  let option = [...find("#mechanism").options].find((each) => each.value === name);
  if (!option) find("#mechanism optgroup").append(option = element("option", { value: name }));
  option.textContent = entry.title;
}

async function opened(file) {
  if (!file) return;
  const about = { mechanism: file.name, text: file.size > longest ? "" : await file.text(), language: start.language };
  if (Math.max(file.size, new Blob([JSON.stringify(about)]).size) > longest)
    return complain({ kind: "usage", message: gaps(words.large, { name: file.name, most: longest / 1024 }) });
  const answer = await asked("entry", about);
  if (answer.error) return complain(answer.error);
  offer(answer.mechanism, answer.entry);
  standing &&= { ...standing, mechanism: null };
  if (answer.given) {
    const { assembly, ...given } = answer.given;
    choose(answer.mechanism, { ...given, places: { "": assembly } });
    return want(true);
  }
  choose(answer.mechanism);
  want(true);
}

// The command that opens the window with what is set: a server that is started again has another
// address.
function command() {
  const quoted = (text) => /^[\w.,=+-]+$/.test(text) ? text : `'${text}'`, given = [];
  for (const { name, default: usual } of settable()) {
    const own = group(name)[name];
    if (own !== null && own !== usual) given.push(name, String(own));
  }
  for (const [name, [link, distance, angle]] of Object.entries(set.points)) given.push("point", `${name} on ${link} ${distance} at ${angle}`);
  const places = entry().assemblies.filter(([point, , [[usual]]]) => set.places[point] !== usual);
  if (places.length) given.push("assembly", places.map(([point]) => point ? `${point}=${set.places[point]}` : set.places[point]).join());
  if (set.length_unit !== entry().unit) given.push("length_unit", set.length_unit);
  if (start.language !== "en") given.push("language", start.language);
  const words = given.map((text, i) => i % 2 ? quoted(text) : `--${text.replaceAll("_", "-")}`);
  return ["vad gui", quoted(set.mechanism), ...words].join(" ");
}

const does = {
  command: () => {
    const line = command();
    (navigator.clipboard?.writeText(line) ?? Promise.reject()).then(() => tell(gaps(words.copied, { line })), () => tell(line));
  },
  draw: () => { clearTimeout(timer); retry = "play"; want(true); },
  reset: () => { choose(set.mechanism); standing &&= { ...standing, mechanism: null }; want(true); },
  link: () => { remember(); navigator.clipboard?.writeText(location.href).then(() => tell(words.linked), () => {}); },
  open: () => find("input[type=file]").click(),
};

async function save(extension) {
  const about = question("export");
  tell(words.saving);
  const answer = await post(`export/${extension}`, about).catch(() => null);
  if (!answer) return complain({ kind: "stopped", message: words.stopped });
  if (answer.headers.get("content-type").startsWith("application/json") && !answer.headers.get("content-disposition"))
    return complain((await answer.json()).error);
  const kinds = { turn: "-turn.html", problem: "-problem.pdf" }, name = `${catalogue[about.mechanism].name}${kinds[extension] ?? `.${extension}`}`;
  const address = URL.createObjectURL(await answer.blob());
  element("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
  tell(gaps(words.saved, { name }));
}

for (const place of [bar, message]) place.addEventListener("click", ({ target }) => {
  const button = target.closest("[data-what]"), file = target.closest("[data-save]");
  if (button) does[button.dataset.what]();
  if (file) {
    file.closest("details").open = false;
    save(file.dataset.save);
  }
});
// The list of formats closes as any list does: by Escape, and by what is done elsewhere.
const formats = find(".save");
formats.addEventListener("keydown", (event) => {
  if (event.key !== "Escape" || !formats.open) return;
  formats.open = false;
  formats.firstElementChild.focus();
  event.preventDefault();
});
formats.addEventListener("focusout", ({ relatedTarget }) => { if (relatedTarget && !formats.contains(relatedTarget)) formats.open = false; });
addEventListener("pointerdown", (event) => { if (!event.composedPath().includes(formats)) formats.open = false; }, true);
for (const each of root.querySelectorAll("form")) each.addEventListener("submit", (event) => event.preventDefault());
find("input[type=file]").addEventListener("change", ({ target }) => { opened(target.files[0]); target.value = ""; });
find("#mechanism").addEventListener("change", async ({ target }) => {
  const name = target.value;
  if (!await listed(name)) return complain({ kind: "stopped", message: words.stopped });
  choose(name);
  want(true);
});

find("#language").value = start.language;
find("#language").addEventListener("change", ({ target }) => {
  remember();
  location.assign(`/?lang=${target.value}${location.hash.replace(/&lang=\w+/, "")}&lang=${target.value}`);
});
let writing = 0;
root.addEventListener("vad:step", () => {
  clearTimeout(writing);
  writing = setTimeout(() => { if (stands() && !root.classList.contains("moving")) remember(); }, CALM);
});
new MutationObserver(() => { if (stands()) remember(); }).observe(root, { attributeFilter: ["data-theme"] });
// The address is that of the event, because by now another one may have been remembered.
addEventListener("hashchange", async ({ newURL }) => {
  clearTimeout(writing);
  clearTimeout(timer);
  addressed = new URL(newURL).hash;
  if (!await recall(addressed)) return;
  standing &&= { ...standing, mechanism: null };
  want(true);
});

// Who likes the dark is shown the board, unless the address says otherwise.
const dark = root.dataset.themes.split(" ").find((each) => each === "chalk");
if (dark && matchMedia("(prefers-color-scheme: dark)").matches) root.dataset.theme = dark;
const lang = /[#&]lang=(\w\w)/.exec(location.hash)?.[1];
if (lang && lang !== start.language) location.replace(`/?lang=${lang}${location.hash}`);
if (!await recall()) {
  const places = typeof start.assembly === "string" ? { "": start.assembly } : start.assembly;
  choose(start.mechanism, { ...start.parameters, ...start.inputs, places, unit: start.length_unit });
}
want(true);
