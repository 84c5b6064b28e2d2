// Wires the page: the design asks, the answer is shown, the address holds both.

import { $, download, element } from "dom";
import { Engine } from "engine";
import * as checks from "checks";
import * as diagram from "diagram";
import * as editor from "editor";
import * as figures from "figures";
import * as knobs from "knobs";
import * as link from "link";
import * as output from "output";
import * as plane from "plane";
import * as runs from "runs";
import * as trials from "trials";

/** Pause after a key, in ms, before the generator is asked. */
const PAUSE = 120;

const known = JSON.parse($("known").textContent);
const engine = new Engine(show, busy);
let timer = 0;

function request() {
  const checked = [...document.querySelectorAll("#overlays input:checked")].map((box) => box.value);
  const { overlays, leftOut } = link.bounded(checked);
  if (leftOut) say(link.leftOut(leftOut));
  return {
    design: editor.text(),
    language: output.language(),
    x0: $("x0").value,
    seed: Number($("seed").value) || 0,
    overlays,
    trial: trials.request(),
  };
}

/** Says that an answer is awaited, which the picture of the last one shows too. */
function busy(text) {
  $("busy").textContent = text;
  document.body.classList.toggle("busy", text !== "");
  document.querySelector("main").setAttribute("aria-busy", String(text !== ""));
}

function say(text) {
  $("said").textContent = text;
}

function ask() {
  clearTimeout(timer);
  timer = 0;
  const asked = request();
  engine.ask(asked);
  link.write({ ...asked, log: $("log").checked });
}

function askSoon() {
  clearTimeout(timer);
  timer = setTimeout(ask, PAUSE);
}

function show(answer, asked) {
  checks.show(answer);
  if (!answer.fault) shown(answer, asked);
  const { dataset } = document.body;
  dataset.ready ??= performance.now();
  dataset.answers = Number(dataset.answers ?? 0) + 1;
  dataset.settled = engine.idle && !timer ? "yes" : "no";
}

function shown(answer, asked) {
  // Places are those of the text that was asked about.
  if (asked.design === editor.text()) editor.show(answer);
  knobs.show(answer);
  plane.show(answer);
  if (asked.language === output.language()) output.show(answer);
  trials.show(answer);
  figures.show(answer);
  diagram.show(answer);
  runs.show(answer);
  document.body.classList.toggle("stale", !answer.runs);
  if (answer.runs) $("x0").placeholder = (answer.runs.x0 ?? []).join(", ");
}

function load(state) {
  editor.put(state.design);
  output.set(state.language);
  $("x0").value = state.x0;
  $("seed").value = state.seed;
  $("log").checked = state.log;
  trials.put(state.trial);
  for (const mapping of state.overlays) overlay(mapping).checked = true;
  say(link.leftOut(state.leftOut ?? 0));
  engine.ask(request());
}

/** The box of a mapping to compare with. */
function overlay(mapping) {
  const boxes = [...document.querySelectorAll("#overlays input[type=checkbox]")];
  const there = boxes.find((box) => box.value === mapping);
  if (there) return there;
  const box = element("input", { type: "checkbox", value: mapping, onchange: ask });
  $("overlays").append(element("label", {}, box, element("code", {}, mapping)));
  return box;
}

function start() {
  output.start(ask);
  knobs.start(askSoon);
  plane.start(ask);
  trials.start(askSoon);
  figures.start((tau) => knobs.set("tau", tau));
  known.mappings.forEach(overlay);
  const own = element("input", { "aria-label": "Another mapping", placeholder: "another, for example power(a=2, m=1)", spellcheck: "false" });
  own.addEventListener("change", () => {
    if (own.value.trim()) overlay(own.value.trim()).checked = true;
    own.value = "";
    ask();
  });
  $("overlays").append(own);
  const examples = known.examples.flatMap(({ designs }) => designs);
  for (const { label, designs } of known.examples) {
    $("examples").append(element("optgroup", { label }, ...designs.map(({ name }) => element("option", { value: name }, name))));
  }
  $("examples").addEventListener("change", () => {
    const example = examples.find(({ name }) => name === $("examples").value);
    if (!example) return;
    $("x0").value = example.x0;
    trials.clear();
    editor.put(example.text);
    ask();
  });
  $("text").addEventListener("input", () => {
    editor.typed();
    askSoon();
  });
  for (const id of ["x0", "seed"]) $(id).addEventListener("input", askSoon);
  $("log").addEventListener("change", () => {
    runs.draw();
    ask();
  });
  $("save").addEventListener("click", () => download("design.toml", editor.text()));
  $("share").addEventListener("click", () => {
    ask();
    navigator.clipboard.writeText(location.href).then(() => say("Link copied"), () => say("Copy the address of the page"));
  });
  addEventListener("hashchange", () => {
    const state = link.read();
    if (state && state.design !== editor.text()) load(state);
  });
  let width = 0;
  new ResizeObserver(([{ contentRect }]) => {
    if (contentRect.width !== width) requestAnimationFrame(runs.draw);
    width = contentRect.width;
  }).observe($("charts"));
  const first = examples.find(({ name }) => name === known.first);
  load(link.read() ?? { design: first.text, language: "c", x0: first.x0, seed: 0, log: true, trial: { symbols: {} }, overlays: [] });
}

start();
