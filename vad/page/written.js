// Numbers as vad/written.py writes them: four digits, or those that were given; degrees with one
// decimal; thousands parted; powers of ten.

const RAISED = { "-": "⁻", ...Object.fromEntries([..."⁰¹²³⁴⁵⁶⁷⁸⁹"].map((sign, digit) => [digit, sign])) };

function written(value, unit, given, point) {
  if (value - value !== 0) return "–";
  const text = given ? typed(value) : unit === "°" ? (Number(value.toFixed(1)) % 360 + 0).toFixed(1) : rounded(value);
  const [mantissa, power] = text.replace("+", "").split("e"), [whole, decimals] = mantissa.replace("-", "−").split(".");
  const parted = whole.replace("−", "").length < 5 ? whole : whole.replace(/\B(?=(\d{3})+$)/g, "\u202f");
  const number = parted + (decimals ? point + decimals : "") + (power ? "×10" + [...power].map((sign) => RAISED[sign]).join("") : "");
  return number + (unit && unit !== "°" ? "\u00a0" : "") + unit;
}

function typed(value) {
  const rest = Number(value.toPrecision(6)), size = Math.abs(rest);
  return size && (size < 1e-4 || size >= 1e6) ? rest.toExponential() : String(rest);
}

function rounded(value) {
  if (!value) return "0";
  const text = value.toExponential(3), power = Number(text.split("e")[1]);
  return power >= -4 && power < 6 ? value.toFixed(Math.max(3 - power, 0)) : text;
}
