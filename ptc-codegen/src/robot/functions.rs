//! The functions of a robot as a program of statements, from their staged programs.

use super::{Quantity, Request, staged};
use crate::code::{
    Access, Code, Expr, Finish, Function, Owner, Shape, Statement, Status, Test, Variable, Written,
};
use crate::internal::fault;
use crate::program::{Input, Op, Program, Value, passes};
use crate::request::Guard;
use crate::urdf::Robot;

/// The arrays that a function is given: name, and what it holds.
const GIVEN: [(&str, &str); 3] = [
    ("q", "positions of the joints, rad or m"),
    ("v", "velocities of the joints, rad/s or m/s"),
    ("a", "accelerations of the joints, rad/s^2 or m/s^2"),
];

/// The functions of a robot, without a head.
pub fn code(request: &Request, robot: &Robot) -> Code {
    let functions = request.quantities.iter().map(|own| function(request, robot, *own)).collect();
    let code = Code {
        name: request.name(robot),
        precision: request.precision,
        head: Vec::new(),
        parameters: Vec::new(),
        fields: Vec::new(),
        gains: Vec::new(),
        tables: Vec::new(),
        init: Vec::new(),
        start: None,
        functions,
    };
    match code.check() {
        Ok(()) => code,
        Err(error) => fault(error),
    }
}

fn function(request: &Request, robot: &Robot, quantity: Quantity) -> Function {
    let n = robot.bodies.len();
    let program = passes::optimise(staged(request, robot, quantity), &mut |_, _| {});
    let given = &GIVEN[..quantity.arrays()];
    let guarded = request.guard == Guard::Full;
    let inputs = (0..given.len() * n).map(|index| element(index + 1, n));
    let mut body = Vec::new();
    if guarded {
        let finite = inputs.map(Test::Finite).collect();
        body.push(Statement::Require(Test::All(finite), Status::Input));
    }
    let (statements, results) = Writer::new(&program, n).results();
    body.extend(statements);
    let finish = match request.guard {
        Guard::None => Finish::give(results, Status::Ok),
        Guard::Full | Guard::Result => {
            let computed = results.iter().filter(|own| matches!(own, Expr::Local(_)));
            let finite: Vec<_> = computed.cloned().map(Test::Finite).collect();
            let done = Finish::give(results, Status::Ok);
            match finite.is_empty() {
                // What depends on no joint is a number.
                true => done,
                false => Finish::choose(Test::All(finite), done, Finish::Fail(Status::Range)),
            }
        }
    };
    let (result, about) = quantity.result();
    Function {
        name: quantity.function(),
        about: quantity.about(robot),
        owner: Owner::Controller,
        access: Access::Read,
        arguments: given
            .iter()
            .map(|(name, about)| Variable::new(*name, Shape::Reals(n), *about))
            .collect(),
        callbacks: Vec::new(),
        results: vec![Variable::new(result, Shape::Reals(quantity.size(n)), about)],
        failures: match request.guard {
            Guard::Full => vec![Status::Input, Status::Range],
            Guard::Result => vec![Status::Range],
            Guard::None => Vec::new(),
        },
        body,
        finish,
        guarded,
    }
}

/// The element of the arrays of `n` that input `x_j` is, from 1.
fn element(j: usize, n: usize) -> Expr {
    let (array, _) = GIVEN[(j - 1) / n];
    Expr::Element(array.to_owned(), (j - 1) % n)
}

/// Writer of a program without loops as statements: what several values use is a local value.
struct Writer<'a> {
    program: &'a Program,
    /// Number of joints.
    n: usize,
    written: Written,
    body: Vec<Statement>,
    temporaries: usize,
}

impl<'a> Writer<'a> {
    fn new(program: &'a Program, n: usize) -> Self {
        // A result is a local value: it is tested, and then given.
        let written = Written::of(program, &program.watched, 2);
        Self { program, n, written, body: Vec::new(), temporaries: 0 }
    }

    /// The statements, and the results.
    fn results(mut self) -> (Vec<Statement>, Vec<Expr>) {
        for value in self.program.needed(&self.program.watched) {
            let expression = self.value(value);
            self.written.insert(value, expression);
        }
        let watched = self.program.watched.iter();
        let results = watched.map(|result| self.written.expression(*result)).collect();
        (self.body, results)
    }

    fn value(&mut self, value: Value) -> Expr {
        let expression = match &self.program.get(value).op {
            Op::Number(number) => return Expr::Number(number.clone()),
            Op::Input(Input::State(j)) => return element(*j, self.n),
            op => Expr::of(op, &mut |operand| self.written.expression(*operand))
                .unwrap_or_else(|| fault(format!("{op:?} of a robot"))),
        };
        if !self.written.is_shared(value) {
            return expression;
        }
        self.temporaries += 1;
        let name = format!("w{}", self.temporaries);
        self.body.push(Statement::Let(name.clone(), Shape::Real, expression));
        Expr::local(name)
    }
}
