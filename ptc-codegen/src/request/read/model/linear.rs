//! A model whose clock is in samples: a linear one is the same plant as A, B and C, any other is
//! measured whole, and known at the samples alone.

use num_traits::Zero;

use super::super::{Reader, count, items, shown, suggestion};
use super::names::word;
use crate::algebra::BigRational;
use crate::diagnostic::{Place, near_miss};
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};
use crate::model::Model;
use crate::parameter::{Fixed, Name, Parameter};
use crate::request::{Entry, MAX_ORDER, Spec, What};
use crate::syntax::{Node, Value};

/// The keys that A, B and C stand for.
const REPLACED: [&str; 5] = ["input", "output", "dynamics", "let", "measured"];

/// Reason why a model is not A, B and C: key, place, message, help.
type Refusal = (&'static str, Option<Place>, String, String);

/// Help text on legal models.
const LEGAL: &str =
    "a clock in samples takes a linear model with rational numbers; leave `clock` out for this one";

/// An expression as a row: its slopes by the states and by the input.
struct Row {
    states: Vec<BigRational>,
    input: BigRational,
}

impl Reader<'_> {
    /// The entries of a design in samples with A, B and C in place of its linear model; `None` where
    /// there is no such model, or something is wrong with it.
    pub(in crate::request::read) fn as_linear_plant(
        &mut self,
        entries: &[Entry],
    ) -> Option<Vec<Entry>> {
        let clock = self.keys.get("clock").map(|node| &node.value);
        if !matches!(clock, Some(Value::Word(word)) if word == "samples") {
            return None;
        }
        if !self.found.is_empty() {
            return None;
        }
        // Mistakes in the model are reported when the design is read with it.
        let model = self.model().map(|read| read.model);
        let found = std::mem::take(&mut self.found);
        let model = model.filter(|_| found.is_empty())?;
        let n = self.keys.get("n").map(|node| count(node, MAX_ORDER));
        let takes_a = parameters(&model).any(|name| name == "a");
        if takes_a || n.is_some_and(|n| n != Some(model.states.len())) {
            return None;
        }
        let plant = self.linear_rows(&model).ok()?;
        let output = self.row_of_output(&model);
        let used: Vec<_> = parameters(&model).map(|name| format!("params.{name}")).collect();
        let replaced =
            |entry: &&Entry| REPLACED.contains(&entry.key.as_str()) || used.contains(&entry.key);
        let kept = entries.iter().filter(|entry| !replaced(entry)).cloned();
        Some(kept.chain(plant).chain(output).collect())
    }

    /// A, B, and C or the measured states of a model.
    fn linear_rows(&self, model: &Model) -> Result<Vec<Entry>, Vec<Refusal>> {
        let place = |key: &str| self.keys.get(key).map_or(Place(0), |node| node.place);
        let mut wrong = Vec::new();
        let mut rows = Vec::new();
        let nodes = self.rate_places(model);
        for ((state, rate), at) in model.states.iter().zip(&model.dynamics).zip(nodes) {
            match self.slopes(model, &format!("{state}'"), rate) {
                Ok(row) => rows.push(row),
                Err((message, help)) => wrong.push(("dynamics", at, message, help)),
            }
        }
        let measured = self.keys.get("measured").copied();
        let shown = match measured {
            Some(node) => measured_states(node, model),
            None => self.slopes(model, "the output", &model.output).map(|row| {
                ("C", list(vec![numbers(&row.states, place("output"))], place("output")))
            }),
        };
        match shown {
            Ok((key, value)) if wrong.is_empty() => {
                let at = place("dynamics");
                let a = rows.iter().map(|row| numbers(&row.states, at)).collect();
                let b: Vec<_> = rows.iter().map(|row| row.input.clone()).collect();
                let entry = |key: &str, value: Node| Entry {
                    key: key.to_owned(),
                    place: value.place,
                    value,
                };
                let plant = [("A", list(a, at)), ("B", numbers(&b, at)), (key, value)];
                Ok(plant.map(|(key, value)| entry(key, value)).to_vec())
            }
            Ok(_) => Err(wrong),
            Err((message, help)) => {
                let key = if measured.is_some() { "measured" } else { "output" };
                wrong.push((key, Some(place(key)), message, help));
                Err(wrong)
            }
        }
    }

    /// The output as a row, where it follows a reference.
    fn row_of_output(&self, model: &Model) -> Option<Entry> {
        let place = self.keys.get("output").filter(|_| self.keys.contains_key("reference"))?.place;
        let row = self.slopes(model, "the output", &model.output).ok()?;
        Some(Entry { key: "output".to_owned(), place, value: numbers(&row.states, place) })
    }

    /// Returns true if a model is linear in the states and the input, whatever its parameters are.
    pub(in crate::request::read) fn is_linear(&self, model: &Model) -> bool {
        self.curved(model).is_none()
    }

    /// Describes the nonlinear part of a model, with a slope that shows it.
    pub(super) fn curved(&self, model: &Model) -> Option<String> {
        let values = self.fixed_names();
        let moves = Expression::varies;
        let of_states = (1..=model.states.len()).map(Variable::State);
        let variables: Vec<_> = of_states.chain([Variable::Control]).collect();
        let rates = model.states.iter().map(|state| format!("{state}'")).zip(&model.dynamics);
        let mut all = rates.chain([("the output".to_owned(), &model.output)]);
        all.find_map(|(name, e)| {
            let valued = e.known(&|p| values.get(&p).cloned());
            let slope = |by: &Variable| normal(&valued.derivative(*by));
            let (by, slope) = variables.iter().map(|by| (by, slope(by))).find(|(_, s)| moves(s))?;
            let [by, slope] = [&(*by).into(), &slope].map(|e| model.text(e));
            let text = model.text(e);
            Some(format!("{name} = {text} is not linear: its slope by {by} is {slope}"))
        })
    }

    /// Reports why a linear model has no clock in samples.
    pub(super) fn not_sampled_exactly(&mut self, model: &Model) {
        for (key, place, message, help) in self.linear_rows(model).err().unwrap_or_default() {
            self.found.push("bad-model", key, place, message, help);
        }
    }

    /// Refuses what is sampled exactly in a linear model alone, and says `wanted` in place of it.
    pub(super) fn is_measured_whole(&mut self, spec: &Spec, states: &[Name], wanted: &str) {
        let names: Vec<_> = states.iter().map(|state| state.text()).collect();
        let all = self.keys.get("measured").is_none_or(|node| {
            items(node).iter().map(|item| word(item).unwrap_or_default()).eq(names.iter().copied())
        });
        let keeps = self.keys.get("disturbance").is_some_and(|node| word(node) != Some("none"));
        let late = spec.promises.delay.as_ref().is_some_and(|delay| delay.samples() > 0.0);
        for (key, wrong, what) in [
            ("measured", !all, "an observer"),
            ("disturbance", keeps, "an observer"),
            ("what", spec.what == What::Observer, "an observer"),
            ("delay", late, "the prediction over a delay"),
        ] {
            if let Some(node) = self.keys.get(key).copied().filter(|_| wrong) {
                let message = format!("{what} needs {wanted}");
                let help =
                    format!("leave `{key}` out: `step` takes all states, {}", names.join(", "));
                self.found.push("conflict", key, Some(node.place), message, help);
            }
        }
    }

    /// Returns the places of the rates of the states.
    fn rate_places(&self, model: &Model) -> Vec<Option<Place>> {
        let Some(node) = self.keys.get("dynamics").copied() else { return Vec::new() };
        let of = |state: &Name| match &node.value {
            Value::Table(rates) => rates
                .iter()
                .find(|rate| rate.name.as_ref().is_some_and(|(name, _)| name == state.text()))
                .map(|rate| rate.value.place),
            _ => None,
        };
        let in_order = items(node).iter().map(|rate| Some(rate.place));
        match &node.value {
            Value::Table(_) => model.states.iter().map(of).collect(),
            _ => in_order.collect(),
        }
    }

    /// The slopes of an expression called `name`; where they are no numbers, why, and what is legal.
    fn slopes(
        &self,
        model: &Model,
        name: &str,
        expression: &Expression,
    ) -> Result<Row, (String, String)> {
        let text = model.text(expression);
        let values = self.fixed_names();
        let open = expression.parameters().into_iter().find(|of| !values.contains_key(of));
        if let Some(open) = open {
            let open = open.spelling();
            let message =
                format!("{name} = {text} has the parameter `{open}`, which has no number");
            let help = format!(
                "a plant in samples is sampled when the code is generated: give `{open}` one number under [params], not bounds"
            );
            return Err((message, help));
        }
        let valued = expression.substitute(&|e| {
            let value = e.parameter().and_then(|parameter| values.get(&parameter))?;
            Some(Expression::from(value.clone()))
        });
        let slope = |by: Variable| {
            let slope = normal(&valued.derivative(by));
            slope.number().cloned().ok_or_else(|| {
                let of = model.text(&by.into());
                let slope = model.text(&slope);
                let message =
                    format!("{name} = {text} is not linear: its slope by {of} is {slope}, which is not a rational number");
                (message, LEGAL.to_owned())
            })
        };
        let states: Result<Vec<_>, _> =
            (1..=model.states.len()).map(|j| slope(Variable::State(j))).collect();
        let row = Row { states: states?, input: slope(Variable::Control)? };
        let rest = normal(&valued.substitute(&|e| {
            matches!(e.variable()?, Variable::State(_) | Variable::Control)
                .then(|| Expression::integer(0))
        }));
        if !rest.number().is_some_and(Zero::is_zero) {
            let message = format!("{name} = {text} is {rest} at rest, not 0");
            let help = "take states that are 0 at rest; a constant beside the input is subtracted from u outside, or estimated: disturbance = constant";
            return Err((message, help.to_owned()));
        }
        Ok(row)
    }
}

/// The parameters of a model, by their names in [params].
fn parameters(model: &Model) -> impl Iterator<Item = String> {
    let all = model.dynamics.iter().chain([&model.output]).flat_map(Expression::parameters);
    all.filter(|parameter| matches!(parameter, Parameter::Named(_))).map(|of| of.spelling())
}

/// The measured states, x1, x2, ..., by their names in the model.
fn measured_states(node: &Node, model: &Model) -> Result<(&'static str, Node), (String, String)> {
    let mut named = Vec::new();
    for item in items(node) {
        let text = word(item).unwrap_or_default();
        let Some(index) = model.states.iter().position(|state| state.text() == text) else {
            let message = format!("measured = {} is no state of the model", shown(&item.value));
            let names = model.states.iter().map(|state| state.text());
            let all = names.clone().collect::<Vec<_>>().join(", ");
            let legal = format!("the states are {all}; without `measured` the output is measured");
            return Err((message, suggestion(near_miss(text, names), &legal)));
        };
        let value = Value::Word(format!("x{}", index + 1));
        named.push(Node { value, place: item.place });
    }
    Ok(("measured", list(named, node.place)))
}

fn list(items: Vec<Node>, place: Place) -> Node {
    Node { value: Value::List(items), place }
}

fn numbers(values: &[BigRational], place: Place) -> Node {
    let number = |value: &BigRational| {
        let number = Fixed::Number { value: value.clone(), text: value.to_string() };
        Node { value: Value::Number(number), place }
    };
    list(values.iter().map(number).collect(), place)
}
