//! Signals that end the process, and the one that asks a search to end with what it has.

#[cfg(feature = "lab")]
use std::sync::atomic::{AtomicBool, Ordering};

/// True while the first SIGINT is a request.
#[cfg(feature = "lab")]
static IS_REQUEST: AtomicBool = AtomicBool::new(false);

/// True once there was one.
#[cfg(feature = "lab")]
static IS_ASKED: AtomicBool = AtomicBool::new(false);

/// Makes the first SIGINT a request, as long as it exists; the second one ends the process.
#[cfg(feature = "lab")]
pub(crate) struct Interruption(());

#[cfg(feature = "lab")]
impl Interruption {
    /// Waits for a request from here on; signals have to be [watched](super::temporary::watch).
    pub(crate) fn new() -> Self {
        IS_REQUEST.store(true, Ordering::SeqCst);
        Self(())
    }

    /// Returns true if the end was asked for.
    #[allow(clippy::unused_self)]
    pub(crate) fn is_asked(&self) -> bool {
        IS_ASKED.load(Ordering::SeqCst)
    }
}

#[cfg(feature = "lab")]
impl Drop for Interruption {
    fn drop(&mut self) {
        IS_REQUEST.store(false, Ordering::SeqCst);
    }
}

/// Returns true if a signal is a request, and not the end.
#[cfg(all(unix, feature = "lab"))]
fn is_request(signal: i32) -> bool {
    signal == signal_hook::consts::SIGINT
        && IS_REQUEST.load(Ordering::SeqCst)
        && !IS_ASKED.swap(true, Ordering::SeqCst)
}

#[cfg(all(unix, not(feature = "lab")))]
fn is_request(_: i32) -> bool {
    false
}

/// From here on `clean` runs before a signal ends the process.
#[cfg(unix)]
pub(super) fn handle(clean: fn()) -> std::io::Result<()> {
    unix::handle(clean)
}

/// Signals are those of Unix.
#[cfg(not(unix))]
pub(super) fn handle(_: fn()) -> std::io::Result<()> {
    Ok(())
}

#[cfg(unix)]
mod unix {
    use std::fs;
    use std::io;
    use std::sync::Arc;
    use std::thread;

    use signal_hook::consts::{SIGALRM, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGXFSZ};
    use signal_hook::iterator::Signals;
    use signal_hook::{flag, low_level};

    use super::is_request;

    pub(super) fn handle(clean: fn()) -> io::Result<()> {
        // To be interrupted by it is not to be ended by it: the write then fails.
        flag::register(SIGXFSZ, Arc::default())?;
        let ignored = ignored();
        let all = [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGXCPU];
        let heard = all.into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
        let heard: Vec<_> = heard.collect();
        let mut signals = Signals::new(&heard)?;
        let listen = move || {
            if let Some(signal) = signals.forever().find(|signal| !is_request(*signal)) {
                clean();
                let _ = low_level::emulate_default_handler(signal);
                low_level::exit(128 + signal);
            }
        };
        if let Err(error) = thread::Builder::new().name("signals".to_owned()).spawn(listen) {
            // Without a thread that listens a signal ends the process at once, as it would anyway.
            for signal in heard {
                flag::register_conditional_default(signal, Arc::new(true.into()))?;
            }
            return Err(error);
        }
        Ok(())
    }

    /// The signals that whoever started the process wants ignored, as `nohup` does, one bit each.
    /// Where the system does not say so, that is taken of SIGHUP.
    fn ignored() -> u64 {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        mask.unwrap_or(1 << (SIGHUP - 1))
    }
}
