// The window of vad gui: the page of a lesson under a bar. What a hand moves is moved by the page's
// own player; Python is asked for a lesson when the hand rests, and when there is a mechanism that
// the player does not have. The files are joined to one script, in the order of vad/gui/window.py;
// this part is shared by all.

const DIGITS = 7; // as many as a box has room for; what is set keeps them all
const CALM = 260; // milliseconds after the last change, until a lesson is asked for
const root = document.querySelector(".vad"), find = (selector) => root.querySelector(selector);
const { start, catalogue, usual, words, longest } = JSON.parse(document.getElementById("data").textContent);
const bar = find(".tools"), message = find(".message"), mend = find(".message button"), rail = find(".rail");
const fields = new Map();
// What is set; what stands on the page: key and strokes of its program, player, body and dock.
let set = {}, standing = null;
// What is asked for, and how the answer is to be shown.
let wanted = false, asking = false, timer = 0, step = null, retry = null, broken = false, aside = null;
// The number that was set last, for which Python was asked.
let blamed = "";

const entry = () => catalogue[set.mechanism];
const settable = () => [...entry().parameters, ...entry().inputs];
const group = (name) => entry().inputs.some((each) => each.name === name) ? set.inputs : set.parameters;
const shortened = (value) => typeof value === "number" ? String(+value.toPrecision(DIGITS)).replace(".", words.point) : value ?? "";
const gaps = (text, values) => text.replace(/{(\w+)}/g, (_, key) => values[key]);
// A number as the page's language writes it; null for any other text.
function plain(text) {
  const value = text.trim().replace(/[−–]/g, "-").replace(words.point, ".");
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(value) && Math.abs(+value) <= 1e200 ? +value : null;
}
