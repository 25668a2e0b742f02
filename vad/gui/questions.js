// Questions to Python, and what becomes of its answers.

function question(kind) {
  const present = (values) => Object.fromEntries(Object.entries(values).filter(([, value]) => value !== null));
  const asked = { mechanism: set.mechanism, parameters: present(set.parameters), inputs: present(set.inputs),
    assembly: "" in set.places ? set.places[""] : set.places, points: set.mechanism === start.mechanism ? start.points : {},
    length_unit: set.length_unit, panels: start.panels, language: start.language, style: start.style };
  if (kind === "pose") return { ...asked, scales, ways, known: classes(), ...(stands && { stands }) };
  if (kind === "beside") return { ...asked, inputs: { ...asked.inputs, ...aside } };
  if (kind === "lesson") return { ...asked, scales: find("#lock").checked ? scales : {} };
  const style = root.dataset.theme, speed = +find(".speed").value;
  return { ...asked, style: start.style === "print" ? "print" : style, size: start.size, fps: start.fps, speed };
}

const post = globalThis.ask ?? ((path, body) => fetch(`/api/${path}`, { method: "POST", headers: { "content-type": "application/json" },
  body: JSON.stringify(body) }));

function want(kind) {
  wanted = kind;
  if (!asking) pump();
}

function send() {
  const kind = wanted, asked = question(kind);
  wanted = null;
  asking = true;
  return post(kind === "beside" ? "lesson" : kind, asked).then((answer) => answer.json(), () => ({ error: { kind: "stopped", message: words.stopped } }))
    .then((answer) => [kind, asked, answer]);
}

async function pump() {
  let pending = send();
  while (pending) {
    const [kind, asked, answer] = await pending;
    asking = false;
    pending = wanted ? send() : null; // the next question goes out before this answer is painted
    if (asked.mechanism === set.mechanism) take(kind, asked, answer);
  }
}

function take(kind, asked, answer) {
  if (kind === "beside") return backdrop(answer);
  if (answer.ranges) [ranges, grip] = [answer.ranges, answer.handle];
  if (answer.error && shown !== set.mechanism) clear();
  if (answer.panels) (kind === "pose" ? move : play)(answer);
  complain(answer.error);
  if (kind === "lesson") {
    root.classList.remove("moving");
    stands = answer.error ? stands : asked.parameters;
    if (!answer.error) remember();
    else if (answer.error.kind === "dead-centre") stay(answer.error);
  }
  if (answer.results) settle(answer.results, { ...asked.parameters, ...asked.inputs });
  hold();
}

// At a dead centre there is the position; where nothing is shown yet, in the panels of a pose beside it.
function stay(error) {
  if (names.length) return want("pose");
  if (!error.try) return;
  aside = error.try;
  want("beside");
}

function backdrop(answer) {
  if (!answer.panels) return;
  play(answer);
  root.classList.add("bare");
  want("pose");
}

// Boxes in which a text with a unit was written show what it came to.
function settle({ parameters, input, assembly }, asked) {
  for (const [name, value] of Object.entries({ ...parameters, ...input })) {
    const { box } = fields.get(name), own = group(name);
    if (typeof own[name] !== "string" || own[name] !== asked[name]) continue;
    own[name] = value;
    if (box.value.trim() === asked[name]) show(name, value);
  }
  find("#assemblies").disabled = assembly === null;
}
