//! The names that have a meaning of their own in expressions: one table of what each means, and where.

use super::{Expression, Function, Variable};
use crate::diagnostic::shorten;
use crate::family::FAMILIES;
use crate::keys::{KeyInfo, PLANT_KEYS};
use crate::parameter::Parameter;

/// What an expression is for, which decides the names it may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// mu(t), t the stretched time since the start.
    Mu,
    /// kappa(dt), dt the elapsed time.
    Kappa,
    /// pi0(xi, t), t the stretched time.
    Law,
    /// g(x, t), t the time.
    InputGain,
    /// A family's own kappa, in time-to-go T.
    Family,
    /// f(x, u, t) of the plant, t the time.
    Drift,
    /// The plant's own g(x, t), where it differs from the controller's.
    PlantGain,
    /// A bound of an objective over the time of a run.
    Bound,
    /// h(x, u, t) of an objective.
    Objective,
}

use Subject::{Bound, Drift, Family, InputGain, Kappa, Law, Mu, Objective, PlantGain};

impl Subject {
    /// Key of the spec.
    pub fn key(self) -> &'static str {
        match self {
            Mu => "mu",
            Kappa | Family => "kappa",
            Law => "pi0",
            InputGain => "g",
            Drift => "plant.f",
            PlantGain => "plant.g",
            Bound | Objective => "objective",
        }
    }
}

/// Where users write expressions, in the order of the documentation.
const PLACES: [(Subject, &str); 8] = [
    (Mu, "mu"),
    (Kappa, "kappa"),
    (Law, "pi0"),
    (InputGain, "g"),
    (Drift, "plant.f"),
    (PlantGain, "plant.g"),
    (Objective, "h"),
    (Bound, "zeta, upsilon, low, high"),
];

/// What a name stands for.
#[derive(Clone, Copy)]
enum Sense {
    Variable(Variable),
    /// A letter and an index from 1 to n, with `_0` behind where it is latched at t0.
    Indexed(fn(usize) -> Variable),
    Parameter(Parameter),
    /// A gain k_i: no expression uses it, and in pi0, which takes the place of gains, the name is free.
    Gain,
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
const OF_STATE: &[Subject] = &[InputGain, Drift, PlantGain, Objective];
/// All places outside the mapping, which is fixed before the controller has a start or a bound.
const OUTSIDE_MAPPING: &[Subject] = &[Law, InputGain, Drift, PlantGain, Objective, Bound];
const EVERYWHERE: &[Subject] =
    &[Mu, Kappa, Family, Law, InputGain, Drift, PlantGain, Objective, Bound];

/// The table. A name with several meanings has a row for each.
#[rustfmt::skip]
static NAMES: [NameInfo; 17] = [
    info("x1", "state of the plant", "", Sense::Indexed(Variable::State), OF_STATE),
    info("xi1", "state in stretched time, xi = BB_n x", "", Sense::Indexed(Variable::Xi), &[Law]),
    info("u", "input of the plant", "", Sense::Variable(Variable::Control), &[Drift, Objective]),
    info("t", "stretched time since the start", "stretched time since the start", Sense::Variable(Variable::SinceStart), &[Mu]),
    info("t", "stretched time, kappa + t0", "stretched time", Sense::Variable(Variable::StretchedTime), &[Law]),
    info("t", "time", "time", Sense::Variable(Variable::Time), &[InputGain, Drift, PlantGain, Objective, Bound]),
    info("t_kappa", "stretched time, kappa + t0", "stretched time", Sense::Variable(Variable::StretchedTime), &[Law, InputGain]),
    info("dt", "elapsed time, t - t0", "elapsed time", Sense::Variable(Variable::Elapsed), &[Kappa, Law, InputGain, Drift, PlantGain, Objective, Bound]),
    info("T", "time-to-go, t0 + tau - t, in `pi0` held at eps", "time-to-go", Sense::Variable(Variable::TimeToGo), &[Family, Law, Objective, Bound]),
    info("tau", "settling time", "", Sense::Parameter(Parameter::Tau), EVERYWHERE),
    info("t0", "start time", "", Sense::Parameter(Parameter::StartTime), OUTSIDE_MAPPING),
    info("eps", "time-to-go at which the gains are held", "", Sense::Parameter(Parameter::Eps), OUTSIDE_MAPPING),
    info("u_max", "bound of abs(u)", "", Sense::Parameter(Parameter::UMax), OUTSIDE_MAPPING),
    info("x1_0", "state of the plant at t0", "", Sense::Indexed(Variable::StateAtStart), &[Law, InputGain, Drift, PlantGain, Objective]),
    info("xi1_0", "xi at t0", "", Sense::Indexed(Variable::XiAtStart), &[Law]),
    info("k1", "gains of xi1..xin, given by `gains` or `poles`", "", Sense::Gain, &[]),
    info("pi", "the circle constant", "", Sense::Pi, EVERYWHERE),
];

/// What the table says of a name.
pub(super) enum Found {
    /// It means this.
    Is(Expression),
    /// It is a mistake, with its correction.
    Wrong { message: String, help: String },
    /// Nothing: it may name a parameter.
    Free,
}

impl Found {
    fn wrong(message: String, help: String) -> Self {
        Self::Wrong { message, help }
    }
}

/// What `name` means in an expression for `subject`, at order `n`.
pub(super) fn find(name: &str, subject: Subject, n: usize) -> Found {
    let shown = shorten(name);
    let mut elsewhere = Vec::new();
    for info in &NAMES {
        let (index, exact) = match info.sense {
            Sense::Indexed(_) | Sense::Gain => match info.index(name) {
                Some(found) => found,
                None => continue,
            },
            _ if info.name == name => (0, true),
            _ => continue,
        };
        let exists = (1..=n).contains(&index);
        match info.sense {
            Sense::Gain if subject == Law || !exact || !exists => return Found::Free,
            Sense::Indexed(_) if !exists => {
                let message = format!("`{shown}` does not exist for order n = {n}");
                let at_start = if index == 0 { "; the state at t0 is x1_0..xn_0" } else { "" };
                return Found::wrong(message, format!("the indices are 1..={n}{at_start}"));
            }
            Sense::Indexed(_) if !exact => return misspelt(&shown, &info.with_index(index)),
            _ => {}
        }
        if info.places.contains(&subject) {
            return Found::Is(info.sense.expression(index));
        }
        elsewhere.push((info, index));
    }
    match elsewhere.as_slice() {
        [] => not_in_the_table(name, subject),
        [(first, index), ..] => {
            let message = format!("`{shown}` is not known where {} is computed", subject.key());
            let meanings = elsewhere.iter().map(|(info, _)| info.explained());
            let meanings = meanings.collect::<Vec<_>>().join(", ");
            let help = match first.instead(subject, *index) {
                Some(instead) => format!("write `{instead}`; `{shown}` is the {meanings}"),
                None => format!("`{shown}` is the {meanings}; a parameter needs another name"),
            };
            Found::wrong(message, format!("{help}; legal: {}", legal(subject)))
        }
    }
}

/// Names that only resemble one of the table, and those that mean something outside expressions.
fn not_in_the_table(name: &str, subject: Subject) -> Found {
    let shown = shorten(name);
    let of_mapping = matches!(subject, Mu | Kappa | Family);
    if matches!(plain(name).as_str(), "x" | "xi") {
        let message = format!("`{shown}` has no index");
        return Found::wrong(message, format!("legal: {}", legal(subject)));
    }
    // T and t differ in nothing else.
    let alike = |info: &&NameInfo| plain(info.name) == plain(name);
    let same_case = |info: &&NameInfo| info.name.contains('T') == name.contains('T');
    let alike: Vec<_> = NAMES.iter().filter(alike).collect();
    if let Some(meant) = alike.iter().copied().find(same_case).or(alike.first().copied()) {
        return misspelt(&shown, meant.name);
    }
    let key = KeyInfo::find(name).or_else(|| PLANT_KEYS.iter().find(|info| info.key == name));
    if let Some(key) = key {
        let message = format!("`{shown}` is a key of the design, not a name in expressions");
        return Found::wrong(
            message,
            format!("{name}: {}; a parameter needs another name, such as {name}_1", key.meaning),
        );
    }
    if FAMILIES.iter().any(|info| info.name == name) && !of_mapping {
        if Function::ALL.iter().any(|(function, _)| *function == name) {
            return Found::Free;
        }
        let message = format!("`{shown}` is a family of mappings");
        return Found::wrong(message, "families are for `mu` and `kappa`".to_owned());
    }
    Found::Free
}

fn misspelt(shown: &str, meant: &str) -> Found {
    let message = format!("`{shown}` differs from `{meant}` in spelling only");
    Found::wrong(message, format!("write `{meant}`, or give a parameter another name"))
}

/// A name without what is easily mistaken: capitals and underscores.
fn plain(name: &str) -> String {
    name.chars().filter(|c| *c != '_').map(|c| c.to_ascii_lowercase()).collect()
}

/// The names that an expression may use, in words.
fn legal(subject: Subject) -> String {
    let own = NAMES.iter().filter(|info| info.places.contains(&subject));
    let one = |info: &NameInfo| match info.short {
        "" => info.shown(),
        short => format!("{} ({short})", info.shown()),
    };
    own.map(one).collect::<Vec<_>>().join(", ") + " and parameters"
}

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
        matches!(self.sense, Sense::Indexed(_) | Sense::Gain)
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

    /// What says the same where the name has no meaning.
    fn instead(&self, subject: Subject, index: usize) -> Option<String> {
        let of_state = OF_STATE.contains(&subject);
        let text = match (self.name, subject) {
            ("T", Kappa | InputGain | Drift | PlantGain) => "tau - dt".to_owned(),
            ("t", Kappa) => "dt".to_owned(),
            ("dt" | "t_kappa", Mu) => "t".to_owned(),
            ("t_kappa", Drift | PlantGain | Objective | Bound) => return None,
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
            Self::Parameter(parameter) => parameter.into(),
            Self::Pi | Self::Gain => Expression::Pi,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::{Diagnostics, Place};
    use crate::expression::{Scope, resolve};
    use crate::parameter::Name;
    use crate::syntax::parse;

    const PAGE: &str = include_str!("../../../docs/expressions.md");

    /// V where a name has its meaning, P where it names a parameter, E where it is an error: in mu,
    /// kappa, pi0, g, plant.f, plant.g, h and the bounds, at order 3.
    const VERDICTS: [(&str, &[&str]); 17] = [
        ("VVVVVVVV", &["tau", "pi"]),
        ("VEVVVVVV", &["t"]),
        ("EVVVVVVV", &["dt"]),
        ("EEVVVVVV", &["t0", "eps", "u_max"]),
        ("EEVEEEVV", &["T"]),
        ("EEVVEEEE", &["t_kappa"]),
        ("EEEEVEVE", &["u"]),
        ("EEEVVVVE", &["x1", "x3"]),
        ("EEVVVVVE", &["x1_0", "x3_0"]),
        ("EEVEEEEE", &["xi1", "xi3", "xi1_0", "xi3_0"]),
        ("EEPEEEEE", &["k1", "k3"]),
        ("VVEEEEEE", &["rational"]),
        ("EEEEEEEE", &["x0", "x4", "xi0", "xi4", "x0_0", "x4_0", "xi4_0", "x_0"]),
        ("EEEEEEEE", &["x", "xi", "X", "Xi", "x01", "X1", "x_1", "Xi2", "XI1_0", "xi_1_0"]),
        (
            "EEEEEEEE",
            &[
                "Tau", "TAU", "Dt", "DT", "d_t", "T0", "t_0", "Eps", "umax", "U", "Pi", "T_kappa",
                "T_",
            ],
        ),
        (
            "EEEEEEEE",
            &[
                "mu",
                "kappa",
                "pi0",
                "f",
                "g",
                "n",
                "gains",
                "poles",
                "sample_time",
                "min",
                "mean",
                "ln",
                "int",
            ],
        ),
        (
            "PPPPPPPP",
            &["psi", "a", "m", "w", "h", "rho", "e", "k0", "k4", "k", "x1y", "tau2", "K1"],
        ),
    ];

    fn verdict(name: &str, subject: Subject) -> char {
        let node = parse(subject.key(), name, &mut |_| Place(0)).expect(name);
        let mut found = Diagnostics::default();
        let parameter = Name::new(name).map(|name| Expression::from(Parameter::Named(name)));
        match resolve(&node, Scope { subject, n: 3, known: &[Parameter::Tau] }, &mut found) {
            None => 'E',
            value if value == parameter => 'P',
            Some(_) => 'V',
        }
    }

    #[test]
    fn every_name_in_every_place() {
        for (wanted, names) in VERDICTS {
            for name in names {
                let found: String = PLACES.iter().map(|(place, _)| verdict(name, *place)).collect();
                assert_eq!(found, wanted, "{name}");
            }
        }
    }

    #[test]
    fn a_mistake_says_what_the_name_means_and_what_to_write() {
        for (name, subject, parts) in [
            (
                "T",
                InputGain,
                ["`T` is not known where g", "write `tau - dt`; `T` is the time-to-go"],
            ),
            ("u", Law, ["`u` is not known where pi0", "input of the plant (in plant.f, h)"]),
            ("x2", Law, ["`x2` is not known", "write `xi2`"]),
            ("xi2_0", Drift, ["`xi2_0` is not known", "write `x2_0`"]),
            ("t", Kappa, ["`t` is not known where kappa", "write `dt`"]),
            ("k2", Drift, ["`k2` is not known", "gains of xi1..xin"]),
            ("Dt", Kappa, ["`Dt` differs from `dt`", "write `dt`"]),
            ("T_", Law, ["`T_` differs from `T`", "write `T`"]),
            ("x_2", Drift, ["`x_2` differs from `x2`", "write `x2`"]),
            ("x0", Drift, ["`x0` does not exist", "x1_0..xn_0"]),
            ("g", Drift, ["`g` is a key", "input gain"]),
            ("f", Law, ["`f` is a key", "known constant of the plant"]),
        ] {
            let Found::Wrong { message, help } = find(name, subject, 3) else {
                panic!("{name} is taken");
            };
            assert!(message.contains(parts[0]), "{name}: {message}");
            assert!(help.contains(parts[1]), "{name}: {help}");
        }
    }

    #[test]
    fn the_page_has_the_table() {
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
