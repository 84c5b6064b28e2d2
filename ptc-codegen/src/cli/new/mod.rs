//! `new`: a design file to begin with.

mod args;

use std::path::{Path, PathBuf};

use crate::design::{self, STARTS, Start};
use crate::diagnostic::Place;
use crate::request;

pub(crate) use args::{EXAMPLES, New};

use super::catalogue::Entry;
use super::output::{self, Outputs};
use super::report::Failure;
use super::source::Source;
use super::write;
use args::Values;

/// The design that a file starts from.
#[derive(Clone, Copy)]
enum Origin {
    Plant(&'static Start),
    Published(&'static Entry),
    All,
}

impl Origin {
    fn of(request: &New) -> Self {
        let published = request.from.as_deref().and_then(Entry::find);
        match (request.all, published) {
            (true, _) => Self::All,
            (false, Some(entry)) => Self::Published(entry),
            (false, None) => {
                let plant = request.plant.as_deref().and_then(Start::find);
                Self::Plant(plant.unwrap_or(&STARTS[0]))
            }
        }
    }

    /// Returns the name of the file where the command line has none.
    fn default_name(self, request: &New) -> &'static str {
        match self {
            Self::Published(entry) => entry.name,
            Self::Plant(start) if request.plant.is_some() => start.name,
            Self::Plant(_) | Self::All => "design",
        }
    }

    /// Returns the text of the file `stem`.toml, whose controller is called `name`, or as the origin calls it.
    fn text(self, request: &New, stem: &str, name: Option<&str>) -> Result<String, Failure> {
        match self {
            Self::Published(entry) => Ok(entry.design(stem, name.is_some())),
            Self::All => Ok(design::template(name)),
            Self::Plant(start) => started(start, &request.values, stem, name),
        }
    }
}

/// Returns the design of a plant with the values of the flags.
///
/// # Errors
/// A value is not legal in this design.
fn started(
    start: &Start,
    values: &Values,
    stem: &str,
    name: Option<&str>,
) -> Result<String, Failure> {
    let named = name.map(|name| ("name", name));
    let given = values.given().map(|(key, _, text)| (key, text));
    let text = start.design(stem, &named.into_iter().chain(given).collect::<Vec<_>>());
    // The flags are given a second time, so that errors quote them.
    let mut flags = Source::default();
    for (key, flag, text) in values.given() {
        flags.give_key(key, flag, text);
    }
    flags.with_text(Path::new(&format!("{stem}.toml")), text.clone()).parse().read_with_plant()?;
    Ok(text)
}

/// Runs `new`.
pub(crate) fn new(request: &New) -> Result<(), Failure> {
    let origin = Origin::of(request);
    let name = request.name.as_deref().filter(|name| *name != "-");
    let path = PathBuf::from(name.unwrap_or(origin.default_name(request)));
    let stem = path.file_name().and_then(|stem| stem.to_str()).unwrap_or_default();
    let stem = stem.strip_suffix(".toml").unwrap_or(stem);
    if stem.is_empty() {
        return Err(Failure::because(
            format!("`{}` names no file", path.display()),
            "give a name, for example `ptc-codegen new roll`",
        ));
    }
    // A file may be called what a controller may not; its design then has another name, or none.
    let given = name.map(|_| stem).filter(|stem| names_a_controller(stem));
    let text = origin.text(request, stem, given)?;
    if request.name.as_deref() == Some("-") {
        return write::to_stdout(&text);
    }
    let mut outputs = Outputs::default();
    let out = outputs.folder("--out", &request.out)?;
    if out.is_stream() {
        return write::to_stdout(&output::write(&[(out, text.as_bytes())])?);
    }
    let folder = request.out.join(path.parent().unwrap_or(Path::new("")));
    let file = format!("{stem}.toml");
    let there = folder.join(&file);
    if there.symlink_metadata().is_ok() {
        return Err(Failure::because(
            format!("{} is there already, and is left as it is", there.display()),
            "give another name, or `-` to print the file",
        ));
    }
    let mut told = outputs.write_in(&folder, &[(&file, text)])?;
    if let Origin::Plant(start) = origin {
        if name.is_some() && given.is_none() {
            told.push_str(&format!(
                "`{stem}` is not a legal name: the controller is {}\n",
                start.name
            ));
        }
        told.push_str(&next(start, &there, request.plant.is_none()));
    }
    write::to_stdout(&told)
}

/// Returns what to do with the file, and where no plant was chosen, which others there are.
fn next(start: &Start, file: &Path, others: bool) -> String {
    let mut told = format!("next: ptc-codegen check {}\n", file.display());
    if others {
        let names = STARTS.iter().map(|other| other.name).filter(|name| *name != start.name);
        let names = names.collect::<Vec<_>>().join(", ");
        told.push_str(&format!(
            "its plant is a {}; others: --plant {names}; every key: --all\n",
            start.name
        ));
    }
    told
}

fn names_a_controller(name: &str) -> bool {
    let (entries, found) = design::read(&design::template(Some(name)), &mut |_| Place(0));
    found.is_empty() && request::read(&entries).is_ok()
}
