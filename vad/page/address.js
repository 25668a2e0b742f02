// The address of a page in the hand: "#hand&angle=128.4&crank=64&theme=chalk" opens it so; one that is
// turned writes what differs from the lesson's own.

function addressed(root, body, dock, page, player) {
  // A pose as entries of an address: of an assembly by points one for each of these.
  const entries = ({ assembly, ...numbers }) => [
    ...Object.entries(numbers).map(([name, value]) => [name, `${+value.toPrecision(12)}`]),
    ...(typeof assembly === "string" ? [["assembly", assembly]]
      : Object.entries(assembly ?? {}).map(([point, word]) => [`assembly.${point}`, word])),
  ];
  const own = new Map(entries(page.state)), [driver] = own.keys(), usual = root.dataset.theme;

  function open() {
    if (!location.hash.startsWith("#hand")) return;
    const asked = {}, given = new URLSearchParams(location.hash.slice(1)), theme = given.get("theme");
    if (root.dataset.themes.split(" ").includes(theme)) root.dataset.theme = theme;
    for (const [name, value] of given) {
      const [, point] = name.split("assembly.");
      if (!own.has(name) || !value.trim()) continue;
      if (point) asked.assembly = { ...asked.assembly, [point]: value };
      else asked[name] = name === "assembly" ? value : +value;
    }
    page.pose(asked);
  }

  const later = rested(() => {
    if (!dock.held) return;
    const told = entries(page.state).filter(([name, value]) => name === driver || value !== own.get(name));
    if (root.dataset.theme !== usual) told.push(["theme", root.dataset.theme]);
    const pairs = told.map(([name, value]) => `&${name}=${encodeURIComponent(value)}`).join("");
    try { history.replaceState(null, "", `#hand${pairs}`); } catch { /* a frame without an address */ }
  }, 250);
  function write() {
    if (dock.held) later();
    else if (location.hash.startsWith("#hand"))
      try { history.replaceState(null, "", `#step=${Math.ceil(player.x)}`); } catch { /* the same */ }
  }

  dock.on(write);
  new MutationObserver(write).observe(root, { attributeFilter: ["data-theme"] });
  player.on(window, "hashchange", open);
  open();
}
