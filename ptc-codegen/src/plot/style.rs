//! Colours, dashes and letters.

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::PathElement;
use plotters::prelude::DrawingBackend;
use plotters::style::{Color, FontStyle, IntoFont, RGBColor, ShapeStyle, TextStyle, register_font};

use super::{Figure, HEAD, LEGEND, PANEL};

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
pub(super) const LETTERS: &[u8] = include_bytes!("font/ptc_sans.ttf");

/// The font family of the figures, which every reader of SVG has in some shape.
pub(super) const FAMILY: &str = "sans-serif";

/// Gives plotters the letters of the family `sans-serif`, without which it draws no text.
///
/// # Errors
/// The letters cannot be read.
pub fn register_letters() -> Result<(), String> {
    register_font(FAMILY, FontStyle::Normal, LETTERS)
        .map_err(|_| "the letters cannot be read".to_owned())
}

/// Resolution of a drawing: its units per pixel. Points are drawn at whole units, so that lines of one unit a pixel
/// would be jagged.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen(u32);

impl Pen {
    /// For drawings whose coordinates may have fractions of a pixel.
    pub(super) const FINE: Self = Self(10);
    /// For pixels, each of which becomes the mean of 3 by 3.
    pub(super) const PIXELS: Self = Self(3);

    /// A length in pixels.
    pub(super) fn px(self, pixels: u32) -> u32 {
        self.0 * pixels
    }

    /// A place in pixels.
    pub(super) fn at(self, pixels: u32) -> i32 {
        i32::try_from(self.px(pixels)).unwrap_or(i32::MAX)
    }

    /// Line of a bound.
    pub(super) fn bound(self) -> ShapeStyle {
        BOUND.stroke_width(self.px(1))
    }

    /// Edge of a set within bounds.
    pub(super) fn edge(self) -> ShapeStyle {
        BOUND.stroke_width(self.px(2))
    }

    /// Line of the run with this index.
    pub(super) fn line(self, index: usize) -> ShapeStyle {
        TRACES[index % TRACES.len()].stroke_width(self.px(2))
    }

    /// Thin line of its deadline.
    pub(super) fn deadline(self, index: usize) -> ShapeStyle {
        TRACES[index % TRACES.len()].stroke_width(self.px(1))
    }

    /// Bar of a histogram.
    pub(super) fn bar(self) -> ShapeStyle {
        TRACES[0].filled()
    }

    /// Between what runs are.
    pub(super) fn band(self) -> ShapeStyle {
        GRID.filled()
    }

    /// Thin line of axes and mesh.
    pub(super) fn thin(self, colour: RGBColor) -> ShapeStyle {
        colour.stroke_width(self.px(1))
    }

    /// Dash and gap of the run with this index.
    pub(super) fn dash(self, index: usize) -> (u32, u32) {
        self.dashes(DASHES[index % DASHES.len()])
    }

    /// Dash and gap of bounds.
    pub(super) fn dash_of_bound(self) -> (u32, u32) {
        self.dashes((4, 3))
    }

    fn dashes(self, (dash, gap): (u32, u32)) -> (u32, u32) {
        (self.px(dash), self.px(gap))
    }

    /// Text of a size in pixels.
    pub(super) fn text(self, size: u32) -> TextStyle<'static> {
        (FAMILY, self.px(size)).into_font().color(&TEXT)
    }

    /// Text beside a bound.
    pub(super) fn bound_text(self) -> TextStyle<'static> {
        (FAMILY, self.px(SMALL)).into_font().color(&BOUND)
    }
}

/// Letters of axes and notes, 12 pt, and of titles; a size is 1.24 em.
pub(super) const SMALL: u32 = 20;
pub(super) const TITLE: u32 = 22;

/// A straight line from `from` to `to` on one row or column, dashed.
fn dashes(from: i32, to: i32, (dash, gap): (u32, u32)) -> Vec<(i32, i32)> {
    if gap == 0 {
        return vec![(from, to)];
    }
    let period = usize::try_from(dash + gap).unwrap_or(1);
    let dash = i32::try_from(dash).unwrap_or(1);
    (from..to).step_by(period).map(|at| (at, (at + dash).min(to))).collect()
}

/// Returns the places of the entries of the legend, as row and distance from the left, and the number of rows.
fn legend(figure: &Figure, pen: Pen) -> Result<(Vec<(u32, i32)>, u32), String> {
    let (width, mut row, mut left) = (pen.at(2 * PANEL.0), 0, pen.at(16));
    let mut places = Vec::with_capacity(figure.traces.len());
    for trace in &figure.traces {
        let entry = pen.at(78) + width_of(&trace.label, pen)?;
        if left + entry > width && left > pen.at(16) {
            (row, left) = (row + 1, pen.at(16));
        }
        places.push((row, left));
        left += entry;
    }
    Ok((places, row + 1))
}

/// The height of title and legend in pixels.
pub(super) fn head_height(figure: &Figure, pen: Pen) -> Result<u32, String> {
    Ok(HEAD + LEGEND * legend(figure, pen)?.1)
}

/// The title and the legend.
pub(super) fn head<B: DrawingBackend>(
    figure: &Figure,
    area: &DrawingArea<B, Shift>,
    pen: Pen,
) -> Result<(), String> {
    let told = |error: &dyn std::fmt::Display| error.to_string();
    let title = (pen.at(16), pen.at(8));
    area.draw_text(&figure.title, &pen.text(TITLE), title).map_err(|e| told(&e))?;
    let (places, _) = legend(figure, pen)?;
    for (index, (trace, (row, left))) in figure.traces.iter().zip(places).enumerate() {
        sample(area, (left, HEAD + row * LEGEND), (index, &trace.label), pen)?;
    }
    Ok(())
}

/// An entry of a legend: the line of an index, and its label. `left` is in units, `top` in pixels.
pub(super) fn sample<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    (left, top): (i32, u32),
    (index, label): (usize, &str),
    pen: Pen,
) -> Result<(), String> {
    let told = |error: &dyn std::fmt::Display| error.to_string();
    let middle = pen.at(top + 9);
    for (from, to) in dashes(left, left + pen.at(40), pen.dash(index)) {
        let line = PathElement::new(vec![(from, middle), (to, middle)], pen.line(index));
        area.draw(&line).map_err(|e| told(&e))?;
    }
    let place = (left + pen.at(48), pen.at(top));
    area.draw_text(label, &pen.text(SMALL), place).map_err(|e| told(&e))
}

/// The width of a small text in units.
pub(super) fn width_of(text: &str, pen: Pen) -> Result<i32, String> {
    let size = (FAMILY, pen.px(SMALL)).into_font().box_size(text);
    let (width, _) = size.map_err(|error| error.to_string())?;
    Ok(i32::try_from(width).unwrap_or(0))
}

/// A drawing of [`Pen::FINE`], of this size in pixels, with other colours where the reader's page is dark.
pub(super) fn finished(svg: &str, (width, height): (u32, u32)) -> String {
    let mut rules = String::new();
    for (RGBColor(r, g, b), dark) in DARK {
        let light = format!("#{r:02X}{g:02X}{b:02X}");
        rules.push_str(&format!(
            "[fill=\"{light}\"]{{fill:{dark}}}[stroke=\"{light}\"]{{stroke:{dark}}}\n"
        ));
    }
    let pen = Pen::FINE;
    let head = format!(
        "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {} {}\" xmlns=\"http://www.w3.org/2000/svg\">\n\
         <style>\n@media (prefers-color-scheme: dark) {{\n{rules}}}\n</style>\n",
        pen.px(width),
        pen.px(height)
    );
    let drawn = svg.split_once('>').map_or(svg, |(_, drawn)| drawn);
    head + drawn.trim_start_matches('\n')
}
