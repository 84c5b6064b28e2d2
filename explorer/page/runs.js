// The trajectories: a chart for each state and each input, a legend, numbers.

import { $, element, short } from "dom";
import { chart } from "chart";

/** Instants in the table of numbers. */
const SHOWN = 12;
/** Least width of a chart and the gap beside it, in pixels. */
const WIDTH = 300;
const GAP = 14;

let answered = null;

/** Shows the runs of an answer. */
export function show(answer) {
  if (answer.runs) answered = answer.runs;
  if (!answer.runs && !answered) return;
  draw();
}

/** Draws the last runs again, in the width that there is. */
export function draw() {
  if (!answered) return;
  const all = answered.series ?? [];
  const drawn = all.map((one, index) => ({ ...one, index })).filter((one) => one.t);
  $("legend").replaceChildren(...(answered.problem ? [element("li", { class: "problem" }, answered.problem)] : all.map(entry)));
  const by = $("log").checked;
  const panels = drawn.length === 0 ? [] : [
    ...answered.states.map((name, j) => ({ name, bounds: [answered.x_max[j], answered.x_max[j] && -answered.x_max[j]], of: (one) => one.x[j] })),
    ...answered.inputs.map((name, k) => ({ name, bounds: [drawn[0].u_max[k], drawn[0].u_min[k]], of: (one) => one.u[k], steps: true })),
  ];
  const space = $("charts").clientWidth;
  const columns = Math.max(1, Math.min(panels.length, Math.floor((space + GAP) / (WIDTH + GAP))));
  const width = Math.floor((space - GAP * (columns - 1)) / columns);
  $("charts").replaceChildren(...panels.map((panel) => chart(panel, drawn, { width, logarithmic: by, read })));
  $("readout").textContent = "";
  $("numbers").replaceChildren(...(drawn.length ? [table(drawn[0])] : []));
}

/** What a run came to, in a line. */
function entry(one, index) {
  const name = element("strong", {}, one.label);
  if (one.problem) return element("li", { class: "problem" }, name, ` not simulated: ${one.problem}`);
  const parts = [
    `|x| at the deadline ${short(Math.max(...one.end.x.map((x) => Math.abs(x ?? NaN))), 3)}`,
    ...answered.inputs.map((name, k) => `peak |${name}| ${short(one.peak[k], 3)}`),
  ];
  if (one.saturated > 0) parts.push(`saturated for ${short(one.saturated, 3)} s`);
  if (one.failed) parts.push(`step returns ${one.failed.status} at ${short(one.failed.t, 4)} s`);
  if (one.refused_by.length) parts.push(`refused by ${one.refused_by.join(", ")}`);
  if (one.assumed.length) parts.push(`with ${one.assumed.join(", ")}`);
  if (one.every > 1) parts.push(`every ${one.every}th sample is drawn`);
  parts.push(one.held ? "sampled, u held" : "continuous: give sample_time for the sampled loop");
  return element("li", { class: `run run${index % 6}` }, name, ` ${parts.join("; ")}`);
}

/** Shows the values at an instant. */
function read(told) {
  $("readout").textContent = told;
}

function table(one) {
  const cell = (value) => element("td", {}, short(value));
  const head = ["t in s", ...answered.states, ...answered.inputs].map((name) => element("th", { scope: "col" }, name));
  const last = one.t.length - 1;
  const rows = Array.from({ length: SHOWN }, (_, i) => Math.round((i * last) / (SHOWN - 1)));
  const row = (at) => element("tr", {}, cell(one.t[at]), ...[...one.x, ...one.u].map((all) => cell(all[at])));
  return element("table", {}, element("caption", {}, one.label), element("thead", {}, element("tr", {}, ...head)),
    element("tbody", {}, ...[...new Set(rows)].map(row)));
}
