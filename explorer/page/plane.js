// The poles in the complex plane of stretched time, dragged or moved by the arrow keys.

import { $, drawn, short } from "dom";
import * as editor from "editor";

const SIZE = { width: 360, height: 260 };
const CENTRE = SIZE.height / 2;
/** Poles nearer to the real axis than this part of the plane are on it. */
const REAL = 0.02;

let poles = [];
let plane = null;
let scale = null;
let dragged = -1;
let onchange = () => {};

export function start(change) {
  onchange = change;
}

/** Draws the poles of the answer, unless one is under the pointer. */
export function show(answer) {
  if (dragged >= 0 && answer.plane) {
    plane = answer.plane;
    return draw();
  }
  plane = answer.plane ?? null;
  poles = (plane?.poles ?? []).map(([re, im]) => ({ re, im }));
  const hint = $("plane-hint");
  if (!plane) {
    $("plane").replaceChildren();
    hint.textContent = "The poles are shown once `poles` or `gains` are given.";
    return;
  }
  hint.textContent = plane.control === null
    ? "Drag a pole, or focus it and use the arrow keys."
    : `Drag a pole, or focus it and use the arrow keys. Right of ${short(plane.control)} u does not vanish at the deadline; right of ${short(plane.state)} x does not either.`;
  scale = fitted();
  draw();
}

/** The visible part of the plane: all poles and lines, and the imaginary axis. */
function fitted() {
  const left = Math.min(-1, ...poles.map((p) => p.re), plane.control ?? -1) * 1.3;
  const right = Math.max(0.2 * -left, ...poles.map((p) => p.re * 1.2));
  const high = Math.max(0.3 * (right - left), ...poles.map((p) => Math.abs(p.im) * 1.3));
  const unit = Math.min(SIZE.width / (right - left), CENTRE / high);
  const middle = (left + right) / 2;
  return { unit, origin: SIZE.width / 2 - middle * unit };
}

const toX = (re) => scale.origin + re * scale.unit;
const toY = (im) => CENTRE - im * scale.unit;

function draw() {
  const focused = [...$("plane").querySelectorAll(".pole")].indexOf(document.activeElement);
  const region = (from, name) => {
    const x = Math.max(0, Math.min(SIZE.width, toX(from)));
    return drawn("rect", { class: name, x, y: 0, width: SIZE.width - x, height: SIZE.height });
  };
  const shaded = plane.control === null ? [] : [region(plane.control, "grows"), region(plane.state, "stays")];
  const ticks = marks();
  $("plane").replaceChildren(drawn("svg", {
    viewBox: `0 0 ${SIZE.width} ${SIZE.height}`, role: "group", "aria-labelledby": "plane-title", onpointermove: drag,
    onpointerup: drop, onpointercancel: drop,
  },
  drawn("rect", { class: "field", width: SIZE.width, height: SIZE.height }), ...shaded,
  drawn("path", { class: "axis", d: `M0 ${CENTRE}H${SIZE.width}M${toX(0)} 0V${SIZE.height}` }), ...ticks,
  ...poles.map(pole)));
  $("plane").querySelectorAll(".pole")[focused]?.focus();
}

/** Numbers along the real axis. */
function marks() {
  const wanted = SIZE.width / scale.unit / 6;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= wanted);
  const all = [];
  for (let at = Math.ceil(-scale.origin / scale.unit / step) * step; toX(at) < SIZE.width - 8; at += step) {
    if (toX(at) > 12) all.push(drawn("text", { x: toX(at), y: SIZE.height - 6, "text-anchor": "middle" }, short(at, 3)));
  }
  return all;
}

function pole({ re, im }, index) {
  const [x, y] = [toX(re), toY(im)];
  const name = `Pole ${index + 1}`;
  return drawn("g", {
    class: "pole", tabindex: 0, role: "slider", "aria-label": name, "aria-valuenow": short(re), "aria-valuetext": spelling({ re, im }),
    onpointerdown: (event) => take(event, index), onkeydown: (event) => nudge(event, index),
  },
  drawn("circle", { class: "reach", cx: x, cy: y, r: 16 }),
  drawn("path", { d: `M${x - 5} ${y - 5}l10 10m0 -10l-10 10` }), drawn("title", {}, `${name}: ${spelling({ re, im })}`));
}

function take(event, index) {
  dragged = index;
  $("plane").firstChild.setPointerCapture?.(event.pointerId);
  event.preventDefault();
}

function drag(event) {
  if (dragged < 0) return;
  const box = $("plane").firstChild.getBoundingClientRect();
  const share = SIZE.width / box.width;
  const re = ((event.clientX - box.left) * share - scale.origin) / scale.unit;
  const im = (CENTRE - (event.clientY - box.top) * share) / scale.unit;
  move(dragged, rounded(re), rounded(im));
}

function drop() {
  if (dragged < 0) return;
  dragged = -1;
  onchange();
}

function nudge(event, index) {
  const step = (SIZE.width / scale.unit) / 200;
  const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
  if (!by) return;
  event.preventDefault();
  const { re, im } = poles[index];
  // A real pole leaves the axis at once, as what is near it counts as real.
  const start = im === 0 && by[1] ? REAL * SIZE.height / scale.unit : 0;
  move(index, rounded(re + by[0] * step), rounded(im + by[1] * Math.max(step, start)));
}

/** Rounds to what a pixel can tell. */
function rounded(value) {
  const digit = 10 ** Math.floor(Math.log10(1 / scale.unit));
  return Number((Math.round(value / digit) * digit).toPrecision(6));
}

/** Moves a pole, and its conjugate with it; a real pole that leaves the axis needs another one. */
function move(index, re, im) {
  const own = poles[index];
  const on = Math.abs(im) * scale.unit < REAL * SIZE.height;
  const partner = own.im === 0
    ? poles.findIndex((other, at) => at !== index && other.im === 0)
    : poles.findIndex((other, at) => at !== index && other.im === -own.im && other.re === own.re);
  if (own.im === 0 && (on || partner < 0)) {
    poles[index] = { re, im: 0 };
  } else if (on) {
    poles[index] = { re, im: 0 };
    poles[partner] = { re, im: 0 };
  } else {
    poles[index] = { re, im };
    poles[partner] = { re, im: -im };
  }
  draw();
  write();
}

/** Puts the poles into the design. */
function write() {
  const real = poles.every(({ im }) => im === 0);
  const list = poles.map(spelling).join(real ? ", " : ",");
  const value = real ? `[${list}]` : `"${list}"`;
  if (editor.given("poles") === null && editor.given("gains") !== null) editor.rename("gains", "poles", value);
  else editor.give("poles", value);
  onchange();
}

function spelling({ re, im }) {
  if (im === 0) return short(re, 6);
  return `${short(re, 6)}${im < 0 ? "-" : "+"}${short(Math.abs(im), 6)}i`;
}
