//! No two checks of a report contradict one another, and leaving a key out is no way around a verdict.

use crate::support::entries;

use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::check::sampled::stability;
use ptc_codegen::plant::read_design;

/// Numbers from a seed.
struct Draws(u64);

impl Draws {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        ((low + (high - low) * self.next()) * 1000.0).round() / 1000.0
    }

    fn of<'a>(&mut self, all: &[&'a str]) -> &'a str {
        all[(self.next() * all.len() as f64) as usize]
    }
}

/// A design as its lines: those under [params] last.
fn drawn(seed: u64) -> Vec<String> {
    let mut draws = Draws(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + 1);
    let n = 1 + (draws.next() * 3.0) as usize;
    let in_samples = draws.next() < 0.7;
    let delay = if in_samples { (draws.next() * 2.0) as usize } else { 0 };
    let poles = |draws: &mut Draws, count: usize| {
        let all: Vec<_> = (0..count).map(|_| format!("-{}", draws.between(0.3, 7.0))).collect();
        all.join(", ")
    };
    let mut lines = vec![
        format!("n = {n}"),
        "mu = \"exp(a=1)\"".to_owned(),
        "sample_time = 0.02".to_owned(),
        format!("poles = [{}]", poles(&mut draws, n + delay)),
        format!("x0_max = [{}]", vec!["1"; n].join(", ")),
        format!("error = {}", draws.of(&["1e-9", "1e-3", "1", "1e3"])),
    ];
    if draws.next() < 0.5 {
        lines.push(format!("noise = {}", draws.of(&["1e-6", "1e-2"])));
    }
    if in_samples {
        lines.push("clock = \"samples\"".to_owned());
        lines.push(format!("delay = {delay}"));
        if n > 1 && draws.next() < 0.4 {
            lines.push("measured = [\"x1\"]".to_owned());
            lines.push(format!("observer_poles = [{}]", poles(&mut draws, n)));
        }
    }
    if in_samples && draws.next() < 0.5 {
        lines.push("deadbeat = 8".to_owned());
    }
    let held = format!("{}", 0.02 * f64::from((draws.next() * 12.0) as u32));
    lines.push("[params]".to_owned());
    lines.push(format!("eps = {}", if in_samples { held } else { "0.1".to_owned() }));
    lines.push("tau = 1.2".to_owned());
    lines.push(format!("u_max = {}", draws.of(&["3", "300", "1e9", "inf"])));
    lines
}

fn report(lines: &[String]) -> Option<Report> {
    let (spec, _) = read_design(&entries(&(lines.join("\n") + "\n"))).ok()?;
    Some(examine(&spec))
}

fn of(report: &Report, name: &str) -> (Verdict, String) {
    let found = report.outcomes.iter().find(|outcome| outcome.name == name).expect("a check");
    (found.verdict, found.summary.clone())
}

/// 3 for a refusal, 2 for what is undecided, 1 where something was not looked at, 0 for acceptance alone.
fn grade(report: &Report) -> u8 {
    if report.refusals().next().is_some() {
        return 3;
    }
    match (report.undecided().next().is_some(), report.unseen().is_empty()) {
        (true, _) => 2,
        (false, false) => 1,
        (false, true) => 0,
    }
}

#[test]
fn growth_never_refuses_what_the_loop_proves() {
    let (mut proved, mut held, mut unstable) = (0, 0, 0);
    for seed in 0..60 {
        let lines = drawn(seed);
        let Some(report) = report(&lines) else { continue };
        if report.spec.sampled().is_none() {
            continue;
        }
        let (growth, why) = of(&report, "growth");
        assert!(!matches!(growth, Verdict::Unsound | Verdict::Refuted), "{lines:?} {why}");
        proved += u32::from(of(&report, "loop").0 == Verdict::Sound);
        // By the powers of the transition of the emitted program, where no observer has modes of its own.
        let observes = lines.iter().any(|line| line.starts_with("observer_poles"));
        if why.contains("held") && !observes {
            held += 1;
            unstable += u32::from(growth == Verdict::Undecided);
            let found = stability(&report.spec, None);
            assert_eq!(growth == Verdict::Sound, found.is_ok(), "{lines:?} {why} {found:?}");
        }
    }
    assert!(proved > 4 && held > 8 && unstable > 0, "{proved} {held} {unstable}");
}

#[test]
fn a_key_that_is_left_out_makes_no_acceptance_of_a_refusal() {
    let (mut refused, mut clipped) = (0, 0);
    for seed in 100..140 {
        let lines = drawn(seed);
        let Some(whole) = report(&lines) else { continue };
        let grade_of_whole = grade(&whole);
        refused += u32::from(grade_of_whole > 1);
        let is_clipped = of(&whole, "loop").1.starts_with("u may reach its limit");
        clipped += u32::from(is_clipped);
        for key in ["error", "noise", "x0_max", "u_max"] {
            let without: Vec<_> = lines
                .iter()
                .filter(|line| !line.starts_with(&format!("{key} =")))
                .cloned()
                .collect();
            let Some(less) = report(&without) else { continue };
            assert!(grade_of_whole < 2 || grade(&less) > 0, "{lines:?} without {key}");
            if key == "error" && is_clipped {
                let looped = of(&less, "loop");
                assert_eq!(looped.0, Verdict::Undecided, "{lines:?} {}", looped.1);
            }
        }
    }
    assert!(refused > 5 && clipped > 1, "{refused} {clipped}");
}

/// The first number behind a phrase of a summary or a fix.
fn suggested(report: &Report, phrase: &str) -> Option<f64> {
    let mut texts = report.outcomes.iter().flat_map(|outcome| {
        outcome.fix.iter().chain([&outcome.summary]).cloned().collect::<Vec<_>>()
    });
    texts.find_map(|text| {
        let behind = text.split_once(phrase)?.1.to_owned();
        let number: String =
            behind.chars().take_while(|c| c.is_ascii_digit() || "+-.e".contains(*c)).collect();
        number.trim_end_matches('.').parse().ok()
    })
}

/// A number that a report suggests is accepted by the check that suggests it.
#[test]
fn suggested_numbers_are_accepted() {
    let with = |text: &str| {
        let (spec, _) =
            read_design(&entries(text)).unwrap_or_else(|wrong| panic!("{wrong:?} {text}"));
        examine(&spec)
    };
    let fails = |report: &Report, name: &str| {
        matches!(of(report, name).0, Verdict::Unsound | Verdict::Refuted | Verdict::Undecided)
    };
    let mut draws = Draws(7);
    for base in [3.1, 7.7, 23.0, 100.0, 1234.5] {
        let text =
            |poles: &str| format!("n = 3\nmu = \"tau*(1 - {base}^(-t))\"\npoles = [{poles}]\n");
        let refused = with(&text("-0.1, -0.2, -0.3"));
        assert!(fails(&refused, "growth"), "{base}");
        let line = suggested(&refused, "left of ").expect("a line");
        let poles = format!("{line}, {}, {}", line - 0.1, line - 0.2);
        assert!(!fails(&with(&text(&poles)), "growth"), "{base}: {poles}");
        let (a, p) = (draws.between(1.5, 4.0), draws.between(0.5, 2.0));
        let text = |a: f64| format!("n = 2\nmu = \"exp(a={a:?})\"\npoles = [-{p}, -{}]\n", p + 0.5);
        let refused = with(&text(a + 2.0));
        let a = suggested(&refused, "take a of at most ").expect("a rate");
        assert!(!fails(&with(&text(a)), "growth"), "a = {a}, p = {p}");
    }
    for (tau, h) in [(1.0, 1e-3), (0.7, 3e-3), (13.0, 0.011)] {
        let text = |more: &str| {
            format!("n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n{more}\n[params]\ntau = {tau:?}\n")
        };
        let asked = |eps: f64| text(&format!("sample_time = {h:?}\neps = {eps:?}"));
        let refused = with(&asked(h / 50.0));
        for phrase in ["needs eps >= ", "take eps = "] {
            let eps = suggested(&refused, phrase).expect("an eps");
            assert!(!fails(&with(&asked(eps)), "sampling"), "{phrase}{eps}");
        }
        let asked = |eps: f64| text(&format!("error = 1e-3\nx0_max = [1, 1]\neps = {eps:?}"));
        let eps = suggested(&with(&asked(tau * 0.9)), "take eps <= ").expect("an eps");
        assert!(!fails(&with(&asked(eps)), "deadline"), "{eps}");
        let asked = |u_max: f64| {
            format!(
                "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nclock = \"samples\"\nsample_time = 0.01\n\
                 x0_max = [{tau}, 1]\n[params]\ntau = 1\nu_max = {u_max:?}\n"
            )
        };
        let u_max = suggested(&with(&asked(0.1)), "take u_max = ").expect("a limit");
        assert!(!fails(&with(&asked(u_max)), "loop"), "{u_max}");
    }
}
