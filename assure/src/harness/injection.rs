//! Random designs with odd texts in them, and what is emitted for them: nothing that a user writes
//! ends a comment or a text of an emitted file, or reaches a shell.

#[path = "../../../tests/support/command.rs"]
mod command;

use std::fmt::Write as _;

use ptc_codegen::diagnostic::Place;
use ptc_codegen::emit::{File, Language, Project};
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::parse;
use ptc_codegen::{design, generate, project};

use super::inert::{breach, is_of_a_tool, renamed};
use super::random::Random;
use command::spec_of;

/// Texts that end comments and strings, or are special to shells, CMake, make, HTML, MATLAB and terminals.
pub const ODD: [&str; 36] = [
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

/// Counts of the examination.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Designs that were drawn.
    pub drawn: usize,
    /// Designs among them that are legal, by flags or as a file.
    pub legal: usize,
    /// Files that were emitted for them.
    pub files: usize,
    /// User text that was read as code.
    pub breaches: Vec<String>,
}

/// Draws designs until `legal` of them are legal, and examines all that is emitted for these.
pub fn examine(random: &mut Random, legal: usize) -> Tally {
    let mut tally = Tally::default();
    while tally.legal < legal {
        let keys = design(random);
        tally.drawn += 1;
        for spec in [by_flags(&keys), by_file(&keys)].into_iter().flatten() {
            tally.legal += 1;
            let files = files(&spec);
            tally.files += files.len();
            let found = wrong(&spec, &files);
            tally.breaches.extend(found.map(|what| format!("{what}\n{keys:?}")));
        }
    }
    tally
}

/// Returns the fault of the output for a design.
fn wrong(spec: &Spec, files: &[File]) -> Option<String> {
    let line = spec.command();
    // Panics at what a shell would read.
    if spec_of(&line).as_ref() != Ok(spec) {
        return Some(format!("another design: {line}"));
    }
    if !spec.name().chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        return Some(format!("the name {}", spec.name()));
    }
    files.iter().find_map(breach).or_else(|| tools(spec))
}

/// Returns the difference between the files of build tools and those of a plain design, the name aside.
fn tools(spec: &Spec) -> Option<String> {
    let plain = Spec { name: Some("plain_design".to_owned()), ..spec.clone() };
    for kind in Project::ALL {
        let (Ok(own), Ok(plain)) = (project(spec, kind), project(&plain, kind)) else { continue };
        let own = own.iter().filter(|file| is_of_a_tool(file));
        let plain = plain.iter().filter(|file| is_of_a_tool(file));
        for (own, plain) in own.zip(plain) {
            if own != &renamed(plain, "plain_design", &spec.name()) {
                return Some(format!("{} differs from that of a plain design", own.name));
            }
        }
    }
    None
}

/// All files that can be emitted for a design.
fn files(spec: &Spec) -> Vec<File> {
    let languages = Language::ALL.into_iter().filter_map(|language| generate(spec, language).ok());
    let projects = Project::ALL.into_iter().filter_map(|kind| project(spec, kind).ok());
    languages.chain(projects).flatten().collect()
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

/// One of several.
pub fn of<T: Copy>(random: &mut Random, choices: &[T]) -> T {
    choices[usize::try_from(random.below(choices.len() as u64)).unwrap_or(0)]
}

/// A legal text, now and then with something odd in it.
fn text(random: &mut Random, legal: &[&str]) -> String {
    let mut text = of(random, legal).to_owned();
    if random.below(10) == 0 {
        let at = usize::try_from(random.below(text.len() as u64 + 1)).unwrap_or(0);
        text.insert_str(at, of(random, &ODD));
    }
    text
}

/// Keys with legal texts; of a group, one key is given.
type Group<'a> = &'a [(&'a str, &'a [&'a str])];

const ALWAYS: Group = &[
    ("mu", &["exp", "exp(a=2)", "exp_sum(rates=[1, 2])", "tau*a*t/(1 + a*t)", "power(m=b)"]),
    ("kappa", &["-ln(1 - dt/tau)/a", "dt/(tau - dt)*own", "tau*dt/(tau - dt)"]),
];

const SOMETIMES: [Group; 10] = [
    &[
        ("gains", &["120,74,15", "[1e2, 74, 1.50]", "+6,11,6"]),
        ("poles", &["-4,-3+2i,-3-2i", "[-1, -2, -3]", "-1 , -1+1i,-1-1i"]),
        ("pi0", &["-20*xi1 - 9*xi2/psi", "-xi1*(1 + xi2^2)", "extern", "-a*xi1"]),
    ],
    &[("name", &["roll", "Stage_2", "a1b", "x_y", "status"])],
    &[("g", &["2 + cos(x1)", "b", "(x1)/2 + 3"])],
    &[("tau", &["2", "2.50", "1e1", "0x10"])],
    &[("t0", &["0", "-1.5e0"])],
    &[("eps", &["1e-3", "0.001"])],
    &[("u_max", &["5", "inf"])],
    &[("after", &["zero", "extern", "hold"])],
    &[("params.psi", &["0.5", "2e0"])],
    &[("precision", &["f32", "f64"])],
];

/// The keys of a design with their values.
fn design(random: &mut Random) -> Vec<(String, String)> {
    let fixed = [("n", "3"), ("allow", "membership,growth,sampling")];
    let mut keys = fixed.map(|(key, value)| (key.to_owned(), value.to_owned())).to_vec();
    let given = |random: &mut Random, group: Group| {
        let (key, legal) = of(random, group);
        (key.to_owned(), text(random, legal))
    };
    keys.push(given(random, ALWAYS));
    for group in SOMETIMES {
        if random.below(2) == 0 {
            keys.push(given(random, group));
        }
    }
    if random.below(10) == 0 {
        let key = text(random, &["params.psi", "params.own", "params.gain_of"]);
        keys.push((key, text(random, &["2", "1.5"])));
    }
    keys
}
