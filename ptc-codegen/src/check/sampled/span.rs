//! Least and greatest values, in doubles that are rounded by whoever adds to them.

/// Interval of a value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Span {
    /// Its least value.
    pub low: f64,
    /// Its greatest value.
    pub high: f64,
}

impl Span {
    /// All numbers.
    pub(super) const ALL: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// All values of at most this size.
    pub(crate) fn of_size(size: f64) -> Self {
        Self { low: -size, high: size }
    }

    /// The greatest size.
    pub fn size(self) -> f64 {
        self.high.max(-self.low)
    }

    /// Returns the smallest interval that holds both.
    #[must_use]
    pub(crate) fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Returns the intersection of both.
    #[must_use]
    pub(crate) fn common(self, other: Self) -> Self {
        Self { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// The same and everything up to a distance of it.
    #[must_use]
    pub(crate) fn wider(self, by: f64) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }
}

/// The hulls of pairs.
pub(crate) fn hulls(a: &[Span], b: &[Span]) -> Vec<Span> {
    a.iter().zip(b).map(|(a, b)| a.hull(*b)).collect()
}

/// The sizes of spans.
pub(super) fn sizes(spans: &[Span]) -> Vec<f64> {
    spans.iter().map(|span| span.size()).collect()
}
