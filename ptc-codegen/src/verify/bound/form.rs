//! The expressions of an objective in one canonical form: in T/tau, tau and t0, with fixed values in
//! place.
//!
//! Two enclosures of each are intersected: that of its normal form, which is the same for every
//! spelling and in which parts that are linear in x and u are taken along the trajectory as a whole,
//! and that of what was given, with dt = tau s for its own s. Both hold the value wherever it exists;
//! where it does is decided by the conditions that `existence` lists, never by a normal form.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::algebra::BigRational;
use crate::expression::existence::{self, Condition};
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};
use crate::parameter::Parameter;

/// The values of what is fixed.
pub(super) type Values = BTreeMap<Parameter, BigRational>;

/// An expression that certainly exists where its conditions hold.
#[derive(Clone, Debug)]
pub(super) struct Form {
    pub(super) value: Part,
    /// What each part has to be, and its spelling.
    pub(super) needs: Vec<(Part, Condition, String)>,
}

/// An expression, in two forms that are equal wherever it exists.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// In T/tau, for which `T` stands, with xi_k in place of `linear[k]`.
    pub(super) normal: Expression,
    pub(super) linear: Vec<Linear>,
    /// In T/tau and dt/tau, for which `T` and `dt` stand.
    pub(super) given: Expression,
}

/// sum_v slope_v v + rest, where neither the slopes nor the rest depend on x or u.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    pub(super) slopes: BTreeMap<Variable, Expression>,
    pub(super) rest: Expression,
}

impl Form {
    pub(super) fn new(expression: &Expression, values: &Values) -> Self {
        let needs = existence::needs(expression).into_iter();
        let need = |(part, condition)| {
            let spelt = format!("{expression}");
            (Part::new(&part, values), condition, spelt)
        };
        Self { value: Part::new(expression, values), needs: needs.map(need).collect() }
    }
}

impl Part {
    fn new(expression: &Expression, values: &Values) -> Self {
        let tau = || Expression::from(Parameter::Tau);
        let share = || tau().mul(Variable::TimeToGo.into());
        let fixed = |name: Parameter| {
            values.get(&name).cloned().map_or(Expression::from(name), Expression::Number)
        };
        let with = |elapsed: &dyn Fn() -> Expression| {
            expression.substitute(&|e| match e {
                Expression::Variable(Variable::TimeToGo) => Some(share()),
                Expression::Variable(Variable::Elapsed) => Some(elapsed()),
                Expression::Variable(Variable::Time) => {
                    Some(fixed(Parameter::StartTime).add(elapsed()))
                }
                Expression::Parameter(name) => Some(fixed(*name)),
                _ => None,
            })
        };
        let given = with(&|| tau().mul(Variable::Elapsed.into()));
        let linear = RefCell::new(Vec::new());
        let normal = normal(&with(&|| tau().sub(share()))).substitute(&|e| {
            let part = if moves(e) { Linear::of(e)? } else { return None };
            linear.borrow_mut().push(part);
            Some(Variable::Xi(linear.borrow().len() - 1).into())
        });
        Self { normal, linear: linear.into_inner(), given }
    }
}

/// Whether x or u is in it.
fn moves(expression: &Expression) -> bool {
    expression.any(&|e| {
        matches!(
            e,
            Expression::Variable(
                Variable::State(_) | Variable::Control | Variable::StateAtStart(_)
            )
        )
    })
}

impl Linear {
    /// The sum that an expression is; none where it is no such sum as it is spelt.
    fn of(expression: &Expression) -> Option<Self> {
        use Expression as E;
        if !moves(expression) {
            return Some(Self { slopes: BTreeMap::new(), rest: expression.clone() });
        }
        Some(match expression {
            E::Variable(variable) => {
                let slopes = BTreeMap::from([(*variable, Expression::integer(1))]);
                Self { slopes, rest: Expression::integer(0) }
            }
            E::Neg(a) => Self::of(a)?.map(&E::neg),
            E::Add(a, b) => Self::of(a)?.plus(Self::of(b)?),
            E::Sub(a, b) => Self::of(a)?.plus(Self::of(b)?.map(&E::neg)),
            E::Mul(a, b) if !moves(a) => Self::of(b)?.map(&|e| (**a).clone().mul(e)),
            E::Mul(a, b) if !moves(b) => Self::of(a)?.map(&|e| e.mul((**b).clone())),
            E::Div(a, b) if !moves(b) => Self::of(a)?.map(&|e| e.div((**b).clone())),
            _ => return None,
        })
    }

    fn map(self, to: &dyn Fn(Expression) -> Expression) -> Self {
        let slopes = self.slopes.into_iter().map(|(variable, slope)| (variable, to(slope)));
        Self { slopes: slopes.collect(), rest: to(self.rest) }
    }

    fn plus(mut self, other: Self) -> Self {
        for (variable, slope) in other.slopes {
            let own = self.slopes.remove(&variable);
            let sum = own.map_or(slope.clone(), |own| own.add(slope));
            self.slopes.insert(variable, sum);
        }
        Self { slopes: self.slopes, rest: self.rest.add(other.rest) }
    }
}
