//! From keys and values to a [`Spec`]: all mistakes at once, none left for later stages.

mod alone;
mod axes;
mod law;
mod linear;
mod mapping;
mod model;
mod parameters;
mod promises;
mod reference;
mod sampled;
mod units;
mod values;

use std::collections::BTreeMap;

use model::Read;
pub(crate) use parameters::known;
pub(crate) use reference::derivatives;
pub(crate) use values::items;
use values::{count, shown, suggestion, whole};

use super::{After, Clock, Feedback, Guard, MAX_ORDER, Spec, What};
use crate::diagnostic::{Diagnostic, Diagnostics, Place, counted, near_miss, shorten};
use crate::expression::Expression;
use crate::family::Family;
use crate::keys::{KEYS, KeyInfo};
use crate::linear::Delay;
use crate::mapping::TimeMapping;
use crate::model::Coupled;
use crate::parameter::{Fixed, Parameter, Precision, is_reserved, reason};
use crate::syntax::{Node, Value};

/// One key with its value, as a front end found it. A key of a table of a design file is written
/// `params.a` or `envelope.x_max`.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// Where the key was written.
    pub place: Place,
    /// Its value.
    pub value: Node,
}

/// Reads a spec.
///
/// # Errors
/// Every mistake in the entries, in their order.
pub fn read(entries: &[Entry]) -> Result<Spec, Vec<Diagnostic>> {
    let mut reader = Reader::new(entries);
    let plant = reader.as_linear_plant(entries);
    if let Some(entries) = &plant {
        reader = Reader::new(entries);
    }
    let spec = reader.spec();
    reader.found.finish(spec)
}

/// Values of parameters as far as the spec fixes them.
type FixedValues = BTreeMap<Parameter, Fixed>;

struct Reader<'a> {
    found: Diagnostics,
    keys: BTreeMap<&'static str, &'a Node>,
    /// What is given for the user's own parameters, and where.
    params: BTreeMap<&'a str, (Place, &'a Node)>,
}

impl<'a> Reader<'a> {
    fn new(entries: &'a [Entry]) -> Self {
        let (found, keys, params) = (Diagnostics::default(), BTreeMap::new(), BTreeMap::new());
        let mut reader = Self { found, keys, params };
        entries.iter().for_each(|entry| reader.admit(entry));
        reader
    }

    fn admit(&mut self, entry: &'a Entry) {
        let (table, name) = match entry.key.split_once('.') {
            Some((table, name)) => (Some(table), name),
            None => (None, entry.key.as_str()),
        };
        // Outside a design file a key needs no table.
        let info = KeyInfo::find(name).filter(|info| table.is_none() || table == info.table());
        match (info, table) {
            (Some(info), _) => {
                if self.keys.insert(info.key, &entry.value).is_some() {
                    self.twice(info.key, entry.place);
                }
            }
            (None, Some("params")) => {
                if self.params.insert(name, (entry.place, &entry.value)).is_some() {
                    self.twice(&entry.key, entry.place);
                }
            }
            // What moves the plant is no part of the controller, nor is what is verified: `plant::read`
            // and `verify::read` read them.
            (None, Some("plant" | "disturbance" | "verify")) => {}
            (None, Some(table)) if table.starts_with("objective[") => {}
            (None, _) => self.unknown(&entry.key, entry.place, name),
        }
    }

    fn twice(&mut self, key: &str, place: Place) {
        self.found.push(
            "repeated-key",
            key,
            Some(place),
            format!("key `{key}` is given twice"),
            "leave one of the two out",
        );
    }

    /// `name` is what `key` is called in its table.
    fn unknown(&mut self, key: &str, place: Place, name: &str) {
        let names = KEYS.iter().map(|info| info.key);
        let legal = names.clone().collect::<Vec<_>>().join(", ");
        let help = match KeyInfo::find(name).map(KeyInfo::table) {
            Some(Some(table)) => format!("`{name}` belongs in [{table}]"),
            Some(None) => format!("`{name}` belongs at the top, before the first table"),
            None => suggestion(near_miss(name, names), &format!("the keys are {legal}")),
        };
        self.found.push(
            "unknown-key",
            key,
            Some(place),
            format!("unknown key `{}`", shorten(key)),
            help,
        );
    }

    fn spec(&mut self) -> Option<Spec> {
        let samples = self.counts_samples();
        let model = self.model();
        let coupled = self.coupled();
        let orders = coupled.as_ref().map(Coupled::orders);
        let first = orders.as_ref().and_then(|orders| orders.first().copied());
        let whole = samples && model.as_ref().is_some_and(|read| self.is_linear(&read.model));
        let degree = model.as_ref().map(|Read { model, .. }| match whole {
            true => model.states.len(),
            false => model.coordinates.len(),
        });
        let n = self.order(degree.or(first), whole);
        // With the order unknown, all else is still read, so that all mistakes are reported at once.
        let order = n.unwrap_or(MAX_ORDER);
        let highest = orders.as_ref().and_then(|orders| orders.iter().copied().max());
        let axes = self.axes().map(|number| vec![n; number]);
        let axes = axes.or(orders.map(|orders| orders.into_iter().map(Some).collect()));
        let mapping = self.time_mapping(highest.unwrap_or(order));
        let own = mapping.as_ref().map(|(mapping, _)| mapping.parameters()).unwrap_or_default();
        let known = parameters::known(own);
        let name = self.name();
        let units = self.units();
        let what = self.choice(
            "what",
            &[
                ("controller", What::Controller),
                ("associated", What::Associated),
                ("observer", What::Observer),
            ],
        );
        let precision =
            self.choice("precision", &[("f64", Precision::F64), ("f32", Precision::F32)]);
        let [fma, latency] =
            ["fma", "latency"].map(|key| self.choice(key, &[("true", true), ("false", false)]));
        let guard = self.choice(
            "guard",
            &[("full", Guard::Full), ("result", Guard::Result), ("none", Guard::None)],
        );
        let after = self.choice(
            "after",
            &[("hold", After::Hold), ("zero", After::Zero), ("extern", After::Extern)],
        );
        let precision = precision.unwrap_or(Precision::F64);
        let states = match (&model, &coupled) {
            (Some(read), _) => Some(read.model.states.len()),
            (None, Some(coupled)) => Some(coupled.states.len()),
            (None, None) if self.has_model() => None,
            (None, None) => n,
        };
        let outputs = coupled.as_ref().filter(|_| samples).map(Coupled::orders);
        let promises = self.promises(n, states, outputs.as_deref());
        // A sample of delay is a state more of a chain, or of a plant that is linear.
        let one = !self.has_model() && !self.keys.contains_key("axes");
        let keeps = samples && (whole || one);
        let late = promises.delay.as_ref().filter(|_| keeps).map_or(0, Delay::inputs);
        let orders = (n.map(|n| n + late), order + late);
        let of_model = model.as_ref().map(|read| &read.model);
        let law = self.law(orders, late, &known, (of_model, coupled.as_ref()));
        let (drift, input_gain) = match &model {
            Some(read) => {
                let unless =
                    |e: &Expression, value| (*e != Expression::integer(value)).then(|| e.clone());
                (unless(&read.drift, 0), unless(&read.gain, 1))
            }
            None => (self.drift(order, &known), self.input_gain(order, &known)),
        };
        let (reference, references) = match (&axes, &coupled) {
            (Some(orders), Some(_)) => self.references(("output", orders), &known),
            // What it is of has not been read.
            _ if self.has_coupled() => (None, Vec::new()),
            (Some(orders), None) if samples => self.references(("axis", orders), &known),
            _ => (self.reference(n, &known), Vec::new()),
        };
        let mut spec = Spec {
            n: order,
            time_mapping: mapping.as_ref().map_or(UNREAD, |(mapping, _)| mapping.clone()),
            name,
            units,
            what: what.unwrap_or(What::Controller),
            clock: Clock::Time,
            precision,
            fma: fma.unwrap_or(false),
            latency: latency.unwrap_or(false),
            guard: guard.unwrap_or(Guard::Full),
            feedback: law.feedback,
            drift,
            input_gain,
            reference,
            axes: None,
            model: model.map(|read| Box::new(read.model)),
            coupled: coupled.map(Box::new),
            after: after.unwrap_or(After::Hold),
            fixed: law.gains,
            bounds: BTreeMap::new(),
            poles: law.poles,
            promises,
            engine: None,
        };
        if spec.what == What::Associated {
            self.associated(&mut spec);
        }
        if let Some(orders) = axes {
            self.own_values(&mut spec, &orders, (law.laws, law.own_gains));
        }
        if let Some(axes) = &mut spec.axes {
            axes.references = references;
        }
        self.fits_axes(&spec, samples);
        self.fits_model(&spec, samples);
        self.fits_coupled(&spec, samples);
        self.fits_reference(&spec, samples);
        self.fits_units(&spec);
        self.fits_r(&spec);
        // A law of the user's program knows all of them.
        if let (Feedback::Extern, Some(chains)) = (&spec.feedback, spec.chains()) {
            spec.coupled = Some(Box::new(chains));
        }
        let complete = self.found.is_empty();
        spec.fixed.extend(mapping.iter().flat_map(|(_, fixed)| fixed.iter().cloned()));
        self.parameters(&mut spec, complete);
        self.reference_exists(&spec, samples);
        match samples {
            true if whole => {}
            true => self.sampled(&mut spec),
            false => self.not_sampled(&spec),
        }
        // A plant that is refused leaves a spec with another clock than requested.
        if samples == spec.sampled().is_some() {
            self.representable(&spec);
        }
        (n.is_some() && mapping.is_some()).then_some(spec)
    }

    /// The infinite-time system needs mu, and checks every input.
    fn associated(&mut self, spec: &mut Spec) {
        spec.guard = Guard::Full;
        if spec.time_mapping.complement().is_none() {
            let place = self.keys.get("what").map(|node| node.place);
            let message = "no closed form of mu is found from this kappa".to_owned();
            let help = "the infinite-time system holds mu'(t): give the mapping as mu";
            self.wrong("what", place, message, help.to_owned());
        }
    }

    fn wrong(&mut self, key: &str, place: Option<Place>, message: String, help: String) {
        self.found.push("bad-value", key, place, message, help);
    }

    /// Refuses the keys that are given and wrong beside others: key, whether it is wrong, message, help.
    fn against(&mut self, beside: &[(&str, bool, &str, &str)]) {
        for (key, wrong, message, help) in beside {
            if let Some(node) = self.keys.get(*key).copied().filter(|_| *wrong) {
                self.found.push("conflict", *key, Some(node.place), *message, *help);
            }
        }
    }

    fn missing(&mut self, key: &'static str) {
        let legal = KeyInfo::find(key).map_or("", |info| info.legal);
        let message = format!("`{key}` is missing");
        self.found.push("missing-key", key, None, message, format!("give {legal}"));
    }

    /// The order, which is `degree` where the plant has a model: if it comes to rest as a `whole`, as many
    /// states as it has.
    fn order(&mut self, degree: Option<usize>, whole: bool) -> Option<usize> {
        let Some(node) = self.keys.get("n").copied() else {
            // The matrix of a plant has an order.
            let rows = self.keys.get("A").map(|node| items(node).len());
            let rows = rows.filter(|rows| (1..=MAX_ORDER).contains(rows));
            let known = degree.or(rows);
            if known.is_none() && !self.has_model() {
                self.missing("n");
            }
            return known;
        };
        let n = count(node, MAX_ORDER);
        if n.is_none() {
            let message =
                format!("n = {} is not an order that can be generated", shown(&node.value));
            let shared = match (&node.value, self.keys.contains_key("axes")) {
                (Value::List(_), true) => {
                    "; axes share one order: make a controller for each order, armed at the same t0 with the same tau"
                }
                _ => "",
            };
            let help = format!("n is an integer 1..={MAX_ORDER}{shared}");
            self.wrong("n", Some(node.place), message, help);
        }
        if let (Some(n), Some(degree)) =
            (n, degree.filter(|degree| n.is_some_and(|n| n != *degree)))
        {
            let message = match whole {
                true => format!("n = {n}, but the model has {}", counted(&degree, "state")),
                false => format!("n = {n}, but the relative degree of the output is {degree}"),
            };
            let help = format!("leave n out, or give {degree}: it follows from the model");
            self.wrong("n", Some(node.place), message, help);
            return Some(degree);
        }
        n
    }

    fn name(&mut self) -> Option<String> {
        let node = self.keys.get("name").copied()?;
        if let Value::Word(word) = &node.value
            && word.len() <= 48
            && !is_reserved(word)
        {
            return Some(word.clone());
        }
        let message = format!("{} cannot name a controller", shown(&node.value));
        let legal = KeyInfo::find("name").map_or("", |info| info.legal);
        let why = match &node.value {
            Value::Word(word) => reason(word).map(|why| format!("{why}; ")).unwrap_or_default(),
            _ => String::new(),
        };
        self.wrong("name", Some(node.place), message, format!("{why}a name is {legal}"));
        None
    }

    fn choice<T: Copy>(&mut self, key: &'static str, legal: &[(&str, T)]) -> Option<T> {
        let node = self.keys.get(key).copied()?;
        let names = legal.iter().map(|(name, _)| *name);
        let word = match &node.value {
            Value::Word(word) => word.as_str(),
            _ => "",
        };
        if let Some((_, value)) = legal.iter().find(|(name, _)| *name == word) {
            return Some(*value);
        }
        let meant = near_miss(word, names.clone());
        let all = names.collect::<Vec<_>>().join(", ");
        let message = format!("{key} = {} is not one of {all}", shown(&node.value));
        self.wrong(key, Some(node.place), message, suggestion(meant, &format!("legal: {all}")));
        None
    }

    /// `key` excludes the others of its group: the first that is given counts, each further one is
    /// a mistake.
    fn only_one(&mut self, group: &[&'static str]) -> Option<(&'static str, &'a Node)> {
        let mut given = group.iter().filter_map(|key| Some((*key, *self.keys.get(key)?)));
        let first = given.next();
        let others: Vec<_> = given.collect();
        if let Some((first, _)) = first {
            for (key, node) in others {
                let message = format!("`{key}` beside `{first}`");
                let help = format!("give one of {}", group.join(", "));
                self.found.push("conflict", key, Some(node.place), message, help);
            }
        }
        first
    }
}

/// Stands in for a mapping that could not be read while the rest of the spec is.
const UNREAD: TimeMapping = TimeMapping::Family { family: Family::Exp, rates: 0 };
