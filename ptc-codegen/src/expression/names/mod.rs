//! The names that have a meaning of their own in expressions: one table of what each means, and where.

mod find;

use super::{Expression, Variable};
use crate::parameter::Parameter;

pub(crate) use find::is_known;
pub(super) use find::{Found, find};

/// Purpose of an expression, which decides the names it may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// mu(t), t the stretched time since the start.
    Mu,
    /// kappa(dt), dt the elapsed time.
    Kappa,
    /// pi0(xi, t), t the stretched time.
    Law,
    /// The known f(x, t), t the time.
    Force,
    /// g(x, t), t the time.
    InputGain,
    /// r(t), which the output follows, t the time.
    Reference,
    /// The dynamics and the output of a model of the plant.
    Model,
    /// A family's own kappa, in time-to-go T.
    Family,
    /// f(x, u, t) of the plant, t the time.
    Drift,
    /// The plant's own g(x, t), where it differs from the controller's.
    PlantGain,
    /// A rate of the plant that differs from that of its model, t the time.
    PlantRate,
    /// A bound of an objective over the time of a run.
    Bound,
    /// h(x, u, t) of an objective.
    Objective,
}

use Subject::{
    Bound, Drift, Family, Force, InputGain, Kappa, Law, Mu, Objective, PlantGain, PlantRate,
    Reference,
};

impl Subject {
    /// Key of the spec.
    pub fn key(self) -> &'static str {
        match self {
            Mu => "mu",
            Kappa | Family => "kappa",
            Law => "pi0",
            Force => "f",
            InputGain => "g",
            Reference => "reference",
            Subject::Model => "model",
            Drift => "plant.f",
            PlantGain => "plant.g",
            PlantRate => "plant.dynamics",
            Bound | Objective => "objective",
        }
    }
}

/// Keys of the expressions that users write, in the order of the documentation.
const PLACES: [(Subject, &str); 11] = [
    (Mu, "mu"),
    (Kappa, "kappa"),
    (Law, "pi0"),
    (Force, "f"),
    (InputGain, "g"),
    (Reference, "reference"),
    (Drift, "plant.f"),
    (PlantGain, "plant.g"),
    (PlantRate, "plant.dynamics"),
    (Objective, "h"),
    (Bound, "zeta, upsilon, low, high"),
];

/// Meaning of a name.
#[derive(Clone, Copy)]
enum Sense {
    Variable(Variable),
    /// A letter and an index from 1 to n, with `_0` behind where it is latched at t0.
    Indexed(fn(usize) -> Variable),
    Parameter(Parameter),
    /// A gain k_i: no expression uses it, and in pi0, which takes the place of gains, the name is free.
    Gain,
    /// r_k of the mapping, in pi0; elsewhere, and in other spellings, the name is free.
    R,
    Pi,
}

/// A name, its meaning, and the places where it has that meaning.
struct NameInfo {
    /// The name; of an indexed one, the one with the index 1.
    name: &'static str,
    meaning: &'static str,
    sense: Sense,
    /// A word for it where a list is short of space; empty where none is needed.
    short: &'static str,
    places: &'static [Subject],
}

const fn info(
    name: &'static str,
    meaning: &'static str,
    short: &'static str,
    sense: Sense,
    places: &'static [Subject],
) -> NameInfo {
    NameInfo { name, meaning, sense, short, places }
}

/// Places that look at the state of the plant.
const OF_STATE: &[Subject] = &[Force, InputGain, Drift, PlantGain, Objective];
/// All places outside the mapping, which is fixed before the controller has a start or a bound.
const OUTSIDE_MAPPING: &[Subject] =
    &[Law, Force, InputGain, Reference, Drift, PlantGain, PlantRate, Objective, Bound];
const EVERYWHERE: &[Subject] = &[
    Mu, Kappa, Family, Law, Force, InputGain, Reference, Drift, PlantGain, PlantRate, Objective,
    Bound,
];

/// The same with the model of a plant, which has names of its own.
const WITH_MODEL: &[Subject] = &[
    Mu,
    Kappa,
    Family,
    Law,
    Force,
    InputGain,
    Reference,
    Subject::Model,
    Drift,
    PlantGain,
    PlantRate,
    Objective,
    Bound,
];

/// The table. A name with several meanings has a row for each.
#[rustfmt::skip]
static NAMES: [NameInfo; 19] = [
    info("x1", "state of the plant", "", Sense::Indexed(Variable::State), OF_STATE),
    info("xi1", "state in stretched time, xi = BB_n x", "", Sense::Indexed(Variable::Xi), &[Law]),
    info("u", "input of the plant", "", Sense::Variable(Variable::Control), &[Drift, Objective]),
    info("t", "stretched time since the start", "stretched time since the start", Sense::Variable(Variable::SinceStart), &[Mu]),
    info("t", "stretched time, kappa + t0", "stretched time", Sense::Variable(Variable::StretchedTime), &[Law]),
    info("t", "time", "time", Sense::Variable(Variable::Time), &[Force, InputGain, Reference, Drift, PlantGain, PlantRate, Objective, Bound]),
    info("t_kappa", "stretched time, kappa + t0", "stretched time", Sense::Variable(Variable::StretchedTime), &[Law, Force, InputGain]),
    info("dt", "elapsed time, t - t0", "elapsed time", Sense::Variable(Variable::Elapsed), &[Kappa, Law, Force, InputGain, Reference, Drift, PlantGain, PlantRate, Objective, Bound]),
    info("T", "time-to-go, t0 + tau - t, in `pi0` held at eps", "time-to-go", Sense::Variable(Variable::TimeToGo), &[Family, Law, Objective, Bound]),
    info("kappa_rate", "derivative of kappa, kappa'(dt), with `T` held at eps", "derivative of kappa", Sense::Variable(Variable::KappaRate), &[Law]),
    info("r_1", "derivatives of mu at the stretched time, with `T` held at eps; r_1 is 1/kappa_rate", "derivatives of mu", Sense::R, &[Law]),
    info("tau", "settling time", "", Sense::Parameter(Parameter::Tau), EVERYWHERE),
    info("t0", "start time", "", Sense::Parameter(Parameter::StartTime), OUTSIDE_MAPPING),
    info("eps", "time-to-go at which the gains are held", "", Sense::Parameter(Parameter::Eps), OUTSIDE_MAPPING),
    info("u_max", "bound of abs(u)", "", Sense::Parameter(Parameter::UMax), OUTSIDE_MAPPING),
    info("x1_0", "state of the plant at t0", "", Sense::Indexed(Variable::StateAtStart), &[Law, Force, InputGain, Drift, PlantGain, Objective]),
    info("xi1_0", "xi at t0", "", Sense::Indexed(Variable::XiAtStart), &[Law]),
    info("k1", "gains of xi1..xin, given by `gains` or `poles`", "", Sense::Gain, &[]),
    info("pi", "the circle constant", "", Sense::Pi, WITH_MODEL),
];

impl NameInfo {
    /// Index in a name of this form, and whether it is spelt as it should be.
    fn index(&self, name: &str) -> Option<(usize, bool)> {
        let (stem, tail) = self.name.split_once('1')?;
        let lower = name.to_ascii_lowercase();
        let rest = lower.strip_prefix(stem)?.strip_suffix(tail)?;
        let digits = rest.strip_prefix('_').unwrap_or(rest);
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let index = digits.parse().unwrap_or(usize::MAX);
        Some((index, name == self.with_index(index)))
    }

    fn with_index(&self, index: usize) -> String {
        self.name.replacen('1', &index.to_string(), 1)
    }

    fn is_indexed(&self) -> bool {
        matches!(self.sense, Sense::Indexed(_) | Sense::Gain | Sense::R)
    }

    /// The name as a reader finds it: `x1..xn`.
    fn shown(&self) -> String {
        match self.is_indexed() {
            true => format!("{}..{}", self.name, self.name.replacen('1', "n", 1)),
            false => self.name.to_owned(),
        }
    }

    /// Its meaning, and the places where it has it.
    fn explained(&self) -> String {
        let places = PLACES.iter().filter(|(place, _)| self.places.contains(place));
        let places: Vec<_> = places.map(|(_, name)| *name).collect();
        match places.is_empty() {
            true => self.meaning.replace('`', ""),
            false => format!("{} (in {})", self.meaning.replace('`', ""), places.join(", ")),
        }
    }

    /// Suggests an equivalent where the name has no meaning.
    fn instead(&self, subject: Subject, index: usize) -> Option<String> {
        let of_state = OF_STATE.contains(&subject);
        let text = match (self.name, subject) {
            ("T", Kappa | Force | InputGain | Reference | Drift | PlantGain | PlantRate) => {
                "tau - dt".to_owned()
            }
            ("t", Kappa) => "dt".to_owned(),
            ("dt" | "t_kappa", Mu) => "t".to_owned(),
            ("t_kappa", Reference | Drift | PlantGain | PlantRate | Objective | Bound) => {
                return None;
            }
            ("x1", Law) => format!("xi{index}"),
            ("xi1", _) if of_state => format!("x{index}"),
            ("xi1_0", _) if of_state => format!("x{index}_0"),
            _ => return None,
        };
        Some(text)
    }
}

impl Sense {
    fn expression(self, index: usize) -> Expression {
        match self {
            Self::Variable(variable) => variable.into(),
            Self::Indexed(variable) => variable(index).into(),
            Self::R => Variable::R(index).into(),
            Self::Parameter(parameter) => parameter.into(),
            Self::Pi | Self::Gain => Expression::pi(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = include_str!("../../../../docs/expressions.md");

    #[test]
    fn page_contains_the_table_of_names() {
        let mut table = "| name | meaning | in |\n| --- | --- | --- |\n".to_owned();
        for info in &NAMES {
            let shown = info.shown().replace("..", "`..`");
            let places = PLACES.iter().filter(|(place, _)| info.places.contains(place));
            let places: Vec<_> =
                places.map(|(_, name)| format!("`{}`", name.replace(", ", "`, `"))).collect();
            let places = match (places.len(), info.sense) {
                (_, Sense::Gain) => "none; in `pi0` a free name".to_owned(),
                (all, _) if all == PLACES.len() => "all".to_owned(),
                _ => places.join(", "),
            };
            table += &format!("| `{shown}` | {} | {places} |\n", info.meaning);
        }
        assert!(PAGE.contains(&table), "docs/expressions.md has no such table:\n{table}");
    }
}
