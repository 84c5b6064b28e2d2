//! Between what many runs keep a quantity, and one run of them.

use plotters::element::Polygon;
use plotters::series::LineSeries;

use super::style::Pen;
use super::{chart, range, single};

/// A quantity of many runs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Band {
    /// The quantity.
    pub title: String,
    /// Label of the horizontal axis, with its unit.
    pub across: String,
    /// Points of the horizontal axis at which the band is known.
    pub at: Vec<f64>,
    /// Least and greatest value at each of these.
    pub within: Vec<(f64, f64)>,
    /// The points of one run.
    pub run: Vec<(f64, f64)>,
}

impl Band {
    /// As the text of an SVG file.
    ///
    /// # Errors
    /// A drawing that cannot be made.
    pub fn svg(&self) -> Result<String, String> {
        single::svg(|page, pen| self.draw(page, pen))
    }

    fn draw(&self, page: &single::Page<'_>, pen: Pen) -> Result<(), String> {
        let told = |error: &dyn std::fmt::Display| error.to_string();
        let known: Vec<_> = self.at.iter().zip(&self.within).map(|(x, y)| (*x, *y)).collect();
        let known: Vec<_> =
            known.into_iter().filter(|(_, y)| y.0.is_finite() && y.1.is_finite()).collect();
        let lows = known.iter().map(|(x, y)| (*x, y.0));
        let highs = known.iter().map(|(x, y)| (*x, y.1));
        let run: Vec<_> = self.run.iter().copied().filter(|(_, y)| y.is_finite()).collect();
        let all = || lows.clone().chain(highs.clone()).chain(run.iter().copied());
        let end = all().map(|(x, _)| x).fold(f64::MIN_POSITIVE, f64::max);
        let up = range::of(all().map(|(_, y)| y));
        let mut chart = chart::around(page, &self.title, pen)
            .build_cartesian_2d(0.0..end, up.0..up.1)
            .map_err(|e| told(&e))?;
        chart::mesh(&mut chart, pen)
            .x_label_formatter(&|x| range::mark(*x, (0.0, end)))
            .y_label_formatter(&|y| range::mark(*y, up))
            .x_desc(&self.across)
            .draw()
            .map_err(|e| told(&e))?;
        let outline: Vec<_> = lows.clone().chain(highs.clone().rev()).collect();
        chart.draw_series([Polygon::new(outline, pen.band())]).map_err(|e| told(&e))?;
        for edge in [lows.collect::<Vec<_>>(), highs.collect()] {
            chart.draw_series(LineSeries::new(edge, pen.deadline(0))).map_err(|e| told(&e))?;
        }
        chart.draw_series(LineSeries::new(run, pen.line(1))).map(|_| ()).map_err(|e| told(&e))
    }
}
