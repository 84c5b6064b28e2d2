//! The loops of an elimination in C and C++.

use super::text::Lines;

/// How a language writes them.
pub(super) struct Words<'a> {
    pub(super) real: &'a str,
    /// The type of indices.
    pub(super) index: &'a str,
    /// The absolute value of an element.
    pub(super) size: &'a dyn Fn(&str) -> String,
    pub(super) zero: &'a str,
    pub(super) nan: &'a str,
}

/// Solves a x = b for `m` unknowns in place: what stands in b is x.
pub(super) fn lines(words: &Words<'_>, m: usize) -> Lines {
    let Words { real, index, zero, nan, .. } = words;
    let mut out = Lines::default();
    let at = |row: &str, column: &str| format!("a[({m}U * {row}) + {column}]");
    let pivot = at("k", "k");
    let each = |variable: &str, from: &str| {
        format!("for ({index} {variable} = {from}; {variable} < {m}U; {variable}++) {{")
    };
    out.open(each("k", "0U"));
    out.line(format!("{index} most = k;\n{real} kept = b[k];\n"));
    out.open(each("i", "k + 1U"));
    let [largest, other] = [at("most", "k"), at("i", "k")].map(|element| (words.size)(&element));
    out.line(format!("if ({largest} < {other}) {{\n    most = i;\n}}"));
    out.close("}");
    out.line("b[k] = b[most];\nb[most] = kept;");
    out.open(each("j", "k"));
    let [own, most] = [at("k", "j"), at("most", "j")];
    out.line(format!("kept = {own};\n{own} = {most};\n{most} = kept;"));
    out.close("}");
    out.line(format!(
        "if (!(({pivot} < {zero}) || ({pivot} > {zero}))) {{\n    {pivot} = {nan};\n}}"
    ));
    out.open(each("i", "k + 1U"));
    out.line(format!("const {real} factor = {} / {pivot};\n", at("i", "k")));
    out.open(each("j", "k + 1U"));
    out.line(format!("{} = {} - (factor * {own});", at("i", "j"), at("i", "j")));
    out.close("}");
    out.line("b[i] = b[i] - (factor * b[k]);");
    out.close("}");
    out.close("}");
    out.open(format!("for ({index} n = {m}U; n > 0U; n--) {{"));
    out.line(format!("const {index} k = n - 1U;\n"));
    out.open(each("j", "n"));
    out.line(format!("b[k] = b[k] - ({own} * b[j]);"));
    out.close("}");
    out.line(format!("b[k] = b[k] / {pivot};"));
    out.close("}");
    out
}
