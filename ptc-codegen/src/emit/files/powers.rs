//! The loops over the powers of a series, in C and C++: those of short sums are written out, as a round of
//! such a loop takes longer than the product in it.

use super::text::{Lines, Text};

/// The longest sum that is written out: all of them at n = 9. The code of a step of `exp_sum` then takes 2623
/// bytes there and 3583 at n = 16, and 3394 and 4645 with three rates and full guard.
const WRITTEN: usize = 8;

/// The words of a language.
pub(super) struct Words<'a> {
    /// Type of the numbers.
    pub(super) real: &'a str,
    /// A pointer f to them.
    pub(super) pointer: &'a str,
    /// Type of an index.
    pub(super) index: &'a str,
    /// The arrays of the coefficients of p and of p^2, as pointers.
    pub(super) powers: [&'a str; 2],
}

/// What forms `row`, of so many weights, from p, with the array q at hand.
pub(super) fn powers(text: &impl Text, words: &Words<'_>, weights: usize, fused: bool) -> Lines {
    let Words { real, pointer, index, powers: [p, q] } = words;
    let (tail, part) = (weights - 1, weights - 2);
    let more = |sum: &str, a: &str, b: &str| {
        let operands = [a, b, sum].map(str::to_owned);
        match text.fused(&operands).filter(|_| fused) {
            Some(fused) => format!("{sum} = {fused};"),
            None => format!("{sum} += {a} * {b};"),
        }
    };
    let mut out = Lines::default();
    let written = part.min(WRITTEN + 1);
    for k in 0..written {
        let sum = format!("q[{k}]");
        out.line(format!("{sum} = p[{k}] + p[{k}];"));
        for m in 0..k {
            out.line(more(&sum, &format!("p[{m}]"), &format!("p[{}]", k - m - 1)));
        }
    }
    if written < part {
        out.line(format!(
            "for ({index} k = {written}U; k < {part}U; k++) {{
    {real} v = p[k] + p[k];
    for ({index} m = 0U; m < k; m++) {{
        {}
    }}
    q[k] = v;
}}",
            more("v", "p[m]", "p[k - m - 1U]")
        ));
    }
    out.open(format!("for ({index} round = 0U; round < {tail}U; round += 2U) {{"));
    out.line(format!("const {pointer} = {p};"));
    let long = tail.saturating_sub(WRITTEN).next_multiple_of(2);
    if long > 0 {
        out.line(format!(
            "for ({index} k = round; k < {long}U; k++) {{
    {real} v = row[k];
    for ({index} m = k + 1U; m < {weights}U; m++) {{
        {}
    }}
    row[k] = v;
    f = {q};
}}",
            more("v", "f[m - k - 1U]", "row[m]")
        ));
    }
    for at in (long..tail).step_by(2) {
        out.line("");
        // No round is behind the last sums.
        let is_last = at + 2 >= tail;
        match at {
            _ if is_last => {}
            0 => out.open("if (round == 0U) {"),
            at => out.open(format!("if (round <= {at}U) {{")),
        }
        let both = [("v", "f", at), ("w", "q", at + 1)];
        for (sum, power, at) in both.into_iter().filter(|(.., at)| *at < tail) {
            out.line(format!("{real} {sum} = row[{at}];"));
            for m in at + 1..weights {
                out.line(more(sum, &format!("{power}[{}]", m - at - 1), &format!("row[{m}]")));
            }
            out.line(format!("row[{at}] = {sum};"));
        }
        if !is_last {
            out.line(format!("f = {q};"));
            out.close("}");
        }
    }
    out.close("}");
    out
}
