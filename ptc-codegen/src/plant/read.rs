//! From the entries of the table `[plant]` to a plant: all mistakes at once.

use std::collections::{BTreeMap, BTreeSet};

use super::{Plant, TABLE, resonance};
use crate::diagnostic::{Diagnostic, Diagnostics, Place, near_miss, shorten};
use crate::expression::constant::real;
use crate::expression::normal::normal;
use crate::expression::{Expression, Scope, Subject, resolve};
use crate::keys::PLANT_KEYS;
use crate::parameter::Parameter;
use crate::request::{Entry, Spec, has_own_states, known};
use crate::syntax::{Node, Value};

/// The value of a key, and where the key is.
pub(super) type Given<'a> = BTreeMap<&'a str, (Place, &'a Node)>;

/// Reads the plant of the controller of `spec`; `None` if the design has none.
///
/// # Errors
/// Every mistake in the table `[plant]`.
pub fn read(entries: &[Entry], spec: &Spec) -> Result<Option<Plant>, Vec<Diagnostic>> {
    let (plant, found) = read_partly(entries, spec);
    if found.is_empty() { Ok(plant) } else { Err(found) }
}

/// The same for callers that report these mistakes with their own: what could be read of it, and
/// every mistake.
pub fn read_partly(entries: &[Entry], spec: &Spec) -> (Option<Plant>, Vec<Diagnostic>) {
    let mut found = Diagnostics::default();
    let mut given = Given::new();
    for entry in entries {
        let Some(name) = entry.key.strip_prefix(TABLE).and_then(|rest| rest.strip_prefix('.'))
        else {
            continue;
        };
        if given.insert(name, (entry.place, &entry.value)).is_some() {
            let message = format!("key `{}` is given twice", entry.key);
            let help = "leave one of the two out";
            found.push("repeated-key", entry.key.as_str(), Some(entry.place), message, help);
        }
    }
    let own_states = has_own_states(entries);
    if spec.sampled().is_some_and(|sampled| sampled.linear.is_some()) && !own_states {
        return (
            linear(&given, spec, &mut found),
            found.finish(None::<()>).err().unwrap_or_default(),
        );
    }
    let plant = match own_states {
        true => Some(super::larger::read(&given, entries, spec, &mut found)),
        false => (!given.is_empty()).then(|| plant(&given, spec, &mut found)),
    };
    (plant, found.finish(None::<()>).err().unwrap_or_default())
}

/// The plant of a controller that knows A, B and C: the same, or with a resonance.
fn linear(given: &Given<'_>, spec: &Spec, found: &mut Diagnostics) -> Option<Plant> {
    let of_resonance =
        |name: &str| name == resonance::KEY || resonance::keys().iter().any(|key| key == name);
    for (name, (place, _)) in given.iter().filter(|(name, _)| !of_resonance(name)) {
        let message = format!("`{name}` beside `A`");
        let help = "the plant is either x' = A x + B u, or a chain with f and g";
        found.push("conflict", format!("{TABLE}.{name}"), Some(*place), message, help);
    }
    let mut plant = Plant::default();
    resonance::put(&mut plant, given, spec, found);
    plant.larger.is_some().then_some(plant)
}

fn plant(given: &Given<'_>, spec: &Spec, found: &mut Diagnostics) -> Plant {
    let mut plant = match spec.has_model() {
        true => super::model::read(given, spec, found),
        false if spec.axes.is_some() && given.contains_key("dynamics") => {
            super::model::read(given, &spec.clone().as_one_plant(), found)
        }
        false => chain(given, spec, found),
    };
    resonance::put(&mut plant, given, spec, found);
    plant
}

fn chain(given: &Given<'_>, spec: &Spec, found: &mut Diagnostics) -> Plant {
    for key in ["dynamics", "outputs", "added"] {
        let Some((place, _)) = given.get(key) else { continue };
        let message = format!("`{key}` of the plant without `states`");
        let help = "a chain is moved by f and g; a plant with other states names them, `states` under [plant], or has a model, [model]";
        found.push("conflict", format!("{TABLE}.{key}"), Some(*place), message, help);
    }
    let known = known(spec.time_mapping.parameters());
    let mut whole = true;
    let mut expression = |subject: Subject| {
        let key = subject.key().trim_start_matches("plant.");
        let (_, node) = given.get(key)?;
        let read = resolve(node, Scope { subject, n: spec.n, known: &known, own: &[] }, found);
        whole &= read.is_some();
        read
    };
    let own = Plant::own(spec);
    let f = expression(Subject::Drift).unwrap_or(own.f);
    let g = expression(Subject::PlantGain);
    if g.as_ref().is_some_and(|g| normal(g) == Expression::integer(0)) {
        let place = given.get("g").map(|(_, node)| node.place);
        let message = "g = 0: the input does not move the plant";
        found.push("bad-value", "plant.g", place, message, "g(x, t) is not 0");
    }
    let mut plant = Plant { f, g, ..Plant::default() };
    let keys = PLANT_KEYS.each_ref().map(|info| info.key);
    Symbols { own: plant.symbols(spec), keys: &keys, whole }.read(&mut plant, given, spec, found);
    plant
}

/// The symbols of a plant, which have their values among its keys.
pub(super) struct Symbols<'a> {
    /// Symbols of its expressions.
    pub(super) own: BTreeSet<Parameter>,
    /// Keys that are not symbols.
    pub(super) keys: &'a [&'a str],
    /// True if all expressions could be read.
    pub(super) whole: bool,
}

impl Symbols<'_> {
    /// Gives the plant the values of its symbols.
    pub(super) fn read(
        &self,
        plant: &mut Plant,
        given: &Given<'_>,
        spec: &Spec,
        found: &mut Diagnostics,
    ) {
        let unvalued: Vec<_> = self
            .own
            .iter()
            .filter(|symbol| !given.contains_key(symbol.spelling().as_str()))
            .map(|symbol| symbol.spelling())
            .collect();
        let of_resonance = resonance::keys();
        let is_key = |name: &str| {
            let of_resonance =
                given.contains_key(resonance::KEY) && of_resonance.iter().any(|key| key == name);
            of_resonance || self.keys.contains(&name)
        };
        for (name, (place, node)) in given.iter().filter(|(name, _)| !is_key(name)) {
            match self.own.iter().find(|symbol| symbol.spelling() == *name) {
                Some(symbol) => value(plant, name, *symbol, node, found),
                // An expression that could not be read may use it.
                None if self.whole => match near_miss(name, unvalued.iter().map(String::as_str)) {
                    Some(meant) => misspelt(plant, (name, meant), given, found),
                    None => self.unused(name, *place, spec, found),
                },
                None => {}
            }
        }
    }

    /// A key that is neither one of the plant nor the name of a symbol.
    fn unused(&self, name: &str, place: Place, spec: &Spec, found: &mut Diagnostics) {
        let key = format!("plant.{name}");
        if spec.parameters().iter().any(|parameter| parameter.spelling() == name) {
            let message = format!("`{name}` is a parameter of the controller");
            let help = format!(
                "give it under [params]; the plant's own needs another name, such as true_{name}"
            );
            found.push("conflict", key, Some(place), message, help);
            return;
        }
        let keys = self.keys.iter().map(|key| (*key).to_owned());
        let names: Vec<_> = keys.chain(self.own.iter().map(|s| s.spelling())).collect();
        let meant = near_miss(name, names.iter().map(String::as_str));
        let meant = meant.map(|meant| format!("did you mean `{meant}`? ")).unwrap_or_default();
        let all = names.join(", ");
        let help = format!("{meant}[plant] holds f, g and the symbols that they use; here {all}");
        found.push(
            "unknown-key",
            key,
            Some(place),
            format!("nothing of the plant is called `{}`", shorten(name)),
            help,
        );
    }
}

/// A number, or `[lower, upper]`, for a symbol.
pub(super) fn value(
    plant: &mut Plant,
    name: &str,
    symbol: Parameter,
    node: &Node,
    found: &mut Diagnostics,
) {
    let finite = |node: &Node| real(node).filter(|value| value.number().is_some());
    if let Value::List(items) = &node.value
        && let [least, greatest] = items.as_slice()
        && let (Some(least), Some(greatest)) = (finite(least), finite(greatest))
        && least.number() < greatest.number()
    {
        plant.bounds.insert(symbol, (least, greatest));
        return;
    }
    match finite(node) {
        Some(value) if !value.leaves(crate::parameter::Precision::F64) => {
            plant.fixed.insert(symbol, value);
        }
        _ => {
            let (message, help) = match &node.value {
                Value::List(_) => {
                    ("is not a pair of bounds", "bounds are [lower, upper] with least < greatest")
                }
                _ => (
                    "is not a finite number",
                    "a symbol of the plant is a finite number, or bounds [lower, upper] where it is uncertain",
                ),
            };
            let key = format!("plant.{name}");
            found.push(
                "bad-value",
                key.as_str(),
                Some(node.place),
                format!("{key} {message}"),
                help,
            );
        }
    }
}

/// A key that nothing uses, where f or g uses nearly the same name, which has no value.
fn misspelt(plant: &Plant, (name, used): (&str, &str), given: &Given<'_>, found: &mut Diagnostics) {
    let uses = |e: &Expression| e.parameters().iter().any(|own| own.spelling() == used);
    let key = plant.keyed().find(|(_, e)| uses(e)).map_or("g", |(key, _)| &key[TABLE.len() + 1..]);
    let place = given.get(key).map(|(_, node)| node.place);
    let message = format!("{key} uses `{used}`, which has no value, and nothing uses `{name}`");
    let help = format!(
        "write one name in both places: `{name}` in {key}, or `{used} = ...` under [plant]"
    );
    found.push("unknown-symbol", format!("{TABLE}.{key}"), place, message, help);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design;

    fn of(design: &str) -> Result<Option<Plant>, Vec<Diagnostic>> {
        let text = format!("n = 2\nmu = \"exp\"\ng = \"gain\"\n{design}");
        let (entries, found) = design::read(&text, &mut |range| Place(range.start));
        assert_eq!(found, []);
        read(&entries, &crate::request::read(&entries).expect("a controller"))
    }

    #[test]
    fn plant_table_gives_expressions_and_symbols() {
        assert_eq!(of(""), Ok(None));
        let text =
            "[plant]\nf = \"-d*x2 + w*sin(t)*u/tau\"\ng = \"gain*b\"\nd = 0.4\nw = [0, 1e-1]\n";
        let plant = of(text).expect("a plant").expect("a table");
        assert_eq!(plant.f.to_string(), "-d*x2 + w*sin(t)*u/tau");
        assert_eq!(plant.g.map(|g| g.to_string()).as_deref(), Some("gain*b"));
        let names = |p: &Parameter| p.spelling();
        assert_eq!(plant.fixed.keys().map(names).collect::<Vec<_>>(), ["d"]);
        let (bounded, (least, greatest)) = plant.bounds.first_key_value().expect("bounds");
        let shown = (names(bounded), least.to_string(), greatest.to_string());
        assert_eq!(shown, ("w".to_owned(), "0".to_owned(), "1e-1".to_owned()));
        assert_eq!(of("plant.f = 0\n").map(|p| p.map(|p| p.g)), Ok(Some(None)));
    }

    #[test]
    fn plant_errors_state_the_legal_values() {
        for (text, code, message, help) in [
            ("[plant]\nf = \"x3\"", "bad-expression", "`x3` does not exist", "1..=2"),
            (
                "[plant]\nf = \"xi1\"",
                "bad-expression",
                "`xi1` is not known where plant.f",
                "u, t (time)",
            ),
            ("[plant]\ng = \"u\"", "bad-expression", "`u` is not known where plant.g", "x1..xn"),
            ("[plant]\ng = 0", "bad-value", "g = 0", "not 0"),
            (
                "[plant]\nf = \"damping*x1\"\ndamping = 2\ndampin = 1",
                "unknown-key",
                "called `dampin`",
                "did you mean `damping`?",
            ),
            (
                "[plant]\nf = \"-dampng*x1\"\ndamping = 1",
                "unknown-symbol",
                "f uses `dampng`, which has no value, and nothing uses `damping`",
                "`damping` in f",
            ),
            ("[plant]\nf = \"gain*x1\"\ngain = 1", "conflict", "`gain` is a parameter", "[params]"),
            (
                "[plant]\nf = \"d*x1\"\nd = inf",
                "bad-value",
                "plant.d is not a finite number",
                "finite",
            ),
            (
                "[plant]\nf = \"d*x1\"\nd = [2, 1]",
                "bad-value",
                "plant.d is not a pair",
                "least < greatest",
            ),
            ("[plant]\nf = 1\nf = 2", "repeated-key", "`plant.f` is given twice", "leave one"),
        ] {
            let found = of(text).expect_err(text);
            let [wrong] = &found[..] else { panic!("{text}: {found:?}") };
            assert_eq!(wrong.code, code, "{text}: {wrong:?}");
            assert!(wrong.message.contains(message), "{text}: {}", wrong.message);
            assert!(wrong.help.contains(help), "{text}: {}", wrong.help);
            assert!(wrong.place.is_some(), "{text}");
        }
    }
}
