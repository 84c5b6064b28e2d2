//! The expressions of an objective in one canonical form: in T/tau, tau and t0, with fixed values in
//! place.
//!
//! Two enclosures of each are intersected: that of its normal form, which is the same for every
//! spelling, and that of what was given, with dt = tau s for its own s. In both, parts that are linear
//! in x and u are taken along the trajectory as a whole. Both hold the value wherever it exists; where
//! it does is decided by the conditions that `existence` lists, never by a normal form. Where the sign
//! is known by which abs, sign, min or max is decided, they are replaced by what they are there.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::slice::Iter;

use crate::expression::existence::{self, Condition};
use crate::expression::normal::normal;
use crate::expression::{Expression, Function, Node, Variable};
use crate::parameter::Parameter;
use crate::verify::linear::Values;

/// Patterns of signs for which an expression is brought to its normal form.
const PATTERNS: usize = 64;

/// An expression that certainly exists where its conditions hold.
#[derive(Clone, Debug)]
pub(super) struct Form {
    pub(super) value: Part,
    /// Condition on each part, with its spelling.
    pub(super) needs: Vec<(Part, Condition, String)>,
    /// Expressions whose sign decides each abs, sign, min and max.
    pub(super) kinks: Vec<Part>,
    values: Values,
    /// The value with these decided, by the signs that are known.
    decided: RefCell<BTreeMap<Vec<Option<bool>>, Rc<Part>>>,
}

/// An expression, in two forms that are equal wherever it exists.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// In T/tau, for which `T` stands, with xi_k in place of `linear[k]`.
    pub(super) normal: Expression,
    pub(super) linear: Vec<Linear>,
    /// In T/tau and dt/tau, for which `T` and `dt` stand, with xi_k likewise.
    pub(super) given: Expression,
    /// As the user wrote it.
    pub(super) spelt: Expression,
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
        let mut kinks = Vec::new();
        collect(expression, &mut kinks);
        Self {
            value: Part::new(expression, values),
            needs: needs.map(need).collect(),
            kinks: kinks.iter().map(|of| Part::new(of, values)).collect(),
            values: values.clone(),
            decided: RefCell::default(),
        }
    }

    /// The value where what decides the kinks is positive or negative as `signs` says, in their order;
    /// none where no sign is known.
    pub(super) fn decided(&self, signs: Vec<Option<bool>>) -> Option<Rc<Part>> {
        let mut decided = self.decided.borrow_mut();
        let is_new = decided.len() < PATTERNS || decided.contains_key(&signs);
        (is_new && signs.iter().any(Option::is_some)).then(|| {
            let part = decided.entry(signs).or_insert_with_key(|signs| {
                let smooth = smooth(&self.value.spelt, &mut signs.iter());
                Rc::new(Part::new(&smooth, &self.values))
            });
            Rc::clone(part)
        })
    }
}

/// Collects the expressions that decide each kink, from the outside in and from left to right.
fn collect(expression: &Expression, kinks: &mut Vec<Expression>) {
    if !expression.any(&Expression::is_kink) {
        return;
    }
    match expression.node() {
        Node::Call(Function::Abs | Function::Sign, a) => kinks.push(a.clone()),
        Node::Min(a, b) | Node::Max(a, b) => kinks.push(a.clone().sub(b.clone())),
        _ => {}
    }
    expression.operands().for_each(|operand| collect(operand, kinks));
}

/// The expression with its kinks replaced where their signs, in the order of [`collect`], are known.
fn smooth(expression: &Expression, signs: &mut Iter<'_, Option<bool>>) -> Expression {
    if !expression.any(&Expression::is_kink) {
        return expression.clone();
    }
    let kink = matches!(
        expression.node(),
        Node::Call(Function::Abs | Function::Sign, _) | Node::Min(..) | Node::Max(..)
    );
    let sign = if kink { signs.next().copied().flatten() } else { None };
    let mut inner = |a: &Expression| smooth(a, signs);
    match (expression.node(), sign) {
        (Node::Number(_) | Node::Pi | Node::Parameter(_) | Node::Variable(_), _) => {
            expression.clone()
        }
        (Node::Neg(a), _) => inner(a).neg(),
        (Node::Call(Function::Abs, a), Some(true)) => inner(a),
        (Node::Call(Function::Abs, a), Some(false)) => inner(a).neg(),
        (Node::Call(Function::Sign, a), Some(positive)) => {
            inner(a);
            Expression::integer(if positive { 1 } else { -1 })
        }
        (Node::Call(function, a), _) => Expression::call(*function, inner(a)),
        (Node::Add(a, b), _) => inner(a).add(inner(b)),
        (Node::Sub(a, b), _) => inner(a).sub(inner(b)),
        (Node::Mul(a, b), _) => inner(a).mul(inner(b)),
        (Node::Div(a, b), _) => inner(a).div(inner(b)),
        (Node::Power(a, b), _) => inner(a).power(inner(b)),
        (Node::Min(a, b), sign) => {
            let (a, b) = (inner(a), inner(b));
            match sign {
                Some(true) => b,
                Some(false) => a,
                None => a.min(b),
            }
        }
        (Node::Max(a, b), sign) => {
            let (a, b) = (inner(a), inner(b));
            match sign {
                Some(true) => a,
                Some(false) => b,
                None => a.max(b),
            }
        }
    }
}

impl Part {
    /// Returns true if x and u occur in one linear part alone.
    pub(super) fn is_of_one(&self) -> bool {
        let is_of_one = |form: &Expression| {
            let mut parts = Vec::new();
            form.each(&mut |e| match e.variable() {
                Some(Variable::Xi(k)) if !parts.contains(&k) => parts.push(k),
                _ => {}
            });
            !moves(form) && parts.len() <= 1
        };
        is_of_one(&self.normal) || is_of_one(&self.given)
    }

    fn new(expression: &Expression, values: &Values) -> Self {
        let tau = || Expression::from(Parameter::Tau);
        let share = || tau().mul(Variable::TimeToGo.into());
        let fixed = |name: Parameter| {
            values.get(&name).cloned().map_or(Expression::from(name), Expression::from)
        };
        let with = |elapsed: &dyn Fn() -> Expression| {
            expression.substitute(&|e| match e.node() {
                Node::Variable(Variable::TimeToGo) => Some(share()),
                Node::Variable(Variable::Elapsed) => Some(elapsed()),
                Node::Variable(Variable::Time) => Some(fixed(Parameter::StartTime).add(elapsed())),
                Node::Parameter(name) => Some(fixed(*name)),
                _ => None,
            })
        };
        let linear = RefCell::new(Vec::new());
        let along = |e: &Expression| {
            let part = if moves(e) { Linear::of(e)? } else { return None };
            linear.borrow_mut().push(part);
            Some(Variable::Xi(linear.borrow().len() - 1).into())
        };
        let given = with(&|| tau().mul(Variable::Elapsed.into())).substitute(&along);
        let normal = normal(&with(&|| tau().sub(share()))).substitute(&along);
        Self { normal, linear: linear.into_inner(), given, spelt: expression.clone() }
    }
}

/// Returns true if x or u is in it.
fn moves(expression: &Expression) -> bool {
    expression.any(&|e| {
        matches!(
            e.variable(),
            Some(Variable::State(_) | Variable::Control | Variable::StateAtStart(_))
        )
    })
}

impl Linear {
    /// The linear sum of an expression; `None` if it is not linear as it is spelt.
    pub(super) fn of(expression: &Expression) -> Option<Self> {
        use Expression as E;
        if !moves(expression) {
            return Some(Self { slopes: BTreeMap::new(), rest: expression.clone() });
        }
        Some(match expression.node() {
            Node::Variable(variable) => {
                let slopes = BTreeMap::from([(*variable, Expression::integer(1))]);
                Self { slopes, rest: Expression::integer(0) }
            }
            Node::Neg(a) => Self::of(a)?.map(&E::neg),
            Node::Add(a, b) => Self::of(a)?.plus(Self::of(b)?),
            Node::Sub(a, b) => Self::of(a)?.plus(Self::of(b)?.map(&E::neg)),
            Node::Mul(a, b) if !moves(a) => Self::of(b)?.map(&|e| a.clone().mul(e)),
            Node::Mul(a, b) if !moves(b) => Self::of(a)?.map(&|e| e.mul(b.clone())),
            Node::Div(a, b) if !moves(b) => Self::of(a)?.map(&|e| e.div(b.clone())),
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
