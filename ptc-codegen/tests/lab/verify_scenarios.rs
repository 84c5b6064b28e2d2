//! Scenarios of a verification: draws, corners, what is printed and run again, and the worst signals
//! that a search finds, against closed solutions.

use crate::support;

use ptc_codegen::verify::search::search;
use ptc_codegen::verify::{
    self, Campaign, Corners, Course, Judgement, Outcome, Scenario, Signal, Status, Tally, Trial,
};

fn campaign(text: &str) -> Campaign {
    let (spec, plant) = support::design(text);
    let read = verify::read(&support::entries(text), &spec, &plant);
    read.unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"))
}

/// n, poles, tables.
fn design(n: usize, poles: &str, rest: &str) -> Campaign {
    campaign(&format!("n = {n}\nmu = \"exp(a=1)\"\npoles = [{poles}]\n{rest}"))
}

const UNCERTAIN: &str = "[plant]\nf = \"gust - damping*x2 + slip*u\"\ndamping = [0, 0.5]\n\
                         slip = [-0.2, 0.2]\ngust = [-0.1, 0.3]\n[disturbance]\ngust = \"any\"\n\
                         [verify]\nx1 = [-1, 1]\nx2 = [0.25, 1]\ntau = [0.5, 2]\nscenarios = 4000\n\
                         seed = 5\n[[objective]]\nbound = \"attractive\"\nerror = 1\n";

#[test]
fn draws_are_even_and_independent() {
    let campaign = design(2, "-3, -4", UNCERTAIN);
    let draws: Vec<_> = (0..campaign.scenarios).map(|index| campaign.scenario(index)).collect();
    let sides: Vec<_> = campaign.uncertain().map(|(_, side)| side).collect();
    let parts = |draw: &Scenario| -> Vec<f64> {
        let pairs = draw.point.iter().zip(&sides);
        pairs.map(|(value, (low, high))| (value - low) / (high - low)).collect()
    };
    let count = draws.len() as f64;
    let sigma = (1.0 / 12.0 / count).sqrt();
    for side in 0..sides.len() {
        let all: Vec<_> = draws.iter().map(|draw| parts(draw)[side]).collect();
        assert!(all.iter().all(|part| (0.0..1.0).contains(part)), "{side}");
        let mean = all.iter().sum::<f64>() / count;
        assert!((mean - 0.5).abs() < 4.0 * sigma, "{side}: {mean}");
        // No index is another kind of draw than the next one.
        for period in [2, 3, 4, 5] {
            let own: Vec<_> = all.iter().step_by(period).collect();
            let mean = own.iter().copied().sum::<f64>() / own.len() as f64;
            assert!((mean - 0.5).abs() < 5.0 * sigma * (period as f64).sqrt(), "{side}: {period}");
            assert!(own.iter().all(|part| **part > 0.0), "corners are no draws");
        }
        let next: f64 = all.windows(2).map(|pair| (pair[0] - 0.5) * (pair[1] - 0.5)).sum();
        assert!((next / count).abs() < 4.0 / 12.0 / count.sqrt(), "{side}: {next}");
    }
    for signal in Signal::ALL {
        let own = draws.iter().filter(|draw| draw.courses[0].signal() == signal).count();
        assert!((700..900).contains(&own), "{signal:?}: {own}");
    }
}

#[test]
fn rows_hold_the_drawn_signals() {
    let campaign = design(2, "-3, -4", UNCERTAIN);
    let columns = campaign.columns();
    let of = |name: &str| columns.iter().position(|own| own == name).expect("a column");
    let levels: Vec<_> = (1..=16).map(|piece| of(&format!("gust.{piece}"))).collect();
    let outcome = Outcome { excess: vec![-1.0], direct: None, ended: None };
    let mut seen = [0; 5];
    for index in 0..200 {
        let scenario = campaign.scenario(index);
        let numbers = campaign.numbers(&scenario, outcome.clone());
        let at = |name: &str| numbers[of(&format!("gust.{name}"))];
        let own: Vec<_> = levels.iter().map(|place| numbers[*place]).collect();
        let known = |of: [bool; 3]| {
            assert_eq!([!at("value").is_nan(), !at("periods").is_nan(), !own[0].is_nan()], of);
            assert_eq!(at("phase").is_nan(), at("periods").is_nan());
        };
        seen[scenario.courses[0].signal() as usize] += 1;
        assert_eq!(at("signal"), scenario.courses[0].signal().code());
        match &scenario.courses[0] {
            Course::Constant(value) => {
                known([true, false, false]);
                assert_eq!(at("value"), *value);
            }
            Course::Sine(periods, phase) => {
                known([false, true, false]);
                assert_eq!([at("periods"), at("phase")], [*periods, *phase]);
            }
            Course::Square(halves, phase) => {
                known([false, true, false]);
                assert_eq!([2.0 * at("periods"), at("phase")], [*halves, *phase]);
            }
            Course::Random(drawn) => {
                known([false, false, true]);
                assert_eq!(own, *drawn);
            }
            Course::Worst { high, switches } => {
                known([false, false, true]);
                assert_eq!(own[0], if *high { 0.3 } else { -0.1 });
                let jumps = own.windows(2).filter(|pair| pair[0] != pair[1]).count();
                assert_eq!(jumps, switches.len());
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
    // Names of symbols have no dot, so that none is that of a column of a signal.
    assert!(columns.iter().enumerate().all(|(place, name)| of(name) == place), "{columns:?}");
}

#[test]
fn corners_are_joint_and_hold_the_start_nearest_to_rest() {
    let campaign = design(2, "-3, -4", UNCERTAIN);
    let corners = campaign.corners();
    // Of tau, x1, x2, damping, slip and gust, and with x1 = 0 of all but x0.
    assert_eq!(corners.len(), 64 + 16);
    let (whole, nearest) = corners.split_at(64);
    for (place, corner) in whole.iter().enumerate() {
        let told = campaign.text_of(corner);
        assert!(whole[..place].iter().all(|own| campaign.text_of(own) != told), "{told}");
        for (value, (_, (low, high))) in corner.point.iter().zip(campaign.uncertain()) {
            assert!(*value == low || *value == high, "{told}");
        }
        let gust = told.rsplit("gust = ").next();
        assert!(matches!(gust, Some("-0.1" | "0.3")), "{told}");
    }
    assert!(nearest.iter().all(|corner| corner.point[1..3] == [0.0, 0.25]));
}

#[test]
fn what_is_printed_is_run_again_to_the_last_bit() {
    let campaign = design(2, "-3, -4", UNCERTAIN);
    let corners = campaign.corners();
    for scenario in (0..200).map(|index| campaign.scenario(index)).chain(corners) {
        let told = campaign.text_of(&scenario);
        assert_eq!(campaign.replayed(&told), Ok(scenario), "{told}");
    }
    let good = "tau = 2, x1 = -1, x2 = 1, damping = 0, slip = 0.1, gust = worst(0.3, 0.5, 0.1)";
    assert!(campaign.replayed(good).is_ok());
    for (from, to, part) in [
        ("tau = 2", "tau = 3", "no tau in [0.5, 2]"),
        ("x1 = -1, ", "", "no x1 in [-1, 1]"),
        ("x1 = -1", "x1", "`x1` in the scenario is not NAME = VALUE"),
        ("0.3, 0.5, 0.1", "0.2, 0.5, 0.1", "no legal gust"),
        ("0.3, 0.5, 0.1", "0.3, 0.1, 0.5", "no legal gust"),
        ("worst(0.3, 0.5, 0.1)", "worst(0.3", "no legal gust"),
        ("worst(0.3, 0.5, 0.1)", "sine(0.1, 0)", "no legal gust"),
        ("worst(0.3, 0.5, 0.1)", "nan", "no legal gust"),
        ("slip", "slop", "no slip"),
        ("tau = 2", "tau = 2, x3 = 1", "`x3` is not a quantity"),
    ] {
        let (message, help) = campaign.replayed(&good.replace(from, to)).expect_err(part);
        assert!(message.contains(part) && !help.is_empty(), "{message}");
    }
}

/// Largest effect of a disturbance within -1..1 on x1 and x2 at T, from x0 = 0 and tau = 1 with the poles -p and -q:
/// an impulse at T0 leaves T0 (r^q - r^p)/(p - q) with r = T/T0.
fn worst((p, q): (f64, f64), t: f64) -> [f64; 2] {
    let count = 20_000;
    let mut sums = [0.0; 2];
    for i in 0..count {
        let from = t + (1.0 - t) * (f64::from(i) + 0.5) / f64::from(count);
        let r = t / from;
        let x1 = from * (r.powf(q) - r.powf(p)) / (p - q);
        let x2 = (p * r.powf(p - 1.0) - q * r.powf(q - 1.0)) / (p - q);
        sums[0] += x1.abs() * (1.0 - t) / f64::from(count);
        sums[1] += x2.abs() * (1.0 - t) / f64::from(count);
    }
    sums
}

fn found(campaign: &Campaign) -> (f64, Scenario) {
    let trial = Trial::new(campaign).expect("a loop");
    let corners = Corners::run(campaign, &trial, &|| ());
    let mut starts = corners.starts(campaign, 0);
    starts.push(campaign.scenario(0));
    let found = search(campaign, &trial, (0, &starts, None), &|_| ());
    assert!(found.runs <= campaign.search + 1, "{}", found.runs);
    (found.excess, found.scenario)
}

#[test]
fn the_search_switches_where_the_kernel_changes_its_sign() {
    for (p, q) in [(3.0, 2.5), (6.0, 3.0)] {
        let poles = format!("-{p}, -{q}");
        let tables = |h: &str, high: f64| {
            format!(
                "[params]\ntau = 1\n[plant]\nf = \"d\"\nd = [-1, 1]\n[disturbance]\nd = \"worst\"\n\
                 [verify]\nx1 = 0\nx2 = 0\nscenarios = 1\nsearch = 40\nuntil = 0.01\n\
                 [[objective]]\nbound = \"within\"\nh = \"{h}\"\nhigh = {high}\n"
            )
        };
        for (place, h) in ["x1", "x2"].into_iter().enumerate() {
            // The greatest over the run.
            let most = (1..100).map(|i| worst((p, q), f64::from(i) / 100.0)[place]);
            let most = most.fold(0.0, f64::max);
            let campaign = design(2, &poles, &tables(h, most));
            let (excess, scenario) = found(&campaign);
            assert!(excess.abs() < 2e-3 * most, "{h}, {p}, {q}: {excess} beside {most}");
            let told = campaign.text_of(&scenario);
            assert!(told.contains("d = worst("), "{told}");
        }
    }
}

#[test]
fn what_one_side_exceeds_before_it_ends_is_no_failure() {
    // Of x near 1e-200 the plant in doubles keeps rounding alone, which the law then drives far out.
    let fixed: String = (2..8).map(|j| format!("x{j} = 0.2\n")).collect();
    let text = format!(
        "n = 8\nmu = \"power(a=0.90, m=2)\"\n\
         poles = [-2.72, -3.72, -3.72, -4.72, -6.05, -7.63, -7.63, -7.63]\n[plant]\nf = 0\n\
         [verify]\nx1 = [-1, 1]\n{fixed}x8 = [-0.5, 0.5]\ntau = 2\nscenarios = 1\n\
         [[objective]]\nbound = \"input\"\nupsilon = \"300318103.7\"\n"
    );
    let campaign = campaign(&text);
    let mut trial = Trial::new(&campaign).expect("a loop");
    let mut unfinished = 0;
    for (x1, x8) in [(-1.0, -0.5), (-1.0, 0.5), (1.0, -0.5), (1.0, 0.5)] {
        let mut scenario = campaign.scenario(0);
        (scenario.point[1], scenario.point[8]) = (x1, x8);
        let outcome = trial.run(&campaign.setting(&scenario));
        assert!(
            outcome.excess[0] < 0.0
                && outcome.direct.as_ref().is_some_and(|direct| direct.excess[0] > 0.0),
            "{outcome:?}"
        );
        assert_eq!(outcome.judgement(0), Judgement::Open, "{outcome:?}");
        unfinished += u32::from(outcome.status() == Status::Unfinished);
    }
    assert!(unfinished > 0);
}

#[test]
fn a_run_that_cannot_be_finished_is_neither_kept_nor_failed() {
    // x1 falls below 0.5, where f has no value.
    let text = |high: f64| {
        format!(
            "[params]\ntau = 1\n[plant]\nf = \"sqrt(x1 - 0.5)\"\n[verify]\nx1 = 1\nx2 = 0\n\
             scenarios = 3\nsearch = 5\n[[objective]]\nbound = \"within\"\nh = \"x1\"\nhigh = {high}\n"
        )
    };
    for (high, fails) in [(1.5, false), (1.0 - 1e-3, true)] {
        let campaign = design(2, "-3, -4", &text(high));
        let mut trial = Trial::new(&campaign).expect("a loop");
        let outcome = trial.run(&campaign.setting(&campaign.scenario(0)));
        assert_eq!(outcome.status(), Status::Unfinished, "{outcome:?}");
        let ended = outcome.ended.expect("a reason");
        assert!(ended.at.is_some_and(|t| 0.0 < t && t < 1.0) && !ended.help.is_empty(), "{ended}");
        let mut tally = Tally::new(&campaign);
        (0..3).for_each(|index| tally.add(&campaign.row(&mut trial, index)));
        assert_eq!((tally.unfinished, tally.first_unfinished), (3, Some(0)));
        assert_eq!(tally.failed[0], if fails { 3 } else { 0 });
        let row = campaign.row(&mut trial, 0);
        assert_eq!(campaign.columns().last().map(String::as_str), Some("status"));
        assert_eq!(row.numbers.last(), Some(&Status::Unfinished.code()));
    }
}

/// Dry friction of 100 holds x1 at 1 as long as the law wants less, 12/T^2: until T = 0.346. The force that the
/// law cancels makes its u another function on each side of the jump, and no side has a bound of u.
#[test]
fn what_dry_friction_holds_is_run_to_its_end() {
    let text = "f = \"-20*sin(x1) - 0.2*x2\"\ntau = 1\neps = 0.05\n[plant]\n\
                f = \"-20*sin(x1) - 0.2*x2 - 100*sign(x2)\"\n[verify]\nx1 = 1\nx2 = 0\nscenarios = 1\nuntil = 0.35\n\
                [[objective]]\nbound = \"within\"\nh = \"x1\"\nlow = 0.999999\nhigh = 1.000001\n";
    let campaign = design(2, "-3, -4", text);
    let mut trial = Trial::new(&campaign).expect("a trial");
    let outcome = trial.run(&campaign.setting(&campaign.scenario(0)));
    assert_eq!(outcome.ended, None);
    assert!((outcome.excess[0] + 1e-6).abs() < 1e-12, "{outcome:?}");
    assert!(outcome.direct.is_some_and(|other| other.difference < 1e-9));
}
