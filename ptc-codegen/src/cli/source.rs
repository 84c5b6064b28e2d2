//! From a design file and flags to the entries of a spec, with a table of the places they came from.

use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::check::resolved::Choice;
use crate::design::{self, mistakes, overrides, root};
use crate::diagnostic::{Diagnostic, LARGE, Place};
use crate::internal::INTERNAL;
use crate::keys::KeyInfo;
use crate::limits::ENTRIES;
use crate::plant::{self, Plant};
use crate::request::{Entry, Spec};
use crate::syntax::parse;

use super::report::{Exit, Failure, Notice, Quote, quoted};

/// The flag of a value of the plant.
#[cfg(feature = "lab")]
const PLANT: &str = "--plant";

/// The flags that were given, and the design file if there is one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Source {
    given: Vec<Flag>,
    file: Option<(PathBuf, String)>,
}

/// One flag.
#[derive(Clone, Debug)]
struct Flag {
    key: String,
    /// With its dashes.
    name: String,
    /// Text after it.
    text: String,
    /// Offset of the value in it: after `NAME=` for `--param`.
    value: usize,
}

/// The lines of a design file that fix what was chosen.
pub(crate) fn chosen(choices: &[Choice]) -> Vec<design::Line> {
    let line = |choice: &Choice| design::Line {
        key: choice.key.to_owned(),
        value: choice.value.clone(),
        comment: format!("chosen: {}", choice.reason),
    };
    choices.iter().map(line).collect()
}

/// Location of a [`Place`].
#[derive(Clone, Debug)]
enum Spot {
    /// A flag's index and a byte range of its text.
    Flag(usize, Range<usize>),
    /// A byte range of the design file.
    File(Range<usize>),
}

/// Flags and lines whose texts are values, though not yet of a known meaning.
pub(crate) struct Parsed<'a> {
    source: &'a Source,
    places: Vec<Spot>,
    pub(crate) entries: Vec<Entry>,
    found: Vec<Diagnostic>,
}

/// The flag of a key.
pub(crate) fn flag(key: &str) -> String {
    format!("--{}", key.replace('_', "-"))
}

impl Source {
    /// Notes one flag.
    pub(crate) fn give(&mut self, key: &str, text: &str) {
        let flag = Flag { key: key.to_owned(), name: flag(key), text: text.to_owned(), value: 0 };
        self.given.push(flag);
    }

    /// Notes one `--param NAME=VALUE`. Without `=` the value is empty, which is an error.
    pub(crate) fn give_parameter(&mut self, text: &str) {
        self.give_named("params", "--param", text);
    }

    /// Notes one `--plant NAME=VALUE`.
    #[cfg(feature = "lab")]
    pub(crate) fn give_plant(&mut self, text: &str) {
        self.give_named(plant::TABLE, PLANT, text);
    }

    /// Notes a flag of another name than its key's.
    pub(crate) fn give_key(&mut self, key: &str, name: &str, text: &str) {
        let flag =
            Flag { key: key.to_owned(), name: name.to_owned(), text: text.to_owned(), value: 0 };
        self.given.push(flag);
    }

    fn give_named(&mut self, table: &str, flag: &str, text: &str) {
        let (name, value) = match text.split_once('=') {
            Some((name, _)) => (name, name.len() + 1),
            None => (text, text.len()),
        };
        let key = format!("{table}.{}", name.trim());
        let key = design::canonical(&key).to_owned();
        self.given.push(Flag { key, name: flag.to_owned(), text: text.to_owned(), value });
    }

    /// The design file with what the flags give in it, and `more` beside.
    pub(crate) fn completed(&self, more: Vec<design::Line>) -> String {
        let flag = |flag: &Flag| design::Line {
            key: flag.key.clone(),
            // A switch has no value.
            value: Some(&flag.text[flag.value..])
                .filter(|text| !text.is_empty())
                .unwrap_or("true")
                .to_owned(),
            comment: "from the command line".to_owned(),
        };
        let lines: Vec<_> = self.given.iter().map(flag).chain(more).collect();
        design::completed(self.text().unwrap_or_default(), &lines)
    }

    /// The folder to which the path that is the value of `key` is relative: that of the design file, if the key is in it.
    fn folder_of(&self, key: &str) -> PathBuf {
        let in_file = self.given.iter().all(|flag| flag.key != key);
        let folder = self.file.as_ref().filter(|_| in_file).and_then(|(path, _)| path.parent());
        folder.map(Path::to_owned).unwrap_or_default()
    }

    /// The place of the file that an entry names.
    pub(crate) fn file_of(&self, entry: &Entry) -> PathBuf {
        self.folder_of(&entry.key).join(entry.value.value.to_string())
    }

    /// The text of the design file, if there is one.
    pub(crate) fn text(&self) -> Option<&str> {
        self.file.as_ref().map(|(_, text)| text.as_str())
    }

    /// The flags with what is written after them, in their order.
    #[cfg(feature = "lab")]
    pub(crate) fn flags(&self) -> impl Iterator<Item = (&str, &str)> {
        self.given.iter().map(|flag| (flag.name.as_str(), flag.text.as_str()))
    }

    /// Returns true if a flag gives `key`.
    #[cfg(feature = "lab")]
    pub(crate) fn gives(&self, key: &str) -> bool {
        self.given.iter().any(|flag| flag.key == key)
    }

    /// The same without the values of `--plant`.
    #[cfg(feature = "lab")]
    pub(crate) fn without_plant(&self) -> Self {
        let mut source = self.clone();
        source.given.retain(|flag| flag.name != PLANT);
        source
    }

    /// The same with one of the values that the flag of `key` lists, for each of them.
    #[cfg(feature = "lab")]
    pub(crate) fn each(&self, key: &str) -> Vec<Self> {
        let Some(index) = self.given.iter().position(|flag| flag.key == key) else {
            return vec![self.clone()];
        };
        let (name, values) = self.given[index].text.split_at(self.given[index].value);
        let one = |value: &str| {
            let mut source = self.clone();
            source.given[index].text = format!("{name}{value}");
            source
        };
        values.split(',').map(one).collect()
    }

    /// The same with one of the flags of `key`, for each time that it is given.
    #[cfg(feature = "lab")]
    pub(crate) fn each_flag(&self, key: &str) -> Vec<Self> {
        let of_key: Vec<_> = (0..self.given.len()).filter(|i| self.given[*i].key == key).collect();
        let one = |kept: &usize| {
            let mut source = self.clone();
            let mut index = 0..;
            source.given.retain(|flag| index.next() == Some(*kept) || flag.key != key);
            source
        };
        if of_key.is_empty() { vec![self.clone()] } else { of_key.iter().map(one).collect() }
    }

    /// The same flags over the keys of a design file, if one is given.
    pub(crate) fn with_design(&self, path: Option<&Path>) -> Result<Self, Failure> {
        let mut source = self.clone();
        if let Some(path) = path {
            let text =
                design::load(path).map_err(|wrong| Failure::because(wrong.message, &wrong.help))?;
            source = source.with_text(path, text);
        }
        Ok(source)
    }

    /// The same flags over the keys of `text`, the design file at `path`.
    pub(crate) fn with_text(mut self, path: &Path, text: String) -> Self {
        self.file = Some((path.to_owned(), text));
        self
    }

    /// The values of the file and the flags. A flag stands for the file's entry of its key.
    pub(crate) fn parse(&self) -> Parsed<'_> {
        let mut parsed =
            Parsed { source: self, places: Vec::new(), entries: Vec::new(), found: Vec::new() };
        if !ENTRIES.admits(self.given.len()) {
            parsed.found.push(Diagnostic {
                code: LARGE,
                key: String::new(),
                place: None,
                message: ENTRIES.exceeded("the command line", self.given.len()),
                help: ENTRIES.fix.to_owned(),
            });
            return parsed;
        }
        if let Some((_, text)) = &self.file {
            let (entries, found) = design::read(text, &mut |range| parsed.place(Spot::File(range)));
            let stands = |key: &str| self.given.iter().all(|flag| !overrides(&flag.key, key));
            parsed.entries.extend(entries.into_iter().filter(|entry| stands(&entry.key)));
            // Invalid TOML is always reported, even if flags override its keys.
            let kept = |wrong: &Diagnostic| wrong.code == design::SYNTAX || stands(&wrong.key);
            parsed.found.extend(found.into_iter().filter(kept));
        }
        for (index, flag) in self.given.iter().enumerate() {
            let value = &flag.text[flag.value..];
            let key_range = if flag.value > 0 { 0..flag.value - 1 } else { 0..value.len() };
            let key_place = parsed.place(Spot::Flag(index, key_range));
            let mut place = |range: Range<usize>| {
                let range = flag.value + range.start..flag.value + range.end;
                parsed.place(Spot::Flag(index, range))
            };
            match parse(&flag.key, value, &mut place) {
                Ok(value) => {
                    parsed.entries.push(Entry { key: flag.key.clone(), place: key_place, value });
                }
                Err(mut diagnostic) => {
                    if ["--param", "--plant"].contains(&flag.name.as_str()) {
                        let told = format!("; the flag is {} NAME=VALUE", flag.name);
                        diagnostic.help.push_str(&told);
                    }
                    parsed.found.push(diagnostic);
                }
            }
        }
        design::with_files(&mut parsed.entries, &|entry| self.file_of(entry));
        parsed
    }
}

impl Parsed<'_> {
    fn place(&mut self, spot: Spot) -> Place {
        self.places.push(spot);
        Place(self.places.len() - 1)
    }

    /// The spec of the file and the flags.
    pub(crate) fn read(&self) -> Result<Spec, Failure> {
        self.read_with_plant().map(|(spec, _)| spec)
    }

    /// The same with the plant, if the design has one.
    pub(crate) fn read_with_plant(&self) -> Result<(Spec, Option<Plant>), Failure> {
        self.read_by(plant::read_design)
    }

    /// The same of a controller that runs, whose duration may be given where the code leaves it open.
    #[cfg(feature = "lab")]
    pub(crate) fn read_run(&self) -> Result<(Spec, Option<Plant>), Failure> {
        self.read_by(plant::read_run)
    }

    fn read_by(
        &self,
        read: impl Fn(&[Entry]) -> Result<(Spec, Option<Plant>), Vec<Diagnostic>>,
    ) -> Result<(Spec, Option<Plant>), Failure> {
        match read(&self.entries) {
            Ok(both) => self.finish(Some(both), Vec::new()),
            Err(found) => self.finish(None, found),
        }
    }

    /// `value`, unless something given was wrong or `found` holds a mistake.
    pub(crate) fn finish<T>(&self, value: Option<T>, found: Vec<Diagnostic>) -> Result<T, Failure> {
        let all = mistakes(&self.found, &self.entries, found);
        match value {
            Some(value) if all.is_empty() => Ok(value),
            _ => {
                let internal = all.iter().any(|d| d.code == INTERNAL);
                let refused = !all.is_empty() && all.iter().all(Diagnostic::refuses);
                let notices = all.iter().map(|d| self.notice(d)).collect();
                let exit = if internal {
                    Exit::Internal
                } else if refused {
                    Exit::Failed
                } else {
                    Exit::BadInput
                };
                Err(Failure { exit, notices })
            }
        }
    }

    /// A diagnostic of the library in terms of what was given.
    fn notice(&self, diagnostic: &Diagnostic) -> Notice {
        let key = root(&diagnostic.key);
        let known = diagnostic.place.and_then(|place| self.places.get(place.0));
        let spot = known.or_else(|| {
            let entry = self.entries.iter().find(|entry| entry.key == key)?;
            self.places.get(entry.place.0)
        });
        let mut help = diagnostic.help.clone();
        // Where its number of values matters, the help has an example of its own.
        if let ("missing-key", Some(info), false) =
            (diagnostic.code, KeyInfo::find(key), help.contains(&format!("{key} = ")))
        {
            let example = match self.source.file.is_some() {
                true => format!("{key} = {}", design::written(info)),
                false => format!("{} {}", flag(key), quoted(info.example)),
            };
            help.push_str(&format!(", for example {example}"));
        }
        if self.source.file.is_none() {
            help = help.replace(&format!("{key} = ["), &format!("{}=[", flag(key)));
        }
        Notice {
            code: Some(diagnostic.code),
            title: diagnostic.message.clone(),
            quote: spot.and_then(|spot| self.quote(spot, label(diagnostic.code))),
            notes: Vec::new(),
            help: Some(help),
            ..Notice::default()
        }
    }

    fn quote(&self, spot: &Spot, label: &'static str) -> Option<Quote> {
        match spot {
            Spot::File(range) => {
                let (path, text) = self.source.file.as_ref()?;
                let quote = design::Quote::new(text, range.clone());
                let file = Some((path.display().to_string(), quote.line));
                Some(Quote { file, text: quote.text, range: quote.range, label })
            }
            Spot::Flag(index, range) => {
                let Flag { name, text, .. } = self.source.given.get(*index)?;
                let before = name.len() + 2;
                // A value is quoted on one line, whatever it holds; the bytes keep their places.
                let line = format!("{name} \"{text}\"").replace(['\n', '\r', '\t'], " ");
                let quote = design::Quote::new(&line, before + range.start..before + range.end);
                Some(Quote { file: None, text: quote.text, range: quote.range, label })
            }
        }
    }
}

/// Returns the label of the underlined text.
fn label(code: &str) -> &'static str {
    match code {
        "syntax" | "toml" => "this does not fit here",
        "unknown-family" => "no such family",
        "unknown-parameter" => "no such parameter",
        "unknown-key" => "no such key",
        "unknown-table" => "no such table",
        "bad-value" => "not legal",
        _ => "here",
    }
}
