//! Protocol between the engine and the program that asks it: an answer is a line, an expression is words between
//! spaces, operands before operators.
//!
//! A number `3/4`, a symbol `v2` by its place in a list that only the asking side has, a sum `+3` and a
//! product `*3` of so many operands, a power `^`, and functions of one operand by their names. Flat
//! text needs no bound on its depth.

/// The prefix of an answer: all other lines are Symbolica's own messages.
pub(super) const MARK: &str = "ptc-answer: ";

/// The exit code of the engine for a request that it does not understand.
pub(super) const REFUSED: u8 = 3;

/// Target into which expressions are read.
pub(super) trait Target {
    /// The result.
    type Value;
    /// An exact number.
    fn number(&self, text: &str) -> Option<Self::Value>;
    /// The symbol at a place of the list.
    fn symbol(&self, place: usize) -> Option<Self::Value>;
    /// A sum.
    fn sum(&self, terms: Vec<Self::Value>) -> Option<Self::Value>;
    /// A product.
    fn product(&self, factors: Vec<Self::Value>) -> Option<Self::Value>;
    /// A power.
    fn power(&self, base: Self::Value, exponent: Self::Value) -> Option<Self::Value>;
    /// A function of one operand.
    fn call(&self, name: &str, operand: Self::Value) -> Option<Self::Value>;
}

/// Reads an expression; `None` for what is none, or has no meaning in the target.
pub(super) fn read<T: Target>(text: &str, target: &T) -> Option<T::Value> {
    let mut stack = Vec::new();
    for word in text.split_ascii_whitespace() {
        let (head, rest) = word.split_at(1);
        let value = match head {
            "v" => target.symbol(rest.parse().ok()?)?,
            "+" | "*" => {
                let at = stack.len().checked_sub(rest.parse().ok()?)?;
                let operands = stack.split_off(at);
                if head == "+" { target.sum(operands)? } else { target.product(operands)? }
            }
            "^" => {
                let exponent = stack.pop()?;
                target.power(stack.pop()?, exponent)?
            }
            _ if word.starts_with(|c: char| c == '-' || c.is_ascii_digit()) => {
                target.number(word)?
            }
            _ => {
                let operand = stack.pop()?;
                target.call(word, operand)?
            }
        };
        stack.push(value);
    }
    let result = stack.pop()?;
    stack.is_empty().then_some(result)
}
