//! Random designs of every kind.

use super::design::{Design, Line, MODEL, PARAMS, PLANT, Value};
use crate::harness::random::Random;

/// A kind of design: it adds its own lines to those of every design.
type Kind = fn(&mut Draft<'_>);

/// All of them, by name.
const KINDS: [(&str, Kind); 13] = [
    ("clock in time", in_time),
    ("known force in time", with_force),
    ("mapping of the user's", with_mapping),
    ("clock in samples", in_samples),
    ("observer", observed),
    ("disturbance", disturbed),
    ("linear plant", linear),
    ("resonance", swinging),
    ("model in time", model_in_time),
    ("model in samples", model_in_samples),
    ("axes", axes),
    ("several outputs", several),
    ("reference", followed),
];

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

fn in_time(draft: &mut Draft<'_>) {
    let n = draft.order(4);
    draft.chain(n);
    draft.family();
    draft.poles("poles", n);
}

const FORCES: [&str; 9] = [
    "-0.5*x1",
    "-sin(x1)",
    "-0.3*x2*abs(x2)",
    "0.2*tanh(x1) - 0.1*x2",
    "0.5*cos(t)",
    "-x1^3/6 - x2/4",
    "0.1*sqrt(1 + x1^2)",
    "ln(2 + cos(x1))",
    "0.2*sinh(0.5*sin(x1)) + atan(x2)/4",
];

const GAINS: [&str; 4] =
    ["2 + cos(x1)", "1/(1 + 0.1*x1^2)", "exp(0.1*sin(x1))", "1.5 + 0.2*tanh(x2)"];

fn with_force(draft: &mut Draft<'_>) {
    draft.chain(2);
    draft.family();
    draft.poles("poles", 2);
    draft.formula("f", &FORCES);
    if draft.chance(50) {
        draft.formula("g", &GAINS);
    }
    if draft.chance(50) {
        let most = draft.of(&["[2, 4]", "[0.8, 100]"]);
        draft.plain("x_max", most);
    }
}

fn with_mapping(draft: &mut Draft<'_>) {
    let n = draft.order(3);
    draft.chain(n);
    draft.formula(
        "mu",
        &[
            "tau*(1 - exp(-2*t))",
            "tau*t/(1 + t)",
            "tau*tanh(t)",
            "tau*(1 - 1/(1 + t)^2)",
            "2*tau/pi*atan(t)",
        ],
    );
    draft.poles("poles", n);
}

fn in_samples(draft: &mut Draft<'_>) {
    let n = draft.order(3);
    let delay = draft.random.below(3) as usize;
    draft.chain(n);
    draft.samples();
    draft.poles("poles", n + delay);
    if delay > 0 {
        draft.plain("delay", delay.to_string());
    }
    if draft.chance(30) {
        draft.word("g", "1/3.5");
    }
}

fn observer(draft: &mut Draft<'_>, disturbance: bool) {
    let n = 2 + draft.random.below(2) as usize;
    let delay = draft.random.below(2) as usize;
    draft.chain(n);
    draft.samples();
    draft.poles("poles", n + delay);
    draft.plain("delay", delay.to_string());
    draft.plain("measured", "[\"x1\"]");
    draft.poles("observer_poles", n + usize::from(disturbance));
    if disturbance {
        draft.word("disturbance", "constant");
    }
    if draft.chance(50) {
        let samples = 6 + draft.random.below(6);
        draft.plain("observer_samples", samples.to_string());
    }
    if draft.chance(30) {
        draft.plain("observer_eps", "0.06");
    }
    if draft.chance(40) {
        let steps: Vec<_> = (0..n).map(|i| if i == 0 { "1e-5" } else { "0" }).collect();
        draft.plain("sensor_step", format!("[{}]", steps.join(", ")));
    }
}

fn observed(draft: &mut Draft<'_>) {
    observer(draft, false);
}

fn disturbed(draft: &mut Draft<'_>) {
    observer(draft, true);
}

fn linear(draft: &mut Draft<'_>) {
    draft.samples();
    draft.states = vec!["x1".to_owned(), "x2".to_owned()];
    let delay = draft.random.below(2) as usize;
    draft.poles("poles", 2 + delay);
    draft.plain("delay", delay.to_string());
    let (a, b) = [
        ("[[0, 1], [0, -0.5]]", "[0, 2]"),
        ("[[0, 1], [4, -0.1]]", "[0.1, -1.3]"),
        ("[[-1, 1], [3, -2]]", "[1, 2]"),
    ][draft.random.below(3) as usize];
    draft.plain("A", a);
    draft.plain("B", b);
    if draft.chance(50) {
        draft.plain("C", "[[1, 0]]");
        draft.poles("observer_poles", 2);
    }
}

fn swinging(draft: &mut Draft<'_>) {
    match draft.random.below(3) {
        0 => in_time(draft),
        1 => in_samples(draft),
        _ => disturbed(draft),
    }
    let (frequency, damping) = (draft.number(2.0, 60.0), draft.number(0.01, 0.3));
    let (ratio, side) = (draft.number(0.2, 6.0), draft.of(&["motor", "load"]));
    let spring = format!(
        "{{ frequency_hz = {frequency}, damping = {damping}, inertia_ratio = {ratio}, measured = \"{side}\" }}"
    );
    draft.line(PLANT, "resonance", Value::Plain(spring));
    draft.hidden = 2;
}

/// Second-order plants: the output, and the rate of w.
const PLANTS: [[&str; 2]; 6] = [
    ["q", "(M - 4*sin(q))/2"],
    ["q", "M*(2 + cos(q)) - 0.5*w - q^3/6"],
    ["q + q^3/6", "M/(1 + 0.1*q^2) - 0.3*tanh(w)"],
    ["sinh(q)", "M - tan(0.3*q)"],
    ["atanh(0.5*q)", "2*M - w/4"],
    ["q - 0.2", "M - sqrt(1 + q^2) + 1"],
];

fn model_in_time(draft: &mut Draft<'_>) {
    draft.family();
    draft.poles("poles", 2);
    let [output, rate] = PLANTS[draft.random.below(6) as usize];
    draft.model(&["q", "w"], "M", output, &["w", rate]);
}

fn model_in_samples(draft: &mut Draft<'_>) {
    draft.samples();
    draft.poles("poles", 2);
    let [output, rate] = PLANTS[draft.random.below(6) as usize];
    draft.model(&["q", "w"], "M", output, &["w", rate]);
}

fn axes(draft: &mut Draft<'_>) {
    let n = draft.order(2);
    draft.plain("n", n.to_string());
    draft.plain("axes", "2");
    draft.states = (1..=2).flat_map(|axis| (1..=n).map(move |i| format!("x{i}_{axis}"))).collect();
    if draft.chance(50) {
        draft.samples();
    } else {
        draft.family();
    }
    let rows = [draft.listed_poles(n), draft.listed_poles(n)];
    draft.plain("poles", format!("[{}]", rows.join(", ")));
}

fn several(draft: &mut Draft<'_>) {
    if draft.chance(50) {
        draft.samples();
    } else {
        draft.family();
    }
    let rows = [draft.listed_poles(2), draft.listed_poles(1)];
    draft.plain("poles", format!("[{}]", rows.join(", ")));
    draft.states = ["p", "v", "c"].map(str::to_owned).to_vec();
    draft.line(MODEL, "states", Value::Plain("[\"p\", \"v\", \"c\"]".to_owned()));
    draft.line(MODEL, "inputs", Value::Plain("[\"F\", \"V\"]".to_owned()));
    draft.line(MODEL, "outputs", Value::Formulas(vec!["p".to_owned(), "c".to_owned()]));
    let force = draft.of(&["F - sin(p) + 0.2*V", "F*(2 + cos(p)) - v/2", "3*c - 2*p - v/2 + F"]);
    let other = draft.of(&["V - 4*c + p/8", "V*(1.5 + 0.2*tanh(c)) - c", "2*V - c"]);
    let rates = ["v", force, other].map(str::to_owned).to_vec();
    draft.line(MODEL, "dynamics", Value::Formulas(rates));
}

const REFERENCES: [&str; 6] = [
    "0.1*sin(t)",
    "0.2*tanh(t)",
    "0.1*t^2/(1 + t^2)",
    "0.1*ln(1 + t^2)",
    "0.1*exp(-t)*cos(2*t)",
    "0.1*(1.5 + sin(t))^0.3",
];

fn followed(draft: &mut Draft<'_>) {
    let n = draft.order(2);
    draft.chain(n);
    if draft.chance(60) {
        draft.samples();
    } else {
        draft.family();
    }
    draft.poles("poles", n);
    draft.formula("reference", &REFERENCES);
}
