//! Faults of the generator itself, which end the work: no part of a file is output for one.

use std::any::Any;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use crate::diagnostic::Diagnostic;

/// Code of the diagnostic of such a fault.
pub const INTERNAL: &str = "internal";

/// A fault of the generator, not of its input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Internal(String);

impl Internal {
    /// Advice to the user.
    pub const HELP: &'static str = "this is a fault of ptc-codegen, not of the input, and nothing was written: report this text with the command line and the design at https://github.com/ptc-codegen/ptc/issues";

    fn of(payload: Box<dyn Any + Send>) -> Self {
        let text = |payload: &(dyn Any + Send)| {
            let text = payload.downcast_ref::<String>().map(String::as_str);
            text.or(payload.downcast_ref::<&str>().copied()).unwrap_or("a panic").to_owned()
        };
        payload.downcast::<Self>().map_or_else(|other| Self(text(other.as_ref())), |own| *own)
    }
}

impl From<String> for Internal {
    fn from(what: String) -> Self {
        Self(what)
    }
}

impl fmt::Display for Internal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "internal fault: {}", self.0)
    }
}

impl std::error::Error for Internal {}

impl From<Internal> for Diagnostic {
    fn from(fault: Internal) -> Self {
        Self {
            code: INTERNAL,
            key: String::new(),
            place: None,
            message: fault.to_string(),
            help: Internal::HELP.to_owned(),
        }
    }
}

/// Ends the work that [`guarded`] does. It is for what no input may cause.
pub fn fault(what: impl Into<String>) -> ! {
    resume_unwind(Box::new(Internal(what.into())))
}

/// The result of `work`.
///
/// # Errors
/// The fault, or the panic, that ended it.
pub fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, Internal> {
    catch_unwind(AssertUnwindSafe(work)).map_err(Internal::of)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_and_panics_are_errors_with_their_texts() {
        assert_eq!(guarded(|| 1), Ok(1));
        let faults: [fn() -> u8; 2] = [|| fault("no name"), || resume_unwind(Box::new("no name"))];
        for work in faults {
            let found = guarded(work).expect_err("a fault");
            assert_eq!(found.to_string(), "internal fault: no name");
            assert_eq!(Diagnostic::from(found).code, INTERNAL);
        }
    }
}
