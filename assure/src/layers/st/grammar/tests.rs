//! Goldens that parse, and changes of them that do not.

use super::parse;
use crate::context::workspace;

/// The goldens in Structured Text.
fn goldens() -> Vec<(String, String)> {
    let mut folders = vec![workspace().join("generated")];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder").flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ext| ext == "st") {
                let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
                files.push((name, std::fs::read_to_string(&path).expect("a file")));
            }
        }
    }
    files
}

fn others(name: &str) -> [String; 2] {
    ["pi0", "after"].map(|law| format!("{name}_{law}"))
}

#[test]
fn emitted_structured_text_parses() {
    let files = goldens();
    assert!(files.len() > 30);
    for (name, text) in files {
        assert_eq!(parse(&text, &others(&name)), Ok(()), "{name}");
    }
}

#[test]
fn invalid_structured_text_is_refused() {
    let changes = [
        ("END_STRUCT;", "END_STRUCT"),
        ("_vector2; (* ", "_vector2 (* "),
        ("LREAL#0.0", "LREAL#1.7E+308"),
        ("LREAL#0.0", "LREAL#1E5"),
        ("LREAL#0.0", "0.0f"),
        ("VAR_TEMP\n", "VAR_TEMP\n    more : table_fields;\n"),
        ("VAR_TEMP\n", "VAR_TEMP\n    more : table_other;\n"),
        ("VAR_TEMP\n", "VAR_TEMP\n    a__b : LREAL;\n"),
        ("VAR_TEMP\n", "VAR_TEMP\n    type : LREAL;\n"),
        ("x : table_vector2", "x : ARRAY[1..2] OF LREAL"),
        ("ABS(", "FABS("),
        (" := ", " = "),
        (" THEN", ""),
        ("END_IF;", "END_IF"),
        ("END_IF;", ""),
        ("END_FUNCTION_BLOCK", ""),
        ("(*", "(* (*"),
        ("NOT (", "! ("),
        ("LREAL#1.0 - v1", "LREAL#1.0 - - - v1"),
    ];
    let (_, text) = goldens().into_iter().find(|(name, _)| name == "table").expect("a table");
    for (good, bad) in changes {
        let changed = text.replacen(good, bad, 1);
        assert_ne!(changed, text, "{good}");
        assert!(parse(&changed, &[]).is_err(), "{bad}");
    }
}
