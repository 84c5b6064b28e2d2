//! Check that an emitted file keeps user text inside of its comments and strings.

use ptc_codegen::emit::File;

/// Delimiters of the text that a language does not read as code.
struct Syntax {
    /// Opening and closing delimiters of a comment or text of several lines.
    blocks: &'static [(&'static str, &'static str)],
    /// Delimiters that open a comment up to the end of the line.
    line: &'static [&'static str],
    /// Delimiters of a text on one line.
    quotes: &'static [char],
    /// Character that begins an escape in such a text.
    escape: Option<char>,
    /// Characters that no emitted code of the language has: a shell, a preprocessor or an attribute reads them.
    foreign: &'static [char],
}

const C: Syntax = Syntax {
    blocks: &[("/*", "*/")],
    line: &["//"],
    quotes: &['"', '\''],
    escape: Some('\\'),
    foreign: &['`', '$', '@'],
};
// A quote alone begins a lifetime.
const RUST: Syntax = Syntax { quotes: &['"'], ..C };
const PYTHON: Syntax =
    Syntax { blocks: &[("\"\"\"", "\"\"\"")], line: &["#"], foreign: &['`', '$', ';', '\\'], ..C };
const MATLAB: Syntax = Syntax {
    blocks: &[],
    line: &["%"],
    quotes: &['\''],
    escape: None,
    foreign: &['`', '$', '!', '"'],
};
const TEXT: Syntax = Syntax {
    blocks: &[("(*", "*)")],
    line: &["//"],
    quotes: &['\''],
    escape: Some('$'),
    foreign: &['`', '$', '{', '}', '"'],
};

/// Returns the fault of the file; `None` where every comment and every text ends where its template says. Files of
/// build tools are compared instead, by [`renamed`].
pub fn breach(file: &File) -> Option<String> {
    let odd = |c: char| !(c == '\n' || c == '\t' || c == ' ' || c.is_ascii_graphic());
    if let Some(c) = file.text.chars().find(|c| odd(*c)) {
        return Some(format!("{}: the character {c:?}", file.name));
    }
    let extension = file.name.rsplit_once('.').map_or("", |(_, extension)| extension);
    let found = match extension {
        "c" | "h" | "hpp" | "ino" => scan(&file.text, &C),
        "rs" => scan(&file.text, &RUST),
        "py" => scan(&file.text, &PYTHON),
        "m" => scan(&file.text, &MATLAB),
        "st" => scan(&file.text, &TEXT),
        "xml" => scan_xml(&file.text),
        _ => None,
    };
    found.map(|wrong| format!("{}: {wrong}", file.name))
}

/// Reads the text as the language does.
fn scan(text: &str, syntax: &Syntax) -> Option<String> {
    // C reads `??/` as a backslash, in comments too.
    if text.contains("??") {
        return Some("a trigraph".to_owned());
    }
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let shown = || rest.lines().next().unwrap_or_default().to_owned();
        if let Some((open, close)) = syntax.blocks.iter().find(|(open, _)| rest.starts_with(open)) {
            let Some(end) = rest[open.len()..].find(close) else {
                return Some(format!("no end: {}", shown()));
            };
            let inner = &rest[open.len()..open.len() + end];
            if inner.contains(open) {
                return Some(format!("a comment in a comment: {inner}"));
            }
            rest = &rest[open.len() + end + close.len()..];
        } else if syntax.line.iter().any(|open| rest.starts_with(open)) {
            let line = rest.lines().next().unwrap_or_default();
            if line.ends_with('\\') {
                return Some(format!("a comment that goes on: {line}"));
            }
            rest = &rest[line.len()..];
        } else if syntax.quotes.contains(&c) {
            let mut inner = rest.char_indices().skip(1);
            let end = loop {
                match inner.next() {
                    None | Some((_, '\n')) => return Some(format!("an open text: {}", shown())),
                    Some((at, own)) if own == c => break at,
                    Some((_, own)) if Some(own) == syntax.escape => _ = inner.next(),
                    Some(_) => {}
                }
            };
            rest = &rest[end + c.len_utf8()..];
        } else if syntax.foreign.contains(&c)
            || syntax.blocks.iter().any(|(_, close)| rest.starts_with(close))
        {
            return Some(format!("in code: {}", shown()));
        } else {
            rest = &rest[c.len_utf8()..];
        }
    }
    None
}

/// Reads tags and the entities between them.
fn scan_xml(text: &str) -> Option<String> {
    let (mut tag, mut value, mut entity) = (false, false, false);
    for (at, c) in text.char_indices() {
        let wrong = match c {
            '<' => tag || value,
            '>' => !tag || value,
            '"' => !tag,
            '&' => {
                entity = true;
                let name = text[at + 1..].split(';').next().unwrap_or_default();
                name.len() > 6 || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '#')
            }
            _ => false,
        };
        if wrong {
            return Some(format!("{c} in {}", text[..at].lines().last().unwrap_or_default()));
        }
        match c {
            '<' => tag = true,
            '>' => tag = false,
            '"' => value = !value,
            _ => {}
        }
    }
    let open = tag || value;
    (open || (entity && !text.contains(';'))).then(|| "no end".to_owned())
}

/// A file of a build tool, for a controller of another name.
pub fn renamed(file: &File, from: &str, to: &str) -> File {
    let other = |text: &str| text.replace(from, to);
    File { name: other(&file.name), text: other(&file.text) }
}

/// Returns true if a build tool reads the file.
pub fn is_of_a_tool(file: &File) -> bool {
    let extensions = [".txt", ".in", ".ld", ".x", ".toml", "Makefile", "build.rs"];
    extensions.iter().any(|extension| file.name.ends_with(extension))
}
