//! Functions of robots against Lagrange's equations, formed from the kinetic and potential energy of the links.

use ptc_codegen::code::{Instance, Status};
use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::Entry;
use ptc_codegen::robot::{self, code};
use ptc_codegen::syntax::parse;
use ptc_codegen::urdf::Robot;

use dual::{Dual, Matrix, Vector};

/// A joint, and the link that it moves.
struct Joint {
    kind: &'static str,
    /// Place of its parent in the list, from 1; 0 for the base.
    parent: usize,
    origin: Vector<f64>,
    angles: Vector<f64>,
    axis: Vector<f64>,
    mass: f64,
    centre: Vector<f64>,
    centre_angles: Vector<f64>,
    /// xx, yy, zz, xy, xz, yz about the centre.
    inertia: [f64; 6],
}

const GRAVITY: Vector<f64> = [0.4, -1.1, -9.7];

/// Two arms on a torso, with all kinds of joints, and frames in general position. Quarter turns are rounded as in files.
#[allow(clippy::approx_constant)]
fn tree() -> Vec<Joint> {
    let joint = |kind, parent, origin, angles, axis, mass: f64| Joint {
        kind,
        parent,
        origin,
        angles,
        axis,
        mass,
        centre: [0.02 * mass, -0.05, 0.11],
        centre_angles: [0.3, -0.2, 0.7 * mass],
        inertia: [0.021, 0.017, 0.012, 0.001, -0.002, 0.0015].map(|entry| entry * mass),
    };
    vec![
        joint("revolute", 0, [0.1, -0.2, 0.4], [0.2, -0.5, 0.9], [0.0, 0.0, 1.0], 4.0),
        joint("prismatic", 1, [0.0, 0.3, 0.1], [0.0, 1.5707963, 0.0], [0.0, -1.0, 0.0], 2.5),
        joint("fixed", 2, [0.05, 0.0, 0.2], [0.4, 0.1, -0.3], [1.0, 0.0, 0.0], 0.7),
        joint("continuous", 3, [0.2, 0.1, -0.1], [-1.5708, 0.0, 0.0], [1.0, 2.0, -2.0], 1.8),
        joint("revolute", 4, [0.3, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], 1.1),
        joint("revolute", 1, [-0.1, 0.2, 0.3], [3.14159265, 0.0, 0.6], [0.0, 1.0, 0.0], 2.0),
        joint("prismatic", 6, [0.0, 0.0, 0.25], [0.0, 0.0, 0.0], [0.6, 0.0, 0.8], 0.9),
        joint("fixed", 7, [0.0, 0.1, 0.0], [0.0, 0.7, 0.0], [1.0, 0.0, 0.0], 0.3),
    ]
}

fn written(numbers: &[f64]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// The URDF file of joints.
fn urdf(joints: &[Joint]) -> String {
    let mut text =
        "<?xml version=\"1.0\"?>\n<robot name=\"test\">\n<link name=\"link0\"/>\n".to_owned();
    for (index, joint) in (1..).zip(joints) {
        let [xx, yy, zz, xy, xz, yz] = joint.inertia;
        text.push_str(&format!(
            "<link name=\"link{index}\"><inertial><origin xyz=\"{}\" rpy=\"{}\"/><mass value=\"{}\"/>\
             <inertia ixx=\"{xx}\" iyy=\"{yy}\" izz=\"{zz}\" ixy=\"{xy}\" ixz=\"{xz}\" iyz=\"{yz}\"/></inertial></link>\n\
             <joint name=\"joint{index}\" type=\"{}\"><parent link=\"link{}\"/><child link=\"link{index}\"/>\
             <origin xyz=\"{}\" rpy=\"{}\"/><axis xyz=\"{}\"/></joint>\n",
            written(&joint.centre), written(&joint.centre_angles), joint.mass,
            joint.kind, joint.parent,
            written(&joint.origin), written(&joint.angles), written(&joint.axis),
        ));
    }
    text.push_str("</robot>\n");
    text
}

/// Numbers with a derivative, and vectors and matrices of them.
mod dual {
    use std::ops::{Add, Mul, Neg, Sub};

    #[derive(Clone, Copy, Default)]
    pub(super) struct Dual(pub(super) f64, pub(super) f64);

    impl Add for Dual {
        type Output = Self;
        fn add(self, b: Self) -> Self {
            Self(self.0 + b.0, self.1 + b.1)
        }
    }
    impl Sub for Dual {
        type Output = Self;
        fn sub(self, b: Self) -> Self {
            Self(self.0 - b.0, self.1 - b.1)
        }
    }
    impl Mul for Dual {
        type Output = Self;
        fn mul(self, b: Self) -> Self {
            Self(self.0 * b.0, self.0 * b.1 + self.1 * b.0)
        }
    }
    impl Neg for Dual {
        type Output = Self;
        fn neg(self) -> Self {
            Self(-self.0, -self.1)
        }
    }

    pub(super) type Vector<T> = [T; 3];
    pub(super) type Matrix<T> = [[T; 3]; 3];

    pub(super) fn constant(values: Vector<f64>) -> Vector<Dual> {
        values.map(|value| Dual(value, 0.0))
    }

    pub(super) fn dot(a: &Vector<Dual>, b: &Vector<Dual>) -> Dual {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    pub(super) fn add(a: &Vector<Dual>, b: &Vector<Dual>) -> Vector<Dual> {
        std::array::from_fn(|i| a[i] + b[i])
    }

    pub(super) fn cross(a: &Vector<Dual>, b: &Vector<Dual>) -> Vector<Dual> {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    }

    pub(super) fn apply(m: &Matrix<Dual>, v: &Vector<Dual>) -> Vector<Dual> {
        m.map(|row| dot(&row, v))
    }

    pub(super) fn product(a: &Matrix<Dual>, b: &Matrix<Dual>) -> Matrix<Dual> {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
        })
    }

    /// Rodrigues' rotation about a unit vector.
    pub(super) fn rotation(axis: &Vector<f64>, angle: Dual) -> Matrix<Dual> {
        let (c, s) = (
            Dual(angle.0.cos(), -angle.0.sin() * angle.1),
            Dual(angle.0.sin(), angle.0.cos() * angle.1),
        );
        let [x, y, z] = constant(*axis);
        let one = Dual(1.0, 0.0);
        let t = one - c;
        [
            [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
            [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
        ]
    }
}

/// A rounded quarter turn is meant as such.
fn meant(angle: f64) -> f64 {
    let turns = (angle / std::f64::consts::FRAC_PI_2).round();
    let exact = turns * std::f64::consts::FRAC_PI_2;
    if (angle - exact).abs() < 1e-5 { exact } else { angle }
}

fn fixed(angles: &Vector<f64>) -> Matrix<Dual> {
    let [roll, pitch, yaw] = angles.map(|angle| Dual(meant(angle), 0.0));
    let about = |axis, angle| dual::rotation(&axis, angle);
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    dual::product(&about(z, yaw), &dual::product(&about(y, pitch), &about(x, roll)))
}

/// Columns of the Jacobians of a link and the point at `point` in its frame: velocity, angular velocity.
struct Link {
    rotation: Matrix<Dual>,
    origin: Vector<Dual>,
    /// Each moving joint on the way: its number, axis and origin, and whether it slides.
    way: Vec<(usize, Vector<Dual>, Vector<Dual>, bool)>,
}

impl Link {
    fn columns(&self, point: &Vector<Dual>, n: usize) -> Vec<[Vector<Dual>; 2]> {
        let mut columns = vec![[[Dual::default(); 3]; 2]; n];
        for (joint, axis, origin, slides) in &self.way {
            let lever: Vector<Dual> = std::array::from_fn(|i| point[i] - origin[i]);
            columns[*joint] = match slides {
                true => [*axis, [Dual::default(); 3]],
                false => [dual::cross(axis, &lever), *axis],
            };
        }
        columns
    }
}

/// The links in the base, with the positions of the moving joints.
fn links(joints: &[Joint], q: &[Dual]) -> Vec<Link> {
    let unit = dual::rotation(&[0.0, 0.0, 1.0], Dual(0.0, 0.0));
    let mut links = vec![Link { rotation: unit, origin: [Dual::default(); 3], way: Vec::new() }];
    let mut moving = 0;
    for joint in joints {
        let parent = &links[joint.parent];
        let origin = dual::add(
            &parent.origin,
            &dual::apply(&parent.rotation, &dual::constant(joint.origin)),
        );
        let rotation = dual::product(&parent.rotation, &fixed(&joint.angles));
        let size = joint.axis.iter().map(|own| own * own).sum::<f64>().sqrt();
        let own = joint.axis.map(|own| own / size);
        let axis = dual::apply(&rotation, &dual::constant(own));
        let mut link = Link { rotation, origin, way: parent.way.clone() };
        if joint.kind != "fixed" {
            let slides = joint.kind == "prismatic";
            link.way.push((moving, axis, origin, slides));
            match slides {
                true => link.origin = dual::add(&origin, &axis.map(|own| own * q[moving])),
                false => link.rotation = dual::product(&rotation, &dual::rotation(&own, q[moving])),
            }
            moving += 1;
        }
        links.push(link);
    }
    links
}

/// Mass matrix and potential energy.
fn energies(joints: &[Joint], q: &[Dual]) -> (Vec<Vec<Dual>>, Dual) {
    let n = q.len();
    let (mut mass, mut potential) = (vec![vec![Dual::default(); n]; n], Dual::default());
    for (joint, link) in joints.iter().zip(&links(joints, q)[1..]) {
        let centre =
            dual::add(&link.origin, &dual::apply(&link.rotation, &dual::constant(joint.centre)));
        let weight = Dual(joint.mass, 0.0);
        potential = potential - weight * dual::dot(&dual::constant(GRAVITY), &centre);
        let [xx, yy, zz, xy, xz, yz] = joint.inertia;
        let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(dual::constant);
        let rotation = dual::product(&link.rotation, &fixed(&joint.centre_angles));
        let columns = link.columns(&centre, n);
        for i in 0..n {
            // R I R^T w.
            let spun: Vector<Dual> = std::array::from_fn(|a| {
                (0..3).fold(Dual::default(), |sum, b| sum + rotation[b][a] * columns[i][1][b])
            });
            let momentum = dual::apply(&rotation, &dual::apply(&tensor, &spun));
            for j in 0..n {
                let [linear, angular] = &columns[j];
                mass[i][j] = mass[i][j]
                    + weight * dual::dot(&columns[i][0], linear)
                    + dual::dot(&momentum, angular);
            }
        }
    }
    (mass, potential)
}

/// Torques by Lagrange's equations, the mass matrix, and the Jacobian of the last link.
fn lagrange(joints: &[Joint], q: &[f64], v: &[f64], a: &[f64]) -> [Vec<f64>; 3] {
    let n = q.len();
    let seeded = |k: usize| -> Vec<Dual> {
        (0..n).map(|j| Dual(q[j], if j == k { 1.0 } else { 0.0 })).collect()
    };
    let all: Vec<_> = (0..n).map(|k| energies(joints, &seeded(k))).collect();
    let mass = &all[0].0;
    let torque = (0..n).map(|i| {
        let mut torque = all[i].1.1;
        for j in 0..n {
            torque += mass[i][j].0 * a[j];
            for k in 0..n {
                torque += (all[k].0[i][j].1 - 0.5 * all[i].0[j][k].1) * v[j] * v[k];
            }
        }
        torque
    });
    let torque = torque.collect();
    let entries = mass.iter().flatten().map(|entry| entry.0).collect();
    let links = links(joints, &seeded(n));
    let last = &links[links.len() - 1];
    let columns = last.columns(&last.origin, n);
    let row = |row: usize| {
        columns.iter().map(move |column| column[row / 3][row % 3].0).collect::<Vec<_>>()
    };
    [torque, entries, (0..6).flat_map(row).collect()]
}

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
    let request = robot::read(&entries(&all)).expect("a request");
    let robot = request.robot(text).expect("a robot");
    let code = code(&request, &robot);
    (Instance::new(&code, &[]).expect("no parameters"), robot)
}

fn close(found: &[f64], expected: &[f64], most: f64) -> bool {
    let size = expected.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= most * size)
}

#[test]
fn a_tree_obeys_lagranges_equations() {
    let joints = tree();
    for (precision, most) in [("f64", 1e-13), ("f32", 2e-5)] {
        let gravity = GRAVITY.map(|own| own.to_string()).join(", ");
        let keys =
            [("tip", "link8, link5"), ("gravity", gravity.as_str()), ("precision", precision)];
        let all = [&keys[..], &[("what", "inverse-dynamics, mass-matrix")]].concat();
        let mut given = vec![("urdf", "test.urdf")];
        given.extend(all);
        let request = robot::read(&entries(&given)).expect("a request");
        let robot = request.robot(&urdf(&joints)).expect("a robot");
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
fn a_chain_has_the_jacobian_of_its_tip() {
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

/// Replaces a part of the file of the tree, and tries to read it.
fn refused(from: &str, to: &str, keys: &[(&str, &str)]) -> String {
    let text = urdf(&tree());
    assert!(text.contains(from), "{from}");
    let given = [&[("urdf", "test.urdf"), ("what", "inverse-dynamics")], keys].concat();
    let request = robot::read(&entries(&given)).expect("a request");
    let found = request.robot(&text.replacen(from, to, 1)).expect_err("a mistake");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(!found[0].help.is_empty());
    found[0].message.clone()
}

#[test]
fn mistakes_of_a_file_are_named_with_their_line() {
    let joint = "<joint name=\"joint1\" type=\"revolute\">";
    let parent = "<parent link=\"link0\"/>";
    for (from, to, expected) in [
        (
            joint,
            "<joint name=\"joint1\" type=\"floating\">",
            "test.urdf, line 5: joint `joint1` is floating, which is not supported",
        ),
        (
            joint,
            "<joint name=\"joint1\" type=\"planar\">",
            "test.urdf, line 5: joint `joint1` is planar, which is not supported",
        ),
        (
            joint,
            "<joint name=\"joint1\" type=\"ball\">",
            "test.urdf, line 5: joint `joint1` has the unknown type `ball`",
        ),
        (
            parent,
            "<mimic joint=\"joint2\"/><parent link=\"link0\"/>",
            "test.urdf, line 5: joint `joint1` mimics `joint2`, which is not supported",
        ),
        (
            parent,
            "<parent link=\"link3\"/>",
            "test.urdf, line 5: link `link1` is in a loop of joints",
        ),
        (
            "<link name=\"link0\"/>",
            "<link name=\"link0\"/><link name=\"other\"/>",
            "test.urdf: no joint connects the links link0, other",
        ),
        (
            parent,
            "<parent link=\"nothing\"/>",
            "test.urdf, line 5: joint `joint1` names the unknown link `nothing`",
        ),
        (
            "<child link=\"link2\"/>",
            "<child link=\"link1\"/>",
            "test.urdf, line 7: link `link1` is moved by `joint1` and by `joint2`: a loop",
        ),
        (
            "<axis xyz=\"0 0 1\"/>",
            "<axis xyz=\"0 0 0\"/>",
            "test.urdf, line 5: the axis of joint `joint1` is 0",
        ),
        (
            "<axis xyz=\"0 0 1\"/>",
            "<axis xyz=\"0 0\"/>",
            "test.urdf, line 5: xyz = \"0 0\" of <axis> is not three numbers",
        ),
        (
            "<mass value=\"4\"/>",
            "<mass value=\"heavy\"/>",
            "test.urdf, line 4: value = \"heavy\" of <mass> is not a number",
        ),
        (
            "<mass value=\"4\"/>",
            "<mass value=\"-4\"/>",
            "test.urdf, line 4: the mass of link `link1` is negative",
        ),
        ("<mass value=\"4\"/>", "", "test.urdf, line 4: the inertia of link `link1` has no <mass>"),
        (
            "<link name=\"link2\">",
            "<link name=\"link1\">",
            "test.urdf, line 6: there are two links called `link1`",
        ),
        (
            "<robot name=\"test\">",
            "<model><robot/>",
            "test.urdf: it is not well-formed XML: expected 'model' tag, not 'robot' at 20:1",
        ),
    ] {
        assert_eq!(refused(from, to, &[]), expected);
    }
    let message = refused("link0", "link0", &[("tip", "link9")]);
    assert_eq!(message, "test.urdf: there is no link `link9`, which `tip` names");
    let message = refused("link0", "link0", &[("base", "link5"), ("tip", "link2")]);
    assert_eq!(message, "test.urdf: `link2` is not carried by `link5`");
    let message = refused("link0", "link0", &[("base", "link8")]);
    assert_eq!(message, "test.urdf: no joint moves between `link8` and its end");
}

#[test]
fn a_loop_of_joints_hangs_at_no_root() {
    let from = "<joint name=\"joint4\" type=\"continuous\"><parent link=\"link3\"/>";
    let to = "<joint name=\"joint4\" type=\"continuous\"><parent link=\"link5\"/>";
    assert_eq!(refused(from, to, &[]), "test.urdf, line 11: link `link4` is in a loop of joints");
}

#[test]
fn a_body_without_inertia_is_refused_by_its_joint() {
    let text = urdf(&tree()[..1]);
    let start = text.find("<inertial>").expect("an inertia");
    let end = text.find("</inertial>").expect("its end") + "</inertial>".len();
    let text = format!("{}{}", &text[..start], &text[end..]);
    let of = |what: &str| {
        let request =
            robot::read(&entries(&[("urdf", "test.urdf"), ("what", what)])).expect("a request");
        request.robot(&text)
    };
    let found = of("mass-matrix").expect_err("no inertia");
    assert_eq!(found[0].message, "test.urdf: what joint `joint1` moves has no inertia");
    assert!(of("jacobian").is_ok(), "the Jacobian needs no inertia");
}

#[test]
fn mistakes_of_a_request_are_reported_at_once() {
    let given = [
        ("urdf", "a.urdf"),
        ("what", "inverse-dynamic"),
        ("gravity", "9.81"),
        ("n", "3"),
        ("guard", "half"),
    ];
    let found = robot::read(&entries(&given)).expect_err("mistakes");
    let messages: Vec<_> = found.iter().map(|own| own.message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "`n` beside `urdf`",
            "what = inverse-dynamic of a robot",
            "gravity = 9.81",
            "guard = half is not one of full, result, none",
        ]
    );
    assert_eq!(found[1].help, "did you mean inverse-dynamics?");
    let found = robot::read(&entries(&[("urdf", "a.urdf")])).expect_err("no function");
    assert_eq!(found[0].code, "missing-key");
}
