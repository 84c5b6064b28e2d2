//! From a controller to its [`Tape`].

mod expressions;
mod functions;
mod statements;

use std::collections::BTreeMap;

use super::tape::{Begun, Ended, Named, Slots, Step, Tape};
use crate::code::{Code, Status, Table, Variable};
use crate::internal::fault;
use crate::program::{Arithmetic, number};

/// Names and their slots.
type Names<'c> = BTreeMap<&'c str, Slots>;

/// Compiles a controller; with the steps that record every branch, where it is `watched`.
pub(super) fn compile(code: &Code, watched: bool) -> Tape {
    let mut writer = Writer::new(code, watched);
    let fields = writer.variables(&code.fields);
    let gains = writer.variables(&code.gains);
    let parameters = writer.variables(&code.parameters);
    writer.parameters = names(&parameters);
    writer.fields = names(&fields);
    code.tables.iter().for_each(|table| writer.table(table));
    writer.block(&code.init);
    let start = code.start.as_ref().map(|start| Begun {
        function: start.function(),
        numbers: start.numbers().map(|number| writer.slot(number)).collect(),
    });
    writer.steps.push(Step::Give(Ended::Known(Status::Ok)));
    let init = writer.finished();
    let own = [names(&fields), names(&gains)];
    let routines = code.functions.iter().map(|function| writer.function(function, &own));
    let routines = routines.collect();
    Tape {
        precision: code.precision,
        parameters,
        fields,
        gains,
        init,
        start,
        routines,
        image: writer.image,
    }
}

fn names(variables: &[Named]) -> BTreeMap<String, Slots> {
    variables.iter().map(|variable| (variable.name.clone(), variable.slots)).collect()
}

/// Steps of one function under way, and the slots of all.
struct Writer<'c> {
    code: &'c Code,
    watched: bool,
    image: Vec<f64>,
    /// Slots of constants, by their bits.
    constants: BTreeMap<u64, usize>,
    parameters: BTreeMap<String, Slots>,
    fields: BTreeMap<String, Slots>,
    tables: BTreeMap<String, Slots>,
    locals: Names<'c>,
    steps: Vec<Step>,
    /// Steps that leave the innermost loop, once its end is known.
    leaving: Vec<usize>,
    /// Steps that end the call with a status.
    failing: Vec<(usize, Status)>,
    /// Results of the function.
    results: Vec<Named>,
    /// The status that statements settle for the call.
    settled: usize,
}

impl<'c> Writer<'c> {
    fn new(code: &'c Code, watched: bool) -> Self {
        Self {
            code,
            watched,
            image: Vec::new(),
            constants: BTreeMap::new(),
            parameters: BTreeMap::new(),
            fields: BTreeMap::new(),
            tables: BTreeMap::new(),
            locals: BTreeMap::new(),
            steps: Vec::new(),
            leaving: Vec::new(),
            failing: Vec::new(),
            results: Vec::new(),
            settled: 0,
        }
    }

    /// New slots.
    fn fresh(&mut self, count: usize) -> Slots {
        let first = self.image.len();
        self.image.resize(first + count, f64::NAN);
        Slots { first, count }
    }

    fn constant(&mut self, value: f64) -> usize {
        let image = &mut self.image;
        *self.constants.entry(value.to_bits()).or_insert_with(|| {
            image.push(value);
            image.len() - 1
        })
    }

    /// Takes the constants of a table over.
    fn table(&mut self, table: &Table) {
        let first = self.image.len();
        let numbers = table.rows.iter().flatten();
        self.image.extend(numbers.map(|exact| number::round(exact, self.code.precision)));
        let slots = Slots { first, count: self.image.len() - first };
        self.tables.insert(table.name.clone(), slots);
    }

    fn variables(&mut self, variables: &[Variable]) -> Vec<Named> {
        let named = |variable: &Variable| {
            let slots = self.fresh(variable.shape.length().unwrap_or(1));
            Named { name: variable.name.clone(), shape: variable.shape, slots }
        };
        variables.iter().map(named).collect()
    }

    fn copy(&mut self, from: usize, to: usize) {
        self.steps.push(Step::Compute(Arithmetic::Copy(from), to));
    }

    /// Lets steps that go on elsewhere go on at the next one.
    fn land(&mut self, steps: &[usize]) {
        let next = self.steps.len();
        for step in steps {
            match &mut self.steps[*step] {
                Step::Unless(_, other) | Step::Go(other) => *other = next,
                other => fault(format!("{other:?} goes nowhere")),
            }
        }
    }

    /// A step that goes on elsewhere.
    fn go(&mut self) -> usize {
        self.steps.push(Step::Go(0));
        self.steps.len() - 1
    }

    fn local(&self, name: &str) -> Slots {
        let known = self.locals.get(name);
        *known.unwrap_or_else(|| fault(format!("{name} is not known")))
    }

    /// The slots of a local value, which it has already where another branch or round defines it too.
    fn define(&mut self, name: &'c str, count: usize) -> Slots {
        let known = self.locals.get(name).filter(|slots| slots.count == count);
        let slots = known.copied().unwrap_or_else(|| self.fresh(count));
        self.locals.insert(name, slots);
        slots
    }
}
