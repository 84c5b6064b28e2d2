//! Meaning of a name where it is used, or the reason why it has none there.

use super::Subject::{self, Family, Kappa, Law, Mu};
use super::{NAMES, NameInfo, Sense};
use crate::diagnostic::shorten;
use crate::expression::{Expression, Function};
use crate::family::FAMILIES;
use crate::keys::{KeyInfo, PARAMETERS_TOO, PLANT_KEYS};

/// Entry of the table for a name.
pub(in crate::expression) enum Found {
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

/// Looks up the meaning of `name` in an expression for `subject`, at order `n`.
pub(in crate::expression) fn find(name: &str, subject: Subject, n: usize) -> Found {
    let shown = shorten(name);
    let mut elsewhere = Vec::new();
    for info in &NAMES {
        let (index, exact) = match info.sense {
            Sense::Indexed(_) | Sense::Gain | Sense::R => match info.index(name) {
                Some(found) => found,
                None => continue,
            },
            _ if info.name == name => (0, true),
            _ => continue,
        };
        let exists = (1..=n).contains(&index);
        match info.sense {
            Sense::Gain if subject == Law || !exact || !exists => return Found::Free,
            // Of several outputs the reader of their laws knows the highest order.
            Sense::R if subject != Law || !exact || n == 0 => return Found::Free,
            // Several chains have no order in common.
            Sense::Indexed(_) if n == 0 && matches!(subject, Subject::Objective | Law) => {
                let message = format!("`{shown}` does not exist where there are several outputs");
                let help = match subject {
                    Law => {
                        "xi1_2 is xi_1 of output 2, x1_2 the output 2 and x2_2 its rate; states at t0 are not known"
                    }
                    _ => "x1_2 is the output 2, x2_2 its rate, and x1_2_0 the output 2 at t0",
                };
                return Found::wrong(message, help.to_owned());
            }
            Sense::Indexed(_) | Sense::R if !exists => {
                let message = format!("`{shown}` does not exist for order n = {n}");
                let of_state = index == 0 && !matches!(info.sense, Sense::R);
                let at_start = if of_state { "; the state at t0 is x1_0..xn_0" } else { "" };
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

/// Returns true if `name` means something in an expression for `subject`, at an order up to `most`.
pub(crate) fn is_known(name: &str, subject: Subject, most: usize) -> bool {
    matches!(find(name, subject, most), Found::Is(_))
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
    let alike = |info: &&NameInfo| !info.is_indexed() && plain(info.name) == plain(name);
    let same_case = |info: &&NameInfo| info.name.contains('T') == name.contains('T');
    let alike: Vec<_> = NAMES.iter().filter(alike).collect();
    if let Some(meant) = alike.iter().copied().find(same_case).or(alike.first().copied()) {
        return misspelt(&shown, meant.name);
    }
    let key = KeyInfo::find(name).filter(|info| !PARAMETERS_TOO.contains(&info.key));
    let key = key.or_else(|| PLANT_KEYS.iter().find(|info| info.key == name));
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
    let of_model = if subject == Subject::Model { "the names of [model], " } else { "" };
    let own = NAMES.iter().filter(|info| info.places.contains(&subject));
    let one = |info: &NameInfo| match info.short {
        "" => info.shown(),
        short => format!("{} ({short})", info.shown()),
    };
    format!("{of_model}{} and parameters", own.map(one).collect::<Vec<_>>().join(", "))
}

#[cfg(test)]
mod tests {
    use super::super::PLACES;
    use super::super::Subject::{Drift, InputGain, Reference};
    use super::*;
    use crate::diagnostic::{Diagnostics, Place};
    use crate::expression::{Scope, resolve};
    use crate::parameter::{Name, Parameter};
    use crate::syntax::parse;

    /// V where a name has its meaning, P where it names a parameter, E where it is an error: in mu,
    /// kappa, pi0, f, g, reference, plant.f, plant.g, plant.dynamics, h and the bounds, at order 3.
    const VERDICTS: [(&str, &[&str]); 20] = [
        ("VVVVVVVVVVV", &["tau", "pi"]),
        ("VEVVVVVVVVV", &["t"]),
        ("EVVVVVVVVVV", &["dt"]),
        ("EEVVVVVVVVV", &["t0", "eps", "u_max"]),
        ("EEVEEEEEEVV", &["T"]),
        ("EEVVVEEEEEE", &["t_kappa"]),
        ("EEVEEEEEEEE", &["kappa_rate"]),
        ("EEEEEEVEEVE", &["u"]),
        ("EEEVVEVVEVE", &["x1", "x3"]),
        ("EEVVVEVVEVE", &["x1_0", "x3_0"]),
        ("EEVEEEEEEEE", &["xi1", "xi3", "xi1_0", "xi3_0"]),
        ("EEPEEEEEEEE", &["k1", "k3"]),
        ("PPVPPPPPPPP", &["r_1", "r_3"]),
        ("PPEPPPPPPPP", &["r_0", "r_4"]),
        ("VVEEEEEEEEE", &["rational"]),
        ("EEEEEEEEEEE", &["x0", "x4", "xi0", "xi4", "x0_0", "x4_0", "xi4_0", "x_0"]),
        ("EEEEEEEEEEE", &["x", "xi", "X", "Xi", "x01", "X1", "x_1", "Xi2", "XI1_0", "xi_1_0"]),
        (
            "EEEEEEEEEEE",
            &[
                "Tau", "TAU", "Dt", "DT", "d_t", "T0", "t_0", "Eps", "umax", "U", "Pi", "T_kappa",
                "T_",
            ],
        ),
        (
            "EEEEEEEEEEE",
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
            "PPPPPPPPPPP",
            &[
                "psi", "a", "m", "w", "h", "rho", "e", "k0", "k4", "k", "x1y", "tau2", "K1", "r1",
                "R_1", "r",
            ],
        ),
    ];

    fn verdict(name: &str, subject: Subject) -> char {
        let node = parse(subject.key(), name, &mut |_| Place(0)).expect(name);
        let mut found = Diagnostics::default();
        let parameter = Name::new(name).map(|name| Expression::from(Parameter::Named(name)));
        match resolve(
            &node,
            Scope { subject, n: 3, known: &[Parameter::Tau], own: &[] },
            &mut found,
        ) {
            None => 'E',
            value if value == parameter => 'P',
            Some(_) => 'V',
        }
    }

    #[test]
    fn every_name_has_its_verdict_in_every_place() {
        for (wanted, names) in VERDICTS {
            for name in names {
                let found: String = PLACES.iter().map(|(place, _)| verdict(name, *place)).collect();
                assert_eq!(found, wanted, "{name}");
            }
        }
    }

    #[test]
    fn name_errors_give_the_meaning_and_a_replacement() {
        for (name, subject, parts) in [
            (
                "T",
                InputGain,
                ["`T` is not known where g", "write `tau - dt`; `T` is the time-to-go"],
            ),
            ("T", Reference, ["`T` is not known where reference", "write `tau - dt`"]),
            ("x1", Reference, ["`x1` is not known where reference", "state of the plant"]),
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
            ("f", Law, ["`f` is a key", "known part of the plant"]),
        ] {
            let Found::Wrong { message, help } = find(name, subject, 3) else {
                panic!("{name} is taken");
            };
            assert!(message.contains(parts[0]), "{name}: {message}");
            assert!(help.contains(parts[1]), "{name}: {help}");
        }
    }
}
