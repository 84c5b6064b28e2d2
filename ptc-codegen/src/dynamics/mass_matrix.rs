//! The mass matrix: composite rigid bodies.

use super::model::{Joint, Joints, Model};
use super::tape::{Tape, Term};
use super::vector::{Matrix, Turn, Vector, known, known_matrix, zero};
use super::wrench::Wrench;
use crate::algebra::integer;
use crate::urdf::{Inertia, Motion, Placement};

/// Inertia of a body and of all that it carries, about the origin of its frame.
#[derive(Clone)]
struct Composite {
    mass: Term,
    first: Vector,
    second: Matrix,
}

/// The entries of the mass matrix, row by row.
pub(super) fn entries(tape: &mut Tape, model: &Model, joints: &Joints) -> Vec<Term> {
    let bodies = &model.bodies;
    let n = bodies.len();
    let mut composites: Vec<Composite> =
        bodies.iter().map(|body| Composite::of(&body.inertia)).collect();
    let mut entries = vec![Term::zero(); n * n];
    for (index, body) in bodies.iter().enumerate().rev() {
        let own = composites[index].clone();
        if let Some(parent) = body.parent {
            let moved = own.in_parent(tape, &joints.at(bodies, index));
            composites[parent] = composites[parent].clone().with(tape, &moved);
        }
        let mut wrench = own.unit(body.motion, tape);
        let mut at = index;
        loop {
            let mut entry = wrench.along(bodies[at].motion);
            if at == index {
                entry = tape.add(&entry, &Term::from(&body.drive.rotor));
            }
            entries[index * n + at] = entry.clone();
            entries[at * n + index] = entry;
            let Some(parent) = bodies[at].parent else { break };
            wrench = wrench.in_parent(tape, &joints.at(bodies, at));
            at = parent;
        }
    }
    entries
}

impl Composite {
    fn of(inertia: &Inertia) -> Self {
        Self {
            mass: Term::from(&inertia.mass),
            first: known(&inertia.first),
            second: known_matrix(&inertia.second),
        }
    }

    fn with(self, tape: &mut Tape, more: &Self) -> Self {
        Self {
            mass: tape.add(&self.mass, &more.mass),
            first: tape.add_vectors(&self.first, &more.first),
            second: std::array::from_fn(|i| tape.add_vectors(&self.second[i], &more.second[i])),
        }
    }

    /// Force and moment of a unit acceleration of the joint, without any velocity.
    fn unit(&self, motion: Motion, tape: &mut Tape) -> Wrench {
        let [x, y, _] = &self.first;
        match motion {
            Motion::Revolute => {
                let force = [-y.clone(), x.clone(), Term::zero()];
                let about = tape.add(&self.second[0][0], &self.second[1][1]);
                let moment = [-self.second[0][2].clone(), -self.second[1][2].clone(), about];
                Wrench { force, moment }
            }
            Motion::Prismatic => {
                let force = [Term::zero(), Term::zero(), self.mass.clone()];
                Wrench { force, moment: [y.clone(), -x.clone(), Term::zero()] }
            }
        }
    }

    /// The same inertia in the frame of the parent.
    fn in_parent(&self, tape: &mut Tape, joint: &Joint<'_>) -> Self {
        let own = match joint.turn {
            Some(turn) => Self {
                mass: self.mass.clone(),
                first: tape.turn(turn, &self.first),
                second: turned(tape, turn, &self.second),
            },
            None => self.shifted(tape, &joint.slide()),
        };
        let Placement { rotation, origin } = &joint.body.placement;
        let rotation = known_matrix(rotation);
        let first = tape.apply(&rotation, &own.first);
        // Columns of R S, which are rows of its transpose, as S is symmetric.
        let half: Matrix = own.second.each_ref().map(|row| tape.apply(&rotation, row));
        let rows: Matrix = std::array::from_fn(|i| half.each_ref().map(|own| own[i].clone()));
        let mut second: Matrix = std::array::from_fn(|_| zero());
        for i in 0..3 {
            for j in i..3 {
                let entry = tape.products(&[0, 1, 2].map(|k| (&rows[i][k], &rotation[j][k])));
                (second[i][j], second[j][i]) = (entry.clone(), entry);
            }
        }
        Self { mass: own.mass, first, second }.shifted(tape, &known(origin))
    }

    /// The same about a point that lies at `shift` in the opposite direction.
    fn shifted(&self, tape: &mut Tape, shift: &Vector) -> Self {
        let Self { mass, first, second } = self;
        let weight = shift.each_ref().map(|own| tape.mul(mass, own));
        let moved = tape.add_vectors(first, &weight);
        let mut all = second.clone();
        for i in 0..3 {
            for j in i..3 {
                let more = tape.products(&[(&shift[i], &moved[j]), (&first[i], &shift[j])]);
                let entry = tape.add(&second[i][j], &more);
                (all[i][j], all[j][i]) = (entry.clone(), entry);
            }
        }
        Self { mass: mass.clone(), first: moved, second: all }
    }
}

/// Second moments of a body that has turned about z.
fn turned(tape: &mut Tape, Turn { cosine, sine }: &Turn, second: &Matrix) -> Matrix {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = second;
    let (square, product) = (tape.mul(cosine, cosine), tape.mul(cosine, sine));
    let differ = tape.sub(xx, yy);
    let (twice_square, twice_product) = (tape.twice(&square), tape.twice(&product));
    let moved = tape.products(&[(&square, &differ), (&-twice_product, xy)]);
    let first = tape.add(yy, &moved);
    let last = tape.sub(xx, &moved);
    let cosine_of_twice = tape.sub(&twice_square, &Term::from(&integer(1)));
    let mixed = tape.products(&[(&product, &differ), (&cosine_of_twice, xy)]);
    let [x, y, _] = tape.turn(
        &Turn { cosine: cosine.clone(), sine: sine.clone() },
        &[xz.clone(), yz.clone(), Term::zero()],
    );
    [[first, mixed.clone(), x.clone()], [mixed, last, y.clone()], [x, y, zz.clone()]]
}
