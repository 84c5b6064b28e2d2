//! The controller at one precision, with the mapping at the last times.

use std::collections::VecDeque;
use std::rc::Rc;

use astro_float_num::BigFloat;

use super::Call;
use super::law::Term;
use super::long::Arithmetic;
use super::mapping::{Mapping, Point};
use super::work::Work;
use crate::parameter::Parameter;
use crate::request::Spec;

/// Times at which the mapping is kept: those of a call and of the start, and the calls before.
pub(super) const POINTS: usize = 4;

/// One precision, with the mapping at the last times.
pub(super) struct Kept {
    pub(super) arithmetic: Arithmetic,
    pub(super) points: VecDeque<(At, Option<Rc<Point>>)>,
}

/// Arguments of the mapping: time-to-go, and the bits of its parameters.
type At = (BigFloat, Vec<u64>);

impl Kept {
    pub(super) fn new(bits: usize, work: Work) -> Option<Self> {
        Some(Self { arithmetic: Arithmetic::within(bits, work)?, points: VecDeque::new() })
    }

    /// Every u at time-to-go `to_go`.
    pub(super) fn controls(
        &mut self,
        (spec, designs, mapping): (&Spec, &[Spec], &Mapping),
        call: &Call<'_>,
        to_go: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Vec<Term>> {
        let to_go = self.arithmetic.add(to_go, &self.arithmetic.integer(0));
        let point = self.point(mapping, &to_go, parameter)?;
        let at_start = if call.x0.is_empty() {
            point.clone()
        } else {
            let tau = self.arithmetic.double(parameter(Parameter::Tau));
            self.point(mapping, &tau, parameter)?
        };
        let points = [&*point, &*at_start];
        self.arithmetic.controls((spec, designs), (call, &to_go), points)
    }

    /// The mapping at time-to-go `to_go`.
    fn point(
        &mut self,
        mapping: &Mapping,
        to_go: &BigFloat,
        parameter: &dyn Fn(Parameter) -> f64,
    ) -> Option<Rc<Point>> {
        let values = mapping.parameters.iter().map(|p| parameter(*p).to_bits());
        let at = (to_go.clone(), values.collect());
        if let Some((_, point)) = self.points.iter().find(|(other, _)| *other == at) {
            return point.clone();
        }
        let point = self.arithmetic.point(mapping, to_go, parameter).map(Rc::new);
        self.points.truncate(POINTS - 1);
        self.points.push_front((at, point.clone()));
        point
    }
}
