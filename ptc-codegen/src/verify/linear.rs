//! Selection of campaigns whose loop is linear in stretched time, decided on their expressions.

use std::collections::BTreeMap;

use super::{Campaign, Signal};
use crate::algebra::{BigRational, integer};
use crate::expression::normal::normal;
use crate::expression::{Expression, existence};
use crate::parameter::{Fixed, Parameter};
use crate::plant::{Bounded, force};
use crate::request::Feedback;

/// Values of the fixed parameters.
pub(super) type Values = BTreeMap<Parameter, BigRational>;

/// A law of gains, on a chain with the gain that it divides by: with an f of the state and time alone
/// xi' = A xi + mu'^n f, A the companion matrix of the gains.
pub(super) struct LinearLoop {
    /// k_1..k_n.
    pub(super) gains: Vec<BigRational>,
    /// g.
    pub(super) gain: BigRational,
}

impl LinearLoop {
    /// Returns the linear loop of a campaign, or why it has none.
    pub(super) fn of(campaign: &Campaign, values: &Values) -> Result<Self, String> {
        let spec = &campaign.spec;
        let number = |g: &Expression| {
            let known = g.known(&|p| values.get(&p).cloned());
            normal(&known).number().cloned().ok_or(known)
        };
        if spec.feedback != Feedback::Linear {
            return Err("pi0 is not a sum of gains, so that the loop is not linear".to_owned());
        }
        if spec.reference.is_some() {
            return Err("the law follows a reference, and the proof is of one that brings x to 0"
                .to_owned());
        }
        if let Some(f) = &spec.drift {
            return Err(format!("the law cancels f = {f}, which the proof does not know"));
        }
        let gain = spec.input_gain.as_ref().map_or(Ok(integer(1)), number);
        let gain = gain.map_err(|g| format!("g = {g} is not a number"))?;
        if let Some(own) = &campaign.plant.g
            && (number(own).ok() != Some(gain.clone()) || !existence::needs(own).is_empty())
        {
            return Err(format!("the plant's g = {own} is not the number that the law divides by"));
        }
        let gains = (1..=spec.n).map(|i| spec.fixed.get(&Parameter::Gain(i))?.number().cloned());
        let gains = gains.collect::<Option<Vec<_>>>().ok_or("gains are left to run time")?;
        Ok(Self { gains, gain })
    }
}

/// Collects the fixed values of a design.
pub(super) fn values(campaign: &Campaign) -> Values {
    let fixed = campaign.spec.fixed.iter().chain(&campaign.plant.fixed);
    fixed.filter_map(|(name, value)| Some((*name, Fixed::number(value)?.clone()))).collect()
}

/// The middle of f, how far it may be from there for all of a run, and how far from that.
pub(super) fn drift(campaign: &Campaign, values: &Values) -> Result<[BigRational; 3], String> {
    let of_constants =
        campaign.intervals.iter().map(|(symbol, interval)| (*symbol, *interval, true));
    let of_signals = campaign.disturbances.iter().map(|(symbol, interval, signals)| {
        (*symbol, *interval, signals.iter().all(|signal| *signal == Signal::Constant))
    });
    let exact = |value: f64| BigRational::from_float(value).ok_or("a bound of f is not a number");
    let one = |(symbol, (low, high), is_constant): (Parameter, (f64, f64), bool)| {
        Ok::<Bounded, &str>((symbol, [exact(low)?, exact(high)?], is_constant))
    };
    let bounded = of_constants.chain(of_signals).map(one).collect::<Result<Vec<_>, _>>()?;
    force(&campaign.plant.f, values, &bounded)
}
