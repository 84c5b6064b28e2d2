//! Legal values of a parameter.

use super::Spec;
use crate::parameter::{Domain, Parameter, Precision};

impl Spec {
    /// Legal values of a parameter: the bounds that the user gave, else those of its kind. A
    /// parameter of a mapping is positive, as a rate or an exponent is.
    pub fn domain(&self, parameter: Parameter) -> Domain {
        if self.bounds.contains_key(&parameter) { Domain::Within } else { self.kind(parameter) }
    }

    /// Legal values of a parameter of its kind, whatever bounds the user gave.
    fn kind(&self, parameter: Parameter) -> Domain {
        let maps = self.custom().is_some_and(|custom| custom.parameters.contains(&parameter));
        match parameter {
            Parameter::Named(_) if maps => Domain::Positive,
            Parameter::UMax if self.u_min => Domain::AboveUMin,
            parameter => parameter.domain(),
        }
    }

    /// The least and the greatest value of a parameter with which the code keeps its digits; none
    /// where 0 or infinity is legal, or the user gave bounds. The exponent of the power mapping
    /// raises a rounded T/tau to the n m, which leaves n m times its rounding error.
    pub fn ends(&self, parameter: Parameter) -> Option<(f64, f64)> {
        if self.bounds.contains_key(&parameter) { None } else { self.ends_of_kind(parameter) }
    }

    /// Returns those ends, whatever bounds the user gave.
    pub(crate) fn ends_of_kind(&self, parameter: Parameter) -> Option<(f64, f64)> {
        // A count, and a hold of 0 samples.
        if self.sampled().is_some() && matches!(parameter, Parameter::Samples | Parameter::Eps) {
            return None;
        }
        let (least, greatest) = self.kind(parameter).ends(self.precision)?;
        let roundings = match self.precision {
            Precision::F64 => 450.0,
            Precision::F32 => 32.0,
        };
        #[allow(clippy::cast_precision_loss)]
        match parameter {
            Parameter::M => Some((least, (roundings / self.n as f64).floor())),
            Parameter::Start => Some((least_start(self.n, self.precision), 1.0)),
            _ => Some((least, greatest)),
        }
    }

    /// Returns true if `value`, a number of the precision, lies between those ends.
    pub fn keeps_digits(&self, parameter: Parameter, value: f64) -> bool {
        self.ends(parameter).is_none_or(|(least, greatest)| value >= least && value <= greatest)
    }

    /// The legal values of a parameter in words.
    pub fn legal(&self, parameter: Parameter) -> String {
        #[allow(clippy::cast_possible_truncation)]
        let text = |end: f64| match self.precision {
            Precision::F64 => format!("{end:e}"),
            Precision::F32 => format!("{:e}", end as f32),
        };
        if let Some((least, greatest)) = self.bounds.get(&parameter) {
            return format!("from {least} to {greatest}");
        }
        match (self.ends(parameter), self.domain(parameter)) {
            (Some((least, _)), Domain::BelowTau) => format!(">= {}, < tau", text(least)),
            (Some((least, greatest)), _)
                if matches!(parameter, Parameter::M | Parameter::Start) =>
            {
                format!("from {} to {greatest}", text(least))
            }
            (Some((least, greatest)), _) => format!("from {} to {}", text(least), text(greatest)),
            (None, domain) => domain.text().to_owned(),
        }
    }
}

/// The least `start` of the soft family. Far below 1e-12 the way on which time is stretched at all
/// is a rounding of tau. At the start y is 1/start^2, and gains hold terms up to
/// (2n - 2)!/(n - 1)! y^(n-1), which is to leave room for the other factors.
fn least_start(n: usize, precision: Precision) -> f64 {
    let (digits, room) = match precision {
        Precision::F64 => (12, 1e280),
        Precision::F32 => (5, 1e32),
    };
    let fits = |start: f64| {
        let mut left: f64 = room;
        for i in 1..n {
            left *= start * start / f64::from(u32::try_from(4 * i - 2).unwrap_or(u32::MAX));
        }
        left >= 1.0
    };
    let candidates = (1..=digits).rev().flat_map(|exponent| {
        [1, 2, 5].map(|digit| {
            let start = format!("{digit}e-{exponent}");
            match precision {
                Precision::F64 => start.parse().unwrap_or(1.0),
                Precision::F32 => f64::from(start.parse().unwrap_or(1.0_f32)),
            }
        })
    });
    candidates.into_iter().find(|start| fits(*start)).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smallest_start_grows_with_order() {
        let least = |n, precision| format!("{:e}", least_start(n, precision) as f32);
        let f64s = [1, 12, 13, 16].map(|n| least(n, Precision::F64));
        assert_eq!(f64s, ["1e-12", "1e-12", "1e-11", "5e-9"]);
        let f32s = [1, 3, 4, 5, 8, 12, 16].map(|n| least(n, Precision::F32));
        assert_eq!(f32s, ["1e-5", "1e-5", "2e-5", "5e-4", "2e-2", "2e-1", "5e-1"]);
    }
}
