//! From the values that one function computes to statements.

use std::collections::BTreeMap;

use num_traits::ToPrimitive;

use super::given::Given;
use crate::code::{Expr, Index, Iteration, Place, Shape, Statement, Subroutine, parameter_name};
use crate::controller::plan::{Plan, Routine};
use crate::internal::fault;
use crate::program::{Input, Op, Root, Stage, Value};

/// The statements of one function and the expressions of its roots.
pub(super) struct Body {
    pub(super) statements: Vec<Statement>,
    /// One expression for each root, in order.
    pub(super) roots: Vec<Expr>,
    /// Number of local values that have a number for a name.
    pub(super) temporaries: usize,
}

/// Builds the statements of `routine`, from the values that are `given`.
pub(super) fn body(plan: &Plan<'_>, routine: Routine, given: Given<'_>) -> Body {
    let roots = [plan.roots(routine).as_slice(), given.further].concat();
    let mut writer = Writer {
        plan,
        routine,
        temporaries: given.temporaries,
        given,
        elements: Vec::new(),
        uses: uses(plan, routine, &roots),
        known: BTreeMap::new(),
        statements: Vec::new(),
    };
    for value in plan.program.needed(&roots) {
        if !plan.program.get(value).looped && writer.uses.contains_key(&value) {
            writer.value(value);
        }
    }
    let roots = roots.iter().map(|value| writer.expression(*value)).collect();
    Body { statements: writer.statements, roots, temporaries: writer.temporaries }
}

/// Counts the uses of each value in the function; values that only fields need are left out.
fn uses(plan: &Plan<'_>, routine: Routine, roots: &[Value]) -> BTreeMap<Value, usize> {
    let mut uses: BTreeMap<Value, usize> = BTreeMap::new();
    for root in roots {
        *uses.entry(*root).or_default() += 1;
    }
    for value in plan.program.needed(roots).into_iter().rev() {
        if uses.contains_key(&value) && !plan.is_field(routine, value) {
            let op = &plan.program.get(value).op;
            for operand in op.operands() {
                *uses.entry(operand).or_default() += Expr::writes(op);
            }
        }
    }
    uses
}

/// Name of the results of the laws of all outputs.
const LAWS: &str = "laws";

/// The gains of all axes, one axis after the other, or those that they share.
pub(super) const GAIN: &str = "gain";

/// The field of the gains by which u of an axis is divided.
pub(super) const INPUT_GAIN: &str = "input_gain";

/// The sums of which u of an axis is made, level by level.
pub(super) const PARTS: [&str; 2] = ["part", "half"];

struct Writer<'a> {
    plan: &'a Plan<'a>,
    routine: Routine,
    given: Given<'a>,
    /// Elements of the array that is being filled.
    elements: Vec<Expr>,
    uses: BTreeMap<Value, usize>,
    known: BTreeMap<Value, Expr>,
    statements: Vec<Statement>,
    temporaries: usize,
}

impl Writer<'_> {
    /// Returns the expression of a value. For the only user it is moved out: the terms of a sum would be copied with
    /// each term that is added.
    fn expression(&mut self, value: Value) -> Expr {
        let once = self.uses.get(&value) == Some(&1);
        let known = match self.known.get(&value) {
            Some(
                Expr::Neg(_) | Expr::Binary(..) | Expr::Fused(_) | Expr::Call(..) | Expr::Pow(..),
            ) if once => self.known.remove(&value),
            known => known.cloned(),
        };
        known.unwrap_or_else(|| fault(format!("value {} is used before it is computed", value.0)))
    }

    fn all(&mut self, values: &[Value]) -> Vec<Expr> {
        values.iter().map(|value| self.expression(*value)).collect()
    }

    fn name(&self, value: Value) -> String {
        let name = self.plan.name(value);
        name.unwrap_or_else(|| fault(format!("value {} has no name", value.0))).to_owned()
    }

    /// Computes a value: as a statement where it has a name or several users, else in place.
    fn value(&mut self, value: Value) {
        let definition = self.plan.program.get(value);
        if self.plan.is_field(self.routine, value) {
            self.known.insert(value, Expr::field(self.name(value)));
            return;
        }
        let known = match &definition.op {
            // Its tests name it several times.
            Op::Input(Input::Divisor) => {
                let own = match (self.plan.program.divisors.len(), self.given.of_all) {
                    (1, Some(_)) => Expr::local(INPUT_GAIN),
                    (1, None) => Expr::field(INPUT_GAIN),
                    (_, Some(axis)) => Expr::At(INPUT_GAIN.to_owned(), axis.place(1, 0)),
                    (_, None) => Expr::OfAxis(INPUT_GAIN.to_owned(), 1, 0),
                };
                let name = Input::Divisor.name();
                self.statements.push(Statement::Let(name.clone(), Shape::Real, own));
                Expr::local(name)
            }
            Op::Input(input) => self.input(*input),
            Op::Root(root) => self.root(root),
            Op::Law(arguments) if !self.plan.program.others.is_empty() => {
                let [xi @ .., time, rate, place] = arguments.as_slice() else {
                    fault("a law of several outputs without its times")
                };
                self.laws(xi, [*time, *rate]);
                let place = self.expression(*place).number().and_then(ToPrimitive::to_usize);
                let place = place.unwrap_or_else(|| fault("a law without a place"));
                self.define(value, Expr::Element(LAWS.to_owned(), place))
            }
            Op::Law(arguments) => {
                let (time, xi) =
                    arguments.split_last().unwrap_or_else(|| fault("a law without time"));
                let (time, xi) = (self.expression(*time), self.all(xi));
                if !self.given.xi {
                    self.statements.push(Statement::Array("xi".to_owned(), xi));
                }
                self.define(value, Expr::Callback("pi0", "xi".to_owned(), Box::new(time)))
            }
            Op::Rows { tail, weights, fused } => {
                let (tail, weights) = (self.all(tail), self.all(weights));
                let rows = Subroutine::Rows { weights: weights.len(), fused: *fused };
                self.apply(value, rows, [weights, tail])
            }
            Op::Elimination { matrix, right } => {
                let (matrix, right) = (self.all(matrix), self.all(right));
                self.apply(value, Subroutine::Elimination(right.len()), [right, matrix])
            }
            Op::Element(array, index) => match self.expression(*array) {
                Expr::Local(array) => Expr::Element(array, *index),
                other => fault(format!("{other:?} is no array")),
            },
            op => {
                let expression = self.operation(op);
                let shared = self.uses.get(&value).is_some_and(|uses| *uses > 1);
                let named = definition.name.is_some() && definition.stage >= Stage::Init;
                match !self.plan.is_literal(value) && (shared || named) {
                    true => self.define(value, expression),
                    false => expression,
                }
            }
        };
        let known = self.element(value, known);
        self.known.insert(value, known);
    }

    /// Returns the expression of a value, given the `known` one: an element, where it is one of the parts; those of a
    /// level are set behind the last one.
    fn element(&mut self, value: Value, known: Expr) -> Expr {
        let level = self.given.parts.iter().zip(PARTS).find(|(level, _)| level.contains(&value));
        let Some((level, name)) = level else { return known };
        let place = self.elements.len();
        if level.get(place) != Some(&value) {
            fault("the sums of an axis are not computed in their order");
        }
        let axis = self.given.of_all.unwrap_or_else(|| fault("parts of one axis"));
        let of_axis = |place| axis.place(level.len(), place);
        self.elements.push(known);
        if level.last() == Some(&value) {
            for (place, sum) in std::mem::take(&mut self.elements).into_iter().enumerate() {
                let place = Place::Element(name.to_owned(), of_axis(place));
                self.statements.push(Statement::Set(place, sum));
            }
        }
        Expr::At(name.to_owned(), of_axis(place))
    }

    /// Calls the law of all outputs, once.
    fn laws(&mut self, xi: &[Value], times: [Value; 2]) {
        let is_call = |statement: &Statement| matches!(statement, Statement::Call { .. });
        if self.statements.iter().any(is_call) {
            return;
        }
        let (xi, times) = (self.all(xi), times.map(|time| self.expression(time)));
        self.statements.push(Statement::Array("xi".to_owned(), xi));
        self.statements.push(Statement::Call {
            name: LAWS.to_owned(),
            callback: "pi0",
            array: "xi".to_owned(),
            times,
            count: self.plan.program.others.len() + 1,
        });
    }

    /// The local array that a subroutine gives.
    fn apply(&mut self, value: Value, subroutine: Subroutine, given: [Vec<Expr>; 2]) -> Expr {
        let name = self.fresh(value);
        self.statements.push(subroutine.apply(name.clone(), given));
        Expr::local(name)
    }

    fn define(&mut self, value: Value, expression: Expr) -> Expr {
        let name = self.fresh(value);
        self.statements.push(Statement::Let(name.clone(), Shape::Real, expression));
        Expr::local(name)
    }

    fn fresh(&mut self, value: Value) -> String {
        if let Some(name) = self.plan.name(value) {
            return self.given.of_all.map_or(name.to_owned(), |axis| axis.name(name));
        }
        self.temporaries += 1;
        format!("v{}", self.temporaries)
    }

    fn input(&self, input: Input) -> Expr {
        match input {
            Input::Parameter(parameter) => Expr::local(parameter_name(parameter)),
            Input::StartTime => Expr::local("t0"),
            Input::Time => Expr::local("t"),
            Input::State(_) | Input::Reference(_) | Input::StateAtStart(_)
                if self.given.local.contains(&input) =>
            {
                Expr::local(input.name())
            }
            Input::State(j) => self.element_of("x", j - 1, input),
            Input::Reference(order) => self.element_of("r", order, input),
            Input::ReferenceOf(..) => Expr::local(input.name()),
            Input::StateAtStart(j) => Expr::Element("x0".to_owned(), j - 1),
            Input::Gain(j) => {
                let own = self.plan.program.gains_of_axis();
                match (own < self.plan.program.gains.len(), self.given.of_all) {
                    (true, Some(axis)) => Expr::At(GAIN.to_owned(), axis.place(own, j - 1)),
                    (true, None) => Expr::OfAxis(GAIN.to_owned(), own, j - 1),
                    (false, Some(_)) => Expr::At(GAIN.to_owned(), Index::at(j - 1)),
                    (false, None) => Expr::FieldElement(GAIN.to_owned(), j - 1),
                }
            }
            Input::Divisor => fault("an input gain that is not read first"),
            Input::Drift => Expr::local("f"),
            Input::Control | Input::Wanted(_) => fault("a controller does not take u"),
        }
    }

    /// An element of the array `name`, or of that of an axis.
    fn element_of(&self, name: &str, place: usize, input: Input) -> Expr {
        match self.given.of_all {
            Some(axis) => axis.element(input, self.plan.program.gains_of_axis()),
            None => Expr::Element(name.to_owned(), place),
        }
    }

    fn operation(&mut self, op: &Op) -> Expr {
        Expr::of(op, &mut |value| self.expression(*value))
            .unwrap_or_else(|| fault(format!("{op:?} is not a part of an expression")))
    }

    fn root(&mut self, root: &Root) -> Expr {
        let unknown = self.name(root.unknown);
        self.known.insert(root.unknown, Expr::local(unknown.clone()));
        let outside = std::mem::take(&mut self.statements);
        for inner in self.plan.program.needed(&[root.residual, root.next, root.size]) {
            if self.plan.program.get(inner).looped && inner != root.unknown {
                self.value(inner);
            }
        }
        let body = std::mem::replace(&mut self.statements, outside);
        let iteration = Iteration {
            unknown: unknown.clone(),
            start: self.expression(root.start),
            bracket: [root.low, root.high].map(|end| self.expression(end)),
            body,
            residual: self.expression(root.residual),
            next: self.expression(root.next),
            size: self.expression(root.size),
            tolerance: self.expression(root.tolerance),
            proposals: root.proposals,
            rounds: root.rounds,
        };
        self.statements.extend(iteration.statements(self.plan.program.precision));
        Expr::local(unknown)
    }
}
