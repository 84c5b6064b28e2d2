//! The samples of the runs of all lanes: what a [`Frame`](crate::simulate::frame::Frame) is of one run, with its
//! bits.

// Lanes are counted, which compilers make vectors of.
#![allow(clippy::needless_range_loop)]

use super::flow::Which;
use crate::program::lanes::{LANES, Pack};
use crate::simulate::Loop;
use crate::simulate::around::SAME;
use crate::simulate::frame::{Frame, quantised};

/// When the samples of each lane are taken, and what its sensors draw.
#[derive(Clone, Debug)]
pub(super) struct Frames<'a> {
    /// Frames that draw, for lanes in which anything is drawn or quantised.
    drawing: [Option<Frame<'a>>; LANES],
    /// Number of the next sample.
    pub(super) index: u32,
    pub(super) period: Pack,
    end: Pack,
    /// From where on a time counts as the end.
    nearly: Pack,
    /// True if the end of a lane was chosen, and follows no deadline.
    chosen: Which,
    /// Part of a sample after which the next input takes over; `None` where it does at the samples.
    part: Option<f64>,
    /// When the last sample was taken, after t0.
    now: Pack,
    /// The input gains of the plants.
    pub(super) gain: Pack,
    u_step: Pack,
    /// True if any lane draws its times, draws what it measures, or resolves its inputs.
    jitters: bool,
    senses: bool,
    resolves: bool,
}

impl<'a> Frames<'a> {
    pub(super) fn new() -> Self {
        let none = Pack::all(0.0);
        Self {
            drawing: Default::default(),
            index: 0,
            period: none,
            end: none,
            nearly: none,
            chosen: [false; LANES],
            part: None,
            now: none,
            gain: Pack::all(1.0),
            u_step: none,
            jitters: false,
            senses: false,
            resolves: false,
        }
    }

    /// Begins a run of a controller of length `tau` in a lane.
    pub(super) fn start(&mut self, lane: usize, around: &'a Loop, tau: f64) {
        let frame = Frame::new(around, tau);
        self.period.0[lane] = around.period;
        self.end.0[lane] = frame.end;
        self.nearly.0[lane] = frame.end * (1.0 - SAME);
        self.chosen[lane] = around.until.is_some();
        self.part = (!around.delay.is_whole()).then_some(frame.part);
        self.gain.0[lane] = frame.gain;
        self.u_step.0[lane] = around.u_step;
        let (jitters, senses) = (around.jitter > 0.0, !frame.exact);
        self.jitters |= jitters;
        self.senses |= senses;
        self.resolves |= around.u_step > 0.0;
        self.drawing[lane] = (jitters || senses).then_some(frame);
    }

    /// Ends the run of a lane.
    pub(super) fn stop(&mut self, lane: usize) {
        for pack in [&mut self.period, &mut self.end, &mut self.nearly, &mut self.now] {
            pack.0[lane] = 0.0;
        }
        self.drawing[lane] = None;
    }

    /// Puts the end of the run of a lane off to a later deadline, unless its end was chosen.
    pub(super) fn extend(&mut self, lane: usize, deadline: f64) {
        if !self.chosen[lane] {
            self.end.0[lane] = self.end.0[lane].max(deadline);
            self.nearly.0[lane] = self.end.0[lane] * (1.0 - SAME);
        }
    }

    /// The times of the next samples after t0, as the controllers have them, and whether each is the last one.
    pub(super) fn since(&self) -> (Pack, Which) {
        let index = f64::from(self.index);
        let mut since = Pack::of(|lane| index * self.period.0[lane]);
        let mut last = [false; LANES];
        for lane in 0..LANES {
            last[lane] = since.0[lane] >= self.nearly.0[lane];
            since.0[lane] = if last[lane] { self.end.0[lane] } else { since.0[lane] };
        }
        (since, last)
    }

    /// Adds noise to the measured values and quantises them.
    pub(super) fn measure(&mut self, measured: &mut [Pack]) {
        if !self.senses {
            return;
        }
        for (lane, frame) in self.drawing.iter_mut().enumerate() {
            if let Some(frame) = frame {
                frame.measure(measured.iter_mut().map(|own| &mut own.0[lane]));
            }
        }
    }

    /// The inputs as the actuators resolve them.
    pub(super) fn actuated(&self, u: &Pack) -> Pack {
        match self.resolves {
            true => Pack::of(|lane| quantised(u.0[lane], self.u_step.0[lane])),
            false => *u,
        }
    }

    /// Goes on to the next samples: from where over the take-over of the next input to where, after t0. No time is left
    /// where a lane does not run.
    pub(super) fn next(&mut self) -> [Pack; 3] {
        let from = self.now;
        self.index += 1;
        let index = f64::from(self.index);
        let due = Pack::of(|lane| index * self.period.0[lane]);
        let last = Pack::of(|lane| if due.0[lane] >= self.nearly.0[lane] { 1.0 } else { 0.0 });
        let mut to = due;
        if self.jitters {
            for (lane, frame) in self.drawing.iter_mut().enumerate() {
                if let (Some(frame), false) = (frame, last.0[lane] > 0.0) {
                    to.0[lane] = frame.jittered(due.0[lane]);
                }
            }
        }
        let to = Pack::of(|lane| if last.0[lane] > 0.0 { self.end.0[lane] } else { to.0[lane] });
        self.now = to;
        let over = match self.part {
            Some(part) => {
                Pack::of(|lane| to.0[lane].min(from.0[lane] + part * self.period.0[lane]))
            }
            None => to,
        };
        [from, over, to]
    }
}
