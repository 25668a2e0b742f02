// A found ω or α goes to its link, as in films (vad/plan/pictures/sent.py): its number leaves the caption
// and flies to the arrow of its sense, which then is there; or to its row, where the link has no room for
// an arrow.
//
// sending(root) -> {send, stop}. send(number, goals, wait, seconds) lets it leave after some seconds.

// When it leaves, when it arrives, and when it fades: shares of the whole. How high it flies, of its way.
const LEAVES = .06, ARRIVES = .55, FADES = [.7, .9], RISES = .1;

function sending(root) {
  let flying = [], copy = null;

  function stop() {
    flying.forEach((each) => each.cancel());
    copy?.remove();
    [flying, copy] = [[], null];
  }

  function send(number, goals, wait, seconds) {
    stop();
    const from = number.getBoundingClientRect(), own = getComputedStyle(number), text = goals[0].querySelector("text") ?? goals[0];
    const to = text.getBoundingClientRect(), size = Math.min(1, to.height / from.height);
    if (!from.width || !to.width) return;
    copy = root.appendChild(number.cloneNode(true));
    copy.className = "sent";
    copy.ariaHidden = true;
    copy.style.cssText = `left:${from.left}px;top:${from.top}px;font:${own.fontSize}/${from.height}px ${own.fontFamily};color:${getComputedStyle(text).fill}`;
    // The middle of the number flies to that of the name.
    const x = to.left + to.width / 2 - from.left - size * from.width / 2, y = to.top + to.height / 2 - from.top - size * from.height / 2;
    const high = RISES * Math.hypot(x, y), way = [...Array(11).keys()].map((n) => {
      const part = smooth(n / 10);
      return { offset: LEAVES + (ARRIVES - LEAVES) * n / 10, transform: `translate(${part * x}px,${part * y - 4 * part * (1 - part) * high}px) scale(${1 + (size - 1) * part})` };
    });
    const last = way.at(-1).transform, timing = { duration: 1000 * seconds, delay: 1000 * wait, fill: "both" };
    flying = [
      copy.animate([{ opacity: 0 }, { opacity: 1, offset: LEAVES }, { opacity: 1, offset: FADES[0] }, { opacity: 0, offset: FADES[1] }, { opacity: 0 }], timing),
      copy.animate([{ transform: "none" }, ...way, { transform: last }], timing),
      ...goals.map((goal) => goal.animate([{ opacity: 0 }, { opacity: 0, offset: ARRIVES }, { opacity: 1, offset: FADES[1] }, { opacity: 1 }], timing)),
    ];
    flying[0].onfinish = stop;
  }

  return { send, stop };
}
