//! The law: gains, poles, or an expression; and the input gain of the plant.

use std::collections::BTreeMap;

use num_traits::Zero;

use super::least_energy::is_least_energy;
use super::{FixedValues, Reader, items, shown};
use crate::algebra::BigRational;
use crate::diagnostic::counted;
use crate::expression::constant::real;
use crate::expression::effort::bounded;
use crate::expression::normal::normal;
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::model::{Coupled, Model};
use crate::parameter::{Fixed, Parameter};
use crate::request::{DelayLaw, Feedback, Pole, Spec, gains};
use crate::syntax::{Node, Value, constant};

/// Values of the keys of the law.
pub(super) struct Law {
    pub(super) feedback: Feedback,
    pub(super) gains: FixedValues,
    pub(super) poles: Vec<(BigRational, BigRational)>,
    /// The expression for each output of a plant with several, where these are no sums of gains.
    pub(super) laws: Vec<Expression>,
    /// The gains of each such output, where the expressions are.
    pub(super) own_gains: Vec<Vec<Fixed>>,
}

impl Law {
    /// Gains that are left to run time.
    pub(super) fn open() -> Self {
        Self {
            feedback: Feedback::Linear,
            gains: BTreeMap::new(),
            poles: Vec::new(),
            laws: Vec::new(),
            own_gains: Vec::new(),
        }
    }
}

/// The gains k where a law is -(k_1 xi_1 + ... ) of these `states` xi with numbers k_i, however it is spelt,
/// as far as that is found within the effort.
pub(super) fn gains_of(
    law: &Expression,
    states: impl Iterator<Item = usize>,
) -> Option<Vec<BigRational>> {
    let other = |e: &Expression| e.variable().is_some_and(|v| !matches!(v, Variable::Xi(_)));
    if law.any(&Expression::is_kink) || law.any(&other) {
        return None;
    }
    bounded(|| {
        let (mut rest, mut gains) = (law.clone(), Vec::new());
        for xi in states.map(Variable::Xi) {
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
pub(super) fn fixed(gains: Vec<BigRational>) -> FixedValues {
    let gain = |(i, value): (usize, BigRational)| {
        let text = constant::text(&value);
        (Parameter::Gain(i), Fixed::Number { value, text })
    };
    (1..).zip(gains).map(gain).collect()
}

impl<'a> Reader<'a> {
    /// The law; `n` is the order if it could be read, and `order` is used in its place. Both count `late` states
    /// of a delay.
    pub(super) fn law(
        &mut self,
        (n, order): (Option<usize>, usize),
        late: usize,
        known: &[Parameter],
        (model, coupled): (Option<&Model>, Option<&Coupled>),
    ) -> Law {
        let mut law = Law::open();
        match self.only_one(&["gains", "poles", "pi0"]) {
            Some(("gains", node)) => {
                let node = self.first("gains", node);
                law.gains = self.gains(n, node).into_iter().collect();
            }
            Some(("poles", node)) => {
                let node = self.first("poles", node);
                let (poles, gains) = self.pole_gains("poles", n, late, node);
                (law.poles, law.gains) = (poles, fixed(gains));
            }
            Some((_, node)) if matches!(&node.value, Value::Word(word) if word == "extern") => {
                law.feedback = Feedback::Extern;
            }
            // What it is of has not been read.
            Some(_) if coupled.is_none() && self.has_coupled() => {}
            Some((_, node))
                if self.keys.contains_key("axes") && matches!(node.value, Value::List(_)) =>
            {
                let message = "axes share one `pi0`, and this is a list".to_owned();
                let help = "give one law for all axes; for a law each, write the chains as one plant under [model], with `inputs` and `outputs`";
                self.wrong("pi0", Some(node.place), message, help.to_owned());
            }
            Some((_, node)) if coupled.is_some() => {
                law = coupled.map_or(law, |coupled| self.laws(node, known, coupled));
            }
            Some((_, node)) => {
                let own = model.map(Model::own_names).unwrap_or_default();
                let scope = Scope { subject: Subject::Law, n: order, known, own: &own };
                let inputs = model.map(|model| vec![(model.input, Variable::Control)]);
                let inputs = inputs.unwrap_or_default();
                let read = resolve(node, scope, &mut self.found);
                let read = read.map(|law| model.map_or(law.clone(), |model| model.put(&law)));
                if let Some(expression) = read.filter(|law| self.gives_inputs(node, law, &inputs)) {
                    match gains_of(&expression, 1..=order) {
                        Some(gains) => law.gains = fixed(gains),
                        None => law.feedback = Feedback::Expression(expression),
                    }
                }
            }
            None => {}
        }
        law
    }

    /// The law of a delay. Left open it predicts, unless there are no poles or gains, or not one for each state of a
    /// plant of `n`.
    pub(super) fn delay_law(&mut self, n: Option<usize>) -> DelayLaw {
        let laws = [(DelayLaw::EXTEND, DelayLaw::Extend), (DelayLaw::PREDICT, DelayLaw::Predict)];
        if let Some(given) = self.choice("delay_law", &laws) {
            return given;
        }
        let given = ["poles", "gains"].into_iter().find_map(|key| self.keys.get(key));
        let of_plant = |node: &Node| is_least_energy(node) || Some(items(node).len()) == n;
        match given.is_some_and(|node| of_plant(node)) {
            true => DelayLaw::Predict,
            false => DelayLaw::Extend,
        }
    }

    /// Refuses r_k of the mapping in pi0 beside a parameter of that name.
    pub(super) fn fits_r(&mut self, spec: &Spec) {
        let is_parameter = |name: &String| {
            let named = |e: &Expression| e.parameter().is_some_and(|p| p.spelling() == *name);
            spec.expressions().any(|e| e.any(&named))
        };
        let both = |e: &Expression| match e.variable() {
            Some(r @ Variable::R(_)) => Some(r.to_string()).filter(is_parameter),
            _ => None,
        };
        let Some(name) = spec.laws().find_map(|law| law.first(&mut |e| both(e))) else { return };
        let node = self.keys.get("pi0").map(|node| node.place);
        let message = format!("`{name}` is a derivative of mu in pi0, and a parameter elsewhere");
        self.found.push("conflict", "pi0", node, message, "give the parameter another name");
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
        let node = self.first("g", node);
        let gain = self.input_gain_of(node, n, known)?;
        (gain != Expression::integer(1)).then_some(gain)
    }

    /// The input gain in one value.
    pub(super) fn input_gain_of(
        &mut self,
        node: &Node,
        n: usize,
        known: &[Parameter],
    ) -> Option<Expression> {
        let scope = Scope { subject: Subject::InputGain, n, known, own: &[] };
        let gain = resolve(node, scope, &mut self.found)?;
        if normal(&gain) == Expression::integer(0) {
            let message = "g = 0: the input does not move the plant".to_owned();
            self.wrong("g", Some(node.place), message, "g(x, t) is not 0".to_owned());
        }
        Some(gain)
    }

    /// The poles under `key`, and the gains that they give, exactly.
    pub(super) fn pole_gains(
        &mut self,
        key: &'static str,
        n: Option<usize>,
        late: usize,
        node: &Node,
    ) -> (Vec<(BigRational, BigRational)>, Vec<BigRational>) {
        let nothing = (Vec::new(), Vec::new());
        if key == "poles" && is_least_energy(node) {
            let poles = n.and_then(|n| self.least_energy(key, n, node)).unwrap_or_default();
            return self.gains_of_poles(key, node, poles);
        }
        let items = items(node);
        if let Some(n) = n
            && items.len() != n
        {
            let wanted = match key {
                "observer_poles" | "after_observer" => format!(
                    "{} that {} estimated",
                    counted(&n, "value"),
                    if n == 1 { "is" } else { "are" }
                ),
                _ if late > 0 => {
                    format!("n + delay = {n}, or order n = {} with delay_law = predict", n - late)
                }
                _ => format!("order n = {n}"),
            };
            let message = format!("{} for {wanted}", counted(&items.len(), "pole"));
            let help = format!(
                "give {}; a complex one counts with its conjugate: -1+2i, -1-2i",
                counted(&n, "pole")
            );
            self.wrong(key, Some(node.place), message, help);
            return nothing;
        }
        let mut poles = Vec::with_capacity(items.len());
        for (index, item) in items.iter().enumerate() {
            let real = || Some((real(item)?.number()?.clone(), BigRational::zero()));
            let Some(pole) = constant::complex(item).or_else(real) else {
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
        self.gains_of_poles(key, node, poles)
    }

    /// Poles with their gains; none of either where a complex one has no conjugate.
    fn gains_of_poles(
        &mut self,
        key: &'static str,
        node: &Node,
        poles: Vec<(BigRational, BigRational)>,
    ) -> (Vec<(BigRational, BigRational)>, Vec<BigRational>) {
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
                (Vec::new(), Vec::new())
            }
        }
    }

    /// The gains as far as they are legal, whether or not the order is.
    pub(super) fn gains(&mut self, n: Option<usize>, node: &Node) -> Vec<(Parameter, Fixed)> {
        let items = items(node);
        if let Some(n) = n
            && items.len() != n
        {
            let message = format!("{} for order n = {n}", counted(&items.len(), "gain"));
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
