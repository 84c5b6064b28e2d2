//! Pictures of runs: states, control and bounds over time, and the view in stretched time; level curves in a plane.
//!
//! The same drawing becomes SVG, PNG and PDF. The page is white, which prints; where a reader's page is
//! dark, SVG turns dark with it. Runs differ by their dashes too, so that no colour is needed.

mod band;
mod chart;
mod contours;
mod curve;
mod drawing;
mod format;
mod histogram;
mod panel;
mod pdf;
mod pixels;
mod quantity;
mod range;
mod run;
mod single;
mod style;

use plotters::drawing::DrawingArea;
use plotters::prelude::DrawingBackend;

use crate::program::range::Range;
pub use band::Band;
pub use contours::{Contour, Contours};
pub use curve::Curve;
use drawing::Drawing;
pub use drawing::Picture;
pub use format::Format;
pub use histogram::Histogram;
use panel::Panel;
pub use quantity::Quantity;
pub use run::Drawn;
use style::Pen;
pub use style::register_letters;

/// Content of a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// A line above all.
    pub title: String,
    /// The states.
    pub states: Vec<Quantity>,
    /// The inputs.
    pub inputs: Vec<Quantity>,
    /// The runs, one a tau.
    pub traces: Vec<Trace>,
    /// Limits of each input; empty where there are none.
    pub limits: Vec<Range>,
    /// Bounds of |x_i|; empty where there are none.
    pub x_max: Vec<f64>,
    /// Objectives that have to hold for the first run.
    pub objectives: Vec<Bounded>,
    /// True if the sizes of states and inputs are drawn, on logarithmic axes.
    pub by_decades: bool,
}

/// A quantity over the times of a run, with bounds that go with time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bounded {
    /// Name of the quantity.
    pub title: String,
    /// Its values.
    pub values: Vec<f64>,
    /// Its bounds, each at the same times; NaN where there is none.
    pub bounds: Vec<Vec<f64>>,
    /// True if the axis is logarithmic: for sizes, which are > 0 and fall by decades.
    pub by_decades: bool,
}

/// One run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// Name in the legend.
    pub label: String,
    /// Start time in s.
    pub start: f64,
    /// Deadline t0 + tau in s.
    pub deadline: f64,
    /// Times in s.
    pub t: Vec<f64>,
    /// Stretched times since the start in s; NaN where they are not known.
    pub stretched: Vec<f64>,
    /// `x[j]` is state j + 1 at these times.
    pub x: Vec<Vec<f64>>,
    /// `u[k]` is input k + 1 at these times.
    pub u: Vec<Vec<f64>>,
    /// True if u is held from each of these times to the next.
    pub held: bool,
}

/// Size of a panel, of what is above all, and of a row of the legend, in pixels.
const PANEL: (u32, u32) = (480, 290);
const HEAD: u32 = 38;
const LEGEND: u32 = 26;

impl Figure {
    /// Describes the figure in words.
    pub fn caption(&self) -> String {
        let panels = Panel::all(self);
        let stretched = match panels.contains(&Panel::Stretched) {
            true => ", and the first state in stretched time",
            false => "",
        };
        let bounded = self.limits.iter().any(|limits| limits.finite().next().is_some())
            || !self.x_max.is_empty();
        let bounds = if bounded { ", dashed ones in red bounds" } else { "" };
        let shown =
            if self.by_decades { "Sizes of states and control" } else { "States and control" };
        format!("{shown} over time in s{stretched}. Thin lines are deadlines{bounds}.")
    }
}

impl Drawing for Figure {
    fn title(&self) -> &str {
        &self.title
    }

    fn size(&self, pen: Pen) -> Result<(u32, u32), String> {
        let rows = u32::try_from(Panel::all(self).len().div_ceil(2)).unwrap_or(1);
        Ok((2 * PANEL.0, style::head_height(self, pen)? + rows * PANEL.1))
    }

    fn draw<B: DrawingBackend>(
        &self,
        page: &DrawingArea<B, plotters::coord::Shift>,
        pen: Pen,
    ) -> Result<(), String> {
        let (head, body) = page.split_vertically(pen.px(style::head_height(self, pen)?));
        style::head(self, &head, pen)?;
        let panels = Panel::all(self);
        let rows = body.split_evenly((panels.len().div_ceil(2), 1));
        for (row, place) in panels.chunks(2).zip(&rows) {
            // A panel alone in the last row takes all of it.
            for (panel, place) in row.iter().zip(&place.split_evenly((1, row.len()))) {
                panel.draw(self, place, pen)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure() -> Figure {
        let t: Vec<_> = (0..=50).map(|i| f64::from(i) / 50.0).collect();
        let trace = |label: &str, held| Trace {
            label: label.to_owned(),
            deadline: 1.0,
            stretched: t.iter().map(|t| if held { f64::NAN } else { -(1.001 - t).ln() }).collect(),
            x: vec![t.iter().map(|t| 1.0 - t).collect(), t.iter().map(|_| -1.0).collect()],
            u: vec![t.iter().map(|t| t - 0.5).collect()],
            t: t.clone(),
            held,
            ..Trace::default()
        };
        Figure {
            title: "two runs".to_owned(),
            states: ["x1", "x2"].map(Quantity::plain).into(),
            inputs: vec![Quantity::plain("u")],
            traces: vec![trace("one", false), trace("two", true)],
            limits: vec![Range::symmetric(0.6)],
            x_max: vec![1.2],
            ..Figure::default()
        }
    }

    /// The values of a run fall from 1 to 0 and u passes 0: sizes are drawn, and a 0 is left out.
    #[test]
    fn logarithmic_plots_show_absolute_values() {
        let plain = figure().svg().expect("a drawing");
        let svg = Figure { by_decades: true, ..figure() }.svg().expect("a drawing");
        for label in ["|x1|", "|x2|", "|u|", "bound 0.6"] {
            assert!(svg.contains(&format!(">\n{label}\n<")), "{label}");
            assert_eq!(
                plain.contains(&format!(">\n{label}\n<")),
                label.starts_with('b'),
                "{label}"
            );
        }
        // The decades of |x1| and |u|; there is no bound below 0.
        assert!(svg.contains(">\n0.01\n<") && !svg.contains("bound -0.6"));
        assert!(plain.contains("bound -0.6"));
        let zero = Trace {
            x: vec![vec![0.0; 51]; 2],
            u: vec![vec![0.0; 51]],
            ..figure().traces[0].clone()
        };
        let still = Figure { traces: vec![zero], by_decades: true, ..figure() };
        assert!(still.svg().expect("a drawing").contains("|x1|"));
    }

    #[test]
    fn objectives_are_drawn_between_their_bounds() {
        let plain = figure();
        let count = plain.traces[0].t.len();
        let size: Vec<_> = (0..count).map(|i| 0.5f64.powi(i32::try_from(i).unwrap_or(0))).collect();
        let mut last = vec![f64::NAN; count];
        last[count - 1] = 1e-9;
        let objective = |bounds: Vec<Vec<f64>>, by_decades| Bounded {
            title: "what is bounded".to_owned(),
            values: size.clone(),
            bounds,
            by_decades,
        };
        let red = |objectives: Vec<Bounded>| {
            let svg = Figure { objectives, ..plain.clone() }.svg().expect("a drawing");
            (svg.matches("stroke=\"#A02030\"").count(), svg)
        };
        let (without, _) = red(vec![objective(vec![vec![f64::NAN; count]; 2], true)]);
        let throughout: Vec<_> = size.iter().map(|size| 2.0 * size).collect();
        let (with, svg) = red(vec![objective(vec![throughout, last.clone()], true)]);
        assert!(svg.contains("what is bounded") && svg.contains("1e-10"), "decades are labelled");
        // One goes on all along, one is a short line at the end.
        let (at_end, _) = red(vec![objective(vec![last], true)]);
        assert!(at_end > without && with > at_end + 30, "{without} {at_end} {with}");
        assert!(!red(vec![objective(Vec::new(), false)]).1.contains("1e-10"));
    }

    #[test]
    fn svg_has_every_part_and_a_dark_page() {
        let svg = figure().svg().expect("a drawing");
        assert_eq!(svg, figure().svg().expect("the same drawing"));
        for part in [
            "two runs",
            "one",
            "x1",
            "x2",
            "x1 = xi1 in stretched time",
            "prefers-color-scheme: dark",
        ] {
            assert!(svg.contains(part), "{part}");
        }
        // The bound of u on both sides, and that of x1, in dashes.
        assert!(svg.matches("stroke=\"#A02030\"").count() > 100);
        let colours = svg.matches("stroke=\"#1B5FA8\"").count();
        assert!(colours >= 1 + 4 + 3, "legend, lines and deadlines: {colours}");
    }

    #[test]
    fn caption_names_the_drawn_panels() {
        let all = figure();
        assert_eq!(
            all.caption(),
            "States and control over time in s, and the first state in stretched time. \
             Thin lines are deadlines, dashed ones in red bounds."
        );
        let held = Figure {
            traces: all.traces[1..].to_vec(),
            limits: Vec::new(),
            x_max: Vec::new(),
            ..Figure::default()
        };
        assert!(!held.svg().expect("a drawing").contains("stretched"));
        assert_eq!(held.caption(), "States and control over time in s. Thin lines are deadlines.");
    }

    #[test]
    fn png_matches_the_svg_drawing() {
        let bytes = figure().png().expect("a drawing");
        let decoder = png::Decoder::new(std::io::Cursor::new(&bytes));
        let mut reader = decoder.read_info().expect("a head");
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        let frame = reader.next_frame(&mut pixels).expect("pixels");
        assert_eq!((frame.width, frame.height), figure().size(Pen::PIXELS).expect("a size"));
        let of = |colour: [u8; 3]| pixels.chunks(3).filter(|pixel| **pixel == colour).count();
        assert!(of([255, 255, 255]) > 100_000, "a white page");
        assert!(of([0x1b, 0x5f, 0xa8]) > 1000 && of([0xa0, 0x20, 0x30]) > 300, "lines and bounds");
    }

    #[test]
    fn empty_and_constant_runs_are_drawn() {
        let still = Trace {
            x: vec![vec![0.0; 2]],
            u: vec![vec![0.0; 2]],
            t: vec![0.0, 1.0],
            stretched: vec![0.0, f64::INFINITY],
            deadline: 1.0,
            ..Trace::default()
        };
        assert!(Figure { traces: vec![still], ..Figure::default() }.png().is_ok());
        assert!(Figure::default().svg().is_ok());
    }
}
