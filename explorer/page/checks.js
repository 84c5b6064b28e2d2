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
  const opened = new Set([...document.querySelectorAll("#verdicts details[open]")].map((one) => one.dataset.name));
  $("verdicts").replaceChildren(...(answer.checks ?? []).flatMap((check) => one(check, opened)));
  $("checks").hidden = !answer.checks;
  $("cost").textContent = cost(answer);
  $("told").hidden = !answer.design;
  $("command").textContent = answer.design ? `ptc-codegen emit --lang c ${answer.design.command}` : "";
}

/** A check: what fails is open, what holds says so in a line. */
function one({ name, verdict: word, summary, details, fix }, opened) {
  const more = details.map((text) => element("li", {}, text));
  const mend = fix ? [element("p", { class: "fix" }, `Fix: ${fix}`)] : [];
  const open = opened.has(name);
  const rest = more.length ? [element("details", { "data-name": name, open }, element("summary", {}, more.length === 1 ? "1 detail" : `${more.length} details`), element("ul", {}, ...more))] : [];
  return [element("div", {},
    element("dt", {}, name, " ", element("span", { class: `badge ${CLASSES[word]}` }, word)),
    element("dd", {}, element("p", {}, summary), ...mend, ...rest))];
}

function cost(answer) {
  if (answer.design?.samples) return "The operations of a step are counted only where the clock is time.";
  if (!answer.cost) return "";
  const parts = OPERATIONS.filter(([key]) => answer.cost[key] > 0)
    .map(([key, one, many]) => `${answer.cost[key]} ${answer.cost[key] === 1 ? one : many}`);
  return `One step, without input checks and clipping: ${parts.join(", ")}.`;
}
