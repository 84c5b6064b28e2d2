//! Kinks along a step, and what no run crosses: a step is one of a single mode where every distance stays on the side
//! on which it begins.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use crate::program::kink::Kink;
use crate::program::lanes::{LANES, Lanes, Pack};
use crate::simulate::crossing::{NODES, is_coarse};
use crate::simulate::lanes::along::distances;
use crate::simulate::lanes::flow::Which;

/// The node at the end of a step.
pub(super) const LAST: usize = NODES - 1;

/// The kinks of the rates, with their distances in each lane.
#[derive(Clone, Debug)]
pub(super) struct Kinks {
    all: Vec<Watched>,
    /// True before the rates at the start of a step.
    is_new: bool,
    /// Lanes in which no distance has left its side.
    kept: Which,
}

#[derive(Clone, Debug)]
struct Watched {
    /// `None` for the determinant of an inertia.
    kink: Option<Kink>,
    /// 1 above the kink and -1 below.
    side: Pack,
    /// The distance where the rates were computed last, positive on its side.
    here: Pack,
    /// The same at the nodes of a step.
    nodes: [Pack; NODES],
}

impl Kinks {
    /// Those of a plant, which may have an inertia.
    pub(super) fn new(kinks: &[Kink], has_inertia: bool) -> Self {
        let none = Pack::all(f64::NAN);
        let watched = |kink| Watched { kink, side: none, here: none, nodes: [none; NODES] };
        let kinks = kinks.iter().map(|kink| Some(*kink)).chain(has_inertia.then_some(None));
        Self { all: kinks.map(watched).collect(), is_new: true, kept: [true; LANES] }
    }

    pub(super) fn any(&self) -> bool {
        !self.all.is_empty()
    }

    /// Before the rates at the start of a step.
    pub(super) fn begin(&mut self) {
        (self.is_new, self.kept) = (true, [true; LANES]);
    }

    /// Takes the distances where the rates have been computed, and the determinant there.
    pub(super) fn pass(&mut self, lanes: &Lanes, determinant: Option<&Pack>) {
        let determinant = determinant.copied().unwrap_or(Pack::all(f64::NAN));
        let Self { all, is_new, kept } = self;
        for Watched { kink, side, here, nodes } in all {
            let distance = kink.as_ref().map_or(determinant, |kink| distances(kink, lanes));
            if *is_new {
                *side = distance.map(|own| if own < 0.0 { -1.0 } else { 1.0 });
            }
            *here = Pack::of(|lane| distance.0[lane] * side.0[lane]);
            if *is_new {
                nodes[0] = *here;
            }
            for lane in 0..LANES {
                kept[lane] &= here.0[lane] > 0.0;
            }
        }
        *is_new = false;
    }

    /// Keeps the distances of the last rates as those at a node.
    pub(super) fn note(&mut self, node: usize) {
        self.all.iter_mut().for_each(|own| own.nodes[node] = own.here);
    }

    /// Returns true if a lane stays on one side of every kink, between the nodes too.
    pub(super) fn keep(&self, lane: usize) -> bool {
        let values = |own: &Watched| own.nodes.each_ref().map(|pack| pack.0[lane]);
        self.kept[lane] && !self.all.iter().any(|own| is_coarse(&values(own), NODES, 0.0))
    }
}
