//! Contents of the templates.

use std::fs;
use std::path::Path;

/// The operations in a template outside its comments, line by line.
fn operations(text: &str) -> Vec<&str> {
    let is_code = |line: &&str| {
        let line = line.trim_start();
        !["//", "/*", "*", "#", "\"\"\""].iter().any(|open| line.starts_with(open))
    };
    let code = |line: &str| line.split("//").next().unwrap_or_default().to_owned();
    let computes = |line: &&str| {
        let code = code(line);
        [" + ", " - ", " * ", " / ", " += ", " -= ", " *= ", " /= "]
            .iter()
            .any(|o| code.contains(o))
    };
    text.lines().filter(is_code).filter(computes).collect()
}

#[test]
fn no_template_of_a_controller_computes() {
    let templates = Path::new(env!("CARGO_MANIFEST_DIR")).join("templates");
    let mut seen = 0;
    // Folders have what is around a controller: programs that call it, projects, reports.
    for entry in fs::read_dir(&templates).expect("the templates") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|end| end == "txt") {
            let text = fs::read_to_string(&path).expect("a template");
            assert_eq!(operations(&text), Vec::<&str>::new(), "{}", path.display());
            seen += 1;
        }
    }
    assert!(seen >= 6, "{seen} templates of controllers");
    // The plant of an example is computed in one.
    let plant = fs::read_to_string(templates.join("project/sample.c.txt")).expect("a template");
    assert!(!operations(&plant).is_empty());
}
