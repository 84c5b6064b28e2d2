//! `new`: a design file to begin with.

use std::path::{Path, PathBuf};

use crate::design;
use crate::diagnostic::Place;
use crate::request;
use clap::Args;
use clap::builder::PossibleValuesParser;

use super::catalogue::{ENTRIES, Entry};
use super::output::{self, Outputs};
use super::report::Failure;
use super::write;

pub(crate) const EXAMPLES: &str = "\
The file is a valid design: a comment explains every key and its legal values.
With --from it is a published controller, and its head names the paper.

Examples:
  ptc-codegen new                           design.toml
  ptc-codegen new roll                      roll.toml, of a controller called roll
  ptc-codegen new -                         to the standard output
  ptc-codegen new --from power_scaling      after Song et al. 2017
  ptc-codegen new yaw --from power_scaling  the same as yaw.toml";

/// The flags of `new`.
#[derive(Debug, Args)]
pub(crate) struct New {
    /// Name of the controller, and of the file before `.toml`; `-` prints to the standard output
    #[arg(value_name = "NAME")]
    pub(crate) name: Option<String>,
    /// Start from a published controller, by its name in `list --catalogue`
    #[arg(
        long,
        value_name = "CONTROLLER",
        value_parser = PossibleValuesParser::new(ENTRIES.iter().map(|entry| entry.name)),
        hide_possible_values = true
    )]
    pub(crate) from: Option<String>,
    /// Folder to write to, made if it is missing; `-` prints to the standard output
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    pub(crate) out: PathBuf,
}

/// Runs `new`.
pub(crate) fn new(request: &New) -> Result<(), Failure> {
    let name = request.name.as_deref().filter(|name| *name != "-");
    let published = request.from.as_deref().and_then(Entry::find);
    let path = PathBuf::from(name.unwrap_or(published.map_or("design", |entry| entry.name)));
    let stem = path.file_name().and_then(|stem| stem.to_str()).unwrap_or_default();
    let stem = stem.strip_suffix(".toml").unwrap_or(stem);
    if stem.is_empty() {
        return Err(Failure::because(
            format!("`{}` names no file", path.display()),
            "give a name, for example `ptc-codegen new roll`",
        ));
    }
    // A file may be called what a controller may not; its design then leaves the name out.
    let given = name.map(|_| stem).filter(|stem| names_a_controller(stem));
    let text = match published {
        Some(entry) => entry.design(stem, given.is_some()),
        None => design::template(given),
    };
    let mut outputs = Outputs::default();
    if request.name.as_deref() == Some("-") {
        return write::to_stdout(&text);
    }
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
    write::to_stdout(&outputs.write_in(&folder, &[(&file, text)])?)
}

fn names_a_controller(name: &str) -> bool {
    let (entries, found) = design::read(&design::template(Some(name)), &mut |_| Place(0));
    found.is_empty() && request::read(&entries).is_ok()
}
