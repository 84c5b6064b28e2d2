//! Events of a run at times after t0, from the tables `[[event]]` of a design.
//!
//! ```toml
//! [[event]]
//! at = 0.4             # s after t0, from the next sample on
//! move = [-0.1, 0.1]   # the target moves; a campaign draws by how much
//! tau = 0.6            # and the deadline is 0.6 s later
//! ```

mod read;

pub use read::{read, read_numbers};

/// Event of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Time after t0 in s; it happens at the next sample.
    pub at: f64,
    /// Its action.
    pub change: Change,
}

/// A change in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The controller is armed again.
    Arm,
    /// The deadline is so many samples later.
    Deadline(u32),
    /// The deadline is so much later, in s, with a clock in time.
    Duration(f64),
    /// The target of a chain moves.
    Target {
        /// The state that counts from it, from 0.
        state: usize,
        /// By how much.
        by: f64,
    },
    /// A force is added to u for so long, in s.
    Force {
        /// The input, from 0; `None` for every one.
        input: Option<usize>,
        /// The force, in units of u.
        size: f64,
        /// The time for which it acts.
        length: f64,
    },
}

impl Change {
    /// Returns true if the controller is given a deadline.
    pub fn arms(self) -> bool {
        matches!(self, Self::Arm | Self::Deadline(_) | Self::Duration(_))
    }
}

/// The events of a design. Each number is known, or an interval of which a run takes one value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events(Vec<Planned>);

/// One table `[[event]]`.
#[derive(Clone, Debug, PartialEq)]
struct Planned {
    at: Quantity,
    actions: Vec<Action>,
}

/// Number of an event: an interval, whose ends are equal if it is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Its name, such as `event1_move`.
    pub name: String,
    /// The least value.
    pub low: f64,
    /// The greatest value.
    pub high: f64,
}

/// Action of a table.
#[derive(Clone, Debug, PartialEq)]
enum Action {
    Arm,
    /// A new deadline after a time in s, counted in samples of a period with a clock in samples.
    Deadline(Quantity, Option<f64>),
    /// By how much the target of a state moves.
    Target(usize, Quantity),
    Force {
        input: Option<usize>,
        size: Quantity,
        length: Quantity,
    },
}

impl Events {
    /// Returns true if nothing happens.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns each number that is not known.
    pub fn uncertain(&self) -> impl Iterator<Item = &Quantity> {
        self.0.iter().flat_map(Planned::quantities).filter(|own| own.is_open())
    }

    /// Returns the events of a run that takes these values of what is uncertain, in their order.
    pub fn with(&self, drawn: &[f64]) -> Vec<Event> {
        let mut drawn = drawn.iter();
        let mut value = |own: &Quantity| match own.is_open() {
            true => drawn.next().copied().unwrap_or(f64::NAN),
            false => own.low,
        };
        let mut events = Vec::new();
        for table in &self.0 {
            let at = value(&table.at);
            let changes = table.actions.iter().map(|action| action.change(&mut value));
            events.extend(changes.map(|change| Event { at, change }));
        }
        events
    }

    /// Returns the events of a run in which every number is the largest that it may be.
    pub fn latest(&self) -> Vec<Event> {
        let high: Vec<_> = self.uncertain().map(|own| own.high).collect();
        self.with(&high)
    }

    /// Returns true if the controller is given a deadline in a run.
    pub fn arms(&self) -> bool {
        let arms = |action: &Action| matches!(action, Action::Arm | Action::Deadline(..));
        self.0.iter().flat_map(|table| &table.actions).any(arms)
    }
}

impl Planned {
    fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        std::iter::once(&self.at).chain(self.actions.iter().flat_map(Action::quantities))
    }
}

impl Quantity {
    fn is_open(&self) -> bool {
        self.low < self.high
    }
}

impl Action {
    fn quantities(&self) -> Vec<&Quantity> {
        match self {
            Self::Arm => Vec::new(),
            Self::Deadline(own, _) | Self::Target(_, own) => vec![own],
            Self::Force { size, length, .. } => vec![size, length],
        }
    }

    fn change(&self, value: &mut dyn FnMut(&Quantity) -> f64) -> Change {
        match self {
            Self::Arm => Change::Arm,
            Self::Deadline(tau, Some(period)) => Change::Deadline(samples(value(tau), *period)),
            Self::Deadline(tau, None) => Change::Duration(value(tau)),
            Self::Target(state, by) => Change::Target { state: *state, by: value(by) },
            Self::Force { input, size, length } => {
                let size = value(size);
                Change::Force { input: *input, size, length: value(length) }
            }
        }
    }
}

/// The whole number of sample periods that is nearest to a time; more than there may be saturate.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn samples(tau: f64, period: f64) -> u32 {
    (tau / period).round() as u32
}
