//! The signals of an FMU: what the importer sets at each call, and what it reads, by name.

use super::steering::Steering;
use super::units::chain_units;
use crate::request::Spec;

/// An input or an output.
pub(super) struct Signal {
    pub(super) name: String,
    /// Member of the instance that holds an input.
    pub(super) place: String,
    pub(super) about: String,
    /// Axis from 0, of the signals of several axes, each of which depends on its own alone.
    pub(super) axis: Option<usize>,
}

/// The inputs of an FMU, and u with its statuses.
pub(super) struct Signals {
    /// The state, or what is measured.
    pub(super) states: Vec<Signal>,
    /// The reference and its derivatives, where each call is given them.
    pub(super) references: Vec<Signal>,
    /// Inputs of the plant.
    pub(super) controls: Vec<Signal>,
    /// The status of each, where there are several.
    pub(super) statuses: Vec<Signal>,
    /// The letter of the states, or of what is measured.
    pub(super) letter: char,
    /// Dimensions of the arrays that hold the states and the references.
    pub(super) of_states: Vec<usize>,
    pub(super) of_references: Vec<usize>,
    /// Signals of a deadline in flight.
    pub(super) steering: Option<Steering>,
}

impl Signals {
    pub(super) fn of(spec: &Spec) -> Self {
        let (letter, states, of_states) = states(spec);
        let (references, of_references) = references(spec);
        Self {
            states,
            references,
            controls: controls(spec),
            statuses: statuses(spec),
            letter,
            of_states,
            of_references,
            steering: Steering::of(spec),
        }
    }

    /// The inputs in the order of their value references, from 1.
    pub(super) fn inputs(&self) -> impl Iterator<Item = &Signal> {
        self.states.iter().chain(&self.references).chain(self.steered()).chain(self.switches())
    }

    /// The numbers that change in flight.
    fn steered(&self) -> &[Signal] {
        self.steering.as_ref().map_or(&[], |steering| &steering.inputs)
    }

    /// The inputs that are 0 or 1.
    pub(super) fn switches(&self) -> &[Signal] {
        self.steering.as_ref().map_or(&[], |steering| &steering.switches)
    }

    /// The number of inputs.
    pub(super) fn given(&self) -> usize {
        self.inputs().count()
    }

    /// Returns true if an input is held in an array of rows.
    pub(super) fn rows(&self) -> bool {
        self.of_states.len() > 1 || self.of_references.len() > 1
    }

    /// A cast to the type of an argument of rows, which C does not make of an array that is not constant.
    pub(super) fn constant(&self, lengths: &[usize], real: &str) -> String {
        match lengths {
            [_, columns] => format!("(const {real} (*)[{columns}])"),
            _ => String::new(),
        }
    }

    /// Every signal of the call.
    pub(super) fn all(&self) -> impl Iterator<Item = &Signal> {
        self.inputs().chain(&self.controls).chain(&self.statuses)
    }

    /// Instructions for the importer at each communication point.
    pub(super) fn usage(&self) -> String {
        let states = ends(&self.states);
        let references = match self.references.is_empty() {
            true => String::new(),
            false => format!(", {}", ends(&self.references)),
        };
        match self.controls.as_slice() {
            [u] => format!("set {states}{references}, get {}, give it to the plant, step", u.name),
            all => {
                format!("set {states}{references}, get {}, give them to the plant, step", ends(all))
            }
        }
    }
}

/// The first and the last name.
fn ends(signals: &[Signal]) -> String {
    let name = |signal: Option<&Signal>| signal.map_or(String::new(), |signal| signal.name.clone());
    format!("{}..{}", name(signals.first()), name(signals.last()))
}

/// The states, or what is measured: the letter of their names, the signals, and the dimensions of their array.
fn states(spec: &Spec) -> (char, Vec<Signal>, Vec<usize>) {
    if let Some((axes, order)) = spec.rows_of_axes() {
        let place = |k: usize| (k / order, k % order);
        let signal = |k| {
            let (axis, j) = place(k);
            let unit = chain_units(spec, j + 1);
            Signal {
                name: format!("x{}_{}", j + 1, axis + 1),
                place: format!("x[{axis}][{j}]"),
                about: format!("State x{} of axis {}{unit}", j + 1, axis + 1),
                axis: Some(axis),
            }
        };
        return ('x', (0..axes * order).map(signal).collect(), vec![axes, order]);
    }
    let (letter, count, what) = match spec.sampled() {
        Some(sampled) if !sampled.measures_states() => ('y', sampled.measured, "Measurement"),
        _ => ('x', spec.states(), "State"),
    };
    let chain = spec.sampled().is_none_or(|sampled| sampled.linear.is_none());
    let coupled = spec.coupled.as_ref().map(|coupled| &coupled.states);
    let named = coupled.or_else(|| spec.model.as_ref().map(|model| &model.states));
    let signal = |j: usize| Signal {
        name: format!("{letter}{j}"),
        place: format!("x[{}]", j - 1),
        about: match named {
            Some(states) => format!("State {} of the plant", states[j - 1]),
            None => {
                let unit = if chain { chain_units(spec, j) } else { String::new() };
                format!("{what} {letter}{j} of the plant{unit}")
            }
        },
        axis: None,
    };
    (letter, (1..=count).map(signal).collect(), vec![count])
}

/// The references that each call is given, and the dimensions of their array.
fn references(spec: &Spec) -> (Vec<Signal>, Vec<usize>) {
    let count = spec.references();
    let Some(axes) = spec.axes.as_ref().filter(|_| count > 0) else {
        let signal = |order| Signal {
            name: format!("r{order}"),
            place: format!("r[{order}]"),
            about: derivative(spec, order, spec.n, "the output"),
            axis: None,
        };
        return ((0..count).map(signal).collect(), vec![count]);
    };
    let orders = match spec.decoupled() {
        Some(coupled) => coupled.orders(),
        None => vec![spec.n; axes.count],
    };
    let (each, of_axes) = match spec.rows_of_axes() {
        Some(_) => ("axis", true),
        None => ("output", false),
    };
    // What stands behind the order of an output is not read.
    let rows = orders.into_iter().enumerate().flat_map(|(row, n)| {
        (0..=n).map(move |order| Signal {
            name: format!("r{order}_{}", row + 1),
            place: format!("r[{row}][{order}]"),
            about: derivative(spec, order, n, &format!("{each} {}", row + 1)),
            axis: of_axes.then_some(row),
        })
    });
    (rows.collect(), vec![axes.count, count])
}

/// Describes a derivative of a reference that `what`, of order `n`, follows.
fn derivative(spec: &Spec, order: usize, n: usize, what: &str) -> String {
    let unit = if spec.has_model() { String::new() } else { chain_units(spec, order + 1) };
    match order {
        0 => format!("Reference that {what} follows{unit}"),
        order if order == n && spec.sampled().is_some() => {
            format!("Its derivative of order {order} over the sample in which u acts{unit}")
        }
        order => format!("Its derivative of order {order}{unit}"),
    }
}

/// The inputs of the plant.
fn controls(spec: &Spec) -> Vec<Signal> {
    let unit = spec.input_unit().map_or(String::new(), |unit| format!(" [{unit}]"));
    let signal = |name: String, about: String, axis| Signal {
        place: String::new(),
        about: format!("{about}{unit}"),
        name,
        axis,
    };
    let Some(axes) = &spec.axes else {
        return vec![signal("u".to_owned(), "Input of the plant".to_owned(), None)];
    };
    let each = |index: usize| {
        let name = format!("u{}", index + 1);
        match (spec.rows_of_axes(), &spec.coupled) {
            (None, Some(coupled)) => {
                signal(name, format!("Input {} of the plant", coupled.inputs[index]), None)
            }
            _ => signal(name, format!("Input of axis {}", index + 1), Some(index)),
        }
    };
    (0..axes.count).map(each).collect()
}

/// The status of each of several inputs.
fn statuses(spec: &Spec) -> Vec<Signal> {
    let count = spec.axes.as_ref().map_or(0, |axes| axes.count);
    let of_axes = spec.rows_of_axes().is_some();
    let signal = |index: usize| Signal {
        name: format!("status{}", index + 1),
        place: String::new(),
        about: format!("The same of u{} alone", index + 1),
        axis: of_axes.then_some(index),
    };
    (0..count).map(signal).collect()
}
