//! Random designs, as keys and values of the command line.

use ptc_codegen::request::Spec;

use crate::harness::random::Random;
use crate::harness::specs::accepted;

/// Keys with their values.
pub(super) type Keys = Vec<(String, String)>;

/// Properties that all designs of a round have in common.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    family: &'static str,
    precision: &'static str,
}

const FAMILIES: [&str; 12] = [
    "exp",
    "rational",
    "power",
    "tan",
    "tanh",
    "algebraic",
    "exp_sum",
    "soft",
    "mu",
    "mu",
    "kappa",
    "kappa",
];

impl Kind {
    pub(super) fn new(random: &mut Random) -> Self {
        Self { family: of(random, &FAMILIES), precision: of(random, &["f64", "f64", "f32"]) }
    }
}

fn of<T: Copy>(random: &mut Random, choices: &[T]) -> T {
    choices[usize::try_from(random.below(choices.len() as u64)).unwrap_or(0)]
}

/// A decimal number of a few digits.
fn number(random: &mut Random, low: f64, high: f64) -> String {
    format!("{:.3}", random.between(low, high))
}

/// A family with some of its parameters fixed.
fn family(random: &mut Random, name: &str) -> String {
    let mut own = Vec::new();
    match name {
        "exp_sum" => {
            let count = 1 + random.below(3);
            return match random.below(3) {
                0 => name.to_owned(),
                1 => format!("exp_sum({})", count.max(2)),
                _ => {
                    let rates: Vec<_> =
                        (0..count.max(2)).map(|_| number(random, 0.3, 3.0)).collect();
                    format!("exp_sum(rates=[{}])", rates.join(","))
                }
            };
        }
        "power" => {
            let m = of(random, &["", "m=1", "m=2", "m=3", "m=0.5", "m=1.5", "m=0.8"]);
            own.extend((!m.is_empty()).then(|| m.to_owned()));
        }
        "soft" => {
            let start = of(random, &["", "start=0.1", "start=0.37", "start=1"]);
            own.extend((!start.is_empty()).then(|| start.to_owned()));
        }
        _ => {}
    }
    if random.below(2) == 0 {
        own.push(format!("a={}", number(random, 0.3, 3.0)));
    }
    if own.is_empty() { name.to_owned() } else { format!("{name}({})", own.join(",")) }
}

/// An operand of a mapping of the user's: a number, or a parameter.
fn rate(random: &mut Random) -> String {
    match random.below(3) {
        0 => "a".to_owned(),
        1 => "b".to_owned(),
        _ => number(random, 0.3, 3.0),
    }
}

/// mu as an expression: families of free rates, their means, and forms that are written out.
fn mu(random: &mut Random, depth: u32) -> String {
    let a = rate(random);
    let plain = ["exp", "rational", "tan", "tanh", "algebraic"];
    match random.below(if depth == 0 { 5 } else { 7 }) {
        0 => format!("1*{}(a={a})", of(random, &plain)),
        1 => format!("tau*(1 - exp(-{a}*t))"),
        2 => format!("tau*{a}*t/(1 + {a}*t)"),
        3 => format!("tau*tanh({a}*t)"),
        4 => format!("tau*(1 - (1 + {a}*t)^(-{}))", of(random, &["1", "2", "0.5", "1.5"])),
        _ => format!("mean({}, {})", mu(random, depth - 1), mu(random, depth - 1)),
    }
}

/// kappa as an expression: one that grows beyond every bound, and further ones that grow.
fn kappa(random: &mut Random) -> String {
    let a = rate(random);
    let mut sum = match random.below(5) {
        0 => format!("dt/({a}*(tau - dt))"),
        1 => format!("-ln(1 - dt/tau)/{a}"),
        2 => format!("tan(pi*dt/(2*tau))/{a}"),
        3 => format!("atanh(dt/tau)/{a}"),
        _ => format!("((1 - dt/tau)^(-{}) - 1)/{a}", of(random, &["1", "2", "0.5"])),
    };
    for _ in 0..random.below(3) {
        let c = rate(random);
        sum.push_str(&match random.below(4) {
            0 => format!(" + {c}*dt"),
            1 => format!(" + {c}*(dt/tau)^{}", 2 + random.below(3)),
            2 => format!(" + {c}*sinh(dt/tau)"),
            _ => format!(" + {c}*tau*dt/(tau - dt)"),
        });
    }
    sum
}

/// A random design called `name`.
pub(super) fn keys(random: &mut Random, kind: Kind, name: &str) -> Keys {
    let n = 1 + random.below(8);
    let mut keys = vec![("name".to_owned(), name.to_owned()), ("n".to_owned(), n.to_string())];
    let mut give = |key: &str, value: String| keys.push((key.to_owned(), value));
    match kind.family {
        "mu" => give("mu", mu(random, 2)),
        "kappa" => give("kappa", kappa(random)),
        name => give("mu", family(random, name)),
    }
    give("precision", kind.precision.to_owned());
    let guard = of(random, &["full", "full", "result", "none"]);
    give("guard", guard.to_owned());
    let after = of(random, &["hold", "hold", "zero", "extern"]);
    give("after", after.to_owned());
    give("allow", "growth".to_owned());
    for (key, low, high) in [("tau", 0.5, 10.0), ("t0", -30.0, 30.0), ("eps", 1e-2, 0.2)] {
        if random.below(4) == 0 {
            give(key, number(random, low, high));
        }
    }
    match random.below(4) {
        0 => give("u_max", "inf".to_owned()),
        1 => give("u_max", number(random, 1.0, 1e3)),
        _ => {}
    }
    let list = |random: &mut Random, low, high| {
        (0..n).map(|_| number(random, low, high)).collect::<Vec<_>>().join(",")
    };
    match random.below(7) {
        0 => give("gains", list(random, 0.5, 20.0)),
        1 => give("poles", list(random, -30.0, -0.5)),
        2 => give("pi0", "extern".to_owned()),
        3 | 4 => give("pi0", law(random, n)),
        _ => {}
    }
    if random.below(5) == 0 {
        let gain = ["-0.5", "gain", "2 + x1*x1/(1 + x1*x1)", "1 + exp(-x1*x1)", "3 - sin(t)"];
        give("g", of(random, &gain).to_owned());
    }
    keys
}

/// A law that is not a sum of gains.
fn law(random: &mut Random, n: u64) -> String {
    let linear = (1..=n).map(|i| format!("- {}*xi{i}", number(random, 0.5, 9.0)));
    let linear = linear.collect::<Vec<_>>().join(" ");
    let last = 1 + random.below(n);
    match random.below(6) {
        0 => linear,
        1 => format!("{linear} - xi{last}*abs(xi{last})"),
        2 => format!("max(min({linear}, 5), -5)"),
        3 => format!("{linear} - psi*tanh(xi1) + 0.1*x{last}_0"),
        4 => format!("{linear} - 0.3*xi{last}_0*dt - t0/8"),
        _ => format!("{linear} - psi*sign(xi{last})"),
    }
}

/// The spec of some keys; `None` if it is refused.
pub(super) fn spec(keys: &Keys) -> Option<Spec> {
    accepted(keys).map(|(spec, _)| spec)
}

/// Designs with one choice less, the simplest first.
pub(super) fn simpler(keys: &Keys) -> Vec<Keys> {
    let kept = ["name", "n", "mu", "kappa", "allow"];
    let mut all = Vec::new();
    for (index, (key, value)) in keys.iter().enumerate() {
        let mut fewer = keys.clone();
        match (key.as_str(), value.parse::<u32>()) {
            ("n", Ok(n)) if n > 1 => fewer[index].1 = (n / 2).to_string(),
            (key, _) if kept.contains(&key) => continue,
            _ => {
                fewer.remove(index);
            }
        }
        all.push(fewer);
    }
    all
}
