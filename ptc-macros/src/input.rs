//! `key = value, ...` as entries of a spec, with the spot of every place.
//!
//! A value is handed on as text, so that the macro and the command line share one parser.

use std::ops::Range;

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use ptc_codegen::design::{SYNTAX, UNREADABLE, canonical, overrides};
use ptc_codegen::diagnostic::{Diagnostic, Place};
use ptc_codegen::keys::KeyInfo;
use ptc_codegen::request::Entry;
use ptc_codegen::syntax::parse;

use crate::design::{self, Design};

const VALUES: &str = "a value is a number, a name, a name with arguments such as `power(m = 2)`, a list in brackets such as `[6, 11, 6]`, or an expression such as `-2 * xi1`";

/// What was found between the parentheses of the macro.
#[derive(Default)]
pub(crate) struct Input {
    /// The entries that can be read.
    pub(crate) entries: Vec<Entry>,
    /// The mistakes in the others.
    pub(crate) wrong: Vec<Diagnostic>,
    /// Where each [`Place`] is.
    pub(crate) places: Vec<Spot>,
    /// The design file, if one is named.
    pub(crate) design: Option<Design>,
}

/// Where a place is.
#[derive(Clone)]
pub(crate) enum Spot {
    /// From the first to the last token.
    Tokens(Span, Span),
    /// Bytes of the design file.
    File(Range<usize>),
}

/// Reads the tokens. A mistake ends its entry; reading goes on after the next comma.
pub(crate) fn read(tokens: TokenStream) -> Input {
    let tokens = flatten(tokens);
    let mut input = Input::default();
    let mut file = None;
    let mut rest = tokens.as_slice();
    while !rest.is_empty() {
        let comma = rest.iter().position(|token| token.depth == 0 && token.text == ",");
        let end = comma.unwrap_or(rest.len());
        input.entry(&rest[..end], &rest[..rest.len().min(end + 1)], &mut file);
        rest = rest.get(end + 1..).unwrap_or_default();
    }
    if let Some((name, span)) = file {
        input.design(name, span);
    }
    input
}

impl Input {
    /// The keys of the design file, except those that are given beside it.
    fn design(&mut self, name: String, span: Span) {
        let (design, entries, found) = Design::read(name, span, &mut self.places);
        let beside = self.entries.iter().map(|entry| &entry.key);
        let beside: Vec<_> = beside.chain(self.wrong.iter().map(|own| &own.key)).collect();
        let stands = |key: &str| beside.iter().all(|given| !overrides(given, key));
        // Errors of the file itself are reported even if keys beside it override its own.
        let kept = |own: &Diagnostic| [SYNTAX, UNREADABLE].contains(&own.code) || stands(&own.key);
        let entries: Vec<_> = entries.into_iter().filter(|entry| stands(&entry.key)).collect();
        let found: Vec<_> = found.into_iter().filter(kept).collect();
        self.entries.extend(entries);
        self.wrong.extend(found);
        self.design = Some(design);
    }

    /// One entry; `with_comma` are its tokens and the comma after it.
    fn entry(&mut self, tokens: &[Token], with_comma: &[Token], file: &mut Option<(String, Span)>) {
        let key = match tokens.first().or(with_comma.first()) {
            Some(key) if key.is_word => key,
            Some(other) => return self.unexpected("", other, "a key"),
            None => return,
        };
        match &tokens[1..] {
            [equals, value @ ..] if equals.text == "=" && key.text == "file" => {
                self.file(key, equals, value, file);
            }
            [equals, value @ ..] if equals.text == "=" => {
                self.value(&key.text, (key, key), equals, value);
            }
            [point, name, equals, value @ ..]
                if point.text == "." && name.is_word && equals.text == "=" =>
            {
                let dotted = format!("{}.{}", key.text, name.text);
                self.value(canonical(&dotted), (key, name), equals, value);
            }
            [other, ..] => self.unexpected(&key.text, other, "`=`"),
            [] => {
                let message = format!("`{}` has no value", key.text);
                let help = format!("write `{}`", example(&key.text));
                self.syntax(&key.text, key, message, help);
            }
        }
    }

    /// `file = "roll.toml"`, which is no key of a spec.
    fn file(
        &mut self,
        key: &Token,
        equals: &Token,
        tokens: &[Token],
        file: &mut Option<(String, Span)>,
    ) {
        let help = "write `file = \"roll.toml\"`, from the folder of your crate's Cargo.toml on";
        let at = tokens.first().unwrap_or(equals);
        match (tokens, tokens.first().and_then(|token| design::literal(&token.text))) {
            ([_], Some(_)) if file.is_some() => {
                let message = "`file` is given twice".to_owned();
                self.syntax("file", key, message, "leave one of the two out".to_owned());
            }
            ([name], Some(path)) => *file = Some((path, name.span)),
            _ => {
                let found = tokens.first().map_or("the end", |token| token.text.as_str());
                let message = format!("found `{found}` where the path of a file should be");
                self.syntax("file", at, message, help.to_owned());
            }
        }
    }

    fn value(&mut self, key: &str, at: (&Token, &Token), equals: &Token, tokens: &[Token]) {
        let place = self.place(at.0.span, at.1.span);
        let (text, ranges) = join(tokens);
        let mut locate = |range: Range<usize>| {
            let mut touched = ranges
                .iter()
                .zip(tokens)
                .filter(|(r, _)| r.start < range.end && r.end > range.start);
            // An empty range is behind the last token.
            let last = tokens.last().unwrap_or(equals).span;
            let first = touched.next().map_or(last, |(_, token)| token.span);
            let last = touched.next_back().map_or(first, |(_, token)| token.span);
            self.places.push(Spot::Tokens(first, last));
            Place(self.places.len() - 1)
        };
        match parse(key, &text, &mut locate) {
            Ok(value) => self.entries.push(Entry { key: key.to_owned(), place, value }),
            Err(wrong) => {
                let quoted = tokens.iter().any(|token| token.text.starts_with('"'));
                // The parser's own help is for a command line, where a list needs no brackets.
                let (message, help) = match quoted {
                    true => {
                        let message = "in the macro expressions have no quotes".to_owned();
                        (message, format!("write {key} ={}", text.replace('"', "")))
                    }
                    false if wrong.code == "syntax" => (wrong.message, VALUES.to_owned()),
                    false => (wrong.message, wrong.help),
                };
                self.wrong.push(Diagnostic { message, help, ..wrong });
            }
        }
    }

    fn unexpected(&mut self, key: &str, found: &Token, expected: &str) {
        let message = format!("found `{}` where {expected} should be", found.text);
        let help = "write `key = value`, separated by commas, and a list in brackets: `[6, 11, 6]`";
        self.syntax(key, found, message, help.to_owned());
    }

    fn syntax(&mut self, key: &str, at: &Token, message: String, help: String) {
        let place = Some(self.place(at.span, at.span));
        self.wrong.push(Diagnostic { code: "syntax", key: key.to_owned(), place, message, help });
    }

    fn place(&mut self, first: Span, last: Span) -> Place {
        self.places.push(Spot::Tokens(first, last));
        Place(self.places.len() - 1)
    }
}

/// An entry for `key` as it is written in the macro.
pub(crate) fn example(key: &str) -> String {
    match KeyInfo::find(key) {
        Some(info) if key == "gains" => format!("{key} = [{}]", info.example),
        Some(info) => format!("{key} = {}", info.example),
        None => format!("{key} = value"),
    }
}

struct Token {
    text: String,
    span: Span,
    /// Number of brackets around it.
    depth: usize,
    is_word: bool,
}

/// All tokens in a row, brackets included. It keeps its own stack, so that no depth of brackets
/// can exhaust the compiler's.
fn flatten(stream: TokenStream) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut open = vec![(stream.into_iter(), None)];
    let mut depth = 0;
    while let Some((rest, _)) = open.last_mut() {
        match rest.next() {
            Some(TokenTree::Group(group)) => {
                // An invisible group holds what a macro_rules macro passes on; its tokens count
                // as if they stood here.
                let brackets = match group.delimiter() {
                    Delimiter::Parenthesis => Some(("(", ")")),
                    Delimiter::Bracket => Some(("[", "]")),
                    Delimiter::Brace => Some(("{", "}")),
                    Delimiter::None => None,
                };
                let bracket = |text: &str, span| Token {
                    text: text.to_owned(),
                    span,
                    depth: depth + 1,
                    is_word: false,
                };
                let close = brackets.map(|(_, close)| bracket(close, group.span_close()));
                if let Some((text, _)) = brackets {
                    tokens.push(bracket(text, group.span_open()));
                    depth += 1;
                }
                open.push((group.stream().into_iter(), close));
            }
            Some(tree) => {
                let is_word = matches!(tree, TokenTree::Ident(_));
                tokens.push(Token {
                    text: plain(&tree.to_string()),
                    span: tree.span(),
                    depth,
                    is_word,
                });
            }
            None => {
                if let Some((_, Some(close))) = open.pop() {
                    tokens.push(close);
                    depth -= 1;
                }
            }
        }
    }
    tokens
}

/// A decimal literal without its underscores and the suffix of a float; other tokens as they are.
fn plain(token: &str) -> String {
    let decimal = token.starts_with(|c: char| c.is_ascii_digit())
        && !["0x", "0o", "0b"].iter().any(|prefix| token.starts_with(prefix));
    if !decimal {
        return token.to_owned();
    }
    let number = token.strip_suffix("f64").or(token.strip_suffix("f32")).unwrap_or(token);
    number.replace('_', "")
}

/// The text of the tokens, and the place of each in it. A sign, or a leading point, belongs to the
/// number after it.
fn join(tokens: &[Token]) -> (String, Vec<Range<usize>>) {
    let mut text = String::new();
    let mut ranges = Vec::new();
    for token in tokens {
        if !text.ends_with(['-', '+', '.']) {
            text.push(' ');
        }
        let start = text.len();
        text.push_str(&token.text);
        ranges.push(start..text.len());
    }
    (text, ranges)
}

#[cfg(test)]
mod tests {
    use proc_macro2::{Group, Literal};
    use ptc_codegen::request::{Spec, read as read_spec};
    use ptc_codegen::syntax::Value;

    use super::*;

    fn read_text(text: &str) -> Input {
        read(text.parse().expect("tokens"))
    }

    fn spec(text: &str) -> Spec {
        let input = read_text(text);
        assert!(input.wrong.is_empty(), "{text}: {:?}", input.wrong);
        read_spec(&input.entries).expect("a spec")
    }

    fn number(text: &str) -> String {
        match &read_text(&format!("tau = {text}")).entries[..] {
            [Entry { value, .. }] => match &value.value {
                Value::Number(number) => number.to_string(),
                other => panic!("{text}: {other:?}"),
            },
            other => panic!("{text}: {other:?}"),
        }
    }

    #[test]
    fn numbers_as_rust_writes_them() {
        for (text, read) in [
            ("1", "1"),
            ("-1_000.5", "-1000.5"),
            ("- 2", "-2"),
            ("2.5e-3", "2.5e-3"),
            ("1_f64", "1"),
            ("1.5f32", "1.5"),
            ("3.", "3."),
            (".5", ".5"),
            ("inf", "inf"),
        ] {
            assert_eq!(number(text), read);
        }
    }

    #[test]
    fn every_shape_of_value() {
        let found = spec(
            "n = 2, mu = exp_sum(rates = [0.5, 1.5,],), name = Roll, precision = f32, \
             guard = result, gains = [6, 5], tau = 2, t0 = -1, eps = 1e-3, u_max = inf,",
        );
        assert_eq!(
            found.command(),
            "--n 2 --mu \"exp_sum(rates=[0.5,1.5])\" --name Roll --precision f32 --guard result \
             --tau=2 --t0=-1 --eps=1e-3 --u-max=inf --gains=6,5"
        );
        assert_eq!(spec("mu = exp_sum(3), n = 1").rates(), 3);
    }

    #[test]
    fn what_macro_rules_passes_on_is_read_as_if_written() {
        let mut tokens: TokenStream = "mu = exp, n =".parse().expect("tokens");
        let inner = TokenTree::from(Literal::u8_unsuffixed(4)).into();
        tokens.extend([TokenTree::from(Group::new(Delimiter::None, inner))]);
        assert_eq!(read_spec(&read(tokens).entries).expect("a spec").n, 4);
    }

    #[test]
    fn each_entry_has_its_own_mistake() {
        let input =
            read_text("n: 3, = 2, 7, tau, eps =, , mu = exp(a = ), t0 = 1 2, gains = [1; 3]");
        let found: Vec<_> = input.wrong.iter().map(|wrong| wrong.message.as_str()).collect();
        assert_eq!(
            found,
            [
                "found `:` where `=` should be",
                "found `=` where a key should be",
                "found `7` where a key should be",
                "`tau` has no value",
                "found the end where a value should be",
                "found `,` where a key should be",
                "found `)` where a value should be",
                "found `2` where the end of the value should be",
                "found `;` where `,` or `]` should be",
            ]
        );
        assert!(input.wrong.iter().all(|wrong| wrong.place.is_some()));
        assert!(input.entries.is_empty());
    }

    #[test]
    fn dotted_keys_are_those_of_the_tables_of_a_design() {
        let input = read_text("params.psi = 20, params.tau = 1, envelope.x_max = [1], params. = 2");
        let keys: Vec<_> = input.entries.iter().map(|entry| entry.key.as_str()).collect();
        assert_eq!(keys, ["params.psi", "tau", "x_max"]);
        assert_eq!(input.wrong.len(), 1);
    }

    #[test]
    fn entries_beside_a_file_stand_for_its_keys() {
        let design = "file = \"../tests/designs/roll.toml\"";
        assert_eq!(
            spec(&format!("{design}, name = yaw, params.tau = 3")).command(),
            "--n 2 --mu \"exp(a=1)\" --name yaw --tau=3 --eps=1e-2 --u-max=inf --gains=6,5"
        );
        let input = read_text(&format!("{design}, file = r#\"b.toml\"#, gains = [6, x y]"));
        assert_eq!(input.wrong.len(), 2);
        assert!(input.entries.iter().all(|entry| entry.key != "gains"));
        assert!(input.design.is_some_and(|d| d.tracked().to_string().contains("roll.toml")));
        for wrong in ["file = roll", "file =", "file = \"a\" b", "file = \"a\\nb\"", "file = 1"] {
            let input = read_text(wrong);
            assert!(input.wrong.len() == 1 && input.design.is_none(), "{wrong}");
        }
        let input = read_text("file = \"none.toml\"");
        assert!(input.wrong[0].message.contains("none.toml"), "{:?}", input.wrong);
        assert!(input.design.is_some_and(|d| d.tracked().is_empty()));
    }

    #[test]
    fn deep_brackets_are_a_mistake_and_no_crash() {
        let depth = 2000;
        let text = format!("n = {}1{}, mu = exp", "[".repeat(depth), "]".repeat(depth));
        let input = read_text(&text);
        assert_eq!(input.wrong.len(), 1);
        assert_eq!(input.entries.len(), 1);
    }
}
