//! A process that runs scenarios: numbers go in, numbers come out, or one clear reason why not.

use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Bytes of the pipes that are converted at a time.
const BLOCK: usize = 1 << 15;

/// Bytes of a process's complaint that are read.
const SAID: u64 = 400;

/// A process, and when it has to have answered.
#[derive(Debug)]
pub(super) struct Guarded {
    child: Mutex<Child>,
    due: Mutex<Option<Instant>>,
    late: AtomicBool,
}

/// A process at work.
#[derive(Debug)]
pub(super) struct Worker {
    guarded: Arc<Guarded>,
    /// `None` once it is told to end.
    input: Option<ChildStdin>,
    output: ChildStdout,
    block: Vec<u8>,
}

/// The end of a process that gave no answer.
pub(super) struct Ended {
    /// How it ended.
    pub(super) told: String,
    /// True if it took too long.
    pub(super) is_late: bool,
}

/// A batch of scenarios.
pub(super) struct Request<'a> {
    /// Its numbers.
    pub(super) numbers: &'a [f64],
    /// Most numbers of its answer.
    pub(super) most: usize,
    /// Time within which the answer has to come.
    pub(super) limit: Duration,
}

impl Guarded {
    /// Ends a process that is late.
    pub(super) fn look(&self) {
        let due = *self.due.lock().unwrap_or_else(PoisonError::into_inner);
        if due.is_some_and(|due| Instant::now() >= due) {
            self.late.store(true, Ordering::Relaxed);
            // Who waits for its answer sees how it ended.
            let _ = self.end();
        }
    }

    /// Ends the process, and returns how it ended.
    fn end(&self) -> io::Result<ExitStatus> {
        let mut child = self.child.lock().unwrap_or_else(PoisonError::into_inner);
        // One that has ended has the status with which it did.
        let _ = child.kill();
        child.wait()
    }

    fn set(&self, due: Option<Instant>) {
        *self.due.lock().unwrap_or_else(PoisonError::into_inner) = due;
    }
}

impl Worker {
    /// Starts a process.
    ///
    /// # Errors
    /// The program cannot be run.
    pub(super) fn start(program: &Path) -> Result<(Self, Arc<Guarded>), Ended> {
        let mut command = Command::new(program);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let ended = |told| Ended { told, is_late: false };
        let failed = |error: io::Error| ended(format!("cannot be run: {error}"));
        let mut child = command.spawn().map_err(failed)?;
        let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(ended("has no pipes".to_owned()));
        };
        let (child, due, late) = (Mutex::new(child), Mutex::new(None), AtomicBool::new(false));
        let guarded = Arc::new(Guarded { child, due, late });
        let worker = Self {
            guarded: Arc::clone(&guarded),
            input: Some(input),
            output,
            block: Vec::with_capacity(BLOCK),
        };
        Ok((worker, guarded))
    }

    /// Runs a batch, and replaces what is in `answer` by its numbers.
    ///
    /// # Errors
    /// How the process ended; it is of no use any more.
    pub(super) fn ask(
        &mut self,
        request: &Request<'_>,
        answer: &mut Vec<f64>,
    ) -> Result<(), Ended> {
        self.guarded.set(Instant::now().checked_add(request.limit));
        let asked = self.send(request).and_then(|()| self.receive(request.most, answer));
        self.guarded.set(None);
        asked.map_err(|error| self.ended(&error, request.limit))
    }

    fn send(&mut self, request: &Request<'_>) -> io::Result<()> {
        let Some(input) = &mut self.input else {
            return Err(io::ErrorKind::BrokenPipe.into());
        };
        #[allow(clippy::cast_precision_loss)]
        let head = [request.numbers.len() as f64, request.most as f64];
        for numbers in std::iter::once(&head[..]).chain(request.numbers.chunks(BLOCK / 8)) {
            self.block.clear();
            self.block.extend(numbers.iter().flat_map(|number| number.to_ne_bytes()));
            input.write_all(&self.block)?;
        }
        input.flush()
    }

    fn receive(&mut self, most: usize, answer: &mut Vec<f64>) -> io::Result<()> {
        answer.clear();
        let mut head = [0; 8];
        self.output.read_exact(&mut head)?;
        let count = f64::from_ne_bytes(head);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let mut left = count as usize;
        #[allow(clippy::cast_precision_loss)]
        if left > most || left as f64 != count {
            return Err(io::ErrorKind::InvalidData.into());
        }
        answer.reserve(left);
        while left > 0 {
            let bytes = (8 * left).min(BLOCK);
            self.block.resize(bytes, 0);
            self.output.read_exact(&mut self.block)?;
            let (numbers, _) = self.block.as_chunks();
            answer.extend(numbers.iter().map(|number| f64::from_ne_bytes(*number)));
            left -= bytes / 8;
        }
        Ok(())
    }

    /// How a process ended that gave no answer.
    fn ended(&mut self, error: &io::Error, limit: Duration) -> Ended {
        self.input = None;
        // Only a process whose pipes are closed has ended by itself.
        let is_garbled = error.kind() == io::ErrorKind::InvalidData;
        let status = if is_garbled { None } else { self.guarded.end().ok() };
        let mut said = Vec::new();
        if !is_garbled {
            let mut child = self.guarded.child.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(complaint) = child.stderr.take() {
                // What cannot be read is not said.
                let _ = complaint.take(SAID).read_to_end(&mut said);
            }
        }
        let said = String::from_utf8_lossy(&said);
        let said = said.lines().next().map(|line| format!(": {line}")).unwrap_or_default();
        let is_late = self.guarded.late.load(Ordering::Relaxed);
        let told = match status {
            _ if is_late => format!("gave no answer within {} s", limit.as_secs()),
            Some(status) => format!("ended by {status}{said}"),
            None => "gave an answer that is none".to_owned(),
        };
        Ended { told, is_late }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.input = None;
        // Nothing is left to wait for if it cannot be ended.
        let _ = self.guarded.end();
    }
}
