//! The samples on the way whose signals are kept, for one part of the table.
//!
//! They are few, and each is chosen where those before it bound the signal worst: a number of samples to go, of samples
//! from now, or a part of the way. Each moves evenly with the samples to go, so that its row is interpolated.

use num_traits::ToPrimitive;

use super::Row;
use super::closed::Future;
use super::hull::Hull;

/// A sample on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Knot {
    /// A row of the held gains.
    Held(usize),
    /// So many samples after those of held gains begin.
    Left(usize),
    /// So many samples from now.
    Ahead(usize),
    /// A part of the way from held gains to now.
    Part(f64),
}

/// The samples that are kept.
#[derive(Clone, Debug, Default)]
pub(super) struct Knots(Vec<Knot>);

/// A number of samples to go for which knots are chosen: the signal from there on, and from the two nodes beside it,
/// between which its rows are interpolated, unless it is a node.
pub(super) struct Way {
    pub(super) own: Future,
    pub(super) beside: Option<[Future; 2]>,
}

/// Rows at which a choice looks, of each way.
const LOOKED: usize = 32;

impl Knot {
    fn row(self, future: &Future) -> Row {
        let last = future.rows.len();
        let held = || future.held[0].clone();
        match self {
            Self::Held(i) => future.held[i].clone(),
            Self::Left(i) if last > 0 => future.rows[i.min(last - 1)].clone(),
            Self::Ahead(i) if i < last => future.rows[last - 1 - i].clone(),
            Self::Part(part) if last > 0 => {
                let place = part * (last - 1).to_f64().unwrap_or(0.0);
                let below = place.floor().to_usize().unwrap_or(0).min(last - 1);
                let (a, b) = (&future.rows[below], &future.rows[(below + 1).min(last - 1)]);
                a.iter().zip(b).map(|(a, b)| a + place.fract() * (b - a)).collect()
            }
            Self::Left(_) | Self::Ahead(_) | Self::Part(_) => held(),
        }
    }
}

impl Knots {
    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// Adds knots until there are `most`, or the rows of all ways are bounded by `enough`.
    pub(super) fn choose(&mut self, ways: &[Way], most: usize, enough: f64) {
        if self.0.is_empty() {
            self.0.push(Knot::Ahead(0));
        }
        while self.count() < most {
            let Some((way, place)) = self.worst(ways, enough) else { return };
            let best =
                options(&ways[way].own, place).into_iter().filter(|own| !self.0.contains(own));
            let scored = best.map(|own| {
                let with = Self(self.0.iter().copied().chain([own]).collect());
                (with.score(ways), own)
            });
            match scored.min_by(|a, b| a.0.total_cmp(&b.0)) {
                Some((_, own)) => self.0.push(own),
                None => return,
            }
        }
    }

    /// The rows of a way.
    pub(super) fn rows(&self, future: &Future) -> Vec<Row> {
        self.0.iter().map(|knot| knot.row(future)).collect()
    }

    /// The way and the row that is bounded worst, by more than `enough`.
    fn worst(&self, ways: &[Way], enough: f64) -> Option<(usize, usize)> {
        let each = ways.iter().enumerate().flat_map(|(way, own)| {
            let bounds = self.bounds(own);
            bounds.into_iter().map(move |(place, bound)| ((way, place), bound))
        });
        let worst = each.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (worst.1 > enough).then_some(worst.0)
    }

    /// The sum of the worst bounds of all ways.
    fn score(&self, ways: &[Way]) -> f64 {
        let of_way = |way: &Way| {
            self.bounds(way).into_iter().map(|(_, bound)| bound.ln()).fold(0.0, f64::max)
        };
        ways.iter().map(of_way).sum()
    }

    fn bounds(&self, way: &Way) -> Vec<(usize, f64)> {
        let future = &way.own;
        let rows = match &way.beside {
            None => self.rows(future),
            Some(beside) => {
                let [below, above] = beside.each_ref().map(|future| self.rows(future));
                let middle =
                    |(a, b): (&Row, &Row)| a.iter().zip(b).map(|(a, b)| 0.5 * (a + b)).collect();
                below.iter().zip(&above).map(middle).collect()
            }
        };
        let hull = Hull::new(rows[0].len(), rows.iter());
        let mut basis = hull.basis();
        let places = looked(future.held.len(), future.rows.len());
        let bound = |place: usize| (place, hull.bound(at(future, place), &mut basis).sum);
        places.into_iter().map(bound).collect()
    }
}

/// The rows of a way by one number, those of held gains first.
fn at(future: &Future, place: usize) -> &Row {
    match place.checked_sub(future.held.len()) {
        None => &future.held[place],
        Some(place) => &future.rows[place],
    }
}

/// The knots that give a row.
fn options(future: &Future, place: usize) -> Vec<Knot> {
    let Some(place) = place.checked_sub(future.held.len()) else { return vec![Knot::Held(place)] };
    let last = future.rows.len() - 1;
    let part = place.to_f64().unwrap_or(0.0) / last.max(1).to_f64().unwrap_or(1.0);
    vec![Knot::Part(part), Knot::Left(place), Knot::Ahead(last - place)]
}

/// The rows of a way at which a choice looks: those of held gains, evenly, and closer near both ends.
fn looked(held: usize, rows: usize) -> Vec<usize> {
    let mut all: Vec<_> = (0..held).collect();
    let mut places: Vec<usize> =
        (0..=LOOKED).map(|i| i * rows.saturating_sub(1) / LOOKED).collect();
    let mut near = 1;
    while near < rows / LOOKED {
        places.extend([near, rows - 1 - near]);
        near *= 2;
    }
    places.sort_unstable();
    places.dedup();
    all.extend(places.into_iter().filter(|place| *place < rows).map(|place| held + place));
    all
}
