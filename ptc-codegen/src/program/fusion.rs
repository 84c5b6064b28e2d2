//! The product that a sum or a difference takes in, so that both are rounded once: one rule for programs and expressions.

/// The operand that is fused with the rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fusion {
    /// The first one.
    First,
    /// The second one.
    Second,
}

impl Fusion {
    /// The operand of a sum that is a product, and free: nothing else needs it.
    pub(crate) fn of_sum([first, second]: [bool; 2]) -> Option<Self> {
        match (first, second) {
            (_, true) => Some(Self::Second),
            (true, false) => Some(Self::First),
            (false, false) => None,
        }
    }

    /// The same of a difference. That of two products stays as it is: it is 0 where they are equal, and has the sign that
    /// they give, while with one of them unrounded it would be what the other was rounded by.
    pub(crate) fn of_difference(products: [bool; 2], free: [bool; 2]) -> Option<Self> {
        if products == [true, true] { None } else { Self::of_sum(free) }
    }
}
