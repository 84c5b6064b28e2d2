//! The Python module `ptc_codegen._ptc`: designs, and what the command does with them, as plain Python values.
//!
//! `python/ptc_codegen` puts types, defaults and documentation around it. Arrays are given as the bytes of
//! their doubles, so that NumPy is no dependency of this crate.

mod check;
mod design;
mod failure;
mod picture;
mod simulate;
mod verify;
mod watch;

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs the command `ptc-codegen` with a command line, its own name first: the exit code.
///
/// Help and mistakes in the flags end the process, as in the program.
#[pyfunction]
fn command(py: Python<'_>, line: Vec<OsString>) -> u8 {
    py.detach(|| ptc_codegen::command(line))
}

/// The functions and classes of `ptc_codegen`.
#[pymodule]
mod _ptc {
    #[pymodule_export]
    use super::check::check;
    #[pymodule_export]
    use super::command;
    #[pymodule_export]
    use super::design::{Design, emit};
    #[pymodule_export]
    use super::picture::{card, draw};
    #[pymodule_export]
    use super::simulate::simulate;
    #[pymodule_export]
    use super::verify::{merge, part, signals, verify};
}
