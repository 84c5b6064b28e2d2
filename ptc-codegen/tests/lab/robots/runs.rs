//! Runs of robots. The torques cancel what moves the joints, so each joint is a chain of integrators with its law, and
//! the run of the tree is that of as many chains.

use std::fs;

use super::LAW;
use super::lagrange::{Joint, tree, urdf};
use crate::support::{folder, run_in};

const X0: &str = "0.5,-0.3,0.8,-1,0.2,0.1,0.4,0.2,-0.5,1,0,-0.3";

/// The rows of a run in a folder, without the torques.
fn rows(folder: &std::path::Path, words: &[&str], states: usize) -> Vec<Vec<f64>> {
    let (code, csv, told) = run_in(folder, &[&["simulate"], words].concat());
    assert_eq!(code, Some(0), "{told}");
    let numbers = |line: &str| -> Vec<f64> {
        line.split(',')
            .skip(1)
            .take(1 + states)
            .map(|cell| cell.parse().expect("a number"))
            .collect()
    };
    csv.lines().skip(1).map(numbers).collect()
}

/// The folder of a design of a robot, and of the same law for chains.
fn written(test: &str, joints: &[Joint], more: &str) -> std::path::PathBuf {
    let folder = folder(test);
    fs::write(folder.join("arm.urdf"), urdf(joints)).expect("a file");
    fs::write(folder.join("arm.toml"), format!("{LAW}{more}")).expect("a file");
    let (law, _) = LAW.split_once("[robot]").expect("a robot");
    let chains = format!("n = 2\naxes = 6\n{law}");
    fs::write(folder.join("chains.toml"), chains).expect("a file");
    folder
}

#[test]
fn joints_move_as_chains_of_integrators() {
    for (test, more) in
        [("gravity", "gravity = [0.4, -1.1, -9.7]\n"), ("weightless", "gravity = [0, 0, 0]\n")]
    {
        let folder = written(test, &tree(), more);
        let arm = rows(&folder, &["arm.toml", "--x0", X0], 12);
        // Of axes the states of one follow each other.
        let x0: Vec<_> = X0.split(',').collect();
        let x0: Vec<_> = (0..6).flat_map(|j| [x0[j], x0[6 + j]]).collect();
        let chains = rows(&folder, &["chains.toml", "--x0", &x0.join(",")], 12);
        assert_eq!(arm.len(), chains.len());
        for (arm, chains) in arm.iter().zip(&chains) {
            for j in 0..6 {
                let [q, v] = [arm[1 + j] - chains[1 + 2 * j], arm[7 + j] - chains[2 + 2 * j]];
                assert!(q.abs() < 1e-8 && v.abs() < 1e-7, "{arm:?}, not {chains:?}");
            }
        }
        let last = arm.last().expect("rows");
        let rest = last[1..7].iter().fold(0.0, |most: f64, q| most.max(q.abs()));
        assert!((last[0] - 1.0).abs() < 1e-8 && rest < 1e-8, "{last:?}");
    }
}

#[test]
fn sampled_arms_follow_references() {
    let more = "gravity = [0, 0, -9.81]\n";
    let folder = written("samples", &tree(), more);
    let flags =
        ["arm.toml", "--sample-time", "0.001", "--reference", "0.3,0,0.2*t,0,-0.1,0", "--x0", X0];
    let rows = rows(&folder, &flags, 12);
    let last = rows.last().expect("rows");
    for (q, wanted) in last[1..7].iter().zip([0.3, 0.0, 0.2, 0.0, -0.1, 0.0]) {
        assert!((q - wanted).abs() < 1e-3, "{last:?}");
    }
}

/// A joint without weight: the payload changes the inertia alone, from 0.6 to 0.85 kg m^2, and the joint accelerates by
/// 0.6/0.85 of what the law wants.
#[test]
fn unknown_payloads_slow_a_joint() {
    let joint = weightless();
    let more = "gravity = [0, 0, 0]\n[plant]\npayload = [1, 0, 0.5, 0]\n";
    moves_as(("payload", &joint, more), "g = \"0.6/0.85\"");
}

/// With a rotor of 0.4 kg m^2 and damping of 0.3 N m s/rad that the law does not know, the joint of 0.6 kg m^2 is a chain
/// with g = 0.6 and f = -0.3 x2; where the law knows them, nothing is left of them.
#[test]
fn unknown_drives_act_on_a_joint_and_known_ones_are_compensated() {
    let joint = weightless();
    let given = "rotor = 0.4\ndamping = 0.3\n";
    let dry = "friction_width = 0.5\nfriction";
    let more = format!("gravity = [0, 0, 0]\n[plant]\n{given}");
    moves_as(("drive", &joint, &more), "g = \"0.6\"\nf = \"-0.3*x2\"");
    let more = format!("gravity = [0, 0, 0]\n{given}{dry} = 2\n");
    moves_as(("known", &joint, &more), "g = 1");
    // Of what the law knows and the joint has not, the opposite acts.
    let more = format!("{more}[plant]\nrotor = 0\ndamping = 0.3\nfriction = 1\n");
    moves_as(("other", &joint, &more), "g = \"1/0.6\"\nf = \"x2/sqrt(x2^2 + 0.25)/0.6\"");
}

/// A joint of 0.6 kg m^2.
fn weightless() -> Joint {
    Joint {
        kind: "revolute",
        parent: 0,
        origin: [0.1, 0.2, 0.0],
        angles: [0.3, 0.0, 0.2],
        axis: [0.0, 0.0, -1.0],
        mass: 2.0,
        centre: [0.5, 0.0, 0.0],
        centre_angles: [0.0; 3],
        inertia: [0.0, 0.0, 0.1, 0.0, 0.0, 0.0],
    }
}

/// Runs a joint and the chain of its law with another plant.
fn moves_as((test, joint, more): (&str, &Joint, &str), plant: &str) {
    let folder = written(test, std::slice::from_ref(joint), more);
    let (law, _) = LAW.split_once("[robot]").expect("a robot");
    let chain = format!("n = 2\n{law}[plant]\n{plant}\n");
    fs::write(folder.join("chain.toml"), chain).expect("a file");
    let run = |design: &str| rows(&folder, &[design, "--x0", "0.5,-0.3"], 2);
    let (arm, chain) = (run("arm.toml"), run("chain.toml"));
    assert_eq!(arm.len(), chain.len());
    // What an integration leaves of the rates grows with 1/T.
    for (arm, chain) in arm.iter().zip(&chain).filter(|(arm, _)| arm[0] < 0.99) {
        let off = arm.iter().zip(chain).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-6, "{arm:?}, not {chain:?}");
    }
    assert!(chain.iter().any(|row| row[1] > 0.3), "it moves");
}
