//! The loops over the powers of a series.

use super::super::powers::{Words, powers};
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
}
