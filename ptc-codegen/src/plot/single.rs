//! A drawing of one chart.

use plotters::backend::SVGBackend;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};

use super::PANEL;
use super::style::{self, Pen};

/// The page on which it is drawn.
pub(super) type Page<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// As the text of an SVG file.
pub(super) fn svg(
    draw: impl FnOnce(&Page<'_>, Pen) -> Result<(), String>,
) -> Result<String, String> {
    style::register_letters()?;
    let mut text = String::new();
    let pen = Pen::FINE;
    let size = (pen.px(PANEL.0), pen.px(PANEL.1));
    let page = SVGBackend::with_string(&mut text, size).into_drawing_area();
    page.fill(&style::PAGE).map_err(|error| error.to_string())?;
    draw(&page, pen)?;
    page.present().map_err(|error| error.to_string())?;
    drop(page);
    Ok(style::finished(&text, PANEL))
}
