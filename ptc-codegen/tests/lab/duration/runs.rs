//! Runs in which a duration changes: events of `simulate`, and of a campaign.

use std::path::Path;

use ptc_codegen::plant::Plant;
use ptc_codegen::simulate::{Change, Controller, Event, Loop, Process, Values};
use ptc_codegen::verify::{self, Trial};

use crate::support;

const STAGE: &str = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 1e-3\n\
    in_flight = true\n[params]\neps = 0.005\nu_max = inf\n";

fn simulate(folder: &Path, events: &str, more: &[&str]) -> (Option<i32>, String, String) {
    std::fs::write(folder.join("stage.toml"), format!("{STAGE}{events}")).expect("a file");
    let mut command = support::command_in(folder, &["simulate", "stage.toml", "--x0=0.1,0"]);
    support::told(command.args(["--sample-time=1e-3"]).args(more))
}

/// t, x1 and x2 of each sample.
fn rows(csv: &str) -> Vec<[f64; 3]> {
    let head: Vec<_> = csv.lines().next().expect("a head").split(',').collect();
    let place = |name: &str| head.iter().position(|own| *own == name).expect(name);
    let places = ["t", "x1", "x2"].map(place);
    let row = |line: &str| {
        let cells: Vec<_> = line.split(',').collect();
        places.map(|place| cells[place].parse().expect("a number"))
    };
    csv.lines().skip(1).map(row).collect()
}

#[test]
fn deadlines_of_events_are_kept() {
    let folder = support::folder("events");
    let events = "[[event]]\nat = 0.3\nmove = 0.05\ntau = 0.4\n[[event]]\nat = 0.5\ntau = 1.1\n\
        [[event]]\nat = 1.8\nmove = -0.1\narm = true\n";
    let (code, csv, told) = simulate(&folder, events, &["--tau=0.9"]);
    assert_eq!(code, Some(0), "{told}");
    let rows = rows(&csv);
    let at = |t: f64| rows.iter().find(|row| (row[0] - t).abs() < 1e-9).expect("a sample");
    // The deadline of 0.7 has been put off.
    assert!(at(0.7)[1].abs() > 1e-3, "{:?}", at(0.7));
    // At rest at 1.6, and, started again with tau of the design, at 2.7.
    for t in [1.6, 2.7] {
        assert!(at(t)[1].abs() < 1e-6 && at(t)[2].abs() < 1e-3, "{:?}", at(t));
    }
    assert!((rows.last().expect("a sample")[0] - 2.7).abs() < 1e-9);
}

#[test]
fn duration_below_eps_is_refused() {
    let folder = support::folder("refused");
    let (code, _, told) = simulate(&folder, "[[event]]\nat = 0.3\ntau = 0.004\n", &["--tau=0.9"]);
    assert_ne!(code, Some(0));
    assert!(told.contains("arm_for refuses a deadline in 0.004 s, PTC_E_PARAM"), "{told}");
}

#[test]
fn event_of_a_duration_needs_the_key() {
    let folder = support::folder("without");
    let text = STAGE.replace("in_flight = true\n", "") + "[[event]]\nat = 0.3\ntau = 0.4\n";
    std::fs::write(folder.join("stage.toml"), text).expect("a file");
    let mut command = support::command_in(
        &folder,
        &["simulate", "stage.toml", "--x0=0.1,0", "--tau=0.9", "--sample-time=1e-3"],
    );
    let (code, _, told) = support::told(&mut command);
    assert_ne!(code, Some(0));
    assert!(told.contains("a deadline changes with in_flight = true"), "{told}");
}

/// The samples from an event on are those of a run that begins there with that duration.
#[test]
fn run_goes_on_as_one_that_starts_there() {
    let text = format!("{STAGE}tau = 0.9\n");
    let entries = support::entries(&text);
    let spec = ptc_codegen::request::read_run(&entries).expect("a run");
    let plant = Plant::own(&spec);
    let run = |values: &Values, x0: &[f64], events: Vec<Event>, until: f64| {
        let around = Loop { period: 1e-3, until: Some(until), events, ..Loop::default() };
        let mut control = Controller::new(&spec).expect("a controller");
        let mut all = Vec::new();
        Process::new(&spec, &plant)
            .run(&mut control, values, &mut |_| None, x0, &around, &mut |sample| {
                all.push((sample.t, sample.x.to_vec(), sample.u.to_vec(), sample.status));
            })
            .expect("a run");
        all
    };
    let values = Values::of(&spec, &plant);
    let event = Event { at: 0.25, change: Change::Duration(0.4) };
    let whole = run(&values, &[0.1, 0.0], vec![event], 0.65);
    let (t, x, ..) = whole[250].clone();
    let again = values
        .with(ptc_codegen::parameter::Parameter::StartTime, t)
        .with(ptc_codegen::parameter::Parameter::Tau, 0.4);
    let second = run(&again, &x, Vec::new(), 0.4);
    assert_eq!(whole.len(), 651);
    for (one, other) in whole[250..].iter().zip(&second) {
        // The times of the samples differ by roundings of their sums.
        assert!((one.0 - other.0).abs() < 1e-12);
        assert!(
            (one.2[0] - other.2[0]).abs() <= 1e-6 * (1.0 + other.2[0].abs()),
            "{one:?} {other:?}"
        );
        assert_eq!(one.3, other.3);
    }
}

#[test]
fn campaigns_draw_durations() {
    let text = format!(
        "{STAGE}[[event]]\nat = [0.2, 0.3]\ntau = [0.3, 0.6]\n[verify]\ntau = [0.8, 1]\nx1 = [-0.1, 0.1]\n\
         x2 = 0\nscenarios = 40\nsearch = 0\n[[objective]]\nbound = \"attractive\"\nerror = [1e-3, 1e-1]\n"
    );
    let (spec, plant) = support::design(&text);
    let campaign = verify::read(&support::entries(&text), &spec, &plant);
    let campaign = campaign.unwrap_or_else(|wrong| panic!("{wrong:?}"));
    assert!(campaign.columns().contains(&"event1_tau".to_owned()), "{:?}", campaign.columns());
    let mut trial = Trial::new(&campaign).expect("a loop");
    for index in 0..20 {
        let setting = campaign.setting(&campaign.scenario(index));
        let mut last = None;
        trial.instants(&setting, &mut |instant| last = Some(instant)).expect("a whole run");
        let last = last.expect("an instant");
        assert!(last.x[0].abs() < 1e-4, "{index}: {:?}", last.x);
    }
}
