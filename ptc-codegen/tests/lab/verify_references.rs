//! Campaigns of laws that follow a reference, against closed solutions and errors by hand.

use crate::support;

use ptc_codegen::verify::bound::{Proof, proved};
use ptc_codegen::verify::{self, Campaign, Instant, Outcome, Trial, csv};
use support::entries;

fn campaign(text: &str) -> Campaign {
    let spec = support::spec(text);
    let read = verify::read_with_plant(&entries(text), &spec);
    read.unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"))
}

fn instants(campaign: &Campaign, index: u64) -> Vec<Instant> {
    let mut instants = Vec::new();
    let setting = campaign.setting(&campaign.scenario(index));
    let mut trial = Trial::new(campaign).expect("a trial");
    let end = trial.instants(&setting, &mut |instant| instants.push(instant));
    end.unwrap_or_else(|failure| panic!("{failure:?}"));
    instants
}

/// In samples: the errors by hand, at samples and beside a force that is drawn.
const IN_SAMPLES: &str = "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\npoles = [-4, -5]\n\
    reference = \"0.1*sin(2*t)\"\n[params]\ntau = 1\n[plant]\nf = \"gust\"\ngust = [-0.1, 0.1]\n[verify]\n\
    x1 = [-0.3, 0.3]\nx2 = 0\nscenarios = 40\nseed = 7\n[[objective]]\nbound = \"within\"\n\
    h = \"e1 - x1 + 0.1*sin(2*t)\"\nlow = -1e-12\nhigh = 1e-12\n[[objective]]\nbound = \"within\"\n\
    h = \"e2 - x2 + 0.2*cos(2*t)\"\nlow = -1e-12\nhigh = 1e-12\n[[objective]]\nbound = \"attractive\"\nerror = 0.01\n";

#[test]
fn a_loop_in_samples_follows() {
    let campaign = campaign(IN_SAMPLES);
    let mut trial = Trial::new(&campaign).expect("a trial");
    for index in 0..40 {
        let outcome = trial.run(&campaign.setting(&campaign.scenario(index)));
        assert!(outcome.excess.iter().all(|excess| *excess < 0.0), "{outcome:?}");
    }
    for proof in proved(&campaign) {
        assert!(matches!(proof, Proof::NotProved { why } if why.contains("follows a reference")));
    }
    let started = IN_SAMPLES.replace("x2 = 0\n", "x2 = 0\nt0 = [0, 1]\n");
    let refused = verify::read_with_plant(&entries(&started), &support::spec(&started));
    assert!(refused.is_err_and(|found| found[0].message.contains("t0 has no meaning")));
}

/// A chain of order 1 with `exp` and a pole at -4: e = e0 s^4, s = T/tau.
const CHAIN: &str = "n = 1\nmu = \"exp(a=1)\"\npoles = [-4]\ng = 2\nreference = \"sin(w*t) + 0.3*t\"\n\
    [plant]\nf = 0\n[verify]\nx1 = [-1, 1]\ntau = [0.5, 2]\nt0 = [0, 3]\nw = [1, 4]\n\
    until = 0.05\nscenarios = 64\nseed = 5\n[[objective]]\nbound = \"within\"\n\
    h = \"e1 - (x1_0 - sin(w*t0) - 0.3*t0)*(T/tau)^4\"\nlow = 0\nhigh = 0\n\
    [[objective]]\nbound = \"within\"\nh = \"x1 - e1 - sin(w*t) - 0.3*t\"\nlow = 0\nhigh = 0\n\
    [[objective]]\nbound = \"within\"\nh = \"2*u + 4*e1/T - w*cos(w*t) - 0.3\"\nlow = 0\nhigh = 0\n\
    [[objective]]\nbound = \"state\"\nsigma = 2\nzeta = \"(T/tau)^4\"\n\
    [[objective]]\nbound = \"attractive\"\nerror = 6.25e-6\n";

#[test]
fn both_sides_follow_the_closed_solution_in_lanes_and_alone() {
    let campaign = campaign(CHAIN);
    let settings: Vec<_> =
        (0..64).map(|index| campaign.setting(&campaign.scenario(index))).collect();
    let mut trial = Trial::new(&campaign).expect("a trial");
    let judge = |outcome: &Outcome, e0: f64| {
        let sides = [&outcome.excess, &outcome.direct.as_ref().expect("a side").excess];
        for excess in sides {
            assert!(excess[..2].iter().all(|off| *off < 1e-8), "{outcome:?}");
            assert!(excess[2] < 1e-6, "{outcome:?}");
            assert!((excess[3] + 0.5).abs() < 1e-3, "{outcome:?}");
            // The end is at s = 0.05.
            assert!(((1.0 + excess[4]) / e0.abs() - 1.0).abs() < 1e-3, "{outcome:?}");
        }
        assert!(outcome.difference() < 1e-6, "{outcome:?}");
    };
    let together = trial.run_all(&settings);
    for (setting, outcome) in settings.iter().zip(&together) {
        let [t0, w] = ["t0", "w"].map(|name| {
            let all = setting.values.clone();
            let parameter = campaign.spec.parameters().into_iter().find(|p| p.spelling() == name);
            all.get(parameter.expect("a parameter"))
        });
        let e0 = setting.x0[0] - (w * t0).sin() - 0.3 * t0;
        judge(outcome, e0);
        judge(&trial.run(setting), e0);
    }
}

#[test]
fn a_trajectory_shows_the_errors_and_nothing_is_proved() {
    let campaign = campaign(CHAIN);
    for instant in instants(&campaign, 3) {
        assert_eq!(instant.errors.len(), 1);
        assert!(instant.excess[1].abs() < 1e-12, "{instant:?}");
    }
    let mut trial = Trial::new(&campaign).expect("a trial");
    let (text, _) = csv(&campaign, &mut trial, &campaign.scenario(3));
    assert!(text.starts_with("t,time_to_go,x1,u,e1,excess1,"), "{text}");
    let settled = CHAIN.replace("t0 = [0, 3]\nw = [1, 4]\n", "");
    let settled = settled.replace("[plant]", "[params]\nw = 3\nt0 = 0\n[plant]");
    assert_ne!(settled, CHAIN);
    for proof in proved(&self::campaign(&settled)) {
        let Proof::NotProved { why } = proof else { panic!("{proof:?}") };
        assert!(why.contains("the law follows a reference"), "{why}");
    }
    // In the loop that runs neither.
    let sampled = settled.replace("n = 1\n", "n = 1\nsample_time = 1e-3\n");
    let sampled = sampled.replace("tau = [0.5, 2]\n", "").replace("t0 = 0", "t0 = 0\ntau = 1");
    for proof in proved(&self::campaign(&sampled)) {
        let Proof::NotProved { why } = proof else { panic!("{proof:?}") };
        assert!(why.contains("reference"), "{why}");
    }
}

#[test]
fn the_sampled_loop_follows_beyond_the_deadline() {
    let text = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nreference = \"0.1*sin(2*t)\"\n\
        sample_time = 1e-3\n[params]\ntau = 1\n[plant]\nf = \"gust\"\ngust = [-0.05, 0.05]\n[verify]\n\
        x1 = [-0.5, 0.5]\nx2 = [-0.5, 0.5]\nt0 = [0, 2]\nuntil = -1\nscenarios = 4\n\
        [[objective]]\nbound = \"attractive\"\nerror = 1e-3\n\
        [[objective]]\nbound = \"within\"\nh = \"e2 - x2 + 0.2*cos(2*t)\"\nlow = 0\nhigh = 0\n";
    let campaign = campaign(text);
    for index in 0..4 {
        let all = instants(&campaign, index);
        let last = all.last().expect("an instant");
        assert!((last.time_to_go + 1.0).abs() < 1e-9, "{last:?}");
        for Instant { t, x, errors, excess, time_to_go, .. } in &all {
            let by_hand = [x[0] - 0.1 * (2.0 * t).sin(), x[1] - 0.2 * (2.0 * t).cos()];
            assert!(errors.iter().zip(by_hand).all(|(e, own)| (e - own).abs() < 1e-14));
            assert!(excess[1] < 1e-14);
            if *time_to_go <= 0.0 {
                assert!(excess[0] <= 0.0 && x[0].abs() < 0.11, "{x:?} {excess:?}");
            }
        }
        // The state itself moves on.
        assert!(all.iter().any(|at| at.time_to_go <= 0.0 && at.x[1].abs() > 0.1));
    }
}

#[test]
fn each_output_has_its_errors() {
    let text = "mu = \"exp(a=1)\"\npoles = [[-4, -5], [-4]]\nreference = [\"0.3*sin(t)\", \"e1\"]\n[params]\ntau = 1\n\
        e1 = 0.2\n[model]\nstates = [\"y\", \"z\", \"v\"]\ninputs = [\"p\", \"q\"]\noutputs = [\"y\", \"z\"]\n\
        dynamics = { y = \"v\", z = \"q - z^2\", v = \"p*(1 + z^2) - 0.1*v\" }\n[verify]\n\
        y = [-0.5, 0.5]\nz = [-0.5, 0.5]\nv = 0\nscenarios = 3\n\
        [[objective]]\nbound = \"attractive\"\nerror = 1e-2\n\
        [[objective]]\nbound = \"within\"\nh = \"e2_1 - (v - 0.3*cos(t))\"\nlow = 0\nhigh = 0\n\
        [[objective]]\nbound = \"within\"\nh = \"e1_2 - (z - e1)\"\nlow = 0\nhigh = 0\n\
        [[objective]]\nbound = \"within\"\nh = \"x1_1 - y\"\nlow = 0\nhigh = 0\n";
    let campaign = campaign(text);
    for index in 0..3 {
        let all = instants(&campaign, index);
        for Instant { t, x, errors, excess, .. } in &all {
            let by_hand = [x[0] - 0.3 * t.sin(), x[2] - 0.3 * t.cos(), x[1] - 0.2];
            assert_eq!(errors.len(), 3);
            assert!(errors.iter().zip(by_hand).all(|(e, own)| (e - own).abs() < 1e-14));
            assert!(excess[1..].iter().all(|off| *off < 1e-14), "{excess:?}");
        }
        let last = all.last().expect("an instant");
        let norm = last.errors.iter().map(|e| e * e).sum::<f64>().sqrt();
        assert!((last.excess[0] - (norm / 1e-2 - 1.0)).abs() < 1e-9, "{last:?}");
        assert!(norm < 1e-3 && (last.x[0] - 0.3 * last.t.sin()).abs() < 1e-3);
    }
}

/// e1 begins between -0.4 and 0.2, and does not grow.
#[test]
fn an_objective_of_the_error_has_a_value_or_fails() {
    let text = |h: &str| {
        format!(
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nreference = \"0.1 + 0.2*t\"\n[params]\ntau = 1\n\
             t0 = 0\n[plant]\nf = 0\n[verify]\nx1 = [-0.3, 0.3]\nx2 = 0.2\nscenarios = 20\n\
             [[objective]]\nbound = \"within\"\nh = \"{h}\"\nhigh = 1\n"
        )
    };
    let all = [("0*ln(0.25 - e1)", true), ("0*ln(0.1 - e1)", false), ("ln(0.1 - e1)^0", false)];
    for (h, has_values) in all {
        let campaign = campaign(&text(h));
        let mut trial = Trial::new(&campaign).expect("a trial");
        let holds = (0..20).all(|index| {
            let outcome = trial.run(&campaign.setting(&campaign.scenario(index)));
            outcome.excess[0] <= 0.0
        });
        assert_eq!(holds, has_values, "{h}");
    }
}

/// Axes in samples: each has its error, in the loop that runs.
#[test]
fn axes_in_samples_have_their_errors() {
    let text = "n = 2\naxes = 2\nclock = \"samples\"\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n\
        reference = [\"0.1*sin(2*t)\", \"0.2*t\"]\nsample_time = 1e-2\n[params]\ntau = 1\n[verify]\n\
        x1_1 = [-0.5, 0.5]\nx2_1 = 0\nx1_2 = [-0.5, 0.5]\nx2_2 = 0\nscenarios = 3\n\
        [[objective]]\nbound = \"attractive\"\nerror = 1e-4\n\
        [[objective]]\nbound = \"within\"\nh = \"e2_1 - x2_1 + 0.2*cos(2*t)\"\nlow = 0\nhigh = 0\n\
        [[objective]]\nbound = \"within\"\nh = \"e1_2 - x1_2 + 0.2*t\"\nlow = 0\nhigh = 0\n";
    let campaign = campaign(text);
    for index in 0..3 {
        let all = instants(&campaign, index);
        for Instant { t, x, errors, excess, .. } in &all {
            let wanted = [0.1 * (2.0 * t).sin(), 0.2 * (2.0 * t).cos(), 0.2 * t, 0.2];
            let by_hand = x.iter().zip(wanted).map(|(x, r)| x - r);
            assert_eq!(errors.len(), 4);
            assert!(errors.iter().zip(by_hand).all(|(e, own)| (e - own).abs() < 1e-14));
            assert!(excess[1..].iter().all(|off| *off < 1e-14), "{excess:?}");
        }
        let last = all.last().expect("an instant");
        assert!(last.excess[0] < 0.0, "{last:?}");
        // r'' of the second does not move between samples, and r''' of the first is up to 0.8.
        assert!(last.errors[2].abs() < 1e-14 && last.errors[3].abs() < 1e-12, "{last:?}");
        assert!(last.errors[1].abs() > 1e-8, "{last:?}");
    }
}
