// The window of vad gui: what is set goes to Python, what is answered is shown. It knows no
// mechanism. One question is asked at a time, and the newest wins. Its parts are one script, in the
// order of vad/gui/window.py; this is what they share.

const DIGITS = 7; // as many as a box has room for; what is set keeps them all
const root = document.querySelector(".vad"), find = (selector) => root.querySelector(selector);
const { start, catalogue, words } = JSON.parse(document.getElementById("data").textContent);
const handle = find(".handle"), message = find(".message"), mend = find(".message button");
const fields = new Map();
let set = {}, player = null, shown = null, names = [], scales = {}, ways = {}, stands = null, grip = null, ranges = [], broken = false;
let wanted = null, aside = {}, asking = false, timer = 0, step = null, retry = null;

const entry = () => catalogue[set.mechanism];
const settable = () => [...entry().parameters, ...entry().inputs];
const group = (name) => entry().inputs.some((each) => each.name === name) ? set.inputs : set.parameters;
const written = (value) => typeof value === "number" ? String(+value.toPrecision(DIGITS)) : value ?? "";
const filled = (text, values) => text.replace(/{(\w+)}/g, (_, key) => values[key]);
