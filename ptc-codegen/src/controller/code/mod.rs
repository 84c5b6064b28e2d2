//! The controller as one program: the functions around the values of the staged program.

mod associated;
mod axes;
mod body;
mod clip;
mod gains;
mod given;
mod guard;
mod inputs;
mod start;
mod step;

use super::Controller;
use super::plan::{Field, Plan, Routine};
use crate::code::{Callback, Cell, Code, Expr, Index, Shape, Statement, Test, Variable};
use crate::internal::fault;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, Limits, Op, Program, Value};
use crate::request::{After, Feedback, Guard, Spec, What};
use body::{Body, body};
use given::Given;

/// The controller as a program that the interpreter runs.
pub fn whole(controller: &Controller<'_>) -> Code {
    let greatest = controller.report.greatest.as_ref();
    of_program(controller.spec(), controller.program, greatest)
}

/// The same of an optimised program, with the greatest value of a parameter that `init` accepts.
pub(crate) fn of_program(
    spec: &Spec,
    program: &Program,
    greatest: Option<&(Parameter, Fixed)>,
) -> Code {
    let parameters: Vec<_> = spec.run_time_parameters().collect();
    let variable = |group: &[Parameter]| {
        let first = group.first()?;
        let shape = first.index().map_or(Shape::Real, |_| Shape::Reals(group.len()));
        Some(Variable::new(first.key(), shape, first.meaning()))
    };
    let groups = parameters.chunk_by(|a, b| a.key() == b.key());
    let parameters = groups.filter_map(variable).collect();
    Builder::new(spec, program, greatest).code(Vec::new(), parameters)
}

/// The controller as a program, with the head of its file and its parameters as they are declared.
pub(crate) fn code(
    controller: &Controller<'_>,
    head: Vec<String>,
    parameters: Vec<Variable>,
) -> Code {
    let greatest = controller.report.greatest.as_ref();
    Builder::new(controller.spec(), controller.program, greatest).code(head, parameters)
}

struct Builder<'a> {
    spec: &'a Spec,
    program: &'a Program,
    greatest: Option<&'a (Parameter, Fixed)>,
    plan: Plan<'a>,
    limits: Limits,
}

impl<'a> Builder<'a> {
    fn new(spec: &'a Spec, program: &'a Program, greatest: Option<&'a (Parameter, Fixed)>) -> Self {
        Self { spec, program, greatest, plan: Plan::new(spec, program), limits: program.limits }
    }

    fn code(&self, head: Vec<String>, parameters: Vec<Variable>) -> Code {
        let field = |of: &Field| Variable::new(of.name.clone(), Shape::Real, of.meaning.clone());
        let code = Code {
            name: self.spec.name(),
            precision: self.spec.precision,
            head,
            parameters,
            fields: self.plan.fields.iter().map(field).collect(),
            gains: self.gains(),
            tables: Vec::new(),
            init: self.init(),
            start: Some(self.start()),
            functions: self.functions(),
        };
        match code.check() {
            Ok(()) => code,
            Err(error) => fault(error),
        }
    }
}

impl Builder<'_> {
    fn functions(&self) -> Vec<crate::code::Function> {
        let mut functions = vec![self.arm()];
        functions.extend(self.arm_for());
        if self.spec.what == What::Associated {
            functions.extend(self.associated());
            return functions;
        }
        if let Some(coupled) = &self.spec.coupled {
            functions.push(self.step_of_inputs(coupled));
            return functions;
        }
        match &self.spec.axes {
            Some(axes) => {
                return [functions, vec![self.tick(), self.axis(), self.all_axes(axes.count)]]
                    .concat();
            }
            None => functions.push(self.step()),
        }
        if !self.program.gains.is_empty() {
            functions.extend([self.tick(), self.axis()]);
        }
        functions
    }

    /// Builds the statements of `routine`; elements of x and r that are `local` are local values.
    fn body(&self, routine: Routine, local: &[Input]) -> Body {
        let given = self.spec.what == What::Associated;
        body(&self.plan, routine, Given { local, xi: given, ..Given::default() })
    }

    /// Returns true if arguments are checked.
    fn guarded(&self) -> bool {
        self.spec.guard == Guard::Full || self.spec.what == What::Associated
    }

    /// The states, and the reference: what a call is given in arrays.
    fn arrays(&self) -> Vec<Input> {
        let states = (1..=self.spec.states()).map(Input::State);
        let count = self.spec.references();
        let Some(coupled) = &self.spec.coupled else {
            return states.chain((0..count).map(Input::Reference)).collect();
        };
        // Behind the order of an output its row is not read.
        let orders = (1..).zip(coupled.orders()).filter(|_| count > 0);
        let rows = orders.flat_map(|(output, order)| {
            (0..=order).map(move |order| Input::ReferenceOf(output, order))
        });
        states.chain(rows).collect()
    }

    /// Such an input as a local value.
    fn local(&self, input: Input) -> Expr {
        match input {
            Input::State(_)
            | Input::StateAtStart(_)
            | Input::Reference(_)
            | Input::ReferenceOf(..) => Expr::local(input.name()),
            other => fault(format!("{other:?} is in no array")),
        }
    }

    /// Such an input in its array.
    fn element(&self, input: Input) -> Expr {
        match input {
            Input::State(j) if self.spec.what == What::Associated => {
                Expr::Element("xi".to_owned(), j - 1)
            }
            Input::State(j) => match self.row() {
                Some(columns) => {
                    let (row, column) = (Index::at((j - 1) / columns), (j - 1) % columns);
                    Expr::Entry("x".to_owned(), Cell { row, column, columns })
                }
                None => Expr::Element("x".to_owned(), j - 1),
            },
            Input::StateAtStart(j) => Expr::Element("x0".to_owned(), j - 1),
            Input::Reference(order) => Expr::Element("r".to_owned(), order),
            Input::ReferenceOf(output, order) => {
                let row = Index::at(output - 1);
                let cell = Cell { row, column: order, columns: self.spec.references() };
                Expr::Entry("r".to_owned(), cell)
            }
            other => fault(format!("{other:?} is in no array")),
        }
    }

    /// Their local values.
    fn locals(&self, inputs: &[Input]) -> Vec<Statement> {
        let local = |input: &Input| match self.local(*input) {
            Expr::Local(name) => Statement::Let(name, Shape::Real, self.element(*input)),
            other => fault(format!("{other:?} is no local value")),
        };
        inputs.iter().map(local).collect()
    }

    /// Tests that t is finite and not before the start.
    fn legal_time(&self) -> Vec<Test> {
        let mut tests = vec![Test::Finite(Expr::local("t"))];
        if let Some(start) = self.limits.start_time {
            tests.push(Test::AtMost(self.field(start), Expr::local("t")));
        }
        tests
    }

    /// A value that `init` or `arm` has left.
    fn field(&self, value: Value) -> Expr {
        match &self.program.get(value).op {
            Op::Number(number) => Expr::Number(number.clone()),
            _ => match self.plan.name(value) {
                Some(name) => Expr::field(name),
                None => fault("a field without a name"),
            },
        }
    }

    fn callbacks(&self) -> Vec<Callback> {
        let law = match &self.spec.coupled {
            Some(coupled) if coupled.outputs.len() > 1 => Callback {
                name: "pi0",
                array: "xi",
                length: coupled.orders().iter().sum(),
                gives: coupled.outputs.len(),
                about: "User-defined laws pi0(xi, t, rate) of all outputs; xi are the states of their chains in stretched time, one output after the other, t is the stretched time kappa + t0, and rate is kappa'.",
            },
            _ => Callback {
                name: "pi0",
                array: "xi",
                length: self.spec.n,
                gives: 1,
                about: "User-defined law pi0(xi, t); t is the stretched time kappa + t0.",
            },
        };
        let after = Callback {
            name: "after",
            array: "x",
            length: self.spec.states(),
            gives: 1,
            about: "User-defined law for t >= t0 + tau.",
        };
        let extern_law = self.spec.feedback == Feedback::Extern;
        let extern_end = self.spec.after == After::Extern && self.spec.what == What::Controller;
        extern_law.then_some(law).into_iter().chain(extern_end.then_some(after)).collect()
    }

    /// The array of the reference, where each call is given it.
    fn reference(&self) -> Option<Variable> {
        let count = self.spec.references();
        if let Some(coupled) = self.spec.coupled.as_ref().filter(|_| count > 0) {
            let orders: Vec<_> = coupled.orders().iter().map(ToString::to_string).collect();
            let about = format!(
                "for each output its reference and the derivatives, up to that of its order, {}; what is behind is not read",
                orders.join(", ")
            );
            return Some(Variable::new("r", Shape::Lists(coupled.outputs.len(), count), about));
        }
        let about =
            format!("reference of x1 and its derivatives, up to that of order {}", self.spec.n);
        (count > 0).then(|| Variable::new("r", Shape::Reals(count), about))
    }

    /// Number of states of an axis, where a call is given those of each in a row.
    fn row(&self) -> Option<usize> {
        self.spec.coupled.as_ref().filter(|coupled| coupled.is_of_axes).map(|_| self.spec.n)
    }

    /// The array of states of the argument `name`.
    fn array(&self, name: &str, about: &str) -> Variable {
        let states = self.spec.states();
        let shape = match self.row() {
            Some(columns) => Shape::Lists(states / columns, columns),
            None => Shape::Reals(states),
        };
        Variable::new(name, shape, about)
    }
}
