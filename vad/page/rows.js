// The rows of the table under the hand: a press on a name hides its vectors and curves, or with Shift
// those of all others.
//
// hidden(root, body, dock). Marks wear the classes of their looks, and the style sheets tell which of
// these are in the ink of a row.

function hidden(root, body, dock) {
  const rules = root.appendChild(document.createElement("style")), away = new Set();
  const rows = [...root.querySelectorAll(".results tbody th")].map((head, row) => {
    const button = document.createElement("button");
    button.className = "hides";
    button.append(...head.childNodes);
    button.title = filled(body.data.words["hide-row"], { name: button.textContent.trim() });
    button.addEventListener("click", ({ shiftKey }) => {
      const others = rows.map((_, other) => other).filter((other) => other !== row);
      const alone = others.every((other) => away.has(other)) && !away.has(row);
      if (shiftKey) {
        away.clear();
        for (const other of alone ? [] : others) away.add(other);
      } else if (!away.delete(row)) away.add(row);
      show();
    });
    head.append(button);
    return button;
  });

  // The classes whose rules name the ink of a row that is away.
  function classes() {
    const all = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]);
    const inked = all.filter(({ cssText }) => away.has(Number(cssText.match(/--(?:ink|tint|letter)(\d+)\)/)?.[1])));
    return inked.map(({ selectorText }) => selectorText).filter((name) => /^\.\w+$/.test(name));
  }

  function show() {
    rows.forEach((button, row) => button.setAttribute("aria-pressed", !away.has(row)));
    const marks = classes().map((name) => `.turned .drawing ${name}`);
    const lines = [...away].map((row) => `.turned [style$="--ink${row})"]`);
    rules.textContent = away.size ? `${[...marks, ...lines]}{opacity:.1}` : "";
  }

  const able = () => { for (const button of rows) button.disabled = !dock.held; };
  show();
  dock.on(able);
  able();
}
