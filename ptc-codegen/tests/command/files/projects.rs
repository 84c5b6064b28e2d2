//! Projects, which are written as a whole.

use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::process::{Command, Stdio};
use std::time::Instant;

use super::names;
use super::support::{command_in, folder, run_in};

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
