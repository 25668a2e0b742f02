// The address of a page in the hand: "#hand&angle=128.4&crank=64" opens it so; one that is turned
// writes what differs from the lesson's own.

function addressed(root, body, dock, page, player) {
  const { data, state } = body, names = Object.keys(page.state);

  function open() {
    if (!location.hash.startsWith("#hand")) return;
    const asked = {};
    for (const [name, value] of new URLSearchParams(location.hash.slice(1))) if (names.includes(name) && value.trim()) asked[name] = +value;
    page.pose(asked);
  }

  let timer = 0;
  function write() {
    clearTimeout(timer);
    if (dock.held) timer = setTimeout(() => {
      const now = page.state, own = data.dimensions.map((each) => each[5]);
      const differs = (name, i) => state[i < data.own.length ? i : own[i - data.own.length]] !== data.start[i < data.own.length ? i : own[i - data.own.length]];
      const told = names.map((name, i) => differs(name, i) || !i ? `&${name}=${+now[name].toPrecision(12)}` : "").join("");
      try { history.replaceState(null, "", `#hand${told}`); } catch { /* a frame without an address */ }
    }, 250);
    else if (location.hash.startsWith("#hand"))
      try { history.replaceState(null, "", `#step=${Math.ceil(player.x)}`); } catch { /* the same */ }
  }

  dock.on(write);
  player.on(window, "hashchange", open);
  open();
}
