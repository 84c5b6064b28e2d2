//! A design file as text.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::UNREADABLE;
use crate::diagnostic::Diagnostic;
use crate::keys::KeyInfo;
use crate::limits::{DESIGN, URDF};
use crate::request::Entry;
use crate::syntax::Value;

/// The text of the file at `path`.
///
/// # Errors
/// The file cannot be read, is no UTF-8, or is larger than a design can be.
pub fn load(path: &Path) -> Result<String, Diagnostic> {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(DESIGN.most + 1).read_to_end(&mut bytes));
    let wrong = |message: String, help: &str| Diagnostic {
        code: UNREADABLE,
        key: "file".to_owned(),
        place: None,
        message,
        help: help.to_owned(),
    };
    let shown = path.display();
    match read {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            let near = path.with_extension("toml");
            let help = match path.extension().is_none() && near.is_file() {
                true => &format!("did you mean `{}`?", near.display()),
                false => "`ptc-codegen new` writes a design file to begin with",
            };
            Err(wrong(format!("there is no design file {shown}"), help))
        }
        Err(error) => {
            let help = "give a design file, TOML that can be read";
            Err(wrong(format!("cannot read the design file {shown}: {error}"), help))
        }
        Ok(read) if !DESIGN.admits(read) => {
            Err(wrong(DESIGN.beyond(&format!("the design file {shown}")), DESIGN.fix))
        }
        Ok(_) => {
            // The mark that some editors put before UTF-8 would shift every column.
            let text = String::from_utf8(bytes).map(|text| match text.strip_prefix('\u{feff}') {
                Some(rest) => rest.to_owned(),
                None => text,
            });
            text.map_err(|error| {
                let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
                let line = valid.iter().filter(|byte| **byte == b'\n').count() + 1;
                let message = format!("the design file {shown} is no UTF-8 in line {line}");
                wrong(message, "save it as UTF-8 text")
            })
        }
    }
}

/// Reads the files that entries name: their texts are values from here on. `path` is the place of the file of an entry.
pub fn with_files(entries: &mut [Entry], path: &dyn Fn(&Entry) -> PathBuf) {
    for entry in entries.iter_mut().filter(|entry| KeyInfo::is_file(&entry.key)) {
        let file = path(entry);
        let text = text_of(&file).map(Arc::from);
        let text = text.map_err(|error| format!("cannot read {}: {error}", file.display()));
        entry.value.value = Value::File(entry.value.value.to_string(), text);
    }
}

fn text_of(path: &Path) -> io::Result<String> {
    let mut bytes = Vec::new();
    File::open(path)?.take(URDF.most + 1).read_to_end(&mut bytes)?;
    if !URDF.admits(bytes.len()) {
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, URDF.beyond("it")));
    }
    String::from_utf8(bytes)
        .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error.utf8_error()))
}
