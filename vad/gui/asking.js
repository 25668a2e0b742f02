// Questions to Python, and what is done with its answers. One question is asked at a time; of several
// that wait only the newest is asked.

function question(kind) {
  const present = (values) => Object.fromEntries(Object.entries(values).filter(([, value]) => value !== null));
  const asked = { mechanism: set.mechanism, parameters: present(set.parameters), inputs: { ...present(set.inputs), ...aside },
    assembly: "" in set.places ? set.places[""] : set.places, points: set.points, burden: set.burden,
    length_unit: set.length_unit, panels: set.panels, language: start.language, style: start.style };
  if (kind === "lesson") return { ...asked, scales: stands() ? scalesNow() : {}, key: stands() ? standing.key : "", known: [...known] };
  const style = root.dataset.theme, speed = +(find(".speed")?.value ?? 1);
  return { ...asked, style: start.style === "print" ? "print" : style, size: start.size, fps: start.fps, speed };
}

function scalesNow() {
  const { data, state } = standing.body, found = {};
  data.inputs.forEach((name, i) => { if (name.endsWith(" x")) found[name.slice(0, -2)] = state.slice(i, i + 3); });
  return found;
}

const post = globalThis.ask ?? ((path, body) => fetch(`/api/${path}`, { method: "POST",
  headers: { "content-type": "application/json", "accept-language": start.language }, body: JSON.stringify(body) }));
const asked = (path, body) => post(path, body).then((answer) => answer.json(), () => ({ error: { kind: "stopped", message: words.stopped } }));

// Asks for the lesson of what is set: at once, or when nothing has changed for a while.
function want(now = false) {
  if (!root.classList.contains("moving")) root.classList.add("moving");
  clearTimeout(timer);
  timer = now ? 0 : setTimeout(() => want(true), CALM);
  wanted ||= now;
  if (wanted && !asking) pump();
}

async function pump() {
  asking = true;
  // Each round asks one question; it ends when nothing is wanted any more.
  while (wanted) {
    wanted = false;
    const about = question("lesson"), pose = stands() ? poseNow() : "";
    const answer = await asked("lesson", about);
    if (about.mechanism === set.mechanism) take(about, answer, pose);
  }
  asking = false;
  if (!timer) root.classList.remove("moving");
}

// Whether a text was typed after a question, which is asked next.
const typedSince = (about) => wanted && [...Object.entries(set.parameters), ...Object.entries(set.inputs)]
  .some(([name, value]) => typeof value === "string" && value !== { ...about.parameters, ...about.inputs }[name]);

function take(about, answer, pose) {
  if (typedSince(about)) return;
  if (answer.error) return refused(answer.error);
  const moved = stands() && poseNow() !== pose, goal = aside && { ...set.inputs }, play = retry === "play";
  if (answer.layers) {
    if (stands() && held) return want(); // who has a slider in hand keeps it
    const now = moved && standing.body.state.slice(0, standing.body.data.own.length);
    stand(answer);
    if (now || goal) hold(now || Object.values(goal));
  } else if (moved) return; // it is asked again
  else if (!copy(answer)) {
    standing.key = "";
    return want(true);
  }
  aside = null;
  if (play) drawn();
  complain(null);
  settled(answer.results, { ...about.parameters, ...about.inputs });
}

// Moves the hand to a place with its rates.
function hold(inputs) {
  const { body, dock } = standing;
  if (!inputs.every(Number.isFinite)) return;
  dock.enter();
  body.set([...inputs, ...body.state.slice(inputs.length)]);
}

// A lecture of the pose that stands.
function drawn() {
  const { player, dock } = standing;
  retry = null;
  dock.leave(true);
  player.seek(0);
  player.play();
}

// At a dead centre there is no lesson; where none stands, that of a pose near by is asked for first.
function refused(error) {
  const dead = error.kind === "dead-centre";
  retry = null;
  if (dead && stands()) {
    complain(null);
    return remember();
  }
  if (dead && error.try && !aside) {
    aside = error.try;
    return want(true);
  }
  if (!stands() && error.kind !== "stopped" && error.kind !== "busy") clear();
  complain({ ...error, field: blamed || error.field });
}

// A box in which a text with a unit was written shows its value in the unit of the box.
function settled({ parameters, input, assembly }, about) {
  for (const [name, value] of Object.entries({ ...parameters, ...input })) {
    const own = group(name), typed = typeof own[name] === "string";
    if (typed && own[name] !== about[name]) continue;
    if (typed) own[name] = value;
    if (typed || document.activeElement !== fields.get(name)?.box) if (fields.has(name) && own[name] !== null) show(name, own[name]);
  }
  find("#assemblies").disabled = assembly === null;
  remember();
}

function complain(error) {
  broken = Boolean(error);
  root.classList.toggle("stale", broken && error.kind !== "stopped" && error.kind !== "busy");
  root.classList.toggle("alone", error?.kind === "stopped");
  message.hidden = !broken;
  for (const box of root.querySelectorAll(".row input:not([type]), .size input:not([type]), .place input"))
    box.ariaInvalid = broken && (box.name || box.id.slice(6)) === error.field ? "true" : null;
  if (!broken) blamed = "";
  if (!broken) return tell("");
  const tries = error.try && Object.entries(error.try);
  tell(error.hint && !tries ? `${error.message} (${error.hint})` : error.message);
  message.classList.add("wrong");
  find("[data-what=command]").hidden = !["stopped", "refused"].includes(error.kind);
  mend.hidden = !tries && !["stopped", "refused", "busy"].includes(error.kind);
  const label = (name) => settable().find((each) => each.name === name)?.label ?? name;
  mend.textContent = tries ? gaps(words.try, { values: tries.map(([name, value]) => `${label(name)} ${shortened(value)}`).join(", ") }) : words.retry;
  mend.onclick = () => { for (const [name, value] of tries ?? []) put(name, value); want(true); };
}

function tell(text) {
  const place = message.querySelector("span");
  message.classList.remove("wrong");
  message.hidden = !text;
  for (const each of message.querySelectorAll("button")) each.hidden = true;
  if (place.textContent !== text) place.textContent = text;
}

// Whether a pointer holds something that another page would take away.
let held = false;
addEventListener("pointerdown", ({ target }) => { held = Boolean(target.closest?.(".set, .board")); }, true);
for (const name of ["pointerup", "pointercancel"]) addEventListener(name, () => { held = false; }, true);
