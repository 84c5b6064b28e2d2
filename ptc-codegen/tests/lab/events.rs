//! Events of a simulated run: targets that move, deadlines that change, kicks.

use std::path::Path;

use crate::support;

/// A stage whose position alone is measured, with a force that is not known.
const STAGE: &str = "name = \"stage\"\nn = 2\ng = \"1/1.5\"\nmu = \"exp(a=1)\"\nclock = \"samples\"\n\
    sample_time = 1e-3\ndelay = 1\npoles = \"least-energy\"\nmeasured = [\"x1\"]\n\
    disturbance = \"constant\"\nobserver_poles = [-4, -5, -6]\nobserver_samples = 100\n";

fn simulate(folder: &Path, design: &str, more: &[&str]) -> (Option<i32>, String, String) {
    std::fs::write(folder.join("stage.toml"), design).expect("a file");
    let mut command = support::command(&["simulate", "stage.toml"]);
    command.args(["--x0=0.1,0"].iter().filter(|_| !more.iter().any(|own| own.starts_with("--x0"))));
    command.args(more).current_dir(folder);
    support::told(&mut command)
}

/// t, x1, x2 and the status of each sample.
fn rows(csv: &str) -> Vec<(f64, f64, f64, String)> {
    let row = |line: &str| {
        let cells: Vec<_> = line.split(',').collect();
        let number = |i: usize| cells[i].parse().expect("a number");
        (number(1), number(2), number(3), cells[cells.len() - 1].to_owned())
    };
    csv.lines().skip(1).map(row).collect()
}

#[test]
fn moves_follow_one_another() {
    let folder = support::folder("events_moves");
    let design = format!(
        "{STAGE}late = \"extend\"\n[params]\ntau = 0.8\neps = 0\nu_max = 6\n\
         [[event]]\nat = 0.9\nmove = 0.05\ntau = 0.4\n[[event]]\nat = 1.4\nmove = -0.2\ntau = 0.1\n"
    );
    let (code, csv, told) = simulate(&folder, &design, &[]);
    assert_eq!(code, Some(0), "{told}");
    let rows = rows(&csv);
    let at = |t: f64| rows.iter().find(|row| (row.0 - t).abs() < 1e-6).expect("a sample");
    for t in [0.8, 1.3] {
        assert!(at(t).1.abs() < 1e-9 && at(t).2.abs() < 1e-7, "{:?}", at(t));
    }
    assert!((at(0.9).1 + 0.05).abs() < 1e-9, "the target is 0.05 farther: {:?}", at(0.9));
    // 0.1 s is too soon for 0.2 m: the deadline is put off, and the run goes on to it.
    let last = rows.last().expect("a sample");
    assert!(last.0 > 1.6 && last.0 < 2.2, "{last:?}");
    assert!(last.1.abs() < 1e-9 && last.2.abs() < 1e-7, "{last:?}");
    assert!(rows.iter().any(|row| row.3 == "PTC_LATE"), "{csv}");
    assert!(rows.iter().all(|row| row.3 != "PTC_SATURATED"), "{csv}");
}

#[test]
fn arms_start_the_deadline_again() {
    let folder = support::folder("events_arm");
    let design = format!(
        "{STAGE}[params]\ntau = 0.8\neps = 0\nu_max = 6\n[[event]]\nat = 0.4\narm = true\n"
    );
    let (code, csv, told) = simulate(&folder, &design, &[]);
    assert_eq!(code, Some(0), "{told}");
    let (again, by_flag, told) = simulate(
        &folder,
        &format!("{STAGE}[params]\ntau = 0.8\neps = 0\nu_max = 6\n"),
        &["--arm-at", "0.4"],
    );
    assert_eq!(again, Some(0), "{told}");
    assert_eq!(csv, by_flag);
    let rows = rows(&csv);
    let last = rows.last().expect("a sample");
    assert!((last.0 - 1.2).abs() < 1e-9 && last.1.abs() < 1e-9, "{last:?}");
}

#[test]
fn kicks_are_forces_for_a_time() {
    let folder = support::folder("events_kick");
    let design = "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\npoles = [-4, -5]\n\
        [params]\ntau = 1\neps = 0\nu_max = inf\n[[event]]\nat = 0\nkick = 3\nfor = 0.02\n";
    let (code, csv, told) = simulate(&folder, design, &["--until", "0.03"]);
    assert_eq!(code, Some(0), "{told}");
    let rows = rows(&csv);
    let u = |row: usize| -> f64 {
        csv.lines()
            .nth(row + 1)
            .and_then(|line| line.split(',').nth(4))
            .expect("u")
            .parse()
            .expect("a number")
    };
    for k in 0..3 {
        let force = if k < 2 { 3.0 } else { 0.0 };
        let wanted = rows[k].2 + 0.01 * (u(k) + force);
        assert!((rows[k + 1].2 - wanted).abs() < 1e-12, "{k}: {rows:?}");
    }
}

/// Two axes: the target of the second moves, and both are at rest at the deadline that is put off for them.
const AXES: &str = "n = 2\naxes = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\n\
    poles = [[-4, -5], [-2, -3]]\nlimits = [5, 2]\nlate = \"extend\"\n[params]\ntau = 0.4\neps = 0\n";

#[test]
fn targets_of_axes_move_one_by_one() {
    let folder = support::folder("events_axes");
    let design = format!(
        "{AXES}[[event]]\nat = 1\nmove = [0, 0.5]\ntau = 0.2\n[[event]]\nat = 0.1\nkick = [0, 3]\nfor = 0.02\n"
    );
    let more = ["--x0=0.1,0,0.2,0"];
    std::fs::write(folder.join("stage.toml"), &design).expect("a file");
    let mut command = support::command(&["simulate", "stage.toml"]);
    command.args(more).current_dir(&folder);
    let (code, csv, told) = support::told(&mut command);
    assert_eq!(code, Some(0), "{told}");
    let row = |line: &str| -> (Vec<f64>, String) {
        let cells: Vec<_> = line.split(',').collect();
        let numbers = cells[1..8].iter().map(|cell| cell.parse().expect("a number"));
        (numbers.collect(), cells[cells.len() - 1].to_owned())
    };
    let rows: Vec<_> = csv.lines().skip(1).map(row).collect();
    let at = |t: f64| rows.iter().find(|row| (row.0[0] - t).abs() < 1e-6).expect("a sample");
    // u2 and the kick move the second axis, u1 alone the first one.
    for (t, force) in [(0.1, 3.0), (0.11, 3.0), (0.12, 0.0)] {
        let [now, next] = [t, t + 0.01].map(|t| &at(t).0);
        assert!((next[2] - now[2] - 0.01 * now[5]).abs() < 1e-12, "{now:?}, {next:?}");
        assert!((next[4] - now[4] - 0.01 * (now[6] + force)).abs() < 1e-12, "{now:?}, {next:?}");
    }
    let moved = &at(1.0).0;
    assert!(moved[1].abs() < 1e-9 && (moved[3] + 0.5).abs() < 1e-9, "{moved:?}");
    assert_eq!(at(1.0).1, "PTC_LATE");
    let (last, status) = rows.last().expect("a sample");
    assert!(last[0] > 1.2 && last[1..5].iter().all(|x| x.abs() < 1e-9), "{last:?}");
    assert_eq!(status, "PTC_HOLD");
    assert!(rows.iter().all(|row| row.1 != "PTC_SATURATED"), "{csv}");
}

/// Two masses with a spring, each driven: sampled exactly, so that any deadline in flight ends at rest.
const MASSES: &str = "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\npoles = [-3, -4]\nin_flight = true\n\
    [params]\ntau = 1\neps = 0\nu_max = inf\n[model]\nstates = [\"p\", \"q\", \"v\", \"w\"]\n\
    inputs = [\"F\", \"G\"]\noutputs = [\"p + q/4\", \"q\"]\n\
    dynamics = { p = \"v\", q = \"w\", v = \"(F - 80*p + 50*q)/2\", w = \"G + 50*(p - q)\" }\n";

#[test]
fn deadlines_of_plants_with_several_inputs_change() {
    let folder = support::folder("events_masses");
    let design = format!("{MASSES}[[event]]\nat = 0.4\ntau = 1.1\n");
    std::fs::write(folder.join("stage.toml"), design).expect("a file");
    let mut command = support::command(&["simulate", "stage.toml", "--x0=0.1,-0.2,0.3,0"]);
    let (code, csv, told) = support::told(command.current_dir(&folder));
    assert_eq!(code, Some(0), "{told}");
    let at = |t: f64| -> Vec<f64> {
        let row =
            |line: &str| line.split(',').skip(1).take(5).map(|x| x.parse().expect("x")).collect();
        let mut rows = csv.lines().skip(1).map(row);
        rows.find(|row: &Vec<f64>| (row[0] - t).abs() < 1e-6).expect("a sample")
    };
    assert!(at(1.0)[1].abs() > 1e-4, "{:?}", at(1.0));
    assert!(at(1.5)[1..].iter().all(|x| x.abs() < 1e-9), "{:?}", at(1.5));
}

#[test]
fn wrong_events_of_axes_are_refused() {
    let folder = support::folder("events_axes_wrong");
    for (event, message) in [
        ("move = 1", "move = 1 for 2 axes"),
        ("move = [1, 2, 3]", "move: 3 numbers for 2 axes"),
        ("move = [1, inf]", "move = inf is not a finite number"),
        ("kick = [1]\nfor = 1", "kick: 1 number for 2 axes"),
    ] {
        let (code, _, told) =
            simulate(&folder, &format!("{AXES}[[event]]\nat = 1\n{event}\n"), &[]);
        assert_eq!(code, Some(2), "{event}: {told}");
        assert!(told.contains(message) && told.matches("error").count() == 1, "{event}: {told}");
    }
}

#[test]
fn wrong_events_are_refused() {
    let folder = support::folder("events_wrong");
    let head = format!("{STAGE}[params]\ntau = 0.8\neps = 0\nu_max = 6\n");
    for (event, message) in [
        ("[[event]]\n", "event 1 is empty"),
        ("[[event]]\nmove = 1\n", "an event without a time"),
        ("[[event]]\nat = 0.1\n", "an event in which nothing happens"),
        ("[[event]]\nat = -1\nmove = 1\n", "at = -1 is not a time >= 0"),
        ("[[event]]\nat = 0.1\ntau = 0.3\n", "`tau` of an event does not suit this controller"),
        ("[[event]]\nat = 0.1\nkick = 3\n", "`kick` and `for` belong together"),
        ("[[event]]\nat = 0.1\nmov = 3\n", "unknown key `mov` of an event"),
        ("[event]\nat = 0.1\n", "`[event]` is one table of a list"),
    ] {
        let (code, _, told) = simulate(&folder, &format!("{head}{event}"), &[]);
        assert_eq!(code, Some(2), "{event}: {told}");
        assert!(told.contains(message) && told.matches("error").count() == 1, "{event}: {told}");
    }
    let refuses = format!(
        "{STAGE}late = \"refuse\"\n[params]\ntau = 0.8\neps = 0\nu_max = 6\n\
         [[event]]\nat = 0.4\nmove = 1\ntau = 0.05\n"
    );
    let (code, _, told) = simulate(&folder, &refuses, &[]);
    assert!(
        code != Some(0) && told.contains("arm_for refuses a deadline in 50 samples, PTC_E_SOON"),
        "{told}"
    );
}

#[test]
fn runs_last_to_the_end_of_a_kick() {
    let folder = support::folder("events_kick_end");
    let design = format!(
        "{STAGE}[params]\ntau = 0.8\neps = 0\nu_max = 6\n[[event]]\nat = 1\nkick = 3\nfor = 0.1\n"
    );
    let (code, csv, told) = simulate(&folder, &design, &[]);
    assert_eq!(code, Some(0), "{told}");
    let rows = rows(&csv);
    let last = rows.last().expect("a sample");
    assert!((last.0 - 1.1).abs() < 1e-9, "{last:?}");
    assert!(rows.iter().any(|row| row.0 > 1.0 && row.1.abs() > 1e-6), "{csv}");
}

/// With bounds of two states the bounds of a plan are too coarse for this move: a state leaves its bound, and the
/// status says so from the move on.
#[test]
fn steps_without_a_plan_are_infeasible() {
    let folder = support::folder("events_infeasible");
    let design = "name = \"q\"\nn = 3\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\nlate = \"extend\"\n\
        state_max = [inf, 0.7, 5]\npoles = \"least-energy\"\n[params]\ntau = 0.8\neps = 0.02\nu_max = 180\n\
        [[event]]\nat = 0.263\nmove = -0.478\n";
    let (code, csv, told) = simulate(&folder, design, &["--x0=0.218,0,0"]);
    assert_eq!(code, Some(0), "{told}");
    let rows = rows(&csv);
    let status = |row: &(f64, f64, f64, String)| row.3 == "PTC_INFEASIBLE";
    let first = rows.iter().find(|row| status(row)).expect("a step without a plan");
    assert!((first.0 - 0.263).abs() < 1e-9, "{first:?}");
    let beyond: Vec<_> = rows.iter().filter(|row| row.2.abs() > 0.7 + 1e-9).collect();
    assert!(!beyond.is_empty() && beyond.iter().all(|row| status(row)), "{beyond:?}");
}
