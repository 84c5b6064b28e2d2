// The design: its text, the underlined mistakes, and edits of single keys.

import { $, element } from "dom";

const area = $("text");
let keys = {};
/** Whether the places of the keys are those of the text. */
let fresh = false;

export const text = () => area.value;

/** Puts in another text. */
export function put(design) {
  area.value = design;
  typed();
}

/** The text is another one: until it is answered, nothing is known of it. */
export function typed() {
  fresh = false;
  mark([]);
}

/** Underlines mistakes and lists them. */
export function show(answer) {
  keys = answer.keys ?? {};
  fresh = true;
  const found = answer.diagnostics ?? [];
  mark(found.filter((one) => one.at));
  area.setAttribute("aria-invalid", String(found.length > 0));
  $("errors").replaceChildren(...found.map(item));
}

function item(one) {
  const place = one.line ? `line ${one.line}, column ${one.column}: ` : "";
  const line = element("span", { class: "message" }, `${place}${one.message}`);
  const head = one.at ? element("button", { type: "button", onclick: () => select(one.at) }, line) : line;
  return element("li", { "data-code": one.code, "data-line": one.line, "data-column": one.column },
    head, element("span", { class: "help" }, one.help));
}

function select([start, end]) {
  area.focus();
  area.setSelectionRange(start, Math.max(end, start + 1));
}

/** The text with the ranges of mistakes marked, behind the one that is typed in. */
function mark(found) {
  const ranges = found.map(({ at: [start, end] }) => [start, Math.max(end, start + 1)]).sort((a, b) => a[0] - b[0]);
  const parts = [];
  let last = 0;
  for (const [start, end] of ranges) {
    if (start < last) continue;
    parts.push(area.value.slice(last, start), element("mark", {}, area.value.slice(start, end)));
    last = end;
  }
  // A last line that is empty has no height without something in it.
  parts.push(`${area.value.slice(last)}\n `);
  $("marks").replaceChildren(...parts);
}

/** The value of a key as it is written, without quotes; null where it is not given. */
export function given(key) {
  const at = keys[key]?.value;
  return at ? area.value.slice(...at) : null;
}

/** Gives a key another value, or adds it before the first table. */
export function give(key, value) {
  if (!fresh) return;
  if (keys[key]) {
    const old = area.value.slice(...keys[key].value);
    replace(quoted(keys[key].value), value);
    return revise(key, old, value);
  }
  const tables = area.value.search(/^[ \t]*\[/m);
  const end = tables < 0 ? area.value.length : tables;
  const start = area.value.slice(0, end).trimEnd().length;
  const line = `${start > 0 ? "\n" : ""}${key} = ${value}`;
  replace([start, end], `${line}${tables < 0 ? "\n" : "\n\n"}`);
  const last = start + line.length;
  keys[key] = { key: [last - value.length - 3 - key.length, last - value.length - 3], value: [last - value.length, last] };
}

/** Takes the line of a key away. */
export function take(key) {
  const at = keys[key];
  if (!fresh || !at) return;
  const start = area.value.lastIndexOf("\n", at.key[0] - 1) + 1;
  const end = area.value.indexOf("\n", at.value[1]);
  delete keys[key];
  replace([start, end < 0 ? area.value.length : end + 1], "");
}

/** Renames a key and gives it a value. */
export function rename(from, to, value) {
  if (!fresh) return;
  const at = keys[from];
  const start = at.key[0];
  delete keys[from];
  replace([start, quoted(at.value)[1]], `${to} = ${value}`);
  keys[to] = { key: [start, start + to.length], value: [start + to.length + 3, start + to.length + 3 + value.length] };
}

/** Keys in seconds, of which comments speak with their unit. */
const TIMES = ["tau", "sample_time", "eps", "observer_eps"];

/** A number of its own in a comment, not in a name or a unit such as 1/kg. */
const NUMBER = /[\s=(]\d(?!\/)/;

/** Keeps comments true: those with the old value of a time get the new one, and a comment beside the key that has other numbers says
 * for which value they hold. */
function revise(key, old, value) {
  const [from, to] = [Number(old), Number(value)];
  for (const [start, end] of comments()) {
    const text = area.value.slice(start, end);
    const beside = keys[key].value[1] < start && !area.value.slice(keys[key].value[1], start).includes("\n");
    let next = text;
    if (TIMES.includes(key)) {
      next = text.replace(/(\d+(?:\.\d+)?(?:e[-+]?\d+)?)(\s?)(ms|s)\b/g, (all, number, space, unit) => {
        const scale = unit === "ms" ? 1e-3 : 1;
        return Math.abs(Number(number) * scale - from) <= 1e-9 * from ? `${Number((to / scale).toPrecision(6))}${space}${unit}` : all;
      });
    }
    if (beside && next === text && NUMBER.test(text) && !text.startsWith("# with ")) {
      next = `# with ${old}: ${text.replace(/^#\s*/, "")}`;
    }
    if (next !== text) replace([start, end], next);
  }
}

/** The places of comments, the last one first: a change of one moves none that is still to come. */
function comments() {
  const places = [];
  const text = area.value;
  let at = 0;
  for (const line of text.split("\n")) {
    const start = hash(line);
    if (start >= 0) places.unshift([at + start, at + line.length]);
    at += line.length + 1;
  }
  return places;
}

/** Where the comment of a line starts, outside of strings; -1 without one. */
function hash(line) {
  let quote = "";
  for (let i = 0; i < line.length; i += 1) {
    const c = line[i];
    if (quote) {
      if (c === quote) quote = "";
    } else if (c === '"' || c === "'") quote = c;
    else if (c === "#") return i;
  }
  return -1;
}

/** A place within quotes is that of what is quoted: the place with the quotes. */
function quoted([start, end]) {
  const within = area.value[start - 1] === '"' && area.value[end] === '"';
  return within ? [start - 1, end + 1] : [start, end];
}

/** Replaces a part of the text; the places of all keys go with it. */
function replace([start, end], value) {
  area.value = area.value.slice(0, start) + value + area.value.slice(end);
  const moved = (at) => (at >= end ? at + start + value.length - end : Math.min(at, start + value.length));
  for (const at of Object.values(keys)) {
    at.key = at.key.map(moved);
    at.value = at.value[0] >= start && at.value[1] <= end ? [start, start + value.length] : at.value.map(moved);
  }
  mark([]);
}
