// Sliders for keys of the design. A box beside each adds the key or takes it away.

import { $, element, short } from "dom";
import * as editor from "editor";

// Logarithmic ranges in powers of ten; `whole` ones are linear.
const KNOBS = [
  { key: "tau", name: "tau", unit: "s", from: -2, to: 2, start: 1 },
  { key: "sample_time", name: "Sample time", unit: "s", from: -5, to: 0, start: 1e-3 },
  { key: "eps", name: "eps", unit: "s", from: -5, to: 0, start: 0.05, timeOnly: true },
  { key: "noise", name: "Noise", unit: "", from: -8, to: 0, start: 1e-4 },
  { key: "delay", name: "Delay", unit: "samples", from: 0, to: 5, start: 1, whole: true },
];

/** Steps of a slider for a power of ten. */
const STEPS = 50;

let onchange = () => {};

export function start(change) {
  onchange = change;
  $("knobs").replaceChildren(...KNOBS.map(row));
}

function row(knob) {
  const { key, name, from, to, whole } = knob;
  const box = element("input", { type: "checkbox", id: `has-${key}`, onchange: () => toggle(knob) });
  const steps = whole ? 1 : STEPS;
  const range = element("input", {
    type: "range", id: `knob-${key}`, "aria-label": name, min: from * steps, max: to * steps, oninput: () => turn(knob),
  });
  return element("div", { class: "knob" }, box, element("label", { for: `has-${key}` }, name), range,
    element("output", { id: `value-${key}`, for: `knob-${key}` }));
}

function toggle(knob) {
  if ($(`has-${knob.key}`).checked) editor.give(knob.key, short(knob.start, 3));
  else editor.take(knob.key);
  onchange();
}

function turn(knob) {
  const at = Number($(`knob-${knob.key}`).value);
  set(knob.key, knob.whole ? at : 10 ** (at / STEPS));
}

/** Gives a key a value, as its slider would. */
export function set(key, value) {
  editor.give(key, short(value, 3));
  onchange();
}

/** Turns the sliders to what the design gives. */
export function show(answer) {
  for (const knob of KNOBS) {
    const { key, name, unit, whole } = knob;
    const [box, range, told] = [$(`has-${key}`), $(`knob-${key}`), $(`value-${key}`)];
    const given = editor.given(key);
    const value = given === null ? NaN : Number(given);
    box.checked = given !== null;
    box.closest(".knob").hidden = knob.timeOnly && given === null && (answer.design?.samples ?? false);
    // A key that is not there is added where its slider is moved, from what the run takes for it.
    const taken = given === null ? assumed(answer, key) ?? knob.start : value;
    range.disabled = !Number.isFinite(taken) || (!whole && taken <= 0);
    const known = given === null && assumed(answer, key) !== null ? `${short(taken)} ${unit}, open` : "not set";
    const units = value === 1 && unit === "samples" ? "sample" : unit;
    const text = given === null ? known : Number.isFinite(value) ? `${short(value)} ${units}` : given;
    told.classList.toggle("none", given === null);
    told.textContent = text;
    range.setAttribute("aria-valuetext", `${name} ${text}`);
    if (range.disabled) range.value = Math.round((Number(range.min) + Number(range.max)) / 2);
    else if (document.activeElement !== range) range.value = whole ? taken : Math.round(Math.log10(taken) * STEPS);
  }
}

/** The value that the run takes for an open key; null where it takes none. */
function assumed(answer, key) {
  const all = answer.runs?.series?.[0]?.assumed ?? [];
  const own = all.find((text) => text.startsWith(`${key} = `));
  return own ? Number.parseFloat(own.slice(key.length + 3)) : null;
}
