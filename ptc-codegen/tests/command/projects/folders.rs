//! The files of a project and the folder that holds them.

use std::fs;
use std::path::Path;

use super::support::{self, folder};
use super::{DESIGN, KINDS, emit, made, run, told};

/// The files of a folder by their paths in it, with their contents.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(&next).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
                continue;
            }
            let name = path.strip_prefix(folder).expect("within").display().to_string();
            found.push((name, fs::read(&path).expect("readable")));
        }
    }
    found.sort();
    found
}

#[test]
fn each_kind_has_its_files_and_the_same_bytes_twice() {
    let folder = folder("projects_files");
    for (kind, wanted) in KINDS {
        let [a, b] = ["a", "b"].map(|name| folder.join(kind).join(name));
        made(kind, &DESIGN, &a);
        made(kind, &DESIGN, &b);
        let names: Vec<_> = files(&a).into_iter().map(|(name, _)| name).collect();
        assert_eq!(names, wanted, "{kind}");
        assert_eq!(files(&a), files(&b), "{kind}");
        let beside: Vec<_> = fs::read_dir(folder.join(kind)).expect("a folder").collect();
        assert_eq!(beside.len(), 2, "nothing is left beside the project");
    }
}

/// The controller in a project is what `--lang` writes, in f32 for Arduino.
#[test]
fn the_controller_is_the_emitted_one() {
    let folder = folder("projects_controller");
    let emitted = |lang: &str, precision: &str, name: &str| {
        let own = folder.join(format!("{lang}_{precision}"));
        let mut command = support::command(&["emit", "--lang", lang, "--precision", precision]);
        run(command.arg("-o").arg(&own).args(DESIGN));
        fs::read(own.join(name)).expect("written")
    };
    for (kind, _) in KINDS {
        let precision = if kind == "arduino" { "f32" } else { "f64" };
        let home = folder.join(kind);
        made(kind, &DESIGN, &home);
        for (name, content) in files(&home) {
            let wanted = match Path::new(&name).file_name().and_then(|name| name.to_str()) {
                Some(own @ ("stage.h" | "stage.c")) => emitted("c", precision, own),
                Some(own @ "stage.rs") => emitted("rust", precision, own),
                _ => continue,
            };
            assert!(content == wanted, "{kind}: {name}");
        }
    }
}

#[test]
fn a_folder_is_made_as_a_whole_and_never_over_another() {
    let folder = folder("projects_folders");
    // Without a folder it is that of the name.
    let output = emit("cmake", &DESIGN, None, &folder);
    assert!(output.status.success());
    let home = folder.join("stage");
    let first = files(&home);
    assert!(made("cmake", &DESIGN, &home).lines().all(|line| line.starts_with("unchanged ")));
    // A build beside the files is nothing to complain of, a changed file is.
    fs::create_dir(home.join("build")).expect("writable");
    made("cmake", &DESIGN, &home);
    let mine = home.join("example/config.h");
    fs::write(&mine, "mine").expect("writable");
    let text = told(&emit("cmake", &DESIGN, Some(&home), &folder), 2);
    assert!(text.contains("is not empty") && text.contains("give a new folder"), "{text}");
    assert_eq!(fs::read(&mine).expect("there"), b"mine");
    assert_eq!(files(&home).len(), first.len());

    let other = folder.join("other");
    fs::create_dir(&other).expect("writable");
    made("cmake", &DESIGN, &other);
    assert_eq!(files(&other), first, "an empty folder is taken");
    let text = told(&emit("arduino", &DESIGN, Some(&other), &folder), 2);
    assert!(text.contains("is not empty"), "{text}");
    assert_eq!(files(&other), first);
    let file = folder.join("file");
    fs::write(&file, "").expect("writable");
    told(&emit("arduino", &DESIGN, Some(&file), &folder), 2);
    told(&emit("arduino", &DESIGN, Some(&file.join("below")), &folder), 2);
    told(&emit("arduino", &DESIGN, Some(Path::new("-")), &folder), 2);
    told(&emit("arduino", &DESIGN, Some(Path::new(".")), &folder), 2);
    let left: Vec<_> =
        files(&folder).into_iter().filter(|(name, _)| name.contains("tmp")).collect();
    assert_eq!(left, []);
}

#[test]
fn check_tells_drift_and_writes_nothing() {
    let folder = folder("projects_check");
    let home = folder.join("stage");
    let check = [&DESIGN[..], &["--check"]].concat();
    assert!(told(&emit("cmake", &check, Some(&home), &folder), 1).contains("is missing"));
    assert!(!home.exists());
    made("cmake", &DESIGN, &home);
    assert_eq!(told(&emit("cmake", &check, Some(&home), &folder), 0), "");
    fs::write(home.join("src/stage.c"), "").expect("writable");
    let text = told(&emit("cmake", &check, Some(&home), &folder), 1);
    assert!(text.contains("src/stage.c differs"), "{text}");
}

#[test]
fn the_plant_is_told_for_every_order() {
    let folder = folder("told_plant");
    for (n, g, plant) in [
        ("1", None, "with its plant, x1' = u, up to"),
        ("2", None, "with its plant, x1' = x2, x2' = u, up to"),
        ("3", Some("2"), "with its plant, x1' = x2, ..., x3' = g u, g = 2, up to"),
    ] {
        let out = folder.join(n);
        let gain = g.map(|g| ["--g", g]);
        let own = ["--n", n, "--mu", "exp", "--name", "stage"];
        made("cmake", &[&own[..], gain.as_ref().map_or(&[], |g| &g[..])].concat(), &out);
        let main = fs::read_to_string(out.join("example/main.c")).expect("a program");
        assert!(main.contains(plant), "{main}");
    }
}
