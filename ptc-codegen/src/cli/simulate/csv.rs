//! The rows of all runs as CSV, written as they are made.

use std::io::{self, BufWriter, Write};

use crate::simulate::record::Row;

use crate::cli::output::{Content, Place, Spool};
use crate::cli::report::Failure;
use crate::cli::write::failed;

/// The file of the rows.
pub(super) struct Csv {
    place: Place,
    out: BufWriter<Spool>,
    /// True if each row begins with the number of its run.
    numbered: bool,
    run: usize,
    has_head: bool,
    wrong: Option<io::Error>,
}

/// Values that the rows of a run have in common.
pub(super) struct Common<'a> {
    pub(super) tau: f64,
    /// The names of states and inputs.
    pub(super) names: &'a [Vec<String>; 2],
    /// True if the loop is sampled: only such a loop measures.
    pub(super) held: bool,
    /// Number of measured values.
    pub(super) measured: usize,
}

impl Csv {
    /// A file of no rows as yet. With `numbered` each row begins with the number of its run.
    pub(super) fn new(place: Place, numbered: bool) -> Result<Self, Failure> {
        let out =
            Spool::new(&place).map_err(|error| failed("cannot write", &place.shown, &error))?;
        let out = BufWriter::new(out);
        Ok(Self { place, out, numbered, run: 0, has_head: false, wrong: None })
    }

    /// Begins the next run.
    pub(super) fn next_run(&mut self) {
        self.run += 1;
    }

    /// Takes the next row. What fails is reported in the end.
    pub(super) fn take(&mut self, of: &Common<'_>, row: &Row) {
        if self.wrong.is_none() {
            self.wrong = self.write(of, row).err();
        }
    }

    fn write(&mut self, of: &Common<'_>, row: &Row) -> io::Result<()> {
        if !std::mem::replace(&mut self.has_head, true) {
            self.head(of)?;
        }
        if !row.reported {
            return Ok(());
        }
        if self.numbered {
            write!(self.out, "{},", self.run)?;
        }
        write!(self.out, "{:?},{:?}", of.tau, row.t)?;
        let measured = row.measured.get(..of.measured).filter(|_| of.held).unwrap_or_default();
        for value in row.x.iter().chain(&row.u).chain(measured) {
            write!(self.out, ",{value:?}")?;
        }
        if of.held {
            write!(self.out, ",{}", row.status.c_name())?;
        }
        writeln!(self.out)
    }

    /// The line above the rows: all runs are of one kind.
    fn head(&mut self, of: &Common<'_>) -> io::Result<()> {
        let mut columns = of.names.concat();
        if of.held {
            columns.extend((1..=of.measured).map(|j| format!("y{j}")));
            columns.push("status".to_owned());
        }
        let first = if self.numbered { "run," } else { "" };
        writeln!(self.out, "{first}tau,t,{}", columns.join(","))
    }

    /// The place and the content.
    ///
    /// # Errors
    /// A row could not be written.
    pub(super) fn finish(self) -> Result<(Place, Content<'static>), Failure> {
        let Self { place, out, wrong, .. } = self;
        let done = match wrong {
            Some(error) => Err(error),
            None => out.into_inner().map_err(io::IntoInnerError::into_error),
        };
        let out = done.map_err(|error| failed("cannot write", &place.shown, &error))?;
        Ok((place, Content::Spooled(out)))
    }
}
