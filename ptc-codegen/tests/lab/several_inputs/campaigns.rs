//! Campaigns: objectives by the names of states, inputs and chains, replayed scenarios, shards and reports.

use std::fs;
use std::path::PathBuf;

use super::by_hand::{Arm, TAU, along, torques};
use super::{UNICYCLE, example, folder_with, near, numbers, run_in};

/// An arm whose second mass and whose drag are not known.
fn design() -> String {
    let bias = "[\"-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 + m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2) + drag*w1\", \"m2*l1*l2*sin(q2)*w1^2 + m2*grav*l2*cos(q1 + q2)\"]";
    format!(
        "{}[plant]\nm2 = [1.4, 1.6]\ndrag = [0, 0.4]\nbias = {bias}\n[disturbance]\ndrag = \"worst\"\n\
         [verify]\nq1 = [0.5, 1]\nq2 = [-0.5, 0]\nw1 = 0\nw2 = 0.1\nscenarios = 12\nsearch = 4\n\
         [[objective]]\nbound = \"input\"\nupsilon = [60, \"30 + dt\"]\n\
         [[objective]]\nbound = \"within\"\nh = \"x1_2 + 2*x2_1 - x1_1_0 + M2/10 + q1\"\nhigh = 9\n\
         [[objective]]\nbound = \"state\"\nsigma = 4\n\
         [[objective]]\nbound = \"attractive\"\nerror = 1e-2\n",
        example("two_link.toml")
    )
}

fn folder(test: &str) -> PathBuf {
    folder_with(&format!("several_inputs_campaigns_{test}"), "arm.toml", design())
}

const SCENARIO: &str = "q1 = 0.8, q2 = -0.3, m2 = 1.55, drag = worst(0.4, 0.5)";

#[test]
fn a_scenario_is_the_run_by_hand_with_its_objectives() {
    let folder = folder("scenario");
    let (code, csv, told) = run_in(&folder, &["verify", "arm.toml", "--scenario", SCENARIO]);
    assert_eq!(code, Some(0), "{told}");
    let (head, rows) = csv.split_once('\n').expect("a head");
    assert_eq!(head, "t,time_to_go,q1,q2,w1,w2,M1,M2,excess1,excess2,excess3,excess4");
    let rows: Vec<_> = rows
        .lines()
        .map(|line| line.split(',').map(|n| n.parse().unwrap_or(f64::NAN)).collect::<Vec<f64>>())
        .collect();
    // The drag ends where half of tau is over.
    let with = |drag: f64| move |x: &[f64], u: &[f64]| Arm { m1: 2.0, m2: 1.55, drag }.rates(x, u);
    let x0 = [0.8, -0.3, 0.0, 0.1];
    let mut states = along(&with(0.4), &torques, (&[0.0, TAU / 2.0], 8000), &x0);
    states.extend(
        along(&with(0.0), &torques, (&[TAU / 2.0, 0.9 * TAU], 8000), &states[1].clone()).pop(),
    );
    for (t, x) in [0.0, TAU / 2.0, 0.9 * TAU].into_iter().zip(&states) {
        let near_t = |row: &&Vec<f64>| (row[0] - t).abs();
        let row = rows.iter().min_by(|a, b| near_t(a).total_cmp(&near_t(b))).expect("a row");
        if (row[0] - t).abs() < 1e-9 {
            near(&row[2..6], x, 1e-7);
            near(&row[6..8], &torques(t, x), 1e-5);
        } else {
            assert!(t > TAU / 2.0, "the start and the end of the drag are looked at");
        }
    }
    let size = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    for row in &rows {
        let [t, _, q1, q2, w1, w2, m1, m2, of_inputs, within, state, _] = row[..] else {
            panic!("{row:?}")
        };
        let parts = (m1.abs() / 60.0).max(m2.abs() / (30.0 + t));
        near(&[of_inputs], &[parts - 1.0], 1e-12);
        near(&[within], &[q2 + 2.0 * w1 - 0.8 + m2 / 10.0 + q1 - 9.0], 1e-12);
        near(&[state], &[size(&[q1, q2, w1, w2]) / (4.0 * size(&x0)) - 1.0], 1e-12);
    }
    let last = rows.last().expect("a row");
    near(&[last[11]], &[size(&last[2..6]) / 1e-2 - 1.0], 1e-12);
}

#[test]
fn verdicts_shards_and_reports_are_those_of_any_campaign() {
    let folder = folder("whole");
    let asked = [
        "verify",
        "arm.toml",
        "--out",
        "all.parquet",
        "--report",
        "all.html",
        "--worst",
        "worst.csv",
    ];
    let (code, told, wrong) = run_in(&folder, &asked);
    assert_eq!((code, wrong.as_str()), (Some(0), ""));
    for part in [
        "with the emitted controller",
        "objective 1, |M1| <= 60, |M2| <= 30 + dt: holds, by sampling",
        "objective 2, x1_2 + 2*x2_1 - x1_1_0 + M2/10 + q1 <= 9: holds",
        "not proved: the plant is a model",
        "           M1           M2\n",
        "every objective holds",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    for part in ["1/2", "2/2"] {
        let file = format!("{}.parquet", &part[..1]);
        assert_eq!(
            run_in(&folder, &["verify", "arm.toml", "--shard", part, "--out", &file]).0,
            Some(0)
        );
    }
    let merged = [
        "verify",
        "arm.toml",
        "--merge",
        "2.parquet",
        "--merge",
        "1.parquet",
        "--out",
        "merged.parquet",
    ];
    assert_eq!(run_in(&folder, &merged).0, Some(0));
    let [all, merged] =
        ["all.parquet", "merged.parquet"].map(|file| fs::read(folder.join(file)).expect("rows"));
    assert!(all == merged, "parts that are merged are other rows");
    let worst = fs::read_to_string(folder.join("worst.csv")).expect("a trajectory");
    assert!(worst.lines().nth(1).is_some_and(|line| numbers(line).len() >= 11), "{worst}");
    let page = fs::read_to_string(folder.join("all.html")).expect("a report");
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    roxmltree::Document::parse_with_options(&page, options).expect("well-formed");
    for part in ["largest |u_k| in parts of its bound", ">M1<", ">M2<"] {
        assert!(page.contains(part), "{part}");
    }
}

/// A scenario in which the inputs stop decoupling the outputs fails with that reason, in time or in samples.
#[test]
fn a_scenario_without_control_fails() {
    let campaign = "[verify]\nx = 1\ny = 0\ns = [1.9, 2]\nc = 0\nscenarios = 2\nsearch = 2\n\
                    [[objective]]\nbound = \"within\"\nh = \"x\"\nlow = -9\n";
    let folder =
        folder_with("several_inputs_campaigns_turn", "turn.toml", format!("{UNICYCLE}{campaign}"));
    let (code, told, _) = run_in(&folder, &["verify", "turn.toml"]);
    assert_eq!(code, Some(1), "{told}");
    assert!(told.contains("2 of 2 draws"), "{told}");
    let (code, _, told) = run_in(&folder, &["verify", "turn.toml", "--scenario", "0"]);
    assert!(code != Some(0) && told.contains("stop decoupling the outputs"), "{told}");
}

#[test]
fn objectives_are_refused_where_they_are_wrong() {
    let design = design();
    for (own, other, told) in [
        (
            "h = \"x1_2 + 2*",
            "h = \"x1 + 2*",
            ["`x1` does not exist where there are several outputs", "x1_2 is the output 2"],
        ),
        (
            "M2/10",
            "u/10",
            ["`u` is not known where there are several inputs", "the inputs are M1, M2"],
        ),
        (
            "M2/10",
            "u_max",
            ["`u_max` is not known where there are several inputs", "each with its own limit"],
        ),
        ("[60, \"30 + dt\"]", "[60, 30, 20]", ["3 bounds of 2 inputs", "a list of one for each"]),
    ] {
        let text = design.replacen(own, other, 1);
        let key = if own.starts_with('[') { "upsilon = " } else { "h = " };
        let line = 1 + text.lines().position(|line| line.starts_with(key)).expect("a line");
        let folder = folder_with("several_inputs_campaigns_wrong", "arm.toml", &text);
        let (code, _, wrong) = run_in(&folder, &["verify", "arm.toml"]);
        assert!(code == Some(2) && wrong.contains(&format!("arm.toml:{line}:")), "{wrong}");
        assert!(told.iter().all(|part| wrong.contains(part)), "{told:?}: {wrong}");
    }
}
