//! Designs that a project refuses, and names reserved by its tools.

use std::fs;
use std::path::Path;

use super::compiled::DESIGNS;
use super::support::folder;
use super::{DESIGN, KINDS, emit, told};

#[test]
fn what_a_project_cannot_do_is_refused() {
    let folder = folder("projects_refused");
    for (flags, parts) in [
        (&["--n=2", "--mu=exp", "--pi0=extern"][..], &["pi0", "user-defined pi0"][..]),
        (&["--n=2", "--mu=exp", "--after=extern"], &["after the deadline"]),
        (&["--n=2", "--mu=exp", "--what=associated"], &["infinite-time system"]),
        (&["--n=2", "--mu=exp", "--g=1+x1^2"], &["with a number for g"]),
        (&["--n=2", "--axes=2", "--mu=exp", "--g=[2, 1/mass]"], &["with a number for g"]),
        (
            &["--mu=exp", "--states=p,q", "--inputs=a,b", "--outputs=p,q", "--dynamics=a,b"],
            &["dynamics", "the plant of a project is x_n' = g u"],
        ),
        (&["--n=2", "--mu=exp", "--name=plant"], &["`plant`", "choose another name"]),
        (&["--n=2", "--mu=exp", "--lang=c"], &["--lang", "cannot be used with"]),
        (&["--n=2", "--mu=expp"], &["did you mean `exp`"]),
    ] {
        for (kind, _) in KINDS {
            let text = told(&emit(kind, flags, Some(&folder.join("new")), &folder), 2);
            for part in parts {
                assert!(text.contains(part), "{kind} {flags:?} lacks {part}: {text}");
            }
        }
    }
    assert!(told(&emit("avr", &DESIGN, None, &folder), 2).contains("arduino"));
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0, "nothing is left behind");
}

/// Names of CMake's own targets, of the library that is linked, of files and of crates.
#[test]
fn names_of_the_tools_are_refused() {
    let home = folder("projects_names");
    for kind in ["cmake", "cortex-m", "rust-embedded", "arduino"] {
        for name in ["test", "all", "install", "clean", "help", "ZERO_CHECK", "m", "startup"] {
            let arguments = [DESIGNS[3], &["--name", name]].concat();
            let output = emit(kind, &arguments, Some(Path::new("out")), &home);
            assert!(told(&output, 2).contains("error[reserved-name]"), "{kind} {name}");
            assert!(!home.join("out").exists());
        }
    }
}
