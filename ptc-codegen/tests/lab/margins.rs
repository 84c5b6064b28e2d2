//! Margins of a loop beyond its design: each ends where the check does.

use crate::loop_of_plant::{designs, verdict};
use crate::support::entries;

use ptc_codegen::check::Verdict;
use ptc_codegen::check::sampled::margins;
use ptc_codegen::plant::read_design;

/// The gain of a linear plant is that of its B.
#[test]
fn margins_of_a_linear_plant_end() {
    let text = "n = 2\nname = \"motor\"\nmu = \"exp(a=1)\"\nclock = \"samples\"\neps = 0\nsample_time = 2e-3\npoles = [-4, -5]\n\
        u_max = inf\nx0_max = [1, 1]\nerror = 1e-3\n[params]\ntau = 0.1\n[plant]\nA = [[0, 1], [-3, -0.5]]\nB = [0, 2]\n";
    let (spec, _) = read_design(&entries(text)).expect("a design");
    let found = margins(&spec, None).expect("a sound loop");
    let at = |gain: f64| {
        let g_error = format!("g_error = [{gain}, {gain}]\n{text}");
        verdict(&g_error).0
    };
    let [low, high] = found.gain;
    assert!(0.2 < low && low < 1.0 && 1.0 < high && high < 5.0, "{found:?}");
    assert_eq!([at(low * 1.001), at(high * 0.999)], [Verdict::Sound; 2], "{found:?}");
    assert_eq!([at(low * 0.98), at(high * 1.02)], [Verdict::Refuted; 2], "{found:?}");
    jitter_ends(text, found.jitter);
}

/// Each end of the margins is sound, and a little beyond it the loop is not.
#[test]
fn margins_end_where_the_loop_is_not_sound() {
    for text in [&designs()[3]] {
        let text = text.replace("error = 10", "error = [2e-3, 0.1]");
        let (spec, _) = read_design(&entries(&text)).expect("a design");
        let margins = margins(&spec, None).expect("a sound loop");
        let at = |gain: f64, delay: usize| {
            let text = text.replace("f = \"push\"\n", &format!("f = \"push\"\ng = {gain:?}\n"));
            verdict(&text.replace("delay = 0", &format!("delay = {delay}"))).0
        };
        let [low, high] = margins.gain;
        let late = margins.delay.expect("a clock in time");
        assert!(low < 0.9 && 1.1 < high && high < 60.0, "{margins:?}");
        for (gain, delay) in [(low * 1.001, 0), (high * 0.999, 0), (1.0, late)] {
            assert_eq!(at(gain, delay), Verdict::Sound, "{margins:?}");
        }
        // 16 is the longest legal delay.
        let beyond = if late == 16 { (high * 1.05, 0) } else { (1.0, late + 1) };
        for (gain, delay) in [(low * 0.98, 0), (high * 1.02, 0), beyond] {
            assert_ne!(at(gain, delay), Verdict::Sound, "{margins:?}");
        }
        jitter_ends(&text, margins.jitter);
    }
}

/// Margins of different axes are those that all axes tolerate; with a clock in samples too.
#[test]
fn margins_of_axes_are_the_least() {
    for clock in ["eps = 0.05", "clock = \"samples\"\nu_max = inf"] {
        let text = |axes: &str| {
            format!(
                "n = 2\nmu = \"exp(a=1)\"\n{clock}\nsample_time = 5e-3\n{axes}\nx0_max = [1, 1]\nerror = [1e-3, 0.1]\n\
                 noise = 1e-5\n[params]\ntau = 1\nm = 4\n"
            )
        };
        let of = |axes: &str| {
            let (spec, _) = read_design(&entries(&text(axes))).expect("a design");
            margins(&spec, None).expect("a sound loop")
        };
        let [slow, fast] =
            ["poles = [-4, -5]\ng = \"1/m\"", "poles = [-7, -9]\ng = \"2/m\""].map(of);
        let all = of("axes = 2\npoles = [[-4, -5], [-7, -9]]\ng = [\"1/m\", \"2/m\"]");
        assert_ne!(slow, fast);
        assert_eq!(all.gain, [slow.gain[0].max(fast.gain[0]), slow.gain[1].min(fast.gain[1])]);
        assert_eq!(all.delay, slow.delay.min(fast.delay));
        assert_eq!(all.jitter[0], slow.jitter[0].min(fast.jitter[0]));
    }
}

/// The jitter is sound, and a little more of it is not.
fn jitter_ends(text: &str, [time, periods]: [f64; 2]) {
    assert!(0.0 < periods && periods < 0.49, "{text}{time} {periods}");
    let at = |time: f64| verdict(&format!("jitter = {time:?}\n{text}")).0;
    assert_eq!([at(time), at(0.9 * time)], [Verdict::Sound; 2], "{text}{time}");
    assert_ne!(at(1.03 * time), Verdict::Sound, "{text}{time}");
}
