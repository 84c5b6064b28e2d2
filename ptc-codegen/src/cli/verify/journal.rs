//! The rows of a campaign under way: one file beside the output, which an interrupted run leaves and
//! the next one goes on with. One process has it at a time, by a lock that ends with the process.
//!
//! The file is a line that names the owner, a header that names program, version, campaign and range,
//! and then one record a chunk: its range, a checksum, and the numbers of its rows. The header is synced
//! before the first scenario runs, and the records every few seconds, so that a power cut costs the last
//! of them. Every record that is whole is used again, whatever stands between them.

mod failure;
mod header;
mod lock;
mod records;

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use crate::verify::Campaign;
use crate::verify::record::{PROGRAM, Row, differing, hash};

use failure::{foreign, unusable};
use header::{Header, OWNER, owner, owner_line};
use lock::lock;

use crate::cli::output::{nameless, sync_folder, watch};
use crate::cli::report::{Failure, print};

/// The end of the name of its file.
pub(super) const SUFFIX: &str = ".chunks";

/// Bytes before the numbers of a record: the two ends of its range, and the digits of its checksum.
const HEAD: usize = 8 + 8 + 64;

/// Most bytes of a header that is looked at to say how it differs.
const MAX_HEADER: u64 = 1 << 20;

/// Longest time for which records are not on the disk.
const SYNC: Duration = Duration::from_secs(2);

/// The rows under way.
pub(super) struct Journal {
    /// Its file, unless that has no name.
    path: Option<PathBuf>,
    state: Mutex<State>,
    columns: usize,
    header: Header,
}

struct State {
    file: Arc<File>,
    /// Offset of the next record.
    end: u64,
    /// When the records were last synced.
    synced: Instant,
    /// Offset of each chunk that is done, by its first scenario.
    done: BTreeMap<u64, u64>,
}

impl Journal {
    /// The journal at `path`: a new one, or that of an interrupted run of the same campaign.
    ///
    /// # Errors
    /// Another process has it; it is of another run; its header is damaged; or it is not of this program.
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
        let journal = Self::new(None, nameless()?, campaign, range);
        journal.start()?;
        Ok(journal)
    }

    fn new(path: Option<PathBuf>, file: File, campaign: &Campaign, range: &Range<u64>) -> Self {
        let (file, synced) = (Arc::new(file), Instant::now());
        let state = Mutex::new(State { file, end: 0, synced, done: BTreeMap::new() });
        let columns = campaign.columns().len();
        Self { path, state, columns, header: Header::new(campaign, range) }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns true if a chunk is done.
    pub(super) fn has(&self, chunk: &Range<u64>) -> bool {
        self.state().done.contains_key(&chunk.start)
    }

    /// Adds a chunk.
    ///
    /// # Errors
    /// It cannot be written; the chunks before it stay.
    pub(super) fn keep(&self, chunk: &Range<u64>, rows: &[Row]) -> io::Result<()> {
        let record = self.record(chunk, rows);
        let mut state = self.state();
        let (end, mut file) = (state.end, &*state.file);
        let written = file.seek(SeekFrom::Start(end)).and_then(|_| file.write_all(&record));
        if written.is_err() {
            // The next run would cut it off as well.
            let _ = file.set_len(end);
            return written;
        }
        state.done.insert(chunk.start, end);
        state.end += record.len() as u64;
        if self.path.is_none() || state.synced.elapsed() < SYNC {
            return Ok(());
        }
        state.synced = Instant::now();
        let file = Arc::clone(&state.file);
        // The others go on writing meanwhile.
        drop(state);
        file.sync_data()
    }

    /// The rows of a chunk that is done, as they are read back.
    ///
    /// # Errors
    /// They cannot be read, or are not what was written.
    pub(super) fn rows(&self, chunk: &Range<u64>) -> io::Result<Vec<Row>> {
        let at = self.state().done.get(&chunk.start).copied().ok_or(ErrorKind::NotFound)?;
        let Some(record) = self.record_at(at, chunk)? else { return Err(damaged(chunk)) };
        let number = |bytes: &[u8]| bytes.try_into().map_or(f64::NAN, f64::from_le_bytes);
        let rows = record[HEAD..].chunks_exact(8 * self.columns).map(|row| row.chunks_exact(8));
        let row = |(index, row): (u64, std::slice::ChunksExact<'_, u8>)| Row {
            index,
            numbers: row.map(number).collect(),
        };
        Ok(chunk.clone().zip(rows).map(row).collect())
    }

    /// The record of a chunk at a place of the file; `None` if it is not whole.
    fn record_at(&self, at: u64, chunk: &Range<u64>) -> io::Result<Option<Vec<u8>>> {
        let state = self.state();
        let mut file = &*state.file;
        file.seek(SeekFrom::Start(at))?;
        let mut record = vec![0; self.length(chunk)];
        match file.read_exact(&mut record) {
            Err(error) if error.kind() == ErrorKind::UnexpectedEof => return Ok(None),
            read => read?,
        }
        let whole = record[..HEAD] == *self.head(chunk, &record[HEAD..]);
        Ok(whole.then_some(record))
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
        let mut file = &*state.file;
        file.rewind()?;
        file.write_all(&head)?;
        file.set_len(head.len() as u64)?;
        state.end = head.len() as u64;
        let Some(path) = &self.path else { return Ok(()) };
        file.sync_all()?;
        path.parent().map_or(Ok(()), sync_folder)
    }

    /// Finds what is done in a file that is locked.
    fn begin(&self, path: &Path, range: &Range<u64>) -> Result<(), Failure> {
        let wrong = |error: io::Error| unusable(path, &error.to_string());
        let mut head = Vec::new();
        {
            let most = (OWNER + self.header.text.len()) as u64;
            (&*self.state().file).take(most).read_to_end(&mut head).map_err(wrong)?;
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
        let damage = self.index(range).map_err(wrong)?;
        print(&damage.map(|damage| damage.notice(path)).into_iter().collect::<Vec<_>>());
        // Only a process that finds the file locked reads its owner.
        let state = self.state();
        let mut file = &*state.file;
        let line = owner_line(std::process::id());
        file.rewind().and_then(|()| file.write_all(line.as_bytes())).map_err(wrong)
    }

    /// Why a file of this program is not of this run.
    fn differs(&self, path: &Path, owned: bool) -> Failure {
        let mut text = Vec::new();
        let state = self.state();
        let mut file = &*state.file;
        let read = file.seek(SeekFrom::Start(OWNER as u64));
        let read = read.and_then(|_| file.take(MAX_HEADER).read_to_end(&mut text));
        let there = read.ok().and_then(|_| Header::read(&text)).filter(|_| owned);
        let Some(there) = there else {
            return unusable(path, "its header is damaged");
        };
        let here = &self.header;
        unusable(
            path,
            &if there.version != here.version {
                format!(
                    "it is of version {} of ptc-codegen, and this is {}",
                    there.version, here.version
                )
            } else if there.campaign != here.campaign {
                format!("it is of another campaign: {}", differing(&there.campaign, &here.campaign))
            } else {
                format!("it has {} of this campaign, and not {}", there.range, here.range)
            },
        )
    }
}

fn damaged(chunk: &Range<u64>) -> io::Error {
    let message = format!("its scenarios from {} to below {} are damaged", chunk.start, chunk.end);
    io::Error::new(ErrorKind::InvalidData, message)
}
