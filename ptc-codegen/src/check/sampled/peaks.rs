//! u from a unit of each state: its peak, for a design that does not say where it starts.

use num_traits::One;

use super::judge::Loop;
use super::outcome::limit_of_u;
use crate::algebra::BigRational;
use crate::diagnostic::{digits, digits_down};
use crate::expansion::Expanded;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Clock, Spec};

/// Most samples of a run.
const SAMPLES: usize = 20_000;

/// Bound of what doubles lose of a run.
const ROUNDED: f64 = 1.0 + 1e-6;

/// The loop of a design without a reference, from |x_i| <= 1 at the start.
pub(super) fn from_units(spec: &Spec) -> Spec {
    let mut spec = spec.clone();
    spec.reference = None;
    if let Clock::Samples(own) = &mut spec.clock {
        own.follows = None;
    }
    let one = || Fixed::Number { text: "1".to_owned(), value: BigRational::one() };
    spec.promises.x0_max = vec![one(); spec.n];
    spec
}

/// u of every sample without noise, from each x_i = 1 alone.
pub(super) struct Responses {
    pub(super) of_state: Vec<Vec<f64>>,
    /// The limit of |u|.
    limit: f64,
}

impl Responses {
    /// `None` where the loop is not known.
    pub(super) fn of(spec: &Spec, expanded: Option<&Expanded>) -> Option<Self> {
        let units = from_units(spec);
        if !spec.fixed.contains_key(&Parameter::Eps) {
            return None;
        }
        let closed = Loop::new(&units, expanded).ok().filter(|closed| closed.samples <= SAMPLES)?;
        let gain = closed.gain();
        let sampled = closed.acting(&gain).ok()?;
        let from = |j: usize| {
            let mut state = vec![0.0; sampled.size()];
            state[j] = 1.0;
            let mut walk = sampled.walk(false);
            let mut input = |k: usize| {
                let step = walk.at(k);
                let gains = step.u.of_state.iter().zip(&state);
                let u: f64 = gains.map(|((gain, _), x)| gain * x).sum();
                let rows = step.matrix.entries.chunks_exact(state.len());
                state = rows.map(|row| row.iter().zip(&state).map(|(a, x)| a * x).sum()).collect();
                u
            };
            (0..=closed.samples).map(&mut input).collect()
        };
        Some(Self { of_state: (0..spec.n).map(from).collect(), limit: closed.limit() })
    }
}

/// Describes the peak of |u| from each x_i = 1 alone, and the x_i from which it reaches u_max; `None` where the loop is
/// not known.
pub(super) fn peaks(spec: &Spec, expanded: Option<&Expanded>) -> Option<String> {
    let responses = Responses::of(spec, expanded)?;
    let most = |u: &Vec<f64>| u.iter().fold(0.0_f64, |most, u| most.max(u.abs())) * ROUNDED;
    let all: Vec<_> = responses.of_state.iter().map(most).collect();
    let state = |j: usize| spec.state_of_loop(j);
    let each = (0..).zip(&all).map(|(j, u)| format!("{} from {} = 1", digits(*u), state(j)));
    let each = each.collect::<Vec<_>>().join(", ");
    let below = limit_of_u(spec, 0).map(|(_, name)| {
        let limit = responses.limit;
        let moving = (0..).zip(&all).filter(|(_, u)| **u > 0.0);
        let from = moving.map(|(j, u)| format!("|{}| < {}", state(j), digits_down(limit / u)));
        format!("; below {name} for {}, each alone", from.collect::<Vec<_>>().join(", "))
    });
    let below = below.unwrap_or_default();
    Some(format!("peak of |u| in proportion to the start, without noise: {each}{below}"))
}
