//! What eps makes of the loop, as two small charts with logarithmic axes.

use std::fmt::Write as _;

use super::number::digits;
use super::svg::Svg;

/// Size of a chart, and the room for its axes, in pixels.
const WIDTH: f64 = 420.0;
const HEIGHT: f64 = 240.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 20.0;
const BELOW: f64 = 44.0;
const ABOVE: f64 = 12.0;

/// A quantity over eps, both > 0.
pub(super) struct Chart<'a> {
    pub(super) title: &'a str,
    /// eps in s and the value, by eps.
    pub(super) points: Vec<(f64, f64)>,
    /// The eps of the design.
    pub(super) chosen: Option<f64>,
    /// What the value should not exceed.
    pub(super) limit: Option<f64>,
}

/// An axis of decades, from `low` to `high` as logarithms, over pixels.
struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    fn of(values: impl Iterator<Item = f64> + Clone, from: f64, to: f64) -> Self {
        let logs = values.map(f64::log10);
        let low = logs.clone().fold(f64::INFINITY, f64::min).floor();
        let high = logs.fold(f64::NEG_INFINITY, f64::max).ceil();
        Self { low, high: high.max(low + 1.0), from, to }
    }

    fn at(&self, value: f64) -> f64 {
        let share = (value.log10() - self.low) / (self.high - self.low);
        self.from + share * (self.to - self.from)
    }

    /// Decades to mark: six at most.
    fn marks(&self) -> impl Iterator<Item = f64> {
        let step = ((self.high - self.low) / 6.0).ceil().max(1.0);
        let (low, high) = (self.low, self.high);
        (0..).map(move |i| low + step * f64::from(i)).take_while(move |mark| *mark <= high)
    }
}

impl Chart<'_> {
    /// The drawing; `None` without two points.
    pub(super) fn svg(&self) -> Option<Svg> {
        let shown = |value: f64| value.is_finite() && value > 0.0;
        let points: Vec<_> = self
            .points
            .iter()
            .copied()
            .filter(|(eps, value)| shown(*eps) && shown(*value))
            .collect();
        if points.len() < 2 {
            return None;
        }
        let limit = self.limit.filter(|limit| shown(*limit));
        let x = Axis::of(points.iter().map(|(eps, _)| *eps), LEFT, WIDTH - RIGHT);
        let values = points.iter().map(|(_, value)| *value).chain(limit);
        let y = Axis::of(values, HEIGHT - BELOW, ABOVE);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" role=\"img\" aria-label=\"{} over eps\">",
            self.title
        );
        for mark in x.marks() {
            let (at, end) = (x.at(10_f64.powf(mark)), HEIGHT - BELOW);
            let _ = write!(
                text,
                "<path class=\"grid\" d=\"M{at:.1} {ABOVE}V{end}\"/><text x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">1e{mark}</text>",
                end + 16.0
            );
        }
        for mark in y.marks() {
            let at = y.at(10_f64.powf(mark));
            let _ = write!(
                text,
                "<path class=\"grid\" d=\"M{LEFT} {at:.1}H{:.1}\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">1e{mark}</text>",
                WIDTH - RIGHT,
                LEFT - 6.0,
                at + 4.0
            );
        }
        if let Some(limit) = limit {
            let _ = write!(
                text,
                "<path class=\"limit\" d=\"M{LEFT} {:.1}H{:.1}\"/>",
                y.at(limit),
                WIDTH - RIGHT
            );
        }
        if let Some(chosen) = self.chosen.filter(|eps| shown(*eps)) {
            let at = x.at(chosen).clamp(LEFT, WIDTH - RIGHT);
            let _ =
                write!(text, "<path class=\"mark\" d=\"M{at:.1} {ABOVE}V{}\"/>", HEIGHT - BELOW);
        }
        text.push_str("<polyline points=\"");
        for (eps, value) in &points {
            let _ = write!(text, "{:.2},{:.2} ", x.at(*eps), y.at(*value));
        }
        let middle = 0.5 * (LEFT + WIDTH);
        let least = points.iter().min_by(|a, b| a.1.total_cmp(&b.1));
        let least = least.map_or(String::new(), |(eps, value)| {
            format!(", least {} at {} s", digits(*value), digits(*eps))
        });
        let _ = write!(
            text,
            "\"/><text x=\"{middle}\" y=\"{:.1}\" text-anchor=\"middle\">{} over eps in s{least}</text></svg>",
            HEIGHT - 6.0,
            self.title
        );
        Some(Svg(text))
    }
}
