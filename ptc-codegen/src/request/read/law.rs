//! The law: gains, poles, or an expression; and the input gain of the plant.

use std::collections::BTreeMap;

use num_traits::Zero;

use super::{FixedValues, Reader, items, shown};
use crate::algebra::BigRational;
use crate::expression::effort::bounded;
use crate::expression::normal::normal;
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Feedback, Pole, gains};
use crate::syntax::{Node, Value, constant};

/// What the keys of the law say.
pub(super) struct Law {
    pub(super) feedback: Feedback,
    pub(super) gains: FixedValues,
    pub(super) poles: Vec<(BigRational, BigRational)>,
}

/// k_1, ..., k_n where a law is -(k_1 xi_1 + ... + k_n xi_n) with numbers k_i, however it is spelt, as
/// far as that is found within the effort.
fn gains_of(law: &Expression, n: usize) -> Option<Vec<BigRational>> {
    let other = |e: &Expression| e.variable().is_some_and(|v| !matches!(v, Variable::Xi(_)));
    if law.any(&Expression::is_kink) || law.any(&other) {
        return None;
    }
    bounded(|| {
        let (mut rest, mut gains) = (law.clone(), Vec::with_capacity(n));
        for xi in (1..=n).map(Variable::Xi) {
            law.differentiable()?;
            let slope = normal(&law.derivative(xi));
            rest = rest.sub(slope.clone().mul(xi.into()));
            gains.push(-slope.number()?);
        }
        let linear = normal(&rest) == Expression::integer(0);
        (linear && !gains.iter().all(Zero::is_zero)).then_some(gains)
    })
}

/// Gains that are fixed, as a reader would spell them.
fn fixed(gains: Vec<BigRational>) -> FixedValues {
    let gain = |(i, value): (usize, BigRational)| {
        let text = constant::text(&value);
        (Parameter::Gain(i), Fixed::Number { value, text })
    };
    (1..).zip(gains).map(gain).collect()
}

impl Reader<'_> {
    /// The law; `n` is the order if it could be read, and `order` is used in its place.
    pub(super) fn law(&mut self, n: Option<usize>, order: usize, known: &[Parameter]) -> Law {
        let mut law = Law { feedback: Feedback::Linear, gains: BTreeMap::new(), poles: Vec::new() };
        match self.only_one(&["gains", "poles", "pi0"]) {
            Some(("gains", node)) => law.gains = self.gains(n, node).into_iter().collect(),
            Some(("poles", node)) => {
                let (poles, gains) = self.pole_gains("poles", n, node);
                (law.poles, law.gains) = (poles, fixed(gains));
            }
            Some((_, node)) if matches!(&node.value, Value::Word(word) if word == "extern") => {
                law.feedback = Feedback::Extern;
            }
            Some((_, node)) => {
                let scope = Scope { subject: Subject::Law, n: order, known, own: &[] };
                if let Some(expression) = resolve(node, scope, &mut self.found) {
                    match gains_of(&expression, order) {
                        Some(gains) => law.gains = fixed(gains),
                        None => law.feedback = Feedback::Expression(expression),
                    }
                }
            }
            None => {}
        }
        law
    }

    /// The known f of a chain, which a clock in time cancels at any state; 0 is none at all.
    pub(super) fn drift(&mut self, n: usize, known: &[Parameter]) -> Option<Expression> {
        let node = self.keys.get("f").copied()?;
        let scope = Scope { subject: Subject::Force, n, known, own: &[] };
        let drift = resolve(node, scope, &mut self.found)?;
        (drift != Expression::integer(0)).then_some(drift)
    }

    /// The input gain; 1 is none at all.
    pub(super) fn input_gain(&mut self, n: usize, known: &[Parameter]) -> Option<Expression> {
        let node = self.keys.get("g").copied()?;
        let scope = Scope { subject: Subject::InputGain, n, known, own: &[] };
        let gain = resolve(node, scope, &mut self.found)?;
        if normal(&gain) == Expression::integer(0) {
            let message = "g = 0: the input does not move the plant".to_owned();
            self.wrong("g", Some(node.place), message, "g(x, t) is not 0".to_owned());
        }
        (gain != Expression::integer(1)).then_some(gain)
    }

    /// The poles under `key`, and the gains that they give, exactly.
    pub(super) fn pole_gains(
        &mut self,
        key: &'static str,
        n: Option<usize>,
        node: &Node,
    ) -> (Vec<(BigRational, BigRational)>, Vec<BigRational>) {
        let nothing = (Vec::new(), Vec::new());
        let items = items(node);
        if let Some(n) = n
            && items.len() != n
        {
            let wanted = match key {
                "observer_poles" | "after_observer" => format!("{n} values that are estimated"),
                _ => format!("order n = {n}"),
            };
            let message = format!("{} poles for {wanted}", items.len());
            let help =
                format!("give {n} poles; a complex one counts with its conjugate: -1+2i, -1-2i");
            self.wrong(key, Some(node.place), message, help);
            return nothing;
        }
        let mut poles = Vec::with_capacity(items.len());
        for (index, item) in items.iter().enumerate() {
            let Some(pole) = constant::complex(item) else {
                let message = format!("{key}[{index}] = {} is not a number", shown(&item.value));
                let help = "a pole is a number such as -4, or -1+2i".to_owned();
                self.wrong(key, Some(item.place), message, help);
                continue;
            };
            poles.push(pole);
        }
        if poles.len() != items.len() {
            return nothing;
        }
        let of = |(re, im): &(BigRational, BigRational)| Pole { re: re.clone(), im: im.clone() };
        match gains(&poles.iter().map(of).collect::<Vec<_>>()) {
            Ok(gains) => (poles, gains),
            Err(wrong) => {
                self.wrong(
                    key,
                    Some(node.place),
                    wrong.to_string(),
                    "complex poles come in pairs: -1+2i, -1-2i".to_owned(),
                );
                nothing
            }
        }
    }

    /// The gains as far as they are legal, whether or not the order is.
    fn gains(&mut self, n: Option<usize>, node: &Node) -> Vec<(Parameter, Fixed)> {
        let items = items(node);
        if let Some(n) = n
            && items.len() != n
        {
            let message = format!("{} gains for order n = {n}", items.len());
            let help = format!("give k_1..k_{n}, one for each of xi_1..xi_{n}");
            self.wrong("gains", Some(node.place), message, help);
            return Vec::new();
        }
        let gain = |(index, item): (usize, &Node)| {
            let parameter = Parameter::Gain(index + 1);
            let key = format!("gains[{index}]");
            self.parameter(&key, parameter, item).map(|value| (parameter, value))
        };
        items.iter().enumerate().filter_map(gain).collect()
    }
}
