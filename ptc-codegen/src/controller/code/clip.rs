//! Results of each of several axes, in loops over all.

use super::Builder;
use super::axes::{WANTED, each};
use super::given::OfAll;
use crate::code::{
    AXIS, Bounds, Ending, Expr, Finish, Index, Place, Shape, Standing, Statement, Status, Test,
    Whose,
};
use crate::expression::Function::Abs;
use crate::internal::fault;
use crate::program::{Input, number};

/// 1 where a v is not within its bounds.
const OUTSIDE: &str = "outside";

impl Builder<'_> {
    /// Returns the statements for the results of each axis, and the status of the call. Most often no v is outside of
    /// its bounds: a loop that only searches for one takes fewer instructions than one that clips.
    pub(super) fn clipped_axes(&self, count: usize) -> Vec<Statement> {
        let Some(axis) = self.program.axis else { fault("gains without an axis") };
        let inputs = self.inputs_of_axis(axis);
        let (limit, mut statements, within) = self.bounds_of_axes();
        let n = self.spec.n;
        let finite = |input: &Input| Test::Finite(OfAll::Each.element(*input, n));
        let first: Vec<_> = inputs.local.iter().map(finite).collect();
        let legal: Vec<_> = self.arrays().iter().map(finite).collect();
        let clipped = Self::outside(&limit);
        let otherwise = match self.guarded() {
            false => clipped,
            true => Finish::choose(Test::All(legal), clipped, Finish::Fail(Status::Input)),
        };
        let mut refused = ends(&otherwise);
        let of_first = Statement::Settle(Whose::Call, Standing::Of(of_axis()));
        refused.push(Statement::If(Test::Stands(Whose::Call), vec![of_first], Vec::new()));
        let wanted = || Expr::At(WANTED.to_owned(), Index::of(AXIS));
        let same = Statement::Settle(of_axis(), Standing::Of(Whose::Call));
        // Lines, of which -mavx2 makes fewer instructions than of a loop.
        statements.extend((0..count).map(|axis| {
            let own = Index::at(axis);
            Statement::Set(Place::Input(own.clone()), Expr::At(WANTED.to_owned(), own))
        }));
        statements.push(each(count, vec![same]));
        let v = Statement::Let("v".to_owned(), Shape::Real, wanted());
        let legal = Test::All(first.into_iter().chain(within).collect());
        let found = Statement::Set(Place::Local(OUTSIDE.to_owned()), Expr::Count(1));
        let search = Statement::If(legal.clone(), Vec::new(), vec![found, Statement::Leave]);
        statements.push(Statement::Begin(OUTSIDE.to_owned(), Shape::Count, Expr::Count(0)));
        statements.push(each(count, vec![v.clone(), search]));
        let nothing = vec![each(count, vec![give(Expr::integer(0))])];
        let rare = vec![
            each(count, vec![v, Statement::If(legal, Vec::new(), refused)]),
            Statement::If(Test::Fails(Whose::Call), nothing, Vec::new()),
        ];
        let is_outside = Test::CountEqual(Expr::local(OUTSIDE), Expr::Count(1));
        statements.push(Statement::If(is_outside, rare, Vec::new()));
        statements
    }

    /// The limits of u of an axis, what is computed before the loops, and the tests of v.
    fn bounds_of_axes(&self) -> (Bounds, Vec<Statement>, Vec<Test>) {
        let limit = self.limits_of_axis(|name| Expr::At(name, Index::of(AXIS)));
        let Some(shared @ Expr::Field(_)) = limit.of_size() else {
            let within = Self::within(&limit);
            return (limit, Vec::new(), within);
        };
        // One test for both, that v is finite and that it is within a bound which may be infinite.
        let greatest = Expr::Number(number::finite(self.spec.precision.greatest()));
        let less = Test::Less(shared.clone(), greatest.clone());
        let bound = Expr::choose(less, shared.clone(), greatest);
        let size = Expr::Call(Abs, Box::new(Expr::local("v")));
        let within = Test::AtMost(size, Expr::local("bound"));
        (limit, vec![Statement::Let("bound".to_owned(), Shape::Real, bound)], vec![within])
    }
}

fn give(value: Expr) -> Statement {
    Statement::Set(Place::Input(Index::of(AXIS)), value)
}

/// The status of an axis.
fn of_axis() -> Whose {
    Whose::Input(Index::of(AXIS))
}

/// The end of a call for one axis. Where it fails every u becomes 0 in the end.
fn ends(finish: &Finish) -> Vec<Statement> {
    let settle = |status| Statement::Settle(of_axis(), Standing::Known(status));
    match finish {
        Finish::If(test, yes, no) => vec![Statement::If(test.clone(), ends(yes), ends(no))],
        Finish::Fail(status) => vec![settle(*status)],
        Finish::Give(values, Ending::Known(status)) => {
            let given = values.iter().cloned().map(give);
            given.chain([settle(*status)]).collect()
        }
        other => fault(format!("an axis ends with {other:?}")),
    }
}
