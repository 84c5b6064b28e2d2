//! Counts by size, on a logarithmic axis: a single one is seen beside thousands.

use plotters::element::{PathElement, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::style::Pen;
use super::{chart, range, single};

/// Counts by size.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Histogram {
    /// Title: the counted items.
    pub title: String,
    /// Label of the horizontal axis, with its unit.
    pub across: String,
    /// Sizes in their order, each with how many have it.
    pub sizes: Vec<(f64, u64)>,
    /// Place of the bound.
    pub bound: f64,
}

/// Bars from the least to the greatest size.
const BARS: u8 = 40;

/// Sizes are shown by decades where all are below this part of the bound.
const SMALL_PART: f64 = 0.1;

/// From, to, and a count.
type Bar = (f64, f64, u64);

/// The foot of the bars, a part of a count of 1.
const FOOT: f64 = -0.3;

impl Histogram {
    /// As the text of an SVG file.
    ///
    /// # Errors
    /// A drawing that cannot be made.
    pub fn svg(&self) -> Result<String, String> {
        single::svg(|page, pen| self.draw(page, pen))
    }

    fn draw(&self, page: &single::Page<'_>, pen: Pen) -> Result<(), String> {
        let told = |error: &dyn std::fmt::Display| error.to_string();
        let (bars, bound) = self.bars();
        let edges = bars.iter().flat_map(|(from, to, _)| [*from, *to]).chain([bound]);
        let (low, high) = edges.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), edge| {
            (low.min(edge), high.max(edge))
        });
        let margin = (0.04 * (high - low)).max(1e-9 * high.abs()).max(f64::MIN_POSITIVE);
        let across = (low - margin, high + margin);
        #[allow(clippy::cast_precision_loss)]
        let power = |count: u64| (count as f64).log10();
        let most = bars.iter().map(|(.., count)| power(*count)).fold(0.0, f64::max);
        let up = (FOOT, (most + 0.1).ceil());
        let label = |y: &f64| match (y - y.round()).abs() < 1e-6 {
            true => range::power_of_ten(*y),
            false => String::new(),
        };
        let size = |x: &f64| if self.by_decades() { label(x) } else { range::label(*x) };
        let mut chart = chart::around(page, &self.title, pen)
            .build_cartesian_2d(across.0..across.1, up.0..up.1)
            .map_err(|e| told(&e))?;
        chart::mesh(&mut chart, pen)
            .x_labels(5)
            .x_label_formatter(&size)
            .y_label_formatter(&label)
            .x_desc(&self.across)
            .draw()
            .map_err(|e| told(&e))?;
        let bars = bars.iter().filter(|(.., count)| *count > 0);
        let bars = bars.map(|(from, to, count)| {
            Rectangle::new([(*from, FOOT), (*to, power(*count))], pen.bar())
        });
        chart.draw_series(bars).map_err(|e| told(&e))?;
        let line = PathElement::new(vec![(bound, up.0), (bound, up.1)], pen.bound());
        chart.draw_series([line]).map_err(|e| told(&e))?;
        let side = if bound > 0.5 * (low + high) { HPos::Right } else { HPos::Left };
        let text = pen.bound_text().pos(Pos::new(side, VPos::Top));
        let label = Text::new(" bound ", (bound, up.1), text);
        chart.draw_series([label]).map(|_| ()).map_err(|e| told(&e))
    }

    /// Returns true if the axis is logarithmic.
    fn by_decades(&self) -> bool {
        let small = |(size, _): &(f64, u64)| (0.0..SMALL_PART * self.bound).contains(size);
        self.sizes.iter().all(small)
    }

    /// The bars and the bound, by the powers of ten where the axis is logarithmic.
    fn bars(&self) -> (Vec<Bar>, f64) {
        let shown = |size: f64| if self.by_decades() { size.log10() } else { size };
        let sizes = self.sizes.iter().map(|(size, count)| (shown(*size), *count));
        let sizes: Vec<_> = sizes.filter(|(size, _)| size.is_finite()).collect();
        let (Some((low, _)), Some((high, _))) = (sizes.first(), sizes.last()) else {
            return (Vec::new(), shown(self.bound));
        };
        // Sizes that are all alike have a bar of some width.
        let least = 1e-3 * low.abs().max(shown(self.bound).abs()).max(f64::MIN_POSITIVE);
        let width = ((high - low) / f64::from(BARS)).max(least);
        let edge = |bar: u8| low + width * f64::from(bar);
        let mut bars: Vec<_> = (0..BARS).map(|bar| (edge(bar), edge(bar + 1), 0)).collect();
        for (size, count) in &sizes {
            let place = bars.iter().rposition(|(from, ..)| from <= size).unwrap_or(0);
            bars[place].2 += count;
        }
        (bars, shown(self.bound))
    }
}
