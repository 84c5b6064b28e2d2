//! A design on a card: summary, picture and verdicts as a fragment of HTML, for notebooks.

use askama::Template;

use super::class::{colour, concluded};
use super::design::{Fact, Known, facts, known};
use crate::check::examine::Report;
use crate::plant::Plant;

/// The picture of a card.
#[derive(Clone, Debug)]
pub struct Shown {
    /// A `data:` URL, so that the styles of the picture do not reach the page around it.
    pub source: String,
    /// A line below it.
    pub caption: String,
}

#[derive(Template)]
#[template(path = "card.html", escape = "html")]
struct Card<'a> {
    report: &'a Report,
    facts: Vec<Fact>,
    known: Vec<Known>,
    shown: Option<Shown>,
    /// Why there is no picture.
    problem: String,
}

/// The card of a design that was checked, with its picture or the reason why it has none: the same input gives the
/// same bytes.
///
/// # Errors
/// A text that cannot be written.
pub fn card(
    report: &Report,
    plant: &Plant,
    picture: Result<Shown, String>,
) -> Result<String, String> {
    let (shown, problem) = match picture {
        Ok(shown) => (Some(shown), String::new()),
        Err(problem) => (None, problem),
    };
    let known = known(&report.spec, plant);
    let card = Card { report, facts: facts(report), known, shown, problem };
    card.render().map_err(|error| error.to_string())
}
