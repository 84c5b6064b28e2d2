//! Controllers of robots from their URDF: torques against Lagrange's equations, and loops that are chains of integrators.

#[path = "../../library/robot/dual.rs"]
mod dual;
#[path = "../../library/robot/lagrange.rs"]
mod lagrange;
mod runs;

use ptc_codegen::request::{self, Spec};
use ptc_codegen::simulate::{Control, Controller, Values};

use crate::support::{entries, example, spec, with_urdf};
use lagrange::{GRAVITY, Joint, lagrange, tree, urdf};

/// The law of each joint with poles -3 and -4 and the mapping exp(a=1), that reaches rest at 1 s, in its acceleration:
/// -(k_1 x_1 + (k_2 - 1) T x_2)/T^2.
const LAW: &str = "mu = \"exp(a=1)\"\npoles = [-3, -4]\n[params]\ntau = 1\nt0 = 0\neps = 1e-3\n\
    u_max = inf\n[robot]\nurdf = \"arm.urdf\"\n";

fn wanted(t: f64, position: f64, rate: f64) -> f64 {
    let to_go = 1.0 - t;
    -(12.0 * position / to_go + 6.0 * rate) / to_go
}

fn robot(design: &str, joints: &[Joint]) -> Spec {
    request::read(&with_urdf(entries(design), &urdf(joints))).expect("a robot")
}

/// The torques of a controller at a time and a state.
fn torques(spec: &Spec, t: f64, x: &[f64]) -> Vec<f64> {
    let mut controller = Controller::new(spec).expect("a controller");
    controller.init(&Values::default(), &[]).expect("legal parameters");
    controller.step(t, x).0.to_vec()
}

/// Numbers between -2 and 2 with few bits.
fn draw(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    f64::from((*state >> 48) as u16) / 16384.0 - 2.0
}

fn close(found: &[f64], expected: &[f64], most: f64) {
    let size = expected.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= most * size;
    assert_eq!(found.len(), expected.len());
    assert!(found.iter().zip(expected).all(is_near), "{found:?}, not {expected:?}");
}

#[test]
fn torques_give_each_joint_the_acceleration_of_its_law() {
    let joints = tree();
    let gravity = format!("{LAW}gravity = [0.4, -1.1, -9.7]\n");
    assert_eq!(GRAVITY, [0.4, -1.1, -9.7]);
    for (precision, most) in [("f64", 1e-13), ("f32", 5e-5)] {
        let spec = robot(&format!("precision = \"{precision}\"\n{gravity}"), &joints);
        let mut state = 3;
        for t in [0.0, 0.25, 0.5, 0.75] {
            let x: Vec<_> = (0..12).map(|_| draw(&mut state)).collect();
            let (q, v) = x.split_at(6);
            let a: Vec<_> = q.iter().zip(v).map(|(q, v)| wanted(t, *q, *v)).collect();
            let [expected, ..] = lagrange(&joints, q, v, &a);
            close(&torques(&spec, t, &x), &expected, most);
        }
    }
}

/// The arm of an example whose inertia and bias were derived by hand, as bodies.
#[test]
fn an_arm_has_the_torques_of_its_inertia_and_bias() {
    let link = |parent, origin, mass, length| Joint {
        kind: "revolute",
        parent,
        origin: [origin, 0.0, 0.0],
        angles: [0.0; 3],
        axis: [0.0, 0.0, 1.0],
        mass,
        centre: [length, 0.0, 0.0],
        centre_angles: [0.0; 3],
        inertia: [0.0; 6],
    };
    let joints = [link(0, 0.0, 2.0, 0.6), link(1, 0.6, 1.5, 0.5)];
    let text = example("two_link.toml");
    let (head, _) = text.split_once("[model]").expect("a model");
    let head = head.replace("m1 = 2 ", "").replace("limits", "# limits");
    let kept =
        |line: &&str| !["m1", "m2", "l1", "l2", "grav"].iter().any(|own| line.starts_with(own));
    let head: Vec<_> = head.lines().filter(kept).collect();
    let of_robot = format!(
        "{}\nt0 = 0\nu_max = inf\n[robot]\nurdf = \"arm.urdf\"\ngravity = [0, -9.81, 0]\n",
        head.join("\n")
    );
    let of_robot = robot(&of_robot, &joints);
    let of_model = text.replace("limits = [120, 60]", "limits = [1e9, 1e9]");
    let of_model = spec(&of_model.replace("[params]", "[params]\nt0 = 0"));
    let mut state = 7;
    for t in [0.0, 5.0, 10.0, 18.0, 25.0] {
        let x: Vec<_> = (0..4).map(|_| draw(&mut state)).collect();
        close(&torques(&of_robot, t, &x), &torques(&of_model, t, &x), 1e-14);
    }
}

#[test]
fn payloads_equal_fixed_bodies_at_the_tip() {
    let mut joints: Vec<_> = tree().into_iter().take(5).collect();
    let payload = "[0.8, 0.1, -0.2, 0.3, 0.02, 0.03, 0.025, 0.001, -0.002, 0.003]";
    let gravity = "gravity = [0.4, -1.1, -9.7]";
    let carrying = robot(&format!("{LAW}{gravity}\npayload = {payload}\n"), &joints);
    joints.push(Joint {
        kind: "fixed",
        parent: 5,
        origin: [0.0; 3],
        angles: [0.0; 3],
        axis: [1.0, 0.0, 0.0],
        mass: 0.8,
        centre: [0.1, -0.2, 0.3],
        centre_angles: [0.0; 3],
        inertia: [0.02, 0.03, 0.025, 0.001, -0.002, 0.003],
    });
    let mut state = 11;
    let x: Vec<_> = (0..8).map(|_| draw(&mut state)).collect();
    let (q, v) = x.split_at(4);
    let a: Vec<_> = q.iter().zip(v).map(|(q, v)| wanted(0.5, *q, *v)).collect();
    let [expected, ..] = lagrange(&joints, q, v, &a);
    close(&torques(&carrying, 0.5, &x), &expected, 1e-13);
    let command = carrying.command();
    assert!(command.contains("--payload=0.8,0.1,-0.2,0.3,0.02,"), "{command}");
}
