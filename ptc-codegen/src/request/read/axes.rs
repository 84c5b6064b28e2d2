//! Several axes: how many, and what each has of its own.

use super::least_energy::is_least_energy;
use super::reference::OF_AXES;
use super::{Reader, count, items, shown};
use crate::algebra::BigRational;
use crate::diagnostic::counted;
use crate::expression::constant::real;
use crate::expression::{self, Expression};
use crate::limits::AXES;
use crate::model::Arm;
use crate::parameter::{Fixed, Parameter};
use crate::request::{After, Axes, Feedback, Reference, Spec, What};
use crate::syntax::{Node, Value, constant};

/// Keys of the bounds that are alike on all axes, whose states have the same units.
const BOUNDS: [&str; 6] = ["noise", "noise_rms", "sensor_step", "error", "x0_max", "x_max"];

impl<'a> Reader<'a> {
    /// The number of axes; none for one chain.
    pub(super) fn axes(&mut self) -> Option<usize> {
        let node = self.keys.get("axes").copied()?;
        let found = count(node, AXES.size());
        if found.is_none() {
            let message = format!("axes = {} is not a number of axes", shown(&node.value));
            let help = format!("axes is an integer 1..={}", AXES.most);
            self.wrong("axes", Some(node.place), message, help);
        }
        found
    }

    /// The values of a key for each axis, where it has such: those of gains and poles are lists.
    pub(super) fn each(&self, key: &str) -> &'a [Node] {
        let Some(node) = self.keys.get(key).copied() else { return &[] };
        let is_list = |node: &Node| matches!(node.value, Value::List(_));
        let is_own = match key {
            "limits" => true,
            "g" => is_list(node),
            _ => items(node).iter().any(is_list),
        };
        if is_own { items(node) } else { &[] }
    }

    /// The value of a key for the first axis, with which that of one chain is read.
    pub(super) fn first(&self, key: &str, node: &'a Node) -> &'a Node {
        self.each(key).first().unwrap_or(node)
    }

    /// The values of a key for so many axes.
    pub(super) fn for_axes(&mut self, key: &'static str, number: usize) -> &'a [Node] {
        let all = self.each(key);
        if all.is_empty() || all.len() == number {
            return all;
        }
        let place = self.keys.get(key).map(|node| node.place);
        let message =
            format!("{} of `{key}` for {}", counted(&all.len(), "value"), counted(&number, "axis"));
        let help = format!("give one for each of the {number} axes, or one that all share");
        self.wrong(key, place, message, help);
        &[]
    }

    /// Reads the values that differ between the axes of a spec, which is that of the first; each has its order.
    pub(super) fn own_values(
        &mut self,
        spec: &mut Spec,
        orders: &[Option<usize>],
        (laws, gains): (Vec<Expression>, Vec<Vec<Fixed>>),
    ) {
        let number = orders.len();
        let known = super::known(spec.time_mapping.parameters());
        let mut axes = Axes {
            count: number,
            gains,
            poles: Vec::new(),
            exponents: Vec::new(),
            limits: Vec::new(),
            lower: Vec::new(),
            state_max: Vec::new(),
            input_gains: Vec::new(),
            laws,
            references: Vec::new(),
        };
        let first = (1..=spec.n).map(|i| spec.fixed.get(&Parameter::Gain(i)).cloned());
        let first: Option<Vec<Fixed>> = first.collect();
        if let Some((_, rest)) = self.for_axes("gains", number).split_first() {
            let rest = rest.iter().zip(&orders[1..]).map(|(row, n)| {
                self.gains(*n, row).into_iter().map(|(_, gain)| gain).collect::<Vec<_>>()
            });
            axes.gains = first.iter().cloned().chain(rest.collect::<Vec<_>>()).collect();
        } else if let Some(rows) = self.poles_of_axes(orders) {
            axes.gains.extend(first);
            axes.poles.push(spec.poles.clone());
            for (row, n) in rows.into_iter().zip(orders).skip(1) {
                let (poles, gains) = self.pole_gains("poles", *n, 0, row);
                axes.gains.push(super::law::fixed(gains).into_values().collect());
                axes.poles.push(poles);
            }
        }
        self.limits_of_axes(&mut axes);
        self.efforts_of_joints(spec, &mut axes);
        for item in self.for_axes("g", number) {
            let gain = self.input_gain_of(item, spec.n, &known);
            axes.input_gains.extend(gain);
        }
        if let Some(limit) = axes.limits.first() {
            spec.fixed.insert(Parameter::UMax, limit.clone());
        }
        if let Some(limit) = axes.lower.first() {
            spec.fixed.insert(Parameter::UMin, limit.clone());
            spec.u_min = true;
        }
        spec.axes = Some(axes);
    }

    /// Returns the poles of each axis, where each has its own: a list, or their name, which means others for each order.
    fn poles_of_axes(&mut self, orders: &[Option<usize>]) -> Option<Vec<&'a Node>> {
        let named = self.keys.get("poles").copied().filter(|node| is_least_energy(node));
        let differ = orders.iter().any(|n| *n != orders[0]);
        let rows = match named.filter(|_| differ) {
            Some(node) => vec![node; orders.len()],
            None => self.for_axes("poles", orders.len()).iter().collect(),
        };
        (!rows.is_empty()).then_some(rows)
    }

    /// The limits of u of each axis: a bound of |u|, or a pair.
    fn limits_of_axes(&mut self, axes: &mut Axes) {
        let all = self.for_axes("limits", axes.count);
        let pairs = all.iter().any(|item| matches!(item.value, Value::List(_)));
        for item in all {
            let (least, most) = match &item.value {
                Value::List(pair) => match self.pair_of_limits(item, pair) {
                    Some(pair) => pair,
                    None => continue,
                },
                _ => match self.parameter("limits", Parameter::UMax, item) {
                    Some(most) => (most.opposite(), most),
                    None => continue,
                },
            };
            if least.number().is_none() || most.number().is_none() {
                let help = "give a limit that u does not reach, or leave `limits` out for u_max = inf on all axes";
                let message = "an axis without a limit beside others".to_owned();
                self.wrong("limits", Some(item.place), message, help.to_owned());
            }
            axes.limits.push(most);
            axes.lower.extend(pairs.then_some(least));
        }
    }

    /// The efforts of the joints of a robot as their limits, where all have one and the design gives none.
    fn efforts_of_joints(&self, spec: &Spec, axes: &mut Axes) {
        if ["limits", "u_max", "u_min"].iter().any(|key| self.keys.contains_key(key)) {
            return;
        }
        let efforts = spec.arm().and_then(Arm::efforts).unwrap_or_default();
        let limit = |value: BigRational| Fixed::Number { text: constant::text(&value), value };
        axes.limits.extend(efforts.into_iter().map(limit));
    }

    /// `[lower, upper]`.
    fn pair_of_limits(&mut self, item: &Node, pair: &[Node]) -> Option<(Fixed, Fixed)> {
        let values: Vec<_> = pair.iter().filter_map(real).collect();
        if let [least, most] = values.as_slice()
            && pair.len() == 2
            && least.is_below(most)
        {
            return Some((least.clone(), most.clone()));
        }
        let message = format!("limits has {}, which is not a pair of limits", shown(&item.value));
        let help = "give [lower, upper] with lower < upper, or one number, the bound of |u|";
        self.wrong("limits", Some(item.place), message, help.to_owned());
        None
    }

    /// Refuses what has no meaning for several axes, or beside none.
    pub(super) fn fits_axes(&mut self, spec: &Spec, samples: bool) {
        if spec.coupled.is_some() {
            return;
        }
        let Some(axes) = &spec.axes else {
            for key in ["gains", "poles", "limits", "g", "state_max"] {
                let Some(node) = self.keys.get(key).copied() else { continue };
                let number = self.each(key).len();
                // A number of axes that could not be read is a mistake already.
                if number > 0 && !self.keys.contains_key("axes") && !self.has_coupled() {
                    let message = format!("`{key}` of each axis, and `axes` is not given");
                    let one = if key == "limits" { "u_max and u_min" } else { "one value" };
                    let help = format!("give axes = {number}, or {one} for one chain");
                    self.wrong(key, Some(node.place), message, help);
                }
            }
            return;
        };
        let moves = |g: &Expression| g.any(&|e| matches!(e.node(), expression::Node::Variable(_)));
        let curved = spec.input_gain.iter().chain(&axes.input_gains).any(moves);
        let late = spec.promises.delay.as_ref().is_some_and(|delay| delay.samples() > 0.0);
        let observes = self
            .keys
            .get("disturbance")
            .is_some_and(|node| !matches!(&node.value, Value::Word(word) if word == "none"));
        let alone = "make a controller for each axis, armed at the same t0 with the same tau";
        let beside = [
            (
                "delay",
                samples && late,
                "axes in samples keep no inputs under way",
                "leave `delay` out, or make a controller for each axis and call all with the same k",
            ),
            (
                "disturbance",
                samples && observes,
                "axes in samples have no observers",
                "leave `disturbance` out, or make a controller for each axis and call all with the same k",
            ),
            (
                "A",
                samples,
                "the axes are chains, and A is of one plant",
                "leave A, B and C out, or make a controller for each axis and call all with the same k",
            ),
            (
                "what",
                spec.what != What::Controller,
                "axes are of a controller",
                "leave `axes` out: the infinite-time system is that of one axis",
            ),
            (
                "dynamics",
                spec.model.is_some(),
                "the axes are chains, and a model is one plant",
                alone,
            ),
            (
                "f",
                spec.drift.is_some(),
                "f depends on the state of one axis",
                "cancel f outside, or make a controller for each axis",
            ),
            (
                "pi0",
                matches!(spec.feedback, Feedback::Expression(_)),
                "axes need a linear law, or one that is extern",
                "give gains or poles, `pi0` = extern, make a controller for each axis, or write the chains as one plant with `inputs` and `outputs`, whose laws may be expressions",
            ),
            (
                "after",
                spec.after != After::Hold,
                "axes hold their gains after the deadline",
                "leave `after` out, and set u = 0 outside",
            ),
            (
                "reference",
                !samples && matches!(spec.reference, Some(Reference::Known(_))),
                "each axis has a reference of its own",
                OF_AXES,
            ),
            (
                "g",
                curved,
                "g of the axes depends on the state or time",
                "leave g out, and divide the u of each axis by its g(x, t) outside: u_max then bounds g u",
            ),
            (
                "u_max",
                !axes.limits.is_empty(),
                "`u_max` beside `limits`",
                "give `limits` for each axis, or `u_max` for all",
            ),
            (
                "u_min",
                !axes.limits.is_empty(),
                "`u_min` beside `limits`",
                "give pairs, limits = [[lower, upper], ...], or `u_min` and `u_max` for all",
            ),
        ];
        self.against(&beside);
        for key in BOUNDS {
            let Some(node) = self.keys.get(key).copied() else { continue };
            if items(node).iter().any(|item| matches!(item.value, Value::List(_))) {
                let message = format!("`{key}` differs between the axes");
                let help = format!(
                    "axes share their units and {key}: bring them to one unit, or take the greatest; {alone}"
                );
                self.wrong(key, Some(node.place), message, help);
            }
        }
    }
}
