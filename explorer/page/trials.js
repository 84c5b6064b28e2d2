// Sliders of what the run tries: gain, force and friction of the plant, and uncertain symbols. The design stays as it is.

import { $, element, short } from "dom";
import { gains } from "figures";

/** Steps of a slider to each side. */
const STEPS = 100;

/** Sliders that every plant may have; `most` is in units of u where it is null. */
const GENERAL = [
  { key: "gain", name: "Input gain", rest: 1, before: "\u00d7" },
  { key: "force", name: "Force", rest: 0 },
  { key: "friction", name: "Friction", rest: 0 },
];

let chosen = {};
let symbols = {};
let shown = "";
let onchange = () => {};

export function start(change) {
  onchange = change;
}

/** What a request holds of it: what differs from the design. */
export function request() {
  return { ...chosen, symbols: { ...symbols } };
}

/** Takes what an address holds. */
export function put(held) {
  ({ symbols = {}, ...chosen } = held);
  shown = "";
}

/** Forgets everything: another design has another plant. */
export function clear() {
  put({});
}

/** Shows the sliders that the answer offers. */
export function show({ runs, figures, design }) {
  const offered = runs?.offered;
  if (!offered) return;
  const scale = scaleOf(runs);
  const rows = GENERAL.filter(({ key }) => offered[key]).map((knob) => ({ ...knob, ...range(knob.key, scale) }));
  const own = offered.symbols.map(({ name, low, high, middle }) => ({ key: name, name, symbol: true, rest: middle, low, high }));
  const all = [...rows, ...own];
  const wanted = JSON.stringify([design?.name, all.map(({ key, low, high }) => (chosen[key] || symbols[key] ? key : [key, low, high]))]);
  if (wanted !== shown && !$("trials").contains(document.activeElement)) {
    shown = wanted;
    $("trials").replaceChildren(...(all.length ? all.map(row) : [element("p", { class: "hint" }, "This plant has no forces, friction or uncertain symbols to try.")]));
  }
  const margins = figures?.margins;
  const note = $("note-gain");
  if (note) note.textContent = margins ? `stable: ${gains(margins)}` : "";
}

/** The size of u by which forces are measured. */
function scaleOf({ series }) {
  const run = series?.find((one) => one.peak);
  const most = run?.u_max?.[0];
  const size = Number.isFinite(most) && most !== null ? most : Math.max(...(run?.peak ?? [1]), 1e-9);
  return Number((size || 1).toPrecision(1));
}

function range(key, scale) {
  if (key === "gain") return { low: 0.25, high: 4, logarithmic: true };
  if (key === "force") return { low: -scale / 2, high: scale / 2 };
  return { low: 0, high: scale / 2 };
}

const held = ({ symbol }) => (symbol ? symbols : chosen);

function row(knob) {
  const { key, name, rest, low, high, logarithmic, before = "" } = knob;
  const toValue = (at) => (logarithmic ? low * (high / low) ** (at / STEPS) : low + ((high - low) * at) / STEPS);
  const toStep = (value) => Math.round(STEPS * (logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low)));
  const value = () => held(knob)[key] ?? rest;
  const told = element("output", { for: `try-${key}` });
  const say = () => {
    const text = `${before}${short(value(), 3)}`;
    told.textContent = text;
    slider.setAttribute("aria-valuetext", `${name} ${text}`);
  };
  const set = (next) => {
    if (next === rest) delete held(knob)[key];
    else held(knob)[key] = next;
    reset.hidden = next === rest;
    say();
    onchange();
  };
  const slider = element("input", { type: "range", id: `try-${key}`, "aria-label": name, min: 0, max: STEPS, value: toStep(value()),
    oninput: () => set(Number(slider.value) === toStep(rest) ? rest : Number(toValue(Number(slider.value)).toPrecision(3))) });
  const reset = element("button", { type: "button", class: "reset", "aria-label": `Reset ${name}`, title: "Reset", hidden: value() === rest, onclick: () => {
    slider.value = toStep(rest);
    set(rest);
  } }, "\u21ba");
  say();
  return element("div", { class: "knob" }, reset, element("label", { for: `try-${key}` }, name.replaceAll("_", "_\u200b"), element("small", { id: `note-${key}` })), slider, told);
}
