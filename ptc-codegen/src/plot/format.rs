//! Formats of a picture.

use super::Picture;

/// Format of the file of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Curves and text of a page of the web.
    Svg,
    /// Pixels.
    Png,
    /// A page that prints.
    Pdf,
}

impl Format {
    /// The format of the files with this extension, in letters of any size.
    pub fn of_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "svg" => Some(Self::Svg),
            "png" => Some(Self::Png),
            "pdf" => Some(Self::Pdf),
            _ => None,
        }
    }

    /// The file of a picture.
    ///
    /// # Errors
    /// A drawing that cannot be made.
    pub fn file(self, figure: &impl Picture) -> Result<Vec<u8>, String> {
        match self {
            Self::Svg => figure.svg().map(String::into_bytes),
            Self::Png => figure.png(),
            Self::Pdf => figure.pdf(),
        }
    }
}
