//! An FMU: its text, a library where there is a C compiler, packed into one archive.

use std::env;
use std::fs;
use std::io::{self, Cursor, ErrorKind, Read, Write};
use std::path::Path;
use std::process::Command;

use crate::emit::File;
use crate::emit::fmu::Version;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

use super::compare::compare;
use super::compiler::compiler;
use super::output::TemporaryFolder;
use super::read;
use super::report::{self, Failure, Notice};
use super::write;

/// `NAME.fmu` and its bytes. Without a C compiler it has sources only, which is reported on the standard
/// error.
pub(crate) fn archive(
    name: &str,
    version: Version,
    files: &[File],
) -> Result<(String, Vec<u8>), Failure> {
    let mut entries: Vec<_> =
        files.iter().map(|file| (file.name.clone(), file.text.clone().into_bytes())).collect();
    match library(name, version, files) {
        Ok(entry) => entries.push(entry),
        Err(reason) => report::print(&[Notice {
            notes: reason.notes,
            help: Some(reason.help.to_owned()),
            warns: true,
            ..Notice::of(format!("{name}.fmu holds sources and no library: {}", reason.what))
        }]),
    }
    entries.sort();
    let archive = pack(&entries)
        .map_err(|error| write::failed("cannot pack", Path::new(&file_name(name)), &error))?;
    Ok((file_name(name), archive))
}

/// Most bytes that are read of an archive; one with the library of each platform has a few millions.
const MAX_ARCHIVE: u64 = 1 << 28;

/// Compares the text in `NAME.fmu` with `files`; its library is a compiler's, and not compared.
pub(crate) fn check(folder: &Path, name: &str, files: &[File]) -> Result<(), Failure> {
    let path = folder.join(file_name(name));
    let bytes = match read::start(&path, MAX_ARCHIVE) {
        Err(error) if error.kind() != ErrorKind::NotFound => {
            return Err(write::failed("cannot read", &path, &error));
        }
        bytes => bytes.ok(),
    };
    let archive = bytes.map(|bytes| ZipArchive::new(Cursor::new(bytes))).transpose();
    let mut archive =
        archive.map_err(|error| write::failed("cannot read", &path, &error.into()))?;
    compare(&path, files, &mut |file| {
        let missing = || io::Error::from(ErrorKind::NotFound);
        let mut entry = archive.as_mut().ok_or_else(missing)?.by_name(&file.name)?;
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes)?;
        Ok(bytes)
    })
}

fn file_name(name: &str) -> String {
    format!("{name}.fmu")
}

/// The archive of the entries: stored, with one time for all of them, so that it is made of its
/// contents alone.
fn pack(entries: &[(String, Vec<u8>)]) -> io::Result<Vec<u8>> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::default())
        .unix_permissions(0o644);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in entries {
        archive.start_file(name.as_str(), options)?;
        archive.write_all(content)?;
    }
    Ok(archive.finish()?.into_inner())
}

/// Why there is no library.
struct Reason {
    what: String,
    notes: Vec<String>,
    help: &'static str,
}

/// The library of this platform, by its path in the archive.
fn library(name: &str, version: Version, files: &[File]) -> Result<(String, Vec<u8>), Reason> {
    let Some((folder, suffix)) = platform(version) else {
        return Err(Reason {
            what: format!("FMI knows no platform of {} and {}", env::consts::ARCH, env::consts::OS),
            notes: Vec::new(),
            help: "an importer that compiles sources can use it",
        });
    };
    let compiler = compiler();
    let failed = |what: &str, error: &io::Error| Reason {
        what: format!("{what} `{}`: {error}", compiler.to_string_lossy()),
        notes: Vec::new(),
        help: "install a C compiler, or name one in the environment variable CC; an importer that \
               compiles sources can use the FMU as it is",
    };
    let home = TemporaryFolder::new(&env::temp_dir());
    let home = home.map_err(|error| failed("no folder to run", &error))?;
    let sources = files.iter().filter_map(|file| {
        Some(File { name: file.name.strip_prefix("sources/")?.to_owned(), text: file.text.clone() })
    });
    for file in sources.chain(version.headers()) {
        let written = home.write(&file.name, file.text.as_bytes());
        written.map_err(|error| failed("no folder to run", &error))?;
    }
    // Its paths are relative, so that none of this machine gets into the library.
    let output = Command::new(&compiler)
        .current_dir(home.path())
        .args(["-std=c99", "-O2", "-ffp-contract=off", "-fPIC", "-fvisibility=hidden", "-shared"])
        .args(["-I.", "-o", "library"])
        .args([format!("{name}.c"), format!("{name}_fmu.c")])
        .arg("-lm")
        .output()
        .map_err(|error| failed("cannot run", &error))?;
    if !output.status.success() {
        let told = String::from_utf8_lossy(&output.stderr);
        return Err(Reason {
            what: format!("`{}` fails: {}", compiler.to_string_lossy(), output.status),
            notes: told.lines().take(5).map(|line| line.chars().take(200).collect()).collect(),
            help: "name another C compiler in the environment variable CC",
        });
    }
    let library =
        fs::read(home.path().join("library")).map_err(|error| failed("no library from", &error))?;
    Ok((format!("binaries/{folder}/{name}.{suffix}"), library))
}

/// The folder of this platform's library in an FMU, and the suffix of a library.
fn platform(version: Version) -> Option<(String, &'static str)> {
    let arch = env::consts::ARCH;
    let (os, suffix) = match env::consts::OS {
        "linux" => ("linux", "so"),
        "macos" => ("darwin", "dylib"),
        "windows" => ("windows", "dll"),
        _ => return None,
    };
    let folder = match (version, os, arch) {
        (Version::Three, _, "x86_64" | "x86" | "aarch64") => format!("{arch}-{os}"),
        (Version::Two, "linux" | "darwin", "x86_64") => format!("{os}64"),
        (Version::Two, "windows", "x86_64") => "win64".to_owned(),
        (Version::Two, "linux", "x86") => "linux32".to_owned(),
        (Version::Two, "windows", "x86") => "win32".to_owned(),
        // FMI 2.0 has no name for it; importers look under that of FMI 3.0.
        (Version::Two, _, "aarch64") => format!("{arch}-{os}"),
        _ => return None,
    };
    Some((folder, suffix))
}
