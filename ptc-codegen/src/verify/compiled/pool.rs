//! Processes that wait for work, the watch over those that work, and what went wrong.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::thread::Builder;
use std::time::Duration;

use super::worker::{Ended, Guarded, Request, Worker};

/// Time between two looks at the processes.
const PAUSE: Duration = Duration::from_millis(200);

/// Scenarios that end a process by themselves before no further one is started.
const MOST_FAULTS: usize = 16;

/// The processes of a program.
#[derive(Debug)]
pub(super) struct Pool {
    program: PathBuf,
    idle: Mutex<Vec<Worker>>,
    watched: Arc<Watched>,
    faults: Mutex<Vec<String>>,
    /// True once a process was late: others would be, each for as long.
    stalls: AtomicBool,
}

/// Processes that may be late.
#[derive(Debug, Default)]
struct Watched(Mutex<Vec<Weak<Guarded>>>);

impl Pool {
    pub(super) fn new(program: PathBuf) -> Self {
        let watched = Arc::new(Watched::default());
        let own = Arc::downgrade(&watched);
        let watch = move || {
            while let Some(watched) = own.upgrade() {
                watched.look();
                drop(watched);
                std::thread::sleep(PAUSE);
            }
        };
        // Without a thread nobody looks for processes that are late.
        let _ = Builder::new().name("watch".to_owned()).spawn(watch);
        Self {
            program,
            idle: Mutex::default(),
            watched,
            faults: Mutex::default(),
            stalls: AtomicBool::new(false),
        }
    }

    /// Runs a batch in a process that waits, or in a new one.
    ///
    /// # Errors
    /// How the process ended.
    pub(super) fn ask(&self, request: &Request<'_>, answer: &mut Vec<f64>) -> Result<(), Ended> {
        let waiting = self.idle().pop();
        let mut worker = match waiting {
            Some(worker) => worker,
            None => self.start()?,
        };
        worker.ask(request, answer)?;
        self.idle().push(worker);
        Ok(())
    }

    fn start(&self) -> Result<Worker, Ended> {
        let (worker, guarded) = Worker::start(&self.program)?;
        let mut all = self.watched.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.retain(|own| own.strong_count() > 0);
        all.push(Arc::downgrade(&guarded));
        Ok(worker)
    }

    fn idle(&self) -> std::sync::MutexGuard<'_, Vec<Worker>> {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes a scenario that ended its process.
    pub(super) fn note(&self, x0: &[f64], ended: &Ended) {
        let fault = format!("x0 = {x0:?}: {}", ended.told);
        self.stalls.fetch_or(ended.is_late, Ordering::Relaxed);
        self.faults.lock().unwrap_or_else(PoisonError::into_inner).push(fault);
    }

    /// Returns how the processes of such scenarios ended.
    pub(super) fn faults(&self) -> Vec<String> {
        self.faults.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Returns true if a process was late, or so many scenarios ended theirs that no further one is started.
    pub(super) fn has_given_up(&self) -> bool {
        let faults = self.faults.lock().unwrap_or_else(PoisonError::into_inner).len();
        faults >= MOST_FAULTS || self.stalls.load(Ordering::Relaxed)
    }
}

impl Watched {
    fn look(&self) {
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner).clone();
        all.iter().filter_map(Weak::upgrade).for_each(|guarded| guarded.look());
    }
}
