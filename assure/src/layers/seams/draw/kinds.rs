//! Lines that each kind of design has beside those of all.

use super::super::design::{MODEL, PLANT, Value};
use super::Draft;

/// A kind of design: it adds its own lines to those of every design.
pub(super) type Kind = fn(&mut Draft<'_>);

/// All of them, by name.
pub(super) const KINDS: [(&str, Kind); 13] = [
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
    late(draft, n, delay);
    if draft.chance(30) {
        draft.word("g", "1/3.5");
    }
}

fn observer(draft: &mut Draft<'_>, disturbance: bool) {
    let n = 2 + draft.random.below(2) as usize;
    let delay = draft.random.below(2) as usize;
    draft.chain(n);
    draft.samples();
    late(draft, n, delay);
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

/// A delay in samples, and the poles of a plant of `n` states for one of its two laws.
fn late(draft: &mut Draft<'_>, n: usize, delay: usize) {
    let predicts = draft.chance(50);
    draft.poles("poles", if predicts { n } else { n + delay });
    if delay > 0 {
        draft.plain("delay", delay.to_string());
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
    late(draft, 2, delay);
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
