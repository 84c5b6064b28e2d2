// The trajectories: a chart for each quantity, a legend, numbers.

import { $, element, short } from "dom";
import { chart } from "chart";
import { atDeadline, panels } from "panels";

/** Instants in the table of numbers. */
const SHOWN = 12;
/** Least width of a chart and the gap beside it, in pixels. */
const WIDTH = 280;
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
  $("legend").replaceChildren(...(answered.problem ? [element("li", { class: "problem" }, `Not simulated: ${answered.problem}`)] : all.map(entry)));
  const shown = drawn.length ? panels(answered, drawn, $("log").checked) : [];
  $("charts").replaceChildren(...rows(shown, $("charts").clientWidth).flatMap(({ row, width }) => row.map((panel) => chart(panel, drawn, { width, read }))));
  $("readout").textContent = "";
  $("numbers").replaceChildren(...(drawn.length ? [table(drawn[0])] : []));
}

/** Panels in rows, each of which fills the space. */
function rows(shown, space) {
  const most = Math.max(1, Math.floor((space + GAP) / (WIDTH + GAP)));
  const count = Math.ceil(shown.length / most);
  const at = (row) => Math.round((row * shown.length) / count);
  return Array.from({ length: count }, (_, i) => shown.slice(at(i), at(i + 1)))
    .map((row) => ({ row, width: Math.floor((space - GAP * (row.length - 1)) / row.length) }));
}

/** What a run came to, in a line. */
function entry(one, index) {
  const name = element("strong", {}, one.label);
  if (one.problem) return element("li", { class: "problem" }, name, ` not simulated: ${one.problem}`);
  const { symbol, values } = atDeadline(answered, one);
  const parts = [
    `|${symbol}| at the deadline ${short(Math.max(...values), 3)}`,
    ...answered.inputs.map((name, k) => `peak |${name}| ${short(one.peak[k], 3)}`),
  ];
  if (one.saturated > 0) parts.push(`saturated for ${short(one.saturated, 3)} s`);
  if (one.failed) parts.push(`step returns ${one.failed.status} at ${short(one.failed.t, 4)} s`);
  if (one.refused_by.length) parts.push(`refused by ${one.refused_by.join(", ")}`);
  if (one.deadlines.length > 1) parts.push(`deadlines at ${one.deadlines.map((t) => short(t, 4)).join(", ")} s`);
  if (answered.tried.length) parts.push(`with ${answered.tried.join(", ")}`);
  if (one.assumed.length) parts.push(`the design leaves open, and this run takes: ${one.assumed.join(", ")}`);
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
