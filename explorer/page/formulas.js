// Formulas as MathML, from the text in which the heads of the files have them.

import { element, short } from "dom";

const SPACE = "http://www.w3.org/1998/Math/MathML";
const GREEK = { kappa: "\u03ba", mu: "\u03bc", tau: "\u03c4", pi: "\u03c0", eps: "\u03b5", xi: "\u03be", alpha: "\u03b1", beta: "\u03b2", lambda: "\u03bb", omega: "\u03c9", rho: "\u03c1", sigma: "\u03c3", phi: "\u03c6", Dt: "\u0394t", theta: "\u03b8" };
const FUNCTIONS = ["ln", "exp", "sqrt", "sin", "cos", "tan", "atan", "tanh", "abs", "sign", "min", "max", "log", "cosh", "sinh", "asin", "acos"];

function math(name, ...children) {
  const made = document.createElementNS(SPACE, name);
  made.append(...children);
  return made;
}

const operator = (text) => math("mo", text);

/** A name with its index: `x1`, `b_2`, `B_{0,1}`, `kappa'`. */
function named(text) {
  const [, bare, primes] = /^(.*?)('*)$/.exec(text);
  const [, letters, , braced, index, digits] = /^([A-Za-z]+)((?:_\{([^}]*)\})|_(\w+))?(\d+)?$/.exec(bare) ?? [null, bare];
  const base = math("mi", GREEK[letters] ?? letters);
  const own = braced ?? index ?? digits;
  const dashes = primes && operator("\u2032".repeat(primes.length));
  if (own === undefined) return primes ? math("msup", base, dashes) : base;
  const sub = math(/^\d+$/.test(own) ? "mn" : "mi", GREEK[own] ?? own);
  return primes ? math("msubsup", base, sub, dashes) : math("msub", base, sub);
}

/** Reads infix text; throws where it is none. */
class Reader {
  constructor(text) {
    this.tokens = [...text.matchAll(/\s*(\d+(?:\.\d+)?(?:e[-+]?\d+)?|[A-Za-z][A-Za-z0-9]*(?:_\{[^}]*\}|_\w+)?'*|<=|>=|.)/g)].map((match) => match[1]);
    this.at = 0;
  }

  get next() {
    return this.tokens[this.at];
  }

  take(...wanted) {
    if (!wanted.includes(this.next)) return null;
    this.at += 1;
    return this.tokens[this.at - 1];
  }

  need(token) {
    if (!this.take(token)) throw new Error(`no ${token}`);
  }

  relation() {
    const parts = [this.sum()];
    for (let sign = this.take("=", "<", ">", "<=", ">=", ":"); sign; sign = this.take("=", "<", ">", "<=", ">=", ":")) {
      parts.push(operator({ "<=": "\u2264", ">=": "\u2265" }[sign] ?? sign), this.sum());
    }
    return math("mrow", ...parts);
  }

  sum() {
    const parts = [];
    const lead = this.take("-", "+");
    if (lead) parts.push(operator(lead === "-" ? "\u2212" : "+"));
    parts.push(this.product());
    for (let sign = this.take("+", "-"); sign; sign = this.take("+", "-")) parts.push(operator(sign === "-" ? "\u2212" : "+"), this.product());
    return parts.length === 1 ? parts[0] : math("mrow", ...parts);
  }

  product() {
    let left = [this.power()];
    for (;;) {
      if (this.take("*")) left.push(operator("\u2062"), this.power());
      else if (this.take("/")) left = [math("mfrac", math("mrow", ...left), bare(this.power()))];
      else if (this.next && /^[A-Za-z(\d]/.test(this.next) && !/^(for|if|with|and|or|where|in|to)$/.test(this.next)) left.push(operator("\u2062"), this.power());
      else return left.length === 1 ? left[0] : math("mrow", ...left);
    }
  }

  power() {
    const base = this.atom();
    if (!this.take("^")) return base;
    const sign = this.take("-");
    const up = this.power();
    // `r^(2)` is a derivative, and keeps its parentheses.
    const inner = up.inner && /^\d+$/.test(up.inner.textContent) ? up : bare(up);
    return math("msup", base, sign ? math("mrow", operator("\u2212"), inner) : inner);
  }

  atom() {
    const token = this.next;
    if (token === undefined) throw new Error("no value");
    if (this.take("(")) return this.list("(", ")");
    if (this.take("[")) return this.list("[", "]");
    if (this.take("-")) return math("mrow", operator("\u2212"), this.power());
    if (/^\d/.test(token)) {
      this.at += 1;
      return math("mn", token);
    }
    if (!/^[A-Za-z]/.test(token)) throw new Error(`no value: ${token}`);
    this.at += 1;
    if (token === "sqrt" && this.take("(")) return math("msqrt", bare(this.list("(", ")")));
    const name = named(token);
    if (!this.take("(")) return name;
    const of = this.list("(", ")");
    return math("mrow", name, ...(FUNCTIONS.includes(token) ? [operator("\u2061")] : []), of);
  }

  /** What is between brackets, and a matrix where the parts are lists. */
  list(open, close) {
    const parts = [];
    while (this.next !== close) {
      parts.push(this.relation());
      if (!this.take(",", ";")) break;
    }
    this.need(close);
    const rows = parts.map((part) => (part.childNodes.length === 1 ? part.firstChild : part));
    if (open === "[" && rows.length && rows.every((row) => row.parts)) return table(rows.map((row) => row.parts));
    const between = parts.flatMap((part, i) => (i ? [operator(","), part] : [part]));
    const made = math("mrow", operator(open), ...between, operator(close));
    made.parts = open === "[" ? parts : null;
    made.inner = parts.length === 1 ? parts[0] : null;
    return made;
  }
}

/** What parentheses hold, where a fraction or a root makes them superfluous. */
function bare(made) {
  return made.inner ?? made;
}

function table(rows) {
  return math("mrow", operator("["), math("mtable", ...rows.map((row) => math("mtr", ...row.map((entry) => math("mtd", entry))))), operator("]"));
}

/** A line as a formula; null where it is a sentence. */
function typeset(line) {
  try {
    const reader = new Reader(line);
    const made = reader.relation();
    if (reader.at < reader.tokens.length) return null;
    return block(made);
  } catch {
    return null;
  }
}

/** A line of a head: indented ones are formulas, others sentences. */
function line(text) {
  if (!text.trim()) return [];
  const samples = inWords(text);
  if (samples) return [element("p", { class: "sentence" }, samples[0]), samples[1], element("p", { class: "sentence" }, samples[2])];
  if (!/^\s/.test(text)) return [element("p", { class: "sentence" }, text)];
  const [, body, note] = /^\s*(.*?)(?:, ((?:with|where|by) .*))?$/.exec(text);
  const made = typeset(body);
  if (!made) return [element("p", { class: "plain" }, text.trim())];
  return [made, ...(note ? [element("p", { class: "hint" }, note)] : [])];
}

/** The law in samples, of which the head has a formula within a sentence: what is before it, the formula, what is after. */
function inWords(text) {
  const found = /^(.*?)u(?: h(?:\^(\d+))?)? = sum of row_j z_j h\^\(j-1\)\/\(\(M-j\+1\)\.\.\.\((M(?:-\d+)?)\)\)(.*)$/.exec(text);
  if (!found) return null;
  const [, before, power, last, after] = found;
  const n = power ?? "1";
  const left = math("mrow", math("mi", "u"), operator("\u2062"), n === "1" ? math("mi", "h") : math("msup", math("mi", "h"), math("mn", n)));
  const under = [typeset("(M-j+1)"), typeset(`(${last})`)].map((one) => one.firstChild);
  const sum = math("munder", operator("\u2211"), math("mi", "j"));
  const term = math("mfrac", typeset("row_j*z_j*h^(j-1)").firstChild, math("mrow", under[0], operator("\u22ef"), under[1]));
  return [`${before.trim().replace(/,$/, "")}:`, block(left, operator("="), sum, term), after.replace(/^[;,.]\s*/, "")];
}

function block(...parts) {
  const whole = math("math", ...parts);
  whole.setAttribute("display", "block");
  return whole;
}

/** The numbers of a law in samples. */
function inSamples({ s, rows }) {
  const number = (value) => math("mn", short(value, 6).replace("-", "\u2212"));
  const row = (value, j) => block(math("msub", math("mi", "row"), math("mn", String(j + 1))), operator("="), typeset(value).firstChild);
  return [block(math("mi", "z"), operator("="), table(s.map((line) => line.map(number))), math("mi", "x")), ...rows.map(row)];
}

/** All formulas of an answer. */
export function formulas(answer) {
  const lines = answer.formulas ?? [];
  const law = answer.law ? inSamples(answer.law) : [];
  return element("div", { class: "formulas" }, ...lines.flatMap(line), ...law);
}
