// The emitted files and the formulas, in tabs.

import { $, download, element } from "dom";
import { sheet } from "code";
import { formulas } from "formulas";

const FORMULAS = "formulas";
const TITLES = { c: "C", rust: "Rust", cpp: "C++", matlab: "MATLAB", python: "Python", st: "Structured Text", plcopen: "PLCopen XML", [FORMULAS]: "Formulas" };

let chosen = "c";
/** What is shown, as text: other parameters often leave the code as it is. */
let shown = "";
let onchoose = () => {};

/** The language of the chosen tab; of the formulas, none. */
export const language = () => chosen;

/** Makes the tabs. `change` is called when another is chosen. */
export function start(change) {
  onchoose = change;
  const tab = ([name, title]) => element("button", {
    type: "button", role: "tab", id: `tab-${name}`, "aria-controls": "files", "data-name": name,
    onclick: () => choose(name), onkeydown: move,
  }, title);
  $("tabs").append(...Object.entries(TITLES).map(tab));
}

/** Chooses a tab, if there is one of that name. */
export function set(name) {
  const tabs = [...$("tabs").children];
  if (tabs.some((tab) => tab.dataset.name === name)) chosen = name;
  for (const tab of tabs) {
    const own = tab.dataset.name === chosen;
    tab.setAttribute("aria-selected", String(own));
    tab.tabIndex = own ? 0 : -1;
  }
  $("files").setAttribute("aria-labelledby", `tab-${chosen}`);
}

function choose(name) {
  set(name);
  onchoose();
}

function move(event) {
  const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!step) return;
  const tabs = [...$("tabs").children];
  const next = tabs[(tabs.indexOf(event.target) + step + tabs.length) % tabs.length];
  choose(next.dataset.name);
  next.focus();
}

/** Shows what the answer holds for the chosen tab. */
export function show(answer) {
  const stale = (answer.diagnostics ?? []).length > 0;
  if (stale || chosen === FORMULAS) shown = "";
  if (stale) {
    const told = element("p", { class: "hint" }, "No output: the design has errors, which are listed under it.");
    return $("files").replaceChildren(told);
  }
  if (chosen === FORMULAS) return $("files").replaceChildren(formulas(answer));
  const files = answer.files ?? [];
  const now = JSON.stringify([chosen, files]);
  if (now === shown) return;
  shown = now;
  // The code is what one looks for; what declares it comes after.
  const declares = ({ name }) => /\.(h|hpp)$/.test(name) && files.length > 1;
  const open = [...$("files").querySelectorAll("details.fold[open]")].length > 0;
  $("files").replaceChildren(...[...files].sort((a, b) => declares(a) - declares(b)).map(file));
  if (open) for (const fold of $("files").querySelectorAll("details.fold")) fold.open = true;
}

function file({ name, text }) {
  const lines = text.split("\n").length - 1;
  const copy = (event) => navigator.clipboard.writeText(text).then(() => { event.target.textContent = "Copied"; });
  return element("article", { "data-file": name },
    element("div", { class: "head" }, element("h3", {}, name), element("span", { class: "hint" }, `${lines} lines`),
      element("button", { type: "button", "aria-label": `Copy ${name}`, onclick: copy }, "Copy"),
      element("button", { type: "button", "aria-label": `Download ${name}`, onclick: () => download(name, text) }, "Download")),
    sheet(text, chosen));
}
