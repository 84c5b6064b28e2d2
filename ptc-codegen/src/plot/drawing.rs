//! A drawing as a file: SVG, PNG or PDF.

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::prelude::{DrawingBackend, IntoDrawingArea, SVGBackend};

use super::style::{self, Pen};
use super::{pdf, pixels};

/// Content of a page.
pub(super) trait Drawing {
    /// Title of the file.
    fn title(&self) -> &str;

    /// Width and height in pixels.
    fn size(&self, pen: Pen) -> Result<(u32, u32), String>;

    /// Draws it on a white page of this size.
    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>, pen: Pen)
    -> Result<(), String>;
}

/// A picture that can be written to a file.
pub trait Picture {
    /// As the text of an SVG file.
    ///
    /// # Errors
    /// A drawing that cannot be made, such as one of values that are no numbers.
    fn svg(&self) -> Result<String, String>;

    /// As the bytes of a PNG file.
    ///
    /// # Errors
    /// As [`Self::svg`].
    fn png(&self) -> Result<Vec<u8>, String>;

    /// As the bytes of a PDF file of one page.
    ///
    /// # Errors
    /// As [`Self::svg`].
    fn pdf(&self) -> Result<Vec<u8>, String>;
}

impl<T: Drawing> Picture for T {
    fn svg(&self) -> Result<String, String> {
        let mut text = String::new();
        let (width, height) = sized(self, Pen::FINE)?;
        let size = (Pen::FINE.px(width), Pen::FINE.px(height));
        on_page(self, SVGBackend::with_string(&mut text, size).into_drawing_area(), Pen::FINE)?;
        Ok(style::finished(&text, (width, height)))
    }

    fn png(&self) -> Result<Vec<u8>, String> {
        pixels::png(sized(self, Pen::PIXELS)?, |page| on_page(self, page, Pen::PIXELS))
    }

    fn pdf(&self) -> Result<Vec<u8>, String> {
        let mut page = pdf::Page::new(sized(self, Pen::FINE)?, self.title())?;
        on_page(self, page.backend().into_drawing_area(), Pen::FINE)?;
        Ok(page.finish())
    }
}

fn sized(drawing: &impl Drawing, pen: Pen) -> Result<(u32, u32), String> {
    style::register_letters()?;
    drawing.size(pen)
}

fn on_page<B: DrawingBackend>(
    drawing: &impl Drawing,
    page: DrawingArea<B, Shift>,
    pen: Pen,
) -> Result<(), String> {
    let told = |error: &dyn std::fmt::Display| error.to_string();
    page.fill(&style::PAGE).map_err(|e| told(&e))?;
    drawing.draw(&page, pen)?;
    page.present().map_err(|e| told(&e))
}
