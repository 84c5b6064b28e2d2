//! The emitted program over the envelope of a proof: whether it stays in range there, and how far its
//! u may be from that of the law.
//!
//! Over each cell of T/tau and tau, x is within what encloses the exact loop. The program is run on
//! these intervals: a value that may leave the range of its precision is one at which `step` may
//! return PTC_E_RANGE. What its rounding makes of x in turn, and sampling, are no part of this.

use num_traits::ToPrimitive;

use super::rounding::error;
use super::{Box, Campaign, Prover, halved, middle_of};
use crate::algebra::{BigRational, integer};
use crate::check::envelope::bounds::Bounds;
use crate::check::envelope::{Computed, outward};
use crate::diagnostic::{digits, digits_up};
use crate::expression::enclosure::{Calls, Interval, Range};
use crate::law::Law;
use crate::lower::lower;
use crate::parameter::{Fixed, Parameter};
use crate::program::{Input, Program, number, passes};
use crate::request::{Spec, What};

/// Cells at which the program may be looked at.
const MOST: u32 = 20_000;

/// A cell is not halved where T/tau and tau change by less than one part of as many in it.
const NARROW: i64 = 256;

/// Accepted ratio of the bound of an error over a cell to the one in its middle.
const CLOSE: f64 = 4.0;

/// Cells after which twice as much may be, again and again: a close bound is of less use than one.
const PATIENCE: f64 = 400.0;

/// Accepted ratio of such a bound to the greatest one in the middle of a cell, whatever the ratio in its own cell.
const SMALL: f64 = 1.0 / 1024.0;

/// The emitted program over the envelope.
pub(super) struct Emitted {
    /// Name of its precision.
    precision: &'static str,
    /// T/tau of the cells, rounded outwards, and how far u may be from that of the law in each; none
    /// where that is not bounded.
    errors: Vec<([f64; 2], Option<f64>)>,
}

impl Emitted {
    /// The program of a campaign over the envelope of its exact loop, or why it may leave its range.
    pub(super) fn of(campaign: &Campaign, prover: &mut Prover) -> Result<Self, String> {
        let spec = Spec { what: What::Controller, ..campaign.spec.clone() };
        let program = passes::optimise(lower(&spec, &Law::of(&spec)), &mut |_, _| {});
        let precision = program.precision;
        let mut left: Vec<Box> = prover.run();
        let (mut errors, mut greatest) = (Vec::new(), 0.0_f64);
        let mut calls = Calls::new().ok_or("memory for constants is lacking")?;
        for looked_at in 0_u32..MOST {
            let close = CLOSE * (f64::from(looked_at) / PATIENCE).exp2();
            let Some((share, tau)) = left.pop() else {
                return Ok(Self { precision: precision.name(), errors });
            };
            let wide = |[low, high]: &[BigRational; 2]| (high - low) / low;
            let (of_share, of_tau) = (wide(&share), wide(&tau));
            let least = BigRational::new(1.into(), NARROW.into());
            let narrow = of_share <= least && of_tau <= least;
            let what = match prover.states(&share, &tau) {
                None if prover.closed.pieces == 0 => break,
                None => Some("x, which is not bounded,".to_owned()),
                Some([states, middle]) => {
                    match over(&program, &spec, (&share, &tau), &states, &mut calls) {
                        Ok(error) => {
                            let is_small = error.is_some_and(|error| error <= SMALL * greatest);
                            let is_close = narrow || is_small || {
                                let [share, tau] = [&share, &tau].map(middle_of);
                                let here =
                                    over(&program, &spec, (&share, &tau), &middle, &mut calls);
                                let here = here.ok().flatten();
                                greatest =
                                    error.and(here).map_or(greatest, |here| greatest.max(here));
                                is_near(error, here, close)
                            };
                            if is_close {
                                errors.push((outwards(&share), error));
                                continue;
                            }
                            None
                        }
                        Err(what) => Some(what),
                    }
                }
            };
            if let (true, Some(what)) = (narrow, what) {
                let name = precision.name();
                let at = |value: &BigRational| digits(value.to_f64().unwrap_or(f64::NAN));
                return Err(format!(
                    "in the emitted program {what} may leave the range of {name} at T/tau = {}, tau = {}",
                    at(&share[1]),
                    at(&tau[0])
                ));
            }
            // Where x is not enclosed closely at one tau, T/tau is what has to be halved.
            let at_one = prover.states(&share, &middle_of(&tau));
            let is_loose = at_one.is_none_or(|[states, middle]| {
                states.iter().zip(&middle).any(|(x, about)| size(x) > 2.0 * size(about))
            });
            let is_share = if of_tau <= least || of_share <= least {
                of_share >= of_tau
            } else {
                is_loose || tau[0] == tau[1]
            };
            if is_share {
                left.extend(halved(&share).map(|share| (share, tau.clone())));
            } else {
                left.extend(halved(&tau).map(|tau| (share.clone(), tau)));
            }
        }
        Err("the cells at which the emitted program may be looked at are used up".to_owned())
    }

    /// Bounds the error of u relative to the law over a cell; `None` where it is not bounded.
    pub(super) fn error(&self, share: &[BigRational; 2]) -> Option<f64> {
        let [low, high] = outwards(share);
        let met = self.errors.iter().filter(|([from, to], _)| *from <= high && low <= *to);
        met.map(|(_, error)| *error).try_fold(0.0, |most: f64, error| Some(most.max(error?)))
    }

    /// Describes the part of the program that a proof includes.
    pub(super) fn scope(&self) -> String {
        let name = self.precision;
        let of_u = match self.error(&[integer(0), integer(1)]) {
            Some(error) => format!("within {} of u there", digits_up(error)),
            None => "the rounding of its iteration is not included".to_owned(),
        };
        format!(
            "for the law in exact arithmetic at every instant; the emitted {name} program stays in range there, \
             {of_u}; sampling, and what rounding makes of x, are not included"
        )
    }
}

/// Returns true if the bound of an error over a cell is at most `close` times the one in its middle, or neither has a
/// bound.
fn is_near(error: Option<f64>, here: Option<f64>, close: f64) -> bool {
    match (error, here) {
        (None, here) => here.is_none(),
        (Some(_), None) => false,
        (Some(error), Some(here)) => error <= close * here,
    }
}

fn size([low, high]: &[f64; 2]) -> f64 {
    low.abs().max(high.abs())
}

/// Doubles that hold an interval; long fractions take long to compare.
fn outwards([low, high]: &[BigRational; 2]) -> [f64; 2] {
    Range::from(&Interval::between(low, Some(high))).ends()
}

/// The error of u over a cell, if it is bounded, or the first value that may leave the range.
fn over(
    program: &Program,
    spec: &Spec,
    (share, tau): (&[BigRational; 2], &[BigRational; 2]),
    states: &[[f64; 2]],
    calls: &mut Calls,
) -> Result<Option<f64>, String> {
    let precision = program.precision;
    let within = |low: &BigRational, high: &BigRational| {
        let [low, high] = outwards(&[low.clone(), high.clone()]);
        outward(low, high, precision)
    };
    let of_tau = match tau[0] == tau[1] {
        true => Computed::point(number::round(&tau[0], precision)),
        false => within(&tau[0], &tau[1]),
    };
    let input = |input: Input| match input {
        Input::Parameter(Parameter::Tau) => of_tau,
        Input::State(j) => {
            states.get(j - 1).map_or(Computed::ANY, |[low, high]| outward(*low, *high, precision))
        }
        Input::Parameter(p) => fixed(spec, p),
        Input::StartTime => fixed(spec, Parameter::StartTime),
        _ => Computed::ANY,
    };
    // Time-to-go has a rounding or two.
    let slack = integer(1) / integer(1 << 20);
    let low = &share[0] * &tau[0] * (integer(1) - &slack);
    let high = &share[1] * &tau[1] * (integer(1) + &slack);
    let stretch = within(&low, &high);
    let early = Bounds::new(program, &input);
    let [low, high] = stretch.range.ends();
    let mut bounds = early.at(low, high);
    if let Some(value) = bounds.first_excess(&[program.step]) {
        return Err(crate::check::envelope::describe(program, value));
    }
    let found = error(program, &bounds, bounds.held(), high, program.step, calls);
    let handed: Vec<_> = program.handed_over().copied().collect();
    let gains = bounds.first_excess(&handed);
    bounds.hand_over_gains();
    if let Some(value) = gains.or_else(|| bounds.first_excess(program.axis.as_slice())) {
        return Err(crate::check::envelope::describe(program, value));
    }
    Ok(found)
}

/// A parameter that is fixed; what is not, as eps may be, is not needed for u before the gains are held.
fn fixed(spec: &Spec, parameter: Parameter) -> Computed {
    let value = spec.fixed.get(&parameter).and_then(Fixed::number);
    Computed::point(value.map_or(0.0, |value| number::round(value, spec.precision)))
}
