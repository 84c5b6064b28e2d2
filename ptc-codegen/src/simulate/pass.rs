//! Steps of a method up to points and events.
// A piece that ends early hands over its state, once.
#![allow(clippy::result_large_err)]

use super::Failure;
use super::crossing::{NODES, PART, Step, look};
use super::method::{Method, State};
use super::mode::no_value;
use super::solver::finite;

/// Functions of point and state that are positive until an event.
pub(super) type Monitor<'a> = &'a dyn Fn(f64, &State, &mut Vec<f64>);

/// Observer of the state at each point.
pub(super) type Visit<'a> = &'a mut dyn FnMut(usize, f64, &State);

/// End of a piece of a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    pub(super) at: f64,
    pub(super) state: State,
    /// The step that the method would go on with.
    pub(super) step: f64,
    pub(super) end: End,
}

/// Why a piece ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// The last point is reached.
    Done,
    /// The piece is long enough.
    Limit,
    /// A function of the monitor is 0.
    Event(usize),
}

/// Remainder of a run.
pub(super) struct Pass<'a> {
    pub(super) points: &'a [f64],
    pub(super) next: usize,
    /// Steps.
    pub(super) left: usize,
    /// End of the piece.
    pub(super) until: f64,
    /// Longest step over which the functions of the monitor are resolved.
    pub(super) longest: f64,
    /// True if the steps stay too small to come to an end.
    pub(super) stalled: bool,
    /// True if the last two functions of the monitor are the parts of a slide.
    pub(super) slides: bool,
}

/// Steps after which it is asked whether they lead on.
const ASKED: usize = 5000;

/// Steps that a rest of a run may take at the pace of the last ones asked for.
const HOPELESS: f64 = 1e9;

/// Growth of the pace from one question to the next at which a run leaves what it had to resolve: it passes a point at
/// which f oscillates without end, but not one that the state runs into.
const RECOVERING: f64 = 2.0;

/// End of a piece, and the reason why it does not go on: no failure where only the steps are used up.
pub(super) type Stopped = (Reached, Option<Failure>);

impl Pass<'_> {
    /// Steps on; no failure where only the steps are used up.
    pub(super) fn run(
        &mut self,
        method: &mut dyn Method,
        monitor: Option<Monitor<'_>>,
        visit: Visit<'_>,
    ) -> Result<Reached, Stopped> {
        let end = self.points.last().copied().unwrap_or(f64::NAN).min(self.until);
        let (mut asked_at, mut asked) = (method.t(), self.left.saturating_sub(ASKED));
        let mut before = f64::INFINITY;
        loop {
            let (at, state, wanted) = (method.t(), method.y(), method.h());
            let here = |end| Reached { at, state, step: wanted, end };
            let Some(point) = self.points.get(self.next).copied() else {
                return Ok(here(End::Done));
            };
            // What is left is a rounding of the steps that lead here.
            if point - at <= 1e-13 * point.abs().max(1.0) {
                visit(self.next, point, &state);
                self.next += 1;
                continue;
            }
            if self.until - at <= 1e-13 * at.abs().max(1.0) {
                return Ok(here(End::Limit));
            }
            if self.left == 0 {
                return Err((here(End::Done), None));
            }
            self.left -= 1;
            if self.left < asked {
                #[allow(clippy::cast_precision_loss)]
                let pace = (at - asked_at) / ASKED as f64;
                if (end - at) > HOPELESS * pace.max(before) && pace <= RECOVERING * before {
                    self.stalled = true;
                    return Err((here(End::Done), None));
                }
                (asked_at, asked, before) = (at, self.left.saturating_sub(ASKED), pace);
            }
            let wrong = |failure| (here(End::Done), Some(failure));
            let goal = point.min(self.until);
            let mut step = wanted.min(self.longest);
            let cut = at + step > goal;
            if cut {
                step = goal - at;
            }
            if step < wanted {
                method.set_step(step).map_err(wrong)?;
            }
            method.weigh();
            method.step().map_err(wrong)?;
            let proposed = method.h();
            if method.t() <= at {
                continue;
            }
            if !finite(&method.y()) {
                return Err((here(End::Done), Some(Failure::range())));
            }
            if let Some(monitor) = monitor
                && let Some(event) = self.watch(method, monitor, (at, state))?
            {
                let step = proposed.max(step);
                let (at, state) = (method.t(), method.y());
                return Ok(Reached { at, state, step, end: End::Event(event) });
            }
            if step < wanted && method.t() > at && wanted > method.h() {
                method.set_step(wanted).map_err(wrong)?;
            }
        }
    }

    /// Looks at a step for the first event, and goes back where one is, or may be overlooked.
    fn watch(
        &mut self,
        method: &mut dyn Method,
        monitor: Monitor<'_>,
        (at, state): (f64, State),
    ) -> Result<Option<usize>, Stopped> {
        let here = Reached { at, state, step: method.h(), end: End::Done };
        let wrong = |failure| (here, Some(failure));
        let to = method.t();
        let length = to - at;
        let mut values = Vec::new();
        let mut table: Vec<Vec<f64>> = Vec::with_capacity(NODES);
        for node in 0..NODES {
            values.clear();
            match node {
                0 => monitor(at, &state, &mut values),
                _ if node + 1 == NODES => monitor(to, &method.y(), &mut values),
                _ => {
                    let s = at + share(node) * length;
                    let y = method.within(s.min(to)).map_err(wrong)?;
                    monitor(s, &y, &mut values);
                }
            }
            table.push(values.clone());
        }
        match look(&table, self.slides) {
            Step::Clear => {
                self.longest *= 1.5;
                Ok(None)
            }
            Step::NoNumber => Err(wrong(no_value())),
            Step::Coarse if length > 1e-11 * at.abs().max(1.0) => {
                self.longest = 0.5 * length;
                method.restart(at, &state, self.longest).map_err(wrong)?;
                Ok(None)
            }
            Step::Coarse => Ok(None),
            Step::Event { node } => {
                let (before, after) = (&table[node - 1], &table[node]);
                let (low, high) = (share(node - 1), share(node));
                let crossing = (0..after.len()).filter(|which| after[*which] < 0.0);
                let mut first: Option<(f64, usize)> = None;
                for which in crossing {
                    let mut at_share = |share: f64| {
                        let s = at + share * length;
                        let y = method.within(s.min(to)).unwrap_or(state);
                        values.clear();
                        monitor(s, &y, &mut values);
                        values[which]
                    };
                    let root = match before[which] > 0.0 {
                        true => root((low, before[which]), high, &mut at_share),
                        // A rounding of the event that led here.
                        false => low,
                    };
                    if first.is_none_or(|(least, _)| root < least) {
                        first = Some((root, which));
                    }
                }
                let Some((share, which)) = first else { return Ok(None) };
                let mut goal = at + share * length;
                // By steps of the method itself, as its dense output is less exact.
                for _ in 0..6 {
                    if goal - at <= 1e-14 * at.abs().max(1.0) {
                        method.restart(at, &state, length).map_err(wrong)?;
                        return Ok(Some(which));
                    }
                    self.land(method, (at, state), goal)?;
                    let of_slide = self.slides && which + 2 >= before.len();
                    let least = if of_slide { PART } else { 0.0 };
                    let off = distance(method, monitor, (which, least)).map_err(wrong)?;
                    if off.abs() <= 1e-13 * goal.abs().max(1.0) {
                        return Ok(Some(which));
                    }
                    if off.is_nan() || off.abs() > 0.5 * (goal - at) || goal + off > to {
                        break;
                    }
                    goal += off;
                }
                // Over a shorter step it is.
                self.longest = 0.5 * (goal - at).min(length);
                method.restart(at, &state, self.longest).map_err(wrong)?;
                Ok(None)
            }
        }
    }

    /// Steps from a state to a point close by.
    fn land(
        &mut self,
        method: &mut dyn Method,
        (at, state): (f64, State),
        goal: f64,
    ) -> Result<(), Stopped> {
        let here = Reached { at, state, step: goal - at, end: End::Done };
        let wrong = |failure| (here, Some(failure));
        method.restart(at, &state, goal - at).map_err(wrong)?;
        loop {
            let left = goal - method.t();
            if left <= 1e-15 * goal.abs().max(1.0) {
                return Ok(());
            }
            if self.left == 0 {
                return Err((here, None));
            }
            self.left -= 1;
            if method.h() > left {
                method.set_step(left).map_err(wrong)?;
            }
            method.step().map_err(wrong)?;
        }
    }
}

/// Returns the distance of the root of a function from the end of a step, by its slope there; NaN where it rises. A
/// size of at most `least` counts as 0.
fn distance(
    method: &mut dyn Method,
    monitor: Monitor<'_>,
    (which, least): (usize, f64),
) -> Result<f64, Failure> {
    let mut values = Vec::new();
    let (to, before) = (method.t(), method.t_prev());
    monitor(to, &method.y(), &mut values);
    let here = values[which];
    let near = to - 0.02 * (to - before);
    let y = method.within(near)?;
    values.clear();
    monitor(near, &y, &mut values);
    let slope = (here - values[which]) / (to - near);
    if here.abs() <= least {
        Ok(0.0)
    } else if slope < 0.0 {
        Ok(-here / slope)
    } else {
        Ok(f64::NAN)
    }
}

/// Returns the position of a node, as a part of the step.
#[allow(clippy::cast_precision_loss)]
pub(super) fn share(node: usize) -> f64 {
    node as f64 / (NODES - 1) as f64
}

/// The root of a function that is positive, or 0, at `low` and negative at `high`: by Illinois'
/// rule, and by halves where it is slow.
fn root((mut low, mut above): (f64, f64), mut high: f64, at: &mut dyn FnMut(f64) -> f64) -> f64 {
    let mut below = at(high);
    let mut side = 0;
    for round in 0..100 {
        let width = high - low;
        if width <= 1e-15 {
            break;
        }
        let chord = low + width * above / (above - below);
        let inside = chord > low && chord < high;
        let middle = if inside && round % 4 != 3 { chord } else { 0.5 * (low + high) };
        let value = at(middle);
        if value == 0.0 {
            return middle;
        }
        if value > 0.0 {
            (low, above) = (middle, value);
            if side == 1 {
                below *= 0.5;
            }
            side = 1;
        } else {
            (high, below) = (middle, value);
            if side == -1 {
                above *= 0.5;
            }
            side = -1;
        }
    }
    0.5 * (low + high)
}
