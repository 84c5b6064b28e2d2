//! The pages of docs/ as one book.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result};

use crate::context::{Context, workspace};
use crate::harness::command::{succeed, text};
use crate::harness::runtime;
use crate::layer::{Finding, Layer};
use crate::tool::{CHROMIUM, PYTHON, ShownBy, Source, Tool};

pub(super) const LAYER: Layer = Layer {
    name: "book",
    claim: "mdBook makes one book of docs/: it has every page, and each link of it leads to a page, a \
            heading, or a file of the repository, each picture is shown, and no page is wider than a phone.",
    tools: &[CHROMIUM, MDBOOK, PYTHON],
    run,
};

const MDBOOK: Tool = Tool {
    name: "mdBook",
    shown_by: ShownBy::Command(&["mdbook", "--version"]),
    source: Source::Cargo(&["mdbook", "--no-default-features", "--features", "search"]),
};

const SCRIPT: &str = include_str!("book.py");

/// Package that drives the browser.
const PLAYWRIGHT: &str = "playwright==1.65.2";

/// Address behind links to files that are not pages.
const REPOSITORY: &str = "https://github.com/ptc-codegen/ptc/blob/main/";

/// Files that mdBook makes without a page.
const OWN: [&str; 3] = ["print.html", "toc.html", "404.html"];

/// Added to a page, each is a fault.
const DEFECTS: [(&str, &str); 5] = [
    ("a link to a page that is not there", "[a](no_such.md)"),
    ("a link to a heading that is not there", "[a](verify.md#no-such-heading)"),
    ("a link to a file that is not in the repository", "[a](../examples/no_such.toml)"),
    ("a line that is wider than a phone", "<p style=\"width: 600px\">wide</p>"),
    (
        "a picture that a browser cannot show",
        "![a](https://github.com/ptc-codegen/ptc/blob/main/docs/picture.svg)",
    ),
];

fn run(context: &Context) -> Result<Finding> {
    let (pages, links, failures) = examine(context, "")?;
    let mut finding = Finding { failures, ..Finding::default() };
    for (defect, added) in context.in_turn(DEFECTS.to_vec()) {
        let (.., faults) = examine(context, added)?;
        finding.seed(defect, faults.into_iter().next());
    }
    finding.summary = format!("{pages} pages, {links} links");
    Ok(finding)
}

/// The number of pages and links, and what is wrong with them, of a book whose first page has an addition.
fn examine(context: &Context, added: &str) -> Result<(usize, usize, Vec<String>)> {
    let folder = context.scratch("book");
    for part in ["docs", "tools", "ptc-codegen/catalogue"] {
        copy(&workspace().join(part), &folder.join(part))?;
    }
    let first = folder.join("docs/start.md");
    fs::write(&first, format!("{}\n{added}\n", fs::read_to_string(&first)?))?;
    succeed(Command::new("mdbook").args(["build", "docs"]).current_dir(&folder))?;
    let book = folder.join("target/book");
    let mut texts = BTreeMap::new();
    for path in files(&book)? {
        if path.extension().is_some_and(|extension| extension == "html") {
            texts.insert(path.clone(), fs::read_to_string(&path)?);
        }
    }
    let mut faults = Vec::new();
    // The paper is written for a journal, whose citations mdBook does not know.
    let paper = folder.join("docs/paper");
    let pages = files(&folder.join("docs"))?.into_iter().filter(|path| {
        path.extension().is_some_and(|extension| extension == "md")
            && !path.ends_with("SUMMARY.md")
            && !path.starts_with(&paper)
    });
    let mut count = 0;
    for page in pages {
        let name = page.strip_prefix(folder.join("docs"))?.with_extension("html");
        let made =
            if name.ends_with("README.html") { name.with_file_name("index.html") } else { name };
        count += 1;
        if !texts.contains_key(&book.join(&made)) {
            faults.push(format!("{} is not in docs/SUMMARY.md", made.display()));
        }
    }
    let mut links = 0;
    for (path, text) in &texts {
        if OWN.iter().any(|own| path.ends_with(own)) {
            continue;
        }
        for link in values(text, " href=\"").chain(values(text, " src=\"")) {
            links += 1;
            if let Some(fault) = broken(&texts, path, link) {
                let shown = path.strip_prefix(&book)?.display();
                faults.push(format!("{shown}: {link}: {fault}"));
            }
        }
    }
    // Of a defect, the page that has it.
    let (shown, pictures) = match added.is_empty() {
        true => (book.clone(), Some(context.scratch("book-pictures"))),
        false => (book.join("start.html"), None),
    };
    faults.extend(seen(context, &book, &shown, pictures.as_deref())?);
    faults.sort();
    faults.dedup();
    Ok((count, links, faults))
}

/// Returns the faults in a browser of `shown`, one page of the book or all in its folder; pictures of some are left in
/// a folder.
fn seen(
    context: &Context,
    book: &Path,
    shown: &Path,
    pictures: Option<&Path>,
) -> Result<Vec<String>> {
    let python = runtime::python(&context.shared("playwright"), &[PLAYWRIGHT])?;
    let script = book.join("book.py");
    fs::write(&script, SCRIPT)?;
    let mut look = Command::new(&python);
    let told = text(look.arg(&script).arg("chromium").args([book, shown]).args(pictures))?;
    let told: BTreeMap<String, Vec<String>> = serde_json::from_str(&told)?;
    let faults = |(page, faults): (String, Vec<String>)| {
        faults.into_iter().map(move |fault| format!("{page}: {fault}"))
    };
    Ok(told.into_iter().flat_map(faults).collect())
}

/// Returns the fault of a link of a page.
fn broken(texts: &BTreeMap<PathBuf, String>, page: &Path, link: &str) -> Option<&'static str> {
    if let Some(path) = link.strip_prefix(REPOSITORY) {
        let path = path.split('#').next().unwrap_or_default();
        return (!workspace().join(path).exists()).then_some("not in the repository");
    }
    if link.contains("://") || link.starts_with("data:") || link.starts_with("mailto:") {
        return None;
    }
    let (path, heading) = link.split_once('#').unwrap_or((link, ""));
    let target = match path {
        "" => page.to_owned(),
        path => plain(&page.parent()?.join(path)),
    };
    match texts.get(&target) {
        Some(text) => {
            let there = heading.is_empty() || text.contains(&format!(" id=\"{heading}\""));
            (!there).then_some("no such heading")
        }
        None => (!target.exists()).then_some("no such page"),
    }
}

/// A path without `.` and `..`.
fn plain(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut plain, part| {
        match part {
            Component::ParentDir => drop(plain.pop()),
            Component::CurDir => {}
            part => plain.push(part),
        }
        plain
    })
}

/// The texts in quotes behind each occurrence of a key.
fn values<'a>(text: &'a str, key: &'a str) -> impl Iterator<Item = &'a str> {
    text.split(key).skip(1).filter_map(|rest| rest.split('"').next())
}

/// All files below a folder.
fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let path = entry?.path();
        if path.is_dir() { found.extend(files(&path)?) } else { found.push(path) }
    }
    found.sort();
    Ok(found)
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    for path in files(from)? {
        let copied = to.join(path.strip_prefix(from)?);
        fs::create_dir_all(copied.parent().context("a folder")?)?;
        fs::copy(&path, copied)?;
    }
    Ok(())
}
