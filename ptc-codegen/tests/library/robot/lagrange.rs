//! Lagrange's equations of a tree of joints, from the kinetic and potential energy of its links.

use super::dual::{self, Dual, Matrix, Vector};

/// A joint, and the link that it moves.
pub(super) struct Joint {
    pub(super) kind: &'static str,
    /// Place of its parent in the list, from 1; 0 for the base.
    pub(super) parent: usize,
    pub(super) origin: Vector<f64>,
    pub(super) angles: Vector<f64>,
    pub(super) axis: Vector<f64>,
    pub(super) mass: f64,
    pub(super) centre: Vector<f64>,
    pub(super) centre_angles: Vector<f64>,
    /// xx, yy, zz, xy, xz, yz about the centre.
    pub(super) inertia: [f64; 6],
}

pub(super) const GRAVITY: Vector<f64> = [0.4, -1.1, -9.7];

/// Two arms on a torso, with all kinds of joints, and frames in general position. Quarter turns are rounded as in files.
#[allow(clippy::approx_constant)]
pub(super) fn tree() -> Vec<Joint> {
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
pub(super) fn urdf(joints: &[Joint]) -> String {
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
pub(super) fn lagrange(joints: &[Joint], q: &[f64], v: &[f64], a: &[f64]) -> [Vec<f64>; 3] {
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
