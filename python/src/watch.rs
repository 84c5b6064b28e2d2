//! Work without the interpreter's lock, which reports its progress and can be stopped.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use ptc_codegen::internal::guarded;
use pyo3::prelude::*;

use crate::failure::internal;

/// How often signals are handled and progress is reported.
const EVERY: Duration = Duration::from_millis(50);

/// Stack of the thread that works: that of a main thread, as the command has it.
const STACK: usize = 8 << 20;

/// How far the work is.
#[derive(Default)]
pub(crate) struct Watch {
    done: AtomicU64,
    stopped: AtomicBool,
}

/// The work was stopped.
pub(crate) struct Stopped;

impl Watch {
    /// Notes what is done.
    ///
    /// # Errors
    /// The work was stopped.
    pub(crate) fn add(&self, more: u64) -> Result<(), Stopped> {
        self.done.fetch_add(more, Ordering::Relaxed);
        if self.stopped.load(Ordering::Relaxed) { Err(Stopped) } else { Ok(()) }
    }

    /// Notes what is done, in a loop that has no other way out: where the work was stopped it unwinds
    /// to [`run`].
    pub(crate) fn tick(&self, more: u64) {
        self.add(more).unwrap_or_else(|stopped| resume_unwind(Box::new(stopped)));
    }
}

/// Calls `progress` with what is done and the whole.
fn report(py: Python<'_>, progress: Option<&Py<PyAny>>, (done, total): (u64, u64)) -> PyResult<()> {
    progress.map_or(Ok(()), |progress| progress.call1(py, (done.min(total), total)).map(|_| ()))
}

/// The result of `work`, which counts its ticks up to `total`.
///
/// Meanwhile the interpreter is free, signals are heard, and `progress` is called from this thread.
///
/// # Errors
/// What a signal or `progress` raises, which stops the work; a fault of the generator.
pub(crate) fn run<T: Send>(
    py: Python<'_>,
    (progress, total): (Option<Py<PyAny>>, u64),
    work: impl FnOnce(&Watch) -> T + Send,
) -> PyResult<T> {
    let watch = &Watch::default();
    let hear = |last: &mut u64| {
        Python::attach(|py| {
            py.check_signals()?;
            let done = watch.done.load(Ordering::Relaxed);
            if done == *last {
                return Ok(());
            }
            *last = done;
            report(py, progress.as_ref(), (done, total))
        })
    };
    let end = py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = sync_channel(1);
            let work = move || {
                // The other side waits until this one has sent.
                let _ = sender.send(guarded(|| work(watch)));
            };
            let builder = thread::Builder::new().name("ptc".to_owned()).stack_size(STACK);
            builder.spawn_scoped(scope, work)?;
            let (mut raised, mut last) = (None, 0);
            loop {
                match receiver.recv_timeout(EVERY) {
                    Ok(result) => return raised.map_or(Ok(result), Err),
                    Err(RecvTimeoutError::Timeout) if raised.is_none() => {
                        if let Err(error) = hear(&mut last) {
                            watch.stopped.store(true, Ordering::Relaxed);
                            raised = Some(error);
                        }
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => {
                        return Err(pyo3::exceptions::PyRuntimeError::new_err("the work ended"));
                    }
                }
            }
        })
    });
    let result = end?.map_err(|fault| internal(&fault))?;
    report(py, progress.as_ref(), (total, total))?;
    Ok(result)
}
