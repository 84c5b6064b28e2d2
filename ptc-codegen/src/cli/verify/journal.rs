//! The rows of a campaign under way: one file beside the output, which an interrupted run leaves and
//! the next one goes on with. One process has it at a time, by a lock that ends with the process.
//!
//! The file is a line that names the owner, a header that names program, version, campaign and range,
//! and then one record a chunk: its range, a checksum, and the numbers of its rows. A record that ends
//! too soon was being written; whatever else differs from what was written is damage.

mod failure;
mod header;
mod lock;

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::verify::record::{PROGRAM, Row, differing, hash};
use crate::verify::{Campaign, chunks};

use failure::{foreign, unusable};
use header::{Header, OWNER, owner, owner_line};
use lock::lock;

use crate::cli::output::watch;
use crate::cli::report::Failure;

/// The end of the name of its file.
pub(super) const SUFFIX: &str = ".chunks";

/// Bytes before the numbers of a record: the two ends of its range, and the digits of its checksum.
const HEAD: usize = 8 + 8 + 64;

/// Most bytes of a header that is looked at to say how it differs.
const MAX_HEADER: u64 = 1 << 20;

/// The rows under way.
pub(super) struct Journal {
    /// Its file, unless that has no name.
    path: Option<PathBuf>,
    state: Mutex<State>,
    columns: usize,
    header: Header,
}

struct State {
    file: File,
    /// Where the next record begins.
    end: u64,
    /// Where each chunk that is done begins, by its first scenario.
    done: BTreeMap<u64, u64>,
}

impl Journal {
    /// The journal at `path`: a new one, or that of an interrupted run of the same campaign.
    ///
    /// # Errors
    /// Another process has it; it is of another run; it is damaged; or it is not of this program.
    pub(super) fn open(
        path: &Path,
        campaign: &Campaign,
        range: &Range<u64>,
    ) -> Result<Self, Failure> {
        watch();
        let file = lock(path)?;
        let journal = Self::new(Some(path.to_owned()), file, campaign, range);
        journal.begin(path, range)?;
        Ok(journal)
    }

    /// A journal without a name, which is gone with the process.
    pub(super) fn nameless(campaign: &Campaign, range: &Range<u64>) -> io::Result<Self> {
        watch();
        let file = tempfile::tempfile()?;
        let journal = Self::new(None, file, campaign, range);
        journal.start()?;
        Ok(journal)
    }

    fn new(path: Option<PathBuf>, file: File, campaign: &Campaign, range: &Range<u64>) -> Self {
        let state = Mutex::new(State { file, end: 0, done: BTreeMap::new() });
        let columns = campaign.columns().len();
        Self { path, state, columns, header: Header::new(campaign, range) }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether a chunk is done.
    pub(super) fn has(&self, chunk: &Range<u64>) -> bool {
        self.state().done.contains_key(&chunk.start)
    }

    /// Adds a chunk.
    ///
    /// # Errors
    /// It cannot be written; the chunks before it stay.
    pub(super) fn keep(&self, chunk: &Range<u64>, rows: &[Row]) -> io::Result<()> {
        let record = self.record(chunk, rows);
        let state = &mut *self.state();
        let written =
            state.file.seek(SeekFrom::Start(state.end)).and_then(|_| state.file.write_all(&record));
        if written.is_err() {
            // The next run would cut it off as well.
            let _ = state.file.set_len(state.end);
            return written;
        }
        state.done.insert(chunk.start, state.end);
        state.end += record.len() as u64;
        Ok(())
    }

    /// The rows of a chunk that is done, as they are read back.
    ///
    /// # Errors
    /// They cannot be read, or are not what was written.
    pub(super) fn rows(&self, chunk: &Range<u64>) -> io::Result<Vec<Row>> {
        let state = &mut *self.state();
        let at = state.done.get(&chunk.start).ok_or(ErrorKind::NotFound)?;
        state.file.seek(SeekFrom::Start(*at))?;
        let mut record = vec![0; self.length(chunk)];
        state.file.read_exact(&mut record)?;
        let numbers = &record[HEAD..];
        if record[..HEAD] != *self.head(chunk, numbers) {
            return Err(damaged(chunk));
        }
        let number = |bytes: &[u8]| bytes.try_into().map_or(f64::NAN, f64::from_le_bytes);
        let rows = numbers.chunks_exact(8 * self.columns).map(|row| row.chunks_exact(8));
        let row = |(index, row): (u64, std::slice::ChunksExact<'_, u8>)| Row {
            index,
            numbers: row.map(number).collect(),
        };
        Ok(chunk.clone().zip(rows).map(row).collect())
    }

    /// Removes the file, whose rows are elsewhere now.
    pub(super) fn finish(self) {
        if let Some(path) = &self.path {
            // Where it cannot be removed the next run finds its rows done.
            let _ = fs::remove_file(path);
        }
    }

    fn length(&self, chunk: &Range<u64>) -> usize {
        let rows = usize::try_from(chunk.end - chunk.start).unwrap_or(usize::MAX);
        HEAD + 8 * self.columns * rows
    }

    fn record(&self, chunk: &Range<u64>, rows: &[Row]) -> Vec<u8> {
        let numbers = rows.iter().flat_map(|row| &row.numbers);
        let numbers: Vec<u8> = numbers.flat_map(|number| number.to_le_bytes()).collect();
        [&self.head(chunk, &numbers)[..], &numbers].concat()
    }

    fn head(&self, chunk: &Range<u64>, numbers: &[u8]) -> Vec<u8> {
        let range = [chunk.start.to_le_bytes(), chunk.end.to_le_bytes()].concat();
        let sum = hash(&[self.header.text.as_bytes(), &range, numbers].concat());
        [&range[..], sum.as_bytes()].concat()
    }

    /// Writes owner and header to a file that has nothing else.
    fn start(&self) -> io::Result<()> {
        let state = &mut *self.state();
        let head =
            [owner_line(std::process::id()).as_bytes(), self.header.text.as_bytes()].concat();
        state.file.rewind()?;
        state.file.write_all(&head)?;
        state.file.set_len(head.len() as u64)?;
        state.end = head.len() as u64;
        Ok(())
    }

    /// Finds what is done in a file that is locked.
    fn begin(&self, path: &Path, range: &Range<u64>) -> Result<(), Failure> {
        let wrong = |error: io::Error| unusable(path, &error.to_string());
        let mut head = Vec::new();
        {
            let file = &mut self.state().file;
            let most = (OWNER + self.header.text.len()) as u64;
            Read::by_ref(file).take(most).read_to_end(&mut head).map_err(wrong)?;
        }
        let header = self.header.text.as_bytes();
        let is_owner = |line: &[u8]| owner(line).is_some();
        match head.split_at_checked(OWNER) {
            Some((line, rest)) if is_owner(line) && rest == header => {}
            // It ended between making its file and writing the header.
            Some((line, rest)) if is_owner(line) && header.starts_with(rest) => {
                return self.start().map_err(wrong);
            }
            None if PROGRAM.as_bytes().starts_with(&head[..head.len().min(PROGRAM.len())]) => {
                return self.start().map_err(wrong);
            }
            Some((line, _)) if line.starts_with(PROGRAM.as_bytes()) => {
                return Err(self.differs(path, is_owner(line)));
            }
            _ => return Err(foreign(path, "is not a file of this program")),
        }
        self.index(range).map_err(wrong)?;
        // Only a process that finds the file locked reads its owner.
        let state = &mut *self.state();
        let line = owner_line(std::process::id());
        let renamed = state.file.rewind().and_then(|()| state.file.write_all(line.as_bytes()));
        renamed.map_err(wrong)
    }

    /// Goes through the records, each of which is read in full, and cuts off what was being written.
    fn index(&self, range: &Range<u64>) -> io::Result<()> {
        let legal: BTreeMap<_, _> =
            chunks(range.clone()).into_iter().map(|chunk| (chunk.start, chunk.end)).collect();
        let length = self.state().file.metadata()?.len();
        let mut at = (OWNER + self.header.text.len()) as u64;
        while at < length {
            let left = length - at;
            let mut ends = [[0; 8]; 2];
            if left >= 16 {
                let file = &mut self.state().file;
                file.seek(SeekFrom::Start(at))?;
                ends.iter_mut().try_for_each(|end| file.read_exact(end))?;
            }
            let [start, end] = ends.map(u64::from_le_bytes);
            let chunk = start..end;
            let known = legal.get(&start) == Some(&end) && !self.has(&chunk);
            if left >= 16 && !known {
                return Err(damaged_at(at));
            }
            if left < 16 || left < self.length(&chunk) as u64 {
                self.state().file.set_len(at)?;
                break;
            }
            self.state().done.insert(start, at);
            self.rows(&chunk)?;
            at += self.length(&chunk) as u64;
        }
        self.state().end = at;
        Ok(())
    }

    /// Why a file of this program is not of this run.
    fn differs(&self, path: &Path, owned: bool) -> Failure {
        let mut text = Vec::new();
        let file = &mut self.state().file;
        let read = file.seek(SeekFrom::Start(OWNER as u64));
        let read = read.and_then(|_| Read::by_ref(file).take(MAX_HEADER).read_to_end(&mut text));
        let there = read.ok().and_then(|_| Header::read(&text)).filter(|_| owned);
        let Some(there) = there else {
            return unusable(path, "its header is damaged");
        };
        let here = &self.header;
        unusable(
            path,
            &match () {
                () if there.version != here.version => format!(
                    "it is of version {} of ptc-codegen, and this is {}",
                    there.version, here.version
                ),
                () if there.campaign != here.campaign => {
                    format!(
                        "it is of another campaign: {}",
                        differing(&there.campaign, &here.campaign)
                    )
                }
                () => format!("it has {} of this campaign, and not {}", there.range, here.range),
            },
        )
    }
}

fn damaged(chunk: &Range<u64>) -> io::Error {
    let message = format!("its scenarios from {} to below {} are damaged", chunk.start, chunk.end);
    io::Error::new(ErrorKind::InvalidData, message)
}

fn damaged_at(byte: u64) -> io::Error {
    io::Error::new(ErrorKind::InvalidData, format!("it is damaged from byte {byte} on"))
}
