//! From an order n and a mapping of time to the source of a prescribed-time controller.
//!
//! The plant is x1' = x2, ..., xn' = f + g u. The law is Theorem 1 of A. Shakouri and N. Assadian,
//! "A Framework for Prescribed-Time Control Design via Time-Scale Transformation":
//! u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x), where pi0 is linear unless the user gives another.
//!
//! [`Design`] is the way in: the text of a design file is read and checked, and gives source files. All
//! mistakes in it are found at once, each with its line; the same text gives the same bytes on any machine.
//!
//! ```
//! use ptc_codegen::{Design, Language};
//!
//! let design = Design::read("n = 3\nmu = \"exp\"\nname = \"axle\"")?;
//! let files = design.files(Language::C)?;
//! assert_eq!(files[0].name, "axle.h");
//!
//! let mistakes = Design::read("n = 3\nmu = \"expo\"").unwrap_err();
//! assert_eq!(mistakes.list()[0].line, Some(2));
//! assert!(mistakes.to_string().contains("did you mean `exp`?"));
//! # Ok::<(), ptc_codegen::Mistakes>(())
//! ```
//!
//! The modules of this crate serve the command, the macro `ptc_controller!` and the tests, which are other
//! packages of one workspace. They are no part of the public interface, are not shown here, and change in any
//! version.

#[doc(hidden)]
pub mod algebra;
#[doc(hidden)]
pub mod check;
#[doc(hidden)]
pub mod code;
mod collect;
#[doc(hidden)]
pub mod controller;
#[doc(hidden)]
pub mod design;
#[doc(hidden)]
pub mod diagnostic;
#[doc(hidden)]
pub mod dynamics;
#[doc(hidden)]
pub mod emit;
#[doc(hidden)]
pub mod expansion;
#[doc(hidden)]
pub mod expression;
#[doc(hidden)]
pub mod family;
#[doc(hidden)]
pub mod internal;
#[doc(hidden)]
pub mod keys;
#[doc(hidden)]
pub mod law;
#[doc(hidden)]
pub mod limits;
#[doc(hidden)]
pub mod linear;
#[doc(hidden)]
pub mod lower;
#[doc(hidden)]
pub mod mapping;
#[doc(hidden)]
pub mod model;
#[doc(hidden)]
pub mod parameter;
#[doc(hidden)]
pub mod plant;
#[cfg(feature = "lab")]
#[doc(hidden)]
pub mod plot;
#[doc(hidden)]
pub mod program;
#[cfg(feature = "files")]
#[doc(hidden)]
pub mod reference;
#[doc(hidden)]
pub mod request;
#[cfg(feature = "urdf")]
#[doc(hidden)]
pub mod robot;
#[doc(hidden)]
pub mod samples;
#[cfg(feature = "files")]
#[doc(hidden)]
pub mod selftest;
#[cfg(feature = "simulate")]
#[doc(hidden)]
pub mod simulate;
#[doc(hidden)]
pub mod syntax;
#[cfg(feature = "lab")]
#[doc(hidden)]
pub mod synthesis;
#[doc(hidden)]
pub mod urdf;
#[cfg(feature = "lab")]
#[doc(hidden)]
pub mod verify;

#[cfg(feature = "lab")]
#[doc(hidden)]
pub mod compare;

#[doc(hidden)]
pub mod accepted;
#[cfg(feature = "files")]
mod interface;

#[cfg(feature = "cli")]
mod cli;

/// Runs the command of a command line, its own name first, and gives its exit code: for the program, and for the
/// module of Python, whose wheel carries it.
#[cfg(feature = "cli")]
#[doc(hidden)]
pub fn command(line: impl IntoIterator<Item = std::ffi::OsString>) -> u8 {
    cli::run(line)
}

#[cfg(feature = "lab")]
#[doc(hidden)]
pub use cli::{Shown, card};

#[doc(hidden)]
pub use accepted::{Accepted, macro_items};
#[cfg(feature = "files")]
#[doc(hidden)]
pub use accepted::{dump, generate, generate_selftest, generate_with_proof, project};
#[cfg(feature = "files")]
pub use emit::{File, Language, Project};
#[cfg(feature = "files")]
pub use interface::{Design, Mistake, Mistakes};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
