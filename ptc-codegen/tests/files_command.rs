//! Any output can be pointed at anything, and nothing is lost that was not the tool's own.
#![cfg(all(unix, feature = "lab"))]

mod support;

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read, Write};
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use support::{command_in, folder, run_in, told};

/// A design with a plant and an objective, all of it quick.
const DESIGN: &str = "n = 1\nmu = \"exp(a=1)\"\npoles = [-4]\neps = 1e-3\n[params]\ntau = 1\n\
                      [plant]\nf = \"-d*x1\"\nd = [0, 0.5]\n[verify]\nx1 = [-1, 1]\n\
                      scenarios = 130\nsearch = 4\n[[objective]]\nbound = \"attractive\"\n\
                      error = 1e-2\n";

const SIMULATE: [&str; 7] =
    ["simulate", "stage.toml", "--x0=1", "--plant=d=0", "--at=0,0.5", "--tau=1", "-o"];

fn stage(test: &str) -> PathBuf {
    support::folder_with(&format!("files_{test}"), "stage.toml", DESIGN)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let mut names: Vec<_> =
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// The CSV that a simulation prints.
fn csv(folder: &Path) -> String {
    let (code, printed, wrong) = run_in(folder, &[&SIMULATE[..], &["-"]].concat());
    assert_eq!((code, wrong.as_str()), (Some(0), ""));
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
fn a_regular_file_keeps_its_mode_and_a_link_its_target() {
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

#[test]
fn a_project_leaves_nothing_beside_itself() {
    let folder = folder("files_project");
    let project = ["emit", "--project=cmake", "--n=1", "--mu=exp", "--name=roll", "-o"];
    let (code, told, wrong) = run_in(&folder, &[&project[..], &["./q/../q"]].concat());
    assert_eq!(code, Some(0), "{wrong}");
    assert!(told.starts_with("wrote ./q/../q/"), "{told}");
    assert_eq!(names(&folder), ["q"]);
    let again = run_in(&folder, &[&project[..], &["q"]].concat()).1;
    assert!(again.starts_with("unchanged q/"), "{again}");
    let (code, _, wrong) = run_in(&folder, &[&project[..], &["."]].concat());
    assert_eq!(code, Some(2));
    assert!(wrong.contains("is not empty"), "{wrong}");
    let empty = folder.join("empty");
    fs::create_dir(&empty).expect("a folder");
    let (code, _, wrong) = run_in(&empty, &[&project[..], &["."]].concat());
    assert_eq!(code, Some(2), "{wrong}");
    fs::set_permissions(&empty, fs::Permissions::from_mode(0o750)).expect("a mode");
    assert_eq!(run_in(&folder, &[&project[..], &["empty"]].concat()).0, Some(0));
    assert_eq!(fs::metadata(&empty).expect("there").mode() & 0o7777, 0o750);
    assert_eq!(names(&folder), ["empty", "q"]);
}

/// A command under a limit of `ulimit`.
fn limited(folder: &Path, limit: &str, arguments: &[&str]) -> (Option<i32>, String, String) {
    let script = format!("{limit}; exec \"$0\" \"$@\"");
    let mut command = Command::new("sh");
    command.args(["-c", &script, env!("CARGO_BIN_EXE_ptc-codegen")]).args(arguments);
    told(command.current_dir(folder))
}

#[test]
fn a_limit_of_size_is_an_error_that_leaves_nothing() {
    let folder = stage("limit");
    let whole = ["simulate", "stage.toml", "--x0=1", "--plant=d=0", "-o", "run.csv"];
    let project = ["emit", "--project=cmake", "--n=2", "--mu=exp", "--name=roll", "-o", "q"];
    let verify = ["verify", "stage.toml", "--out", "rows.parquet"];
    fs::write(folder.join("run.csv"), "old").expect("a file");
    for arguments in [&whole[..], &project, &verify] {
        let (code, printed, wrong) = limited(&folder, "ulimit -f 2", arguments);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{wrong}");
        assert!(wrong.contains("File too large"), "{wrong}");
    }
    assert_eq!(fs::read_to_string(folder.join("run.csv")).expect("there"), "old");
    // The rows that were done are kept.
    assert_eq!(names(&folder), ["rows.parquet.chunks", "run.csv", "stage.toml"]);
    assert_eq!(run_in(&folder, &verify).0, Some(0));
    assert_eq!(names(&folder), ["rows.parquet", "run.csv", "stage.toml"]);
}

#[test]
fn a_limit_of_size_leaves_no_folder_that_was_made_for_an_output() {
    let folder = folder("files_limit_folders");
    for what in [&["--lang=c"][..], &["--lang=st"], &["--lang=fmu3"], &["--project=cmake"]] {
        for place in ["q", "a/b/q"] {
            let common = ["emit", "--n=2", "--mu=exp", "--name=roll", "-o", place];
            let arguments = [&common[..], what].concat();
            // 2: the first file of some fits, and a later one does not.
            for limit in ["ulimit -f 0", "ulimit -f 1", "ulimit -f 2"] {
                let (code, printed, wrong) = limited(&folder, limit, &arguments);
                assert_eq!((code, printed.as_str()), (Some(2), ""), "{arguments:?}: {wrong}");
                assert_eq!(names(&folder), [""; 0], "{arguments:?} under {limit}");
            }
        }
    }
    fs::create_dir(folder.join("a")).expect("a folder");
    let arguments = ["emit", "--n=2", "--mu=exp", "--name=roll", "--lang=c", "-o", "a/b"];
    assert_eq!(limited(&folder, "ulimit -f 2", &arguments).0, Some(2));
    assert_eq!(names(&folder), ["a"], "what was there before stays");
    assert_eq!(names(&folder.join("a")), [""; 0]);
    assert_eq!(run_in(&folder, &arguments).0, Some(0));
    assert_eq!(names(&folder.join("a/b")), ["roll.c", "roll.h"]);
}

#[test]
fn a_signal_at_any_instant_leaves_no_part_of_a_project() {
    let folder = folder("files_project_signals");
    let arguments = ["emit", "--project=cmake", "--n=2", "--mu=exp", "--name=roll", "-o", "a/q"];
    let began = Instant::now();
    assert_eq!(run_in(&folder, &arguments).0, Some(0));
    let (whole, time) = (names(&folder.join("a/q")), began.elapsed());
    for instant in 0..40 {
        fs::remove_dir_all(folder.join("a")).expect("removed");
        let mut child =
            command_in(&folder, &arguments).stdout(Stdio::null()).spawn().expect("runs");
        std::thread::sleep(time.mul_f64(f64::from(instant) / 40.0));
        let kill = Command::new("kill").args(["-TERM", &child.id().to_string()]).output();
        kill.expect("runs");
        child.wait().expect("ends");
        match names(&folder).first() {
            Some(_) => {
                assert_eq!(names(&folder.join("a")), ["q"]);
                assert_eq!(names(&folder.join("a/q")), whole);
            }
            None => fs::create_dir(folder.join("a")).expect("a folder"),
        }
    }
}

#[test]
fn an_interrupt_of_the_search_runs_no_scenario_again() {
    // Each objective has a search of its own.
    let objective = DESIGN.find("[[objective]]").map_or("", |at| &DESIGN[at..]);
    let design = format!("{DESIGN}{}", objective.repeat(60)).replace("search = 4", "search = 400");
    let folder = support::folder_with("files_searched", "stage.toml", design);
    let arguments = ["verify", "stage.toml", "--out", "rows.parquet"];
    let rows = || fs::read(folder.join("rows.parquet.chunks")).expect("the rows are kept");
    let mut kept: Option<Vec<u8>> = None;
    for _ in 0..2 {
        let mut child =
            command_in(&folder, &arguments).stdout(Stdio::null()).spawn().expect("runs");
        while !folder.join("rows.parquet").exists() {
            assert!(child.try_wait().expect("a state").is_none(), "it is still running");
            std::thread::sleep(Duration::from_millis(1));
        }
        child.kill().expect("killed");
        assert!(!child.wait().expect("ended").success(), "killed in its search");
        fs::remove_file(folder.join("rows.parquet")).expect("the rows were whole");
        // The first line names the process.
        let after: Vec<u8> = rows().splitn(2, |byte| *byte == b'\n').last().expect("rows").into();
        assert!(kept.is_none_or(|kept| kept == after));
        kept = Some(after);
    }
    assert_eq!(run_in(&folder, &arguments).0, Some(0));
    assert_eq!(names(&folder), ["rows.parquet", "stage.toml"]);
}

/// Starts a campaign and waits until some of its rows are kept.
fn interrupted(folder: &Path, out: &str, signal: &str) {
    let arguments = ["verify", "stage.toml", "--scenarios=20000", "--out", out];
    let mut child = command_in(folder, &arguments).stdout(Stdio::null()).spawn().expect("runs");
    let journal = folder.join(format!("{out}.chunks"));
    let began = Instant::now();
    let size = || fs::metadata(&journal).map_or(0, |there| there.len());
    while size() < 6000 && began.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(1));
    }
    let kill = Command::new("kill").args([signal, &child.id().to_string()]).status();
    assert!(kill.expect("runs").success());
    assert!(!child.wait().expect("ends").success());
    assert!(journal.exists() && !folder.join(out).exists());
}

#[test]
fn one_process_at_a_time_has_a_campaign() {
    let folder = stage("owned");
    let arguments = ["verify", "stage.toml", "--scenarios=20000", "--out", "rows.parquet"];
    let mut first = command_in(&folder, &arguments).stdout(Stdio::null()).spawn().expect("runs");
    let journal = folder.join("rows.parquet.chunks");
    while fs::metadata(&journal).map_or(0, |there| there.len()) < 1000 {
        assert!(first.try_wait().expect("a state").is_none(), "it is still running");
        std::thread::sleep(Duration::from_millis(1));
    }
    for more in [&["--seed=3"][..], &[]] {
        let (code, printed, wrong) = run_in(&folder, &[&arguments[..], more].concat());
        assert_eq!((code, printed.as_str()), (Some(2), ""));
        let owner = format!(
            "rows.parquet.chunks is in use by another run of verify, process {}",
            first.id()
        );
        assert!(wrong.contains(&owner), "{wrong}");
    }
    first.kill().expect("killed");
    first.wait().expect("ended");
    // Its lock has ended with it.
    let (code, _, wrong) = run_in(&folder, &[&arguments[..], &["--seed=3"]].concat());
    assert_eq!(code, Some(2));
    assert!(wrong.contains("another campaign") && wrong.contains("seed = 3"), "{wrong}");
}

#[test]
fn what_is_not_its_own_is_never_removed() {
    let folder = stage("foreign");
    let verify = ["verify", "stage.toml", "--out", "rows.parquet"];
    let journal = folder.join("rows.parquet.chunks");
    fs::create_dir(&journal).expect("a folder");
    fs::write(journal.join("mine"), "precious").expect("a file");
    let (code, _, wrong) = run_in(&folder, &verify);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("rows.parquet.chunks is a folder"), "{wrong}");
    assert_eq!(fs::read_to_string(journal.join("mine")).expect("there"), "precious");
    fs::remove_dir_all(&journal).expect("removed");
    fs::write(&journal, "precious").expect("a file");
    let (code, _, wrong) = run_in(&folder, &verify);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("rows.parquet.chunks is not a file of this program"), "{wrong}");
    assert_eq!(fs::read_to_string(&journal).expect("there"), "precious");
    assert_eq!(names(&folder), ["rows.parquet.chunks", "stage.toml"]);
}

#[test]
fn a_signal_keeps_the_rows_and_leaves_nothing_else() {
    let folder = stage("signals");
    for signal in ["-TERM", "-INT", "-HUP", "-KILL"] {
        interrupted(&folder, "rows.parquet", signal);
        assert_eq!(names(&folder), ["rows.parquet.chunks", "stage.toml"], "{signal}");
        fs::remove_file(folder.join("rows.parquet.chunks")).expect("removed");
    }
}

#[test]
fn damage_is_told_by_name() {
    let folder = stage("damage");
    interrupted(&folder, "rows.parquet", "-KILL");
    let journal = folder.join("rows.parquet.chunks");
    let whole = fs::read(&journal).expect("rows");
    let resume = ["verify", "stage.toml", "--scenarios=20000", "--out", "rows.parquet"];
    let small = ["verify", "stage.toml", "--out", "part.parquet"];
    assert_eq!(run_in(&folder, &small).0, Some(0));
    let part = fs::read(folder.join("part.parquet")).expect("rows");
    let merge = ["verify", "stage.toml", "--merge", "part.parquet"];
    assert_eq!(run_in(&folder, &merge).0, Some(0));
    // A few bits of each; `cargo assure attack` goes through more.
    for (file, bytes, arguments) in
        [("rows.parquet.chunks", whole, &resume[..]), ("part.parquet", part, &merge)]
    {
        for place in 0..12 {
            let mut damaged = bytes.clone();
            // In the journal up to its third record, as what is last may be half there.
            let byte = place * bytes.len().min(5000) / 12;
            damaged[byte] ^= 1 << (place % 8);
            fs::write(folder.join(file), &damaged).expect("written");
            let (code, printed, wrong) = run_in(&folder, arguments);
            assert_eq!((code, printed.as_str()), (Some(2), ""), "byte {byte} of {file}: {wrong}");
            assert!(wrong.contains(file), "byte {byte} of {file}: {wrong}");
            assert!(fs::read(folder.join(file)).expect("there") == damaged, "it is left as it is");
        }
    }
}

#[test]
fn rows_can_be_printed() {
    let folder = stage("printed");
    let verify = ["verify", "stage.toml", "--out"];
    let (code, verdict, _) = run_in(&folder, &[&verify[..], &["rows.parquet"]].concat());
    assert_eq!(code, Some(0));
    let mut child = command_in(&folder, &[&verify[..], &["-"]].concat())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("runs");
    let mut rows = Vec::new();
    child.stdout.take().expect("a pipe").read_to_end(&mut rows).expect("read");
    let told: Vec<_> = BufReader::new(child.stderr.take().expect("a pipe"))
        .lines()
        .map_while(Result::ok)
        .collect();
    assert!(rows == fs::read(folder.join("rows.parquet")).expect("there"));
    assert_eq!(format!("{}\n", told.join("\n")), verdict);
    assert!(child.wait().expect("ends").success());
    assert_eq!(names(&folder), ["rows.parquet", "stage.toml"]);
}
