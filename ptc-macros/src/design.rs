//! `file = "roll.toml"`: the design file of a controller, and how the compiler learns of it.

use std::path::{Path, PathBuf};

use proc_macro2::{Span, TokenStream};
use ptc_codegen::design::{self, Quote};
use ptc_codegen::diagnostic::{Diagnostic, Place};
use ptc_codegen::request::Entry;

use crate::input::Spot;

/// A design file that was named.
pub(crate) struct Design {
    /// Its path as it was written.
    name: String,
    /// The literal that names it.
    pub(crate) span: Span,
    path: PathBuf,
    text: String,
}

impl Design {
    /// The file called `name`, from the folder of the crate that is compiled; its entries, and
    /// what is wrong in it.
    pub(crate) fn read(
        name: String,
        span: Span,
        places: &mut Vec<Spot>,
    ) -> (Self, Vec<Entry>, Vec<Diagnostic>) {
        // Cargo sets it for the compiler, not for this crate when it was built.
        let folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
        let path = Path::new(&folder).join(&name);
        let mut note = |spot| {
            places.push(spot);
            Place(places.len() - 1)
        };
        match design::load(&path) {
            Ok(text) => {
                let (entries, found) = design::read(&text, &mut |range| note(Spot::File(range)));
                (Self { name, span, path, text }, entries, found)
            }
            Err(wrong) => {
                let wrong = Diagnostic { place: Some(note(Spot::Tokens(span, span))), ..wrong };
                (Self { name, span, path, text: String::new() }, Vec::new(), vec![wrong])
            }
        }
    }

    /// An item for which the compiler reads the file, so that a change of it is one of the crate.
    pub(crate) fn tracked(&self) -> TokenStream {
        let Some(path) = self.path.to_str().filter(|_| self.path.is_file()) else {
            return TokenStream::new();
        };
        let item = format!("const _: &[::core::primitive::u8] = ::core::include_bytes!({path:?});");
        item.parse().unwrap_or_default()
    }

    /// A mistake at bytes of the file: its place, what is wrong, and the line.
    pub(crate) fn told(&self, range: std::ops::Range<usize>, message: &str) -> String {
        let Quote { line, column, text, range } = Quote::new(&self.text, range);
        let margin = " ".repeat(line.to_string().len());
        let before = " ".repeat(text[..range.start].chars().count());
        let carets = "^".repeat(text[range].chars().count().max(1));
        format!(
            "{}:{line}:{column}: {message}\n{margin} |\n{line} | {text}\n{margin} | {before}{carets}",
            self.name
        )
    }
}

/// The text of a string literal that needs no escapes, as a path needs none.
pub(crate) fn literal(token: &str) -> Option<String> {
    if let Some(raw) = token.strip_prefix('r') {
        let inner = raw.trim_matches('#').strip_prefix('"')?.strip_suffix('"')?;
        return Some(inner.to_owned());
    }
    let inner = token.strip_prefix('"')?.strip_suffix('"')?;
    (!inner.contains('\\')).then(|| inner.to_owned())
}
