//! How far a run is.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar on the standard error, where that is a terminal.
pub(crate) fn progress(what: &'static str, count: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len}, {eta} left");
    let bar = ProgressBar::new(count).with_message(what);
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
