//! `--report` of `simulate` and `verify`: what the page holds, that it holds it alone, and what is
//! left where a run fails. `cargo assure report` opens it in a browser.

mod mathml;
use crate::support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use roxmltree::{Document, Node, ParsingOptions};
use support::run_in as run;

/// A folder of a test's own that holds `stage.toml`.
fn folder(test: &str, design: &str) -> PathBuf {
    support::folder_with(&format!("report_{test}"), "stage.toml", design)
}

/// The report that a run which succeeds has written.
fn report(folder: &Path, arguments: &[&str]) -> String {
    let all = [arguments, &["--report", "out.html"]].concat();
    let (code, _, stderr) = run(folder, &all);
    let told = support::without_design(&stderr);
    assert_eq!((code, told.as_str()), (Some(0), ""), "{arguments:?}");
    fs::read_to_string(folder.join("out.html")).expect("a report")
}

fn parse(page: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(page, options).expect("well-formed")
}

fn named<'a>(node: Node<'a, 'a>, name: &'a str) -> impl Iterator<Item = Node<'a, 'a>> {
    node.descendants().filter(move |node| node.tag_name().name() == name)
}

fn section<'a>(page: &'a Document<'a>, id: &str) -> Node<'a, 'a> {
    let found = page.descendants().find(|node| node.attribute("id") == Some(id));
    found.unwrap_or_else(|| panic!("no section {id}"))
}

/// All text below a node.
fn text(node: Node<'_, '_>) -> String {
    node.descendants().filter(Node::is_text).filter_map(|node| node.text()).collect()
}

/// x1 = 3T^2 - 2T^3 and u = 3 - 6T from (1, 0) with tau = 1; `<`, `&` and quotes are in its comment.
const STAGE: &str = "# \"R & D\" <script>alert('x < y')</script> ]]>\nname = \"stage\"\nn = 2\n\
                     mu = \"exp(a=1)\"\ng = 2\ngains = [6, 5]\n[params]\ntau = 1\n[plant]\nf = 0\n";

const AT: [&str; 6] = ["simulate", "stage.toml", "--x0", "1,0", "--at", "0,0.25,0.75"];

#[test]
fn simulation_report_has_every_section() {
    let folder = folder("simulation", STAGE);
    let page = report(&folder, &AT);
    let page = parse(&page);
    for id in ["design", "formulas", "checks", "run", "code", "provenance"] {
        assert!(!text(section(&page, id)).trim().is_empty(), "{id}");
    }
    // What is quoted is what was given, to the character.
    let quoted: Vec<_> = named(section(&page, "design"), "pre").map(text).collect();
    assert_eq!(quoted[1], STAGE);
    let checks = text(section(&page, "checks"));
    assert!(
        checks.contains("accepted") && checks.contains("x goes to 0 and u stays bounded"),
        "{checks}"
    );
    let rows: Vec<Vec<String>> = named(section(&page, "run"), "tr")
        .map(|row| row.children().filter(Node::is_element).map(text).collect())
        .collect();
    assert_eq!(rows[0], ["tau in s", "t in s", "x1", "x2", "u"]);
    assert_eq!(rows[1], ["1", "0", "1", "0", "-3"]);
    assert_eq!(rows[2], ["1", "0.25", "0.84375", "-1.125", "-1.5"]);
    assert_eq!(rows[3], ["1", "0.75", "0.15625", "-1.125", "1.5"]);
    // One line in numbers: it ends at rest, and |u| is greatest at the start.
    assert_eq!(rows[4], ["run", "ends at t in s", "final x1", "final x2", "peak |u|", "at t in s"]);
    assert_eq!(
        (rows[5][0].as_str(), &rows[5][4..]),
        ("tau = 1 s", &["3".to_owned(), "0".into()][..])
    );
    let rest: f64 = rows[5][2].parse().expect("a number");
    assert!(rest.abs() < 1e-15, "{rest}");
    assert_eq!(rows.len(), 6);
    assert!(text(section(&page, "run")).contains("x1 = xi1 in stretched time"));
    let (code, header, _) = run(&folder, &["emit", "stage.toml", "--lang", "c", "-o", "out"]);
    assert_eq!(code, Some(0), "{header}");
    let emitted: Vec<_> = named(section(&page, "code"), "pre").map(text).collect();
    for (name, emitted) in ["stage.h", "stage.c"].iter().zip(emitted) {
        assert_eq!(emitted, fs::read_to_string(folder.join("out").join(name)).expect("a file"));
    }
}

/// Every kind of mapping and law, with what its gains are written in.
#[test]
fn every_kind_of_design_has_its_formulas() {
    let gains = "gains = [6, 11, 6]";
    let own = "pi0 = \"-6*xi1 - 11*xi2 - 6*xi3*min(1, 2, xi1_0 + t)\"";
    for (index, (mapping, law, least)) in [
        ("mu = \"exp(a=0.5)\"", gains, 16),
        ("mu = \"rational(a=2)\"", gains, 16),
        ("mu = \"power(a=1, m=2)\"", gains, 16),
        ("mu = \"tan(a=1)\"", gains, 16),
        ("mu = \"tanh(a=0.2)\"", gains, 16),
        ("mu = \"algebraic(a=1)\"", gains, 16),
        ("mu = \"exp_sum(rates=[0.2, 0.4])\"", gains, 15),
        ("kappa = \"-ln(1 - dt/tau) + dt/tau\"", gains, 16),
        ("mu = \"tau*(1 - exp(-t - t^2))\"", gains, 15),
        ("mu = \"exp(a=0.1)\"", own, 13),
    ]
    .into_iter()
    .enumerate()
    {
        let text = format!(
            "name = \"stage\"\nn = 3\n{mapping}\n{law}\ng = \"2 + x1^2\"\n[params]\ntau = 1\n\
             [plant]\nf = 0\n"
        );
        let folder = folder(&format!("kind_{index}"), &text);
        let page = report(&folder, &["simulate", "stage.toml", "--x0", "0.1,0,0", "--at", "0"]);
        let page = parse(&page);
        let formulas = named(section(&page, "formulas"), "math").count();
        assert!(formulas >= least, "{mapping}: {formulas}");
        alone(&page);
    }
}

/// Several axes: the code that is emitted, what each has of its own, and no decoupling.
#[test]
fn report_of_several_axes_shows_each_axis() {
    let axes = "name = \"stage\"\nn = 2\naxes = 2\nmu = \"exp(a=1)\"\npoles = [[-2, -3], [-4, -5]]\nlimits = [9, 80]\n\
                g = [\"1/2\", \"1\"]\n[params]\ntau = 1\nt0 = 0\neps = 0.01\n[plant]\nf = \"-x2\"\n";
    let folder = folder("axes", axes);
    let page = report(&folder, &["simulate", "stage.toml", "--x0", "1,0,1,0", "--at", "0,0.5"]);
    let page = parse(&page);
    let (code, header, _) = run(&folder, &["emit", "stage.toml", "--lang", "c", "-o", "out"]);
    assert_eq!(code, Some(0), "{header}");
    let emitted: Vec<_> = named(section(&page, "code"), "pre").map(text).collect();
    assert_eq!(emitted.len(), 2);
    for (name, emitted) in ["stage.h", "stage.c"].iter().zip(emitted) {
        assert_eq!(emitted, fs::read_to_string(folder.join("out").join(name)).expect("a file"));
    }
    let design = text(section(&page, "design"));
    assert!(design.contains("9, 80") && design.contains("6, 20"), "{design}");
    let formulas = text(section(&page, "formulas"));
    assert!(formulas.contains("Of axis 2: x and u are its own."), "{formulas}");
    assert!(formulas.contains("takes each for a chain of integrators"), "{formulas}");
    assert!(!formulas.contains("decoupling"), "{formulas}");
    alone(&page);
}

/// Asserts that a page requests nothing from a network.
fn alone(page: &Document<'_>) {
    let policy = page.descendants().find_map(|node| {
        let named = node.attribute("http-equiv") == Some("Content-Security-Policy");
        named.then(|| node.attribute("content")).flatten()
    });
    assert_eq!(policy, Some("default-src 'none'; style-src 'unsafe-inline'; img-src data:"));
    let mut ids = std::collections::BTreeSet::new();
    for node in page.descendants().filter(Node::is_element) {
        let name = node.tag_name().name();
        let asks = ["script", "link", "img", "image", "iframe", "object", "embed", "use", "base"];
        assert!(!asks.contains(&name), "{name}");
        for attribute in node.attributes() {
            let (key, value) = (attribute.name(), attribute.value());
            assert!(key != "src" && !key.starts_with("on"), "{key}");
            assert!(key != "href" || value.starts_with('#'), "{value}");
            assert!(!value.contains("url("), "{value}");
            assert!(key != "id" || ids.insert(value.to_owned()), "two of the id {value}");
        }
        if name == "style" {
            let rules = text(node);
            assert!(!rules.contains("url(") && !rules.contains("@import"));
        }
    }
}

#[test]
fn report_is_independent_of_paths() {
    let one = folder("path", STAGE);
    let page = report(&one, &AT);
    assert_eq!(page, report(&one, &AT), "twice");
    let deep = one.join("some/where");
    fs::create_dir_all(&deep).expect("a folder");
    fs::rename(one.join("stage.toml"), deep.join("other.toml")).expect("another name");
    let all = ["simulate", "some/where/other.toml", "--x0", "1,0", "--at", "0,0.25,0.75"];
    let (code, _, stderr) = run(&one, &[&all[..], &["--report", "new/REPORT.HTML"]].concat());
    assert_eq!(code, Some(0), "{stderr}");
    let other = fs::read_to_string(one.join("new/REPORT.HTML")).expect("a report");
    assert_eq!(page, other);
}

/// The command and the design of a report, in an empty folder, give the report.
#[test]
fn report_can_be_reproduced_from_its_contents() {
    let folder = folder("again", STAGE);
    let flags = ["--tau", "0.5,2", "--plant", "f=-w*x2 + 0.1*(x1 < 0)", "--plant", "w=0.5"];
    assert_eq!(run(&folder, &[&AT[..], &flags].concat()).0, Some(2), "no comparison is legal");
    let flags = ["--tau", "0.5,2", "--plant", "f=-w*x2 + sin(3*t)", "--plant", "w=0.5"];
    let sampled =
        ["simulate", "stage.toml", "--x0=-1,0", "--sample-time", "0.01", "--delay=1", "--eps"];
    let noise = ["0.05", "--noise", "1e-3", "--seed", "9", "--u-step", "0.1"];
    let drawn = ["--until", "1.5", "--arm-at", "0.6", "--log"];
    let sampled = [&sampled[..], &noise].concat();
    for arguments in [[&AT[..], &flags].concat(), sampled.clone(), [&sampled[..], &drawn].concat()]
    {
        let page = report(&folder, &arguments);
        let document = parse(&page);
        let quoted: Vec<_> = named(section(&document, "design"), "pre").map(text).collect();
        let empty = folder.join("empty");
        let _ = fs::remove_dir_all(&empty);
        fs::create_dir_all(&empty).expect("a folder");
        fs::write(empty.join("stage.toml"), &quoted[1]).expect("a design");
        let binary = Path::new(env!("CARGO_BIN_EXE_ptc-codegen"));
        let home = binary.parent().expect("a folder").display().to_string();
        let line = format!("PATH=\"{home}:$PATH\"; {}", quoted[0]);
        let output = Command::new("sh").args(["-c", &line]).current_dir(&empty).output();
        let output = output.expect("a shell");
        assert!(output.status.success(), "{line}\n{}", String::from_utf8_lossy(&output.stderr));
        let again = fs::read_to_string(empty.join("stage.html")).expect("a report");
        assert_eq!(page, again, "{line}");
    }
}

#[test]
fn several_tau_leave_tau_to_run_time() {
    let folder = folder("several", STAGE);
    let page = report(&folder, &[&AT[..], &["--tau", "0.5,2"]].concat());
    let page = parse(&page);
    let known = named(section(&page, "design"), "tr").map(text).find(|row| row.starts_with("tau"));
    assert!(known.expect("tau").contains("at run time"));
    assert!(text(section(&page, "code")).contains("double tau;"));
    let in_numbers = 1 + 2;
    assert_eq!(named(section(&page, "run"), "tr").count(), 1 + 2 * 3 + in_numbers);
}

#[test]
fn failed_run_writes_no_file() {
    let folder = folder("fails", STAGE);
    for (arguments, told) in [
        (&["--report", "run.txt"][..], "`run.txt` is no name of a report"),
        (&["--report", "run"], "give a file that ends in .html"),
        (&["--report", "stage.toml/run.html"], "stage.toml"),
        (&["--report", "run.html", "--tau", "0"], "tau"),
        (&["--report", "run.html", "--at", "2"], "outside [0, 1)"),
    ] {
        let at = if arguments.contains(&"--at") { &AT[..4] } else { &AT };
        let (code, stdout, stderr) = run(&folder, &[at, arguments].concat());
        assert_eq!((code, stdout.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(stderr.contains(told), "{arguments:?}: {stderr}");
        let left: Vec<_> = fs::read_dir(&folder).expect("a folder").flatten().collect();
        assert_eq!(left.len(), 1, "{arguments:?}: {left:?}");
    }
}

/// A design that is refused runs in a simulation all the same; its report has no code, and why.
#[test]
fn refused_design_report_has_no_code() {
    let folder = folder("refused", &STAGE.replace("[6, 5]", "[0.5, 1.5]"));
    let page = report(&folder, &AT);
    let page = parse(&page);
    assert!(text(section(&page, "checks")).contains("refused: growth"));
    let code = section(&page, "code");
    assert!(text(code).contains("No code is emitted: ") && named(code, "pre").count() == 0);
}

const OBJECTIVES: &str = "[verify]\nx1 = 1\nx2 = 0\nscenarios = 2\nsearch = 20\n\
                          [[objective]]\nbound = \"input\"\nupsilon = \"4*exp(-dt/tau) + 2\"\n\
                          [[objective]]\nbound = \"attractive\"\nerror = 1e-2\n\
                          [[objective]]\nbound = \"within\"\nh = \"x2\"\nlow = -1.501\nhigh = 1\n\
                          [[objective]]\nbound = \"state\"\nsigma = 7\n";

#[test]
fn verification_report_shows_its_verdicts() {
    let folder = folder("verification", &format!("{STAGE}{OBJECTIVES}"));
    let page = report(&folder, &["verify", "stage.toml"]);
    let page = parse(&page);
    alone(&page);
    let told = text(section(&page, "run"));
    for part in [
        "Every objective holds: 2 draws of seed 0",
        "tau = 1; x1 = 1; x2 = 0.",
        "objective 1: |u|",
        "objective 2: |x|",
        "objective 3: x2",
        "Worst trajectory, tau = 1, x1 = 1, x2 = 0",
        "both sides of Theorem 1 agree: maximum difference ",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    assert_eq!(told.matches("holds, proved by intervals").count(), 4, "{told}");
    // A histogram of each objective, an envelope of each state and u, and the way to run a draw again.
    let charts = |page: &Document<'_>| named(section(page, "run"), "svg").count();
    assert_eq!(charts(&page), 1 + 4 + 3);
    let commands: Vec<_> = named(section(&page, "run"), "td").map(text).collect();
    let replay = commands.iter().find(|cell| cell.contains("--scenario=1")).expect("a command");
    let words: Vec<_> = replay.split(' ').skip(1).collect();
    let (code, trajectory, _) = run(&folder, &words);
    assert_eq!(
        (code, trajectory.lines().next()),
        (Some(0), Some("t,time_to_go,x1,x2,u,excess1,excess2,excess3,excess4"))
    );
    // Bounds of four objectives are drawn, in dashes.
    let bounds =
        named(section(&page, "run"), "line").chain(named(section(&page, "run"), "polyline"));
    let dashes = bounds.filter(|line| line.attribute("stroke") == Some("#A02030")).count();
    assert!(dashes > 4 * 20, "{dashes}");
}

#[test]
fn failed_objective_is_reported() {
    let text_of = STAGE.to_owned() + &OBJECTIVES.replace("error = 1e-2", "error = 5e-3");
    let folder = folder("failing", &text_of);
    let (code, stdout, stderr) = run(&folder, &["verify", "stage.toml", "--report", "out.html"]);
    assert_eq!((code, stderr.as_str()), (Some(1), ""));
    let page = fs::read_to_string(folder.join("out.html")).expect("a report");
    let page = parse(&page);
    let told = text(section(&page, "run"));
    assert!(
        told.contains("Not verified") && told.contains("2 of 2 draws and 1 of 1 corner fail it"),
        "{told}"
    );
    let verdicts: Vec<_> = named(section(&page, "run"), "td")
        .filter(|cell| cell.attribute("class") == Some("verdict bad"))
        .map(text)
        .collect();
    assert_eq!(verdicts, ["fails"]);
    // The page says what the terminal does.
    for line in stdout.lines().filter(|line| line.contains("worst draw:")) {
        assert!(told.contains(line.trim()), "{line}");
    }
    assert_eq!(run(&folder, &["verify", "stage.toml", "--report", "no.pdf"]).0, Some(2));
    assert!(!folder.join("no.pdf").exists());
}

/// The bars of the bounds of a loop: their parts are those of `check`, and add up.
#[test]
fn loop_bounds_are_drawn_as_bars() {
    let design = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\neps = 0.1\nsample_time = 5e-3\n\
        x0_max = [1, 1]\nerror = [1, 1e-3]\nnoise = 1e-4\nu_step = 1e-3\nallow = \"loop\"\n[params]\ntau = 1\nu_max = inf\n[plant]\nf = 0\n";
    let folder = folder("bars", design);
    let page = report(&folder, &["simulate", "stage.toml", "--x0", "1,0"]);
    let page = parse(&page);
    let checks = section(&page, "checks");
    let (code, told, _) = run(&folder, &["check", "stage.toml"]);
    assert_eq!(code, Some(0));
    let lists: Vec<_> =
        named(checks, "ul").map(|list| named(list, "li").map(text).collect::<Vec<_>>()).collect();
    assert_eq!(lists.len(), 2);
    let bars: Vec<_> =
        named(checks, "div").filter(|div| div.attribute("class") == Some("bar")).collect();
    for (i, (list, bar)) in lists.iter().zip(&bars).enumerate() {
        let line = told.lines().find(|line| line.contains(&format!("|x{}| <= ", i + 1)));
        let causes = line.and_then(|line| line.split_once(": ")).expect("a split").1;
        assert_eq!(causes.split(" + ").count(), list.len(), "{causes} {list:?}");
        for (cause, shown) in causes.split(" + ").zip(list) {
            let (value, name) = cause.split_once(' ').expect("a cause");
            let (shown_name, shown) = shown.rsplit_once(' ').expect("a part");
            let [a, b]: [f64; 2] = [value, shown].map(|x| x.parse().expect("a number"));
            assert!(name == shown_name && (a / b - 1.0).abs() < 1e-9, "{cause} {shown}");
        }
        let widths = named(*bar, "span").map(|span| {
            let style = span.attribute("style").expect("a width");
            let width = style.trim_start_matches("width: ").trim_end_matches('%');
            width.parse::<f64>().expect("a number")
        });
        let (sum, mark) = (widths.sum::<f64>(), named(*bar, "i").next().expect("a mark"));
        let mark = mark.attribute("style").expect("a place").contains("left: 100.000%");
        // x1 is within what is wanted, x2 is not.
        assert_eq!((sum < 99.0, mark), (i == 0, i == 0), "{sum}");
    }
    // The run in which x2 ends at its bound.
    let worst = named(checks, "figure").next().expect("a figure");
    let line = told.lines().find_map(|line| line.split_once("|x2| <= ")?.1.split_once(':'));
    let caption = named(worst, "figcaption").next().map(text).expect("a caption");
    let bound = line.expect("a bound").0;
    assert!(caption.contains(&format!("|x2| ends worst, at {bound}:")), "{caption} {bound}");
    assert_eq!(named(worst, "svg").count(), 1);
    // What eps makes of the loop.
    let charts = named(checks, "div").filter(|div| div.attribute("class") == Some("charts"));
    let charts: Vec<_> = charts.flat_map(|div| named(div, "svg")).collect();
    assert_eq!(charts.len(), 2);
    for chart in charts {
        let lines = named(chart, "polyline").filter_map(|line| line.attribute("points"));
        let line = lines.max_by_key(|line| line.len());
        let inside = |point: &str| {
            let (x, y) = point.split_once(',').expect("a point");
            let [x, y]: [f64; 2] = [x, y].map(|place| place.parse().expect("a number"));
            // In tenths of a pixel.
            (800.0..=4800.0).contains(&x) && (0.0..=2400.0).contains(&y)
        };
        let points: Vec<_> = line.expect("points").split_whitespace().collect();
        assert!(points.len() > 20 && points.iter().all(|point| inside(point)), "{points:?}");
    }
}
