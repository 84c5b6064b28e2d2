//! Running a range of scenarios so that it can be interrupted, and putting parts together.

use std::fmt::Display;
use std::fs::File;
use std::io::{self, Seek};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::verify::record::{self, Row, Writer};
use crate::verify::{Campaign, Drawn, Trial, chunks, sample};

use super::journal::{Journal, SUFFIX};

use crate::cli::output::{
    Kind, Outputs, Place, commit, nameless, open_beside, through, with_suffix,
};
use crate::cli::progress::progress;
use crate::cli::report::{Failure, Notice};

/// Destination of the rows.
pub(super) struct Rows {
    out: Place,
    /// The journal's file; `None` if `out` is not a regular file.
    journal: Option<PathBuf>,
}

impl Rows {
    /// Plans the file of the rows, and the one that is there until the verdict is.
    pub(super) fn plan(
        outputs: &mut Outputs,
        path: Option<&Path>,
    ) -> Result<Option<Self>, Failure> {
        let Some(path) = path else { return Ok(None) };
        let out = outputs.file("--out", path)?;
        if out.is_stream() {
            return Ok(Some(Self { out, journal: None }));
        }
        // Beside the file itself, where it is given by a link.
        let is_link = path.symlink_metadata().is_ok_and(|there| there.is_symlink());
        let journal = with_suffix(if is_link { &out.path } else { path }, SUFFIX);
        outputs.reserve("the rows under way", &journal)?;
        Ok(Some(Self { out, journal: Some(journal) }))
    }

    fn open(&self, campaign: &Campaign, range: &Range<u64>) -> Result<Journal, Failure> {
        let Some(path) = &self.journal else {
            let nameless = Journal::nameless(campaign, range);
            return nameless.map_err(|error| write_failed(&self.out.shown, &error));
        };
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|error| write_failed(path, &error))?;
        }
        Journal::open(path, campaign, range)
    }
}

/// Runs the scenarios of `range`. With `out` every chunk that is done is kept in a journal, which the
/// caller ends once the verdict is printed, and is not run again.
pub(super) fn run(
    campaign: &Campaign,
    trial: &Trial,
    range: Range<u64>,
    out: Option<&Rows>,
) -> Result<(Drawn, Option<Journal>), Failure> {
    let journal = out.map(|rows| rows.open(campaign, &range)).transpose()?;
    let all = chunks(range.clone());
    let is_done = |chunk: &Range<u64>| journal.as_ref().is_some_and(|journal| journal.has(chunk));
    let left: Vec<_> = all.iter().filter(|chunk| !is_done(chunk)).cloned().collect();
    let bar = progress("running", range.end - range.start);
    let length = |chunks: &[Range<u64>]| chunks.iter().map(|c| c.end - c.start).sum::<u64>();
    bar.inc(length(&all) - length(&left));
    let total = Mutex::new(Drawn::new(campaign));
    sample(campaign, trial, &left, &|chunk, rows| {
        bar.inc(chunk.end - chunk.start);
        if let (Some(journal), Some(out)) = (&journal, out) {
            let path = out.journal.as_ref().unwrap_or(&out.out.shown);
            return journal.keep(chunk, &rows).map_err(|error| write_failed(path, &error));
        }
        let mut drawn = Drawn::new(campaign);
        rows.iter().for_each(|row| drawn.add(campaign, row));
        let mut total = total.lock().unwrap_or_else(PoisonError::into_inner);
        *total = std::mem::replace(&mut *total, Drawn::new(campaign)).merge(&drawn);
        Ok(())
    })?;
    bar.finish_and_clear();
    let (Some(journal), Some(out)) = (journal, out) else {
        return Ok((total.into_inner().unwrap_or_else(PoisonError::into_inner), None));
    };
    let drawn = write(campaign, Some(out), &mut |put| {
        for chunk in &all {
            let path = out.journal.as_ref().unwrap_or(&out.out.shown);
            let rows = journal.rows(chunk).map_err(|error| unread(path, &error))?;
            rows.into_iter().try_for_each(&mut *put).map_err(|error| unread(path, &error))?;
        }
        Ok(())
    })?;
    Ok((drawn, Some(journal)))
}

/// Puts the parts of a run together, in whatever order they are given.
pub(super) fn merge(
    campaign: &Campaign,
    parts: &[PathBuf],
    out: Option<&Rows>,
) -> Result<(Drawn, Option<Journal>), Failure> {
    let mut found = Vec::new();
    for path in parts {
        let extent = record::extent(path, campaign).map_err(|error| unread(path, &error))?;
        if !extent.is_empty() {
            found.push((extent, path));
        }
    }
    found.sort_by_key(|(extent, _)| extent.start);
    let mut next = 0;
    for (extent, path) in &found {
        if extent.start < next {
            return Err(Failure::because(
                format!(
                    "{} holds scenario {}, which another part holds too",
                    path.display(),
                    extent.start
                ),
                "give each part once, all of one division into parts",
            ));
        }
        if extent.start > next {
            return Err(missing(next..extent.start));
        }
        next = extent.end;
    }
    if next < campaign.scenarios {
        return Err(missing(next..campaign.scenarios));
    }
    // No other run writes to the same file meanwhile.
    let journal = out.map(|out| out.open(campaign, &(0..campaign.scenarios))).transpose()?;
    let drawn = write(campaign, out, &mut |put| {
        let mut next = 0;
        for (_, path) in &found {
            let done = record::read(path, campaign, &mut |row| {
                if row.index != next {
                    let message = format!("found scenario {}, expected {next}", row.index);
                    return Err(parquet::errors::ParquetError::General(message));
                }
                next += 1;
                put(row)
            });
            done.map_err(|error| unread(path, &error))?;
        }
        Ok(())
    })?;
    Ok((drawn, journal))
}

fn missing(range: Range<u64>) -> Failure {
    Failure::because(
        format!("no part holds the scenarios {} to {}", range.start, range.end - 1),
        "give all parts: --merge part1.parquet part2.parquet ..., or run again those that failed",
    )
}

/// Takes a row.
type Put<'a> = dyn FnMut(Row) -> parquet::errors::Result<()> + 'a;

/// Tallies the rows that `give` hands over in their order, and writes them to `to`: a file is in its
/// place as a whole.
fn write(
    campaign: &Campaign,
    to: Option<&Rows>,
    give: &mut dyn FnMut(&mut Put<'_>) -> Result<(), Failure>,
) -> Result<Drawn, Failure> {
    let mut drawn = Drawn::new(campaign);
    let Some(Rows { out, .. }) = to else {
        give(&mut |row| {
            drawn.add(campaign, &row);
            Ok(())
        })?;
        return Ok(drawn);
    };
    let failed = |error: &dyn Display| write_failed(&out.shown, error);
    let mut into = |file: &File, drawn: &mut Drawn| -> Result<(), Failure> {
        let mut writer = Writer::new(file, campaign).map_err(|error| failed(&error))?;
        give(&mut |row| {
            drawn.add(campaign, &row);
            writer.push(row)
        })?;
        writer.finish().map(|_| ()).map_err(|error| failed(&error))
    };
    // What is there now counts, not what was there when it was planned.
    let place = Place::of(&out.shown).map_err(|error| failed(&error))?;
    match place.kind {
        Kind::Missing | Kind::Regular(_) => {
            let temporary = open_beside(&place).map_err(|error| failed(&error))?;
            let file = temporary.file().map_err(|error| failed(&error))?;
            into(file, &mut drawn)?;
            commit(vec![(temporary, place.path)]).map_err(|(_, error)| failed(&error))?;
        }
        _ if place.is_stream() => {
            let mut file = nameless().map_err(|error| failed(&error))?;
            into(&file, &mut drawn)?;
            let copied = file.rewind().and_then(|()| through(&place, &mut file));
            copied.map_err(|error| failed(&error))?;
        }
        _ => return Err(failed(&io::Error::from(io::ErrorKind::IsADirectory))),
    }
    Ok(drawn)
}

fn unread(path: &Path, error: &dyn Display) -> Failure {
    let error = error.to_string();
    let error = error.strip_prefix("Parquet error: ").unwrap_or(&error);
    Failure::bad_input(vec![Notice {
        help: Some(
            "give files that `verify --out` wrote for this design, scenarios and seed".to_owned(),
        ),
        ..Notice::of(format!("cannot use {}: {error}", path.display()))
    }])
}

fn write_failed(path: &Path, error: &dyn Display) -> Failure {
    Failure::bad_input(vec![Notice {
        help: Some("give a file in a folder that can be written with --out".to_owned()),
        ..Notice::of(format!("cannot write {}: {error}", path.display()))
    }])
}
