//! One quantity over another, both on logarithmic axes.

use plotters::element::PathElement;
use plotters::series::LineSeries;

use super::chart::dashed;
use super::style::Pen;
use super::{chart, range, single};

/// A curve, and what its values should not exceed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// Title of the curve.
    pub title: String,
    /// Label of the horizontal axis, with its unit.
    pub across: String,
    /// The points, by the first number; those that are not > 0 are left out.
    pub points: Vec<(f64, f64)>,
    /// The place on the horizontal axis that is chosen.
    pub chosen: Option<f64>,
    /// Limit that a value should not exceed.
    pub limit: Option<f64>,
}

impl Curve {
    /// As the text of an SVG file.
    ///
    /// # Errors
    /// A drawing that cannot be made.
    pub fn svg(&self) -> Result<String, String> {
        single::svg(|page, pen| self.draw(page, pen))
    }

    fn draw(&self, page: &single::Page<'_>, pen: Pen) -> Result<(), String> {
        let told = |error: &dyn std::fmt::Display| error.to_string();
        // Drawn by the powers of ten.
        let points = self.points.iter().map(|(x, y)| (x.log10(), y.log10()));
        let points: Vec<_> = points.filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
        let limit = self.limit.map(f64::log10).filter(|limit| limit.is_finite());
        let across = range::decades(points.iter().map(|(x, _)| *x));
        let up = range::decades(points.iter().map(|(_, y)| *y).chain(limit));
        let label = |power: &f64| match (power - power.round()).abs() < 1e-6 {
            true => range::power_of_ten(*power),
            false => String::new(),
        };
        let mut chart = chart::around(page, &self.title, pen)
            .build_cartesian_2d(across.0..across.1, up.0..up.1)
            .map_err(|e| told(&e))?;
        chart::mesh(&mut chart, pen)
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .x_desc(&self.across)
            .draw()
            .map_err(|e| told(&e))?;
        if let Some(limit) = limit {
            let line = vec![(across.0, limit), (across.1, limit)];
            dashed(&mut chart, line, pen.dash_of_bound(), pen.bound())?;
        }
        if let Some(x) = self.chosen.map(f64::log10).filter(|x| (across.0..=across.1).contains(x)) {
            let line = PathElement::new(vec![(x, up.0), (x, up.1)], pen.deadline(0));
            chart.draw_series([line]).map_err(|e| told(&e))?;
        }
        chart.draw_series(LineSeries::new(points, pen.line(0))).map(|_| ()).map_err(|e| told(&e))
    }
}
