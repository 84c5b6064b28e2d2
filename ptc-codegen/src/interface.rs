//! Interface for other programs: a design from its text, its files, and its mistakes.

use std::fmt;
use std::ops::Range;

use crate::accepted::Accepted;
use crate::check::examine::examine;
use crate::design::{self, Quote};
use crate::diagnostic::{Diagnostic, Place};
use crate::emit::{File, Language, Project};
use crate::internal::guarded;
use crate::plant;

/// A design that the checks accept.
///
/// ```
/// use ptc_codegen::{Design, Language, Project};
///
/// let text = "
///     name = \"roll\"
///     n = 2
///     mu = \"exp(a=1)\"
///     poles = [-4, -5]
///     [params]
///     tau = 0.8
///     t0 = 0
///     eps = 0.01
///     u_max = inf
/// ";
/// let design = Design::read(text)?;
/// for file in design.files(Language::Rust)? {
///     println!("{}: {} lines", file.name, file.text.lines().count());
/// }
/// assert!(design.project(Project::Cmake)?.iter().any(|file| file.name == "CMakeLists.txt"));
/// # Ok::<(), ptc_codegen::Mistakes>(())
/// ```
#[derive(Clone, Debug)]
pub struct Design(Accepted);

impl Design {
    /// Reads and checks the text of a design file, TOML.
    ///
    /// # Errors
    /// Every mistake in it, or every check that refuses it.
    pub fn read(text: &str) -> Result<Self, Mistakes> {
        let mut places: Vec<Range<usize>> = Vec::new();
        let (entries, found) = design::read(text, &mut |range| {
            places.push(range);
            Place(places.len() - 1)
        });
        let told = |found| Mistakes::new(found, text, &places);
        let spec = match plant::read_design(&entries) {
            Ok((spec, _)) if found.is_empty() => spec,
            Ok(_) => return Err(told(design::mistakes(&found, &entries, Vec::new()))),
            Err(more) => return Err(told(design::mistakes(&found, &entries, more))),
        };
        let report = guarded(|| examine(&spec)).map_err(|fault| told(vec![fault.into()]))?;
        Accepted::of(report).map(Self).map_err(told)
    }

    /// Its source files.
    ///
    /// # Errors
    /// Everything in the design that this language cannot express.
    pub fn files(&self, language: Language) -> Result<Vec<File>, Mistakes> {
        self.0.files(language, &[]).map_err(Mistakes::of_design)
    }

    /// The source of its self-test in C, which a target compiles beside the controller, and its header.
    ///
    /// # Errors
    /// Fails if the design has no self-test.
    pub fn selftest(&self) -> Result<Vec<File>, Mistakes> {
        self.0.selftest().map_err(Mistakes::of_design)
    }

    /// The files of a small project around it, by their paths in it.
    ///
    /// # Errors
    /// Everything in the design that a self-contained file cannot have.
    pub fn project(&self, project: Project) -> Result<Vec<File>, Mistakes> {
        self.0.project(project).map_err(Mistakes::of_design)
    }
}

/// One mistake in a design, with what is legal and the likely fix.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Mistake {
    /// Number of its line in the text, from 1; `None` for what is missing, and for checks.
    pub line: Option<usize>,
    /// Stable short name of the kind of mistake, for example `unknown-family`.
    pub code: &'static str,
    /// The key that is wrong, for example `mu.a`.
    pub key: String,
    /// The mistake, with the bad value.
    pub message: String,
    /// The legal values, and the likely fix.
    pub help: String,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        write!(f, "{}: {}; {}", self.key, self.message, self.help)
    }
}

/// Every mistake in a design: at least one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistakes(Vec<Mistake>);

impl Mistakes {
    /// They, in the order of the keys.
    pub fn list(&self) -> &[Mistake] {
        &self.0
    }

    fn new(found: Vec<Diagnostic>, text: &str, places: &[Range<usize>]) -> Self {
        let line = |place: Place| Some(Quote::new(text, places.get(place.0)?.clone()).line);
        let mistake = |Diagnostic { code, key, place, message, help }| {
            let line = place.and_then(line);
            Mistake { line, code, key, message, help }
        };
        Self(found.into_iter().map(mistake).collect())
    }

    /// Creates the mistakes of a design that was read before, which belong to no single line.
    fn of_design(found: Vec<Diagnostic>) -> Self {
        Self::new(found, "", &[])
    }
}

impl fmt::Display for Mistakes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, mistake) in self.0.iter().enumerate() {
            if index > 0 {
                writeln!(f)?;
            }
            mistake.fmt(f)?;
        }
        Ok(())
    }
}

impl std::error::Error for Mistakes {}
