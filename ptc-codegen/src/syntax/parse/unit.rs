//! Numbers that were written with a unit: what they are without it.

use num_traits::{ToPrimitive, Zero};

use crate::algebra::{BigInt, BigRational};
use crate::keys::KeyInfo;
use crate::syntax::decimal;

/// Units of time and what they are in seconds, and rates by the Hz they are.
const TIMES: [(&str, i64, i64); 7] = [
    ("s", 1, 1),
    ("ms", 1, 1_000),
    ("us", 1, 1_000_000),
    ("ns", 1, 1_000_000_000),
    ("min", 60, 1),
    ("sec", 1, 1),
    ("h", 3600, 1),
];
const RATES: [(&str, i64); 4] = [("Hz", 1), ("hz", 1), ("kHz", 1_000), ("khz", 1_000)];

/// Prefixed units of states and inputs, each with its plain unit.
const OTHERS: [(&str, &str, i64, i64); 8] = [
    ("mm", "m", 1, 1_000),
    ("cm", "m", 1, 100),
    ("um", "m", 1, 1_000_000),
    ("km", "m", 1_000, 1),
    ("mrad", "rad", 1, 1_000),
    ("mV", "V", 1, 1_000),
    ("mA", "A", 1, 1_000),
    ("kN", "N", 1_000, 1),
];

/// Returns what to write for a number with a unit behind it, if the text of `key` is one.
pub(super) fn without_unit(key: &str, text: &str) -> Option<(String, String)> {
    let text = text.trim();
    let (number, unit) = parts(text)?;
    let is_time = KeyInfo::find(key).is_some_and(|info| info.meaning.contains(" in s"));
    let by = |above: i64, below: i64| &number * BigRational::new(above.into(), below.into());
    let (value, of) = if is_time {
        let time = TIMES.iter().find(|(name, ..)| *name == unit);
        let rate = RATES.iter().find(|(name, _)| *name == unit);
        match (time, rate) {
            (Some((_, above, below)), _) => (by(*above, *below), "seconds"),
            (None, Some((_, hertz))) if !number.is_zero() => {
                ((number * BigInt::from(*hertz)).recip(), "the period in seconds")
            }
            _ => return None,
        }
    } else if unit == "deg" {
        return Some((told(text), format!("in rad, without a unit: {}*pi/180", shown(&number)?)));
    } else {
        match OTHERS.iter().find(|(name, ..)| *name == unit) {
            Some((_, plain, above, below)) => (by(*above, *below), *plain),
            None if unit.chars().all(|c| c.is_ascii_alphabetic()) => (number.clone(), unit),
            None => return None,
        }
    };
    let of = if is_time { of.to_owned() } else { format!("in {of}") };
    Some((told(text), format!("{of}, without a unit: {}", shown(&value)?)))
}

fn told(text: &str) -> String {
    format!("`{}` has a unit", crate::diagnostic::shorten(text))
}

/// The number and the word behind it.
fn parts(text: &str) -> Option<(BigRational, &str)> {
    let is_unit = |c: char| c.is_ascii_alphabetic();
    let end = text.trim_end_matches(is_unit).len();
    let (number, unit) = text.split_at(end);
    // The e of an exponent is no unit.
    let number = decimal(number.trim_end())?;
    (!unit.is_empty() && !["e", "E", "i", "inf"].contains(&unit)).then_some((number, unit))
}

/// A number as one would type it.
fn shown(value: &BigRational) -> Option<String> {
    let near = value.to_f64()?;
    let plain = near == 0.0 || (1e-3..1e6).contains(&near.abs());
    Some(if plain { format!("{near}") } else { format!("{near:e}") })
}

#[cfg(test)]
mod tests {
    use super::without_unit;

    #[test]
    fn units_are_taken_off_numbers() {
        for (key, text, help) in [
            ("sample_time", "0.5ms", "seconds, without a unit: 5e-4"),
            ("sample_time", "2 kHz", "the period in seconds, without a unit: 5e-4"),
            ("tau", "20 s", "seconds, without a unit: 20"),
            ("noise", "5 mm", "in m, without a unit: 0.005"),
            ("u_max", "24 V", "in V, without a unit: 24"),
            ("x0_max", "30deg", "in rad, without a unit: 30*pi/180"),
        ] {
            assert_eq!(
                without_unit(key, text).map(|(_, help)| help).as_deref(),
                Some(help),
                "{text}"
            );
        }
        for text in ["5", "1e", "2i", "ms", "5 m/s", "x 5"] {
            assert_eq!(without_unit("tau", text), None, "{text}");
        }
    }
}
