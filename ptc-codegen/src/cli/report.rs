//! Messages on the standard error.

use std::io::{IsTerminal, Write};
use std::ops::Range;

use crate::diagnostic::{visible, visible_line};
use crate::internal::{INTERNAL, Internal};
#[cfg(feature = "lab")]
use crate::simulate::{self, Cause};

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

/// Meanings of the exit codes, in every subcommand.
const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  a check refuses the design, an objective fails, or --check finds files that differ
  2  bad input, or a place that cannot be read or written
  3  undecided: nothing fails, but a check or an objective cannot be decided
  70 a fault of this program
  130 interrupted";

/// The end of a help text, with the exit codes.
pub(crate) fn with_exit_codes(examples: &str) -> String {
    format!("{examples}\n\n{EXIT_CODES}")
}

/// Why a command does not end with 0, the exit code of success.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum Exit {
    /// A check refuses the design, an objective fails, or files differ.
    Failed = 1,
    /// The input is wrong, or a place cannot be read or written.
    BadInput = 2,
    /// Nothing fails, but not everything could be decided.
    Undecided = 3,
    /// A fault of this program.
    Internal = 70,
    /// An interrupted search, which ends with what it has.
    #[cfg(feature = "lab")]
    Interrupted = 130,
}

/// Why the command did not succeed.
#[derive(Debug)]
pub(crate) struct Failure {
    /// The exit code.
    pub(crate) exit: Exit,
    /// All messages.
    pub(crate) notices: Vec<Notice>,
}

impl Failure {
    /// The input is wrong.
    pub(crate) fn bad_input(notices: Vec<Notice>) -> Self {
        Self { exit: Exit::BadInput, notices }
    }

    /// `--check` found files that are not what would be written.
    pub(crate) fn drift(notices: Vec<Notice>) -> Self {
        Self { exit: Exit::Failed, notices }
    }

    /// A check refuses the design, or an objective fails.
    pub(crate) fn refused(notices: Vec<Notice>) -> Self {
        Self { exit: Exit::Failed, notices }
    }

    /// Nothing fails, but not everything could be decided.
    pub(crate) fn undecided(notices: Vec<Notice>) -> Self {
        Self { exit: Exit::Undecided, notices }
    }

    /// The user interrupted a search, which found nothing by then.
    #[cfg(feature = "lab")]
    pub(crate) fn interrupted(notices: Vec<Notice>) -> Self {
        Self { exit: Exit::Interrupted, notices }
    }

    /// The generator itself is at fault.
    pub(crate) fn internal(fault: &Internal) -> Self {
        let help = Some(Internal::HELP.to_owned());
        let code = Some(INTERNAL);
        let notice = Notice { code, help, ..Notice::of(fault.to_string()) };
        Self { exit: Exit::Internal, notices: vec![notice] }
    }

    /// One thing went wrong that no flag's value is to blame for.
    pub(crate) fn because(title: String, help: &str) -> Self {
        let notice = Notice { help: Some(help.to_owned()), ..Notice::of(title) };
        Self::bad_input(vec![notice])
    }
}

#[cfg(feature = "lab")]
impl From<simulate::Failure> for Failure {
    fn from(failure: simulate::Failure) -> Self {
        let notice = Notice { help: Some(failure.help), ..Notice::of(failure.message) };
        match failure.cause {
            Cause::Input => Self::bad_input(vec![notice]),
            Cause::Range => Self::refused(vec![notice]),
            Cause::Unfinished => Self::undecided(vec![notice]),
        }
    }
}

/// One thing that is wrong.
#[derive(Clone, Debug, Default)]
pub(crate) struct Notice {
    /// Stable short name.
    pub(crate) code: Option<&'static str>,
    /// Description of the error.
    pub(crate) title: String,
    /// The place in the command line or the design file.
    pub(crate) quote: Option<Quote>,
    /// Details.
    pub(crate) notes: Vec<String>,
    /// Legal values, and the likely fix.
    pub(crate) help: Option<String>,
    /// True if the command goes on all the same.
    pub(crate) warns: bool,
}

impl Notice {
    /// A notice that is a title only.
    pub(crate) fn of(title: String) -> Self {
        Self { title, ..Self::default() }
    }

    /// The same with what it quotes of inputs and paths written out where it could not be seen.
    fn visible(&self) -> Self {
        let text = |text: &String| visible(text).into_owned();
        // A line of the title is ours, so that no input can add one.
        let title = visible_line(&self.title);
        Self {
            code: self.code,
            title,
            quote: self.quote.as_ref().map(Quote::visible),
            notes: self.notes.iter().map(text).collect(),
            help: self.help.as_ref().map(text),
            warns: self.warns,
        }
    }
}

/// A line with a part underlined: a flag with its value, or a line of a file.
#[derive(Clone, Debug)]
pub(crate) struct Quote {
    /// The file and the number of the line in it, if it is one of a file.
    pub(crate) file: Option<(String, usize)>,
    /// The line.
    pub(crate) text: String,
    /// The underlined bytes of the line.
    pub(crate) range: Range<usize>,
    /// Text at the line.
    pub(crate) label: &'static str,
}

/// Prints a line that nothing has to be done about.
pub(crate) fn note(text: &str) {
    // If the standard error is closed, there is nowhere to report it.
    let _ = writeln!(std::io::stderr(), "note: {}", visible(text));
}

impl Quote {
    fn visible(&self) -> Self {
        let Range { start, end } = self.range;
        let part = |range: Range<usize>| visible(self.text.get(range).unwrap_or_default());
        let (before, marked, after) =
            (part(0..start), part(start..end), part(end..self.text.len()));
        let file = self.file.as_ref();
        Self {
            file: file.map(|(path, line)| (visible_line(path), *line)),
            text: format!("{before}{marked}{after}"),
            range: before.len()..before.len() + marked.len(),
            label: self.label,
        }
    }
}

/// Prints the notices.
pub(crate) fn print(notices: &[Notice]) {
    let mut stderr = std::io::stderr().lock();
    let plain = !stderr.is_terminal()
        || std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
        || std::env::var_os("TERM").is_some_and(|value| value == "dumb");
    let renderer = if plain { Renderer::plain() } else { Renderer::styled() };
    for notice in notices {
        let notice = &notice.visible();
        // If the standard error is closed, there is nowhere to report it.
        let _ = writeln!(stderr, "{}\n", renderer.render(&[group(notice)]));
    }
}

/// Prints text that is not a notice of this program's.
pub(crate) fn print_text(text: &str) {
    // If the standard error is closed, there is nowhere to report it.
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

fn group(notice: &Notice) -> Group<'_> {
    let level = if notice.warns { Level::WARNING } else { Level::ERROR };
    let mut title = level.primary_title(notice.title.as_str());
    if let Some(code) = notice.code {
        title = title.id(code);
    }
    let mut group = Group::with_title(title);
    if let Some(quote) = &notice.quote {
        let mark = AnnotationKind::Primary.span(quote.range.clone()).label(quote.label);
        let snippet = Snippet::source(quote.text.as_str()).annotation(mark);
        group = group.element(match &quote.file {
            Some((path, line)) => snippet.path(path.as_str()).line_start(*line),
            None => snippet.line_numbering(false),
        });
    }
    let notes = notice.notes.iter().map(|note| Level::NOTE.message(note.as_str()));
    let help = notice.help.iter().map(|help| Level::HELP.message(help.as_str()));
    group.elements(notes.chain(help))
}

/// A value as it is typed in a shell.
pub(crate) fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "_-.,".contains(c);
    if text.chars().all(plain) { text.to_owned() } else { format!("\"{text}\"") }
}
