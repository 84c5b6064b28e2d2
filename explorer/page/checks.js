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
    const open = (answer.checks ?? []).filter((check) => check.verdict === "undecided").map((check) => check.name);
    return open.length ? ["open", `Accepted; undecided: ${open.join(", ")}`] : ["good", "Accepted"];
  }
  const refusing = (answer.checks ?? []).filter((check) => check.refuses).map((check) => check.name);
  if (refusing.length) return ["bad", `Refused by ${refusing.join(", ")}`];
  return ["bad", found.length === 1 ? "1 error" : `${found.length} errors`];
}

export function show(answer) {
  const [kind, text] = verdict(answer);
  Object.assign($("verdict"), { className: kind, textContent: text });
  $("verdicts").replaceChildren(...(answer.checks ?? []).flatMap(one));
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

function cost(answer) {
  if (answer.design?.samples) return "The operations of a step are counted only where the clock is time.";
  if (!answer.cost) return "";
  const parts = OPERATIONS.filter(([key]) => answer.cost[key] > 0)
    .map(([key, one, many]) => `${answer.cost[key]} ${answer.cost[key] === 1 ? one : many}`);
  return `One step, without input checks and clipping: ${parts.join(", ")}.`;
}
