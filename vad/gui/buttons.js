// Buttons and files; and what opens.

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
