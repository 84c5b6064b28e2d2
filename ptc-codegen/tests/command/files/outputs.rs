//! Devices, pipes, links and modes, and outputs that collide.

use std::fs::{self, File};
use std::io::Write;
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Stdio};

use super::support::{command_in, run_in, told, without_design};
use super::{DESIGN, names, stage};

const SIMULATE: [&str; 7] =
    ["simulate", "stage.toml", "--x0=1", "--plant=d=0", "--at=0,0.5", "--tau=1", "-o"];

/// The CSV that a simulation prints.
fn csv(folder: &Path) -> String {
    let (code, printed, wrong) = run_in(folder, &[&SIMULATE[..], &["-"]].concat());
    assert_eq!((code, without_design(&wrong).as_str()), (Some(0), ""));
    assert_eq!(printed.lines().count(), 3, "{printed}");
    printed
}

#[test]
fn devices_and_pipes_are_written_through() {
    let folder = stage("through");
    let csv = csv(&folder);
    for device in ["/dev/null", "/dev/zero"] {
        let (code, told, _) = run_in(&folder, &[&SIMULATE[..], &[device]].concat());
        assert_eq!((code, told), (Some(0), format!("wrote {device}\n")));
        assert!(fs::metadata(device).expect("there").file_type().is_char_device());
    }
    let (code, told, _) = run_in(&folder, &[&SIMULATE[..], &["/dev/stdout"]].concat());
    assert_eq!((code, &told), (Some(0), &csv));
    symlink("/dev/stdout", folder.join("link")).expect("a link");
    let (code, told, _) = run_in(&folder, &[&SIMULATE[..], &["link"]].concat());
    assert_eq!((code, &told), (Some(0), &csv));
    let (code, _, wrong) = run_in(&folder, &[&SIMULATE[..], &["/dev/full"]].concat());
    assert_eq!(code, Some(2));
    assert!(wrong.contains("cannot write /dev/full"), "{wrong}");

    assert!(Command::new("mkfifo").arg(folder.join("pipe")).status().expect("runs").success());
    let child = command_in(&folder, &[&SIMULATE[..], &["pipe"]].concat())
        .stdout(Stdio::null())
        .spawn()
        .expect("runs");
    let read = fs::read_to_string(folder.join("pipe")).expect("what is written");
    assert_eq!(read, csv);
    assert!(child.wait_with_output().expect("ends").status.success());
    assert!(fs::metadata(folder.join("pipe")).expect("there").file_type().is_fifo());

    // What a shell has written to the same file before stays before it.
    let shared = folder.join("shared");
    let mut file = File::create(&shared).expect("a file");
    file.write_all(b"head\n").expect("written");
    let child =
        command_in(&folder, &[&SIMULATE[..], &["/dev/stdout"]].concat()).stdout(file).status();
    assert!(child.expect("runs").success());
    assert_eq!(fs::read_to_string(&shared).expect("there"), format!("head\n{csv}"));
    assert_eq!(names(&folder), ["link", "pipe", "shared", "stage.toml"]);
}

#[test]
fn file_mode_and_link_target_are_preserved() {
    let folder = stage("mode");
    let csv = csv(&folder);
    let (file, link, hard) = (folder.join("run.csv"), folder.join("link.csv"), folder.join("hard"));
    fs::write(&file, "old").expect("written");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).expect("a mode");
    symlink("run.csv", &link).expect("a link");
    fs::hard_link(&file, &hard).expect("a link");
    let write = || run_in(&folder, &[&SIMULATE[..], &["link.csv"]].concat());
    assert_eq!(write().1, "wrote link.csv\n");
    assert_eq!(fs::read_to_string(&file).expect("there"), csv);
    assert_eq!(fs::metadata(&file).expect("there").mode() & 0o7777, 0o640);
    assert_eq!(fs::read_link(&link).expect("a link"), Path::new("run.csv"));
    // The other name is of another's file now.
    assert_eq!(fs::read_to_string(&hard).expect("there"), "old");
    let before = fs::metadata(&file).expect("there");
    assert_eq!(write().1, "unchanged link.csv\n");
    let after = fs::metadata(&file).expect("there");
    assert_eq!((before.ino(), before.mtime_nsec()), (after.ino(), after.mtime_nsec()));

    fs::write(&file, "precious").expect("written");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).expect("a mode");
    let (code, _, wrong) = write();
    assert_eq!(code, Some(2));
    assert!(wrong.contains("link.csv: it is read-only"), "{wrong}");
    assert_eq!(fs::read_to_string(&file).expect("there"), "precious");

    symlink("deep/er/new.csv", folder.join("dangling")).expect("a link");
    let (code, told, _) = run_in(&folder, &[&SIMULATE[..], &["dangling"]].concat());
    assert_eq!((code, told.as_str()), (Some(0), "wrote dangling\n"));
    assert_eq!(fs::read_to_string(folder.join("deep/er/new.csv")).expect("there"), csv);
    let mode = fs::metadata(folder.join("deep/er/new.csv")).expect("there").mode();
    let ordinary = fs::metadata(folder.join("stage.toml")).expect("there").mode();
    assert_eq!(mode, ordinary, "the mode of a new file is the umask's");
}

#[test]
fn collisions_are_refused_before_anything_runs() {
    let folder = stage("collisions");
    symlink("stage.toml", folder.join("link")).expect("a link");
    fs::hard_link(folder.join("stage.toml"), folder.join("hard")).expect("a link");
    fs::create_dir(folder.join("folder.html")).expect("a folder");
    let socket = std::os::unix::net::UnixListener::bind(folder.join("socket"));
    let verify = ["verify", "stage.toml"];
    let with = |first: &[&'static str], more: &[&'static str]| [first, more].concat();
    let is_design = "is the design";
    for (arguments, part) in [
        (with(&SIMULATE, &["stage.toml"]), is_design),
        (with(&SIMULATE, &["link"]), is_design),
        (with(&SIMULATE, &["hard"]), is_design),
        (with(&SIMULATE, &["not/there/../../stage.toml"]), is_design),
        (with(&SIMULATE, &["-", "--report=-"]), "--report - and --out - are one file"),
        (with(&SIMULATE, &["a.svg", "--plot=a.svg"]), "--plot a.svg and --out a.svg are one file"),
        (with(&SIMULATE, &["x/../a.svg", "--plot=./a.svg"]), "are one file"),
        (with(&SIMULATE, &["b", "--report=b/b.html"]), "one inside the other"),
        (with(&SIMULATE, &["a.csv", "--report=folder.html"]), "--report folder.html is a folder"),
        (with(&SIMULATE, &["socket"]), "--out socket is a socket"),
        (with(&verify, &["--worst=stage.toml"]), is_design),
        (with(&verify, &["--out=stage.toml"]), is_design),
        (with(&verify, &["--report=folder.html"]), "--report folder.html is a folder"),
        (with(&verify, &["--out=b", "--worst=b"]), "--worst b and --out b are one file"),
        (with(&verify, &["--out=b", "--worst=b.chunks"]), "are one file"),
        (with(&verify, &["--out=b", "--merge", "b"]), "--out b is a part to merge"),
        (with(&["design", "stage.toml"], &["-o=link"]), is_design),
        (with(&["emit", "--lang=c", "--n=1", "--mu=exp"], &["-o=stage.toml"]), "stage.toml"),
    ] {
        let (code, printed, wrong) = run_in(&folder, &arguments);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{arguments:?}: {wrong}");
        assert!(wrong.contains(part), "{arguments:?}: no {part:?} in\n{wrong}");
        let left = names(&folder);
        assert_eq!(left, ["folder.html", "hard", "link", "socket", "stage.toml"], "{arguments:?}");
        assert_eq!(fs::read_to_string(folder.join("stage.toml")).expect("there"), DESIGN);
    }
    drop(socket);
    let script = "exec \"$0\" simulate /dev/stdin --x0=1 --plant=d=0 -o hard < stage.toml";
    let mut shell = Command::new("sh");
    shell.args(["-c", script, env!("CARGO_BIN_EXE_ptc-codegen")]);
    let (code, _, wrong) = told(shell.current_dir(&folder));
    assert_eq!(code, Some(2), "{wrong}");
    assert!(wrong.contains(is_design), "{wrong}");
    // An emitted file that would replace the design.
    fs::write(folder.join("roll.c"), "name = \"roll\"\nn = 1\nmu = \"exp\"\n").expect("a design");
    let (code, _, wrong) = run_in(&folder, &["emit", "roll.c", "--lang=c"]);
    assert_eq!(code, Some(2), "{wrong}");
    assert!(wrong.contains("is the design") && !folder.join("roll.h").exists(), "{wrong}");
    // Any number of outputs go to a device.
    let both = with(&verify, &["--out=/dev/null", "--worst=/dev/null"]);
    assert_eq!(run_in(&folder, &both).0, Some(0));
}
