// The address of the page holds all settings that differ from the defaults.

const placeKey = (point) => point ? `assembly.${point}` : "assembly";

function remember() {
  if (location.protocol === "about:") return; // in a cell of a notebook
  const kept = new URLSearchParams({ m: set.mechanism });
  for (const { name, default: value } of settable()) {
    const own = group(name)[name];
    if (own !== value) kept.set(name, own ?? "");
  }
  for (const [point, , [[usual]]] of entry().assemblies)
    if (set.places[point] !== usual) kept.set(placeKey(point), set.places[point]);
  if (set.length_unit !== entry().unit) kept.set("unit", set.length_unit);
  const x = Math.ceil(player?.x ?? 0), all = +find(".scrub").max;
  if (player && x !== all) kept.set("step", x);
  if (start.language !== "en") kept.set("lang", start.language);
  history.replaceState(null, "", `${location.pathname}${location.search}#${kept}`);
}

function recall(hash = location.hash) {
  const kept = Object.fromEntries(new URLSearchParams(hash.slice(1)));
  if (!(kept.m in catalogue)) return false;
  const given = {};
  for (const { name } of [...catalogue[kept.m].parameters, ...catalogue[kept.m].inputs])
    if (kept[name]) given[name] = Number.isFinite(+kept[name]) ? +kept[name] : kept[name];
  const places = Object.fromEntries(catalogue[kept.m].assemblies.map(([point]) => [point, kept[placeKey(point)]]));
  choose(kept.m, { ...given, places, unit: kept.unit, step: /^\d+$/.test(kept.step) ? +kept.step : null });
  return true;
}

find("#language").value = start.language;
find("#language").addEventListener("change", ({ target }) => {
  remember();
  location.assign(`/?lang=${target.value}${location.hash.replace(/&lang=\w+/, "")}&lang=${target.value}`);
});
let writing = 0;
root.addEventListener("vad:step", () => {
  clearTimeout(writing);
  writing = setTimeout(() => { if (!root.classList.contains("moving") && !broken) remember(); }, 250);
});
// The address is that of the event, because by now another one may have been remembered.
addEventListener("hashchange", ({ newURL }) => {
  clearTimeout(writing);
  clearTimeout(timer);
  if (recall(new URL(newURL).hash)) want("lesson");
});

const lang = /[#&]lang=(\w\w)/.exec(location.hash)?.[1];
if (lang && lang !== start.language) location.replace(`/?lang=${lang}${location.hash}`);
// The buttons and files, and the settings with which the page opens.

const does = {
  draw: () => { clearTimeout(timer); [retry, step] = ["play", null]; want("lesson"); },
  reset: () => { choose(set.mechanism); changed(); },
  link: () => { remember(); navigator.clipboard?.writeText(location.href).then(() => tell(words.linked), () => {}); },
};

function tell(text) {
  find(".message span").textContent = text;
}

async function save(extension) {
  const asked = question("export");
  tell(words.saving);
  const answer = await post(`export/${extension}`, asked).catch(() => null);
  if (!answer) return complain({ kind: "stopped", message: words.stopped });
  if (answer.headers.get("content-type").startsWith("application/json") && !answer.headers.get("content-disposition"))
    return complain((await answer.json()).error);
  const name = `${catalogue[asked.mechanism].name}.${extension}`, address = URL.createObjectURL(await answer.blob());
  element("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
  tell(filled(words.saved, { name }));
}

root.addEventListener("click", ({ target }) => {
  const button = target.closest("[data-what]"), file = target.closest("[data-save]");
  if (button) does[button.dataset.what]();
  if (file) save(file.dataset.save);
});
find(".settings").addEventListener("submit", (event) => event.preventDefault());
find("#mechanism").addEventListener("change", (event) => { choose(event.target.value); want("lesson"); });

if (!recall()) {
  const places = typeof start.assembly === "string" ? { "": start.assembly } : start.assembly;
  choose(start.mechanism, { ...start.parameters, ...start.inputs, places, unit: start.length_unit });
}
want("lesson");
