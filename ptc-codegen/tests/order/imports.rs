//! Imports of a file of the library: paths of its `use` lines and of its code, without its tests.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Names of modules from the root of the crate down, and of an item at the end of a path.
pub(crate) type Path = Vec<String>;

/// A file of the library.
#[derive(Clone)]
pub(crate) struct File {
    /// Its name under `src`.
    pub(crate) name: String,
    /// Its text.
    pub(crate) text: String,
}

/// References in the code of a file.
#[derive(Clone, Default)]
pub(crate) struct Imports {
    /// Every path into this crate.
    pub(crate) paths: Vec<Path>,
    /// The types with a block of methods that are named in a `use` line, by their paths.
    pub(crate) extended: Vec<Path>,
    /// The modules that are compiled for tests alone.
    pub(crate) for_tests: Vec<Path>,
}

impl File {
    /// The module that it is.
    pub(crate) fn module(&self) -> Path {
        let stem = self.name.trim_end_matches(".rs");
        let mut path: Path = stem.split('/').map(str::to_owned).collect();
        if path.last().is_some_and(|last| last == "mod") {
            path.pop();
        }
        path
    }

    /// Returns the imports of the file; `modules` are those of all files.
    pub(crate) fn imports(&self, modules: &BTreeSet<Path>) -> Imports {
        let tokens: TokenStream =
            self.text.parse().unwrap_or_else(|error| panic!("{}: {error}", self.name));
        let mut walk = Walk { modules, found: Imports::default(), named: BTreeMap::new() };
        walk.items(tokens, &self.module());
        walk.found
    }
}

struct Walk<'a> {
    modules: &'a BTreeSet<Path>,
    found: Imports,
    /// Names of `use` lines, and what they stand for.
    named: BTreeMap<String, Path>,
}

impl Walk<'_> {
    fn items(&mut self, tokens: TokenStream, here: &Path) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while at < tokens.len() {
            at = match &tokens[at] {
                TokenTree::Punct(hash) if hash.as_char() == '#' && is_for_tests(&tokens[at..]) => {
                    self.skipped(&tokens, at + 2, here)
                }
                TokenTree::Ident(word) if word == "use" => self.used(&tokens, at + 1, here),
                TokenTree::Ident(word) if word == "impl" && is_item(&tokens[..at]) => {
                    self.extends(&tokens[at + 1..], here);
                    at + 1
                }
                TokenTree::Ident(word) if word == "mod" => match tokens.get(at + 2) {
                    Some(TokenTree::Group(body)) => {
                        let inner = [here.as_slice(), &[tokens[at + 1].to_string()]].concat();
                        self.items(body.stream(), &inner);
                        at + 3
                    }
                    _ => at + 1,
                },
                TokenTree::Ident(_) => {
                    let (path, next) = path(&tokens, at);
                    if path.len() > 1 {
                        self.refers(path, here);
                    }
                    next
                }
                TokenTree::Group(group) => {
                    self.items(group.stream(), here);
                    at + 1
                }
                _ => at + 1,
            };
        }
    }

    /// Notes the module that an item for tests declares; the place behind the item.
    fn skipped(&mut self, tokens: &[TokenTree], from: usize, here: &Path) -> usize {
        let mut at = from;
        while let Some(token) = tokens.get(at) {
            match token {
                TokenTree::Ident(word) if word == "mod" => {
                    let name = tokens[at + 1].to_string();
                    self.found.for_tests.push([here.as_slice(), &[name]].concat());
                }
                TokenTree::Punct(end) if end.as_char() == ';' => return at + 1,
                TokenTree::Group(body) if body.delimiter() == Delimiter::Brace => return at + 1,
                _ => {}
            }
            at += 1;
        }
        at
    }

    /// The paths of a `use` line; the place behind it.
    fn used(&mut self, tokens: &[TokenTree], from: usize, here: &Path) -> usize {
        let is_end = |t: &TokenTree| matches!(t, TokenTree::Punct(p) if p.as_char() == ';');
        let end = tokens[from..].iter().position(is_end).map_or(tokens.len(), |end| from + end);
        for (path, name) in leaves(&tokens[from..end]) {
            if let Some(path) = self.refers(path, here) {
                self.named.insert(name, path);
            }
        }
        end + 1
    }

    /// Notes a path, if it leads into this crate.
    fn refers(&mut self, path: Path, here: &Path) -> Option<Path> {
        let up = path.iter().take_while(|part| *part == "super").count();
        let path = match path[0].as_str() {
            "crate" => path[1..].to_vec(),
            "self" => [here.as_slice(), &path[1..]].concat(),
            "super" => [&here[..here.len().saturating_sub(up)], &path[up..]].concat(),
            // A module of this one.
            _ => {
                let inner = [here.as_slice(), &path].concat();
                self.modules.contains(&inner[..=here.len()]).then_some(inner)?
            }
        };
        self.found.paths.push(path.clone());
        Some(path)
    }

    /// Notes the type of a block of methods: `impl<T> Type<T> {`, without `for`.
    fn extends(&mut self, tokens: &[TokenTree], here: &Path) {
        let is_body = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        let is = |token: &TokenTree, word: &str| token.to_string() == word;
        let end = tokens.iter().position(|t| is_body(t) || is(t, "where")).unwrap_or(tokens.len());
        let at = behind_generics(tokens);
        if at >= end || tokens[at..end].iter().any(|token| is(token, "for")) {
            return;
        }
        let (path, _) = path(tokens, at);
        let path = match path.as_slice() {
            [name] => self.named.get(name).cloned(),
            _ => self.refers(path, here),
        };
        self.found.extended.extend(path);
    }
}

/// The place behind `<...>`, if that is how the tokens begin.
fn behind_generics(tokens: &[TokenTree]) -> usize {
    let (mut depth, mut last) = (0, ' ');
    for (at, token) in tokens.iter().enumerate() {
        let sign = if let TokenTree::Punct(sign) = token { sign.as_char() } else { ' ' };
        match sign {
            '<' => depth += 1,
            '>' if last != '-' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return if sign == '>' { at + 1 } else { at };
        }
        last = sign;
    }
    tokens.len()
}

/// Returns true if `#[cfg(test)]`, or `#[cfg(all(test, ...))]`, begins here.
fn is_for_tests(tokens: &[TokenTree]) -> bool {
    let Some(TokenTree::Group(attribute)) = tokens.get(1) else { return false };
    let text = attribute.stream().to_string().replace(' ', "");
    text == "cfg(test)" || text.starts_with("cfg(all(test,")
}

/// Returns true if an item can begin behind `before`.
fn is_item(before: &[TokenTree]) -> bool {
    match before.last() {
        None => true,
        Some(TokenTree::Group(group)) => group.delimiter() != Delimiter::Parenthesis,
        Some(TokenTree::Punct(end)) => end.as_char() == ';',
        Some(_) => false,
    }
}

fn is_colon(token: Option<&TokenTree>) -> bool {
    matches!(token, Some(TokenTree::Punct(colon)) if colon.as_char() == ':')
}

/// The path that begins at `at`, and the place behind it.
fn path(tokens: &[TokenTree], at: usize) -> (Path, usize) {
    let mut path = vec![tokens[at].to_string()];
    let mut next = at + 1;
    while is_colon(tokens.get(next)) && is_colon(tokens.get(next + 1)) {
        let Some(TokenTree::Ident(part)) = tokens.get(next + 2) else { break };
        path.push(part.to_string());
        next += 3;
    }
    (path, next)
}

/// The paths of a tree of a `use` line, each with the name under which it is known.
fn leaves(tokens: &[TokenTree]) -> Vec<(Path, String)> {
    let Some(TokenTree::Ident(_)) = tokens.first() else {
        // `{...}` alone, and `*`.
        return match tokens.first() {
            Some(TokenTree::Group(group)) => branches(group.stream(), &[]),
            _ => Vec::new(),
        };
    };
    let (mut path, next) = path(tokens, 0);
    let behind = next + 2;
    match tokens.get(behind) {
        Some(TokenTree::Group(group)) if is_colon(tokens.get(next)) => {
            return branches(group.stream(), &path);
        }
        _ => {}
    }
    let renamed = match tokens.get(next) {
        Some(TokenTree::Ident(word)) if word == "as" => tokens.get(next + 1),
        _ => None,
    };
    if path.last().is_some_and(|last| last == "self") && path.len() > 1 {
        path.pop();
    }
    let name = renamed.map_or_else(|| path[path.len() - 1].clone(), ToString::to_string);
    vec![(path, name)]
}

/// Returns the leaves of the branches in braces behind `stem`.
fn branches(braces: TokenStream, stem: &[String]) -> Vec<(Path, String)> {
    let tokens: Vec<TokenTree> = braces.into_iter().collect();
    let is_comma = |t: &TokenTree| matches!(t, TokenTree::Punct(p) if p.as_char() == ',');
    let mut all = Vec::new();
    for branch in tokens.split(is_comma).filter(|branch| !branch.is_empty()) {
        for (path, name) in leaves(branch) {
            let mut whole = [stem, &path].concat();
            let is_stem = whole.last().is_some_and(|last| last == "self");
            if is_stem && whole.len() > 1 {
                whole.pop();
            }
            let name =
                if is_stem && name == "self" { whole[whole.len() - 1].clone() } else { name };
            all.push((whole, name));
        }
    }
    all
}
