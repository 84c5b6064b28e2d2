//! Errors of the chains in loops that reach given sizes.

use super::super::super::relative::upper;
use super::super::cell::{OnCells, size};
use super::maps::{both, summed};
use super::{Errors, Exactly, Lacking, Sizes, doubles, fractions};
use crate::algebra::BigRational;
use crate::expression::enclosure::Range;
use crate::linear::Moving;
use crate::program::Value;

impl Exactly<'_> {
    /// The errors in loops that reach so much.
    pub(super) fn needed(
        &self,
        chains: Vec<BigRational>,
        wanted: Vec<BigRational>,
    ) -> Result<(Errors, Sizes), Lacking> {
        let maps = &self.maps;
        let states = summed(&maps.states, &chains);
        let [of_chains, of_inputs] = self.rounded(&states, &wanted)?;
        let seen = summed(&maps.of_measured, &self.noise);
        let ideal = both(summed(&maps.inverse, &wanted), &summed(&maps.of_chains, &chains));
        let u = both(both(ideal, &seen), &of_inputs);
        let one = BigRational::from_integer(1.into());
        let acting: Vec<_> = u.iter().map(|u| (&one + &self.gain) * (u + &self.step)).collect();
        let off = u.iter().zip(&of_inputs);
        let off: Vec<_> =
            off.map(|(u, own)| own + &self.step + &self.gain * (u + &self.step)).collect();
        let beside = both(off.clone(), &seen);
        let moving = Moving { states: &states, wanted: &wanted, errors: &beside, inputs: &acting };
        let (apart, forces) = self.left.bounds(&moving);
        let forces = both(forces, &summed(&maps.gain, &off));
        let forces = both(forces, &summed(&maps.drift, &self.noise));
        let sensors = both(summed(&maps.coordinates, &self.noise), &of_chains);
        let sensors = both(sensors, &apart);
        let errors =
            Errors { forces: doubles(&forces), sensors: doubles(&sensors), apart: doubles(&apart) };
        Ok((errors, Sizes { chains, wanted, u, acting, errors: beside }))
    }

    /// Bounds the rounding error of each xi, and of each input.
    fn rounded(
        &self,
        states: &[BigRational],
        wanted: &[BigRational],
    ) -> Result<[Vec<BigRational>; 2], Lacking> {
        let around = |bounds: &[BigRational]| -> Vec<_> {
            bounds.iter().map(|bound| Range::from(upper(bound)).both_signs()).collect()
        };
        let (cell, held) = (around(states), around(wanted));
        let noise = doubles(&self.noise);
        let errors = |values: &[Value], held: &[Range]| {
            let on = OnCells::new(self.spec, &self.emitted, values, &noise);
            let found = on.map_err(Lacking::Proof)?.at(&cell, held);
            let errors = found.iter().map(|value| size(value, |value| value.error));
            fractions(&errors.collect::<Vec<_>>())
        };
        Ok([errors(&self.emitted.watched, &[])?, errors(&self.emitted.controls(), &held)?])
    }
}
