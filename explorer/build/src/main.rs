//! Builds the explorer: the generator as WebAssembly and all that shows it, in one file of HTML.

mod sorted;

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, ensure};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use lzma_rust2::{LzmaOptions, LzmaWriter};
use serde_json::{Map, Value, json};
use sorted::sorted;

const TARGET: &str = "wasm32-wasip1";
const PROFILE: &str = "page";

/// Bytes of which the packer finds earlier ones again: more than the generator has.
const DICTIONARY: u32 = 1 << 22;

const PAGE: &str = include_str!("../../page/index.html");
const STYLE: &str = include_str!("../../page/style.css");

/// The script of the worker: what unpacks the generator, and what runs it.
const WORKER: [&str; 3] = [
    include_str!("../../page/unpack.js"),
    include_str!("../../page/restore.js"),
    include_str!("../../page/worker.js"),
];

/// The modules by the names under which they import each other.
const MODULES: [(&str, &str); 17] = [
    ("chart", include_str!("../../page/chart.js")),
    ("checks", include_str!("../../page/checks.js")),
    ("code", include_str!("../../page/code.js")),
    ("diagram", include_str!("../../page/diagram.js")),
    ("dom", include_str!("../../page/dom.js")),
    ("editor", include_str!("../../page/editor.js")),
    ("engine", include_str!("../../page/engine.js")),
    ("figures", include_str!("../../page/figures.js")),
    ("formulas", include_str!("../../page/formulas.js")),
    ("knobs", include_str!("../../page/knobs.js")),
    ("link", include_str!("../../page/link.js")),
    ("main", include_str!("../../page/main.js")),
    ("output", include_str!("../../page/output.js")),
    ("panels", include_str!("../../page/panels.js")),
    ("plane", include_str!("../../page/plane.js")),
    ("runs", include_str!("../../page/runs.js")),
    ("trials", include_str!("../../page/trials.js")),
];

/// The example that is there at first.
const FIRST: &str = "encoder.toml";

/// States at the start of examples, where 1 in the first state is not what they are for and their heads name no other.
const STARTS: [(&str, &str); 5] = [
    ("drive.toml", "0.1, 0, 0"),
    ("encoder.toml", "0.1, 0"),
    ("levitation.toml", "0.001, 0, 0"),
    ("motor.toml", "0.1, 0, 0"),
    ("table.toml", "0.1, 0"),
];

/// Mappings to compare with: every family, with parameters.
const MAPPINGS: [&str; 7] = [
    "exp(a=1)",
    "rational(a=1)",
    "power(a=1, m=2)",
    "tan(a=1)",
    "tanh(a=0.5)",
    "algebraic(a=1)",
    "exp_sum(rates=[0.5, 1])",
];

fn main() -> Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).context("the workspace")?;
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let target = std::path::absolute(target.unwrap_or_else(|| root.join("target")))?;
    let built = built(root, &target)?;
    let page = page(&built, &examples(root)?)?;
    let out = target.join("explorer");
    fs::create_dir_all(&out)?;
    let path = out.join("explorer.html");
    fs::write(&path, &page).with_context(|| format!("cannot write {}", path.display()))?;
    println!("{}: {} bytes", path.display(), page.len());
    Ok(())
}

/// The generator as WebAssembly, packed.
fn built(root: &Path, target: &Path) -> Result<Vec<u8>> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["build", "--package", "ptc-explorer", "--bins", "--target", TARGET]);
    // A stripped module needs no room at its addresses for a linker that comes later.
    cargo
        .arg("--config")
        .arg(format!("target.{TARGET}.rustflags=[\"-Clink-arg=--compress-relocations\"]"));
    cargo.args(["--profile", PROFILE]).current_dir(root).env("CARGO_TARGET_DIR", target);
    let status = cargo.status().context("cargo cannot be run")?;
    ensure!(status.success(), "cargo build failed; `rustup target add {TARGET}` adds the target");
    let path = target.join(TARGET).join(PROFILE).join("engine.wasm");
    let engine = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
    by_lzma(&sorted(&engine).context("the generator has an instruction that is not known")?)
}

/// The designs that a reader begins with, by their names, in groups.
fn examples(root: &Path) -> Result<Vec<Value>> {
    let groups = [("Examples", "examples"), ("Published controllers", "ptc-codegen/catalogue")];
    let group =
        |(label, folder)| Ok(json!({ "label": label, "designs": designs(&root.join(folder))? }));
    groups.into_iter().map(group).collect()
}

/// The designs in a folder.
fn designs(folder: &Path) -> Result<Vec<Value>> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        paths.extend(path.extension().is_some_and(|end| end == "toml").then_some(path));
    }
    paths.sort();
    let example = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(path)?;
        let own =
            STARTS.iter().find(|(example, _)| *example == name).map(|(_, x0)| (*x0).to_owned());
        let start = own.or_else(|| start(&text)).unwrap_or_default();
        Ok(json!({ "name": name, "text": text, "x0": start }))
    };
    paths.iter().map(example).collect()
}

/// The state at the start in the command by which the head of a design shows it.
fn start(text: &str) -> Option<String> {
    let (_, rest) = text
        .lines()
        .find(|line| line.starts_with('#') && line.contains("--x0"))?
        .split_once("--x0")?;
    let numbers = rest[1..].split_whitespace().next()?;
    Some(numbers.split(',').collect::<Vec<_>>().join(", "))
}

/// Packs the sorted bytes of a module by LZMA, a third shorter than gzip packs the module. The place of a byte says nothing
/// of it, but the byte before says much.
fn by_lzma(bytes: &[u8]) -> Result<Vec<u8>> {
    let by_bytes =
        LzmaOptions { lc: 2, lp: 0, pb: 0, nice_len: 273, ..LzmaOptions::with_preset(9) };
    let options = LzmaOptions { dict_size: DICTIONARY, ..by_bytes };
    let size = u64::try_from(bytes.len())?;
    let mut writer = LzmaWriter::new_use_header(Vec::new(), &options, Some(size))?;
    writer.write_all(bytes)?;
    Ok(writer.finish()?)
}

/// The page around a packed generator.
fn page(engine: &[u8], examples: &[Value]) -> Result<String> {
    let known = json!({
        "mappings": MAPPINGS,
        "examples": examples,
        "first": FIRST,
    });
    let modules: Map<_, _> =
        MODULES.iter().map(|(name, text)| ((*name).to_owned(), json!(module(text)))).collect();
    let parts = [
        ("style", STYLE.to_owned()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("known", within_script(&known)),
        ("worker", WORKER.map(bare).concat()),
        ("imports", within_script(&json!({ "imports": modules }))),
        ("engine", STANDARD.encode(engine)),
    ];
    let mut page = PAGE.to_owned();
    for (name, text) in parts {
        let mark = format!("@{name}@");
        ensure!(page.matches(&mark).count() == 1, "the page has one place for {mark}");
        page = page.replace(&mark, &text);
    }
    Ok(page)
}

/// A module as an address that a page opened from a file can import: as text, which packs better than base64.
fn module(text: &str) -> String {
    // What an address reads in another way, or leaves out.
    let marks = [('%', "%25"), ('#', "%23"), ('\n', "%0A"), ('\t', "%09")];
    let text = marks.iter().fold(bare(text), |text, (mark, code)| text.replace(*mark, code));
    format!("data:text/javascript;charset=utf-8,{text}")
}

/// A script without the lines that are comments, and without indentation: both are for those who write it.
fn bare(text: &str) -> String {
    let mut within = false;
    let mut kept = String::new();
    for line in text.lines().map(str::trim) {
        within |= line.starts_with("/*");
        if !within && !line.starts_with("//") && !line.is_empty() {
            kept.push_str(line);
            kept.push('\n');
        }
        within &= !line.ends_with("*/");
    }
    kept
}

/// JSON that no text in it can close the element of.
fn within_script(value: &Value) -> String {
    value.to_string().replace('<', "\\u003c")
}
