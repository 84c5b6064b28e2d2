//! The loops over the powers of a series, and those of an elimination.

use super::super::elimination;
use super::super::powers::{Words, powers};
use super::super::text::Text;
use super::C;
use crate::code::Shape;

impl C<'_> {
    /// The function that forms so many rows.
    pub(super) fn rows_function(&mut self, weights: usize, fused: bool) {
        let (name, real, tail) = (&self.code.name, self.type_of(Shape::Real), weights - 1);
        let pointer = format!("{real} *f");
        let words = Words { real: &real, pointer: &pointer, index: "uint32_t", powers: ["p", "q"] };
        let lines = powers(self, &words, weights, fused);
        self.out.line(format!(
            "
/* Loops over the powers of the Taylor series of mu, for the gains of all states at once. */
static void {name}_rows({real} row[{weights}], const {real} p[{tail}])"
        ));
        self.out.open("{");
        self.out.line(format!("{real} q[{}]; /* p^2 */\n", tail - 1));
        self.out.line(lines.text().trim_end());
        self.out.close("}");
    }

    /// The function that solves so many equations.
    pub(super) fn elimination_function(&mut self, m: usize) {
        let (name, real) = (&self.code.name, self.type_of(Shape::Real));
        let words = elimination::Words {
            real: &real,
            index: "uint32_t",
            size: &|element| self.abs(element),
            zero: &self.literal("0.0"),
            nan: &format!("({real})NAN"),
        };
        let lines = elimination::lines(&words, m);
        self.out.line(format!(
            "
/* Solves a x = b, with a row by row, by elimination with the largest pivot of each column: x stands in b.
 * It is no number where a is singular. */
static void {name}_eliminate({real} a[{}], {real} b[{m}])",
            m * m
        ));
        self.out.open("{");
        self.out.line(lines.text().trim_end());
        self.out.close("}");
    }
}
