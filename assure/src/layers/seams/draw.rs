//! Random designs of every kind.

mod kinds;

use super::design::{Design, Line, MODEL, PARAMS, Value};
use crate::harness::random::Random;
use kinds::KINDS;

/// `count` designs, each kind in turn.
pub(super) fn designs(seed: u64, count: usize) -> Vec<Design> {
    (0..count).map(|index| design(seed, index)).collect()
}

fn design(seed: u64, index: usize) -> Design {
    let (kind, draw) = KINDS[index % KINDS.len()];
    let mut random = Random(seed.wrapping_mul(0x0100_0001) ^ index as u64);
    let mut draft = Draft { lines: Vec::new(), states: Vec::new(), hidden: 0, random: &mut random };
    draw(&mut draft);
    draft.finished(format!("seam{index}"), kind)
}

/// A design under way.
struct Draft<'a> {
    lines: Vec<Line>,
    states: Vec<String>,
    hidden: usize,
    random: &'a mut Random,
}

impl Draft<'_> {
    fn chance(&mut self, percent: u64) -> bool {
        self.random.below(100) < percent
    }

    fn of<'t>(&mut self, all: &[&'t str]) -> &'t str {
        all[self.random.below(all.len() as u64) as usize]
    }

    /// A number with three digits behind the point, so that its text is its value.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        (self.random.between(low, high) * 1000.0).round() / 1000.0
    }

    fn order(&mut self, most: u64) -> usize {
        1 + self.random.below(most) as usize
    }

    fn line(&mut self, table: &'static str, key: &'static str, value: Value) {
        self.lines.push(Line { table, key, value });
    }

    fn plain(&mut self, key: &'static str, value: impl Into<String>) {
        self.line("", key, Value::Plain(value.into()));
    }

    fn word(&mut self, key: &'static str, value: &str) {
        self.plain(key, format!("\"{value}\""));
    }

    fn formula(&mut self, key: &'static str, all: &[&str]) {
        let formula = self.of(all).to_owned();
        self.line("", key, Value::Formula(formula));
    }

    fn poles(&mut self, key: &'static str, count: usize) {
        let poles = self.listed_poles(count);
        self.plain(key, poles);
    }

    fn listed_poles(&mut self, count: usize) -> String {
        let all: Vec<_> = (0..count).map(|_| format!("-{}", self.number(0.6, 7.0))).collect();
        format!("[{}]", all.join(", "))
    }

    /// A chain of integrators.
    fn chain(&mut self, n: usize) {
        self.plain("n", n.to_string());
        self.states = (1..=n).map(|i| format!("x{i}")).collect();
    }

    fn family(&mut self) {
        let mu = self.of(&[
            "exp(a=1)",
            "exp(a=1)",
            "rational(a=1)",
            "tan(a=1)",
            "tanh(a=1)",
            "power(a=1,m=2)",
        ]);
        self.word("mu", mu);
    }

    fn samples(&mut self) {
        self.word("mu", "exp(a=1)");
        self.word("clock", "samples");
    }

    /// Adds a model with one input, a line for each key.
    fn model(&mut self, states: &[&str], input: &str, output: &str, rates: &[&str]) {
        self.states = states.iter().map(|state| (*state).to_owned()).collect();
        let list = states.iter().map(|state| format!("\"{state}\"")).collect::<Vec<_>>().join(", ");
        self.line(MODEL, "states", Value::Plain(format!("[{list}]")));
        self.line(MODEL, "input", Value::Plain(format!("\"{input}\"")));
        self.line(MODEL, "output", Value::Formula(output.to_owned()));
        let rates = rates.iter().map(|rate| (*rate).to_owned()).collect();
        self.line(MODEL, "dynamics", Value::Formulas(rates));
    }

    /// Bounds of the states as a design gives them: of axes those of one, of several outputs a row for each.
    fn bounds(&self, all: &[String]) -> String {
        let gives = |key: &str| self.lines.iter().any(|line| line.key == key);
        match (gives("axes"), gives("outputs")) {
            (true, _) => format!("[{}]", all[..all.len() / 2].join(", ")),
            (_, true) => format!("[[{}], [{}]]", all[..2].join(", "), all[2..].join(", ")),
            _ => format!("[{}]", all.join(", ")),
        }
    }

    /// Adds the lines that designs of all kinds share: the period, the start, limits and requirements on the loop.
    fn finished(mut self, name: String, kind: &'static str) -> Design {
        let h = [0.01, 0.02][self.random.below(2) as usize];
        let samples = 20 + self.random.below(40);
        let count = self.states.len();
        self.plain("sample_time", h.to_string());
        let x0_max: Vec<_> = (0..count).map(|_| self.number(0.05, 0.6)).collect();
        let gives = |key: &str| self.lines.iter().any(|line| line.key == key);
        // With several outputs only a clock in samples has bounds.
        let is_bounded = !gives("outputs") || gives("clock");
        if is_bounded && self.chance(90) {
            let all: Vec<_> = x0_max.iter().map(f64::to_string).collect();
            let bounds = self.bounds(&all);
            self.plain("x0_max", bounds);
        }
        if self.lines.iter().any(|line| line.key == "x0_max") && self.chance(60) {
            let errors = ["1e-9", "1e-3", "0.1", "1e3"];
            let error = self.of(&errors).to_owned();
            let bounds = self.bounds(&vec![error; count]);
            self.plain("error", bounds);
        }
        if self.chance(40) {
            let noise = self.of(&["1e-6", "1e-3"]);
            self.plain("noise", noise);
        }
        for (key, value) in [("g_error", "[0.95, 1.05]"), ("jitter", "1e-4"), ("u_step", "1e-3")] {
            if self.chance(10) {
                self.plain(key, value);
            }
        }
        if self.chance(15) {
            self.word("precision", "f32");
        }
        if self.chance(40) {
            let held = h * (4 + self.random.below(10)) as f64;
            self.line(PARAMS, "eps", Value::Plain(format!("{held:.2}")));
        }
        let tau = h * samples as f64;
        self.line(PARAMS, "tau", Value::Plain(format!("{tau:.2}")));
        let in_samples = self.lines.iter().any(|line| line.key == "clock");
        if !in_samples {
            self.line(PARAMS, "t0", Value::Plain("0".to_owned()));
        }
        let u_max = self.of(&["3", "300", "1e9", "inf"]);
        self.line(PARAMS, "u_max", Value::Plain(u_max.to_owned()));
        if u_max != "inf" && self.chance(20) {
            let u_min = self.of(&["-1", "-50", "-1e9", "0"]);
            self.line(PARAMS, "u_min", Value::Plain(u_min.to_owned()));
        }
        let x0 = x0_max.iter().map(|most| 0.5 * most).collect();
        Design {
            name,
            kind,
            lines: self.lines,
            states: self.states,
            hidden: self.hidden,
            x0_max,
            x0,
        }
    }
}
