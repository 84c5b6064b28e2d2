//! Colours, dashes and letters.

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::PathElement;
use plotters::prelude::DrawingBackend;
use plotters::style::{Color, FontStyle, IntoFont, RGBColor, ShapeStyle, TextStyle, register_font};

use super::Figure;

pub(super) const PAGE: RGBColor = RGBColor(0xff, 0xff, 0xff);
pub(super) const TEXT: RGBColor = RGBColor(0x22, 0x22, 0x22);
pub(super) const FRAME: RGBColor = RGBColor(0x77, 0x77, 0x77);
pub(super) const GRID: RGBColor = RGBColor(0xdd, 0xdd, 0xdd);
const BOUND: RGBColor = RGBColor(0xa0, 0x20, 0x30);
const TRACES: [RGBColor; 5] = [
    RGBColor(0x1b, 0x5f, 0xa8),
    RGBColor(0xc2, 0x50, 0x0a),
    RGBColor(0x1d, 0x7a, 0x3a),
    RGBColor(0x7a, 0x3f, 0x9d),
    RGBColor(0x6b, 0x5b, 0x00),
];

/// Each colour of the white page with the one of a dark page.
const DARK: [(RGBColor, &str); 10] = [
    (PAGE, "#161b22"),
    (TEXT, "#e6edf3"),
    (FRAME, "#8b949e"),
    (GRID, "#30363d"),
    (BOUND, "#ff7b86"),
    (TRACES[0], "#6cb6ff"),
    (TRACES[1], "#f0883e"),
    (TRACES[2], "#57c97a"),
    (TRACES[3], "#c9a0ec"),
    (TRACES[4], "#d6c25a"),
];

/// Dash and gap of the runs in pixels; a gap of 0 is a whole line.
const DASHES: [(u32, u32); 5] = [(1, 0), (9, 4), (3, 3), (14, 4), (6, 6)];

/// DejaVu Sans with the letters of figures alone: the same widths on any machine.
const LETTERS: &[u8] = include_bytes!("font/ptc_sans.ttf");

/// The font family of the figures, which every reader of SVG has in some shape.
pub(super) const FAMILY: &str = "sans-serif";

pub(super) fn register_letters() -> Result<(), String> {
    register_font(FAMILY, FontStyle::Normal, LETTERS)
        .map_err(|_| "the letters cannot be read".to_owned())
}

/// Line of a bound.
pub(super) fn bound() -> ShapeStyle {
    BOUND.stroke_width(1)
}

/// Line of the run with this index.
pub(super) fn line(index: usize) -> ShapeStyle {
    TRACES[index % TRACES.len()].stroke_width(2)
}

/// Thin line of its deadline.
pub(super) fn deadline(index: usize) -> ShapeStyle {
    TRACES[index % TRACES.len()].stroke_width(1)
}

/// Dash and gap of the run with this index.
pub(super) fn dash(index: usize) -> (u32, u32) {
    DASHES[index % DASHES.len()]
}

/// Text of a size in pixels.
pub(super) fn text(size: u32) -> TextStyle<'static> {
    (FAMILY, size).into_font().color(&TEXT)
}

/// A straight line from `from` to `to` on one row or column, dashed.
pub(super) fn dashes(from: i32, to: i32, (dash, gap): (u32, u32)) -> Vec<(i32, i32)> {
    if gap == 0 {
        return vec![(from, to)];
    }
    let period = usize::try_from(dash + gap).unwrap_or(1);
    let dash = i32::try_from(dash).unwrap_or(1);
    (from..to).step_by(period).map(|at| (at, (at + dash).min(to))).collect()
}

/// The title and the legend.
pub(super) fn head<B: DrawingBackend>(
    figure: &Figure,
    area: &DrawingArea<B, Shift>,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    area.draw_text(&figure.title, &text(20), (16, 8))?;
    let mut left = 16;
    for (index, trace) in figure.traces.iter().enumerate() {
        for (from, to) in dashes(left, left + 40, dash(index)) {
            area.draw(&PathElement::new(vec![(from, 42), (to, 42)], line(index)))?;
        }
        area.draw_text(&trace.label, &text(16), (left + 48, 34))?;
        let width = area.estimate_text_size(&trace.label, &text(16))?.0;
        left += 78 + i32::try_from(width).unwrap_or(0);
    }
    Ok(())
}

/// The SVG with other colours where the reader's page is dark.
pub(super) fn with_dark_page(svg: &str) -> String {
    let mut rules = String::new();
    for (RGBColor(r, g, b), dark) in DARK {
        let light = format!("#{r:02X}{g:02X}{b:02X}");
        rules.push_str(&format!(
            "[fill=\"{light}\"]{{fill:{dark}}}[stroke=\"{light}\"]{{stroke:{dark}}}\n"
        ));
    }
    let style = format!("<style>\n@media (prefers-color-scheme: dark) {{\n{rules}}}\n</style>\n");
    match svg.find('>') {
        Some(end) => {
            format!("{}\n{style}{}", &svg[..=end], svg[end + 1..].trim_start_matches('\n'))
        }
        None => svg.to_owned(),
    }
}
