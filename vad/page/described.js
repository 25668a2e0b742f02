// What a screen reader says of a finished polygon: its pole, and of each other letter how far it is
// from there, and in which direction.
//
// described(root, body, player). A picture has it as its label when it is whole and at rest.

function described(root, body, player) {
  const { data, state, out, view } = body, { words } = data, svgs = root.querySelectorAll(".drawing > svg");
  const polygons = data.polygons.filter(({ mechanism, bar }) => !mechanism && bar);

  function sentence({ half, input, bar }) {
    const [x, y, factor] = state.slice(input, input + 3), found = [];
    data.labels.forEach(([own, dot, , , [p, q], , , apart], n) => {
      const u = (out[p] - x) / factor, v = (out[q] - y) / factor;
      if (own === half && dot && !vanished(out, apart, out[p], out[q]) && u - u === 0 && v - v === 0) found.push([data.spelled[n], Math.hypot(u, v), Math.atan2(v, u)]);
    });
    const least = 1e-9 * Math.max(...found.map(([, size]) => size)), pole = found.filter(([, size]) => size <= least);
    return [filled(words.pole, { name: pole.map(([name]) => name).join(", ") }),
      ...found.filter(([, size]) => size > least).map(([name, size, angle]) => filled(words.vertex, { name,
        size: view.written(size * bar.factor, bar.unit), angle: view.written((angle * 180 / Math.PI + 360) % 360, "°") }))].join("; ");
  }

  function tell() {
    svgs.forEach((svg, panel) => {
      const own = polygons.filter(({ half }) => data.halves[half][0] === panel);
      if (!own.length || !player.whole(panel) || root.matches(".limited.turned")) return;
      svg.setAttribute("aria-label", `${data.panels[panel]}: ${own.map(sentence).join(". ")}`);
    });
  }

  const later = rested(tell, REST);
  player.on(root, "vad:step", later);
  body.on(later);
  later();
}
