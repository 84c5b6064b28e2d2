//! A checksum of all bytes of a Parquet file, in its own metadata: SHA-256 of the file in which its
//! digits are zeros.

use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};

use sha2::{Digest, Sha256};

/// The key of the checksum.
pub(super) const KEY: &str = "ptc.sha256";

/// The digits while there is no checksum yet.
pub(super) const OPEN: &str = "0000000000000000000000000000000000000000000000000000000000000000";

/// Bytes before the digits: the key as the footer writes it, and the type and the length of the text that follows.
const BEFORE: &[u8] = b"ptc.sha256\x18\x40";

/// Last bytes of every Parquet file, after the length of its footer in four bytes.
const MAGIC: &[u8] = b"PAR1";

/// SHA-256 in hexadecimal.
pub fn hash(bytes: &[u8]) -> String {
    digits(Sha256::digest(bytes).as_slice())
}

/// Puts the checksum into a file that is otherwise whole.
pub(super) fn close<F: Read + Write + Seek>(file: &mut F) -> io::Result<()> {
    let at = place(file)?.ok_or_else(|| io::Error::other("no place for the checksum"))?;
    let sum = sum(file, at)?;
    file.seek(SeekFrom::Start(at))?;
    file.write_all(sum.as_bytes())?;
    file.flush()
}

/// Returns true if the file has a checksum that matches its bytes. The file is at its start then.
pub(super) fn holds<F: Read + Seek>(file: &mut F) -> io::Result<bool> {
    let Some(at) = place(file)? else { return Ok(false) };
    let mut there = [0; OPEN.len()];
    file.seek(SeekFrom::Start(at))?;
    file.read_exact(&mut there)?;
    let holds = sum(file, at)?.as_bytes() == there;
    file.rewind()?;
    Ok(holds)
}

/// Returns the position of the digits.
fn place<F: Read + Seek>(file: &mut F) -> io::Result<Option<u64>> {
    let length = file.seek(SeekFrom::End(0))?;
    let mut end = [0; 8];
    let Some(tail) = length.checked_sub(end.len() as u64) else { return Ok(None) };
    file.seek(SeekFrom::Start(tail))?;
    file.read_exact(&mut end)?;
    let footer = u32::from_le_bytes([end[0], end[1], end[2], end[3]]);
    let Some(start) = tail.checked_sub(u64::from(footer)) else { return Ok(None) };
    if end[4..] != *MAGIC {
        return Ok(None);
    }
    file.seek(SeekFrom::Start(start))?;
    let mut bytes = Vec::new();
    file.take(u64::from(footer)).read_to_end(&mut bytes)?;
    let found = bytes.windows(BEFORE.len()).rposition(|window| window == BEFORE);
    let at = found.map(|found| found + BEFORE.len());
    Ok(at.filter(|at| at + OPEN.len() <= bytes.len()).map(|at| start + at as u64))
}

/// The checksum, whose digits are or will be at `at`.
fn sum<F: Read + Seek>(file: &mut F, at: u64) -> io::Result<String> {
    let mut sum = Sha256::new();
    file.rewind()?;
    feed(&mut sum, &mut file.by_ref().take(at))?;
    sum.update(OPEN);
    file.seek(SeekFrom::Start(at + OPEN.len() as u64))?;
    feed(&mut sum, file)?;
    Ok(digits(sum.finalize().as_slice()))
}

fn feed(sum: &mut Sha256, from: &mut impl Read) -> io::Result<()> {
    let mut block = vec![0; 1 << 16];
    loop {
        match from.read(&mut block) {
            Ok(0) => return Ok(()),
            Ok(read) => sum.update(&block[..read]),
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

fn digits(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    /// A file of the form of Parquet, as far as the checksum is concerned.
    fn file() -> Vec<u8> {
        let footer = [&b"columns"[..], BEFORE, OPEN.as_bytes(), b"more"].concat();
        let length = u32::try_from(footer.len()).expect("short").to_le_bytes();
        let mut file = Cursor::new([b"PAR1 pages ", &footer[..], &length, MAGIC].concat());
        close(&mut file).expect("a checksum");
        file.into_inner()
    }

    #[test]
    fn every_flipped_bit_is_detected() {
        let whole = file();
        assert!(holds(&mut Cursor::new(&whole)).expect("read"));
        for bit in 0..8 * whole.len() {
            let mut damaged = whole.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            assert!(!holds(&mut Cursor::new(damaged)).expect("read"), "bit {bit}");
        }
        for length in 0..whole.len() {
            assert!(!holds(&mut Cursor::new(&whole[..length])).expect("read"), "{length} bytes");
        }
    }

    #[test]
    fn hash_matches_the_sha256_test_vector() {
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(hash(b"abc"), abc);
    }
}
