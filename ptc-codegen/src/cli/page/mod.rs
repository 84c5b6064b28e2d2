//! The report of a run: one self-contained page of HTML.

mod budget;
mod card;
mod class;
mod curve;
mod design;
mod formulas;
mod svg;
mod worst;

use std::path::Path;

use crate::accepted::Accepted;
use crate::check::examine::Report;
use crate::diagnostic::{parts, visible, visible_line};
use crate::emit::{File, Language};
use crate::plant::Plant;
use crate::request::Spec;
use askama::Template;

use super::mathml::{Math, display, inline};
use super::report::Failure;
use super::source::Source;
use budget::Bar;
pub use card::{Shown, card};
use class::{colour, concluded};
use design::{Fact, Known};
pub(crate) use design::{command, reporting, short};
use formulas::Group;
pub(crate) use svg::Svg;
use worst::Drawn;

/// A table with a head.
#[derive(Default)]
pub(crate) struct Table {
    pub(crate) head: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Table {
    /// Returns true if all cells of a column begin with a letter; the others are numbers, which are aligned right.
    fn of_words(&self, column: usize) -> bool {
        self.rows
            .iter()
            .all(|row| row.get(column).is_some_and(|cell| cell.starts_with(char::is_alphabetic)))
    }
}

/// Section of the page on a run of the closed loop.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    /// Sentences before all else.
    pub(crate) told: Vec<String>,
    /// Verdicts, one by one.
    pub(crate) verdicts: Vec<Judged>,
    /// The caption of the figure.
    pub(crate) caption: String,
    pub(crate) figure: Svg,
    pub(crate) table: Table,
    /// Further parts, each under its own title.
    pub(crate) parts: Vec<Part>,
}

/// A part of a section.
pub(crate) struct Part {
    pub(crate) title: &'static str,
    pub(crate) told: Vec<String>,
    pub(crate) charts: Vec<Svg>,
    pub(crate) table: Table,
}

/// Something that holds, fails, or is not known.
pub(crate) struct Judged {
    /// Name by which it is found elsewhere; empty where it is nowhere.
    pub(crate) name: String,
    pub(crate) what: Math,
    /// The class of its verdict: good, bad or open.
    pub(crate) colour: &'static str,
    pub(crate) verdict: String,
    pub(crate) details: Vec<String>,
}

/// Contents of a report.
pub(crate) struct Content<'a> {
    pub(crate) spec: &'a Spec,
    /// Results of the checks.
    pub(crate) report: &'a Report,
    pub(crate) plant: &'a Plant,
    pub(crate) source: &'a Source,
    /// The command that makes the report again.
    pub(crate) command: String,
    pub(crate) section: Section,
}

#[derive(Template)]
#[template(path = "report.html", escape = "html")]
struct Page<'a> {
    title: String,
    facts: Vec<Fact>,
    known: Vec<Known>,
    command: &'a str,
    /// Its file, and the text in parts: what would change how the rest is seen is marked.
    design: Option<(String, Vec<Result<&'a str, char>>)>,
    groups: Vec<Group>,
    report: &'a Report,
    budget: Vec<Bar>,
    worst: Option<Drawn>,
    charts: Vec<Svg>,
    section: &'a Section,
    files: Vec<File>,
    /// Why there is no code.
    refused: Vec<String>,
    version: &'static str,
}

/// The file of a report, if there is one, is named as such.
///
/// # Errors
/// A path that does not end in .html.
pub(crate) fn named(asked: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = asked.filter(|path| path.as_os_str() != "-") else { return Ok(()) };
    match path.extension().map(std::ffi::OsStr::to_ascii_lowercase) {
        Some(extension) if extension == "html" => Ok(()),
        _ => Err(Failure::because(
            format!("`{}` is no name of a report", path.display()),
            "a report is a page of HTML: give a file that ends in .html, for example --report run.html",
        )),
    }
}

/// The page as text: the same input gives the same bytes.
///
/// # Errors
/// Closed forms that an engine does not give.
pub(crate) fn html(content: &Content<'_>) -> Result<String, Failure> {
    let Content { spec, report, plant, source, command, section } = content;
    let emitted = Report { spec: report.spec.clone().apart(), ..Report::clone(report) };
    let code = Accepted::of(emitted).and_then(|own| own.files(Language::C, &[]));
    let (files, refused) = match code {
        Ok(files) => (files, Vec::new()),
        Err(found) => {
            let told = found.iter().map(|wrong| format!("{}; {}", wrong.message, wrong.help));
            (Vec::new(), told.collect())
        }
    };
    // Texts of the user's show what they hold.
    let command = &visible(command);
    let design = source.text().map(|text| (visible_line(&design::file(spec)), parts(text)));
    let page = Page {
        title: format!("{}: {}", spec.name(), section.title.to_lowercase()),
        facts: design::facts(report),
        known: design::known(&report.spec, plant),
        command,
        design,
        groups: formulas::groups(report, plant)?,
        budget: budget::bars(report),
        worst: worst::drawn(report)?,
        charts: curve::charts(report)?,
        report,
        section,
        files,
        refused,
        version: env!("CARGO_PKG_VERSION"),
    };
    page.render().map_err(|error| {
        Failure::because(format!("the report cannot be written: {error}"), "leave --report out")
    })
}
