//! Why a measurement stopped, and its exit code.

use std::fmt::Display;

/// Error that ends a command early.
#[derive(Debug)]
pub(crate) struct Failure {
    /// 1: a measurement failed or is out of bounds; 2: something needed is not installed.
    pub(crate) exit: u8,
    /// For the standard error.
    pub(crate) message: String,
}

pub(crate) type Result<T> = std::result::Result<T, Failure>;

impl Failure {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { exit: 1, message: message.into() }
    }

    pub(crate) fn missing(tool: &str) -> Self {
        let install = match tool {
            "valgrind" => "Debian, Ubuntu: apt-get install valgrind",
            "gcc" | "g++" | "nm" | "objcopy" => "Debian, Ubuntu: apt-get install build-essential",
            _ => "https://rustup.rs",
        };
        Self { exit: 2, message: format!("`{tool}` is needed and not installed ({install})") }
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::new(error.to_string())
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Self::new(error.to_string())
    }
}

/// Names what was being done when an error came up.
pub(crate) trait While<T> {
    fn while_doing(self, what: impl Display) -> Result<T>;
}

impl<T, E: Display> While<T> for std::result::Result<T, E> {
    fn while_doing(self, what: impl Display) -> Result<T> {
        self.map_err(|error| Failure::new(format!("{what}: {error}")))
    }
}
