//! The plot: instructions per step over the order, and ours against the best of the peers.

use std::fmt::Display;
use std::path::Path;

use plotters::prelude::*;

use crate::case::VARIANTS;
use crate::counts::Count;
use crate::failure::{Failure, Result};
use crate::peers::{Entry, OURS};

/// Okabe and Ito's colours, told apart by most eyes and in grey.
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 0, 0),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 114, 178),
    RGBColor(0, 158, 115),
    RGBColor(213, 94, 0),
    RGBColor(204, 121, 167),
    RGBColor(120, 120, 120),
];

fn failed(error: impl Display) -> Failure {
    Failure::new(format!("the plot: {error}"))
}

/// Colours of the plot with those that replace them on a dark page.
const DARK: [(&str, &str); 6] = [
    ("#FFFFFF", "#16181D"),
    ("#000000", "#E6E6E6"),
    ("#F0F0F0", "#262A31"),
    ("#C8C8C8", "#50555E"),
    ("#0072B2", "#8C8CFF"),
    ("#787878", "#A0A0A0"),
];

/// Writes the plot.
pub(super) fn plot(path: &Path, counts: &[Count], peers: &[Entry]) -> Result<()> {
    let pairs = pairs(peers);
    let width = if pairs.is_empty() { 640 } else { 1200 };
    ptc_codegen::plot::register_letters().map_err(failed)?;
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (width, 460)).into_drawing_area();
        area.fill(&WHITE).map_err(failed)?;
        if pairs.is_empty() {
            lines(&area, counts)?;
        } else {
            let (left, right) = area.split_horizontally(640);
            lines(&left, counts)?;
            bars(&right, &pairs)?;
        }
        area.present().map_err(failed)?;
    }
    Ok(std::fs::write(path, darkened(&svg))?)
}

/// The picture with colours that follow those of the reader's page.
fn darkened(svg: &str) -> String {
    let rule = |(light, dark): &(&str, &str)| {
        format!("[fill=\"{light}\"]{{fill:{dark}}}[stroke=\"{light}\"]{{stroke:{dark}}}\n")
    };
    let rules: String = DARK.iter().map(rule).collect();
    let style = format!(">\n<style>\n@media (prefers-color-scheme: dark) {{\n{rules}}}\n</style>");
    svg.replacen('>', &style, 1)
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

fn lines(area: &Area<'_>, counts: &[Count]) -> Result<()> {
    let mut chart = ChartBuilder::on(area)
        .caption("Instructions per step, C, f64, guard none", ("sans-serif", 18))
        .margin(12)
        .x_label_area_size(40)
        .y_label_area_size(60)
        .build_cartesian_2d(1.0..12.0, (10.0..12000.0).log_scale())
        .map_err(failed)?;
    chart
        .configure_mesh()
        .x_desc("order n")
        .y_desc("instructions (log)")
        .x_labels(12)
        .x_label_formatter(&|n| format!("{n:.0}"))
        .y_label_formatter(&|count| format!("{count:.0}"))
        .light_line_style(RGBColor(240, 240, 240))
        .draw()
        .map_err(failed)?;
    for (variant, colour) in VARIANTS.iter().zip(COLOURS) {
        let mut points: Vec<_> = counts
            .iter()
            .filter(|count| {
                let key = &count.key;
                (key.language.as_str(), key.precision.as_str(), key.guard.as_str())
                    == ("c", "f64", "none")
                    && key.variant == variant.name
            })
            .map(|count| (count.key.n as f64, count.step))
            .collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let style = colour.stroke_width(2);
        chart
            .draw_series(LineSeries::new(points, style).point_size(3))
            .map_err(failed)?
            .label(variant.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .background_style(WHITE.mix(0.85))
        .border_style(RGBColor(200, 200, 200))
        .draw()
        .map_err(failed)
}

/// Ours and the best peer, for each family and order that both have.
struct Pair {
    label: String,
    ours: f64,
    best: f64,
    name: String,
}

fn pairs(peers: &[Entry]) -> Vec<Pair> {
    let ours = peers.iter().filter(|entry| entry.name == OURS);
    let pair = |ours: &Entry| {
        let best = peers
            .iter()
            .filter(|peer| peer.name != OURS && peer.family == ours.family && peer.n == ours.n)
            .min_by(|a, b| a.step.total_cmp(&b.step))?;
        Some(Pair {
            label: format!("{} {}", ours.family, ours.n),
            ours: ours.step,
            best: best.step,
            name: best.name.clone(),
        })
    };
    ours.filter_map(pair).collect()
}

fn bars(area: &Area<'_>, pairs: &[Pair]) -> Result<()> {
    let all = || pairs.iter().flat_map(|pair| [pair.best, pair.ours]);
    let most = all().fold(0.0, f64::max);
    // Bars begin at a power of ten, with the names of the families left of it.
    let from = 10f64.powf(all().fold(f64::INFINITY, f64::min).log10().floor());
    let left = from / (most / from).powf(0.3);
    let mut chart = ChartBuilder::on(area)
        .caption(
            "Ours (blue, red where more) and the best of the others (orange)",
            ("sans-serif", 18),
        )
        .margin(12)
        .x_label_area_size(40)
        .y_label_area_size(12)
        .build_cartesian_2d(
            (left..most * (most / from).powf(0.4)).log_scale(),
            0.0..pairs.len() as f64,
        )
        .map_err(failed)?;
    chart
        .configure_mesh()
        .disable_y_mesh()
        .disable_y_axis()
        .y_labels(0)
        .x_desc("instructions per step, f64 (log)")
        .x_label_formatter(&|count| {
            if *count < from { String::new() } else { format!("{count:.0}") }
        })
        .light_line_style(RGBColor(240, 240, 240))
        .draw()
        .map_err(failed)?;
    for (index, pair) in pairs.iter().enumerate() {
        let row = (pairs.len() - 1 - index) as f64;
        let ours = COLOURS[if pair.ours > pair.best { 5 } else { 3 }];
        for (value, low, colour, text) in [
            (pair.ours, 0.52, ours, format!("{:.0}", pair.ours)),
            (pair.best, 0.12, COLOURS[1], format!("{:.0} {}", pair.best, pair.name)),
        ] {
            let corners = [(from, row + low), (value, row + low + 0.36)];
            let place = (value * 1.05, row + low + 0.32);
            chart.draw_series([Rectangle::new(corners, colour.filled())]).map_err(failed)?;
            chart.draw_series([Text::new(text, place, ("sans-serif", 12))]).map_err(failed)?;
        }
        let place = (left * 1.02, row + 0.62);
        chart
            .draw_series([Text::new(pair.label.clone(), place, ("sans-serif", 13))])
            .map_err(failed)?;
    }
    Ok(())
}
