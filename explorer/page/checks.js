// The verdicts of the checks and what a step costs.

import { $, element } from "dom";

const CLASSES = { sound: "good", unsound: "bad", refuted: "bad", undecided: "open", "not checked": "none" };

const OPERATIONS = [
  ["add", "addition or comparison", "additions or comparisons"],
  ["mul", "multiplication", "multiplications"],
  ["fused", "fused multiply-add", "fused multiply-adds"],
  ["div", "division", "divisions"],
  ["sqrt", "square root", "square roots"],
  ["calls", "function call", "function calls"],
];

/** One line for the state of the design. */
export function verdict(answer) {
  if (answer.fault) return ["bad", `The generator failed: ${answer.fault}`];
  const found = answer.diagnostics ?? [];
  if (found.length === 0) {
    return [answer.verdict.open ? "open" : "good", sentence(answer.verdict.text)];
  }
  if ((answer.checks ?? []).some((check) => check.refuses)) return ["bad", sentence(answer.verdict.text)];
  return ["bad", found.length === 1 ? "1 error" : `${found.length} errors`];
}

function sentence(text) {
  return text[0].toUpperCase() + text.slice(1);
}

export function show(answer) {
  const [kind, text] = verdict(answer);
  Object.assign($("verdict"), { className: kind, textContent: text });
  $("verdicts").replaceChildren(...(answer.checks ?? []).flatMap(one), ...margins(answer));
  $("cost").textContent = cost(answer);
  $("told").hidden = !answer.design;
  $("command").textContent = answer.design ? `ptc-codegen emit --lang c ${answer.design.command}` : "";
}

function one({ name, verdict: word, summary, details, fix }) {
  const more = [...details, ...(fix ? [`Fix: ${fix}`] : [])].map((text) => element("li", {}, text));
  return [
    element("dt", {}, name, " ", element("span", { class: `badge ${CLASSES[word]}` }, word)),
    element("dd", {}, element("p", {}, summary), ...(more.length ? [element("ul", {}, ...more)] : [])),
  ];
}

function margins({ verdict: found }) {
  return found ? [element("dt", {}, "margins"), element("dd", {}, element("p", {}, found.margins))] : [];
}

function cost(answer) {
  if (answer.design?.samples) return "The operations of a step are counted only where the clock is time.";
  if (!answer.cost) return "";
  const parts = OPERATIONS.filter(([key]) => answer.cost[key] > 0)
    .map(([key, one, many]) => `${answer.cost[key]} ${answer.cost[key] === 1 ? one : many}`);
  return `One step, without input checks and clipping: ${parts.join(", ")}.`;
}
