//! The records of a file that another run left.

use std::collections::BTreeMap;
use std::io::{self, ErrorKind, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;

use super::header::OWNER;
use super::{HEAD, Journal};
use crate::cli::report::Notice;
use crate::verify::chunks;

/// Bytes that are searched at a time for the next record that is whole.
const WINDOW: usize = 1 << 20;

/// Bytes of the two ends of a range.
const ENDS: usize = 16;

/// The ends of the chunks of a run, by their starts.
type Chunks = BTreeMap<u64, u64>;

/// Damaged part, which cannot be used again.
pub(super) struct Damage {
    /// Offset at which it begins, and the number of its bytes.
    at: u64,
    bytes: u64,
    /// Scenarios that are kept, and all of the run.
    kept: u64,
    all: u64,
}

impl Damage {
    /// The warning of it.
    pub(super) fn notice(&self, path: &Path) -> Notice {
        let Self { at, bytes, kept, all } = self;
        let title = format!(
            "{}, which keeps the rows under way, is damaged: {kept} of {all} scenarios are kept, the \
             others run again",
            path.display()
        );
        let note = format!(
            "{bytes} bytes, the first of them byte {at}, are no rows of this run, as after a power cut"
        );
        Notice { warns: true, notes: vec![note], ..Notice::of(title) }
    }
}

impl Journal {
    /// Finds the records that are whole, each of which is read in full, and cuts off what follows the
    /// last one. `None` if that is nothing but a record that was being written.
    pub(super) fn index(&self, range: &Range<u64>) -> io::Result<Option<Damage>> {
        let legal: Chunks =
            chunks(range.clone()).into_iter().map(|chunk| (chunk.start, chunk.end)).collect();
        let length = self.state().file.metadata()?.len();
        let mut end = (OWNER + self.header.text.len()) as u64;
        let mut damage = None::<(u64, u64)>;
        while let Some((at, chunk)) = self.next_record(end, &legal)? {
            if at > end {
                let (first, bytes) = damage.unwrap_or((end, 0));
                damage = Some((first, bytes + (at - end)));
            }
            self.state().done.insert(chunk.start, at);
            end = at + self.length(&chunk) as u64;
        }
        if end < length && !self.was_being_written(end, length - end, &legal)? {
            let (first, bytes) = damage.unwrap_or((end, 0));
            damage = Some((first, bytes + (length - end)));
        }
        let mut state = self.state();
        state.file.set_len(end)?;
        state.end = end;
        let kept = state.done.keys().map(|start| legal.get(start).map_or(0, |end| end - start));
        let (kept, all) = (kept.sum(), range.end - range.start);
        Ok(damage.map(|(at, bytes)| Damage { at, bytes, kept, all }))
    }

    /// The first record from `from` on that is whole and not known yet, and where it is.
    fn next_record(&self, from: u64, legal: &Chunks) -> io::Result<Option<(u64, Range<u64>)>> {
        if let Some(chunk) = self.range_at(from)?
            && self.is_legal(&chunk, legal)
            && self.record_at(from, &chunk)?.is_some()
        {
            return Ok(Some((from, chunk)));
        }
        let mut from = from;
        loop {
            let window = self.window(from)?;
            for (at, ends) in (from..).zip(window.windows(ENDS)) {
                let chunk = chunk(ends);
                if self.is_legal(&chunk, legal) && self.record_at(at, &chunk)?.is_some() {
                    return Ok(Some((at, chunk)));
                }
            }
            if window.len() < WINDOW {
                return Ok(None);
            }
            from += (WINDOW - ENDS + 1) as u64;
        }
    }

    /// The bytes from `from` on.
    fn window(&self, from: u64) -> io::Result<Vec<u8>> {
        let state = self.state();
        let mut file = &*state.file;
        file.seek(SeekFrom::Start(from))?;
        let mut window = Vec::with_capacity(WINDOW);
        file.take(WINDOW as u64).read_to_end(&mut window)?;
        Ok(window)
    }

    fn is_legal(&self, chunk: &Range<u64>, legal: &Chunks) -> bool {
        legal.get(&chunk.start) == Some(&chunk.end) && !self.has(chunk)
    }

    /// Returns true if the last `left` bytes, from `at` on, are the beginning of a record: its run was ended there.
    fn was_being_written(&self, at: u64, left: u64, legal: &Chunks) -> io::Result<bool> {
        if left < HEAD as u64 {
            return Ok(true);
        }
        let chunk = self.range_at(at)?;
        Ok(chunk
            .is_some_and(|chunk| self.is_legal(&chunk, legal) && left < self.length(&chunk) as u64))
    }

    /// The range of a record at a place of the file; `None` if the file ends before.
    fn range_at(&self, at: u64) -> io::Result<Option<Range<u64>>> {
        let state = self.state();
        let (mut file, mut ends) = (&*state.file, [0; ENDS]);
        file.seek(SeekFrom::Start(at))?;
        match file.read_exact(&mut ends) {
            Err(error) if error.kind() == ErrorKind::UnexpectedEof => Ok(None),
            read => read.map(|()| Some(chunk(&ends))),
        }
    }
}

/// The range that a record begins with.
fn chunk(ends: &[u8]) -> Range<u64> {
    let number = |bytes: &[u8]| bytes.try_into().map_or(u64::MAX, u64::from_le_bytes);
    let (start, end) = ends.split_at(ENDS / 2);
    number(start)..number(end)
}
