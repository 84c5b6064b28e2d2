//! Progress of a run, on the standard error: a bar where that is a terminal, a line now and then elsewhere.

use std::ops::Deref;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::report::print_text;

/// Time that a user waits at a terminal before anything is shown.
const PATIENCE: Duration = Duration::from_millis(500);

/// Time before the first line is printed elsewhere; each further one takes twice as long.
const QUIET: Duration = Duration::from_secs(30);

/// A bar that goes on while the run does nothing that counts.
pub(crate) struct Progress {
    bar: ProgressBar,
    /// `None` where there are no threads to be had.
    ticker: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Progress {
    fn new(bar: ProgressBar, what: &'static str) -> Self {
        let (sender, receiver) = channel();
        let own = bar.clone();
        let tick = move || {
            if own.is_hidden() { lines(&own, what, &receiver) } else { ticks(&own, &receiver) }
        };
        let ticker = Builder::new().name("progress".to_owned()).spawn(tick).ok();
        Self { bar, ticker: ticker.map(|ticker| (sender, ticker)) }
    }
}

impl Deref for Progress {
    type Target = ProgressBar;

    fn deref(&self) -> &ProgressBar {
        &self.bar
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, ticker)) = self.ticker.take() {
            drop(sender);
            // It ends with the channel.
            let _ = ticker.join();
        }
        self.bar.finish_and_clear();
    }
}

/// Draws the bar from time to time.
fn ticks(bar: &ProgressBar, receiver: &Receiver<()>) {
    while let Err(RecvTimeoutError::Timeout) = receiver.recv_timeout(PATIENCE) {
        bar.tick();
    }
}

/// Prints a line from time to time.
fn lines(bar: &ProgressBar, what: &str, receiver: &Receiver<()>) {
    let (began, mut wait) = (Instant::now(), QUIET);
    while let Err(RecvTimeoutError::Timeout) = receiver.recv_timeout(wait) {
        if bar.is_finished() {
            return;
        }
        let count = bar.length().map(|length| format!(", {} of {length}", bar.position()));
        let (count, seconds) = (count.unwrap_or_default(), began.elapsed().as_secs());
        let message = Some(bar.message()).filter(|own| !own.is_empty() && own != what);
        let message = message.map(|own| format!("; {own}")).unwrap_or_default();
        print_text(&format!("note: {what}{count}, {seconds} s so far{message}\n"));
        wait *= 2;
    }
}

/// A bar over so many tries, with a line below it for the best of them.
#[cfg(feature = "lab")]
pub(crate) fn tries(what: &'static str, count: u64) -> Progress {
    let bar =
        styled(ProgressBar::new(count), "{prefix} {wide_bar} {pos}/{len}, {elapsed}\n{wide_msg}");
    Progress::new(bar.with_prefix(what), what)
}

/// A bar over so many steps.
#[cfg(feature = "lab")]
pub(crate) fn progress(what: &'static str, count: u64) -> Progress {
    let bar = styled(ProgressBar::new(count), "{msg} {wide_bar} {pos}/{len}, {eta} left");
    Progress::new(bar.with_message(what), what)
}

/// Returns the result of `check` and shows its progress: the checks on a design take up to minutes with thousands of
/// samples.
pub(crate) fn checking<T>(check: impl FnOnce() -> T) -> T {
    let bar = styled(ProgressBar::new_spinner(), "{spinner} checking the design, {elapsed}");
    let _shown = Progress::new(bar, "checking the design");
    check()
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
