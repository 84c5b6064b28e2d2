//! Nothing that a user writes ends a comment or a text of an emitted file, or reaches a shell: a
//! sample of what `cargo assure attack` draws.

use ptc_assure::harness::inert::breach;
use ptc_assure::harness::injection::examine;
use ptc_assure::harness::random::Random;
use ptc_codegen::emit::File;

#[test]
fn nothing_of_a_design_is_read_as_code() {
    let tally = examine(&mut Random(20), 4);
    assert!(tally.breaches.is_empty(), "{}", tally.breaches.join("\n"));
    assert!(tally.files > 60, "{tally:?}");
}

/// The check sees what it is for: each text ends a comment, a string or a tag of its language.
#[test]
fn a_breach_is_seen() {
    for (name, text) in [
        ("a.c", "/* mu */ system(0); */\nint a;\n"),
        ("a.c", "/* mu /* */\n"),
        ("a.c", "// mu \\\nint a;\n"),
        ("a.h", "char *a = \"b\nc\";\n"),
        ("a.c", "int a = `id`;\n"),
        ("a.rs", "/* mu */ fn a() {} */\n"),
        ("a.py", "\"\"\"mu\"\"\" a; \"\"\"\n"),
        ("a.py", "\"\"\"mu\n"),
        ("a.m", "error('a'b');\n"),
        ("a.m", "% mu\n!id\n"),
        ("a.st", "(* mu *) a := 1; *)\n"),
        ("a.st", "(* mu (* *)\n"),
        ("a.xml", "<a b=\"<c>\"/>"),
        ("a.xml", "<a b=\"&c\"/>"),
        ("a.c", "/* \u{202e} */\n"),
        ("Makefile", "a:\u{1b}\n"),
    ] {
        let file = File { name: name.to_owned(), text: text.to_owned() };
        assert!(breach(&file).is_some(), "{name}: {text}");
    }
}
