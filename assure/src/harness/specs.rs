//! Specs, as a front end would read them.

use super::random::Random;
use ptc_codegen::Accepted;
use ptc_codegen::check::examine::examine;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::Language;
use ptc_codegen::family::Family;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::parse;

/// The spec of keys and values as they are written on the command line.
pub fn spec(keys: &[(&str, &str)]) -> Spec {
    let entry = |(key, text): &(&str, &str)| Entry {
        key: (*key).to_owned(),
        place: Place(0),
        value: parse(key, text, &mut |_| Place(0)).expect("a value"),
    };
    let entries: Vec<_> = keys.iter().map(entry).collect();
    read(&entries).unwrap_or_else(|found| panic!("{keys:?}: {found:?}"))
}

/// The same; `None` where it is refused.
pub fn legal(keys: &[(impl AsRef<str>, impl AsRef<str>)]) -> Option<Spec> {
    let entry = |(key, text): &(_, _)| {
        let (key, text): (&str, &str) = (AsRef::as_ref(key), AsRef::as_ref(text));
        let value = parse(key, text, &mut |_| Place(0)).ok()?;
        Some(Entry { key: key.to_owned(), place: Place(0), value })
    };
    read(&keys.iter().map(entry).collect::<Option<Vec<_>>>()?).ok()
}

/// The same as a design that can be emitted; `None` also where the checks refuse it, or a coefficient overflows.
pub fn accepted(keys: &[(impl AsRef<str>, impl AsRef<str>)]) -> Option<(Spec, Accepted)> {
    let report = examine(&legal(keys)?);
    let spec = report.spec.clone();
    Some((spec, Accepted::of(report).ok()?))
}

/// Every family.
pub fn families() -> impl Iterator<Item = Family> {
    ptc_codegen::family::FAMILIES.iter().map(|info| info.family)
}

/// Values of the run-time parameters.
pub struct Values<'a> {
    /// Settling time, s.
    pub tau: f64,
    /// Start, s.
    pub t0: f64,
    /// Time-to-go at which the gains are held, s.
    pub eps: f64,
    /// Bound of |u|.
    pub u_max: f64,
    /// Rate of stretched time, 1/s.
    pub a: f64,
    /// Exponent of `power`.
    pub m: f64,
    /// Rate at the start of `soft`.
    pub start: f64,
    /// Rates of `exp_sum`, 1/s.
    pub rates: &'a [f64],
    /// Gains.
    pub k: &'a [f64],
}

impl Values<'_> {
    /// The value of one parameter.
    pub fn get(&self, parameter: Parameter) -> f64 {
        match parameter {
            Parameter::Tau => self.tau,
            Parameter::StartTime => self.t0,
            Parameter::Eps => self.eps,
            Parameter::UMax => self.u_max,
            Parameter::UMin => -self.u_max,
            Parameter::A => self.a,
            Parameter::M => self.m,
            Parameter::Start => self.start,
            Parameter::Rate(i) => self.rates[i - 1],
            Parameter::Gain(i) => self.k[i - 1],
            Parameter::Named(name) => panic!("{name} belongs to no family"),
            Parameter::Samples | Parameter::SampleTime | Parameter::Deadbeat => {
                panic!("{parameter:?} belongs to a clock in samples")
            }
        }
    }

    /// Returns the values that `spec` leaves to run time, in the order of the struct.
    pub fn run_time(&self, spec: &Spec) -> Vec<f64> {
        spec.run_time_parameters().map(|parameter| self.get(parameter)).collect()
    }
}

/// `value` in `precision`.
pub fn rounded(value: f64, precision: Precision) -> f64 {
    ptc_codegen::program::number::settle(value, precision)
}

/// Functions that two libraries may round differently.
const LIBRARY: [&str; 14] = [
    "exp", "exp2", "expm1", "log", "log1p", "pow", "sin", "cos", "tan", "sinh", "cosh", "tanh",
    "atan", "atanh",
];

/// Returns true if the C of `spec` calls one of them.
pub fn calls_a_library(spec: &Spec) -> bool {
    let files = ptc_codegen::generate(spec, Language::C).expect("a legal spec");
    let code: String = files.iter().map(|file| without_comments(&file.text)).collect();
    LIBRARY.iter().any(|function| {
        ["", "f"].iter().any(|suffix| {
            let call = format!("{function}{suffix}(");
            code.match_indices(&call).any(|(at, _)| {
                let before = code[..at].chars().next_back();
                !before.is_some_and(|c| c.is_ascii_alphanumeric() || c == '_')
            })
        })
    })
}

fn without_comments(text: &str) -> String {
    text.split("/*").map(|part| part.split_once("*/").map_or(part, |(_, code)| code)).collect()
}

/// Mappings of random controllers: families with and without what can be fixed, and expressions.
const MAPPINGS: [(&str, &str); 19] = [
    ("mu", "exp"),
    ("mu", "exp(a=0.7)"),
    ("mu", "rational"),
    ("mu", "rational(a=3)"),
    ("mu", "power"),
    ("mu", "power(m=2)"),
    ("mu", "power(a=0.5,m=1.5)"),
    ("mu", "tan"),
    ("mu", "tan(a=2)"),
    ("mu", "tanh"),
    ("mu", "algebraic"),
    ("mu", "exp_sum"),
    ("mu", "exp_sum(rates=[0.5,1.5,4])"),
    ("mu", "soft"),
    ("mu", "soft(start=0.1)"),
    ("mu", "mean(rational(a=1), rational(a=b))"),
    ("mu", "tau*(1 - exp(-a*t))"),
    ("kappa", "dt/(a*(tau - dt))"),
    ("kappa", "tau*dt/(tau - dt) + dt"),
];

/// A random controller called `name`.
pub fn random(random: &mut Random, name: &str) -> Spec {
    let mut one_of = |texts: &[&'static str]| texts[random.below(texts.len() as u64) as usize];
    let n = one_of(&["1", "2", "3", "4", "5", "6"]);
    let precision = one_of(&["f64", "f32"]);
    let guard = one_of(&["full", "full", "result", "none"]);
    let after = one_of(&["hold", "hold", "zero", "extern"]);
    let times = one_of(&["", "tau", "tau t0 eps"]);
    let u_max = one_of(&["", "inf", "25"]);
    let law = one_of(&["", "", "gains", "poles", "expression", "extern"]);
    let (key, mapping) = MAPPINGS[random.below(MAPPINGS.len() as u64) as usize];
    let order: usize = n.parse().expect("an order");
    let listed =
        |number: fn(usize) -> String| (1..=order).map(number).collect::<Vec<_>>().join(",");
    let gains = listed(|i| format!("{}.5", 3 * i));
    let poles = listed(|i| format!("-{}", 8 + i));
    let own = (1..=order).map(|i| format!("- {i}*xi{i}")).collect::<String>();
    let own = format!("{own} - xi1*abs(xi1)");
    let mut keys = vec![("name", name), ("n", n), (key, mapping), ("precision", precision)];
    keys.extend([("guard", guard), ("after", after), ("allow", "growth")]);
    for (key, value) in [("tau", "1.75"), ("t0", "0.5"), ("eps", "0.001")] {
        keys.extend(times.split(' ').any(|fixed| fixed == key).then_some((key, value)));
    }
    keys.extend((!u_max.is_empty()).then_some(("u_max", u_max)));
    match law {
        "gains" => keys.push(("gains", &gains)),
        // Poles give gains only where the mapping's rate is known.
        "poles" if mapping.contains("a=") && !mapping.contains("mean") => {
            keys.push(("poles", &poles))
        }
        "expression" => keys.push(("pi0", &own)),
        "extern" => keys.push(("pi0", "extern")),
        _ => {}
    }
    spec(&keys)
}
