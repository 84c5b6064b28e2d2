//! Chosen values, as a design file spells them.

use std::collections::BTreeMap;
use std::fmt;

use crate::diagnostic::Place;
use crate::request::Entry;
use crate::syntax::parse;

/// A key that may be chosen, in the order in which choices are printed and written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Key {
    /// The clock, where it is not that of time.
    Clock,
    /// The mapping with its rate.
    Mu,
    /// The poles, or the name of some.
    Poles,
    /// The poles of the law that takes over towards the end.
    PolesEnd,
    /// The samples to go from which on it is the law.
    EndSamples,
    /// The law of a loop with a delay.
    DelayLaw,
    /// The time-to-go at which the gains are held.
    Eps,
    /// The kind of the observer.
    Observer,
    /// The drift of the disturbance that a stationary observer assumes.
    DisturbanceWalk,
    /// The poles of the observer.
    ObserverPoles,
    /// The samples after which its estimates are exact.
    ObserverSamples,
    /// The time-to-go at which its gains are held.
    ObserverEps,
    /// Its gains behind the round.
    AfterObserver,
}

impl Key {
    /// Its name in a design file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Clock => "clock",
            Self::Mu => "mu",
            Self::Poles => "poles",
            Self::PolesEnd => "poles_end",
            Self::EndSamples => "end_samples",
            Self::DelayLaw => "delay_law",
            Self::Eps => "eps",
            Self::Observer => "observer",
            Self::DisturbanceWalk => "disturbance_walk",
            Self::ObserverPoles => "observer_poles",
            Self::ObserverSamples => "observer_samples",
            Self::ObserverEps => "observer_eps",
            Self::AfterObserver => "after_observer",
        }
    }
}

/// A chosen value.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Value {
    /// A word or a call, which a design file quotes.
    Word(String),
    /// A number.
    Number(String),
    /// Poles: one list, or one for each output of a plant whose outputs differ in order.
    Poles(Vec<Vec<String>>),
}

impl Value {
    /// The value as on the command line: a list without its outer brackets.
    fn text(&self) -> String {
        match self {
            Self::Word(text) | Self::Number(text) => text.clone(),
            Self::Poles(each) => {
                let each: Vec<_> = each.iter().map(|own| own.join(", ")).collect();
                match each.as_slice() {
                    [one] => one.clone(),
                    several => format!("[{}]", several.join("], [")),
                }
            }
        }
    }
}

/// As a design file has it.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(text) => write!(f, "\"{text}\""),
            Self::Number(text) => f.write_str(text),
            Self::Poles(_) => write!(f, "[{}]", self.text()),
        }
    }
}

/// Chosen values, without those given in the file.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Choice(BTreeMap<Key, Value>);

/// The place of an entry that no file holds.
pub(super) const NOWHERE: Place = Place(usize::MAX);

impl Choice {
    /// Returns the value of a key.
    pub fn get(&self, key: Key) -> Option<&Value> {
        self.0.get(&key)
    }

    /// The keys with their values, in order.
    pub fn values(&self) -> impl Iterator<Item = (Key, &Value)> {
        self.0.iter().map(|(key, value)| (*key, value))
    }

    /// The same with a value.
    #[must_use]
    pub(super) fn with(mut self, key: Key, value: Value) -> Self {
        self.0.insert(key, value);
        self
    }

    /// The same with a word.
    #[must_use]
    pub(super) fn word(self, key: Key, word: impl Into<String>) -> Self {
        self.with(key, Value::Word(word.into()))
    }

    /// The same without some keys.
    #[must_use]
    pub(super) fn without(mut self, keys: &[Key]) -> Self {
        self.0.retain(|key, _| !keys.contains(key));
        self
    }

    /// The same with the values of another one, which take precedence.
    #[must_use]
    pub(super) fn and(mut self, other: Self) -> Self {
        self.0.extend(other.0);
        self
    }

    /// The entries that give it.
    pub(super) fn entries(&self) -> Vec<Entry> {
        let entry = |(key, value): (&Key, &Value)| {
            let key = key.name();
            let value = parse(key, &value.text(), &mut |_| NOWHERE).ok()?;
            Some(Entry { key: key.to_owned(), place: NOWHERE, value })
        };
        self.0.iter().filter_map(entry).collect()
    }
}

impl fmt::Display for Choice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all: Vec<_> =
            self.0.iter().map(|(key, value)| format!("{} = {value}", key.name())).collect();
        f.write_str(&if all.is_empty() { "nothing".to_owned() } else { all.join(", ") })
    }
}
