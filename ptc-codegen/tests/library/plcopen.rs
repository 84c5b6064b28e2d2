//! The PLCopen XML of a function block holds its Structured Text, byte for byte.

use crate::support;

use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use roxmltree::{Document, Node};
use support::design;

/// Designs with all that a function block may have: functions beside it, user-defined laws, loops,
/// arrays, latched states, estimates, several axes and inputs, and names and expressions that XML escapes.
const DESIGNS: [&str; 13] = [
    "n = 3\nmu = \"exp(a=1)\"\n",
    "n = 2\nmu = \"exp_sum(2)\"\nprecision = \"f32\"\n",
    "n = 3\nmu = \"tanh\"\npi0 = \"extern\"\nafter = \"extern\"\n",
    "n = 9\nkappa = \"tau*dt/(tau - dt) + dt\"\n",
    "n = 1\nmu = \"exp\"\npi0 = \"-min(xi1, 2)/(abs(xi1) - phi*abs(xi1_0))\"\ng = \"2 + x1\"\n",
    "n = 2\nmu = \"exp(a=1)\"\nreference = \"input\"\nguard = \"result\"\nname = \"axis_Z\"\n",
    "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nmeasured = \"x1\"\npoles = [-4, -5]\n\
     observer_poles = [-4, -5]\nobserver_samples = 9\n",
    "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nwhat = \"observer\"\ndisturbance = \"constant\"\n\
     observer_poles = [-4, -5]\nobserver_samples = 9\n",
    "n = 2\nmu = \"exp(a=1)\"\naxes = 3\nreference = \"input\"\ng = [2, 3, 1]\n",
    "n = 2\nmu = \"rational\"\naxes = 1\n",
    "n = 2\nmu = \"exp\"\naxes = 1\npi0 = \"extern\"\n",
    "n = 2\nmu = \"exp(a=1)\"\naxes = 2\nclock = \"samples\"\n",
    "mu = \"rational\"\n[model]\nstates = [\"p\", \"q\", \"r\", \"s\"]\ninputs = [\"a\", \"b\", \"c\", \"d\"]\n\
     outputs = [\"p\", \"q\", \"r\", \"s\"]\ndynamics = [\"2*a + q*b\", \"3*b - p*c\", \"5*c + d\", \"a + 4*d + p^2\"]\n",
];

fn emitted(text: &str, language: Language) -> String {
    let mut files = generate(&design(text).0, language).expect("a controller");
    assert_eq!(files.len(), 1, "{files:?}");
    files.remove(0).text
}

/// The children of `node` that are elements.
fn elements<'a>(node: Node<'a, 'a>) -> impl Iterator<Item = Node<'a, 'a>> {
    node.children().filter(Node::is_element)
}

fn child<'a>(node: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
    elements(node).find(|one| one.tag_name().name() == name)
}

fn the<'a>(node: Node<'a, 'a>, path: &[&str]) -> Node<'a, 'a> {
    path.iter().fold(node, |node, name| child(node, name).unwrap_or_else(|| panic!("no {name}")))
}

fn name<'a>(node: Node<'a, 'a>) -> &'a str {
    node.attribute("name").expect("a name")
}

/// The text of the one paragraph of XHTML in `node`.
fn paragraph<'a>(node: Node<'a, 'a>) -> &'a str {
    let all: Vec<_> = elements(node).collect();
    assert_eq!(all.len(), 1, "{node:?}");
    assert_eq!(all[0].tag_name().namespace(), Some("http://www.w3.org/1999/xhtml"));
    all[0].text().expect("a text")
}

/// A type as Structured Text writes it.
fn kind(node: Node<'_, '_>) -> String {
    let one = elements(node).next().expect("a type");
    match one.tag_name().name() {
        "derived" => name(one).to_owned(),
        "array" => {
            let dimensions = elements(one).filter(|own| own.tag_name().name() == "dimension");
            let range = |own: Node<'_, '_>| {
                let [lower, upper] =
                    ["lower", "upper"].map(|end| own.attribute(end).expect("an end").to_owned());
                format!("{lower}..{upper}")
            };
            let ranges: Vec<_> = dimensions.map(range).collect();
            format!("ARRAY[{}] OF {}", ranges.join(", "), kind(the(one, &["baseType"])))
        }
        elementary => elementary.to_owned(),
    }
}

fn variables(list: Node<'_, '_>) -> String {
    let line = |variable| {
        let about = child(variable, "documentation").map(paragraph);
        let about = about.map_or(String::new(), |about| format!(" (* {about} *)"));
        let value = child(variable, "initialValue").map(|own| the(own, &["simpleValue"]));
        let value = value.and_then(|own| own.attribute("value"));
        let value = value.map_or(String::new(), |value| format!(" := {value}"));
        let kind = kind(the(variable, &["type"]));
        format!("    {} : {kind}{value};{about}\n", name(variable))
    };
    elements(list).map(line).collect()
}

/// A function or a function block as Structured Text writes it.
fn unit(pou: Node<'_, '_>) -> String {
    let interface = the(pou, &["interface"]);
    let (word, returns, gap) = match pou.attribute("pouType") {
        Some("function") => {
            ("FUNCTION", format!(" : {}", kind(the(interface, &["returnType"]))), "")
        }
        Some("functionBlock") => ("FUNCTION_BLOCK", String::new(), "\n"),
        other => panic!("{other:?}"),
    };
    let mut text = format!("{word} {}{returns}\n", name(pou));
    for list in elements(interface).filter(|one| one.tag_name().name() != "returnType") {
        let var = match list.tag_name().name() {
            "inputVars" => "VAR_INPUT",
            "outputVars" => "VAR_OUTPUT",
            "localVars" if list.attribute("constant") == Some("true") => "VAR CONSTANT",
            "localVars" => "VAR",
            "tempVars" => "VAR_TEMP",
            other => panic!("{other}"),
        };
        text.push_str(&format!("{var}\n{}END_VAR\n", variables(list)));
    }
    let body = paragraph(the(pou, &["body", "ST"]));
    format!("{text}{gap}{body}\nEND_{word}\n")
}

/// The Structured Text of a project.
fn extracted(xml: &str) -> String {
    let document = Document::parse(xml).expect("well-formed XML");
    let types = the(document.root_element(), &["types"]);
    let about = |pou| paragraph(the(pou, &["documentation"]));
    let (mut rest, mut head) = (String::new(), String::new());
    for one in elements(the(types, &["dataTypes"])) {
        let of = the(one, &["baseType"]);
        let Some(members) = child(of, "struct").map(variables) else {
            rest += &format!("TYPE {} : {}; END_TYPE\n\n", name(one), kind(of));
            continue;
        };
        rest += &format!("TYPE {} :\nSTRUCT\n{members}END_STRUCT;\nEND_TYPE\n\n", name(one));
    }
    for pou in elements(the(types, &["pous"])) {
        if pou.attribute("pouType") == Some("function") {
            rest += &format!("(* {} *)\n{}\n", about(pou), unit(pou));
        } else {
            assert_eq!(head, "", "a second function block");
            let lines =
                about(pou).split('\n').map(|line| format!("  {line}").trim_end().to_owned());
            head = lines.collect::<Vec<_>>().join("\n");
            rest += &unit(pou);
        }
    }
    format!("(*\n{head}\n*)\n\n{rest}")
}

#[test]
fn the_project_holds_the_structured_text() {
    let (mut functions, mut arrays, mut escaped) = (0, 0, 0);
    for text in DESIGNS {
        let (xml, st) = (emitted(text, Language::PlcOpen), emitted(text, Language::StructuredText));
        assert_eq!(extracted(&xml), st, "{text}");
        functions += xml.matches("pouType=\"function\"").count();
        arrays += xml.matches("<array>").count();
        escaped += xml.matches("&#60;").count();
    }
    assert!(functions >= 3 && arrays >= 8 && escaped > 8, "{functions} {arrays} {escaped}");
}

/// Importers look for the namespace of the schema and for a date, which is always the same.
#[test]
fn the_project_says_how_it_is_made_again() {
    let xml = emitted("n = 1\nmu = \"exp\"\ngains = [2]\n", Language::PlcOpen);
    let document = Document::parse(&xml).expect("well-formed XML");
    let root = document.root_element();
    assert_eq!(root.tag_name().namespace(), Some("http://www.plcopen.org/xml/tc6_0201"));
    let header = the(root, &["fileHeader"]);
    assert_eq!(header.attribute("creationDateTime"), Some("1970-01-01T00:00:00"));
    let made = "Made by: ptc-codegen emit --lang plcopen --n 1 --mu exp --gains=2";
    let told = header.attribute("contentDescription").unwrap_or_default();
    let (design, command) = told.split_once(". ").expect("two sentences");
    assert!(design.starts_with("Design ") && design.len() == 19, "{told}");
    assert_eq!(command, made);
    assert_eq!(header.attribute("productVersion"), Some(env!("CARGO_PKG_VERSION")));
}

/// It refuses what Structured Text refuses.
#[test]
fn the_project_refuses_what_structured_text_refuses() {
    for (text, key, message) in [
        ("n = 1\nmu = \"exp\"\npi0 = \"-sinh(xi1)\"\n", "pi0", "calls sinh"),
        ("n = 2\nmu = \"exp\"\nfma = true\n", "fma", "Structured Text has no fused multiply-add"),
        ("n = 2\nmu = \"exp\"\nname = \"deadline\"\n", "name", "has a variable deadline"),
        ("n = 2\nmu = \"exp\"\nname = \"limit\"\n", "name", "meaning of its own in plcopen"),
        ("n = 2\nmu = \"exp\"\naxes = 3\npi0 = \"extern\"\n", "pi0", "returns an array"),
    ] {
        let spec = design(text).0;
        let found = generate(&spec, Language::PlcOpen).expect_err(message);
        assert!(found.len() == 1 && found[0].key == key, "{found:?}");
        assert!(found[0].message.contains(message), "{found:?}");
    }
}

/// Constructs that MatIEC, the compiler of Beremiz and OpenPLC, rejects: types without a name, derived types among
/// temporary variables, a declaration without its semicolon, literals beyond the range of a REAL, and FOR loops with
/// one iteration.
#[test]
fn structured_text_keeps_to_what_matiec_takes() {
    let mut literals = 0;
    for text in DESIGNS {
        let st = emitted(text, Language::StructuredText);
        let (_, code) = st.split_once("*)").expect("a head");
        let mut temporary = false;
        for line in code.lines().map(|line| line.split("(*").next().unwrap_or(line).trim()) {
            temporary = (temporary || line == "VAR_TEMP") && line != "END_VAR";
            let elementary = ["BOOL;", "INT;", "DINT;", "UDINT;", "REAL;", "LREAL;"];
            let declared = line.contains(" : ");
            assert!(
                !temporary || !declared || elementary.iter().any(|e| line.ends_with(e)),
                "{line}"
            );
            assert!(!line.contains("ARRAY[") || line.starts_with("TYPE "), "{line}");
            assert_ne!(line, "END_STRUCT", "{text}");
            if let Some((_, ends)) = line.split_once("FOR ").filter(|_| !line.contains("END_")) {
                let (from, to) = ends.split_once(" TO ").expect("ends");
                let count = |end: &str| end.rsplit('#').next().and_then(|n| n.parse::<u32>().ok());
                let first = from.split(":= ").nth(1).and_then(count).expect("a number");
                let last = to.split(' ').next().and_then(count).expect("a number");
                assert!(first < last, "{line}");
            }
            for literal in line.split("REAL#").skip(1) {
                let number = |c: char| c.is_ascii_digit() || ".E+-".contains(c);
                let digits: String = literal.chars().take_while(|c| number(*c)).collect();
                let value: f64 = digits.trim_end_matches(['+', '-']).parse().expect("a number");
                let real = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
                assert!(value == 0.0 || real.contains(&value.abs()), "{line}");
                literals += 1;
            }
        }
    }
    assert!(literals > 100, "{literals}");
}

/// Each number beyond the range of a REAL is a product that is exact, also where a compiler rounds its factors to a REAL
/// before it looks for an overflow.
#[test]
fn wide_numbers_are_exact_products() {
    let st = emitted(DESIGNS[0], Language::StructuredText);
    let mut found = 0;
    for (name, comment) in
        st.lines().filter_map(|line| line.trim().split_once(" : LREAL; (* LREAL#"))
    {
        let wanted: f64 = comment.trim_end_matches(" *)").parse().expect("a number");
        let assigned = st.split_once(&format!("{name} := ")).expect("a statement").1;
        let product = assigned.split_once(';').expect("an end").0;
        let value =
            |text: &str| text.trim().trim_start_matches("LREAL#").parse::<f64>().expect("a number");
        let factor = |text: &str| {
            let text = text.trim().trim_matches(['(', ')']);
            text.split(" - ").map(value).reduce(|a, b| a - b).expect("a number")
        };
        let exact = product.split('*').map(factor).reduce(|a, b| a * b).expect("factors");
        assert_eq!(exact.to_bits(), wanted.to_bits(), "{name}: {product}");
        let single = |text: &str| {
            let text = text.trim().trim_matches(['(', ')']);
            let rounded = text.split(" - ").map(|part| f64::from(value(part) as f32));
            rounded.reduce(|a, b| a - b).expect("a number")
        };
        let rounded = product.split('*').map(single).reduce(|a, b| a * b).expect("factors");
        assert!(rounded.is_finite() && rounded > 0.0, "{name}: {product}");
        found += 1;
    }
    assert!(found >= 4, "{found}");
}
