// The loop as blocks: what is between the law and the plant, and on the way back.

import { $, drawn } from "dom";

const BOX = { width: 112, height: 46, gap: 26 };
/** Room above the blocks, for what acts on them. */
const TOP = 30;
const BARE = 6;

/** Draws the loop of an answer: `loop` has the blocks from the law to the plant, and back. */
export function show({ design }) {
  const loop = design?.loop;
  $("loop").hidden = !loop;
  if (!loop) return;
  const columns = Math.max(loop.forward.length, loop.back.length, 2);
  const width = columns * (BOX.width + BOX.gap) + 24;
  const top = loop.into.length ? TOP : BARE;
  const under = top + BOX.height + 50;
  const height = under + BOX.height + 14;
  const place = (index, y) => ({ x: 12 + BOX.gap / 2 + index * (BOX.width + BOX.gap), y });
  const forward = spread(loop.forward, columns).map(([block, at]) => ({ block, ...place(at, top) }));
  const back = spread(loop.back, columns).map(([block, at]) => ({ block, ...place(columns - 1 - at, under) }));
  const last = forward.at(-1);
  const first = forward[0];
  const middle = BOX.height / 2;
  const wires = [];
  for (const [one, next] of pairs(forward)) wires.push(`M${one.x + BOX.width} ${one.y + middle}H${next.x}`);
  for (const [one, next] of pairs(back)) wires.push(`M${one.x} ${one.y + middle}H${next.x + BOX.width}`);
  const right = width - 8;
  wires.push(`M${last.x + BOX.width} ${last.y + middle}H${right}V${under + middle}H${back.length ? back[0].x + BOX.width : first.x - 8}`);
  const end = back.at(-1);
  if (end) wires.push(`M${end.x} ${under + middle}H${first.x - 16}V${top + middle}H${first.x}`);
  else wires.push(`M${right} ${under + middle}H${first.x - 16}V${top + middle}H${first.x}`);
  const into = loop.into.flatMap(({ block, text }) => {
    const to = forward.find((one) => one.block.name === block) ?? last;
    const x = to.x + BOX.width / 2;
    return [drawn("path", { class: "wire", d: `M${x} 14V${top}`, "marker-end": "url(#tip)" }), drawn("text", { x, y: 10, "text-anchor": "middle" }, text)];
  });
  $("diagram").replaceChildren(drawn("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": told(loop), style: `max-width:${Math.round(width * 1.15)}px` },
    drawn("defs", {}, drawn("marker", { id: "tip", viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: "auto" },
      drawn("path", { class: "tip", d: "M0 0L8 4L0 8z" }))),
    ...wires.map((d) => drawn("path", { class: "wire", d, "marker-end": "url(#tip)" })), ...into, ...[...forward, ...back].map(box)));
}

const told = ({ forward, back, into }) =>
  [...forward, ...back].map(({ name, text }) => `${name}${text ? `, ${text}` : ""}`).join("; then ") + into.map(({ text, block }) => `; ${text} acts on ${block}`).join("");

const pairs = (all) => all.slice(1).map((next, i) => [all[i], next]);

/** The blocks at columns from the first to the last one. */
function spread(blocks, columns) {
  const last = blocks.length - 1;
  return blocks.map((block, i) => [block, last ? Math.round((i * (columns - 1)) / last) : Math.floor((columns - 1) / 2)]);
}

function box({ block: { name, text }, x, y }) {
  return drawn("g", {}, drawn("rect", { class: "box", x, y, width: BOX.width, height: BOX.height, rx: 6 }),
    drawn("text", { class: "name", x: x + BOX.width / 2, y: y + (text ? 19 : 28), "text-anchor": "middle" }, name),
    ...(text ? [drawn("text", { x: x + BOX.width / 2, y: y + 36, "text-anchor": "middle" }, text)] : []));
}
