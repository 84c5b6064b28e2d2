//! The keys of a loop in samples that are chosen one after the other, with the values that are tried.

use super::choice::{Choice, Key, Value};
use super::numbers::Numbers;
use super::wish::Wish;
use crate::diagnostic::digits;
use crate::request::{DelayLaw, LeastEnergy};

/// Greatest weight of a law of least energy that is tried.
const MOST: u32 = 3;

/// Keys that are chosen together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coordinate {
    /// The weight of the law of least energy.
    Weight,
    /// The law that takes over towards the end.
    End,
    /// The time-to-go at which the gains are held.
    Hold,
    /// The time-to-go at which the gains of the observer are held.
    ObserverHold,
    /// The samples after which the estimates are exact.
    Round,
    /// The gains of the observer behind its round.
    Lasting,
    /// Speed of the observer in its round.
    ObserverSpeed,
    /// A stationary observer in place of one with a round, and its drift.
    Stationary,
    /// The law of a loop with a delay.
    DelayLaw,
}

/// The coordinates in the order in which they are tried: what costs nothing first, and last what changes the loop most.
const ALL: [Coordinate; 9] = [
    Coordinate::Hold,
    Coordinate::Weight,
    Coordinate::End,
    Coordinate::ObserverHold,
    Coordinate::Round,
    Coordinate::Lasting,
    Coordinate::ObserverSpeed,
    Coordinate::Stationary,
    Coordinate::DelayLaw,
];

/// The keys of the round of an observer.
const ROUND: [Key; 4] =
    [Key::ObserverPoles, Key::ObserverSamples, Key::ObserverEps, Key::AfterObserver];

/// Keys of the law of least energy.
pub(super) const LEAST_ENERGY: [Key; 4] =
    [Key::Poles, Key::PolesEnd, Key::EndSamples, Key::DelayLaw];

impl Coordinate {
    /// The coordinates of what a wish leaves open; `named` for those of a law of least energy too.
    pub(super) fn all(wish: &Wish<'_>, numbers: &Numbers, named: bool) -> Vec<Self> {
        let is_open = |coordinate: &Self| {
            let observes = numbers.estimates > 0;
            match coordinate {
                Self::Weight => named,
                Self::End => named && wish.leaves_end(),
                Self::DelayLaw => named && numbers.is_late && wish.leaves(Key::DelayLaw),
                Self::Hold => wish.leaves(Key::Eps),
                Self::ObserverHold => observes && wish.leaves(Key::ObserverEps),
                Self::Round => observes && wish.leaves(Key::ObserverSamples),
                Self::Lasting => observes && wish.leaves(Key::AfterObserver),
                Self::ObserverSpeed => observes && wish.leaves(Key::ObserverPoles),
                Self::Stationary => {
                    let all = ROUND.iter().chain(&[Key::Observer]);
                    let is_open = observes && all.copied().all(|key| wish.leaves(key));
                    wish.lacks(Key::DisturbanceWalk) || numbers.is_disturbed && is_open
                }
            }
        };
        ALL.into_iter().filter(is_open).collect()
    }

    /// The choices along it, from one of them on.
    pub(super) fn values(self, wish: &Wish<'_>, numbers: &Numbers, from: &Choice) -> Vec<Choice> {
        let is_stationary = from.get(Key::Observer).is_some();
        let each = |key: Key, all: Vec<Value>| -> Vec<Choice> {
            let open = from.clone().without(&[key]);
            let with = all.into_iter().map(|value| open.clone().with(key, value));
            [open.clone()].into_iter().chain(with).collect()
        };
        let number = |count: u32| Value::Number(count.to_string());
        match self {
            Self::Weight => {
                (0..=MOST).map(|weight| from.clone().word(Key::Poles, law(weight))).collect()
            }
            Self::End => ends(numbers, from),
            Self::DelayLaw => each(Key::DelayLaw, vec![Value::Word(DelayLaw::EXTEND.to_owned())]),
            Self::Hold if numbers.is_bounded => {
                let with = |value| from.clone().with(Key::Eps, value);
                numbers.holds().into_iter().map(with).collect()
            }
            Self::Hold => each(Key::Eps, numbers.holds()),
            Self::Stationary => stationary(wish, numbers, from),
            _ if is_stationary => Vec::new(),
            Self::ObserverHold => each(Key::ObserverEps, numbers.observer_holds(from)),
            Self::Round => {
                let all = numbers.shares(&[3, 4, 8, 16], numbers.estimates);
                each(Key::ObserverSamples, all.into_iter().map(number).collect())
            }
            Self::Lasting => {
                let mut all = each(Key::AfterObserver, numbers.lasting());
                let held = from.clone().without(&[Key::AfterObserver, Key::DisturbanceWalk]);
                if numbers.is_disturbed {
                    let word = held.word(Key::AfterObserver, "stationary");
                    all.extend(walks(wish, numbers, &word));
                }
                all
            }
            Self::ObserverSpeed => {
                let poles = [1, 0, 2, 4].map(|beyond| observer_poles(wish, numbers, beyond));
                poles.into_iter().map(|own| from.clone().with(Key::ObserverPoles, own)).collect()
            }
        }
    }
}

impl Coordinate {
    /// The choices next to one of them along it, where its key is a number.
    pub(super) fn finer(self, wish: &Wish<'_>, numbers: &Numbers, from: &Choice) -> Vec<Choice> {
        let key = match self {
            Self::Hold => Key::Eps,
            Self::End => Key::EndSamples,
            Self::ObserverHold => Key::ObserverEps,
            Self::Round => Key::ObserverSamples,
            Self::Lasting | Self::Stationary if wish.leaves(Key::DisturbanceWalk) => {
                Key::DisturbanceWalk
            }
            _ => return Vec::new(),
        };
        let Some(value) = from.get(key) else { return Vec::new() };
        let with = |value| from.clone().with(key, value);
        numbers.beside(key, value).into_iter().map(with).collect()
    }
}

/// The law of least energy with a weight, as a design has it.
pub(super) fn law(weight: u32) -> String {
    LeastEnergy { weight }.to_string()
}

/// Poles of an observer, as far left of those of least energy.
pub(super) fn observer_poles(wish: &Wish<'_>, numbers: &Numbers, beyond: usize) -> Value {
    let rate = if wish.leaves_mapping() { 1.0 } else { wish.rate().0 };
    #[allow(clippy::cast_precision_loss)]
    let pole = |i: usize| digits(-rate * (numbers.estimates + beyond + i) as f64);
    Value::Poles(vec![(0..numbers.estimates).map(pole).collect()])
}

/// Without a law that takes over, and with stiffer ones.
fn ends(numbers: &Numbers, from: &Choice) -> Vec<Choice> {
    let open = from.clone().without(&[Key::PolesEnd, Key::EndSamples]);
    let weight = (0..=MOST).find(|weight| from.get(Key::Poles) == Some(&Value::Word(law(*weight))));
    let weight = weight.unwrap_or(0);
    let with = |(beyond, count): (u32, u32)| {
        let count = Value::Number(count.to_string());
        open.clone().word(Key::PolesEnd, law(weight + beyond)).with(Key::EndSamples, count)
    };
    let each = [1, 2]
        .into_iter()
        .flat_map(|beyond| numbers.ends().into_iter().map(move |count| (beyond, count)));
    [open.clone()].into_iter().chain(each.map(with)).collect()
}

/// The observer with a round and stationary ones; of a stationary one that lacks its drift each drift.
fn stationary(wish: &Wish<'_>, numbers: &Numbers, from: &Choice) -> Vec<Choice> {
    if wish.lacks(Key::DisturbanceWalk) {
        return walks(wish, numbers, from);
    }
    let open = from.clone().without(&ROUND).without(&[Key::DisturbanceWalk]);
    let all = walks(wish, numbers, &open.word(Key::Observer, "stationary"));
    [from.clone()].into_iter().chain(all).collect()
}

/// A choice with each drift of the disturbance, where it is open.
fn walks(wish: &Wish<'_>, numbers: &Numbers, choice: &Choice) -> Vec<Choice> {
    if !wish.leaves(Key::DisturbanceWalk) {
        return vec![choice.clone()];
    }
    let with = |walk| choice.clone().with(Key::DisturbanceWalk, walk);
    numbers.walks().into_iter().map(with).collect()
}
