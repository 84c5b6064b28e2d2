//! The values of keys: intervals, whole numbers and numbers.

use num_traits::ToPrimitive;

use super::{Given, Reader};
use crate::diagnostic::Place;
use crate::expression::constant::{interval, real};
use crate::keys::verify::KEYS;
use crate::parameter::Fixed;
use crate::syntax::Node;
use crate::verify::Interval;

impl Reader<'_> {
    /// `[lower, upper]`, or one number for both.
    pub(super) fn interval(
        &mut self,
        table: &str,
        name: &str,
        given: &Given<'_>,
    ) -> Option<Interval> {
        let (_, node) = given.get(name)?;
        match interval(node) {
            Some((low, high)) if low <= high => return Some((low, high)),
            Some((low, high)) => self.wrong(
                &format!("{table}.{name}"),
                Some(node.place),
                format!("the interval of {name} is empty: {low} > {high}"),
                "an interval is [lower, upper]",
            ),
            None => self.wrong(
                &format!("{table}.{name}"),
                Some(node.place),
                format!("{table}.{name} is not an interval"),
                "an interval is [lower, upper] of finite numbers, or one number",
            ),
        }
        None
    }

    pub(super) fn integer(
        &mut self,
        key: &'static str,
        given: &Given<'_>,
        (least, most): (u64, u64),
        otherwise: u64,
    ) -> Option<u64> {
        let Some((_, node)) = given.get(key) else { return Some(otherwise) };
        let value = real(node).and_then(|value| value.number().cloned());
        let whole = value.filter(|value| value.is_integer()).and_then(|value| value.to_u64());
        let legal = whole.filter(|value| (least..=most).contains(value));
        if legal.is_none() {
            self.legal(key, node.place);
        }
        legal
    }

    pub(super) fn number(
        &mut self,
        key: &'static str,
        given: &Given<'_>,
        legal: &dyn Fn(f64) -> bool,
    ) -> Option<f64> {
        let (_, node) = given.get(key)?;
        let value = number(node).filter(|value| legal(*value));
        if value.is_none() {
            self.legal(key, node.place);
        }
        value
    }

    pub(super) fn legal(&mut self, key: &'static str, place: Place) {
        let info = KEYS.iter().find(|info| info.key == key);
        let legal = info.map_or("", |info| info.legal);
        self.wrong(
            &format!("verify.{key}"),
            Some(place),
            format!("verify.{key} is not legal"),
            &format!("{key} is {legal}"),
        );
    }
}

pub(super) fn number(node: &Node) -> Option<f64> {
    real(node).as_ref().and_then(to_f64).filter(|value| value.is_finite())
}

pub(super) fn to_f64(value: &Fixed) -> Option<f64> {
    value.number().and_then(ToPrimitive::to_f64)
}
