//! Level curves in the plane of two quantities, around a set that is marked.

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{PathElement, Polygon};
use plotters::prelude::DrawingBackend;

use super::chart::dashed;
use super::drawing::Drawing;
use super::style::{self, Pen, SMALL, TITLE};
use super::{HEAD, LEGEND, PANEL, chart, range};

/// A picture of level curves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contours {
    /// A line above all.
    pub title: String,
    /// Label of the horizontal axis, with its unit.
    pub across: String,
    /// Label of the vertical axis, with its unit.
    pub up: String,
    /// Meaning of the curves.
    pub meaning: String,
    /// The curves, from the inmost one, each with its label.
    pub curves: Vec<Contour>,
    /// The set that is marked, and its meaning.
    pub marked: Contour,
}

/// A closed curve.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contour {
    /// Its label.
    pub label: String,
    /// Its points.
    pub points: Vec<(f64, f64)>,
}

/// Height of the plane in pixels.
const HEIGHT: u32 = 560;

impl Contour {
    /// The points, closed.
    fn closed(&self) -> Vec<(f64, f64)> {
        self.points.iter().chain(self.points.first()).copied().collect()
    }
}

impl Contours {
    /// Describes the picture in words.
    pub fn caption(&self) -> String {
        let labels: Vec<_> = self.curves.iter().map(|curve| curve.label.as_str()).collect();
        let curves = format!("{} {}", self.meaning, labels.join(", "));
        format!("Grey, with a red edge: {}. Curves: {curves}.", self.marked.label)
    }

    fn all(&self) -> impl Iterator<Item = &Contour> {
        self.curves.iter().chain([&self.marked])
    }

    /// The title, the line of the set, and one with an entry for each curve.
    fn head<B: DrawingBackend>(
        &self,
        head: &DrawingArea<B, Shift>,
        pen: Pen,
    ) -> Result<(), String> {
        let told = |error: &dyn std::fmt::Display| error.to_string();
        let title = (pen.at(16), pen.at(8));
        head.draw_text(&self.title, &pen.text(TITLE), title).map_err(|e| told(&e))?;
        let line = [(pen.at(16), pen.at(HEAD + 9)), (pen.at(56), pen.at(HEAD + 9))];
        head.draw(&PathElement::new(line.to_vec(), pen.edge())).map_err(|e| told(&e))?;
        let place = (pen.at(64), pen.at(HEAD));
        head.draw_text(&self.marked.label, &pen.text(SMALL), place).map_err(|e| told(&e))?;
        let top = HEAD + LEGEND;
        let place = (pen.at(16), pen.at(top));
        head.draw_text(&self.meaning, &pen.text(SMALL), place).map_err(|e| told(&e))?;
        let mut left = pen.at(28) + style::width_of(&self.meaning, pen)?;
        for (index, curve) in self.curves.iter().enumerate() {
            style::sample(head, (left, top), (index, &curve.label), pen)?;
            left += pen.at(70) + style::width_of(&curve.label, pen)?;
        }
        Ok(())
    }
}

impl Drawing for Contours {
    fn title(&self) -> &str {
        &self.title
    }

    fn size(&self, _: Pen) -> Result<(u32, u32), String> {
        Ok((2 * PANEL.0, HEAD + 2 * LEGEND + HEIGHT))
    }

    fn draw<B: DrawingBackend>(
        &self,
        page: &DrawingArea<B, Shift>,
        pen: Pen,
    ) -> Result<(), String> {
        let told = |error: &dyn std::fmt::Display| error.to_string();
        let (head, body) = page.split_vertically(pen.px(HEAD + 2 * LEGEND));
        self.head(&head, pen)?;
        let points = || self.all().flat_map(|curve| &curve.points);
        let across = range::of(points().map(|(x, _)| *x));
        let up = range::of(points().map(|(_, y)| *y));
        let mut chart = chart::around(&body, &self.up, pen)
            .build_cartesian_2d(across.0..across.1, up.0..up.1)
            .map_err(|e| told(&e))?;
        chart::mesh(&mut chart, pen)
            .x_label_formatter(&|x| range::mark(*x, across))
            .y_label_formatter(&|y| range::mark(*y, up))
            .x_desc(&self.across)
            .draw()
            .map_err(|e| told(&e))?;
        let set = Polygon::new(self.marked.points.clone(), pen.band());
        chart.draw_series([set]).map_err(|e| told(&e))?;
        for axis in [[(across.0, 0.0), (across.1, 0.0)], [(0.0, up.0), (0.0, up.1)]] {
            let line = PathElement::new(axis.to_vec(), pen.thin(style::FRAME));
            chart.draw_series([line]).map_err(|e| told(&e))?;
        }
        for (index, curve) in self.curves.iter().enumerate() {
            dashed(&mut chart, curve.closed(), pen.dash(index), pen.line(index))?;
        }
        dashed(&mut chart, self.marked.closed(), (1, 0), pen.edge())?;
        Ok(())
    }
}
