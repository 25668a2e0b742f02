// The picture that a hand moves: one program finds its pose, and its elements follow.
//
// picture(root, solve, data) -> {state, out, paint, settle, write, glides, steady, hidden, counts, x, y,
// unit, written}. How many labels have no room is the page's attribute data-hidden, too.
// The function solve is that of vad/page/solver.py; data is that of vad/page/hand.py:
//   inputs, start   the names of all inputs, and their values in the lesson's pose
//   size            how many outputs there are; numbers below are places among them
//   own             the outputs that are the driver's place and rates themselves
//   moves           of each element: a letter, and the places of its coordinates
//   labels, blocks  what is to be placed, and the lines with half widths that it keeps clear of
//   nears           the distances of labels, and from which on they have leaders
//   halves          of each half of a panel: the number of its panel, its edges, and those where the
//                   panel is large
//   rooms, page     of each panel its edges; pixels to the page unit, and its left and upper edge
//   polygons        their scales: the first of three inputs, corners, room, and what a bar states
//   cells           row, column, place, output, factor, unit, whether given

// Degrees: a shorter arc is no arc.
const NO_SWEEP = 1e-6;
// Milliseconds within which poses come frame after frame. Then all letters follow in every second frame:
// they take a quarter of one, and nobody sees that a letter is late by a sixtieth of a second.
const ROW = 25;

function picture(root, solve, data) {
  const out = new Float64Array(data.size), state = [...data.start], counts = { attributes: 0, candidates: 0 };
  const [unit, left, top] = data.page;
  const x = (place) => (out[place] - left) * unit, y = (place) => (top - out[place]) * unit;
  const round = (value) => Math.round(value * 100) / 100;
  const svgs = [...root.querySelectorAll(".drawing > svg")];
  const marks = svgs.flatMap((svg) => [...svg.querySelectorAll("[data-m]")]);
  const names = labels(svgs.flatMap(lettering), data, out, counts), sizes = scales(root, data, out, state);
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const listeners = [];
  let frame = 0, fresh = true, given = [], last = 0, behind = false;

  // The labels of a drawing, in a layer of their own above it: a browser paints all letters of a layer
  // anew when a line in it moves, which took a third of all its painting.
  function lettering(svg) {
    const layer = svg.cloneNode(), hand = svg.querySelector(".hand"), over = document.createElement("div");
    const found = [...hand.querySelectorAll(".label")], own = hand.cloneNode();
    for (const name of ["role", "aria-label"]) layer.removeAttribute(name);
    Object.assign(over, { className: "over", ariaHidden: true });
    own.append(...found);
    layer.append(own);
    over.append(layer);
    svg.after(over);
    return found;
  }

  // The text of an attribute, or of two; none where a number does not exist.
  const kinds = {
    l: (parts) => parts.length > 1 ? line(parts, "") : points(parts[0]),
    a: (parts) => parts.length > 1 ? line(parts, "Z") : points(parts[0]),
    c: ([at]) => pair(x(at[0]), y(at[1])),
    b: ([[u, v, radius, start, sweep, ...squeezed]]) => bow(x(u), y(v), out[radius] * unit, out[start], out[sweep],
      ...squeezed.map((place) => out[place])),
    t: ([at, from]) => pair((out[at[0]] - from[0]) * unit, (from[1] - out[at[1]]) * unit),
  };
  // As a style, the place of a circle takes less of a frame than as two attributes.
  const set = {
    c: ({ style }, text) => text.split(" ").forEach((each, n) => (style[n ? "cy" : "cx"] = each)),
    t: ({ style }, text) => (style.translate = text),
  };
  const path = (element, text) => element.setAttribute(element.localName === "path" ? "d" : "points", text);
  // A text moves with its halo, in one group: texts that move by themselves are laid out anew.
  const all = data.moves.map(([kind, ...parts], i) => ({
    text: kinds[kind], set: set[kind] ?? path, parts, before: null,
    elements: kind !== "t" && marks[i].localName === "g" ? [...marks[i].children] : [marks[i]],
  }));
  const texts = all.filter(({ set: own }) => own === set.t), lines = all.filter(({ set: own }) => own !== set.t);

  function points(places) {
    let text = "";
    for (let i = 0; i < places.length; i += 2) {
      const u = x(places[i]), v = y(places[i + 1]);
      if (u - u !== 0 || v - v !== 0) return "";
      text += `${i ? " " : ""}${round(u)} ${round(v)}`;
    }
    return text;
  }

  const pair = (u, v) => u - u === 0 && v - v === 0 ? `${round(u)}px ${round(v)}px` : "";

  function line(parts, end) {
    let path = "";
    for (const places of parts) {
      for (let i = 0; i < places.length; i += 2) {
        const u = x(places[i]), v = y(places[i + 1]);
        if (u - u !== 0 || v - v !== 0) return "";
        path += `${i ? "L" : "M"}${round(u)} ${round(v)}`;
      }
      path += end;
    }
    return path;
  }

  // An arc of a circle, which is narrow across its axis (p, q) where it is seen from the side. Of a curve
  // on a sphere, most pieces in front and behind are of no length: they are not drawn.
  function bow(u, v, radius, start, sweep, p = 1, q = 0, narrow = 1) {
    if (Math.abs(sweep) < NO_SWEEP) return "";
    if ([u, v, radius, start, sweep, p, q, narrow].some((each) => each - each !== 0)) return "";
    const turns = Math.max(1, Math.ceil(Math.abs(sweep) / 90));
    const at = (k) => {
      const angle = (start + sweep * k / turns) * Math.PI / 180;
      const right = radius * Math.cos(angle), up = radius * Math.sin(angle);
      const along = right * p + up * q, across = narrow * (up * p - right * q);
      return `${round(u + along * p - across * q)} ${round(v - along * q - across * p)}`;
    };
    let path = `M${at(0)}`;
    const radii = `${round(radius)} ${round(radius * Math.abs(narrow))} ${round(-Math.atan2(q, p) * 180 / Math.PI)}`;
    for (let k = 1; k <= turns; k++) path += `A${radii} 0 ${+(sweep * narrow < 0)} ${at(k)}`;
    return path;
  }

  // Paints the pose of the state, or one with other rates; what does not exist in it is hidden.
  // Scales and labels that have changed glide on in the next frames. One of many poses in a row may
  // leave its labels to the next frame; settle() places them at once.
  function paint(at = state, inRow = false) {
    const still = fresh || calm.matches, now = performance.now();
    behind = inRow && !fresh && !behind && now - last < ROW;
    last = now;
    given = at.slice(0, 3);
    fresh = false;
    cancelAnimationFrame(frame);
    find();
    const moving = sizes.choose(still);
    if (moving) find();
    draw(lines);
    lettered(still, moving && !still && (() => {
      paint(given);
      for (const listener of listeners) listener();
    }));
  }

  // Sets the attributes of marks that have changed.
  function draw(moves) {
    for (const move of moves) {
      const text = move.text(move.parts);
      if (text === move.before) continue;
      for (const element of move.elements) {
        if (!text !== !move.before || move.before === null) element.style.visibility = text ? "" : "hidden";
        if (text) move.set(element, text);
        counts.attributes++;
      }
      move.before = text;
    }
  }

  // Draws bars and texts and places the labels. What is to follow comes in the next frame; without it
  // labels may glide on alone.
  function lettered(still, next) {
    if (!behind) {
      sizes.state();
      draw(texts);
    }
    const gliding = behind || names.place(still);
    if (root.dataset.hidden !== `${names.hidden}`) root.dataset.hidden = names.hidden;
    if (!next && !gliding) return;
    // A pose that a pointer has set is painted before the animations of its frame: this is for the next.
    const painted = performance.now(), glide = next || (() => { behind = false; find(); lettered(calm.matches); });
    const later = (time) => { if (time < painted) frame = requestAnimationFrame(later); else glide(); };
    frame = requestAnimationFrame(later);
  }

  function find() {
    solve(...given, ...state.slice(given.length), out, 2);
    data.own.forEach((place, i) => (out[place] = state[i]));
  }

  // What is measured.
  const tables = [...root.querySelectorAll(".results tbody tr")].map((row) => [...row.querySelectorAll("td")]);
  const cells = data.cells.flatMap(([row, column, at, place, factor, units, given]) => {
    const element = tables[row]?.[column]?.querySelectorAll(".cell")[at];
    if (!element) return [];
    const said = element.textContent.replaceAll("\u00a0", " ").replace(/ [↺↻]$/, "");
    return [{ element, place, factor, units, given, bare: !said.endsWith(units.replace("²", "2")) && !said.endsWith(units), text: document.createTextNode("") }];
  });

  // Numbers that grow beyond their column get smaller type, and keep it: only what is longer than all
  // before is measured.
  const APART = 8, SIGNS = { ".": 1, ",": 1, "\u202f": 0.6, "−": 2.8 }, longest = new Map();
  const fitting = tables.flat().filter((column) => column.firstElementChild?.children.length);
  function fit() {
    if (root.classList.contains("staged")) return; // there, columns are as wide as their numbers
    const measured = fitting.flatMap((column) => {
      const [box] = column.children, long = [...column.textContent].reduce((sum, sign) => sum + (SIGNS[sign] ?? 2), 0);
      if (long <= (longest.get(column) ?? 0) || !box.clientWidth) return [];
      longest.set(column, long);
      const wide = [...column.querySelectorAll(".cell")].reduce((sum, each) => sum + each.offsetWidth + APART, -APART);
      return [[column, (box.clientWidth - getComputedStyle(box).paddingRight.slice(0, -2)) / wide]];
    });
    for (const [{ style }, part] of measured)
      if (part < 1) style.setProperty("--fit", part * (style.getPropertyValue("--fit") || 1));
  }

  // A table that is wider or narrower than before is measured anew. It is told its height: see player.css.
  const table = root.querySelector(".results"), apart = root.querySelector(".rows");
  let across = 0;
  const sized = new ResizeObserver(() => {
    apart.style.setProperty("--high", `${apart.firstChild.getBoundingClientRect().height}px`);
    if (table.clientWidth === across) return;
    across = table.clientWidth;
    longest.clear();
    for (const { style } of fitting) style.removeProperty("--fit");
    fit();
  });
  if (table) for (const each of [table, apart.firstChild]) sized.observe(each);

  // What is nothing beside the largest of its unit, in the table or as a vector, is rounding noise.
  const NOTHING = 1e-12;
  function beside() {
    const most = {}, seen = (unit, size) => { if (size > (most[unit] ?? 0)) most[unit] = size; };
    for (const { place, factor, units } of cells) seen(units, Math.abs(out[place] * factor));
    for (const { bar, input } of data.polygons) if (bar) seen(bar.unit, bar.factor / state[input + 2]);
    seen("rad/s²", most["rad/s"] ** 2);
    return most;
  }

  // Writes the numbers of the pose that is painted. A lesson keeps its own.
  function write() {
    find(); // who has looked for another pose has left its numbers
    const most = beside();
    for (const { element, place, factor, units, given, bare, text } of root.classList.contains("turned") ? cells : []) {
      if (!text.isConnected) {
        [...element.childNodes].slice(1).forEach((each) => each.remove());
        element.append(text);
      }
      const found = out[place] * factor, exists = found - found === 0;
      const value = !given && Math.abs(found) < NOTHING * most[units] ? 0 : found;
      let says = written(value, units, given, data.point);
      if (bare && exists && units !== "°") says = says.slice(0, -units.length - 1);
      says = `= ${says.replaceAll(" ", "\u00a0")}`;
      if (text.data !== says) {
        text.data = says;
        counts.attributes++;
      }
    }
    fit();
    for (const { text, value } of names.all)
      if (value !== undefined) {
        const says = written(out[value], "°", false, data.point);
        if (text.firstChild.data !== says) text.firstChild.data = says;
      }
  }

  // The panel that is drawn large, and has another room and another scale there; -1 for none. A picture
  // without an input for its scale becomes larger as a whole, by a factor, with a shift.
  const edges = data.halves.map((half) => [half.slice(1, 5), half.slice(5)]);
  function arrange(panel, factor, ...shift) {
    data.halves.forEach((half, i) => {
      const large = half[0] === panel, scaled = data.polygons.some((polygon) => polygon.half === i);
      if (scaled) half.splice(1, 4, ...edges[i][+(large && edges[i][1].length > 0)]);
      else for (const layer of svgs[half[0]].parentNode.querySelectorAll(".hand, .grip")) {
        // A rule for [transform] would style the texts of each label that moves anew.
        layer.classList.toggle("grown", large);
        if (large) layer.setAttribute("transform", `matrix(${factor} 0 0 ${factor} ${shift.join(" ")})`);
        else layer.removeAttribute("transform");
      }
    });
    sizes.arrange(panel);
    given = [];
    find();
    fresh = true;
  }

  return {
    state, out, paint, write, x, y, unit, counts, names, arrange,
    written: (value, units) => written(value, units, false, data.point),
    settle: () => { if (behind) paint(given); },
    // A listener hears of each frame in which the picture glides on by itself.
    glides: (listener) => listeners.push(listener),
    // One scale for the poses at these places of the driver; null for scales as they are needed.
    steady(poses) {
      sizes.steady(poses, solve);
      given = [];
      find();
    },
    // All poses, by their places of the driver, of a mechanism whose dimensions have changed.
    whole: (poses) => sizes.whole(poses, solve),
    // How many labels have no room in this pose.
    get hidden() { return names.hidden; },
  };
}
