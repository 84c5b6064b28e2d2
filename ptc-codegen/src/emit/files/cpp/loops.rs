//! The loops over the powers of a series, and those of an elimination.

use super::super::elimination;
use super::super::powers::{Words, powers};
use super::super::text::Text;
use super::Cpp;

impl Cpp<'_> {
    /// The function that forms so many rows.
    pub(super) fn rows_function(&mut self, weights: usize, fused: bool) {
        let (real, tail) = (self.real_type(), weights - 1);
        let pointer = format!("{real}* f");
        let powers_of = ["p.data()", "q.data()"];
        let words = Words { real, pointer: &pointer, index: "std::size_t", powers: powers_of };
        let lines = powers(self, &words, weights, fused);
        // std::fma is not constant.
        let constant = if fused { "" } else { "constexpr " };
        self.out.line(format!(
            "
/// Loops over the powers of the Taylor series of mu, for the gains of all states at once.
static {constant}std::array<{real}, {weights}> rows(
    std::array<{real}, {weights}> row, const std::array<{real}, {tail}>& p) noexcept"
        ));
        self.out.open("{");
        self.out.line(format!("std::array<{real}, {}> q{{}}; // p^2", tail - 1));
        self.out.line(lines.text().trim_end());
        self.out.line("return row;");
        self.out.close("}");
    }

    /// The function that solves so many equations.
    pub(super) fn elimination_function(&mut self, m: usize) {
        let (real, zero) = (self.real_type(), self.literal("0.0"));
        let size = |element: &str| format!("(({element} < {zero}) ? -{element} : {element})");
        let words = elimination::Words {
            real,
            index: "std::size_t",
            size: &size,
            zero: &zero,
            nan: &format!("std::numeric_limits<{real}>::quiet_NaN()"),
        };
        let lines = elimination::lines(&words, m);
        self.out.line(format!(
            "
/// Solves a x = b, with a row by row, by elimination with the largest pivot of each column. No numbers where
/// a is singular.
static constexpr std::array<{real}, {m}> eliminate(
    std::array<{real}, {}> a, std::array<{real}, {m}> b) noexcept",
            m * m
        ));
        self.out.open("{");
        self.out.line(lines.text().trim_end());
        self.out.line("return b;");
        self.out.close("}");
    }
}
