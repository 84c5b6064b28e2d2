//! Functions of robots against Lagrange's equations, and mistakes in their files.

mod drives;
mod dual;
mod lagrange;
mod mistakes;

use ptc_codegen::code::{Instance, Status};
use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::Entry;
use ptc_codegen::robot::{self, code};
use ptc_codegen::syntax::parse;
use ptc_codegen::urdf::Robot;

use crate::support::with_urdf;
use lagrange::{GRAVITY, Joint, lagrange, tree, urdf};

/// Returns the next of a row of numbers between -3 and 3.
fn draw(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    #[allow(clippy::cast_precision_loss)]
    let unit = (*state >> 11) as f64 / (1_u64 << 53) as f64;
    6.0 * unit - 3.0
}

fn entries(pairs: &[(&str, &str)]) -> Vec<Entry> {
    let entry = |(key, text): &(&str, &str)| Entry {
        key: (*key).to_owned(),
        place: Place(0),
        value: parse(key, text, &mut |_| Place(0)).expect("a value"),
    };
    pairs.iter().map(entry).collect()
}

/// The functions of a file with these keys, in the interpreter.
fn functions(text: &str, keys: &[(&str, &str)]) -> (Instance, Robot) {
    let all = [&[("urdf", "test.urdf"), ("what", "inverse-dynamics, mass-matrix, jacobian")], keys]
        .concat();
    let request = robot::read(&with_urdf(entries(&all), text)).expect("a request");
    let robot = request.robot().expect("a robot");
    let code = code(&request, &robot);
    (Instance::new(&code, &[]).expect("no parameters"), robot)
}

fn close(found: &[f64], expected: &[f64], most: f64) -> bool {
    let size = expected.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= most * size)
}

#[test]
fn trees_obey_lagranges_equations() {
    let joints = tree();
    for (precision, most) in [("f64", 1e-13), ("f32", 2e-5)] {
        let gravity = GRAVITY.map(|own| own.to_string()).join(", ");
        let keys =
            [("tip", "link8, link5"), ("gravity", gravity.as_str()), ("precision", precision)];
        let all = [&keys[..], &[("what", "inverse-dynamics, mass-matrix")]].concat();
        let mut given = vec![("urdf", "test.urdf")];
        given.extend(all);
        let entries = with_urdf(entries(&given), &urdf(&joints));
        let request = robot::read(&entries).expect("a request");
        let robot = request.robot().expect("a robot");
        let mut arm = Instance::new(&code(&request, &robot), &[]).expect("no parameters");
        let mut state = 1;
        for _ in 0..50 {
            let [q, v, a]: [Vec<f64>; 3] = std::array::from_fn(|_| {
                (0..6).map(|_| f64::from(draw(&mut state) as f32)).collect()
            });
            let [torque, mass, _] = lagrange(&joints, &q, &v, &a);
            let given = [("q", q.as_slice()), ("v", v.as_slice()), ("a", a.as_slice())];
            let found = arm.call("inverse_dynamics", &given);
            assert_eq!(found.status, Status::Ok);
            assert!(
                close(&found.results["torque"], &torque, most),
                "{precision}: {found:?} {torque:?}"
            );
            let found = arm.call("mass_matrix", &given[..1]);
            assert!(close(&found.results["mass"], &mass, most), "{precision}: {found:?} {mass:?}");
        }
    }
}

#[test]
fn jacobians_are_derivatives_of_the_tip() {
    let joints: Vec<_> = tree().into_iter().take(5).collect();
    let (mut arm, robot) = functions(&urdf(&joints), &[]);
    assert_eq!(robot.tip.expect("one end").link, "link5");
    let mut state = 2;
    for _ in 0..50 {
        let q: Vec<_> = (0..4).map(|_| draw(&mut state)).collect();
        let [_, _, jacobian] = lagrange(&joints, &q, &[0.0; 4], &[0.0; 4]);
        let found = arm.call("jacobian", &[("q", &q)]);
        assert!(close(&found.results["j"], &jacobian, 1e-14), "{found:?} {jacobian:?}");
    }
}

#[test]
fn joints_beside_the_way_to_the_tip_are_held() {
    let mut joints = tree();
    let (mut arm, robot) =
        functions(&urdf(&joints), &[("tip", "link5"), ("gravity", "0.4, -1.1, -9.7")]);
    assert_eq!(robot.held, ["joint6", "joint7"]);
    joints[5].kind = "fixed";
    joints[6].kind = "fixed";
    let [q, v, a] = [[0.3, -0.2, 1.1, 2.0], [1.0, 0.5, -0.7, 0.2], [0.1, -2.0, 0.3, 0.9]];
    let [torque, ..] = lagrange(&joints, &q, &v, &a);
    let found = arm.call("inverse_dynamics", &[("q", &q), ("v", &v), ("a", &a)]);
    assert!(close(&found.results["torque"], &torque, 1e-13), "{found:?} {torque:?}");
    // The base may be any link: what it stands on has no part in it.
    let (_, robot) = functions(&urdf(&tree()), &[("base", "link3"), ("tip", "link5")]);
    assert_eq!(robot.joints().collect::<Vec<_>>(), ["joint4", "joint5"]);
}

#[test]
fn two_links_have_the_torques_of_textbooks() {
    let link = |origin: f64| Joint {
        kind: "revolute",
        parent: 0,
        origin: [origin, 0.0, 0.0],
        angles: [0.0; 3],
        axis: [0.0, 0.0, 1.0],
        mass: 1.5,
        centre: [0.3, 0.0, 0.0],
        centre_angles: [0.0; 3],
        inertia: [0.0, 0.0, 0.02, 0.0, 0.0, 0.0],
    };
    let joints = [link(0.0), Joint { parent: 1, ..link(0.8) }];
    let (mut arm, _) = functions(&urdf(&joints), &[("gravity", "0, -9.81, 0")]);
    let [q, v, a] = [[0.4_f64, -1.3], [0.9, 2.0], [-3.0, 1.0]];
    let (m, l, c, inertia, g) = (1.5, 0.8, 0.3, 0.02, 9.81);
    let (h, coupling) = (m * l * c * q[1].sin(), m * c * c + m * l * c * q[1].cos() + inertia);
    let first = 2.0 * inertia + m * c * c + m * (l * l + c * c + 2.0 * l * c * q[1].cos());
    let weight = m * c * g * (q[0] + q[1]).cos();
    let torque = [
        first * a[0] + coupling * a[1] - h * (2.0 * v[0] + v[1]) * v[1]
            + (m * c + m * l) * g * q[0].cos()
            + weight,
        coupling * a[0] + (m * c * c + inertia) * a[1] + h * v[0] * v[0] + weight,
    ];
    let found = arm.call("inverse_dynamics", &[("q", &q), ("v", &v), ("a", &a)]);
    assert!(close(&found.results["torque"], &torque, 1e-14), "{found:?} {torque:?}");
}

#[test]
fn calls_with_what_is_no_number_fail() {
    let (mut arm, _) = functions(&urdf(&tree()[..1]), &[]);
    let found = arm.call("inverse_dynamics", &[("q", &[f64::NAN]), ("v", &[0.0]), ("a", &[0.0])]);
    assert_eq!(found.status, Status::Input);
    let found = arm.call("inverse_dynamics", &[("q", &[0.0]), ("v", &[0.0]), ("a", &[f64::MAX])]);
    assert_eq!(found.status, Status::Ok);
    let found = arm.call("inverse_dynamics", &[("q", &[0.0]), ("v", &[1e200]), ("a", &[0.0])]);
    assert_eq!(found.status, Status::Ok, "v does not enter for one joint");
    let (mut arm, _) = functions(&urdf(&tree()[..2]), &[]);
    let huge = [1e200, 1e200];
    let found = arm.call("inverse_dynamics", &[("q", &[0.0; 2]), ("v", &huge), ("a", &[0.0; 2])]);
    assert_eq!(found.status, Status::Range);
}
