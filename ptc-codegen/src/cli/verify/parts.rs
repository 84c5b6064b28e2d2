//! Running a range of scenarios so that it can be interrupted, and putting parts together.

use std::ffi::OsString;
use std::fs::{self, File};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use ptc_codegen::verify::record::{self, Row, Writer};
use ptc_codegen::verify::{Campaign, Tally, Trial, chunks, sample};

use super::{Notice, progress, unwritable};
use crate::cli::report::Failure;
use crate::cli::write;

/// Runs the scenarios of `range`. With `out` every chunk that is done is kept beside it, and is not
/// run again.
pub(super) fn run(
    campaign: &Campaign,
    trial: &Trial,
    range: Range<u64>,
    out: Option<&Path>,
) -> Result<Tally, Failure> {
    let bar = progress("running", range.end - range.start);
    let kept = out.map(|out| Kept::open(out, campaign)).transpose()?;
    let mut left = chunks(range.clone());
    if let Some(kept) = &kept {
        for chunk in std::mem::take(&mut left) {
            if kept.has(&chunk)? {
                bar.inc(chunk.end - chunk.start);
            } else {
                left.push(chunk);
            }
        }
    }
    let total = Mutex::new(Tally::new(campaign));
    sample(campaign, trial, &left, &|chunk, rows| {
        bar.inc(chunk.end - chunk.start);
        if let Some(kept) = &kept {
            return kept.keep(chunk, rows);
        }
        let mut tally = Tally::new(campaign);
        rows.iter().for_each(|row| tally.add(row));
        let mut total = total.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        *total = total.clone().merge(&tally);
        Ok(())
    })?;
    bar.finish_and_clear();
    match (kept, out) {
        (Some(kept), Some(out)) => {
            let parts: Vec<_> =
                chunks(range.clone()).iter().map(|chunk| kept.path(chunk)).collect();
            let tally = concatenate(campaign, (&parts, range), Some((out, &kept.folder)))?;
            // It holds nothing any more that `out` does not.
            let _ = fs::remove_dir_all(&kept.folder);
            Ok(tally)
        }
        _ => Ok(total.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner)),
    }
}

/// Puts the parts of a run together, in whatever order they are given.
pub(super) fn merge(
    campaign: &Campaign,
    parts: &[PathBuf],
    out: Option<&Path>,
) -> Result<Tally, Failure> {
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
    let paths: Vec<_> = found.into_iter().map(|(_, path)| path.clone()).collect();
    let all = 0..campaign.scenarios;
    let Some(out) = out else { return concatenate(campaign, (&paths, all), None) };
    let kept = Kept::open(out, campaign)?;
    let tally = concatenate(campaign, (&paths, all), Some((out, &kept.folder)))?;
    let _ = fs::remove_dir_all(&kept.folder);
    Ok(tally)
}

fn missing(range: Range<u64>) -> Failure {
    Failure::because(
        format!("no part holds the scenarios {} to {}", range.start, range.end - 1),
        "give all parts: --merge part1.parquet part2.parquet ..., or run again those that failed",
    )
}

/// Reads `parts` as they follow each other, tallies their rows, and writes them to `to`, by way of a
/// file in a folder beside it.
fn concatenate(
    campaign: &Campaign,
    (parts, range): (&[PathBuf], Range<u64>),
    to: Option<(&Path, &Path)>,
) -> Result<Tally, Failure> {
    let mut tally = Tally::new(campaign);
    let failed = |path: &Path, error: &dyn std::fmt::Display| write_failed(path, error);
    let temporary = to.map(|(_, folder)| folder.join("whole.parquet"));
    let mut writer = match &temporary {
        Some(path) => {
            let file = File::create(path).map_err(|error| failed(path, &error))?;
            Some(Writer::new(file, campaign).map_err(|error| failed(path, &error))?)
        }
        None => None,
    };
    let mut next = range.start;
    for path in parts {
        let done = record::read(path, campaign, &mut |row| {
            if row.index != next {
                let message = format!("scenario {} stands where {next} should", row.index);
                return Err(parquet::errors::ParquetError::General(message));
            }
            next += 1;
            tally.add(&row);
            writer.as_mut().map_or(Ok(()), |writer| writer.push(row))
        });
        done.map_err(|error| unread(path, &error))?;
    }
    if let (Some(writer), Some(path), Some((out, _))) = (writer, temporary, to) {
        writer.finish().map_err(|error| failed(&path, &error))?;
        fs::rename(&path, out).map_err(|error| failed(out, &error))?;
    }
    Ok(tally)
}

/// The chunks that are done, one file each in a folder beside what they become.
struct Kept<'a> {
    folder: PathBuf,
    campaign: &'a Campaign,
}

impl<'a> Kept<'a> {
    fn open(out: &Path, campaign: &'a Campaign) -> Result<Self, Failure> {
        let mut name = OsString::from(out.file_name().unwrap_or_default());
        if out.is_dir() || name.is_empty() {
            let message = format!("--out {} is no name of a file", out.display());
            return Err(Failure::because(message, "give one that ends in .parquet"));
        }
        name.push(".chunks");
        let folder = out.with_file_name(name);
        fs::create_dir_all(&folder).map_err(|error| write_failed(&folder, &error))?;
        Ok(Self { folder, campaign })
    }

    fn path(&self, chunk: &Range<u64>) -> PathBuf {
        self.folder.join(format!("{}-{}.parquet", chunk.start, chunk.end))
    }

    /// Whether a chunk is done.
    fn has(&self, chunk: &Range<u64>) -> Result<bool, Failure> {
        let path = self.path(chunk);
        if !path.exists() {
            return Ok(false);
        }
        match record::extent(&path, self.campaign) {
            Ok(extent) => Ok(extent == *chunk),
            Err(error) => Err(Failure::because(
                format!("{} holds what another run left: {error}", self.folder.display()),
                "remove this folder, or give another --out",
            )),
        }
    }

    fn keep(&self, chunk: &Range<u64>, rows: Vec<Row>) -> Result<(), Failure> {
        let path = self.path(chunk);
        let mut writer =
            Writer::new(Vec::new(), self.campaign).map_err(|error| write_failed(&path, &error))?;
        let pushed = rows.into_iter().try_for_each(|row| writer.push(row));
        let bytes = pushed.and_then(|()| writer.finish());
        let bytes = bytes.map_err(|error| write_failed(&path, &error))?;
        write::paths(&[(path, &bytes)]).map(|_| ())
    }
}

fn unread(path: &Path, error: &dyn std::fmt::Display) -> Failure {
    unwritable(Notice {
        help: Some(
            "give files that `verify --out` wrote for this design, scenarios and seed".to_owned(),
        ),
        ..Notice::of(format!("cannot use {}: {error}", path.display()))
    })
}

fn write_failed(path: &Path, error: &dyn std::fmt::Display) -> Failure {
    unwritable(Notice {
        help: Some("give a file in a folder that can be written with --out".to_owned()),
        ..Notice::of(format!("cannot write {}: {error}", path.display()))
    })
}
