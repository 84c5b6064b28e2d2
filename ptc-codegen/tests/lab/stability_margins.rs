//! The margins of the loop that stays, against loops of low order by hand, and the eps that keeps one.

use crate::support::entries;

use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::check::sampled::{NoMargins, Stability, stability};
use ptc_codegen::plant::read_design;

fn report(text: &str) -> Report {
    let (spec, _) = read_design(&entries(text)).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
    examine(&spec)
}

fn found(text: &str) -> Result<Stability, NoMargins> {
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
fn deadbeat_margins_match_its_polynomial() {
    for (poles, most) in [("-3", 2.0), ("-4, -5", 4.0 / 3.0)] {
        let margins = found(&chain(poles, 0.0)).expect("a stable loop");
        assert!((margins.gain[1] / most - 1.0).abs() < 1e-3, "{margins:?}");
        assert_eq!((margins.gain[0], margins.delay), (1.0 / 64.0, 0), "{margins:?}");
    }
}

/// z^(d+1) - z^d + k is stable for k < 2 sin(pi/(2 (2 d + 1))), k = p/(M + p - 1).
#[test]
fn integrator_delay_margin_matches_its_polynomial() {
    for (pole, left) in [(3, 10), (3, 4), (2, 30), (5, 6)] {
        let k = f64::from(pole) / f64::from(left + pole - 1);
        let least = |d: f64| 2.0 * (std::f64::consts::PI / (2.0 * (2.0 * d + 1.0))).sin();
        let wanted = (1..=16).take_while(|d| k < least(f64::from(*d))).count();
        let margins = found(&chain(&format!("-{pole}"), 0.01 * f64::from(left))).expect("stable");
        assert_eq!(margins.delay, wanted, "{pole} {left} {margins:?}");
        assert!((margins.gain[1] * k / 2.0 - 1.0).abs() < 1e-3, "{margins:?}");
    }
}

/// A belt with an encoder, whose smallest error has an eps that tolerates little.
fn belt(error: &str, more: &str) -> Report {
    report(&format!(
        "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-4, -4.5, -5]\nsample_time = 2e-3\ndelay = 1\n\
         sensor_step = 7.7e-6\nmeasured = \"x1\"\ndisturbance = \"constant\"\nobserver_poles = [-5, -6, -7]\nobserver_samples = 60\n\
         x0_max = [0.3, 1e-6]\nerror = {error}\n{more}\n[params]\nu_max = inf\ntau = 0.5\n"
    ))
}

const FREE: &str = "margin_gain = 1\nmargin_delay = 0";

fn reason(report: &Report) -> &str {
    &report.choices.first().expect("a choice").reason
}

/// Returns the largest |x_i| at the deadline in the worst case.
fn finals(report: &Report) -> Vec<f64> {
    report.worst.as_ref().expect("a worst case").states.iter().map(|bound| bound.total()).collect()
}

#[test]
fn chosen_eps_keeps_the_requested_margin() {
    let [free, kept, more] =
        [FREE, "", "margin_gain = 1.5\nmargin_delay = 3"].map(|more| belt("[2e-3, 1]", more));
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
        finals(report).iter().zip([2e-3, 1.0]).map(|(x, error)| x / error).fold(0.0, f64::max)
    };
    assert!(last(&free) <= last(&kept), "{} {}", last(&free), last(&kept));
    for part in
        ["keep the margin, input gains from 0.5 to 2", "is smallest with eps = ", "|x| of about"]
    {
        assert!(reason(&kept).contains(part), "{}", reason(&kept));
    }
}

/// A design that is accepted with the smallest error stays accepted with any wanted margin.
#[test]
fn error_bounds_take_precedence_over_the_margin() {
    let verdict = |report: &Report| {
        report.outcomes.iter().find(|outcome| outcome.name == "loop").expect("a loop").verdict
    };
    let least = finals(&belt("[2e-3, 1]", FREE));
    let mut widest = 0;
    for part in [0.9, 1.02, 1.3] {
        // Between the error without a margin and those with one.
        let error = format!("[{:e}, 1]", part * least[0]);
        let without = belt(&error, FREE);
        let free = verdict(&without);
        for more in ["margin_delay = 3", "margin_gain = 60\nmargin_delay = 16"] {
            let kept = belt(&error, more);
            if free == Verdict::Sound {
                assert_eq!(verdict(&kept), free, "{error} {more}: {}", reason(&kept));
            }
            if reason(&kept).contains("largest margin within `error`") {
                widest += 1;
                let [of_free, of_kept] =
                    [&without, &kept].map(|report| stability(&report.spec, None).expect("stable"));
                assert!(
                    of_kept.gain[1] >= of_free.gain[1] && of_kept.delay >= of_free.delay,
                    "{of_free:?} {of_kept:?}"
                );
            }
        }
        assert_eq!(free == Verdict::Sound, part > 1.0, "{error}");
    }
    assert!(widest > 0);
}

/// Every design whose eps is chosen keeps the margin, or its reason says why not.
#[test]
fn every_chosen_eps_keeps_the_margin_or_gives_a_reason() {
    let bounds = [
        "",
        "x0_max = [1]\n",
        "x0_max = [1]\nerror = 1e-3\n",
        "x0_max = [1]\nerror = 1e-12\n",
        NOISY,
    ];
    let periods = ["", "sample_time = 5e-3\n", "sample_time = 0.05\n"];
    let (mut kept, mut given_up) = (0, 0);
    for n in 1..=3 {
        let poles = ["-4", "-4, -5", "-4, -5, -6"][n - 1];
        for (clock, period) in periods
            .iter()
            .map(|period| ("time", *period))
            .chain(periods[1..].iter().map(|period| ("samples", *period)))
        {
            for bound in bounds {
                let bound = bound.replace("[1]", &format!("{:?}", vec![1; n]));
                let text = format!(
                    "n = {n}\nmu = \"exp(a=1)\"\nclock = \"{clock}\"\npoles = [{poles}]\n{period}{bound}\
                     [params]\ntau = 1\nu_max = inf\n"
                );
                let report = report(&text);
                let Some(choice) = report.choices.first() else { continue };
                let margins = stability(&report.spec, None);
                let is_kept =
                    margins.is_ok_and(|m| m.gain[0] <= 0.5 && m.gain[1] >= 2.0 && m.delay >= 1);
                let keeps = ["it keeps the margin", "those that keep the margin"];
                let says = keeps.iter().any(|part| choice.reason.contains(part))
                    || choice.reason.contains("the smallest found that keeps the margin");
                assert_eq!(is_kept, says, "{}\n{text}", choice.reason);
                let gives_up =
                    ["is not kept", "would cost a bound", "no eps keeps", "no margin is known"];
                let why = gives_up.iter().any(|part| choice.reason.contains(part));
                assert!(is_kept || why, "{}\n{text}", choice.reason);
                kept += usize::from(is_kept);
                given_up += usize::from(!is_kept);
            }
        }
    }
    assert!(kept > 20 && given_up > 10, "{kept} {given_up}");
}

const NOISY: &str = "x0_max = [1]\nnoise = 1e-4\n";

/// An estimate is corrected by gains that are held if its poles are left of -(m - 1), and the report says so where not.
#[test]
fn too_slow_observer_poles_are_reported() {
    for (poles, is_slow) in [
        ("-2, -3, -4", true),
        ("-5, -2.5, -6", false),
        ("-5, -6, -1.9", true),
        ("-2.1, -3, -4", false),
    ] {
        let own = report(&format!(
            "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\npoles = [-4, -5]\nmeasured = \"x1\"\n\
             disturbance = \"constant\"\nobserver_poles = [{poles}]\nobserver_samples = 50\nobserver_eps = 0.2\n\
             [params]\ntau = 1\neps = 0.1\nu_max = inf\n"
        ));
        let growth = own.outcomes.iter().find(|outcome| outcome.name == "growth").expect("a check");
        let told = growth.details.iter().any(|line| line.contains("not left of -2"));
        assert_eq!(told, is_slow, "{poles}: {:?}", growth.details);
        assert_eq!(stability(&own.spec, None).is_err(), is_slow, "{poles}");
    }
}
