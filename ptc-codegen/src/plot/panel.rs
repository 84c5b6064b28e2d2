//! One panel: a quantity of every run, with its axes and bounds.

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{PathElement, Text};
use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::chart::dashed;
use super::style::{Pen, SMALL};
use super::{Figure, Quantity, Trace, chart, range};
use crate::program::range::Range;

/// Content of a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Panel {
    /// State of this index from 0, over time.
    State(usize),
    /// Input of this index from 0, over time.
    Control(usize),
    /// The first state over stretched time: xi_1 = x_1.
    Stretched,
    /// Quantity that the objective of this index from 0 bounds, over time.
    Objective(usize),
}

/// Part of the horizontal axis over which a bound is drawn that holds at one instant alone.
const TICK: f64 = 0.04;

/// Part of the horizontal axis between a deadline and its name.
const GAP: f64 = 0.015;

/// Parts of both axes that the name of a deadline takes.
const NAME: (f64, f64) = (0.2, 0.12);

/// Part of tau at the start in which u may be so large that the rest would be a flat line.
const OUTSET: f64 = 0.02;

impl Panel {
    /// The panels of a figure.
    pub(super) fn all(figure: &Figure) -> Vec<Self> {
        let order = figure.traces.first().map_or(0, |trace| trace.x.len());
        let inputs = figure.traces.first().map_or(1, |trace| trace.u.len());
        let known = |trace: &Trace| trace.stretched.iter().any(|s| s.is_finite());
        let stretched = figure.traces.iter().any(known).then_some(Self::Stretched);
        let objectives = (0..figure.objectives.len()).map(Self::Objective);
        let inputs = (0..inputs).map(Self::Control);
        let of_run = (0..order).map(Self::State).chain(inputs).chain(stretched);
        of_run.chain(objectives).collect()
    }

    /// Draws it.
    pub(super) fn draw<B: DrawingBackend>(
        self,
        figure: &Figure,
        area: &DrawingArea<B, Shift>,
        pen: Pen,
    ) -> Result<(), String> {
        let told = |error: &dyn std::fmt::Display| error.to_string();
        let (across, (up, cut)) = (self.across(figure), self.up(figure));
        let mut chart = chart::around(area, &self.title(figure, cut), pen)
            .build_cartesian_2d(across.0..across.1, up.0..up.1)
            .map_err(|e| told(&e))?;
        chart::mesh(&mut chart, pen)
            .x_label_formatter(&|x| range::mark(*x, across))
            .y_label_formatter(&|y| self.label(figure, *y, up))
            .x_desc(if self == Self::Stretched { "stretched time since t0 in s" } else { "t in s" })
            .draw()
            .map_err(|e| told(&e))?;
        let levels =
            self.levels(figure).into_iter().map(|level| (level, self.drawn(figure, level)));
        for (level, at) in levels.filter(|(_, at)| (up.0..=up.1).contains(at)) {
            let points = vec![(across.0, at), (across.1, at)];
            dashed(&mut chart, points, pen.dash_of_bound(), pen.bound())?;
            let below = if level > 0.0 { VPos::Top } else { VPos::Bottom };
            let text = pen.bound_text().pos(Pos::new(HPos::Left, below));
            let label = Text::new(format!("bound {}", range::label(level)), (across.0, at), text);
            chart.draw_series([label]).map_err(|e| told(&e))?;
        }
        for points in self.bounds(figure, across) {
            let points = points.into_iter().map(|(x, y)| (x, y.clamp(up.0, up.1))).collect();
            dashed(&mut chart, points, pen.dash_of_bound(), pen.bound())?;
        }
        for (index, trace) in figure.traces.iter().enumerate() {
            if self != Self::Stretched {
                let line = vec![(trace.deadline, up.0), (trace.deadline, up.1)];
                let line = PathElement::new(line, pen.deadline(index));
                chart.draw_series([line]).map_err(|e| told(&e))?;
            }
            let inside = |(x, y): &(f64, f64)| *x <= across.1 && y.is_finite();
            let points: Vec<_> = self.points(figure, trace).into_iter().filter(inside).collect();
            let points = points.into_iter().map(|(x, y)| (x, y.clamp(up.0, up.1))).collect();
            dashed(&mut chart, points, pen.dash(index), pen.line(index))?;
        }
        for at in self.named_deadlines(figure, across) {
            let text = pen.text(SMALL).pos(Pos::new(HPos::Right, VPos::Top));
            let place = (at - GAP * (across.1 - across.0), self.free(figure, at, across, up));
            let label = Text::new("deadline", place, text);
            chart.draw_series([label]).map_err(|e| told(&e))?;
        }
        Ok(())
    }

    /// The deadlines that have room for their name beside them.
    fn named_deadlines(self, figure: &Figure, across: (f64, f64)) -> Vec<f64> {
        let mut all: Vec<_> = figure.traces.iter().map(|trace| trace.deadline).collect();
        all.sort_by(f64::total_cmp);
        let room = NAME.0 * (across.1 - across.0);
        let mut last = across.0;
        all.retain(|at| {
            self != Self::Stretched && *at - last >= room && {
                last = *at;
                true
            }
        });
        all
    }

    /// The top of the highest place for a name left of `at` that no run and no bound crosses, else that of the panel.
    fn free(self, figure: &Figure, at: f64, across: (f64, f64), up: (f64, f64)) -> f64 {
        let room = NAME.1 * (up.1 - up.0);
        let from = at - (NAME.0 + 2.0 * GAP) * (across.1 - across.0);
        let levels = self.levels(figure).into_iter();
        let mut lines: Vec<_> = levels.map(|level| [self.drawn(figure, level); 2]).collect();
        for trace in &figure.traces {
            let points = self.points(figure, trace);
            let beside = points.windows(2).filter(|ends| ends[1].0 >= from && ends[0].0 <= at);
            lines.extend(beside.map(|ends| [ends[0].1, ends[1].1]));
        }
        let crosses = |top: f64, [one, other]: [f64; 2]| {
            one.min(other) <= top && one.max(other) >= top - room
        };
        let tops = (0..8).map(|place| up.1 - f64::from(place) * room);
        let mut free = tops.filter(|top| !lines.iter().any(|line| crosses(*top, *line)));
        free.next().unwrap_or(up.1)
    }

    fn title(self, figure: &Figure, cut: bool) -> String {
        let sized =
            |name: &str| if figure.by_decades { format!("|{name}|") } else { name.to_owned() };
        let of = |name: Option<&Quantity>| {
            let Some(Quantity { name, unit }) = name else { return String::new() };
            let unit = unit.as_ref().map_or(String::new(), |unit| format!(" in {unit}"));
            format!("{}{unit}", sized(name))
        };
        match self {
            Self::Objective(index) => figure.objectives[index].title.clone(),
            Self::State(index) => of(figure.states.get(index)),
            Self::Control(index) => {
                let name = of(figure.inputs.get(index));
                if cut { format!("{name}, to scale from t0 + {OUTSET} tau on") } else { name }
            }
            Self::Stretched => format!("{} = {} in stretched time", sized("x1"), sized("xi1")),
        }
    }

    /// The bounds that are constant; of sizes each once.
    fn levels(self, figure: &Figure) -> Vec<f64> {
        let range = match self {
            Self::State(index) => figure.x_max.get(index).map(|most| Range::symmetric(*most)),
            Self::Control(index) => figure.limits.get(index).copied(),
            Self::Stretched | Self::Objective(_) => None,
        };
        let mut levels: Vec<_> = range.into_iter().flat_map(Range::finite).collect();
        levels.reverse();
        if self.by_decades(figure) {
            levels.iter_mut().for_each(|level| *level = level.abs());
            levels.dedup();
        }
        levels
    }

    /// Returns true if the vertical axis is logarithmic.
    fn by_decades(self, figure: &Figure) -> bool {
        match self {
            Self::Objective(index) => figure.objectives[index].by_decades,
            Self::State(_) | Self::Control(_) | Self::Stretched => figure.by_decades,
        }
    }

    /// A value as it is drawn: on a logarithmic axis the power of ten of its size.
    fn drawn(self, figure: &Figure, y: f64) -> f64 {
        if self.by_decades(figure) { y.abs().log10() } else { y }
    }

    fn label(self, figure: &Figure, y: f64, up: (f64, f64)) -> String {
        match self.by_decades(figure) {
            false => range::mark(y, up),
            true if (y - y.round()).abs() < 1e-6 => range::power_of_ten(y),
            true => String::new(),
        }
    }

    /// The bounds that go with time, in pieces without a gap.
    fn bounds(self, figure: &Figure, across: (f64, f64)) -> Vec<Vec<(f64, f64)>> {
        let (Self::Objective(index), Some(trace)) = (self, figure.traces.first()) else {
            return Vec::new();
        };
        let mut pieces = Vec::new();
        for bound in &figure.objectives[index].bounds {
            let points: Vec<_> = self.along(figure, &trace.t, bound);
            for piece in points.split(|(_, y)| !y.is_finite()) {
                match piece {
                    [] => {}
                    [(x, y)] => {
                        pieces.push(vec![(x - TICK * (across.1 - across.0), *y), (*x, *y)]);
                    }
                    _ => pieces.push(piece.to_vec()),
                }
            }
        }
        pieces
    }

    /// Points as they are drawn.
    fn along(self, figure: &Figure, x: &[f64], y: &[f64]) -> Vec<(f64, f64)> {
        x.iter().copied().zip(y.iter().map(|y| self.drawn(figure, *y))).collect()
    }

    fn points(self, figure: &Figure, trace: &Trace) -> Vec<(f64, f64)> {
        match self {
            Self::State(index) => self.along(figure, &trace.t, &trace.x[index]),
            Self::Control(index) if trace.held => {
                let steps = trace.t.windows(2).zip(&trace.u[index]);
                let drawn = |u: &f64| self.drawn(figure, *u);
                steps.flat_map(|(t, u)| [(t[0], drawn(u)), (t[1], drawn(u))]).collect()
            }
            Self::Control(index) => self.along(figure, &trace.t, &trace.u[index]),
            Self::Stretched => self.along(figure, &trace.stretched, &trace.x[0]),
            Self::Objective(index) => {
                self.along(figure, &trace.t, &figure.objectives[index].values)
            }
        }
    }

    /// The shown part of the horizontal axis.
    fn across(self, figure: &Figure) -> (f64, f64) {
        let traces = figure.traces.iter();
        if self == Self::Stretched {
            let end = traces.map(settled).fold(0.0, f64::max);
            return (0.0, if end > 0.0 { end } else { 1.0 });
        }
        let start = traces.clone().map(|trace| trace.start).fold(f64::INFINITY, f64::min);
        let last = |trace: &Trace| trace.t.last().copied().unwrap_or(0.0).max(trace.deadline);
        let end = traces.map(last).fold(f64::NEG_INFINITY, f64::max);
        if start < end && (end - start).is_finite() { (start, end) } else { (0.0, 1.0) }
    }

    /// The shown part of the vertical axis, and whether it leaves out the outset of u.
    fn up(self, figure: &Figure) -> ((f64, f64), bool) {
        let all = || {
            let points = figure.traces.iter().flat_map(|trace| self.points(figure, trace));
            points.map(|(_, y)| y)
        };
        let bounds = self.bounds(figure, (0.0, 1.0)).into_iter().flatten().map(|(_, y)| y);
        if self.by_decades(figure) {
            let levels = self.levels(figure).into_iter().map(|level| self.drawn(figure, level));
            return (range::decades(all().chain(bounds).chain(levels)), false);
        }
        let peak = all().filter(|y| y.is_finite()).fold(0.0_f64, |peak, y| peak.max(y.abs()));
        // A bound that is far away would make a flat line of the run.
        let near = self.levels(figure).into_iter().filter(|level| level.abs() <= 2.0 * peak);
        let whole = range::of(all().chain(bounds).chain(near));
        let later = |trace: &Trace| {
            let from = trace.start + OUTSET * (trace.deadline - trace.start);
            self.points(figure, trace).into_iter().filter(move |(t, _)| *t >= from).map(|(_, y)| y)
        };
        let rest = range::of(figure.traces.iter().flat_map(later));
        match self {
            Self::Control(_) if whole.1 - whole.0 > 4.0 * (rest.1 - rest.0) => (rest, true),
            _ => (whole, false),
        }
    }
}

/// The stretched time up to which there is something to see: x_1 above a hundredth of its peak, and
/// half as much again; at most that of T = tau/100.
fn settled(trace: &Trace) -> f64 {
    let peak = trace.x[0].iter().fold(0.0_f64, |peak, x| peak.max(x.abs()));
    let seen = trace.stretched.iter().zip(&trace.x[0]).filter(|(_, x)| x.abs() > peak / 100.0);
    let last = seen.map(|(s, _)| *s).fold(0.0, f64::max);
    let tau = trace.deadline - trace.start;
    let before =
        trace.stretched.iter().zip(&trace.t).filter(|(_, t)| trace.deadline - *t >= tau / 100.0);
    let most = before.map(|(s, _)| *s).fold(0.0, f64::max);
    if last > 0.0 { (1.5 * last).min(most) } else { most }
}
