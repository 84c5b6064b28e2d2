//! Common parts of every chart: its margins, its letters, its mesh, its lines.

use plotters::chart::{ChartBuilder, ChartContext, MeshStyle};
use plotters::coord::Shift;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingArea;
use plotters::prelude::DrawingBackend;
use plotters::series::{DashedLineSeries, LineSeries};
use plotters::style::ShapeStyle;

use super::style::{self, Pen, SMALL, TITLE};

type Chart<'a, B> = ChartContext<'a, B, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// A chart with its title, before it has axes.
pub(super) fn around<'a, 'b, B: DrawingBackend>(
    area: &'a DrawingArea<B, Shift>,
    title: &str,
    pen: Pen,
) -> ChartBuilder<'a, 'b, B> {
    let mut chart = ChartBuilder::on(area);
    chart
        .margin(pen.px(10))
        .margin_right(pen.px(22))
        .x_label_area_size(pen.px(54))
        .y_label_area_size(pen.px(80))
        .caption(title, pen.text(TITLE));
    chart
}

/// The mesh of a chart, before its axes are named.
pub(super) fn mesh<'a, 'b, B: DrawingBackend>(
    chart: &'b mut Chart<'a, B>,
    pen: Pen,
) -> MeshStyle<'a, 'b, RangedCoordf64, RangedCoordf64, B> {
    let mut mesh = chart.configure_mesh();
    mesh.light_line_style(style::PAGE)
        .bold_line_style(pen.thin(style::GRID))
        .axis_style(pen.thin(style::FRAME))
        .set_all_tick_mark_size(pen.px(5))
        .label_style(pen.text(SMALL))
        .x_labels(7)
        .y_labels(6);
    mesh
}

/// A line of dashes, or a whole one where the gap is 0.
pub(super) fn dashed<B: DrawingBackend>(
    chart: &mut Chart<'_, B>,
    points: Vec<(f64, f64)>,
    (dash, gap): (u32, u32),
    style: ShapeStyle,
) -> Result<(), String> {
    let drawn = match gap {
        0 => chart.draw_series(LineSeries::new(points, style)).map(|_| ()),
        _ => chart.draw_series(DashedLineSeries::new(points, dash, gap, style)).map(|_| ()),
    };
    drawn.map_err(|error| error.to_string())
}
