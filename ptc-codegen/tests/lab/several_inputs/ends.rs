//! Runs that end early, and what is refused: each with its reason.

use super::{UNICYCLE, example, folder_with, run, run_in};

/// Returns the exit code and the message of a run that ends early.
fn ended(test: &str, design: &str, further: &[&str]) -> (Option<i32>, String) {
    let folder = folder_with(&format!("several_inputs_ends_{test}"), "plant.toml", design);
    let (code, _, told) = run_in(&folder, &[&["simulate", "plant.toml"], further].concat());
    (code, told)
}

/// The unicycle moves away from x = 0 at first, and has to stand still to turn around.
#[test]
fn a_run_ends_where_the_inputs_stop_decoupling_the_outputs() {
    let bounded = UNICYCLE.replace("u_max = inf", "u_max = 30");
    for (name, design) in [("free", UNICYCLE), ("bounded", &bounded)] {
        let (code, told) = ended(name, design, &["--x0", "1,0,2,0", "--at", "0,0.5"]);
        assert_eq!(code, Some(1), "{told}");
        let reason = "the inputs stop decoupling the outputs: the determinant of their matrix goes to 0, where `step` returns PTC_E_RANGE and u = 0, at t = ";
        let at = told.split_once(reason).unwrap_or_else(|| panic!("{told}")).1;
        let at: f64 = at.split(' ').next().expect("a time").parse().expect("a number");
        if name == "free" {
            // x = 7 T^4 - 6 T^5 from (1, 2): x' = -28 T^3 + 30 T^4 is 0 at T = 28/30.
            assert!((at - (1.0 - 28.0 / 30.0)).abs() < 1e-6, "{at}");
        } else {
            // u is clipped before, so that it stops later.
            assert!(at > 1.0 - 28.0 / 30.0 && at < 0.1, "{at}");
        }
    }
    // It cannot start where it stands still.
    let (code, told) = ended("still", UNICYCLE, &["--x0", "1,0.5,0,0.3", "--at", "0,0.5"]);
    assert!(code == Some(1) && told.contains("stop decoupling the outputs"), "{told}");
    // A sampled loop goes on as the emitted code does: u is 0, and `simulate` warns of the first such call.
    let (head, rows, told) =
        run("ends_sampled", UNICYCLE, &["--x0=1,0.5,0,0.3", "--sample-time=1e-3", "--until=0.01"]);
    assert!(head.ends_with(",status") && rows.iter().all(|row| row[6..8] == [0.0, 0.0]));
    assert!(told.contains("step returns PTC_E_RANGE and u = 0, first at t = 0 s"), "{told}");
    assert!(told.contains("in which the inputs do not decouple the outputs"), "{told}");
}

#[test]
fn a_singular_inertia_ends_a_run() {
    let design = example("two_link.toml");
    let at = ["--x0", "1,-0.5,0.2,0", "--at", "0,0.5"];
    for (name, inertia) in
        [("always", "inertia=[[1, 1], [1, 1]]"), ("later", "inertia=[[q1, 0], [0, 1]]")]
    {
        let (code, told) = ended(name, &design, &[&at[..], &["--plant", inertia]].concat());
        assert!(told.contains("the inertia of the plant is singular"), "{told}");
        assert_eq!(code, Some(3), "{told}");
    }
    let held = ["--x0=1,-0.5,0,0", "--sample-time=0.02", "--plant", "inertia=[[1, 1], [1, 1]]"];
    let (_, told) = ended("held", &design, &held);
    assert!(
        told.contains("the inertia of the plant is singular") && told.contains("t = 0 s"),
        "{told}"
    );
}

#[test]
fn what_has_no_meaning_says_so() {
    let arm = example("two_link.toml");
    let at = ["--x0", "1,-0.5,0,0", "--at", "0.5"];
    for (given, message) in [
        ("bias=0", "`bias` of the plant has 1 item, and 2 are needed"),
        ("inertia=[[1, 0]]", "`inertia` of the plant has 1 item, and 2 are needed"),
        ("inertia=[[1], [0]]", "`inertia` of the plant has 1 item, and 2 are needed"),
        ("bias=0, u", "`u` is not known where plant.dynamics"),
        ("dynamics=w1, w2, 0, 0", "`dynamics` of a mechanical plant"),
        ("m3=4", "nothing of the plant is called `m3`"),
        ("bias=friction*w1, 0", "friction has no value"),
    ] {
        let (code, told) = ended("wrong", &arm, &[&at[..], &["--plant", given]].concat());
        assert!(code == Some(2) && told.contains(message), "{given}: {told}");
    }
    let (_, told) =
        ended("tank", &example("tank.toml"), &["--x0", "1,1,1", "--plant", "inertia=[[1]]"]);
    assert!(told.contains("nothing of the plant is called `inertia`"), "{told}");
    let (_, told) = ended("states", &arm, &["--x0", "1,2,3"]);
    assert!(told.contains("give one number for each of q1, q2, w1, w2"), "{told}");
}
