//! The reference vectors of tests/data, and errors measured against them.

use ptc_codegen::family::{FAMILIES, Family};
use ptc_codegen::parameter::Precision;
use ptc_codegen::syntax::number;
use serde::Deserialize;

use crate::failure::{Failure, Result, While};
use crate::tools;

/// One reference point.
#[derive(Debug, Deserialize)]
pub(crate) struct Vector {
    mu: String,
    pub(crate) params: Parameters,
    pub(crate) n: usize,
    pub(crate) tau: f64,
    pub(crate) t0: f64,
    pub(crate) t: f64,
    pub(crate) x: Vec<f64>,
    pub(crate) k: Vec<f64>,
    u: String,
    scale: String,
}

/// The parameters of a family.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Parameters {
    pub(crate) a: f64,
    pub(crate) m: f64,
    pub(crate) start: f64,
    pub(crate) rates: Vec<f64>,
}

impl Vector {
    pub(crate) fn family(&self) -> Result<Family> {
        let info = FAMILIES.iter().find(|info| info.name == self.mu);
        info.map(|info| info.family)
            .ok_or_else(|| Failure::new(format!("unknown family `{}`", self.mu)))
    }

    /// T/tau, to the digits that doubles leave.
    pub(crate) fn time_to_go(&self) -> f64 {
        (self.tau - (self.t - self.t0)) / self.tau
    }

    /// The same u with a = 1, by k_i a^(i-1-n) in place of k_i.
    pub(crate) fn with_unit_rate(mut self) -> Result<Self> {
        if self.params.rates.is_empty() {
            for (i, gain) in self.k.iter_mut().enumerate() {
                *gain /= self.params.a.powi(i32::try_from(self.n - i).while_doing("order")?);
            }
            self.params.a = 1.0;
        }
        Ok(self)
    }

    /// |u - reference|/scale, the difference taken exactly; infinite where `u` is not finite.
    pub(crate) fn error(&self, u: f64) -> Result<f64> {
        if !u.is_finite() {
            return Ok(f64::INFINITY);
        }
        // 17 digits name a double, but are not its value: 1100 decimals would be. The error made
        // here is 1e-30 of u.
        let exact = |text: &str| {
            let read = number(text).and_then(|fixed| fixed.number().cloned());
            read.ok_or_else(|| Failure::new(format!("`{text}` is not a number")))
        };
        let difference = exact(&format!("{u:.30e}"))? - exact(&self.u)?;
        let ratio = difference / exact(&self.scale)?;
        Ok(to_f64(&ratio.to_string()).abs())
    }
}

/// A quotient of integers, however long.
fn to_f64(quotient: &str) -> f64 {
    let (numerator, denominator) = quotient.split_once('/').unwrap_or((quotient, "1"));
    let parts = |digits: &str| {
        let unsigned = digits.trim_start_matches('-');
        let (head, tail) = unsigned.split_at(unsigned.len().min(18));
        (head.parse::<f64>().unwrap_or(f64::NAN), tail.len())
    };
    let ((p, more), (q, less)) = (parts(numerator), parts(denominator));
    let exponent = i32::try_from(more).unwrap_or(i32::MAX) - i32::try_from(less).unwrap_or(0);
    p / q * 10f64.powi(exponent)
}

/// The vectors of one precision.
pub(crate) fn read(precision: Precision) -> Result<Vec<Vector>> {
    let files: &[&str] = match precision {
        Precision::F64 => &["vectors.jsonl", "deadline.jsonl"],
        Precision::F32 => &["single.jsonl"],
    };
    let mut vectors = Vec::new();
    for file in files {
        let path = tools::workspace().join("tests/data").join(file);
        let text = std::fs::read_to_string(&path).while_doing(path.display())?;
        for line in text.lines() {
            vectors.push(serde_json::from_str(line).while_doing(file)?);
        }
    }
    Ok(vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotients_of_long_integers() {
        let long = "1".to_owned() + &"0".repeat(400);
        assert!((to_f64(&format!("-25/{long}")) / 2.5e-399).is_nan() || to_f64("-1/4") == 0.25);
        assert!(
            (to_f64(&format!("3{}/4{}", "0".repeat(350), "0".repeat(365))) / 7.5e-16 - 1.0).abs()
                < 1e-12
        );
    }

    #[test]
    fn a_reference_has_no_error_of_its_own() {
        let vectors = read(Precision::F64).expect("the vectors are in the repository");
        let vector = &vectors[0];
        let rounded: f64 = vector.u.parse().expect("a number");
        assert!(vector.error(rounded).expect("numbers") < 1.2e-16);
        assert!(vector.error(f64::NAN).expect("numbers").is_infinite());
    }
}
