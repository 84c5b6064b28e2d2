// One quantity over time, as SVG in the width that there is.

import { drawn, element, short } from "dom";

const HEIGHT = 210;
const MARGIN = { left: 58, right: 12, top: 26, bottom: 34 };
/** Most decades of a logarithmic axis. */
const DECADES = 14;

/**
 * A figure, `width` pixels wide, of a panel: `{name, of, lines, bounds, logarithmic, held}`, where `of(run)` are the values of a
 * run that the readout tells and `lines(run)` further curves `{name, kind, values}`.
 */
export function chart(panel, runs, { width, read }) {
  const { logarithmic } = panel;
  const shown = (y) => (logarithmic ? (y ? Math.log10(Math.abs(y)) : NaN) : y);
  const curves = runs.flatMap((run) => [{ run, kind: "", values: panel.of(run) }, ...panel.lines(run).map((line) => ({ run, ...line }))]);
  const across = [Math.min(...runs.map((run) => run.t[0])), Math.max(...runs.map(end))];
  const up = range(curves, shown, logarithmic);
  const inner = { width: width - MARGIN.left - MARGIN.right, height: HEIGHT - MARGIN.top - MARGIN.bottom };
  const toX = (t) => MARGIN.left + (inner.width * (t - across[0])) / (across[1] - across[0] || 1);
  const toY = (y) => MARGIN.top + (inner.height * (up[1] - y)) / (up[1] - up[0]);
  const inside = (y) => Math.min(up[1], Math.max(up[0], y));
  const mesh = [
    ...steps(up, logarithmic ? 5 : 4, logarithmic).flatMap((y) => [
      drawn("path", { class: "mesh", d: `M${MARGIN.left} ${toY(y)}h${inner.width}` }),
      drawn("text", { x: MARGIN.left - 6, y: toY(y) + 4, "text-anchor": "end" }, logarithmic ? power(y) : short(y, 3)),
    ]),
    ...steps(across, width < 340 ? 4 : 6).map((t) => drawn("text", { x: toX(t), y: HEIGHT - 18, "text-anchor": "middle" }, short(t, 4))),
  ];
  const bounds = panel.bounds.filter(({ at }) => Number.isFinite(at) && at !== null)
    .map((bound) => ({ ...bound, at: shown(bound.at) })).filter(({ at }) => at <= up[1] && at >= up[0]);
  const limits = bounds.flatMap(({ at, name }) => [
    drawn("path", { class: "bound", d: `M${MARGIN.left} ${toY(at)}h${inner.width}` }),
    drawn("text", { class: "of-bound", x: width - MARGIN.right - 2, y: toY(at) - 4, "text-anchor": "end" }, name),
  ]);
  const lines = curves.map(({ run, kind, values }) => drawn("path", { class: `line run${run.index % 6} ${kind}`.trim(), d: path(run, values, panel, shown, toX, toY, inside) }));
  const instants = [...new Set(runs.flatMap((run) => run.deadlines))];
  const ends = instants.map((t) => drawn("path", { class: "deadline", d: `M${toX(t)} ${MARGIN.top}v${inner.height}` }));
  const own = panel.of(runs[0]);
  const peak = Math.max(...own.map((y) => Math.abs(y ?? NaN)).filter(Number.isFinite));
  const told = `${panel.name} over time in s: from ${short(own[0])}, largest size ${short(peak)}, last ${short(own.at(-1))}`;
  const cursor = drawn("path", { class: "cursor" });
  const svg = drawn("svg", { viewBox: `0 0 ${width} ${HEIGHT}`, width, height: HEIGHT, role: "img", "aria-label": told },
    drawn("text", { class: "name", x: MARGIN.left, y: 16 }, panel.name),
    drawn("text", { x: width - MARGIN.right, y: 16, "text-anchor": "end" }, panel.key),
    drawn("text", { x: MARGIN.left + inner.width / 2, y: HEIGHT - 3, "text-anchor": "middle" }, "t in s"),
    ...mesh, ...ends, ...limits, ...lines, cursor);
  svg.addEventListener("pointermove", (event) => {
    const box = svg.getBoundingClientRect();
    const t = across[0] + ((event.clientX - box.left - MARGIN.left) / inner.width) * (across[1] - across[0]);
    if (t < across[0] || t > across[1]) return;
    cursor.setAttribute("d", `M${toX(t)} ${MARGIN.top}v${inner.height}`);
    const at = ({ run, name, values }) => `${run.label}: ${name ?? panel.name} = ${short(values[before(run.t, t)])}`;
    read(`t = ${short(t)} s: ${curves.map(at).join("; ")}`);
  });
  return element("figure", {}, svg);
}

const end = (run) => Math.max(run.t.at(-1), ...run.deadlines);

/** The last index at which time is not after `t`. */
function before(times, t) {
  let [low, high] = [0, times.length - 1];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

function range(curves, shown, logarithmic) {
  let [low, high] = logarithmic ? [Infinity, -Infinity] : [0, 0];
  for (const { values } of curves) {
    for (const y of values) {
      const at = shown(y);
      if (y === null || !Number.isFinite(at)) continue;
      low = Math.min(low, at);
      high = Math.max(high, at);
    }
  }
  if (!(low <= high)) return [-1, 1];
  if (logarithmic) return [Math.floor(Math.max(low, high - DECADES)), Math.ceil(high + 0.1)];
  const margin = 0.06 * (high - low) || 1;
  return [low - margin, high + margin];
}

/** Round numbers in a range, about `count` of them. */
function steps([low, high], count, whole = false) {
  const wanted = (high - low) / count;
  const power10 = 10 ** Math.floor(Math.log10(wanted));
  const step = [1, 2, 5, 10].map((k) => k * power10).find((k) => k >= wanted && (!whole || Number.isInteger(k))) ?? 1;
  const all = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) all.push(k * step);
  return all;
}

const power = (y) => (y >= -2 && y <= 4 ? short(10 ** y) : `1e${Math.round(y)}`);

function path(run, values, panel, shown, toX, toY, inside) {
  let d = "";
  let pen = "M";
  values.forEach((value, i) => {
    const y = shown(value);
    if (value === null || !Number.isFinite(y)) {
      pen = "M";
      return;
    }
    const [x, at] = [toX(run.t[i]).toFixed(1), toY(inside(y)).toFixed(1)];
    // An input that is held goes on level before it changes.
    d += panel.held && run.held && pen === "L" ? `H${x}V${at}` : `${pen}${x} ${at}`;
    pen = "L";
  });
  return d;
}
