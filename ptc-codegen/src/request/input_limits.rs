//! The limits of the inputs.

use super::{After, Spec};
use crate::algebra::BigRational;
use crate::parameter::{Fixed, Parameter};

/// Value of `u_min` that leaves it to run time.
pub(crate) const RUNTIME: &str = "runtime";

/// The limits of one input as they are fixed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits<'a> {
    /// Upper limit.
    pub most: &'a Fixed,
    /// Lower limit; `None` for the opposite of the upper one.
    pub least: Option<&'a Fixed>,
}

impl Spec {
    /// The limits of one of several inputs, from 0, where it has its own; else `u_max` and `u_min` are those of all.
    pub fn own_limits(&self, index: usize) -> Option<Limits<'_>> {
        let axes = self.axes.as_ref()?;
        Some(Limits { most: axes.limits.get(index)?, least: axes.lower.get(index) })
    }

    /// Returns true if these limits of u, which may be parameters at run time, are legal; 0 has to be within them where
    /// the controller returns it after the deadline.
    pub fn admits_limits(&self, least: f64, most: f64) -> bool {
        let rests = self.after != After::Zero || (least <= 0.0 && 0.0 <= most);
        !self.u_min || (least < most && rests)
    }

    /// Returns true if u is not clipped, whatever the run-time parameters are.
    pub fn is_unlimited(&self) -> bool {
        let fixed = |parameter| self.fixed.get(&parameter);
        let below = !self.u_min || fixed(Parameter::UMin) == Some(&Fixed::MinusInfinite);
        below && fixed(Parameter::UMax) == Some(&Fixed::Infinite)
    }

    /// Returns true if a limit of u is left to run time.
    pub fn has_open_limit(&self) -> bool {
        let open = |parameter| !self.fixed.contains_key(&parameter);
        open(Parameter::UMax) || (self.u_min && open(Parameter::UMin))
    }

    /// Largest b such that |u| <= b keeps an input, from 0, within its fixed limits: not positive where u = 0 is
    /// outside; `None` without fixed limits.
    pub fn radius(&self, index: usize) -> Option<BigRational> {
        let [least, most] = self.limits(index);
        most.into_iter().chain(least.map(|least| -least)).min()
    }

    /// The fixed limits of an input, from 0, the lower one first; `None` where u has none, or it is left to run time.
    pub fn limits(&self, index: usize) -> [Option<BigRational>; 2] {
        let (most, least) = match self.own_limits(index) {
            Some(own) => (Some(own.most), own.least),
            None => {
                let least = self.fixed.get(&Parameter::UMin).filter(|_| self.u_min);
                (self.fixed.get(&Parameter::UMax), least)
            }
        };
        let has_own = least.is_some() || (self.u_min && self.axes.is_none());
        let most = most.and_then(Fixed::number).cloned();
        let least = match has_own {
            true => least.and_then(Fixed::number).cloned(),
            false => most.as_ref().map(|most| -most),
        };
        [least, most]
    }

    /// Makes the limits of u that are open infinite.
    pub fn close_limits(&mut self) {
        self.fixed.entry(Parameter::UMax).or_insert(Fixed::Infinite);
        if self.u_min {
            self.fixed.entry(Parameter::UMin).or_insert(Fixed::MinusInfinite);
        }
    }

    /// Removes the limits of u.
    pub fn remove_limits(&mut self) {
        self.fixed.insert(Parameter::UMax, Fixed::Infinite);
        self.fixed.remove(&Parameter::UMin);
        self.u_min = false;
        if let Some(axes) = &mut self.axes {
            axes.limits.clear();
            axes.lower.clear();
        }
    }
}
