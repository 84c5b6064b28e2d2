//! The design file: the keys of a controller in TOML, read as entries of a spec.
//!
//! ```toml
//! name = "roll"
//! n = 2
//! mu = "exp(a=1)"
//! gains = [20, 9]
//! [params]
//! tau = 1.0
//! ```
//!
//! An entry's key is the dotted key of TOML: `gains`, `envelope.x_max`. Numbers keep the digits
//! of the file; text is what it would be on the command line.

mod completed;
mod file;
mod mistakes;
mod over;
mod quote;
mod reader;
mod statement;
mod template;
mod value;

pub use completed::{Line, completed};
pub use file::load;
pub use mistakes::{explains_missing, mistakes, root};
pub use over::overrides;
pub use quote::Quote;
pub use template::template;

use std::ops::Range;

use crate::diagnostic::{Diagnostic, Place};
use crate::limits::ENTRIES;
use crate::request::Entry;
use reader::Reader;
use statement::statements;

/// The tables of a design. All other keys are at the top.
const TABLES: [&str; 6] = ["params", "envelope", "model", "plant", "disturbance", "verify"];

/// The table that a design may have several times.
const LISTED: &str = "objective";

/// Parameters that every controller has: their keys are the same with and without `params.`.
const COMMON: [&str; 5] = ["tau", "t0", "eps", "u_max", "u_min"];

/// Code of a mistake in the TOML itself.
pub const SYNTAX: &str = "toml";

/// Code of a file that cannot be read at all.
pub const UNREADABLE: &str = "unreadable-design";

/// Limit of reported TOML syntax errors: a file of another kind is wrong in every line.
const MAX_SYNTAX: usize = 10;

/// The key of an entry, of one that may be written with `params.` before it.
pub fn canonical(key: &str) -> &str {
    key.strip_prefix("params.").filter(|name| COMMON.contains(name)).unwrap_or(key)
}

/// Reads the text of a design file: the entries that can be read, and the mistakes in the others.
/// `place` makes a place of a byte range of the text.
pub fn read(
    text: &str,
    place: &mut dyn FnMut(Range<usize>) -> Place,
) -> (Vec<Entry>, Vec<Diagnostic>) {
    let mut reader = Reader::new(text, place);
    let mut wrong = 0;
    let statements = statements(text);
    if !ENTRIES.admits(statements.len()) {
        let wrong = Diagnostic {
            code: UNREADABLE,
            key: "file".to_owned(),
            place: None,
            message: ENTRIES.exceeded("the design", statements.len()),
            help: ENTRIES.fix.to_owned(),
        };
        return (Vec::new(), vec![wrong]);
    }
    for statement in statements {
        wrong += usize::from(statement.wrong.is_some());
        if wrong > MAX_SYNTAX {
            break;
        }
        reader.statement(statement);
    }
    reader.finish()
}
