//! Scenarios of loops that are stiff while a law holds a disturbance: what is left of the states is what the rounding of f + g u
//! leaves of them.

use crate::verify_lanes::{bits, campaign, settings};

use ptc_codegen::verify::Trial;

/// A law that holds an unknown constant force down to T/tau = 1e-3, where the last state is some 1e-19 and the terms of its rate
/// are 1e-1.
fn held(n: usize, mu: &str) -> String {
    let poles: Vec<_> = (0..n).map(|i| format!("-{}", n + 1 + i)).collect();
    let states: String = (1..=n).map(|j| format!("x{j} = [-1, 1]\n")).collect();
    format!(
        "n = {n}\nmu = \"{mu}\"\npoles = [{}]\n[plant]\nf = \"gust\"\ngust = [-0.1, 0.1]\n[verify]\n{states}\
         tau = [0.5, 2]\nscenarios = 8\nuntil = 1e-3\nseed = 7\n[[objective]]\nbound = \"attractive\"\n\
         error = 1e-2\n[[objective]]\nbound = \"within\"\nh = \"u\"\nhigh = 1e7\n",
        poles.join(", ")
    )
}

/// Runs by themselves took half a second each, as all their steps round.
#[test]
fn a_law_that_holds_a_force_is_run_in_lanes() {
    for mu in ["mean(exp(a=1), rational(a=1))", "rational(a=1)", "tan(a=1)"] {
        let campaign = campaign(&held(5, mu));
        let mut trial = Trial::new(&campaign).expect("a loop");
        let settings = settings(&campaign, 8);
        let together = trial.run_all(&settings);
        let mut alone = 0;
        for (setting, own) in settings.iter().zip(&together) {
            let by_itself = trial.run(setting);
            alone += usize::from(bits(&by_itself) == bits(own));
            assert_eq!(by_itself.status(), own.status(), "{mu}");
            assert!(own.difference() < 1e-8, "{mu}: {}", own.difference());
            for (a, b) in own.excess.iter().zip(&by_itself.excess) {
                assert!((a - b).abs() < 1e-8 * (1.0 + a.abs()), "{mu}: {a} {b}");
            }
        }
        assert!(alone <= 1, "{mu}: {alone} not in lanes");
    }
}

/// Close to the deadline too the last digits of the states are those that rounding leaves, not what an integration gave up on.
#[test]
fn sides_agree_far_below_the_rounding_of_the_force() {
    for until in ["1e-2", "1e-3", "1e-4"] {
        let text = held(3, "rational(a=1)").replace("1e-3", until);
        let campaign = campaign(&text);
        let mut trial = Trial::new(&campaign).expect("a loop");
        for outcome in trial.run_all(&settings(&campaign, 8)) {
            assert!(outcome.ended.is_none() && outcome.difference() < 1e-7, "{until}: {outcome:?}");
        }
    }
}
