//! The reference vectors of tests/data.

use std::fs;
use std::path::Path;

use ptc_assure::context::workspace;
use ptc_codegen::family::{FAMILIES, Family};
use serde_json::Value;

/// One line of a file; see tests/data/README.md.
#[derive(Clone, Debug)]
pub(crate) struct Vector {
    pub(crate) family: Family,
    pub(crate) n: usize,
    pub(crate) a: f64,
    pub(crate) m: f64,
    pub(crate) start: f64,
    pub(crate) rates: Vec<f64>,
    pub(crate) tau: f64,
    pub(crate) t0: f64,
    pub(crate) t: f64,
    pub(crate) x: Vec<f64>,
    pub(crate) k: Vec<f64>,
    pub(crate) u: f64,
    pub(crate) scale: f64,
    /// BB_n x and b_n, where the file holds them.
    pub(crate) xi: Vec<f64>,
    pub(crate) b: Vec<f64>,
}

impl Vector {
    /// The exact time-to-go (t0 + tau) - t, rounded once or twice.
    pub(crate) fn time_to_go(&self) -> f64 {
        let high = self.t0 + self.tau;
        let part = high - self.t0;
        let low = (self.t0 - (high - part)) + (self.tau - part);
        (high - self.t) + low
    }

    /// Its parameters, held at `eps` of tau and without a bound of u.
    pub(crate) fn values(&self, eps: f64) -> super::specs::Values<'_> {
        super::specs::Values {
            tau: self.tau,
            t0: self.t0,
            eps: eps * self.tau,
            u_max: f64::INFINITY,
            a: self.a,
            m: self.m,
            start: self.start,
            rates: &self.rates,
            k: &self.k,
        }
    }
}

/// All vectors of a file in tests/data.
pub(crate) fn read(file: &str) -> Vec<Vector> {
    lines(file).into_iter().map(|(vector, _)| vector).collect()
}

/// The same, each with all digits of its u.
pub(crate) fn lines(file: &str) -> Vec<(Vector, String)> {
    let path = workspace().join("tests/data").join(file);
    let text = fs::read_to_string(&path).expect("a file of vectors");
    let digits = |line: &str| {
        let line: Value = serde_json::from_str(line).expect("JSON");
        line["u"].as_str().expect("u as a string").to_owned()
    };
    let vectors: Vec<_> = text.lines().map(|line| (vector(line), digits(line))).collect();
    assert!(vectors.len() > 300, "{} holds {} vectors", path.display(), vectors.len());
    vectors
}

fn vector(line: &str) -> Vector {
    let line: Value = serde_json::from_str(line).expect("JSON");
    let family = line["mu"].as_str().expect("a family");
    let info = FAMILIES.iter().find(|info| info.name == family).expect("a known family");
    let params = &line["params"];
    Vector {
        family: info.family,
        n: numbers(&line["x"]).len(),
        a: params["a"].as_f64().unwrap_or(f64::NAN),
        m: params["m"].as_f64().unwrap_or(f64::NAN),
        start: params["start"].as_f64().unwrap_or(f64::NAN),
        rates: numbers(&params["rates"]),
        tau: number(&line["tau"]),
        t0: number(&line["t0"]),
        t: number(&line["t"]),
        x: numbers(&line["x"]),
        k: numbers(&line["k"]),
        u: number(&line["u"]),
        scale: number(&line["scale"]),
        xi: numbers(&line["xi"]),
        b: numbers(&line["b"]),
    }
}

/// A number, written as one or as a string of digits.
fn number(value: &Value) -> f64 {
    let text = value.as_str().map(|text| text.parse().expect("a decimal number"));
    text.or_else(|| value.as_f64()).expect("a number")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().map(|items| items.iter().map(number).collect()).unwrap_or_default()
}
