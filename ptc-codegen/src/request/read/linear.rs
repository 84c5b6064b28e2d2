//! A linear plant in place of a chain: A, B, and C or the names of the measured states.

use num_traits::Zero;

use super::sampled::chain_states;
use super::{Reader, items, shown};
use crate::algebra::{BigRational, integer};
use crate::diagnostic::{counted, digits};
use crate::expression::constant::real;
use crate::linear::{self, Complex, Delay, Disturbance, Ill, Linear};
use crate::parameter::Fixed;
use crate::request::{Pole, Spec, What, gains};
use crate::syntax::{Node, Value};

/// Largest order of a linear plant.
const MAX_LINEAR: usize = 8;

impl Reader<'_> {
    /// Rows of C, where the plant is linear.
    pub(super) fn rows_measured(&self) -> Option<usize> {
        let a = self.keys.get("A").copied()?;
        match (self.keys.get("C").copied(), self.keys.get("measured").copied()) {
            (Some(c), _) => Some(rows(c).len()),
            (None, Some(measured)) => Some(items(measured).len()),
            (None, None) => Some(items(a).len()),
        }
    }

    /// Refuses invalid names of the states, or a wrong number of them.
    fn names_of_states(&mut self, n: usize) {
        let Some(node) = self.keys.get("states").copied() else { return };
        let names = self.names(node, ("input", &[]));
        if let Some((states, _)) = names.filter(|(states, _)| states.len() != n) {
            let message =
                format!("{} for {}", counted(&states.len(), "name"), counted(&n, "state"));
            let help = "give a name for each row of A, or leave `states` out".to_owned();
            self.wrong("states", Some(node.place), message, help);
        }
    }

    /// The linear plant, and how many of the states that are estimated each row of C accounts for;
    /// `None` if the plant is a chain, or was not read.
    pub(super) fn linear(
        &mut self,
        spec: &Spec,
        delay: &Delay,
        disturbance: Option<&Disturbance>,
    ) -> Option<(Linear, Vec<usize>)> {
        let Some(a) = self.keys.get("A").copied() else {
            for key in ["B", "C"] {
                if let Some(node) = self.keys.get(key).copied() {
                    let message = format!("`{key}` without `A`");
                    let help = "give the plant x' = A x + B u by both, or leave it out for a chain";
                    self.wrong(key, Some(node.place), message, help.to_owned());
                }
            }
            return None;
        };
        let n = spec.n;
        for (key, help) in [
            (
                "f",
                "subtract a known constant from u outside, or estimate it: disturbance = \"constant\"",
            ),
            ("g", "B holds the gain of the input"),
        ] {
            if let Some(node) = self.keys.get(key).copied() {
                let message = format!("`{key}` beside `A`: it is of a chain");
                self.found.push("conflict", key, Some(node.place), message, help.to_owned());
            }
        }
        let given = rows(a).len();
        if given > MAX_LINEAR {
            let message = format!("A has {}", counted(&given, "row"));
            let help = format!("the order of a linear plant is at most {MAX_LINEAR}");
            self.wrong("A", Some(a.place), message, help);
            return None;
        }
        self.names_of_states(n);
        let a_rows = self.matrix("A", a, Some(n), n);
        let b = match self.keys.get("B").copied() {
            Some(b) => self.row("B", b, n),
            None => {
                let message = "`B` is missing".to_owned();
                let help = format!("give {}: x' = A x + B u", counted(&n, "number"));
                self.found.push("missing-key", "B", None, message, help);
                None
            }
        };
        let c = match self.only_one(&["C", "measured"]) {
            Some(("C", c)) => self.matrix("C", c, None, n),
            Some((_, names)) => self.named_states(names, n),
            None => Some((0..n).map(|i| unit(i, n)).collect()),
        };
        let h = spec.promises.sample_time.as_ref().and_then(Fixed::number).cloned();
        if h.is_none() && !self.keys.contains_key("sample_time") {
            let message = "`sample_time` is missing".to_owned();
            let help = "a linear plant is sampled when the code is generated: give the period in s";
            self.found.push("missing-key", "sample_time", None, message, help.to_owned());
        }
        let (plant, h) = (Linear { a: a_rows?, b: b?, c: c? }, h?);
        // Nothing has to be controlled for an observer alone.
        let delay = (spec.what != What::Observer).then_some(delay);
        match linear::examine(&plant, &h, delay, disturbance, spec.precision) {
            Ok(blocks) => Some((plant, blocks)),
            Err(ill) => {
                self.ill(&ill, disturbance.is_some());
                None
            }
        }
    }

    fn ill(&mut self, ill: &Ill, disturbance: bool) {
        let place = |key: &str| self.keys.get(key).map(|node| node.place);
        let eigenvalue = |mode: &Option<Complex>| match mode {
            Some(mode) if mode.is_complex() => {
                format!("s = {} +- {}i", digits(mode.re), digits(mode.im))
            }
            Some(mode) => format!("s = {}", digits(mode.re)),
            None => "an unknown eigenvalue".to_owned(),
        };
        let number = |condition: f64| match condition.is_finite() {
            true => format!("condition number {}", digits(condition)),
            false => "infinite condition number".to_owned(),
        };
        let (key, message, help) = match ill {
            Ill::Fast => (
                "A",
                "A h is too large: a mode grows or decays by more than e^1000 in a sample".to_owned(),
                "leave modes out that die within a sample, take a shorter sample_time, or other units".to_owned(),
            ),
            Ill::Dependent => (
                "C",
                "a row of C is a combination of the others".to_owned(),
                "leave it out: it shows nothing new".to_owned(),
            ),
            Ill::Uncontrollable { condition, mode } => (
                "B",
                format!(
                    "the sampled plant is not controllable with enough digits: {}; the input hardly reaches the mode {} 1/s",
                    number(*condition),
                    eigenvalue(mode)
                ),
                "leave out a mode that the input does not reach, one of two equal modes, or one that dies within a sample; oscillations need another sample_time than a multiple of half their period".to_owned(),
            ),
            Ill::Unobservable { condition, mode } => (
                if self.keys.contains_key("measured") { "measured" } else { "C" },
                format!(
                    "the sampled plant is not observable with enough digits: {}; what is measured hardly shows the mode {} 1/s",
                    number(*condition),
                    eigenvalue(mode)
                ),
                match disturbance {
                    true => "measure more, or leave the mode out; a constant disturbance shows only where the plant passes a constant input on to what is measured".to_owned(),
                    false => "measure more, or leave the mode out".to_owned(),
                },
            ),
        };
        let place = place(key);
        self.wrong(key, place, message, help);
    }

    /// Rows of `columns` numbers each.
    fn matrix(
        &mut self,
        key: &'static str,
        node: &Node,
        count: Option<usize>,
        columns: usize,
    ) -> Option<Vec<Vec<BigRational>>> {
        let nodes = rows(node);
        if let Some(count) = count.filter(|count| *count != nodes.len()) {
            let message =
                format!("{key} has {} for order n = {count}", counted(&nodes.len(), "row"));
            let help =
                format!("give {} of {}", counted(&count, "row"), counted(&columns, "number"));
            self.wrong(key, Some(node.place), message, help);
            return None;
        }
        if nodes.is_empty() || nodes.len() > columns {
            let message = format!("{key} has {}", counted(&nodes.len(), "row"));
            let help = format!(
                "give 1 to {} of {}",
                counted(&columns, "row"),
                counted(&columns, "number")
            );
            self.wrong(key, Some(node.place), message, help);
            return None;
        }
        let read: Vec<_> = nodes.iter().map(|row| self.row(key, row, columns)).collect();
        read.into_iter().collect()
    }

    pub(super) fn row(
        &mut self,
        key: &'static str,
        node: &Node,
        columns: usize,
    ) -> Option<Vec<BigRational>> {
        let entries = items(node);
        if entries.len() != columns {
            let message = format!("a row of {key} has {}", counted(&entries.len(), "number"));
            let help =
                format!("give {}, one for each of x1..x{columns}", counted(&columns, "number"));
            self.wrong(key, Some(node.place), message, help);
            return None;
        }
        let number = |node: &Node| real(node).as_ref().and_then(Fixed::number).cloned();
        let read: Vec<_> = entries.iter().map(number).collect();
        if let Some(wrong) = read.iter().position(Option::is_none) {
            let message = format!("{key} holds {}", shown(&entries[wrong].value));
            let help = "its entries are finite numbers".to_owned();
            self.wrong(key, Some(entries[wrong].place), message, help);
        }
        read.into_iter().collect()
    }

    /// The rows of C for the names of states.
    fn named_states(&mut self, node: &Node, n: usize) -> Option<Vec<Vec<BigRational>>> {
        let index = |item: &Node| match &item.value {
            Value::Word(word) => {
                word.strip_prefix('x')?.parse().ok().filter(|j| (1..=n).contains(j))
            }
            _ => None,
        };
        let named: Option<Vec<usize>> = items(node).iter().map(index).collect();
        let once = |named: &Vec<usize>| (1..).zip(named).all(|(i, j)| !named[i..].contains(j));
        match named.filter(once) {
            Some(named) => Some(named.iter().map(|j| unit(j - 1, n)).collect()),
            None if !self.are_states("measured", node, &chain_states(n)) => None,
            None => {
                let message =
                    format!("measured = {} is not a choice of states", shown(&node.value));
                let help = format!("name each measured state of x1..x{n} once, or give C");
                self.wrong("measured", Some(node.place), message, help);
                None
            }
        }
    }

    /// The gains of each block of poles.
    pub(super) fn gains_of_blocks(
        &mut self,
        key: &'static str,
        poles: &[(BigRational, BigRational)],
        blocks: &[usize],
        node: &Node,
    ) -> Vec<BigRational> {
        let of = |(re, im): &(BigRational, BigRational)| Pole { re: re.clone(), im: im.clone() };
        let mut all = Vec::with_capacity(poles.len());
        let mut rest = poles;
        for size in blocks {
            let (own, others) = rest.split_at((*size).min(rest.len()));
            rest = others;
            match gains(&own.iter().map(of).collect::<Vec<_>>()) {
                Ok(gains) => all.extend(gains),
                Err(_) => {
                    let sizes: Vec<_> = blocks.iter().map(ToString::to_string).collect();
                    let message = format!("{key} parts a complex pair");
                    let help = format!(
                        "the rows of C take {} of the poles in turn: keep each pair in one row",
                        sizes.join(", ")
                    );
                    self.wrong(key, Some(node.place), message, help);
                    return Vec::new();
                }
            }
        }
        all
    }
}

/// The rows of a matrix; a single row needs no outer brackets.
fn rows(node: &Node) -> &[Node] {
    match &node.value {
        Value::List(items) if items.iter().any(|item| matches!(item.value, Value::List(_))) => {
            items
        }
        _ => std::slice::from_ref(node),
    }
}

fn unit(at: usize, n: usize) -> Vec<BigRational> {
    (0..n).map(|j| if j == at { integer(1) } else { BigRational::zero() }).collect()
}
