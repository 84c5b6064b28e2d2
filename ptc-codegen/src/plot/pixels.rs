//! A drawing as pixels.

use plotters::backend::BitMapBackend;
use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::prelude::IntoDrawingArea;

use super::style::Pen;

/// Encodes what `draw` draws on 3 by 3 units a pixel, as the bytes of a PNG file of this size in pixels.
pub(super) fn png(
    (width, height): (u32, u32),
    draw: impl FnOnce(DrawingArea<BitMapBackend<'_>, Shift>) -> Result<(), String>,
) -> Result<Vec<u8>, String> {
    let (wide, high) = (Pen::PIXELS.px(width), Pen::PIXELS.px(height));
    let mut units = vec![0; 3 * wide as usize * high as usize];
    draw(BitMapBackend::with_buffer(&mut units, (wide, high)).into_drawing_area())?;
    let pixels = means(&units, (width as usize, height as usize));
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&pixels)?;
        writer.finish()
    });
    written.map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// The mean colour of the units of each pixel.
fn means(units: &[u8], (width, height): (usize, usize)) -> Vec<u8> {
    let side = Pen::PIXELS.px(1) as usize;
    let row = 3 * width * side;
    let mean = |y: usize, x: usize, colour: usize| {
        let lines = units[y * side * row..].chunks(row).take(side);
        let sum: usize = lines
            .flat_map(|line| line[3 * x * side + colour..].iter().step_by(3).take(side))
            .map(|value| usize::from(*value))
            .sum();
        u8::try_from((sum + side * side / 2) / (side * side)).unwrap_or(u8::MAX)
    };
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (y, x)));
    places
        .flat_map(|(y, x)| (0..3).map(move |colour| (y, x, colour)))
        .map(|(y, x, c)| mean(y, x, c))
        .collect()
}
