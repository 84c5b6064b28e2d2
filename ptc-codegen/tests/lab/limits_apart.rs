//! Limits of u that are not symmetric: what runs do at them, and what the check `loop` says of runs that come near.

use ptc_codegen::check::Verdict;
use ptc_codegen::reference::Status;
use ptc_codegen::simulate::{Loop, Sampled, Values};

use crate::looped::loop_of;
use crate::support::{design, entries};

const PERIOD: f64 = 0.01;

const CHAINS: [&str; 3] = [
    "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nx0_max = [0.5, 0.25]\neps = 0.05\n",
    "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nx0_max = [0.5, 0.25]\nclock = \"samples\"\neps = 0\n",
    "n = 3\nmu = \"exp(a=1)\"\npoles = [-4, -5, -6, -7]\nx0_max = [0.5, 0.25, 1]\nclock = \"samples\"\ndelay = 1\neps = 0\n",
];

fn text(chain: &str, limits: &str) -> String {
    format!("name = \"apart\"\n{chain}tau = 1\nsample_time = {PERIOD}\nerror = 10\n{limits}")
}

/// Each u of a run, with its status.
fn run(text: &str, x0: &[f64]) -> Vec<(f64, Status)> {
    let (spec, plant) = design(text);
    let values = Values::of(&spec, &plant);
    let around = Loop::of(&spec).expect("a sample period");
    let mut seen = Vec::new();
    let end = Sampled::new(&spec, &plant).expect("a loop").run(&values, x0, &around, &mut |s| {
        seen.push((s.u[0], s.status));
    });
    end.unwrap_or_else(|failure| panic!("{text}: {failure}"));
    seen
}

/// The corner of the bounds at the start from which u is largest, and this u.
fn worst(chain: &str, bounds: &[f64]) -> (Vec<f64>, f64) {
    let text = text(chain, "u_max = inf\n");
    let corners = (0..1 << bounds.len()).map(|signs: u32| -> Vec<f64> {
        let signed = |(i, bound): (usize, &f64)| if signs >> i & 1 == 1 { -bound } else { *bound };
        bounds.iter().enumerate().map(signed).collect()
    });
    let peak = |x0: &[f64]| run(&text, x0).into_iter().fold(f64::MIN, |peak, (u, _)| peak.max(u));
    let all = corners.map(|x0| (peak(&x0), x0));
    let (u, x0) = all.max_by(|a, b| a.0.total_cmp(&b.0)).expect("a corner");
    (x0, u)
}

/// The loop is linear and the bounds at the start are symmetric, so that -u reaches what u reaches.
#[test]
fn clipping_is_judged_at_the_nearer_limit() {
    for chain in CHAINS {
        let (spec, _) = design(&text(chain, ""));
        let bounds = [0.5, 0.25, 1.0];
        let (x0, peak) = worst(chain, &bounds[..spec.n]);
        let opposite: Vec<_> = x0.iter().map(|x| -x).collect();
        for (share, sound) in [(1.0 + 1e-6, true), (1.0 - 1e-6, false)] {
            let near = share * peak;
            for (limits, start) in [
                (format!("u_min = {}\nu_max = {}\n", -near, 3.0 * peak), &opposite),
                (format!("u_min = {}\nu_max = {near}\n", -3.0 * peak), &x0),
                (format!("u_min = {}\nu_max = inf\n", -near), &opposite),
                (format!("u_min = -inf\nu_max = {near}\n"), &x0),
            ] {
                let text = text(chain, &limits);
                let wanted = if sound { Verdict::Sound } else { Verdict::Undecided };
                let found = loop_of(&text);
                assert_eq!(found.verdict, wanted, "{text}{found:?}");
                let seen = run(&text, start);
                let clipped = seen.iter().any(|(_, status)| *status == Status::Saturated);
                assert_eq!(clipped, !sound, "{text}");
            }
        }
    }
}

/// A u that is clipped is the limit on its side, and no other is clipped.
#[test]
fn clipped_u_equals_the_limit_of_its_sign() {
    // Of a delayed loop the runs show the input that acts, which is 0 at first.
    for chain in &CHAINS[..2] {
        for limits in
            ["u_min = -0.5\nu_max = 2\n", "u_min = 0\nu_max = 2\n", "u_min = 0.25\nu_max = 1\n"]
        {
            let text = text(chain, limits);
            let (spec, _) = design(&text);
            let numbers: Vec<f64> = limits
                .lines()
                .map(|line| line.split(" = ").nth(1).expect("a value").parse().expect("a number"))
                .collect();
            let (least, most) = (numbers[0], numbers[1]);
            let mut met = [false; 2];
            for sign in [1.0, -1.0] {
                let x0: Vec<_> = [0.5, 0.25, 1.0][..spec.n].iter().map(|x| sign * x).collect();
                for (u, status) in run(&text, &x0) {
                    assert!((least..=most).contains(&u), "{text}{u}");
                    match status {
                        Status::Saturated => assert!(u == least || u == most, "{text}{u}"),
                        _ => assert!(u > least && u < most, "{text}{u} {status:?}"),
                    }
                    met = [met[0] || u == least, met[1] || u == most];
                }
            }
            assert_eq!(met, [true; 2], "{text}");
        }
    }
}

/// Without 0 between its limits u is clipped at rest, which no bound of |u| excludes.
#[test]
fn limits_that_exclude_zero_are_undecided() {
    for chain in CHAINS {
        let found = loop_of(&text(chain, "u_min = 0.001\nu_max = 1e9\n"));
        assert_eq!(found.verdict, Verdict::Undecided, "{found:?}");
    }
}

/// From a box on one side of 0 u is not symmetric, and each limit is held against what u reaches on its side.
#[test]
fn proof_checks_u_against_both_limits() {
    // u = -2 x/((M + 1) h), M samples to go and at least 5, is largest at the start, -2/0.51, and never positive.
    let running = "n = 1\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-2]\nsample_time = 0.01\neps = 0.05\n\
                   tau = 0.5\n[verify]\nx1 = [0.5, 1]\n";
    // u = 60 s^2 - 80 s^3, s = T/tau, from x1 = 1 at rest: -20 at the start, 5 at s = 1/2.
    let continuous = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\ntau = 1\n[plant]\nf = 0\n[verify]\nx1 = [0.5, 1]\nx2 = 0\n";
    let objective = "[[objective]]\nbound = \"attractive\"\nerror = 1\n";
    for (design, within, beyond) in [
        (running, [-3.922, 0.001], [[-3.921, 0.001], [-3.922, -0.04]]),
        (continuous, [-20.001, 5.001], [[-19.999, 5.001], [-20.001, 4.999]]),
    ] {
        let proved = |[low, high]: [f64; 2]| {
            let text = format!("u_min = {low:?}\nu_max = {high:?}\n{design}{objective}");
            let entries = entries(&text);
            let spec = ptc_codegen::request::read(&entries).expect("a design");
            let campaign =
                ptc_codegen::verify::read_with_plant(&entries, &spec).expect("a campaign");
            ptc_codegen::verify::bound::proved(&campaign)
        };
        let found = proved(within);
        assert!(found[0].is_proved(), "{within:?}: {found:?}");
        for limits in beyond {
            let found = proved(limits);
            assert!(!found[0].is_proved(), "{limits:?}: {found:?}");
        }
    }
}
