// Source text as it is read: numbered and coloured, its head folded.

import { element } from "dom";

const LINE = { c: "//", rust: "//", cpp: "//", matlab: "%", python: "#", st: "//", plcopen: null };
const WORDS = {
  c: "void|double|float|int|unsigned|const|static|struct|typedef|enum|if|else|for|while|do|return|sizeof|bool|uint32_t|int32_t|inline|include|define|ifndef|ifdef|endif",
  cpp: "void|double|float|int|const|static|struct|class|enum|if|else|for|while|do|return|bool|namespace|noexcept|constexpr|auto|private|public|template|using|include|pragma",
  rust: "fn|let|mut|pub|struct|enum|impl|use|mod|if|else|for|while|loop|match|return|const|static|self|Self|f64|f32|u32|i32|bool|usize|where|trait",
  python: "def|class|if|elif|else|for|while|return|import|from|as|in|not|and|or|None|True|False|raise|with|self|lambda|is",
  matlab: "function|end|if|else|elseif|for|while|return|switch|case|otherwise|classdef|properties|methods|true|false",
  st: "FUNCTION_BLOCK|END_FUNCTION_BLOCK|FUNCTION|END_FUNCTION|VAR|VAR_INPUT|VAR_OUTPUT|VAR_TEMP|END_VAR|IF|THEN|ELSIF|ELSE|END_IF|FOR|TO|DO|END_FOR|WHILE|END_WHILE|RETURN|LREAL|REAL|UDINT|DINT|BOOL|AND|OR|NOT|TRUE|FALSE|ARRAY|OF|CONSTANT|TYPE|END_TYPE",
  plcopen: "xml",
};

/** The languages whose comments span lines, and how. */
const BLOCK = { c: ["/*", "*/"], cpp: ["/*", "*/"], rust: ["/*", "*/"], st: ["(*", "*)"], python: ['"""', '"""'], matlab: ["%{", "%}"], plcopen: ["<!--", "-->"] };

/** Lines before the code that say what it needs. */
const PREAMBLE = { c: /^#/, cpp: /^#/, rust: /^(#!\[|use )/, python: /^(import|from) / };

const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

function grammar(language) {
  const [open, close] = BLOCK[language].map(escaped);
  const line = LINE[language] ? `|${escaped(LINE[language])}[^\\n]*` : "";
  const text = language === "matlab" ? "'[^'\\n]*'" : language === "rust" ? '"[^"\\n]*"' : "\"[^\"\\n]*\"|'[^'\\n]*'";
  return new RegExp(`(?<note>${open}[\\s\\S]*?${close}${line})|(?<text>${text})|(?<number>\\b\\d[\\w.]*(?:[eE][+-]\\d+)?)|(?<word>\\b(?:${WORDS[language]})\\b)`, "g");
}

/** The number of lines at the start that are comments, empty, or of the preamble. */
function head(lines, language) {
  const [open, close] = BLOCK[language];
  const line = LINE[language];
  let inside = false;
  for (const [i, text] of lines.entries()) {
    const bare = text.trim();
    if (inside) inside = !bare.includes(close);
    else if (bare.startsWith(open) && open !== close) inside = !bare.includes(close);
    else if (bare.startsWith(open)) inside = bare.indexOf(close, open.length) < 0;
    else if (bare && !(line && bare.startsWith(line)) && !PREAMBLE[language]?.test(bare)) return i;
  }
  return 0;
}

/** A file: its head behind a line that opens it, and the code. */
export function sheet(text, language) {
  const lines = text.split("\n");
  const count = head(lines, language);
  const first = coloured(lines.slice(0, count).concat(""), language, 0);
  const rest = coloured(lines.slice(count), language, count);
  const fold = count > 3
    ? [element("details", { class: "fold" }, element("summary", {}, `Head: ${count} lines`), first)]
    : count ? [first] : [];
  return element("div", { class: "sources" }, ...fold, rest);
}

/** Lines, the last of which is empty, with their numbers. */
function coloured(lines, language, before) {
  const rule = grammar(language);
  const text = lines.join("\n");
  const made = element("pre", { class: "code" });
  const gutter = element("span", { class: "gutter", "aria-hidden": "true" }, "");
  gutter.dataset.numbers = Array.from({ length: lines.length - 1 }, (_, i) => before + i + 1).join("\n");
  let last = 0;
  const parts = [];
  for (const match of text.matchAll(rule)) {
    const kind = Object.entries(match.groups).find(([, value]) => value !== undefined)[0];
    parts.push(text.slice(last, match.index), element("span", { class: kind }, match[0]));
    last = match.index + match[0].length;
  }
  parts.push(text.slice(last));
  made.append(gutter, element("code", {}, ...parts));
  return made;
}
