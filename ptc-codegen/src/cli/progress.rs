//! How far a run is, on the standard error where that is a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// How long a user waits before anything is shown.
const PATIENCE: Duration = Duration::from_millis(500);

/// A bar over so many steps.
#[cfg(feature = "lab")]
pub(crate) fn progress(what: &'static str, count: u64) -> ProgressBar {
    styled(ProgressBar::new(count), "{msg} {wide_bar} {pos}/{len}, {eta} left").with_message(what)
}

/// What `check` gives: the checks on a design, which take up to minutes with thousands of samples.
pub(crate) fn checking<T>(check: impl FnOnce() -> T) -> T {
    let bar = styled(ProgressBar::new_spinner(), "{spinner} checking the design, {elapsed}");
    bar.enable_steady_tick(PATIENCE);
    let found = check();
    bar.finish_and_clear();
    found
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
