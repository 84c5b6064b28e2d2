// The design: its text, the underlined mistakes, and edits of single keys.

import { $, element } from "dom";

const area = $("text");
let keys = {};

export const text = () => area.value;

/** Puts in another text. */
export function put(design) {
  area.value = design;
  mark([]);
}

/** Underlines mistakes and lists them. */
export function show(answer) {
  keys = answer.keys ?? {};
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
export function mark(found) {
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

/** The value of a key as it is written; null where it is not given. */
export function given(key) {
  const at = keys[key]?.value;
  return at ? area.value.slice(...at) : null;
}

/** Gives a key another value, or adds it before the first table. */
export function give(key, value) {
  const at = keys[key]?.value;
  if (at) return replace(at, quotedLike(at, value));
  const tables = area.value.search(/^[ \t]*\[/m);
  const end = tables < 0 ? area.value.length : tables;
  const before = area.value.slice(0, end).trimEnd();
  const after = tables < 0 ? "\n" : "\n\n";
  area.value = `${before}\n${key} = ${value}${after}${area.value.slice(end)}`;
}

/** A place within quotes is that of what is quoted, so the quotes go with it. */
function quotedLike([start, end], value) {
  const within = area.value[start - 1] === '"' && area.value[end] === '"';
  return within && value.startsWith('"') ? value.slice(1, -1) : value;
}

/** Takes the line of a key away. */
export function take(key) {
  const at = keys[key];
  if (!at) return;
  const start = area.value.lastIndexOf("\n", at.key[0] - 1) + 1;
  const end = area.value.indexOf("\n", at.value[1]);
  replace([start, end < 0 ? area.value.length : end + 1], "");
}

/** Renames a key and gives it a value. */
export function rename(from, to, value) {
  const at = keys[from];
  if (at) replace([at.key[0], at.value[1]], `${to} = ${value}`);
  else give(to, value);
}

function replace([start, end], value) {
  area.value = area.value.slice(0, start) + value + area.value.slice(end);
}
