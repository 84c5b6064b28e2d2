// The results of a design as cards: the error at the deadline, the peak of u, margins, the soonest deadline.

import { $, element, short } from "dom";
import { atDeadline } from "panels";

/** The largest gain and delay that are tried. */
const MOST = 64;
const LATE = 16;

/** The input gains with which a loop is stable, in words. */
export function gains({ gain: [low, high] }) {
  return `${low * MOST > 1 ? "" : "\u2264 "}${short(low, 3)} to ${high < MOST ? "" : "\u2265 "}${short(high, 3)}`;
}

let onuse = () => {};

/** `use` is called with the soonest deadline when it is chosen. */
export function start(use) {
  onuse = use;
}

/** Shows the cards of an answer. */
export function show({ runs, figures, verdict }) {
  const run = runs?.series?.find((one) => one.t);
  const worst = figures?.worst;
  const cards = [run && error(runs, run, worst), run && peak(runs, run, worst), margins(figures, verdict), soonest(figures)];
  $("figures").replaceChildren(...cards.filter(Boolean));
}

function card(title, value, kind, ...hints) {
  return element("div", { class: "card" }, element("h3", {}, title), element("p", { class: `value ${kind}` }, value),
    ...hints.filter(Boolean).map((hint) => element("p", { class: "hint" }, hint)));
}

function error(runs, run, worst) {
  const { symbol, follows, values: all } = atDeadline(runs, run);
  const largest = Math.max(...all);
  const beyond = all.some((x, j) => runs.error[j] !== null && x > runs.error[j]);
  const bound = worst && `worst case: ${worst.states.map(({ name, bound: most }) => `${name} ${short(most, 3)}`).join(", ")}`;
  const wanted = runs.error.some((most) => most !== null) && `required: ${runs.error.map((most) => short(most, 3)).join(", ")}`;
  return card(follows ? "Tracking error at the deadline" : "Error at the deadline", Number.isFinite(largest) ? short(largest, 3) : "none",
    beyond ? "bad" : "good", `|${symbol}| of this run at t = ${short(run.end.t, 4)} s`, bound, wanted);
}

function peak(runs, run, worst) {
  const each = runs.inputs.map((name, k) => {
    const limit = run.u_max[k] === null ? "" : ` of ${short(run.u_max[k], 3)}`;
    return `${runs.inputs.length > 1 ? `${name} ` : ""}${short(run.peak[k], 3)}${limit}`;
  });
  const clipped = run.saturated > 0;
  return card("Peak input", each.join(", "), clipped ? "open" : "good", clipped ? `clipped for ${short(run.saturated, 3)} s` : "never clipped in this run",
    worst?.u != null && `worst case: ${short(worst.u, 3)}`);
}

function margins(figures, verdict) {
  const found = figures?.margins;
  if (!found) return verdict && card("Margins", "\u2013", "none", verdict.margins);
  return card("Margins", gains(found), "good", "times the input gain, with the final gains",
    `${found.delay < LATE ? "" : "\u2265 "}${found.delay} more ${found.delay === 1 ? "sample" : "samples"} of delay`);
}

function soonest(figures) {
  const tau = figures?.soonest;
  if (tau == null) return null;
  const rounded = Number(tau.toPrecision(3)) < tau ? Number((tau * 1.001).toPrecision(3)) : Number(tau.toPrecision(3));
  const made = card("Soonest deadline", `${short(tau, 3)} s`, "good", "keeps the limits from all of x0_max");
  made.append(element("button", { type: "button", onclick: () => onuse(rounded) }, `Set tau = ${rounded}`));
  return made;
}
