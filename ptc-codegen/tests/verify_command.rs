//! `verify` as it is run: objectives with known answers, parts that merge exactly, runs that are
//! interrupted, and bad input.
#![cfg(feature = "lab")]

mod support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = support::command(&["verify"]);
    command.args(arguments).current_dir(folder);
    command
}

fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    support::told(&mut command(folder, arguments))
}

/// A folder of a test's own that holds `stage.toml`.
fn folder(test: &str, design: &str) -> PathBuf {
    support::folder_with(&format!("verify_{test}"), "stage.toml", design)
}

/// x1 = 3T^2 - 2T^3, x2 = -6T + 6T^2 and u = 3 - 6T from (1, 0) with tau = 1.
const STAGE: &str = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\ng = 2\ngains = [6, 5]\n\
                     [params]\ntau = 1\n[plant]\nf = 0\n\
                     [verify]\nx1 = 1\nx2 = 0\nscenarios = 2\nsearch = 20\n";

/// x' = -2x/T + d, |d| <= 1, from 0: the worst d is a bound throughout, with x = T - T^2.
const DRIVEN: &str = "n = 1\nmu = \"exp(a=1)\"\ngains = [2]\n[params]\ntau = 1\n\
                      [plant]\nf = \"d\"\nd = [-1, 1]\n[disturbance]\nd = \"worst\"\n\
                      [verify]\nx1 = 0\nscenarios = 4\nsearch = 200\n";

/// Gain and damping that are not known, a disturbance of any kind, boxes of x0 and tau.
const UNCERTAIN: &str = "n = 1\nmu = \"exp(a=1)\"\npoles = [-4]\n\
                         [plant]\nf = \"gust - damping*x1 + b*u\"\ndamping = [0, 0.5]\n\
                         gust = [-0.1, 0.1]\nb = [-0.2, 0.2]\n[disturbance]\ngust = \"any\"\n\
                         [verify]\nx1 = [-1, 1]\ntau = [0.5, 2]\nscenarios = 130\n\
                         search = 10\nseed = 11\n[[objective]]\nbound = \"attractive\"\n\
                         error = 1e-2\n[[objective]]\nbound = \"within\"\nh = \"x1\"\n\
                         low = -2\nhigh = 2\n";

fn objective(text: &str) -> String {
    format!("[[objective]]\n{text}\n")
}

#[test]
fn objectives_hold_and_fail_as_their_exact_solutions_do() {
    // The greatest |x| of the exact solution, as a part of |x0| = 1.
    let size = |time_to_go: f64| {
        let x1 = 3.0 * time_to_go.powi(2) - 2.0 * time_to_go.powi(3);
        let x2 = -6.0 * time_to_go + 6.0 * time_to_go.powi(2);
        x1.hypot(x2)
    };
    let greatest = (0..=10_000).map(|i| size(f64::from(i) / 1e4)).fold(0.0, f64::max);
    let state = |factor: f64| format!("bound = \"state\"\nsigma = {}", factor * greatest);
    for (text, holds) in [
        ("bound = \"input\"\nupsilon = 3.001", true),
        ("bound = \"input\"\nupsilon = 2.999", false),
        ("bound = \"input\"\nupsilon = \"abs(3 - 6*T) + 1e-6\"", true),
        ("bound = \"input\"\nupsilon = \"abs(3 - 6*T/tau) - 1e-6 + 0*dt\"", false),
        ("bound = \"within\"\nh = \"x2\"\nlow = -1.501\nhigh = 0", true),
        ("bound = \"within\"\nh = \"x2\"\nlow = -1.49", false),
        // The least x2, -1.5 at T = 0.5, lies between two instants: -1.49985 is the least there.
        ("bound = \"within\"\nh = \"x2\"\nlow = -1.49999", false),
        ("bound = \"within\"\nh = \"x1 - 3*T^2 + 2*T^3\"\nlow = -1e-8\nhigh = 1e-8", true),
        ("bound = \"within\"\nh = \"u - 3 + 6*T\"\nlow = -1e-6\nhigh = 1e-6", true),
        ("bound = \"within\"\nh = \"sqrt(x1 - 2)\"\nlow = -1e9", false),
        ("bound = \"attractive\"\nerror = 6.1e-3", true),
        ("bound = \"attractive\"\nerror = 5.9e-3", false),
        (&state(1.001), true),
        (&state(0.999), false),
        ("bound = \"state\"\nsigma = 7\nzeta = \"T/tau\"", true),
        ("bound = \"state\"\nsigma = 4\nzeta = \"T/tau\"", false),
    ] {
        let folder = folder("exact", &format!("{STAGE}{}", objective(text)));
        let (code, told, wrong) = run(&folder, &["stage.toml"]);
        // An h that is no number is told before the run.
        let expected = match (holds, text.contains("sqrt")) {
            (true, _) => Some(0),
            (false, false) => Some(1),
            (false, true) => Some(2),
        };
        assert_eq!(code, expected, "{text}: {told}{wrong}");
        let verdict = if holds { "objective 1, " } else { ": fails" };
        assert!(code == Some(2) || told.contains(verdict), "{text}: {told}");
        assert!(code == Some(2) || told.contains("both sides of Theorem 1 agree"), "{told}");
    }
}

#[test]
fn what_is_linear_in_stretched_time_is_proved() {
    let linear = STAGE
        .replace("gains = [6, 5]", "poles = [-2, -3]")
        .replace("x1 = 1\nx2 = 0", "x1 = [-1, 1]\nx2 = [-1, 1]");
    // x from (1, 0) and from (0, 1), and the Euclidean norm of the matrix of both.
    let size = |t: f64| {
        let (a, b) = (3.0 * t.powi(2) - 2.0 * t.powi(3), 6.0 * t.powi(2) - 6.0 * t);
        let (c, d) = (t.powi(2) - t.powi(3), 3.0 * t.powi(2) - 2.0 * t);
        let (squares, det) = (a * a + b * b + c * c + d * d, a * d - b * c);
        (0.5 * (squares + (squares * squares - 4.0 * det * det).sqrt())).sqrt()
    };
    let norm = (0..=10_000).map(|i| size(f64::from(i) / 1e4)).fold(0.0, f64::max);
    let state = |sigma: f64| format!("bound = \"state\"\nsigma = {sigma}");
    let (proved, sampled, fails) = ("proved by intervals", "holds, by sampling", ": fails");
    // u is 3 - 6T and 1 - 3T from the two: 5 together at the start, and 4 at the end.
    for (text, verdict) in [
        (state(1.001 * norm), proved),
        (state(0.9998 * norm), sampled),
        ("bound = \"state\"\nsigma = 9\nzeta = \"T/tau\"".to_owned(), proved),
        ("bound = \"state\"\nsigma = 3\nzeta = \"T/tau\"".to_owned(), fails),
        ("bound = \"input\"\nupsilon = 5.001".to_owned(), proved),
        ("bound = \"input\"\nupsilon = \"4.001 + dt^0*(1 - dt)\"".to_owned(), proved),
        ("bound = \"input\"\nupsilon = 4.99".to_owned(), fails),
        // |x| at T = 1e-3 is at most that of 6T + 2T and a little.
        ("bound = \"attractive\"\nerror = 8.01e-3".to_owned(), proved),
        ("bound = \"attractive\"\nerror = 5.9e-3".to_owned(), fails),
        // From (1, 1) it rises to 1.09, and x1 + x2 starts at 2.
        ("bound = \"within\"\nh = \"x1\"\nhigh = 1.1".to_owned(), proved),
        ("bound = \"within\"\nh = \"x1 + x2\"\nlow = -2.5\nhigh = 2.5".to_owned(), proved),
        ("bound = \"within\"\nh = \"abs(x1) + abs(x2)\"\nhigh = 4".to_owned(), proved),
    ] {
        let folder = folder("proved", &format!("{linear}{}", objective(&text)));
        let (code, told, wrong) = run(&folder, &["stage.toml"]);
        let first = told.lines().find(|line| line.starts_with("objective 1")).unwrap_or_default();
        assert!(first.contains(verdict), "{text}: {verdict}\n{told}{wrong}");
        assert_eq!(code, Some(i32::from(verdict == fails)), "{text}: {told}");
    }
    // What is not of that kind is not proved.
    for (from, to) in [("f = 0", "f = \"1e-9*x1\""), ("tau = 1", "tau = 1\nu_max = 5")] {
        let design = format!("{linear}{}", objective("bound = \"input\"\nupsilon = 6"));
        let folder = folder("unproved", &design.replace(from, to));
        let (code, told, _) = run(&folder, &["stage.toml"]);
        assert_eq!((code, told.contains(proved)), (Some(0), false), "{told}");
    }
}

#[test]
fn the_search_finds_the_worst_disturbance() {
    for (high, code) in [(0.2501, 0), (0.2495, 1)] {
        let within = format!("bound = \"within\"\nh = \"x1\"\nhigh = {high}");
        let folder = folder("worst", &format!("{DRIVEN}{}", objective(&within)));
        let (found, told, wrong) = run(&folder, &["stage.toml", "--worst", "worst.csv"]);
        assert_eq!(found, Some(code), "{told}{wrong}");
        assert!(code == 0 || told.contains("0 of 4 draws and 1 of 2 corners fail it"), "{told}");
        let csv = fs::read_to_string(folder.join("worst.csv")).expect("a trajectory");
        for line in csv.lines().skip(1) {
            let row: Vec<f64> = line.split(',').map(|x| x.parse().expect("a number")).collect();
            let [_, time_to_go, x, ..] = row[..] else { panic!("{line}") };
            // The search stops where the greatest x is; later pieces decide nothing of it.
            if time_to_go >= 0.5 {
                assert!((x - time_to_go + time_to_go.powi(2)).abs() <= 1e-8, "{line}");
            }
        }
    }
}

#[test]
fn parts_merge_to_the_bytes_of_one_run() {
    let folder = folder("parts", UNCERTAIN);
    let (code, whole, wrong) = run(&folder, &["stage.toml", "--out", "whole.parquet"]);
    assert_eq!((code, wrong.as_str()), (Some(0), ""), "{whole}");
    let bytes = fs::read(folder.join("whole.parquet")).expect("a file");
    assert_eq!(run(&folder, &["stage.toml"]), (Some(0), whole.clone(), String::new()));
    for count in [7, 64] {
        let mut arguments = vec!["stage.toml".to_owned(), "--merge".to_owned()];
        for part in (1..=count).rev() {
            let (shard, out) = (format!("{part}/{count}"), format!("part{part}.parquet"));
            let (code, told, wrong) =
                run(&folder, &["stage.toml", "--shard", &shard, "--out", &out]);
            assert_eq!((code, wrong.as_str()), (Some(0), ""), "{told}");
            arguments.push(out);
        }
        arguments.extend(["--out".to_owned(), "merged.parquet".to_owned()]);
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        assert_eq!(run(&folder, &arguments), (Some(0), whole.clone(), String::new()));
        assert!(fs::read(folder.join("merged.parquet")).expect("a file") == bytes, "{count}");
        // A part that is missing, or there twice, is told.
        let (first, rest) = (&arguments[..2], &arguments[2..arguments.len() - 2]);
        let lacking: Vec<_> = first.iter().chain(&rest[1..]).copied().collect();
        let (code, _, wrong) = run(&folder, &lacking);
        assert_eq!(code, Some(2), "{wrong}");
        assert!(wrong.contains("no part holds the scenarios"), "{wrong}");
        let twice: Vec<_> = first.iter().chain(rest).chain(&rest[..1]).copied().collect();
        let (code, _, wrong) = run(&folder, &twice);
        assert_eq!(code, Some(2), "{wrong}");
        assert!(wrong.contains("which another part holds too"), "{wrong}");
    }
    let names = fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("a file"));
    let left: Vec<_> = names.filter(|name| name.path().is_dir()).collect();
    assert!(left.is_empty(), "{left:?}");
    let other = run(&folder, &["stage.toml", "--seed", "12", "--merge", "whole.parquet"]);
    assert_eq!(other.0, Some(2));
    assert!(other.2.contains("another campaign") && other.2.contains("seed = 11"), "{}", other.2);
}

#[test]
fn the_number_of_cores_and_an_interruption_change_nothing() {
    let folder = folder("resumed", UNCERTAIN);
    let one = command(&folder, &["stage.toml", "--out", "one.parquet"])
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .expect("runs");
    let asked = ["stage.toml", "--out", "resumed.parquet"];
    let mut child = command(&folder, &asked).stdout(Stdio::null()).spawn().expect("runs");
    let rows = folder.join("resumed.parquet.chunks");
    let kept = || fs::metadata(&rows).map_or(0, |there| there.len());
    let began = Instant::now();
    // The header is shorter than one chunk of 64 rows.
    while kept() < 5000 && began.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().expect("killed");
    child.wait().expect("ended");
    assert!(!folder.join("resumed.parquet").exists(), "nothing half");
    // What another campaign left is not taken for this one's.
    let (code, _, wrong) = run(&folder, &["stage.toml", "--seed=12", "--out=resumed.parquet"]);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("another campaign") && wrong.contains("remove this file"), "{wrong}");
    let (code, told, _) = run(&folder, &asked);
    assert_eq!((code, told.as_bytes()), (Some(0), &one.stdout[..]));
    let read = |name: &str| fs::read(folder.join(name)).expect("a file");
    assert!(read("resumed.parquet") == read("one.parquet"));
    assert!(!rows.exists());
}

#[test]
fn a_scenario_can_be_run_again() {
    let folder = folder("again", UNCERTAIN);
    let (code, csv, _) = run(&folder, &["stage.toml", "--scenario", "17"]);
    assert_eq!(code, Some(0));
    assert!(csv.starts_with("t,time_to_go,x1,u,excess1,excess2\n0.0,"), "{csv}");
    assert_eq!(run(&folder, &["stage.toml", "--scenario=17"]).1, csv);
    assert_ne!(run(&folder, &["stage.toml", "--scenario=18"]).1, csv);
    assert_ne!(run(&folder, &["stage.toml", "--scenario=17", "--seed=1"]).1, csv);
}

#[test]
fn the_verdict_by_sampling_says_what_it_is_worth() {
    let folder = folder("worth", UNCERTAIN);
    let (code, told, wrong) = run(&folder, &["stage.toml"]);
    assert_eq!((code, wrong.as_str()), (Some(0), ""), "{told}");
    // tau, x1, damping, b and gust; x1 = 0 with the corners of the others.
    assert!(told.contains("130 draws of seed 11, 48 corners and "), "{told}");
    let draws = "draws: tau, x1, b and damping uniform in their intervals; gust one of constant, sine, square, random and worst, each as likely\n";
    assert!(told.contains(draws), "{told}");
    let most = 1000f64.ln() / 130.0;
    let worth = format!(
        "130 independent draws without a failure: the probability of failure under the stated distribution is at most ln(1/0.001)/130 = {most:.2e} with confidence 0.999"
    );
    assert_eq!(told.matches(&worth).count(), 2, "{told}");
    let (_, few, _) = run(&folder, &["stage.toml", "--scenarios=3"]);
    assert!(few.contains("3 independent draws without a failure: too few to bound"), "{few}");
}

#[test]
fn a_worst_scenario_is_run_again_as_it_is_printed() {
    let within = "bound = \"within\"\nh = \"x1\"\nhigh = 0.2501";
    let folder = folder("replayed", &format!("{DRIVEN}{}", objective(within)));
    let (_, told, wrong) = run(&folder, &["stage.toml", "--worst", "worst.csv"]);
    let line = told.lines().find_map(|line| line.strip_prefix("worst trajectory, "));
    let scenario = line.unwrap_or_else(|| panic!("{told}{wrong}"));
    let (code, csv, wrong) = run(&folder, &["stage.toml", "--scenario", scenario]);
    assert_eq!((code, wrong.as_str()), (Some(0), ""));
    assert_eq!(fs::read_to_string(folder.join("worst.csv")).expect("a trajectory"), csv);
    let (code, csv, wrong) = run(&folder, &["stage.toml", "--scenario", "x1 = 0, d = 2"]);
    assert_eq!((code, csv.as_str()), (Some(2), ""), "{wrong}");
    assert!(wrong.contains("no legal d") && wrong.contains("in [-1, 1]"), "{wrong}");
}

#[test]
fn a_run_that_cannot_be_finished_is_undecided() {
    // x1 falls below 0.5, where f has no value.
    let stuck = STAGE.replace("f = 0", "f = \"sqrt(x1 - 0.5)\"");
    let input = objective("bound = \"input\"\nupsilon = 100");
    let open = folder("undecided", &format!("{stuck}{input}"));
    let (code, told, wrong) = run(&open, &["stage.toml", "--report", "stage.html"]);
    assert_eq!((code, wrong.as_str()), (Some(3), ""), "{told}");
    for part in [
        "objective 1, |u| <= 100: undecided",
        "2 of 2 draws and 1 of 1 corners could not be finished",
        "scenario 0: ",
        "at t = 0.",
        "it ends early: ",
        "\nundecided\n",
    ] {
        assert!(told.contains(part), "no {part:?} in\n{told}");
    }
    assert!(!told.contains("holds") && !told.contains("fails"), "{told}");
    let page = fs::read_to_string(open.join("stage.html")).expect("a page");
    assert!(page.contains("verdict open\">undecided") && page.contains("It ends early: "));
    let (code, csv, wrong) = run(&open, &["stage.toml", "--scenario=1"]);
    assert_eq!(code, Some(3), "{wrong}");
    assert!(csv.lines().count() > 10 && wrong.contains("at t = 0."), "{csv}{wrong}");
    // What failed before the end failed.
    let failed = objective("bound = \"within\"\nh = \"x2\"\nlow = -0.1");
    let folder = folder("undecided_failed", &format!("{stuck}{input}{failed}"));
    let (code, told, _) = run(&folder, &["stage.toml"]);
    assert_eq!(code, Some(1), "{told}");
    assert!(told.contains("<= 100: undecided") && told.contains("<= x2: fails"), "{told}");
}

#[test]
fn an_objective_that_is_impossible_is_refused_with_its_point() {
    let state = objective("bound = \"state\"\nsigma = 50");
    let boxes = |x1: &str| DRIVEN.replace("x1 = 0", x1);
    for (design, code) in [
        (boxes("x1 = [-1, 1]"), 2),
        (boxes("x1 = [0, 1]"), 2),
        (boxes("x1 = [0.1, 1]"), 0),
        // It vanishes at rest.
        (boxes("x1 = [-1, 1]").replace("f = \"d\"", "f = \"d*x1\""), 0),
    ] {
        let folder = folder("impossible", &format!("{design}{state}"));
        let (found, told, wrong) = run(&folder, &["stage.toml"]);
        assert_eq!(found, Some(code), "{design}: {told}{wrong}");
        let point =
            "objective 1, |x| <= 50 |x0| (1), is impossible at tau = 1, x1 = 0, d = worst(-1)";
        assert_eq!(wrong.contains(point), code == 2, "{wrong}");
    }
    // At t0 the corner fails that no draw meets.
    let narrow = objective("bound = \"within\"\nh = \"x1 + x2\"\nhigh = 1.999");
    let design = STAGE.replace("x1 = 1\nx2 = 0", "x1 = [-1, 1]\nx2 = [-1, 1]");
    let folder = folder("corner", &format!("{design}{narrow}"));
    let (code, _, wrong) = run(&folder, &["stage.toml"]);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("fails at t0 already, at tau = 1, x1 = 1, x2 = 1"), "{wrong}");
}

#[test]
fn all_mistakes_of_the_tables_are_told_at_once() {
    let design = "n = 2\nmu = \"exp(a=1)\"\ngains = [6, 5]\n[params]\ntau = 1\n\
                  [plant]\nf = \"gust - dampng*x2\"\ndamping = 0.4\ngust = [1, -1]\n\
                  [disturbance]\ngust = \"sin\"\n[verify]\nx1 = [1, -1]\nx2 = 0\nseed = -1\n\
                  [[objective]]\nbound = \"state\"\nsigma = -1\nzeta = \"T/tua + x1\"\n\
                  [[objective]]\n[[objective]]\nbound = \"input\"\nsigma = 4\n";
    let folder = folder("all", design);
    let (code, out, told) = run(&folder, &["stage.toml"]);
    assert_eq!((code, out.as_str()), (Some(2), ""));
    for part in [
        "f uses `dampng`, which has no value, and nothing uses `damping`",
        "7 | f = \"gust - dampng*x2\"",
        "plant.gust is no pair of bounds",
        "the interval of x1 is empty",
        "verify.seed is not legal",
        "sigma of objective 1 is no number > 0",
        "`x1` is not known where objective",
        "objective 2 is empty",
        "unknown key `sigma` of objective 3",
        "objective 3, of the bound input, without `upsilon`",
    ] {
        assert!(told.contains(part), "no {part:?} in\n{told}");
    }
    assert!(!told.contains("without a value") && !told.contains("objective 0"), "{told}");
    assert!(!told.contains("objective[0]"), "{told}");
}

#[test]
fn bad_input_gets_one_clear_message_and_no_file() {
    let bound = objective("bound = \"input\"\nupsilon = 9");
    let with = |from: &str, to: &str| format!("{STAGE}{bound}").replace(from, to);
    for (design, arguments, parts) in [
        (STAGE.to_owned(), &[][..], &["no objective", "[[objective]]"][..]),
        (with("[plant]\nf = 0\n", ""), &[], &["no plant", "[plant]"]),
        (with("x2 = 0\n", ""), &[], &["no interval of x2", "each of x1..x2"]),
        (with("x2 = 0", "x2 = 0\nx3 = 0"), &[], &["unknown key `verify.x3`", "x3 = 0"]),
        (with("x2 = 0", "x2 = [1, -1]"), &[], &["x2 is empty: 1 > -1", "x2 = [1, -1]", "^"]),
        (with("x2 = 0", "x2 = \"wide\""), &[], &["verify.x2 is no interval"]),
        (with("f = 0", "f = \"d\"\nd = [1, -1]"), &[], &["plant.d is no pair", "least < greatest"]),
        (
            with("f = 0", "f = \"d\"\nd = [-1, 1]\n[disturbance]\ne = \"sine\""),
            &[],
            &["`e` has no bounds"],
        ),
        (
            with("f = 0", "f = \"d\"\nd = [-1, 1]\n[disturbance]\nd = \"sin\""),
            &[],
            &["no signal", "did you mean `sine`?"],
        ),
        (
            with("f = 0", "f = \"b*u\"\nb = [-3, 0]"),
            &["--scenarios=40"],
            &["the gain of the plant is 0 or has another sign than g", "b = -", "|b| < |g|"],
        ),
        (with("f = 0", "f = \"d\""), &[], &["d without a value", "9 | f = \"d\""]),
        (
            with("upsilon = 9", "upsilon = \"9*tua\""),
            &[],
            &["tua without a value", "| upsilon = \"9*tua\""],
        ),
        (with("gains = [6, 5]\n", ""), &[], &["k1, k2 without a value"]),
        (with("tau = 1\n", ""), &[], &["tau has no value"]),
        (with("x1 = 1", "x1 = 1\ntau = [0, 1]"), &[], &["tau is not > 0"]),
        (with("x1 = 1", "x1 = 1\nuntil = 2"), &[], &["verify.until is not legal", "< 1"]),
        (
            with("tau = 1\n", "tau = 1\neps = 0.1\n").replace("x1 = 1", "x1 = 1\nuntil = 0.01"),
            &[],
            &["after the gains are held", "eps/tau = 0.1"],
        ),
        (
            with("upsilon = 9", "upsilon = \"x1\""),
            &[],
            &["`x1` is not known where objective", "dt"],
        ),
        (with("upsilon = 9", "sigma = 9"), &[], &["unknown key", "without `upsilon`"]),
        (with("bound = \"input\"", "bound = \"inputs\""), &[], &["does not say what it bounds"]),
        (with("[[objective]]", "[objective]"), &[], &["one table of a list", "[[objective]]"]),
        (
            with("bound = \"input\"\nupsilon = 9", "bound = \"state\"\nsigma = 0.5"),
            &[],
            &["fails at t0 already", "at tau = 1, x1 = 1, x2 = 0"],
        ),
        (with("", ""), &["--scenarios=0"], &["scenarios is not legal", "--scenarios \"0\""]),
        (with("", ""), &["--seed=-1"], &["seed is not legal", "| --seed \"-1\""]),
        (with("", ""), &["--shard=3/2", "--out=a"], &["--shard 3/2 is no part", "I/N"]),
        (with("", ""), &["--shard=1/2"], &["--out"]),
        (with("", ""), &["--merge", "stage.toml"], &["cannot use stage.toml"]),
        (with("", ""), &["--merge", "none.parquet"], &["cannot use none.parquet", "No such file"]),
        (with("", ""), &["--out=."], &["--out . is a folder"]),
        (with("", ""), &["--out=stage.toml/a"], &["cannot write --out stage.toml/a"]),
        (with("", ""), &["--pi0=extern"], &["`pi0 = extern` is a function of your program"]),
    ] {
        let folder = folder("wrong", &design);
        let (code, out, told) = run(&folder, &[&["stage.toml"][..], arguments].concat());
        assert_eq!((code, out.as_str()), (Some(2), ""), "{design}{arguments:?}: {told}");
        for part in parts {
            assert!(told.contains(part), "{arguments:?}: no {part:?} in\n{told}");
        }
        assert!(!told.contains("panicked"), "{told}");
        let files = fs::read_dir(&folder).expect("a folder").count();
        assert_eq!(files, 1, "{design}{arguments:?}");
    }
}
