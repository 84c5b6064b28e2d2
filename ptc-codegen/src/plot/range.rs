//! Range of an axis, and the format of its numbers.

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

/// Most decades of a logarithmic axis: what is smaller is nothing to be seen.
const DECADES: f64 = 12.0;

/// From the least to the greatest of powers of ten, at most so many decades.
pub(super) fn decades(powers: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    for power in powers.filter(|power| power.is_finite()) {
        (least, greatest) = (least.min(power), greatest.max(power));
    }
    match least <= greatest {
        true => (least.max(greatest - DECADES).floor(), (greatest + 0.1).ceil()),
        false => (-1.0, 1.0),
    }
}

/// A power of ten on an axis.
pub(super) fn power_of_ten(power: f64) -> String {
    match power.round() {
        power @ -2.0..=4.0 => label(10f64.powf(power)),
        power => format!("1e{power}"),
    }
}

/// A mark of an axis that shows `from` to `to`, whose 0 may be off by what rounding adds.
pub(super) fn mark(value: f64, (from, to): (f64, f64)) -> String {
    label(if value.abs() < 1e-9 * (to - from) { 0.0 } else { value })
}

/// A number in short.
pub(super) fn label(value: f64) -> String {
    if value == 0.0 {
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
    fn decades_are_rounded_outward() {
        assert_eq!(decades([-3.5, 0.2, f64::NEG_INFINITY].into_iter()), (-4.0, 1.0));
        assert_eq!(decades([-300.0, 1.0].into_iter()), (-11.0, 2.0));
        assert_eq!(decades(std::iter::empty()), (-1.0, 1.0));
        assert_eq!([-5.0, 0.0, 2.0].map(power_of_ten), ["1e-5", "1", "100"]);
    }

    #[test]
    fn labels_are_short() {
        for (value, shown) in [
            (0.1 + 0.2, "0.3"),
            (-2000.0, "-2000"),
            (0.0, "0"),
            (2e-15, "2e-15"),
            (2.5e-7, "2.5e-7"),
            (1e6, "1e6"),
            (5.0, "5"),
        ] {
            assert_eq!(label(value), shown);
        }
        assert_eq!(mark(1e-17, (0.0, 1.0)), "0");
        assert_eq!(mark(1e-17, (0.0, 5e-17)), "1e-17");
        assert_eq!(of([f64::NAN, 1.0, -1.0].into_iter()), (-1.12, 1.12));
        assert_eq!(of(std::iter::empty()), (-1.0, 1.0));
    }
}
