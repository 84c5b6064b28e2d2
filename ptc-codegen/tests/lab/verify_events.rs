//! Events in campaigns: the same run as `simulate`, draws, deadlines in force, and mistakes.

use std::fs;
use std::path::Path;

use ptc_codegen::verify::{self, Campaign, Instant, Status, Trial};

use crate::support;

const STAGE: &str = "name = \"stage\"\nn = 2\ng = \"1/1.5\"\nmu = \"exp(a=1)\"\nclock = \"samples\"\n\
    sample_time = 1e-3\ndelay = 1\npoles = \"least-energy\"\nmeasured = [\"x1\"]\n\
    disturbance = \"constant\"\nobserver_poles = [-4, -5, -6]\nobserver_samples = 100\n\
    sensor_step = [1e-6, 0]\n";

const PARAMS: &str = "[params]\ntau = 0.8\neps = 0.02\nu_max = 6\n";

const CAMPAIGN: &str = "[verify]\nx1 = [-0.1, 0.1]\nx2 = 0\nscenarios = 70\nsearch = 20\nseed = 3\n\
    [[objective]]\nbound = \"attractive\"\nerror = [1e-4, 2e-2]\n";

const EVENTS: &str = "[[event]]\nat = [0.9, 1.0]\nmove = [-0.05, 0.05]\ntau = [0.4, 0.5]\n\
    [[event]]\nat = 1.6\nkick = [-1, 1]\nfor = [0.01, 0.05]\nmove = 0.02\ntau = 0.4\n";

fn design(key: &str, events: &str) -> String {
    format!("{STAGE}{key}\n{PARAMS}{events}{CAMPAIGN}")
}

fn campaign(text: &str) -> Campaign {
    let (spec, plant) = support::design(text);
    let read = verify::read(&support::entries(text), &spec, &plant);
    read.unwrap_or_else(|wrong| panic!("{wrong:?}"))
}

fn instants(campaign: &Campaign, index: u64) -> Vec<Instant> {
    let mut trial = Trial::new(campaign).expect("a loop");
    let mut all = Vec::new();
    let setting = campaign.setting(&campaign.scenario(index));
    trial.instants(&setting, &mut |instant| all.push(instant)).expect("a whole run");
    all
}

fn verify(folder: &Path, more: &[&str]) -> (Option<i32>, String, String) {
    let mut command = support::command_in(folder, &["verify", "stage.toml"]);
    support::told(command.args(more))
}

#[test]
fn draws_run_as_simulate_runs_them() {
    let folder = support::folder("same");
    let campaign = campaign(&design("late = \"extend\"", EVENTS));
    let names: Vec<_> = campaign.columns();
    let own = ["event1_at", "event1_move", "event1_tau", "event2_kick", "event2_for"];
    assert_eq!(names[3..8], own, "{names:?}");
    let mut trial = Trial::new(&campaign).expect("a loop");
    for index in 0..6 {
        let scenario = campaign.scenario(index);
        let [_, x1, _, at, by, tau, kick, length] = scenario.point[..] else {
            panic!("{scenario:?}")
        };
        let events = format!(
            "[[event]]\nat = {at:?}\nmove = {by:?}\ntau = {tau:?}\n[[event]]\nat = 1.6\n\
             kick = {kick:?}\nfor = {length:?}\nmove = 0.02\ntau = 0.4\n"
        );
        let text = format!("{STAGE}late = \"extend\"\n{PARAMS}{events}");
        fs::write(folder.join("one.toml"), text).expect("a file");
        let start = format!("--x0={x1:?},0");
        let (code, csv, told) = support::run_in(&folder, &["simulate", "one.toml", &start]);
        assert_eq!(code, Some(0), "{told}");
        let all = instants(&campaign, index);
        let rows: Vec<_> = csv.lines().skip(1).collect();
        assert_eq!(all.len(), rows.len());
        for (instant, row) in all.iter().zip(rows) {
            let cells: Vec<f64> = row
                .split(',')
                .skip(1)
                .take(4)
                .map(|cell| cell.parse().expect("a number"))
                .collect();
            let own = [&[instant.t][..], &instant.x, &instant.u].concat();
            assert_eq!(own, cells, "{index}");
        }
        // The deadlines in force, by the calendar of the events.
        let samples = |time: f64| (time / 1e-3 - 1e-9).ceil() * 1e-3;
        let first = (samples(at), samples(at) + (tau / 1e-3).round() * 1e-3);
        let due = |t: f64| {
            let within = |from: f64, to: f64| t > from - 1e-6 && t < to - 1e-6;
            within(0.8, first.0) || within(first.1, 1.6) || within(2.0, 9.0)
        };
        let mut worst = f64::NEG_INFINITY;
        for instant in &all {
            assert_eq!(instant.at_end, due(instant.t), "{index}: {}", instant.t);
            if due(instant.t) {
                let size = (instant.x[0].abs() / 1e-4).max(instant.x[1].abs() / 2e-2);
                worst = worst.max(size - 1.0);
            }
        }
        let row = campaign.row(&mut trial, index);
        assert_eq!(row.numbers[..8], scenario.point[..]);
        assert!((row.numbers[8] - worst).abs() < 1e-12, "{index}: {row:?} {worst}");
    }
}

#[test]
fn shards_and_single_runs_are_the_same_bytes() {
    let text = design("late = \"extend\"", EVENTS);
    let folder = support::folder_with("shards", "stage.toml", text);
    let (code, whole, told) = verify(&folder, &["--out", "whole.parquet"]);
    assert_eq!(code, Some(0), "{whole}{told}");
    assert!(whole.contains("event1_at, event1_move, event1_tau"), "{whole}");
    assert!(whole.contains("from t0 to the last deadline"), "{whole}");
    assert!(whole.contains("not proved: events change the run"), "{whole}");
    for part in ["1", "2", "3"] {
        let (shard, out) = (format!("{part}/3"), format!("{part}.parquet"));
        assert_eq!(verify(&folder, &["--shard", &shard, "--out", &out]).0, Some(0));
    }
    let parts = ["--merge", "3.parquet", "1.parquet", "2.parquet", "--out", "merged.parquet"];
    assert_eq!(verify(&folder, &parts).1, whole);
    let bytes = |name: &str| fs::read(folder.join(name)).expect("a file");
    assert!(bytes("whole.parquet") == bytes("merged.parquet"));
}

#[test]
fn moves_that_are_too_long_fail_without_a_plan() {
    let events = "[[event]]\nat = 1\nmove = [-0.3, 0.3]\ntau = 0.2\n";
    let folder = support::folder_with("fails", "stage.toml", design("in_flight = true", events));
    let (code, text, told) = verify(&folder, &[]);
    assert_eq!(code, Some(1), "{text}{told}");
    assert!(text.contains("at the end: fails\n"), "{text}");
    // The longest move and a short one, far from the bound on either side.
    let campaign = campaign(&design("in_flight = true", events));
    let mut trial = Trial::new(&campaign).expect("a loop");
    for (by, fails) in [("0.3", true), ("-0.25", true), ("0.02", false), ("-0.03", false)] {
        let text = format!("x1 = 0.1, event1_move = {by}");
        let scenario = campaign.replayed(&text).expect("a scenario");
        let outcome = trial.run(&campaign.setting(&scenario));
        assert_eq!(outcome.worst(0) > 0.0, fails, "{by}: {outcome:?}");
    }
    // Put off, all of them come to rest.
    fs::write(folder.join("stage.toml"), design("late = \"extend\"", events)).expect("a file");
    let (code, text, told) = verify(&folder, &[]);
    assert_eq!(code, Some(0), "{text}{told}");
}

#[test]
fn deadlines_that_are_put_off_are_judged_when_they_come() {
    let text = design("late = \"extend\"", "").replace("tau = 0.8", "tau = 0.15");
    let campaign = campaign(&text.replace("observer_samples = 100", "observer_samples = 50"));
    let mut put_off = 0;
    for index in 0..5 {
        let all = instants(&campaign, index);
        let last = all.last().expect("an instant");
        put_off += usize::from(last.t > 0.16);
        assert!(last.at_end && last.time_to_go <= 0.0, "{last:?}");
        assert!(last.excess[0].is_finite() && last.excess[0] < 0.0, "{last:?}");
        assert!(all.iter().filter(|one| one.time_to_go > 0.0).all(|one| !one.at_end));
    }
    assert!(put_off > 2, "{put_off}");
}

#[test]
fn refused_deadlines_leave_an_objective_undecided() {
    let events = "[[event]]\nat = 1\nmove = [-0.3, 0.3]\ntau = 0.2\n";
    let text = design("late = \"refuse\"", events);
    let folder = support::folder_with("refused", "stage.toml", &text);
    let (code, told, wrong) = verify(&folder, &[]);
    assert_eq!(code, Some(3), "{told}{wrong}");
    assert!(told.contains("arm_for refuses a deadline in 200 samples, PTC_E_SOON"), "{told}");
    let campaign = campaign(&text);
    let scenario = campaign.replayed("x1 = 0, event1_move = 0.3").expect("a scenario");
    let outcome = Trial::new(&campaign).expect("a loop").run(&campaign.setting(&scenario));
    assert_eq!(outcome.status(), Status::Unfinished);
}

#[test]
fn loops_in_time_are_armed_moved_and_kicked() {
    let text = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 1e-3\neps = 0.05\n\
        [verify]\nx1 = [-1, 1]\nx2 = 0\ntau = [0.5, 1]\nscenarios = 20\nsearch = 10\n[[event]]\n\
        at = [0.2, 0.4]\nmove = [-1, 1]\narm = true\n[[event]]\nat = 0.3\nkick = [0, 1]\nfor = 0.1\n\
        [[objective]]\nbound = \"attractive\"\nerror = [1e-2, 1e-1]\n[[objective]]\n\
        bound = \"within\"\nh = \"x1\"\nlow = -3\nhigh = 3\n";
    let campaign = campaign(text);
    for index in 0..5 {
        let scenario = campaign.scenario(index);
        let (tau, at) = (scenario.point[0], scenario.point[3]);
        let all = instants(&campaign, index);
        let end = (at / 1e-3 - 1e-9).ceil() * 1e-3 + tau;
        let last = all.last().expect("an instant");
        assert!((last.t - end).abs() < 1e-9 && last.at_end, "{index}: {last:?} {end}");
        assert!(last.excess[0] < 0.0, "{last:?}");
    }
}

#[test]
fn wrong_events_of_a_campaign_are_refused() {
    let folder = support::folder("wrong");
    let event = |text: &str| design("late = \"extend\"", &format!("[[event]]\n{text}\n"));
    let move_ = "at = 1\nmove = 0.1";
    let timed =
        |more: &str| event(move_).replace("bound = \"attractive\"\nerror = [1e-4, 2e-2]", more);
    let in_time = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\ntau = 1\n[[event]]\nat = 0.1\n\
        move = 1\n[plant]\nf = 0\n[verify]\nx1 = 1\nx2 = 0\n[[objective]]\nbound = \"attractive\"\n\
        error = 1\n";
    for (text, message) in [
        (event("at = 1\nmove = [0.1, -0.1]"), "the interval of move is empty: 0.1 > -0.1"),
        (event("at = 1\nmove = [1, 2, 3]"), "move = [1, 2, 3] is not an interval"),
        (event("at = [-1, 1]\nmove = 1"), "at = [-1, 1] is not a time >= 0"),
        (event("at = 1\ntau = [0, 1]"), "tau = [0, 1] is not a time > 0"),
        (event("at = 1\ntau = [1e-6, 1]"), "`tau` of an event does not suit this controller"),
        (event("at = 1\nkick = [1, 2]"), "`kick` and `for` belong together"),
        (event("at = 2000\nmove = 1"), "more than 1000000"),
        (timed("bound = \"state\"\nsigma = 3"), "objective 1 bounds |x| by |x0|"),
        (timed("bound = \"input\"\nupsilon = \"1 + t\""), "objective 1 depends on `t`"),
        (
            timed("bound = \"within\"\nh = \"integral(dt)\"\nhigh = 3"),
            "objective 1 depends on `dt`",
        ),
        (in_time.to_owned(), "the events of the design need the sampled loop"),
    ] {
        fs::write(folder.join("stage.toml"), &text).expect("a file");
        let (code, out, told) = verify(&folder, &[]);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{text}{told}");
        assert!(told.contains(message) && told.matches("error").count() == 1, "{message}: {told}");
    }
    // `simulate` runs numbers alone.
    fs::write(folder.join("stage.toml"), event("at = 1\nmove = [-0.1, 0.1]")).expect("a file");
    let (code, _, told) = support::run_in(&folder, &["simulate", "stage.toml", "--x0=0.1,0"]);
    assert_eq!(code, Some(2), "{told}");
    assert!(
        told.contains("move = [-0.1, 0.1] is an interval, and a run takes one number"),
        "{told}"
    );
}
