//! A random design as its lines, so that one can be left out, changed or spelled otherwise.

use std::fmt::Write as _;

use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::design::read;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::plant::read_design;
use ptc_codegen::request::Spec;

/// The table of parameters of a design file.
pub(super) const PARAMS: &str = "params";

/// The table of the plant of a design file.
pub(super) const PLANT: &str = "plant";

/// The table of the model of a design file.
pub(super) const MODEL: &str = "model";

/// The value of a key.
#[derive(Clone, Debug)]
pub(super) enum Value {
    /// As a file has it.
    Plain(String),
    /// An expression.
    Formula(String),
    /// Several of them.
    Formulas(Vec<String>),
}

impl Value {
    /// The value in which `spelling` replaces every expression.
    pub(super) fn spelled(&self, spelling: &mut dyn FnMut(&str) -> String) -> Self {
        match self {
            Self::Plain(_) => self.clone(),
            Self::Formula(text) => Self::Formula(spelling(text)),
            Self::Formulas(all) => Self::Formulas(all.iter().map(|text| spelling(text)).collect()),
        }
    }

    pub(super) fn text(&self) -> String {
        let quoted = |text: &String| format!("\"{text}\"");
        match self {
            Self::Plain(text) => text.clone(),
            Self::Formula(text) => quoted(text),
            Self::Formulas(all) => {
                format!("[{}]", all.iter().map(quoted).collect::<Vec<_>>().join(", "))
            }
        }
    }
}

/// A key with its value.
#[derive(Clone, Debug)]
pub(super) struct Line {
    /// Its table, empty for the keys above all tables.
    pub(super) table: &'static str,
    pub(super) key: &'static str,
    pub(super) value: Value,
}

/// A design.
#[derive(Clone, Debug)]
pub(super) struct Design {
    pub(super) name: String,
    /// Description of its kind, in a few words.
    pub(super) kind: &'static str,
    pub(super) lines: Vec<Line>,
    /// The names of the states, as `[verify]` has them.
    pub(super) states: Vec<String>,
    /// Number of further states of the plant, which start at 0.
    pub(super) hidden: usize,
    /// Largest |x| at the start.
    pub(super) x0_max: Vec<f64>,
    /// The state at the start of a run, within it.
    pub(super) x0: Vec<f64>,
}

impl Design {
    /// The design file.
    pub(super) fn text(&self) -> String {
        let mut text = format!("name = \"{}\"\n", self.name);
        for table in ["", PARAMS, MODEL, PLANT] {
            let own: Vec<_> = self.lines.iter().filter(|line| line.table == table).collect();
            if !own.is_empty() && !table.is_empty() {
                let _ = writeln!(text, "[{table}]");
            }
            for line in own {
                let _ = writeln!(text, "{} = {}", line.key, line.value.text());
            }
        }
        text
    }

    /// Returns true if it gives a key.
    pub(super) fn gives(&self, key: &str) -> bool {
        self.lines.iter().any(|line| line.key == key)
    }

    /// Samples from the call to the input that acts.
    pub(super) fn delay(&self) -> usize {
        self.text_of("delay").and_then(|text| text.parse().ok()).unwrap_or(0)
    }

    /// The value of a key, as a file has it.
    pub(super) fn text_of(&self, key: &str) -> Option<String> {
        let own = |line: &&Line| line.key == key && ["", PARAMS].contains(&line.table);
        self.lines.iter().find(own).map(|line| line.value.text())
    }

    /// Returns true if the states of the plant are those of `check`: no output, reference or spring stands between.
    pub(super) fn has_own_states(&self) -> bool {
        !["states", "reference", "axes", "resonance"].iter().any(|key| self.gives(key))
    }

    /// Returns true if `step` returns an input and a status for each axis or output.
    pub(super) fn has_several_inputs(&self) -> bool {
        ["axes", "outputs"].iter().any(|key| self.gives(key))
    }

    /// The design without a key.
    pub(super) fn without(&self, key: &str) -> Self {
        let mut design = self.clone();
        design.lines.retain(|line| line.key != key);
        design
    }

    /// The design with every expression replaced.
    pub(super) fn spelled(&self, spelling: &mut dyn FnMut(&str) -> String) -> Self {
        let mut design = self.clone();
        for line in &mut design.lines {
            line.value = line.value.spelled(spelling);
        }
        design
    }

    /// The request.
    ///
    /// # Errors
    /// The first mistake in it.
    pub(super) fn spec(&self) -> Result<Spec, String> {
        let (entries, found) = read(&self.text(), &mut |_| Place(0));
        if let Some(first) = found.first() {
            return Err(first.message.clone());
        }
        let read = read_design(&entries).map(|(spec, _)| spec);
        read.map_err(|found| found.first().map_or_else(String::new, |first| first.message.clone()))
    }

    /// Returns the report of the checks; `None` where it cannot be read.
    pub(super) fn report(&self) -> Option<Report> {
        Some(examine(&self.spec().ok()?))
    }
}
