//! The margins of the loop that stays, against loops of low order by hand, and the eps that keeps one.

use crate::support::entries;

use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::check::sampled::{Stability, stability};
use ptc_codegen::plant::read_design;

fn report(text: &str) -> Report {
    let (spec, _) = read_design(&entries(text)).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
    examine(&spec)
}

fn found(text: &str) -> Result<Stability, String> {
    stability(&report(text).spec, None)
}

fn chain(poles: &str, eps: f64) -> String {
    format!(
        "n = {}\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\npoles = [{poles}]\n[params]\ntau = 1\n\
         eps = {eps}\nu_max = inf\n",
        poles.split(',').count()
    )
}

/// With deadbeat E - 1 is -g for n = 1 and a root of D^2 + 2 g D + g for n = 2, stable for g < 2 and g < 4/3.
#[test]
fn deadbeat_has_the_margins_of_its_polynomial() {
    for (poles, most) in [("-3", 2.0), ("-4, -5", 4.0 / 3.0)] {
        let margins = found(&chain(poles, 0.0)).expect("a stable loop");
        assert!((margins.gain[1] / most - 1.0).abs() < 1e-3, "{margins:?}");
        assert_eq!((margins.gain[0], margins.delay), (1.0 / 64.0, 0), "{margins:?}");
    }
}

/// z^(d+1) - z^d + k is stable for k < 2 sin(pi/(2 (2 d + 1))), k = p/M.
#[test]
fn an_integrator_has_the_delay_margin_of_its_polynomial() {
    for (pole, left) in [(3, 10), (3, 4), (2, 30), (5, 6)] {
        let k = f64::from(pole) / f64::from(left);
        let least = |d: f64| 2.0 * (std::f64::consts::PI / (2.0 * (2.0 * d + 1.0))).sin();
        let wanted = (1..=16).take_while(|d| k < least(f64::from(*d))).count();
        let margins = found(&chain(&format!("-{pole}"), 0.01 * f64::from(left))).expect("stable");
        assert_eq!(margins.delay, wanted, "{pole} {left} {margins:?}");
        assert!((margins.gain[1] * k / 2.0 - 1.0).abs() < 1e-3, "{margins:?}");
    }
}

/// A belt with an encoder, whose least error has an eps that tolerates little.
#[test]
fn the_eps_that_is_chosen_keeps_the_margin_that_is_asked_for() {
    let text = |more: &str| {
        format!(
            "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-4, -4.5, -5]\nsample_time = 2e-3\ndelay = 1\n\
             sensor_step = 7.7e-6\nmeasured = \"x1\"\ndisturbance = \"constant\"\nobserver_poles = [-5, -6, -7]\nobserver_samples = 60\n\
             x0_max = [0.3, 1e-6]\nerror = [2e-5, 1e-2]\n{more}\n[params]\nu_max = inf\ntau = 0.5\n"
        )
    };
    let free = report(&text("margin_gain = 1\nmargin_delay = 0"));
    let kept = report(&text(""));
    let more = report(&text("margin_gain = 1.5\nmargin_delay = 3"));
    let of = |report: &Report| stability(&report.spec, None);
    let (free_margins, margins, delayed) =
        (of(&free), of(&kept).expect("stable"), of(&more).expect("stable"));
    assert!(
        free_margins.as_ref().is_ok_and(|free| free.gain[1] < 2.0 || free.delay < 1),
        "{free_margins:?}"
    );
    assert!(margins.gain[0] <= 0.5 && margins.gain[1] >= 2.0 && margins.delay >= 1, "{margins:?}");
    assert!(delayed.gain[1] >= 1.5 && delayed.delay >= 3, "{delayed:?}");
    let last = |report: &Report| {
        let worst = report.worst.as_ref().expect("a worst case");
        let shares =
            worst.states.iter().zip([2e-5, 1e-2]).map(|(bound, error)| bound.total() / error);
        shares.fold(0.0, f64::max)
    };
    assert!(last(&free) <= last(&kept), "{} {}", last(&free), last(&kept));
    let reason = &kept.choices.first().expect("a choice").reason;
    for part in
        ["keep the margin, input gains from 0.5 to 2", "without the margin", "ends within |x| ="]
    {
        assert!(reason.contains(part), "{reason}");
    }
    // Which no eps keeps.
    let far = report(&text("margin_gain = 60\nmargin_delay = 16"));
    assert!(far.choices.first().expect("a choice").reason.contains("which no eps keeps"));
}
