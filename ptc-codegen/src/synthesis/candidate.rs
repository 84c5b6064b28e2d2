//! The candidates: mappings in the order in which they are tried, poles, and how fast these may be.

use super::choice::{Choice, Key, Value};
use super::wish::{Wish, for_each};
use crate::diagnostic::digits;

/// A mapping that is tried.
#[derive(Debug)]
pub struct Plan {
    /// Its family.
    pub family: &'static str,
    /// Its parameters beside the rate, as they follow it.
    rest: &'static str,
    /// Decay rate of mu' at a rate of 1.
    decay: f64,
    /// Why it is tried where it is.
    pub reason: &'static str,
}

/// The mappings, in the order in which they are tried. `exp_sum` is none of them: it is found by an
/// iteration in each step, and what its rates do is left to a person.
pub static MAPPINGS: [Plan; 6] = [
    Plan {
        family: "exp",
        rest: "",
        decay: 1.0,
        reason: "its law is the cheapest, its checks are exact, and without a disturbance objectives can be proved",
    },
    Plan {
        family: "tanh",
        rest: "",
        decay: 2.0,
        reason: "it begins more gently than exp, and calls no function in a step",
    },
    Plan {
        family: "rational",
        rest: "",
        decay: 0.0,
        reason: "every stable pole brings x and u to 0, so that slow ones will do, and a step calls no function",
    },
    Plan {
        family: "power",
        rest: ",m=0.5",
        decay: 0.0,
        reason: "between exp and rational, at a square root a step",
    },
    Plan {
        family: "algebraic",
        rest: "",
        decay: 0.0,
        reason: "it begins more gently than rational, at a square root a step",
    },
    Plan {
        family: "tan",
        rest: "",
        decay: 0.0,
        reason: "it begins more gently than rational and ends as it does, at a tangent a step",
    },
];

impl Plan {
    fn mu(&self, rate: f64) -> String {
        format!("{}(a={}{})", self.family, digits(rate), self.rest)
    }
}

/// Why a mapping is chosen.
pub(super) fn reason(mu: &str) -> &'static str {
    let plan = MAPPINGS.iter().find(|plan| mu.split('(').next() == Some(plan.family));
    plan.map_or("", |plan| plan.reason)
}

/// Distances of neighbouring poles, as a part of the slowest one. Poles that are real and distinct
/// leave the loop to a proof; far ones act one after the other, close ones together.
const SPACINGS: [f64; 2] = [0.25, 1.0];

/// A mapping and a pattern of poles, at any speed.
#[derive(Debug)]
pub(super) struct Candidate {
    /// Number of poles of each output.
    orders: Vec<usize>,
    /// The mapping, where the wish leaves it open.
    plan: Option<&'static Plan>,
    /// The distance of the poles, where the wish leaves the law open.
    spacing: Option<f64>,
    /// The slowest pole at a speed of 1, or the pole at a rate of 1.
    unit: f64,
    /// Least and greatest speed.
    pub(super) range: (f64, f64),
    /// The speed that is tried first.
    pub(super) first: f64,
}

/// A part of the search.
#[derive(Debug)]
pub(super) enum Part {
    /// One number: the speed of a candidate.
    Speed(Candidate),
    /// The keys of a loop in samples, one after the other; poles of these candidates come last.
    Keys(Vec<Candidate>),
}

/// All parts of the search, in their order.
pub(super) fn parts(wish: &Wish<'_>) -> Vec<Part> {
    let plans: Vec<_> = match wish.leaves_mapping() {
        // In samples the law is that of `exp`.
        true => MAPPINGS
            .iter()
            .take(if wish.is_in_samples() { 1 } else { MAPPINGS.len() })
            .map(Some)
            .collect(),
        false => vec![None],
    };
    let spaced = |plan: Option<&'static Plan>, orders: &[usize]| -> Vec<Candidate> {
        let spacings = match wish.leaves_law() {
            true if orders.iter().all(|order| *order == 1) => vec![Some(SPACINGS[0])],
            true => SPACINGS.map(Some).to_vec(),
            false => vec![None],
        };
        spacings.into_iter().map(|spacing| Candidate::new(wish, orders, plan, spacing)).collect()
    };
    let orders = wish.orders();
    if wish.is_in_samples() && (wish.leaves_law() || wish.leaves_observer()) {
        return vec![Part::Keys(spaced(plans[0], &orders))];
    }
    let each = |plan: &Option<_>| spaced(*plan, &orders).into_iter().map(Part::Speed);
    let mut all: Vec<_> = plans.iter().take(1).flat_map(each).collect();
    // In samples where `exp` does not do in time: its loop ends at rest, whatever the period is.
    all.extend(wish.order_in_samples().map(|order| Part::Keys(spaced(plans[0], &[order]))));
    all.extend(plans.iter().skip(1).flat_map(each));
    all
}

impl Candidate {
    fn new(
        wish: &Wish<'_>,
        orders: &[usize],
        plan: Option<&'static Plan>,
        spacing: Option<f64>,
    ) -> Self {
        let (unit, decay) = match plan {
            Some(plan) if spacing.is_some() => (1.0, plan.decay),
            Some(plan) => (wish.slowest_pole(), plan.decay),
            None => wish.rate(),
        };
        #[allow(clippy::cast_precision_loss)]
        let poles = orders.iter().copied().max().unwrap_or(1) as f64;
        // Left of -n rho u goes to 0, and x with it. Where rho = 0 each stable pole does that.
        let (range, first) = if plan.is_none() && spacing.is_none() {
            ((1.0, 1.0), 1.0)
        } else if decay > 0.0 {
            let line = poles * decay;
            ((line, 32.0 * line), 1.5 * line)
        } else {
            ((poles / 16.0, 32.0 * poles), poles)
        };
        let orders = orders.to_vec();
        Self { orders, plan, spacing, unit, range, first }
    }

    /// Returns the choice at a speed, all numbers to four digits.
    pub(super) fn at(&self, speed: f64) -> Choice {
        let pole = |i: usize, spacing: f64| {
            #[allow(clippy::cast_precision_loss)]
            let place = 1.0 + i as f64 * spacing;
            digits(-speed * self.unit * place)
        };
        let rate = if self.spacing.is_some() { 1.0 } else { self.unit / speed };
        let mut choice = Choice::default();
        if let Some(plan) = self.plan {
            choice = choice.word(Key::Mu, plan.mu(rate));
        }
        if let Some(spacing) = self.spacing {
            let poles = for_each(&self.orders, &|i| pole(i, spacing));
            choice = choice.with(Key::Poles, Value::Poles(poles));
        }
        choice
    }
}
