//! Output of the command `emit` for a design.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context as _, Result};
use serde_json::Value;

use super::cases::Case;
use crate::harness::empty;

/// A message: code, line, column, text and help, with single spaces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Message {
    code: String,
    place: Option<(String, String)>,
    text: String,
    help: String,
}

/// Files by their names, or messages.
pub(super) type Said = Result<BTreeMap<String, String>, Vec<Message>>;

/// Emits a design.
pub(super) fn emitted(
    generator: &Path,
    case: &Case,
    language: &str,
    folder: &Path,
) -> Result<Said> {
    let out = empty(folder);
    let mut emit = Command::new(generator);
    emit.arg("emit").arg(&case.path).args(["--lang", language, "-o"]).arg(&out);
    let output = emit.output().with_context(|| format!("{emit:?}"))?;
    if !output.status.success() {
        return Ok(Err(messages(&String::from_utf8_lossy(&output.stderr))));
    }
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(&out)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        files.insert(name, fs::read_to_string(&path)?);
    }
    Ok(Ok(files))
}

/// The messages on the standard error of the command.
fn messages(text: &str) -> Vec<Message> {
    let mut all: Vec<Message> = Vec::new();
    let mut helps = false;
    for line in text.lines() {
        if let Some((code, title)) = line.strip_prefix("error[").and_then(|l| l.split_once("]: ")) {
            let (code, text) = (code.to_owned(), spaced(title));
            all.push(Message { code, place: None, text, help: String::new() });
            helps = false;
            continue;
        }
        let Some(last) = all.last_mut() else { continue };
        if let Some((_, place)) = line.split_once("--> ").filter(|_| !helps) {
            let mut parts = place.rsplit(':');
            last.place =
                parts.next().and_then(|column| Some((parts.next()?.to_owned(), column.to_owned())));
        } else if let Some((_, help)) = line.split_once("= help: ") {
            helps = true;
            last.help.push_str(help);
        } else if helps {
            last.help.push(' ');
            last.help.push_str(line);
        }
    }
    all.iter_mut().for_each(|message| message.help = shown(&message.help));
    all
}

/// The messages that a browser saw.
pub(super) fn seen(errors: &Value) -> Vec<Message> {
    let one = |error: &Value| {
        let text = |key: &str| error[key].as_str().unwrap_or_default();
        let place = error["line"].as_str().zip(error["column"].as_str());
        Message {
            code: text("code").to_owned(),
            place: place.map(|(line, column)| (line.to_owned(), column.to_owned())),
            text: spaced(text("message")),
            help: shown(text("help")),
        }
    };
    errors.as_array().into_iter().flatten().map(one).collect()
}

/// Words with single spaces between them: where lines break is for each to decide.
fn spaced(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A help as it is compared: the command gives examples as flags, the page as lines of a design.
fn shown(help: &str) -> String {
    let help = spaced(help);
    help.split(", for example ").next().unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_parsed_with_line_and_column() {
        let text = "error[unknown-family]: unknown mapping `expo`\n --> a/b.toml:3:7\n  |\n3 | mu = \"expo\"\n  |       ^^^^\n  |\n  = help: did you mean `exp`?\n          or another\n\nerror[missing-key]: `n` is missing\n  |\n  = help: give it, for example --n 3\n";
        let found = messages(text);
        let place = Some(("3".to_owned(), "7".to_owned()));
        assert_eq!(found.len(), 2);
        assert_eq!((&*found[0].code, &found[0].place), ("unknown-family", &place));
        assert_eq!(found[0].help, "did you mean `exp`? or another");
        assert_eq!((&found[1].place, &*found[1].help), (&None, "give it"));
    }
}
