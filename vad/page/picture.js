// The picture that a hand moves: one program finds its pose, and its elements follow.
//
// picture(root, solve, data) -> {state, out, paint, x, y}. The function solve is that of
// vad/page/solver.py; data is that of vad/page/hand.py:
//   inputs, start   the names of all inputs, and their values in the lesson's pose
//   own             the outputs that are the driver's place and rates themselves
//   size            how many outputs there are; numbers below are places among them
//   moves           of each moving element: a letter and the places of its coordinates
//   labels, blocks  what is to be placed, and the lines with half widths that it keeps clear of
//   rooms, page     of each panel; pixels to the page unit, and its left and upper edge
//   cells           row, column, place, output, factor and unit of each value that changes

function picture(root, solve, data) {
  const out = new Float64Array(data.size), state = [...data.start];
  const [unit, left, top] = data.page;
  const x = (place) => (out[place] - left) * unit, y = (place) => (top - out[place]) * unit;
  const round = (value) => Math.round(value * 100) / 100;
  const svgs = [...root.querySelectorAll(".drawing svg")];
  const elements = svgs.flatMap((svg) => [...svg.querySelectorAll("[data-m]")]).map((each) =>
    each.localName === "g" ? [...each.children] : [each]);
  const texts = svgs.flatMap((svg) => [...svg.querySelectorAll(".label")]);
  const tables = [...root.querySelectorAll(".results tbody tr")].map((row) =>
    [...row.querySelectorAll("td")].map((cell) => [...cell.querySelectorAll(".cell")]));
  const place = labels(texts, data, out);

  const line = (places, close) => {
    let path = "";
    for (let i = 0; i < places.length; i += 2) path += `${i ? "L" : "M"}${round(x(places[i]))} ${round(y(places[i + 1]))}`;
    return close ? path + "Z" : path;
  };
  const kinds = {
    l: (parts) => ({ d: parts.map((part) => line(part, false)).join("") }),
    a: (parts) => ({ d: parts.map((part) => line(part, true)).join("") }),
    c: ([at]) => ({ cx: round(x(at[0])), cy: round(y(at[1])) }),
    b: ([[u, v, radius, start, sweep, ...squeezed]]) => ({ d: bow(x(u), y(v), out[radius] * unit, out[start], out[sweep],
      ...squeezed.map((place) => out[place])) }),
    t: ([at, from]) => ({ transform: `translate(${round((out[at[0]] - from[0]) * unit)} ${round((from[1] - out[at[1]]) * unit)})` }),
  };

  // An arc of a circle, which is narrow across its axis (p, q) where it is seen from the side.
  function bow(u, v, radius, start, sweep, p = 1, q = 0, narrow = 1) {
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

  // Paints the pose of the state; what does not exist in it is hidden.
  function paint(shown = state) {
    solve(...shown, out, 2);
    data.own.forEach((place, i) => (out[place] = state[i]));
    data.moves.forEach(([kind, ...parts], i) => {
      const attributes = kinds[kind](parts);
      for (const element of elements[i]) {
        const shows = !Object.values(attributes).some((each) => String(each).includes("NaN"));
        element.style.display = shows ? "" : "none";
        if (shows) for (const name in attributes) element.setAttribute(name, attributes[name]);
      }
    });
    place();
    write();
  }

  function write() {
    for (const [row, column, at, place, factor, units] of data.cells) {
      const cell = tables[row]?.[column]?.[at];
      if (!cell) continue;
      const [symbol, ...rest] = cell.childNodes;
      rest.forEach((each) => each.remove());
      cell.append(`= ${written(out[place] * factor, units)}`);
    }
  }

  function written(value, units) {
    if (value - value !== 0) return "–";
    if (units === "°") return `${(Math.round(value * 10) / 10 % 360).toFixed(1)}°`;
    const size = Math.abs(value);
    const text = !size ? "0" : size < 1e-4 || size >= 1e6 ? value.toExponential(3) : value.toFixed(Math.max(0, 3 - Math.floor(Math.log10(size))));
    return `${text.replace("-", "−")} ${units}`;
  }

  return { state, out, paint, x, y, unit, written };
}
