// The stage of a lesson: on a wide page the panel in work is large, beside thumbnails, and drawn anew
// for its room (vad/page/large.py). A change of panels is a move.
//
// staging(root, calm) -> {load, to, settle, panel, large, dispose}. load(lesson) before all else;
// to(panel, atOnce, seconds) brings a panel into work, -1 the whole sheet; settle() lets what the hand
// moved glide to its place. The root then hears
// "vad:stage": large is the panel that is drawn large, or -1 where none is.

// A thumbnail's lines are at most so many times as large as on the sheet.
const MOST_SMALL = .8, CROWD = 10;
// How a picture glides; milliseconds until one that was let go stands; what is no move, in pixels.
const SOFT = "cubic-bezier(.333,0,.667,1)", SETTLES = 250, SAME = .01;

function staging(root, calm) {
  const all = (selector) => [...root.querySelectorAll(selector)], roomy = matchMedia("screen and (min-width: 48rem) and (min-height: 27.5rem)");
  let lesson, panels = [], views = [], panel = -1, large = -1, printed = false;

  // A picture, and what lies upon it.
  const layers = (picture) => [picture, ...picture.parentNode.querySelectorAll(".over > svg")];

  // Where a place of a panel on the sheet stands in the window: a factor, and a shift right and down.
  function seen(picture, i) {
    const { a, e, f } = picture.getScreenCTM() ?? {}, [, factor, x, y] = i === large ? lesson.large[i] : [0, 1, 0, 0];
    return [a * factor, a * x + e, a * y + f];
  }

  function load(next) {
    lesson = next;
    panels = lesson.pictures.map((picture) => picture.closest(".panel"));
    all(".scene").forEach((each) => each.remove());
    views = lesson.pictures.map((picture) => picture.getAttribute("viewBox"));
    lesson.pictures.forEach((picture, i) => {
      // Where there are many letters, they are small in a thumbnail.
      panels[i].style.setProperty("--t", picture.querySelectorAll(":scope > [data-s] > text").length > CROWD ? .52 : .68);
      if (lesson.large?.[i]) picture.insertAdjacentHTML("afterbegin", `<g class="scene">${lesson.large[i][4]}</g>`);
    });
    large = -1;
    fitted.disconnect();
    for (const picture of lesson.pictures) fitted.observe(picture.parentNode);
  }

  // Each panel shows a part of its picture: the large one all of its room, a thumbnail what is drawn on the
  // sheet, unless a hand may move that; but while it is dragged nothing shifts. Letters of thumbnails, and
  // the scale bar of the large one or of one that stands alone, follow.
  function fit() {
    const u = parseFloat(root.style.getPropertyValue("--wide")) / 1280, held = root.matches(".turned:not(.gripped)");
    lesson.pictures.forEach((picture, i) => {
      const [view, factor, , , , ink] = lesson.large?.[i] ?? [], { clientWidth: width, clientHeight: height } = picture.parentNode;
      const top = panels[i].querySelector(".top"), small = view && large >= 0 && i !== large;
      const [x, y, wide, high] = (i === large ? view : small && !held ? ink : views[i]).split(" ").map(Number);
      const size = Math.min(width / wide, height / high, small ? MOST_SMALL * u : Infinity);
      const across = small ? width / size : wide, up = small ? height / size : high;
      const shown = large < 0 || !(size > 0) ? views[i] : [x + (wide - across) / 2, y + (high - up) / 2, across, up].map((each) => each.toFixed(2)).join(" ");
      for (const each of layers(picture))
        if (each.getAttribute("viewBox") !== shown) each.setAttribute("viewBox", shown); // else all is laid out anew
      const seen = i === large ? size : panels[i].matches(".large .big") && picture.getScreenCTM().a;
      for (const [owner, name, value] of [[panels[i].style, "--k", small && size / u], [top.style, "--s", seen && `${seen}px`], [top.style, "--q", i === large && factor]])
        if (value) owner.setProperty(name, value);
        else owner.removeProperty(name);
      if (!top.style.length) top.removeAttribute("style");
    });
  }
  const fitted = new ResizeObserver(fit);

  function draw() {
    const next = roomy.matches && !printed && !root.classList.contains("large") && lesson.large?.length ? panel : -1, other = next !== large;
    large = next;
    panels.forEach((each, i) => each.classList.toggle("grand", i === large));
    fit();
    if (other) root.dispatchEvent(new CustomEvent("vad:stage"));
  }

  // Copies of all pictures where they are, which fade: who wants no motion sees one picture become another.
  // They are no drawings: no other script may take them for such.
  function fading(pictures, timing) {
    const home = document.createElement("div");
    all(".ghost").forEach((each) => each.parentNode.remove());
    home.ariaHidden = true;
    for (const picture of pictures) {
      const { left, top, width, height } = picture.getBoundingClientRect(), frame = document.createElement("div"), copy = picture.cloneNode(true);
      if (!width) continue;
      frame.className = `ghost ${["grand", "small"].filter((each) => picture.closest(`.${each}`)).join(" ")}`;
      copy.querySelectorAll(".hand, .grip").forEach((each) => each.remove());
      copy.style.cssText = `position: fixed; left: ${left}px; top: ${top}px; width: ${width}px; height: ${height}px; margin: 0`;
      frame.append(copy);
      home.append(frame);
    }
    root.append(home);
    home.animate([{}, { opacity: 0 }], timing).onfinish = () => home.remove();
  }

  // Headings and table, which would cross one another, fade in.
  function to(next, atOnce, seconds) {
    if (!lesson.move.length) next = -1;
    if (next === panel && !atOnce) return;
    const { pictures } = lesson, others = [...all(".top, .foot"), ...all(".results")], from = pictures.map(seen);
    [...pictures.flatMap(layers), ...others].forEach((each) => each.getAnimations().forEach((old) => old.cancel()));
    const timing = { duration: calm.matches ? 200 : 1000 * seconds, easing: SOFT };
    if (calm.matches && !atOnce) fading(pictures, timing);
    panel = next;
    root.classList.toggle("staged", panel >= 0);
    const small = (each, i) => each.classList.toggle("small", i !== panel);
    panels.forEach(small);
    all(".results tr").forEach((row) => [...row.children].slice(1).forEach(small));
    draw();
    if (atOnce) return;
    for (const each of calm.matches ? [...pictures, ...others] : others) each.animate([{ opacity: 0 }, {}], timing);
    if (!calm.matches) glide(from, timing);
  }

  // Each picture goes from where it was to where it is, and under the hand what lies upon it.
  function glide(from, timing) {
    lesson.pictures.forEach((picture, i) => {
      const { left, top, width } = picture.getBoundingClientRect(), [size, x, y] = from[i], [whole, u, v] = seen(picture, i), part = size / whole;
      // A place of the sheet, and so all others, is where it was.
      const shift = [x - left - part * (u - left), y - top - part * (v - top)];
      if (width && part) for (const each of root.matches(".turned") ? layers(picture) : [picture])
        each.animate([{ transformOrigin: "0 0", transform: `translate(${shift.map((each) => `${each}px`)}) scale(${part})` }, { transformOrigin: "0 0" }], timing);
    });
  }

  // What a hand has let go of may have another place, and glides there.
  function settle() {
    const from = lesson.pictures.map(seen);
    draw();
    const moved = lesson.pictures.some((picture, i) => seen(picture, i).some((each, k) => Math.abs(each - from[i][k]) > SAME));
    if (moved && !calm.matches) glide(from, { duration: SETTLES, easing: SOFT });
  }

  const over = new AbortController();
  roomy.addEventListener("change", draw, { signal: over.signal });
  for (const name of ["beforeprint", "afterprint"]) addEventListener(name, () => { printed = name === "beforeprint"; draw(); }, { signal: over.signal });
  return {
    load, to, draw, settle,
    // Whether a mark is in the picture that its panel shows, on the sheet or large.
    shows: (mark) => Boolean(mark.closest(".scene")) === (mark.ownerSVGElement === lesson.pictures[large]),
    dispose: () => { fitted.disconnect(); over.abort(); },
    get panel() { return panel; },
    get large() { return large; },
  };
}
