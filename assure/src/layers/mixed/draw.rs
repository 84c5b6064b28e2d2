//! Random designs of all keys together, as keys and values of the command line.

use crate::harness::random::Random;

/// Keys with their values.
pub(super) type Keys = Vec<(String, String)>;

const MAPPINGS: [&str; 20] = [
    "exp",
    "exp(a=1)",
    "rational",
    "rational(a=2)",
    "power",
    "power(m=2)",
    "power(m=1.5)",
    "tan",
    "tan(a=1)",
    "tanh",
    "tanh(a=0.5)",
    "algebraic",
    "algebraic(a=2)",
    "exp_sum",
    "exp_sum(rates=[1,2])",
    "soft",
    "soft(start=0.3)",
    "tau*(1 - exp(-b*t))",
    "mean(exp(a=1), rational(a=2))",
    "tau*tanh(0.7*t)",
];

const INVERSES: [&str; 3] =
    ["-ln(1 - dt/tau)/b", "dt/(b*(tau - dt)) + 0.2*sinh(dt/tau)", "atanh(dt/tau)"];

/// Poles, of which each list takes the first few from a random place on.
const POLES: [&str; 13] =
    ["-2", "-7", "-3", "-4.5", "-5", "-3.2", "-6", "-4", "-2.5", "-8", "-6.5", "-3.7", "-5.5"];

/// Models of plants: their keys, and the orders of their outputs.
type Plant = (&'static [(&'static str, &'static str)], &'static [usize]);

const PLANTS: [Plant; 6] = [
    (&[("states", "p, v"), ("input", "u"), ("dynamics", "v, u/m - w0*sin(p)")], &[2]),
    (
        &[
            ("states", "z, v, i"),
            ("input", "u"),
            ("output", "z"),
            ("dynamics", "v, 9.81*(1 - ((1 + i/i0)/(1 + z/z0))^2), (u - R*i)/L"),
        ],
        &[3],
    ),
    (&[("states", "h, q"), ("input", "u"), ("dynamics", "q - c*h, u")], &[2]),
    (&[("A", "[[0,1],[-2,-0.3]]"), ("B", "[0,1]"), ("model.output", "[1,0]")], &[2]),
    (
        &[
            ("states", "h, c, e"),
            ("inputs", "q, p"),
            ("outputs", "h, e"),
            ("dynamics", "q - 0.1*h, p - c*(1 + h), (c - e)*(1 + h)"),
        ],
        &[1, 2],
    ),
    (
        &[
            ("states", "q1, q2, w1, w2"),
            ("inputs", "F1, F2"),
            ("inertia", "[[m + q2^2, q2], [q2, 1]]"),
            ("bias", "[m*q2*w1*w2, w1^2/2 - q1]"),
        ],
        &[2, 2],
    ),
];

/// State of a draw.
struct Draw<'a> {
    random: &'a mut Random,
    keys: Keys,
}

impl Draw<'_> {
    fn of(&mut self, choices: &[&'static str]) -> &'static str {
        choices[usize::try_from(self.random.below(choices.len() as u64)).unwrap_or(0)]
    }

    /// True in one of `count` cases.
    fn one_in(&mut self, count: u64) -> bool {
        self.random.below(count) == 0
    }

    fn give(&mut self, key: &str, value: impl Into<String>) {
        self.keys.push((key.to_owned(), value.into()));
    }

    /// Gives one of `choices`, in one of `count` cases.
    fn perhaps(&mut self, count: u64, key: &str, choices: &[&'static str]) -> bool {
        let given = self.one_in(count);
        if given {
            let value = self.of(choices);
            self.give(key, value);
        }
        given
    }

    fn poles(&mut self, count: usize) -> String {
        let first = usize::try_from(self.random.below(13)).unwrap_or(0);
        let all = POLES.iter().cycle().skip(first).take(count);
        all.copied().collect::<Vec<_>>().join(",")
    }
}

/// A random design called `name`; many of them are refused.
pub(super) fn keys(random: &mut Random, name: &str) -> Keys {
    let mut draw = Draw { random, keys: Vec::new() };
    draw.give("name", name);
    let in_samples = draw.one_in(2);
    // Beyond the order of 8 sums of gains are formed in a subroutine.
    let high = draw.one_in(8);
    let order = usize::try_from(draw.random.below(if high { 4 } else { 5 })).unwrap_or(0);
    let order = order + if high { 9 } else { 1 };
    let kind = draw.random.below(9);
    let (axes, orders): (usize, Vec<usize>) = match kind {
        0..3 => (0, vec![order]),
        3..6 => {
            let count = 1 + usize::try_from(draw.random.below(4)).unwrap_or(0);
            (count, vec![order; count])
        }
        _ => {
            let (keys, orders) = PLANTS[usize::try_from(draw.random.below(6)).unwrap_or(0)];
            keys.iter().for_each(|(key, value)| draw.give(key, *value));
            (0, orders.to_vec())
        }
    };
    let is_chain = kind < 3;
    if kind < 6 {
        draw.give("n", order.to_string());
    }
    if axes > 0 {
        draw.give("axes", axes.to_string());
        gains_of_axes(&mut draw, axes);
    }
    mapping(&mut draw, in_samples);
    let delay = orders.len() == 1 && axes == 0 && draw.perhaps(4, "delay", &["1", "2"]);
    let kept = match draw.keys.last() {
        Some((_, delay_samples)) if delay && in_samples => delay_samples.parse().unwrap_or(0),
        _ => 0,
    };
    let predicts = kept > 0 && draw.perhaps(2, "delay_law", &["predict"]);
    let kept = if predicts { 0 } else { kept };
    law(&mut draw, &orders, kept, is_chain && !in_samples);
    times(&mut draw, in_samples);
    let outputs = orders.len();
    if draw.one_in(3) {
        let first = draw.of(&["sin(t)", "size*t/(1 + t^2)", "dt^2"]);
        let all = std::iter::once(first).chain(std::iter::repeat_n("0.1*t", outputs - 1));
        let known = all.collect::<Vec<_>>().join(", ");
        let given = if draw.one_in(2) { "input".to_owned() } else { known };
        draw.give("reference", given);
    }
    if in_samples {
        if outputs == 1 && axes == 0 && order > 1 && draw.one_in(2) {
            observer(&mut draw, orders[0]);
        }
        draw.perhaps(6, "deadbeat", &["5", "9"]);
        draw.perhaps(3, "guard", &["none"]);
    } else {
        if is_chain {
            draw.perhaps(5, "f", &["-9.81", "sin(x1)", "x1*t", "-c*x1"]);
            draw.perhaps(4, "g", &["2", "1/m", "2 + x1*x1", "exp(-x1*x1)", "3 - sin(t)"]);
            draw.perhaps(12, "what", &["associated"]);
        }
        draw.perhaps(3, "guard", &["result", "none"]);
        draw.perhaps(3, "after", &["zero", "extern"]);
        draw.perhaps(5, "fma", &["true"]);
        draw.perhaps(5, "latency", &["true"]);
    }
    draw.perhaps(4, "precision", &["f32"]);
    draw.perhaps(5, "units", &["m", "rad"]);
    draw.give("allow", "growth,sampling,deadline,loop,envelope");
    draw.keys
}

/// Gains of the plants and bounds of their inputs, which axes share or have for themselves.
fn gains_of_axes(draw: &mut Draw<'_>, axes: usize) {
    let choices = ["2", "1/m", "-0.5", "gain"];
    let list = |draw: &mut Draw<'_>, choices: &[&'static str]| {
        let all: Vec<_> = (0..axes).map(|_| draw.of(choices)).collect();
        all.join(",")
    };
    match draw.random.below(4) {
        0 => {
            let all = list(draw, &choices);
            draw.give("g", format!("[{all}]"));
        }
        1 => {
            draw.perhaps(1, "g", &choices);
        }
        _ => {}
    }
    if draw.one_in(3) {
        let all = list(draw, &["5", "20", "0.5"]);
        draw.give("limits", all);
    } else if draw.one_in(4) {
        let all = list(draw, &["[0,5]", "[-20,3]", "0.5"]);
        draw.give("limits", format!("[{all}]"));
    } else {
        limits(draw);
    }
}

/// The limits of u that all inputs share.
fn limits(draw: &mut Draw<'_>) {
    draw.perhaps(3, "u_max", &["inf", "5"]);
    draw.perhaps(4, "u_min", &["-1", "0", "0.5", "-inf", "runtime"]);
}

fn mapping(draw: &mut Draw<'_>, in_samples: bool) {
    if in_samples {
        draw.give("clock", "samples");
        draw.perhaps(1, "mu", &["exp", "exp(a=1)", "exp(a=0.8)"]);
    } else if draw.one_in(8) {
        draw.perhaps(1, "kappa", &INVERSES);
    } else {
        draw.perhaps(1, "mu", &MAPPINGS);
    }
}

/// The law of outputs of such orders, behind which so many inputs are kept.
fn law(draw: &mut Draw<'_>, orders: &[usize], kept: usize, may_be_free: bool) {
    match orders {
        [order] if draw.one_in(4) && may_be_free => {
            let last = format!("-3*xi1 - xi{order}*abs(xi{order})");
            let of_start = "-psi*tanh(xi1) - 0.1*x1_0".to_owned();
            let law = [last, of_start, "extern".to_owned()];
            let which = usize::try_from(draw.random.below(3)).unwrap_or(0);
            draw.give("pi0", law[which].clone());
        }
        [order] if !draw.one_in(4) => {
            let all = draw.poles(order + kept);
            draw.give("poles", all);
        }
        several if several.len() > 1 && !draw.one_in(4) => {
            let lists: Vec<_> = several.iter().map(|n| format!("[{}]", draw.poles(*n))).collect();
            draw.give("poles", format!("[{}]", lists.join(",")));
        }
        _ => {}
    }
}

fn times(draw: &mut Draw<'_>, in_samples: bool) {
    if in_samples {
        if !draw.one_in(3) {
            draw.give("tau", "0.3");
            draw.perhaps(1, "sample_time", &["0.01", "0.03", "0.005"]);
        }
        draw.perhaps(4, "eps", &["0.04"]);
        return;
    }
    draw.perhaps(2, "tau", &["1.5", "0.4"]);
    draw.perhaps(4, "t0", &["0", "-2.5"]);
    draw.perhaps(3, "eps", &["0.05", "0.01"]);
    draw.perhaps(3, "sample_time", &["0.001", "0.003"]);
}

/// An observer of a plant of this order from its first state.
fn observer(draw: &mut Draw<'_>, order: usize) {
    let states = draw.keys.iter().find(|(key, _)| key == "states");
    let first = states.and_then(|(_, names)| names.split(',').next()).unwrap_or("x1").to_owned();
    draw.give("measured", first);
    let estimated = order + usize::from(draw.perhaps(2, "disturbance", &["constant"]));
    let poles = draw.poles(estimated);
    draw.give("observer_poles", poles);
    draw.perhaps(3, "observer_samples", &["5", "8"]);
    draw.perhaps(5, "observer_eps", &["0.05"]);
    draw.perhaps(3, "noise", &["1e-4"]);
    draw.perhaps(5, "what", &["observer"]);
}
