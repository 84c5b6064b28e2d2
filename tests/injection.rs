//! Nothing that a user writes ends a comment or a text of an emitted file, or reaches a shell.

#[path = "support/command.rs"]
mod command;
#[path = "support/inert.rs"]
mod inert;

use std::cell::Cell;
use std::fmt::Write as _;

use command::spec_of;
use inert::{breach, frame, is_of_a_tool};
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};
use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::{File, Language, Project};
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::parse;
use ptc_codegen::{design, generate, project};

/// What ends comments and texts, or is read by shells, CMake, make, HTML, MATLAB and terminals.
const ODD: [&str; 36] = [
    "*/",
    "/*",
    "*)",
    "(*",
    "//",
    "\n",
    "\r\n",
    "\\",
    "\"",
    "\"\"\"",
    "'",
    "`id`",
    "$(id)",
    "${X}",
    "$X",
    "<b>",
    "</script>",
    "<!--",
    "-->",
    "]]>",
    "%>",
    "%{",
    "%}",
    "??/",
    "#",
    "#define X",
    ";",
    "&amp;",
    "|",
    "!",
    "\0",
    "\u{1b}[31m",
    "\u{202e}",
    "\u{85}",
    "\u{2028}",
    "@",
];

/// A legal text, now and then with something odd in it.
fn text(legal: &'static [&'static str]) -> impl Strategy<Value = String> {
    let odd = prop::sample::select(&ODD[..]);
    (prop::sample::select(legal), prop::option::weighted(0.1, (odd, 0_usize..40))).prop_map(
        |(legal, odd)| match odd {
            Some((odd, at)) => {
                let at = at % (legal.len() + 1);
                format!("{}{odd}{}", &legal[..at], &legal[at..])
            }
            None => legal.to_owned(),
        },
    )
}

fn always(
    key: &'static str,
    legal: &'static [&'static str],
) -> impl Strategy<Value = Option<(String, String)>> {
    text(legal).prop_map(move |text| Some((key.to_owned(), text)))
}

fn one(
    key: &'static str,
    legal: &'static [&'static str],
) -> impl Strategy<Value = Option<(String, String)>> {
    prop::option::of(text(legal)).prop_map(move |text| text.map(|text| (key.to_owned(), text)))
}

/// The keys of a design with their values.
fn design() -> impl Strategy<Value = Vec<(String, String)>> {
    let mapping = prop_oneof![
        always(
            "mu",
            &["exp", "exp(a=2)", "exp_sum(rates=[1, 2])", "tau*a*t/(1 + a*t)", "power(m=b)"]
        ),
        always("kappa", &["-ln(1 - dt/tau)/a", "dt/(tau - dt)*own", "tau*dt/(tau - dt)"]),
    ];
    let law = prop_oneof![
        one("gains", &["120,74,15", "[1e2, 74, 1.50]", "+6,11,6"]),
        one("poles", &["-4,-3+2i,-3-2i", "[-1, -2, -3]", "-1 , -1+1i,-1-1i"]),
        one("pi0", &["-20*xi1 - 9*xi2/psi", "-xi1*(1 + xi2^2)", "extern", "-a*xi1"]),
    ];
    let others = (
        one("name", &["roll", "Stage_2", "a1b", "x_y"]),
        one("g", &["2 + cos(x1)", "b", "(x1)/2 + 3"]),
        (one("tau", &["2", "2.50", "1e1", "0x10"]), one("t0", &["0", "-1.5e0"])),
        one("eps", &["1e-3", "0.001"]),
        (one("u_max", &["5", "inf"]), one("after", &["zero", "extern", "hold"])),
        one("params.psi", &["0.5", "2e0"]),
        one("precision", &["f32", "f64"]),
        prop::option::weighted(
            0.1,
            (text(&["params.psi", "params.own", "params.gain_of"]), text(&["2", "1.5"])),
        ),
    );
    (mapping, law, others).prop_map(|(mapping, law, others)| {
        let (name, g, (tau, t0), eps, (u_max, after), psi, precision, own) = others;
        let fixed = [("n", "3"), ("allow", "membership,growth,sampling")];
        let fixed = fixed.map(|(key, value)| (key.to_owned(), value.to_owned()));
        let keys = [mapping, law, name, g, tau, t0, eps, u_max, after, psi, precision, own];
        fixed.into_iter().chain(keys.into_iter().flatten()).collect()
    })
}

/// The design of the texts, each as the value of a flag.
fn by_flags(keys: &[(String, String)]) -> Option<Spec> {
    let mut entries = Vec::new();
    for (key, text) in keys {
        let value = parse(key, text, &mut |_| Place(0)).ok()?;
        entries.push(Entry { key: key.clone(), place: Place(0), value });
    }
    read(&entries).ok()
}

/// The same from a file, where the texts are strings as they are.
fn by_file(keys: &[(String, String)]) -> Option<Spec> {
    let mut file = String::new();
    for (key, text) in keys {
        let text = text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n");
        let _ = writeln!(file, "{key} = \"{text}\"");
    }
    let (entries, found) = design::read(&file, &mut |_| Place(0));
    if found.is_empty() { read(&entries).ok() } else { None }
}

/// All files that can be emitted for a design.
fn files(spec: &Spec) -> Vec<File> {
    let languages = Language::ALL.into_iter().filter_map(|language| generate(spec, language).ok());
    let projects = Project::ALL.into_iter().filter_map(|kind| project(spec, kind).ok());
    languages.chain(projects).flatten().collect()
}

/// What build tools read is that of a plain design, the name aside.
fn tools(spec: &Spec) -> Result<(), TestCaseError> {
    let plain = Spec { name: Some("plain_design".to_owned()), ..spec.clone() };
    for kind in Project::ALL {
        let (Ok(own), Ok(plain)) = (project(spec, kind), project(&plain, kind)) else { continue };
        let own = own.iter().filter(|file| is_of_a_tool(file));
        let plain = plain.iter().filter(|file| is_of_a_tool(file));
        for (own, plain) in own.zip(plain) {
            prop_assert_eq!(frame(own, &spec.name()), frame(plain, "plain_design"));
        }
    }
    Ok(())
}

fn seed() -> RngSeed {
    match ProptestConfig::default().rng_seed {
        RngSeed::Random => RngSeed::Fixed(20),
        given @ RngSeed::Fixed(_) => given,
    }
}

#[test]
fn nothing_of_a_design_is_read_as_code() {
    let config = ProptestConfig {
        cases: 60,
        failure_persistence: None,
        rng_seed: seed(),
        ..ProptestConfig::default()
    };
    // Designs that were read, and files that were emitted.
    let (read, emitted) = (Cell::new(0), Cell::new(0));
    let outcome = TestRunner::new(config).run(&design(), |keys| {
        for spec in [by_flags(&keys), by_file(&keys)].into_iter().flatten() {
            // Panics at what a shell would read.
            prop_assert_eq!(spec_of(&spec.command()), Ok(spec.clone()));
            let name = spec.name();
            prop_assert!(name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'), "{}", name);
            let files = files(&spec);
            let breach = files.iter().find_map(breach);
            prop_assert!(breach.is_none(), "{:?} of {:?}", breach, keys);
            tools(&spec)?;
            read.set(read.get() + 1);
            emitted.set(emitted.get() + files.len());
        }
        Ok(())
    });
    assert!(outcome.is_ok(), "{}", outcome.err().map_or_else(String::new, |e| e.to_string()));
    assert!(
        read.get() > 10 && emitted.get() > 200,
        "{} designs, {} files",
        read.get(),
        emitted.get()
    );
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
