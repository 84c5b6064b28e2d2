//! From the command line that a spec gives back to a spec.

use ptc_codegen::design::canonical;
use ptc_codegen::diagnostic::{Diagnostic, Place};
use ptc_codegen::keys::KeyInfo;
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::parse;

/// The words of a command line, as a shell splits it.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut quoted) = (vec![String::new()], false);
    for c in line.chars() {
        // What a shell would take for more than text.
        assert!(!"`$\\!;&|<>'\n".contains(c), "{c} in {line}");
        assert!(quoted || !"[]()*?{}~#".contains(c), "{c} is not quoted: {line}");
        match c {
            '"' => quoted = !quoted,
            ' ' if !quoted => words.push(String::new()),
            c => words.last_mut().expect("a word").push(c),
        }
    }
    assert!(!quoted, "an open quote: {line}");
    words
}

/// The keys of a command line with their values: `--flag value`, `--flag=value` and
/// `--param NAME=VALUE`.
pub(crate) fn keys(line: &str) -> Vec<(String, String)> {
    let mut words = words(line).into_iter();
    let mut keys = Vec::new();
    while let Some(word) = words.next() {
        let flag = word.strip_prefix("--").expect("a flag");
        let (flag, value) = match flag.split_once('=') {
            Some((flag, value)) => (flag.to_owned(), value.to_owned()),
            None if KeyInfo::find(flag).is_some_and(KeyInfo::is_switch) => {
                (flag.to_owned(), "true".to_owned())
            }
            None => (flag.to_owned(), words.next().expect("a value")),
        };
        keys.push(match value.split_once('=') {
            Some((name, value)) if flag == "param" => {
                (canonical(&format!("params.{name}")).to_owned(), value.to_owned())
            }
            _ => (flag.replace('-', "_"), value),
        });
    }
    keys
}

/// The spec of a command line.
pub(crate) fn spec_of(line: &str) -> Result<Spec, Vec<Diagnostic>> {
    let mut entries = Vec::new();
    for (key, text) in keys(line) {
        let value = parse(&key, &text, &mut |_| Place(0)).map_err(|wrong| vec![wrong])?;
        entries.push(Entry { key, place: Place(0), value });
    }
    read(&entries)
}
