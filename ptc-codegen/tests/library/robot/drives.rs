//! Rotors and friction of the joints: their part of torques and mass matrix, and mistakes in them.

use ptc_codegen::code::Instance;
use ptc_codegen::request::{self, Spec};
use ptc_codegen::robot::{self, code};

use super::lagrange::{lagrange, tree, urdf};
use super::{close, draw, entries};
use crate::support::with_urdf;

const ROTOR: [f64; 6] = [0.1, 0.25, 0.0, 0.5, 1.0, 2.0];
const DAMPING: [f64; 6] = [0.0, 0.5, 1.5, 0.25, 3.0, 1.0];
const FRICTION: [f64; 6] = [2.0, 0.0, 0.75, 1.0, 0.5, 4.0];
const WIDTH: [f64; 6] = [0.5, 1.0, 0.25, 2.0, 0.125, 0.5];

fn listed(numbers: &[f64]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

fn sign(v: f64, width: f64) -> f64 {
    v / v.hypot(width)
}

/// Inverse dynamics and mass matrix of a file with these keys, and the number of joints.
fn functions(text: &str, keys: &[(&str, &str)]) -> (Instance, usize) {
    let all = [&[("urdf", "test.urdf"), ("what", "inverse-dynamics, mass-matrix")], keys].concat();
    let request = robot::read(&with_urdf(entries(&all), text)).expect("a request");
    let robot = request.robot().expect("a robot");
    let code = code(&request, &robot);
    (Instance::new(&code, &[]).expect("no parameters"), robot.bodies.len())
}

#[test]
fn drives_add_to_torques_and_masses() {
    let joints = tree();
    let [rotor, damping, friction, width] =
        [ROTOR, DAMPING, FRICTION, WIDTH].map(|own| listed(&own));
    let keys = [
        ("tip", "link8, link5"),
        ("gravity", "0.4, -1.1, -9.7"),
        ("rotor", &rotor),
        ("damping", &damping),
        ("friction", &friction),
        ("friction_width", &width),
    ];
    let (mut arm, _) = functions(&urdf(&joints), &keys);
    let mut state = 5;
    for _ in 0..20 {
        let [q, v, a]: [Vec<f64>; 3] =
            std::array::from_fn(|_| (0..6).map(|_| draw(&mut state)).collect());
        let [mut torque, mut mass, _] = lagrange(&joints, &q, &v, &a);
        for j in 0..6 {
            torque[j] += ROTOR[j] * a[j] + DAMPING[j] * v[j] + FRICTION[j] * sign(v[j], WIDTH[j]);
            mass[7 * j] += ROTOR[j];
        }
        let found = arm.call("inverse_dynamics", &[("q", &q), ("v", &v), ("a", &a)]);
        assert!(close(&found.results["torque"], &torque, 1e-13), "{found:?} {torque:?}");
        let found = arm.call("mass_matrix", &[("q", &q)]);
        assert!(close(&found.results["mass"], &mass, 1e-13), "{found:?} {mass:?}");
    }
}

/// The tree, whose first joint has these attributes of `<dynamics>`, as has its fixed one.
fn file(attributes: &str) -> String {
    let joints = tree();
    let fixed = joints.iter().position(|joint| joint.kind == "fixed").expect("a fixed joint");
    let text = urdf(&joints);
    [0, joints[fixed].parent].into_iter().fold(text, |text, index| {
        let parent = format!("<parent link=\"link{index}\"/>");
        text.replacen(&parent, &format!("{parent}<dynamics {attributes}/>"), 1)
    })
}

/// The torque that moves the first joint at 2 rad/s, less that without friction.
fn friction(attributes: &str, keys: &[(&str, &str)]) -> f64 {
    let of = |text: &str, keys: &[(&str, &str)]| {
        let weightless = [&[("gravity", "0, 0, 0")], keys].concat();
        let (mut arm, joints) = functions(text, &weightless);
        let rest = vec![0.0; joints];
        let mut v = rest.clone();
        v[0] = 2.0;
        arm.call("inverse_dynamics", &[("q", &rest), ("v", &v), ("a", &rest)]).results["torque"][0]
    };
    of(&file(attributes), keys) - of(&file(""), &[])
}

#[test]
fn friction_of_a_file_is_that_of_its_joints_unless_a_design_gives_it() {
    let dry = sign(2.0, 0.01);
    for (attributes, keys, expected) in [
        ("", &[][..], 0.0),
        ("damping=\"0.5\"", &[], 1.0),
        ("damping=\" +5e-1 \" friction=\"3\"", &[], 1.0 + 3.0 * dry),
        ("friction=\"3\" D=\"1\" damping=\"-0\"", &[], 3.0 * dry),
        ("damping=\"0.5\" friction=\"3\"", &[("damping", "0")], 3.0 * dry),
        ("damping=\"0.5\" friction=\"3\"", &[("friction", "1"), ("damping", "2")], 4.0 + dry),
    ] {
        let found = friction(attributes, keys);
        assert!((found - expected).abs() < 1e-12, "{attributes} {keys:?}: {found}");
    }
}

#[test]
fn each_mistake_in_a_drive_has_one_message() {
    let refused = |attributes: &str, keys: &[(&str, &str)]| {
        let given = [&[("urdf", "test.urdf"), ("what", "inverse-dynamics")][..], keys].concat();
        let entries = with_urdf(entries(&given), &file(attributes));
        let found = match robot::read(&entries) {
            Ok(request) => request.robot().expect_err("a mistake"),
            Err(found) => found,
        };
        assert!(found.len() == 1 && !found[0].help.is_empty(), "{found:?}");
        found[0].message.clone()
    };
    for (attributes, expected) in [
        ("damping=\"-1\"", "test.urdf, line 5: the damping of joint `joint1` is negative"),
        ("friction=\"-1e-9\"", "test.urdf, line 5: the friction of joint `joint1` is negative"),
        ("damping=\"\"", "test.urdf, line 5: damping = \"\" of <dynamics> is not a number"),
        ("damping=\"1 2\"", "test.urdf, line 5: damping = \"1 2\" of <dynamics> is not a number"),
        ("friction=\"nan\"", "test.urdf, line 5: friction = \"nan\" of <dynamics> is not a number"),
        ("friction=\"0,5\"", "test.urdf, line 5: friction = \"0,5\" of <dynamics> is not a number"),
    ] {
        assert_eq!(refused(attributes, &[]), expected);
    }
    for (key, value, expected) in [
        ("rotor", "1, 2", "rotor has 2 numbers, and the robot 6 joints"),
        ("damping", "1, 2, 3, 4, 5, 6, 7", "damping has 7 numbers, and the robot 6 joints"),
        ("rotor", "-1", "rotor = -1"),
        ("friction", "inf", "friction = inf"),
        ("friction", "0.1, -0.2, 0, 0, 0", "friction = [0.1, -0.2, 0, 0, 0]"),
        ("friction_width", "0", "friction_width = 0"),
        ("friction_width", "1e-7", "friction_width = 1e-7"),
    ] {
        assert_eq!(refused("", &[(key, value)]), expected);
    }
}

const LAW: &str =
    "mu = \"exp(a=1)\"\npoles = [-3, -4]\n[params]\ntau = 1\n[robot]\nurdf = \"a.urdf\"\n";

fn controller(more: &str) -> Spec {
    let entries = crate::support::entries(&format!("{LAW}{more}"));
    request::read(&with_urdf(entries, &file("damping=\"0.5\""))).expect("a controller")
}

#[test]
fn drives_are_part_of_a_design() {
    let own = controller("rotor = [1, 2, 3, 4, 5, 6]\nfriction = 0.5\n");
    let command = own.command();
    assert!(command.contains("--rotor=1,2,3,4,5,6 --friction=0.5"), "{command}");
    let same =
        controller("friction = [0.5, 0.5, 0.5, 0.5, 0.5, 0.5]\nrotor = [1, 2, 3, 4, 5, 6]\n");
    assert_eq!(own.arm().map(|arm| &arm.robot), same.arm().map(|arm| &arm.robot));
    let other = controller("rotor = [1, 2, 3, 4, 5, 6]\nfriction = 0.5\ndamping = 0\n");
    assert_ne!(own.fingerprint(), other.fingerprint());
}
