//! Backend of plotters that writes the operators of a page.

use std::convert::Infallible;

use ab_glyph::{Font, FontRef};
use pdf_writer::{Content, Str};
use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind,
};

use super::{FONT, POINTS};
use crate::plot::style::Pen;

/// Sizes of letters are 1.24 em, as in plotters' SVG.
const SIZE: f32 = 1.24;

/// A page under way.
pub(crate) struct Backend<'a> {
    content: &'a mut Content,
    font: &'a FontRef<'static>,
    size: (u32, u32),
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl<'a> Backend<'a> {
    pub(super) fn new(
        content: &'a mut Content,
        font: &'a FontRef<'static>,
        size: (u32, u32),
    ) -> Self {
        Self { content, font, size }
    }

    /// A length in points.
    fn length(units: f32) -> f32 {
        units * POINTS / Pen::FINE.px(1) as f32
    }

    /// A place in points, from the lower left corner.
    fn place(&self, (x, y): BackendCoord) -> (f32, f32) {
        (Self::length(x as f32), Self::length(self.size.1 as f32 - y as f32))
    }

    /// Draws a path in a colour.
    fn path(&mut self, points: impl IntoIterator<Item = BackendCoord>) {
        for (index, point) in points.into_iter().enumerate() {
            let (x, y) = self.place(point);
            let _ =
                if index == 0 { self.content.move_to(x, y) } else { self.content.line_to(x, y) };
        }
    }

    fn fill_colour(&mut self, colour: BackendColor) {
        let [r, g, b] = parts(colour);
        self.content.set_fill_rgb(r, g, b);
    }

    fn stroke_style(&mut self, style: &impl BackendStyle) {
        let [r, g, b] = parts(style.color());
        self.content.set_stroke_rgb(r, g, b);
        self.content.set_line_width(Self::length(style.stroke_width() as f32));
    }
}

fn parts(BackendColor { rgb: (r, g, b), .. }: BackendColor) -> [f32; 3] {
    [r, g, b].map(|part| f32::from(part) / 255.0)
}

/// Returns true if something of this colour is seen; figures have no other transparency.
fn seen(colour: BackendColor) -> bool {
    colour.alpha > 0.0
}

impl DrawingBackend for Backend<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, colour: BackendColor) -> Drawn {
        self.draw_rect((x, y), (x + 1, y + 1), &colour, true)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        match fill {
            true => self.fill_polygon(corners, style),
            false => self.draw_path(corners.into_iter().chain([(left, top)]), style),
        }
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        if seen(style.color()) {
            self.stroke_style(style);
            self.path(path);
            self.content.stroke();
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Drawn {
        if seen(style.color()) {
            self.fill_colour(style.color());
            self.path(corners);
            self.content.close_path().fill_nonzero();
        }
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Drawn {
        if !seen(style.color()) {
            return Ok(());
        }
        let size = Self::length(style.size() as f32 / SIZE);
        let em = self.font.units_per_em().unwrap_or(1.0);
        let glyphs: Vec<_> = text.chars().map(|letter| self.font.glyph_id(letter)).collect();
        let advance: f32 = glyphs.iter().map(|id| self.font.h_advance_unscaled(*id)).sum();
        let left = match style.anchor().h_pos {
            HPos::Left => 0.0,
            HPos::Center => -0.5,
            HPos::Right => -1.0,
        };
        // The base line below the place, in em.
        let below = match style.anchor().v_pos {
            VPos::Top => 0.76,
            VPos::Center => 0.27,
            VPos::Bottom => -0.27,
        };
        let (x, y) = self.place(at);
        self.fill_colour(style.color());
        let codes: Vec<_> = glyphs.iter().flat_map(|id| id.0.to_be_bytes()).collect();
        self.content
            .begin_text()
            .set_font(FONT, size)
            .next_line(x + left * size * advance / em, y - below * size)
            .show(Str(&codes))
            .end_text();
        Ok(())
    }
}
