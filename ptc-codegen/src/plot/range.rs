//! What an axis shows, and how its numbers are written.

/// From the least to the greatest of the values, 0 and a margin included.
pub(super) fn of(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut least, mut greatest) = (0.0_f64, 0.0_f64);
    for value in values.filter(|value| value.is_finite()) {
        (least, greatest) = (least.min(value), greatest.max(value));
    }
    let margin = 0.06 * (greatest - least);
    match margin > 0.0 {
        true => (least - margin, greatest + margin),
        false => (-1.0, 1.0),
    }
}

/// A number on an axis, without what rounding adds.
pub(super) fn label(value: f64) -> String {
    if value == 0.0 || value.abs() < 1e-12 {
        return "0".to_owned();
    }
    let text = match value.abs() {
        1e-3..1e5 => format!("{value:.4}"),
        _ => return format!("{value:.1e}").replace(".0e", "e"),
    };
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, shown) in [
            (0.1 + 0.2, "0.3"),
            (-2000.0, "-2000"),
            (1e-17, "0"),
            (2.5e-7, "2.5e-7"),
            (1e6, "1e6"),
            (5.0, "5"),
        ] {
            assert_eq!(label(value), shown);
        }
        assert_eq!(of([f64::NAN, 1.0, -1.0].into_iter()), (-1.12, 1.12));
        assert_eq!(of(std::iter::empty()), (-1.0, 1.0));
    }
}
