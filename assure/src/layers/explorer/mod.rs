//! The explorer, built and used in a browser.

mod cases;
mod command;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};
use serde_json::{Value, json};

use super::command::generator;
use crate::context::{Context, workspace};
use crate::harness::command::{succeed, text};
use crate::harness::runtime;
use crate::layer::{Finding, Layer, Table};
use crate::tool::{CHROMIUM, PYTHON, RUSTC, ShownBy, Source, Tool};
use cases::{Case, FEW, cases};
use command::{Said, emitted, seen};

pub(super) const LAYER: Layer = Layer {
    name: "explorer",
    claim: "The explorer shows, for every design, the bytes and the messages of `emit`; it requests \
            nothing, starts within its budgets of size and time, and fits a phone.",
    tools: &[CHROMIUM, PYTHON, RUSTC, WASM],
    run,
};

const WASM: Tool = Tool {
    name: "Rust for wasm32-wasip1",
    shown_by: ShownBy::Command(&[
        "sh",
        "-c",
        "test -d \"$(rustc --print sysroot)/lib/rustlib/wasm32-wasip1/lib\"",
    ]),
    source: Source::Rustup(&["target", "add", "wasm32-wasip1"]),
};

const SCRIPTS: [(&str, &str); 2] =
    [("look.py", include_str!("look.py")), ("tour.py", include_str!("tour.py"))];

/// Package that drives the browser.
const PLAYWRIGHT: &str = "playwright==1.65.2";

/// Languages with a tab.
const LANGUAGES: [&str; 7] = ["c", "rust", "cpp", "matlab", "python", "st", "plcopen"];

/// Most bytes of the page when it is compressed by gzip: one MiB.
const BYTES: usize = 1 << 20;

/// Most milliseconds to the first answer, and those that a processor works for it. Another gate may keep the other
/// processor busy meanwhile, which doubles the first, and adds a third to the second.
const START: f64 = 2000.0;
const BUSY: f64 = 1500.0;

/// Output of the command for each design in each language.
type Commands = BTreeMap<String, BTreeMap<&'static str, Said>>;

fn run(context: &Context) -> Result<Finding> {
    let python = runtime::python(&context.shared("playwright"), &[PLAYWRIGHT])?;
    let command = generator()?;
    let folder = context.scratch("explorer");
    let page = page(context.target())?;
    let all = cases(&folder, context.brief)?;
    let said = commands(&command, &all, &folder)?;
    let script = folder.join("look.py");
    for (name, text) in SCRIPTS {
        fs::write(folder.join(name), text)?;
    }
    let look = |page: &Path, cases: &[&Case]| look(&python, &script, page, cases, &folder);
    let typed: Vec<_> = all.iter().collect();
    let seen = look(&page, &typed)?;
    let bytes = compressed(&page)?;
    let mut finding = Finding { failures: faults(&seen, bytes, &said), ..Finding::default() };
    let few: Vec<_> = all.iter().filter(|case| FEW.contains(&&*case.name)).collect();
    for (defect, page) in context.in_turn(seeds(&page, &folder)?) {
        let caught = match look(&page, &few) {
            Ok(seen) => faults(&seen, compressed(&page)?, &said).into_iter().next(),
            Err(error) => Some(format!("{error:#}").lines().next().unwrap_or_default().to_owned()),
        };
        finding.seed(defect, caught);
    }
    let start = seen["start"].as_f64().unwrap_or(f64::NAN);
    let busy = seen["busy"].as_f64().unwrap_or(f64::NAN);
    let good = said.values().filter(|of| of.values().any(Result::is_ok)).count();
    finding.summary = format!(
        "{good} designs in {} languages and {} with mistakes as `emit` has them; {bytes} bytes compressed, first answer after {start:.0} ms, for {busy:.0} ms of which a processor works",
        LANGUAGES.len(),
        said.len() - good
    );
    finding.tables.push(table(&seen, &said));
    Ok(finding)
}

/// Builds the page by the command that its documentation names.
fn page(target: &Path) -> Result<PathBuf> {
    let mut build = Command::new("cargo");
    build.args(["explorer"]).current_dir(workspace()).env("CARGO_TARGET_DIR", target);
    succeed(&mut build)?;
    Ok(target.join("explorer/explorer.html"))
}

fn commands(generator: &Path, cases: &[Case], folder: &Path) -> Result<Commands> {
    let out = folder.join("emitted");
    let of = |case: &Case| {
        let in_each = LANGUAGES
            .map(|language| emitted(generator, case, language, &out).map(|said| (language, said)));
        Ok((case.name.clone(), in_each.into_iter().collect::<Result<_>>()?))
    };
    cases.iter().map(of).collect()
}

/// Returns the view of a page in a browser.
fn look(
    python: &Path,
    script: &Path,
    page: &Path,
    cases: &[&Case],
    folder: &Path,
) -> Result<Value> {
    let designs: Vec<_> =
        cases.iter().map(|case| json!({ "name": case.name, "text": case.text })).collect();
    let list = folder.join("designs.json");
    fs::write(&list, json!(designs).to_string())?;
    let mut look = Command::new(python);
    look.arg(script).arg("chromium").arg(page).arg(&list).arg(LANGUAGES.join(",")).arg(folder);
    Ok(serde_json::from_str(&text(&mut look)?)?)
}

/// Bytes of a file after gzip, as a server sends it.
fn compressed(path: &Path) -> Result<usize> {
    let output = succeed(Command::new("gzip").args(["-9", "-c"]).arg(path))?;
    Ok(output.stdout.len())
}

/// Pages with defects.
fn seeds(page: &Path, folder: &Path) -> Result<Vec<(&'static str, PathBuf)>> {
    let good = fs::read_to_string(page)?;
    let policy = good.lines().find(|line| line.contains("Content-Security-Policy"));
    let policy = policy.context("the page has a policy")?;
    let with = |text: &str| good.replace("</main>", &format!("{text}</main>"));
    let script = |text: &str| with(&format!("<script>{text}</script>"));
    let answers = "const parse = JSON.parse; JSON.parse = (text) => parse(text.replaceAll(";
    let defects = [
        ("a digit of the code that is another", script(&format!("{answers}'-20.0', '-20.1'))"))),
        (
            "a message that is another",
            script(&format!("{answers}'unknown mapping', 'wrong mapping'))")),
        ),
        (
            "a picture from the network",
            with("<img src=\"http://example.com/x.png\" alt=\"\">").replace(policy, ""),
        ),
        (
            "a start that takes three seconds more",
            script("const end = Date.now() + 3000; while (Date.now() < end) {}"),
        ),
        ("a page that is wider than a phone", with("<p style=\"width: 600px\">wide</p>")),
        ("a control without a name", with("<button></button>")),
        (
            "a head that is not folded",
            script(
                "setInterval(() => document.querySelectorAll('details.fold').forEach((fold) => { fold.open = true; }), 5)",
            ),
        ),
        ("half a megabyte more", with(&format!("<!-- {} -->", noise(500_000)))),
        ("errors that are not underlined", with("<style>#marks mark { display: none }</style>")),
    ];
    let written = defects.into_iter().enumerate().map(|(index, (defect, bad))| {
        ensure!(bad != good, "no place for the defect: {defect}");
        let path = folder.join(format!("defect{index}.html"));
        fs::write(&path, bad)?;
        Ok((defect, path))
    });
    written.collect()
}

/// Letters that gzip cannot make much smaller.
fn noise(count: usize) -> String {
    let mut state = 1_u64;
    let mut letter = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        char::from(b'A' + u8::try_from(state >> 59).unwrap_or(0))
    };
    (0..2 * count).map(|_| letter()).collect()
}

/// Lists the faults of a page.
fn faults(seen: &Value, bytes: usize, said: &Commands) -> Vec<String> {
    let mut faults = Vec::new();
    for (key, told) in [("requests", "requests"), ("refused", "the browser says")] {
        let texts = seen[key].as_array().into_iter().flatten().filter_map(Value::as_str);
        faults.extend(texts.map(|text| format!("{told} {text}")));
    }
    if bytes > BYTES {
        faults.push(format!("{bytes} bytes compressed, more than {BYTES}"));
    }
    let start = seen["start"].as_f64().unwrap_or(f64::INFINITY);
    if start > START {
        faults.push(format!("first answer after {start:.0} ms, more than {START:.0}"));
    }
    let busy = seen["busy"].as_f64().unwrap_or(f64::INFINITY);
    if busy > BUSY {
        faults.push(format!("{busy:.0} ms of work to the first answer, more than {BUSY:.0}"));
    }
    let facts = seen["tour"].as_object();
    let wrong = facts.into_iter().flatten().filter(|(_, holds)| **holds != Value::Bool(true));
    faults.extend(wrong.map(|(fact, _)| format!("it does not hold that {fact}")));
    if facts.is_none() {
        faults.push("the page was not looked at".to_owned());
    }
    let mut papers = BTreeSet::new();
    for (view, looked) in seen["views"].as_object().into_iter().flatten() {
        if looked["too_wide"] != Value::Bool(false) {
            faults.push(format!("{view}: wider than the page"));
        }
        let nameless = looked["nameless"].as_array().into_iter().flatten();
        faults
            .extend(nameless.map(|control| format!("{view}: a control without a name: {control}")));
        papers.insert(looked["paper"].to_string());
    }
    if papers.len() != 2 {
        faults.push(format!("light and dark pages are {papers:?}"));
    }
    let handled = &seen["handled"];
    let expected = json!({
        "tau": true, "pole": true, "errors": [], "overlaid": 2, "from_address": true, "overlaid_from_address": 2,
        "overlaid_at_most": 20, "says_so": true,
    });
    if *handled != expected {
        faults.push(format!("by keyboard and address: {handled}"));
    }
    for (name, typed) in seen["designs"].as_object().into_iter().flatten() {
        match said.get(name) {
            Some(said) => {
                faults.extend(differences(typed, said).map(|text| format!("{name}: {text}")))
            }
            None => faults.push(format!("{name}: not a design of the command")),
        }
    }
    faults
}

/// Lists the differences between a design that was typed and the output of the command for it.
fn differences<'a>(
    typed: &'a Value,
    said: &'a BTreeMap<&'static str, Said>,
) -> impl Iterator<Item = String> + 'a {
    said.iter().flat_map(|(language, said)| {
        let shown = match typed["files"].get(language) {
            Some(files) => files.get("refused").map_or(Ok(files), Err),
            None => Err(&typed["errors"]),
        };
        let mut found = Vec::new();
        match (said, shown) {
            (Ok(files), Ok(shown)) => {
                if json!(files) != *shown {
                    found.push(format!("{language}: files differ from those of emit"));
                }
                if typed["charts"] == 0 && !typed["legend"].to_string().contains("not simulated") {
                    found.push("neither a chart nor a reason".to_owned());
                }
            }
            (Err(messages), Err(errors)) => {
                let shown = seen(errors);
                if *messages != shown {
                    found.push(format!("{language}: {shown:?} for {messages:?}"));
                }
                let underlined = typed["marked"].as_array().map_or(0, Vec::len);
                let placed = typed["errors"].as_array().into_iter().flatten();
                let placed = placed.filter(|error| error["line"].is_string()).count();
                if placed > 0 && underlined == 0 {
                    found.push("no error is underlined".to_owned());
                }
            }
            (Ok(_), Err(errors)) => {
                found.push(format!("{language}: refused by the page: {errors}"))
            }
            (Err(messages), Ok(_)) => found.push(format!("{language}: not refused: {messages:?}")),
        }
        found
    })
}

fn table(seen: &Value, said: &Commands) -> Table {
    let rows = said.iter().map(|(name, said)| {
        let emitted = said.values().filter(|said| said.is_ok()).count();
        let typed = &seen["designs"][name];
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        vec![
            name.clone(),
            text(&typed["verdict"]),
            emitted.to_string(),
            typed["charts"].to_string(),
        ]
    });
    Table {
        title: "Designs typed into the explorer".to_owned(),
        head: vec!["design", "verdict", "languages", "curves"],
        rows: rows.collect(),
    }
}
