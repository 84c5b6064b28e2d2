//! Odd texts in designs: in every emitted file, and in the page of a report.

use std::fs;

use anyhow::{Context as _, Result};
use ptc_codegen::diagnostic::visible;
use ptc_codegen::emit::File;
use roxmltree::{Document, Node, ParsingOptions};

use super::world::{DESIGN, World};
use crate::harness::inert::breach;
use crate::harness::injection::{ODD, examine, of};
use crate::harness::random::Random;
use crate::layer::Finding;

/// Options of the report: one run of the plant of the design.
const REPORT: [&str; 7] = ["--x0=1", "--plant=d=0", "--at=0,0.5", "-o", "run.csv", "--report", "-"];

pub(super) fn attack(world: &World, finding: &mut Finding) -> Result<String> {
    let mut random = Random(world.seed);
    let [legal, pages] = if world.brief { [20, 20] } else { [1000, 1000] };
    let tally = examine(&mut random, legal);
    finding.failures.extend(tally.breaches);
    let file = File { name: "a.c".to_owned(), text: "/* mu */ system(0); */\n".to_owned() };
    finding.seed("a text that ends the comment around it", breach(&file));

    let folder = world.folder("pages")?;
    let page = |name: &str, text: &str| -> Result<String> {
        fs::write(folder.join(name), text)?;
        let arguments = [&["simulate", name][..], &REPORT].concat();
        let end = world.run(&folder, &arguments)?;
        fs::remove_file(folder.join(name))?;
        anyhow::ensure!(end.status.success(), "{name}: {}", String::from_utf8_lossy(&end.stderr));
        String::from_utf8(end.stdout).context("a page of UTF-8")
    };
    let plain = page("plain.toml", DESIGN)?;
    for _ in 0..pages {
        let (name, text) = (name(&mut random), commented(&mut random));
        let found = differs(&plain, &page(&name, &text)?, &text);
        finding.failures.extend(found.map(|what| format!("{what}: {name:?} with {text:?}")));
    }
    let text = format!("# <b>\n{DESIGN}");
    let [raw, lost] = [("&#60;b&#62;", "<b></b>"), ("&#60;b&#62;", "")]
        .map(|(from, to)| page("raw.toml", &text).map(|page| page.replace(from, to)));
    finding.seed("a page with a tag of the design", differs(&plain, &raw?, &text));
    finding.seed("a page that leaves a text out", differs(&plain, &lost?, &text));
    let turned = format!("# \u{202e}x\n{DESIGN}");
    let marked = page("turned.toml", &turned)?;
    let mark = "<mark>\\u{202e}</mark>";
    let [raw, unmarked] = ["\u{202e}", "\\u{202e}"].map(|shown| marked.replace(mark, shown));
    finding.seed("a page whose text turns around", differs(&plain, &raw, &turned));
    finding
        .seed("a hidden character that reads as its escape", differs(&plain, &unmarked, &turned));
    Ok(format!(
        "{} designs with odd texts and {} files of them, of which none is read as code; {pages} \
         reports with the elements of a plain design's",
        tally.legal, tally.files
    ))
}

/// The name of a file with something odd in it that a file system takes.
fn name(random: &mut Random) -> String {
    let odd: String = of(random, &ODD).replace(['/', '\0'], "");
    format!("a{odd}b.toml")
}

/// The design with odd comments.
fn commented(random: &mut Random) -> String {
    let mut text = String::new();
    for line in DESIGN.lines() {
        text += line;
        if random.below(3) == 0 {
            // A comment of a design has one line, and no control character.
            let odd = [of(random, &ODD), of(random, &ODD)].concat();
            text += " # ";
            text.extend(odd.chars().filter(|c| !c.is_control()));
        }
        text += "\n";
    }
    text
}

/// The operators of formulas that are not seen: application of a function, and multiplication.
const INVISIBLE: [&str; 2] = ["<mo>\u{2061}</mo>", "<mo>\u{2062}</mo>"];

/// Returns how a page differs from that of a plain design in what is no text, or in the text of the design.
fn differs(plain: &str, page: &str, design: &str) -> Option<String> {
    let without_operators =
        INVISIBLE.iter().fold(page.to_owned(), |page, own| page.replace(own, ""));
    if visible(&without_operators) != without_operators {
        return Some("characters that change how the page is seen".to_owned());
    }
    let options = || ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let parse = |page| Document::parse_with_options(page, options());
    let (plain, page) = match (parse(plain), parse(page)) {
        (Ok(plain), Ok(page)) => (plain, page),
        (plain, page) => return plain.err().or(page.err()).map(|wrong| wrong.to_string()),
    };
    let mut texts = page.descendants().filter(|node| node.tag_name().name() == "pre");
    if shape(&plain) != shape(&page) {
        return Some("other elements".to_owned());
    }
    let quoted = texts.any(|node| quoted(node).as_deref() == Some(design));
    (!quoted).then(|| "the design is not quoted as it is".to_owned())
}

/// Returns elements and comments in their order, each with the names of its attributes. Marked characters and the line
/// that explains them are left out.
fn shape(page: &Document<'_>) -> Vec<String> {
    let explains = |node: &Node<'_, '_>| {
        let before = node.prev_sibling_element();
        before.is_some_and(|pre| pre.children().any(|own| own.has_tag_name("mark")))
    };
    let own =
        |node: &Node<'_, '_>| !node.is_text() && !node.has_tag_name("mark") && !explains(node);
    let shown = |node: Node<'_, '_>| {
        let attributes: Vec<_> = node.attributes().map(|own| own.name().to_owned()).collect();
        format!("{:?} {} {attributes:?}", node.node_type(), node.tag_name().name())
    };
    page.descendants().filter(own).map(shown).collect()
}

/// Reads a quoted text back: a mark holds the number of one character.
fn quoted(pre: Node<'_, '_>) -> Option<String> {
    let mut text = String::new();
    for part in pre.children() {
        if part.is_text() {
            text += part.text()?;
            continue;
        }
        let number = part.text()?.strip_prefix("\\u{")?.strip_suffix('}')?;
        text.push(char::from_u32(u32::from_str_radix(number, 16).ok()?)?);
    }
    Some(text)
}
