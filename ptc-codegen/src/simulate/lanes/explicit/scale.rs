//! The scales in which a step is taken, from the slope of the loop.

use super::super::flow::{MOVED, share_at};
use super::{Explicit, Rates};
use crate::program::lanes::Pack;

impl Explicit {
    /// Slope of the first component, from what the last rate has of the last component: in a chain no
    /// other rate has any of its own.
    pub(super) fn slope(&mut self, rates: Rates<'_>) -> Pack {
        let last = self.order - 1;
        let (y, rate) = (self.flow.y[last], self.rate[last]);
        let size = Pack::of(|lane| {
            let size = y.0[lane].abs().max(rate.0[lane].abs());
            if size > 0.0 { MOVED * size } else { MOVED }
        });
        self.state.copy_from_slice(&self.flow.y);
        self.state[last] = Pack::of(|lane| y.0[lane] + size.0[lane]);
        rates(&self.last.share, &self.state, &mut self.scaled);
        #[allow(clippy::cast_precision_loss)]
        let (count, middle) = (self.order as f64, 0.5 * last as f64);
        Pack::of(|lane| {
            let own = (self.scaled[last].0[lane] - rate.0[lane]) / size.0[lane];
            let slope = middle * self.slant - own / count;
            if slope.is_finite() { slope } else { 0.0 }
        })
    }

    #[inline(always)]
    fn slope_of(&self, i: usize) -> Pack {
        #[allow(clippy::cast_precision_loss)]
        let less = self.slant * i as f64;
        self.last.slope.map(|slope| slope - less)
    }

    /// The scales at a part of the step, and T/tau there.
    pub(super) fn rescale(&mut self, part: f64) -> Pack {
        let share = self.rescale_at(&self.last.length.map(|length| part * length));
        Pack::of(|lane| self.last.share.0[lane] * share.0[lane])
    }

    /// The scales after a way, and by what T falls on it.
    pub(super) fn rescale_at(&mut self, way: &Pack) -> Pack {
        let fall = share_at(way);
        let mut scale = Pack::of(|lane| -self.last.slope.0[lane] * way.0[lane]).exp();
        for own in &mut self.scale {
            *own = scale;
            if self.slant != 0.0 {
                scale = Pack::of(|lane| scale.0[lane] / fall.0[lane]);
            }
        }
        fall
    }

    /// The scaled derivatives at the begin of the step, where all scales are 1.
    #[inline(always)]
    pub(super) fn scale_first(&mut self) {
        for i in 0..self.order {
            let slope = self.slope_of(i);
            let (y, rate) = (&self.flow.y[i], &self.rate[i]);
            self.k[i] = Pack::of(|lane| rate.0[lane] + slope.0[lane] * y.0[lane]);
        }
    }

    #[inline(always)]
    pub(super) fn unscale(&mut self) {
        for (i, state) in self.state.iter_mut().enumerate() {
            let (scaled, scale) = (&self.scaled[i], &self.scale[i]);
            *state = Pack::of(|lane| scaled.0[lane] * scale.0[lane]);
        }
    }

    #[inline(always)]
    pub(super) fn scale_rates(&mut self, stage: usize) {
        for i in 0..self.order {
            let (slope, scaled, scale) = (self.slope_of(i), &self.scaled[i], &self.scale[i]);
            let k = &mut self.k[stage * self.order + i];
            *k = Pack::of(|lane| k.0[lane] / scale.0[lane] + slope.0[lane] * scaled.0[lane]);
        }
    }
}
