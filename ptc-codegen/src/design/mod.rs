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
//! An entry's key is [`canonical`]: `gains`, `params.a`, `x_max`. Numbers keep the digits
//! of the file; text is what it would be on the command line.

mod completed;
mod file;
mod mistakes;
mod over;
mod quote;
mod reader;
mod start;
mod statement;
mod template;
mod value;

pub use completed::{Line, completed};
pub use file::{load, with_files};
pub use mistakes::{independent, mistakes, root};
pub use over::overrides;
pub use quote::Quote;
pub use start::{STARTS, Start};
pub use template::{template, written};

use std::ops::Range;

use crate::diagnostic::{Diagnostic, Place};
use crate::keys::KeyInfo;
use crate::limits::ENTRIES;
use crate::request::Entry;
use reader::Reader;
use statement::statements;

/// Code of a mistake in the TOML itself.
pub const SYNTAX: &str = "toml";

/// Code of a file that cannot be read at all.
pub const UNREADABLE: &str = "unreadable-design";

/// Limit of reported TOML syntax errors: a file of another kind is wrong in every line.
const MAX_SYNTAX: usize = 10;

/// Returns the key by which a value is known wherever it is given: without its table, where the table
/// holds the key and no other meaning of it.
pub fn canonical(key: &str) -> &str {
    let of_table = |(table, name)| {
        let info = KeyInfo::find(name).filter(|info| info.table() == Some(table));
        info.map(|_| name)
    };
    key.split_once('.').and_then(of_table).unwrap_or(key)
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
