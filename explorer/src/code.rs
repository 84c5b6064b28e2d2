//! The emitted files.

use ptc_codegen::emit::File;
use serde_json::{Value, json};

pub(crate) fn files(files: &[File]) -> Value {
    files.iter().map(|file| json!({ "name": file.name, "text": file.text })).collect()
}
