//! Objectives with known answers, and what a verdict is worth.

use std::fs;

use super::{DRIVEN, STAGE, UNCERTAIN, folder, objective, run};

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
        ("bound = \"within\"\nh = \"x2\"\nlow = -1.501\nhigh = 1e-9", true),
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
        // An h that is not a number is refused before the run.
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

/// x2 <= 0 is true and met at t0, where no enclosure leaves room and no run fails.
#[test]
fn a_bound_that_a_proof_only_meets_is_not_said_to_hold() {
    let within = objective("bound = \"within\"\nh = \"x2\"\nlow = -1.501\nhigh = 0");
    let folder = folder("met_at_start", &format!("{STAGE}{within}"));
    let (code, told, wrong) = run(&folder, &["stage.toml"]);
    assert_eq!((code, wrong.as_str()), (Some(3), ""), "{told}");
    for part in [": undecided", "no room is left at T/tau = 1, ", "no run exceeds the bound"] {
        assert!(told.contains(part), "no {part:?} in\n{told}");
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
    let (proved, open, fails) = ("proved by intervals", ": undecided", ": fails");
    // u is 3 - 6T and 1 - 3T from the two: 5 together at the start, and 4 at the end.
    for (text, verdict) in [
        (state(1.001 * norm), proved),
        // The worst direction is between the corners of the box, and no scenario is known to be in it.
        (state(0.9998 * norm), open),
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
        let expected = match verdict {
            _ if verdict == fails => 1,
            _ if verdict == open => 3,
            _ => 0,
        };
        assert_eq!(code, Some(expected), "{text}: {told}");
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
fn a_run_that_cannot_be_finished_is_undecided() {
    // x1 falls below 0.5, where f has no value.
    let stuck = STAGE.replace("f = 0", "f = \"sqrt(x1 - 0.5)\"");
    let input = objective("bound = \"input\"\nupsilon = 100");
    let open = folder("undecided", &format!("{stuck}{input}"));
    let (code, told, wrong) = run(&open, &["stage.toml", "--report", "stage.html"]);
    assert_eq!((code, wrong.as_str()), (Some(3), ""), "{told}");
    for part in [
        "objective 1, |u| <= 100: undecided",
        "2 of 2 draws and 1 of 1 corner could not be finished",
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

/// Without a sample period nothing runs in f32, and with one everything does.
#[test]
fn runs_say_that_they_are_not_in_single_precision() {
    let single = format!("{STAGE}{}", objective("bound = \"attractive\"\nerror = 6.1e-3"))
        .replace("n = 2", "n = 2\nprecision = \"f32\"");
    let sampled = single.replace("n = 2", "n = 2\nsample_time = 1e-3\nu_step = 0");
    for (text, precision, says) in [
        (&single, "f32", true),
        (&single.replace("f32", "f64"), "f64", false),
        (&sampled.replace("scenarios", "until = -0.1\nscenarios"), "f32", false),
    ] {
        let folder = folder("precision", text);
        let (_, told, wrong) = run(&folder, &["stage.toml"]);
        assert!(told.contains("draws of seed"), "{precision}: {wrong}");
        assert_eq!(
            told.contains(", integrated in f64, called in f32\n"),
            says,
            "{precision}: {told}"
        );
    }
}

/// A state that is 0 throughout is left at the rounding of the others.
#[test]
fn rounding_beside_a_zero_is_no_difference() {
    let text = "name = \"stage\"\nn = 1\nmu = \"exp(a=1)\"\npoles = [-2]\ng = \"1/1.5\"\nf = -9.81\n[params]\ntau = 1\n\
                [plant]\nf = \"-9.81\"\n[verify]\nx1 = [-1, 1]\nscenarios = 20\nsearch = 0\n";
    let text = format!("{text}{}", objective("bound = \"input\"\nupsilon = \"100\""));
    let folder = folder("rounding_beside_zero", &text);
    let (code, told, wrong) = run(&folder, &["stage.toml"]);
    assert_eq!(code, Some(0), "{told}{wrong}");
}

/// From rest an integral begins with a power of time, of which no step has the digits.
#[test]
fn integrals_from_rest_are_finished() {
    let text = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nclock = \"samples\"\nsample_time = 0.01\n\
                [params]\ntau = 0.8\n[plant]\nf = \"gust\"\ngust = [-0.1, 0.1]\n[verify]\nx1 = 0\nx2 = 0\n\
                scenarios = 10\nsearch = 10\n";
    let within = objective("bound = \"within\"\nh = \"integral(x1^2)\"\nhigh = 30");
    let folder = folder("integrals_from_rest", &format!("{text}{within}"));
    let (code, told, wrong) = run(&folder, &["stage.toml"]);
    assert_eq!(code, Some(0), "{told}{wrong}");
}

/// With x2 = -x1 at the start u is 0, and what rounding leaves of it differs on both sides.
#[test]
fn an_input_of_rounding_is_no_difference() {
    let text = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-4.21, -1]\n[params]\ntau = 1\n[plant]\nf = \"0\"\n\
                [verify]\nx1 = [-1, 1]\nx2 = [-1, 1]\nscenarios = 10\nsearch = 10\n";
    let within = objective("bound = \"within\"\nh = \"integral(u^2)\"\nhigh = 3000");
    let folder = folder("input_of_rounding", &format!("{text}{within}"));
    let (code, told, wrong) = run(&folder, &["stage.toml"]);
    assert_eq!(code, Some(0), "{told}{wrong}");
}
