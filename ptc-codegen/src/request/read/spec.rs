//! All parts of a spec, read one after the other and put together.

use std::collections::BTreeMap;

use super::super::{After, Clock, Feedback, Guard, MAX_ORDER, Spec, What};
use super::model::Read;
use super::{Reader, parameters};
use crate::algebra::BigRational;
use crate::expression::Expression;
use crate::family::Family;
use crate::linear::Delay;
use crate::mapping::TimeMapping;
use crate::model::Coupled;
use crate::parameter::{Fixed, Parameter, Precision};

impl<'a> Reader<'a> {
    pub(super) fn spec(&mut self) -> Option<Spec> {
        let samples = self.counts_samples();
        let model = self.model();
        let coupled = self.coupled();
        let orders = coupled.as_ref().map(Coupled::orders);
        let first = orders.as_ref().and_then(|orders| orders.first().copied());
        let whole = samples && model.as_ref().is_some_and(|read| self.is_linear(&read.model));
        let degree = model.as_ref().map(|Read { model, .. }| match whole {
            true => model.states.len(),
            false => model.coordinates.len(),
        });
        let n = self.order(degree.or(first), whole);
        // With the order unknown, all else is still read, so that all mistakes are reported at once.
        let order = n.unwrap_or(MAX_ORDER);
        let highest = orders.as_ref().and_then(|orders| orders.iter().copied().max());
        let axes = self.axes().map(|number| vec![n; number]);
        let axes = axes.or(orders.map(|orders| orders.into_iter().map(Some).collect()));
        let mapping = self.time_mapping(highest.unwrap_or(order));
        self.mapping_is_read = mapping.is_some();
        self.rate = mapping.as_ref().and_then(|(mapping, fixed)| rate_of_exp(mapping, fixed));
        let own = mapping.as_ref().map(|(mapping, _)| mapping.parameters()).unwrap_or_default();
        let known = parameters::known(own);
        let name = self.name();
        let units = self.units();
        let what = self.choice("what", &What::NAMES);
        let precision =
            self.choice("precision", &[("f64", Precision::F64), ("f32", Precision::F32)]);
        let [fma, latency] =
            ["fma", "latency"].map(|key| self.choice(key, &[("true", true), ("false", false)]));
        let guard = self.choice(
            "guard",
            &[("full", Guard::Full), ("result", Guard::Result), ("none", Guard::None)],
        );
        let after = self.choice(
            "after",
            &[("hold", After::Hold), ("zero", After::Zero), ("extern", After::Extern)],
        );
        let precision = precision.unwrap_or(Precision::F64);
        let states = match (&model, &coupled) {
            (Some(read), _) => Some(read.model.states.len()),
            (None, Some(coupled)) => Some(coupled.states.len()),
            (None, None) if self.has_model() => None,
            (None, None) => n,
        };
        let outputs = coupled.as_ref().filter(|_| samples).map(Coupled::orders);
        let promises = self.promises(n, states, outputs.as_deref());
        // A sample of delay is a state more of a chain, or of a plant that is linear.
        let one = !self.has_model() && !self.keys.contains_key("axes");
        let keeps = samples && (whole || one);
        let delay_law = self.delay_law(n);
        let late = promises.delay.as_ref().filter(|_| keeps).map_or(0, Delay::inputs);
        let late = delay_law.states(late);
        let orders = (n.map(|n| n + late), order + late);
        let of_model = model.as_ref().map(|read| &read.model);
        let law = self.law(orders, late, &known, (of_model, coupled.as_ref()));
        let (drift, input_gain) = match &model {
            Some(read) => {
                let unless =
                    |e: &Expression, value| (*e != Expression::integer(value)).then(|| e.clone());
                (unless(&read.drift, 0), unless(&read.gain, 1))
            }
            None => (self.drift(order, &known), self.input_gain(order, &known)),
        };
        let (reference, references) = match (&axes, &coupled) {
            (Some(orders), Some(_)) => self.references(("output", orders), &known),
            // What it is of has not been read.
            _ if self.has_coupled() => (None, Vec::new()),
            (Some(orders), None) if samples => self.references(("axis", orders), &known),
            _ => (self.reference(n, &known), Vec::new()),
        };
        let mut spec = Spec {
            n: order,
            time_mapping: mapping.as_ref().map_or(UNREAD, |(mapping, _)| mapping.clone()),
            name,
            units,
            what: what.unwrap_or(What::Controller),
            clock: Clock::Time,
            precision,
            fma: fma.unwrap_or(false),
            latency: latency.unwrap_or(false),
            guard: guard.unwrap_or(Guard::Full),
            feedback: law.feedback,
            drift,
            input_gain,
            reference,
            axes: None,
            model: model.map(|read| Box::new(read.model)),
            coupled: coupled.map(Box::new),
            larger: None,
            after: after.unwrap_or(After::Hold),
            fixed: law.gains,
            bounds: BTreeMap::new(),
            in_flight: false,
            u_min: false,
            poles: law.poles,
            written: self.written(),
            promises,
            engine: None,
        };
        if spec.what == What::Associated {
            self.associated(&mut spec);
        }
        if let Some(orders) = axes {
            self.own_values(&mut spec, &orders, (law.laws, law.own_gains));
        }
        if let Some(axes) = &mut spec.axes {
            axes.references = references;
        }
        self.fits_axes(&spec, samples);
        self.fits_model(&spec, samples);
        self.fits_coupled(&spec, samples);
        self.fits_reference(&spec, samples);
        self.fits_units(&spec);
        self.fits_r(&spec);
        // A law of the user's program knows all of them.
        if let (Feedback::Extern, Some(chains)) = (&spec.feedback, spec.chains()) {
            spec.coupled = Some(Box::new(chains));
        }
        let complete = self.found.is_empty();
        spec.fixed.extend(mapping.iter().flat_map(|(_, fixed)| fixed.iter().cloned()));
        self.parameters(&mut spec, complete);
        self.reference_exists(&spec, samples);
        match samples {
            true if whole => {}
            true => self.sampled(&mut spec, delay_law),
            false => {
                self.not_sampled(&spec);
                self.duration(&mut spec);
            }
        }
        if spec.what != What::Filter {
            self.refuse_bounds();
        }
        // A plant that is refused leaves a spec with another clock than requested.
        if samples == spec.sampled().is_some() {
            self.representable(&spec);
        }
        (n.is_some() && mapping.is_some()).then_some(spec)
    }

    /// The infinite-time system needs mu, and checks every input. Its states are those of the chain alone, in which a
    /// model is not written.
    fn associated(&mut self, spec: &mut Spec) {
        spec.guard = Guard::Full;
        // `fits_coupled` refuses one with several inputs.
        if spec.has_model() && spec.coupled.is_none() {
            let place = self.keys.get("what").map(|node| node.place);
            let message = "the infinite-time system of a model is not made".to_owned();
            let help = "its state is that of the chain of the output, not that of the model: give the chain with n, f and g, or leave `what` out";
            self.wrong("what", place, message, help.to_owned());
        }
        if spec.time_mapping.complement().is_none() {
            let place = self.keys.get("what").map(|node| node.place);
            let message = "no closed form of mu is found from this kappa".to_owned();
            let help = "the infinite-time system holds mu'(t): give the mapping as mu";
            self.wrong("what", place, message, help.to_owned());
        }
    }
}

/// The rate a of the mapping `exp`, where it has a number.
fn rate_of_exp(mapping: &TimeMapping, fixed: &[(Parameter, Fixed)]) -> Option<BigRational> {
    let is_exp = matches!(mapping, TimeMapping::Family { family: Family::Exp, .. });
    let rate = fixed.iter().find(|(parameter, _)| is_exp && *parameter == Parameter::A);
    rate.and_then(|(_, value)| value.number().cloned())
}

/// Stands in for a mapping that could not be read while the rest of the spec is.
const UNREAD: TimeMapping = TimeMapping::Family { family: Family::Exp, rates: 0 };
