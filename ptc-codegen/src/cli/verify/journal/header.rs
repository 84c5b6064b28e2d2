//! Beginning of a journal: a line that names its owner, and a header that names its run.

use std::ops::Range;

use crate::verify::record::{PROGRAM, hash};
use crate::verify::{Campaign, ENGINE};

/// Bytes of the line that names the owner.
pub(super) const OWNER: usize = PROGRAM.len() + ", owner 0000000000, ".len() + 16 + 1;

/// Header of a journal: the identity of its run.
pub(super) struct Header {
    pub(super) version: String,
    /// The scenarios in words.
    pub(super) range: String,
    pub(super) campaign: String,
    /// As it is written.
    pub(super) text: String,
}

impl Header {
    pub(super) fn new(campaign: &Campaign, range: &Range<u64>) -> Self {
        let version = ENGINE.to_owned();
        let range = format!("the scenarios from {} to below {}", range.start, range.end);
        let campaign = campaign.text();
        let design = hash(campaign.as_bytes());
        let length = campaign.len();
        let text =
            format!("version {version}\n{range}\ndesign {design}, {length} bytes\n{campaign}\n");
        let sum = hash(text.as_bytes());
        Self { version, range, campaign, text: format!("{text}{sum}\n") }
    }

    /// The header that `bytes` begin with, if it is whole.
    pub(super) fn read(bytes: &[u8]) -> Option<Self> {
        let mut lines = bytes.split_inclusive(|byte| *byte == b'\n');
        let mut line = || std::str::from_utf8(lines.next()?).ok()?.strip_suffix('\n');
        let (version, range, design) = (line()?, line()?, line()?);
        let length: usize = design.rsplit_once(", ")?.1.strip_suffix(" bytes")?.parse().ok()?;
        let start = version.len() + range.len() + design.len() + 3;
        let end = start.checked_add(length)?.checked_add(1)?;
        let campaign = std::str::from_utf8(bytes.get(start..end - 1)?).ok()?.to_owned();
        let sum = bytes.get(end..end + 64)?;
        if hash(&bytes[..end]).as_bytes() != sum {
            return None;
        }
        let version = version.strip_prefix("version ")?.to_owned();
        Some(Self { version, range: range.to_owned(), campaign, text: String::new() })
    }
}

/// The first line of a journal: of one length, so that it is written at once.
pub(super) fn owner_line(process: u32) -> String {
    let line = format!("{PROGRAM}, owner {process:010}, ");
    let sum = hash(line.as_bytes());
    format!("{line}{}\n", &sum[..16])
}

/// The process that such a line names.
pub(super) fn owner(line: &[u8]) -> Option<u32> {
    let text = std::str::from_utf8(line).ok()?;
    let number = text.strip_prefix(PROGRAM)?.strip_prefix(", owner ")?.get(..10)?;
    let process = number.parse().ok()?;
    (owner_line(process) == text).then_some(process)
}
