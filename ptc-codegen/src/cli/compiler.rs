//! The C compiler of this machine, which CC names.

use std::env;
use std::ffi::OsString;

/// Returns its command.
pub(crate) fn compiler() -> OsString {
    env::var_os("CC").filter(|cc| !cc.is_empty()).unwrap_or_else(|| "cc".into())
}
