//! A drawing as a PDF file of one page, with the letters of the figures in it.

mod backend;

use ab_glyph::{Font, FontRef};
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, Str, TextStr};

use super::style::{LETTERS, Pen};
use backend::Backend;

/// Points of a pixel, of which there are 96 in an inch.
const POINTS: f32 = 0.75;

/// The name of the font in a page, and the one that readers show.
const FONT: Name<'static> = Name(b"F");
const FONT_NAME: Name<'static> = Name(b"PTCSans");

/// Thousandths of an em, in which a PDF gives widths.
const EM: f32 = 1000.0;

/// A page that is drawn on in units of [`Pen::FINE`].
pub(super) struct Page<'a> {
    content: Content,
    font: FontRef<'static>,
    /// In units.
    size: (u32, u32),
    title: &'a str,
}

impl<'a> Page<'a> {
    /// An empty page of a size in pixels.
    pub(super) fn new((width, height): (u32, u32), title: &'a str) -> Result<Self, String> {
        let font = FontRef::try_from_slice(LETTERS).map_err(|error| error.to_string())?;
        let size = (Pen::FINE.px(width), Pen::FINE.px(height));
        Ok(Self { content: Content::new(), font, size, title })
    }

    /// Returns the backend that draws on it.
    pub(super) fn backend(&mut self) -> Backend<'_> {
        Backend::new(&mut self.content, &self.font, self.size)
    }

    /// The bytes of the file. They hold no date.
    pub(super) fn finish(self) -> Vec<u8> {
        let [catalog, pages, page, content, info] = [1, 2, 3, 4, 5].map(Ref::new);
        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(pages);
        pdf.document_info(info).title(TextStr(self.title));
        pdf.pages(pages).kids([page]).count(1);
        let point = |units: u32| units as f32 * POINTS / Pen::FINE.px(1) as f32;
        let mut written = pdf.page(page);
        written.media_box(Rect::new(0.0, 0.0, point(self.size.0), point(self.size.1)));
        written.parent(pages).contents(content);
        written.resources().fonts().pair(FONT, Ref::new(6));
        written.finish();
        pdf.stream(content, &self.content.finish());
        embed(&mut pdf, &self.font);
        pdf.finish()
    }
}

/// Writes the font as object 6 and those behind it.
fn embed(pdf: &mut Pdf, font: &FontRef<'_>) {
    let [whole, letters, descriptor, file, text] = [6, 7, 8, 9, 10].map(Ref::new);
    let system = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
    pdf.type0_font(whole)
        .base_font(FONT_NAME)
        .encoding_predefined(Name(b"Identity-H"))
        .descendant_font(letters)
        .to_unicode(text);
    let scale = EM / font.units_per_em().unwrap_or(EM);
    let glyphs = u16::try_from(font.glyph_count()).unwrap_or(u16::MAX);
    let widths = (0..glyphs).map(|id| scale * font.h_advance_unscaled(ab_glyph::GlyphId(id)));
    let mut cid = pdf.cid_font(letters);
    cid.subtype(CidFontType::Type2).base_font(FONT_NAME).system_info(system);
    cid.font_descriptor(descriptor).cid_to_gid_map_predefined(Name(b"Identity"));
    cid.widths().consecutive(0, widths);
    cid.finish();
    let (ascent, descent) = (scale * font.ascent_unscaled(), scale * font.descent_unscaled());
    pdf.font_descriptor(descriptor)
        .name(FONT_NAME)
        .flags(FontFlags::NON_SYMBOLIC)
        .bbox(Rect::new(0.0, descent, EM, ascent))
        .italic_angle(0.0)
        .ascent(ascent)
        .descent(descent)
        .cap_height(ascent)
        .stem_v(80.0)
        .font_file2(file);
    pdf.stream(file, LETTERS).pair(Name(b"Length1"), i32::try_from(LETTERS.len()).unwrap_or(0));
    let mut map = UnicodeCmap::new(FONT_NAME, system);
    let mut pairs: Vec<_> = font.codepoint_ids().map(|(id, letter)| (id.0, letter)).collect();
    pairs.sort_unstable();
    pairs.into_iter().for_each(|(id, letter)| map.pair(id, letter));
    pdf.cmap(text, &map.finish());
}
