//! The stage and its motions: three starts, three masses, steps of the force near the deadline, friction.

use std::path::Path;

use ptc_codegen::check::resolved::Resolved;
use ptc_codegen::design;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::parameter::{Name, Parameter};
use ptc_codegen::plant::{Plant, read_design};
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{Loop, Piece, Values};
use ptc_codegen::verify::Setting;

use crate::failure::{Failure, Result, While};

/// The true plant, in place of the 1.5 kg that the designs know.
const PLANT: &str = "
[plant]
f = \"(push - friction*x2)/mass\"
g = \"1/mass\"
push = 0.3                     # N
friction = 0                   # N s/m
mass = 1.5                     # kg
";

/// Position in m and speed in m/s at the start: at rest, as the others need it.
const STARTS: [[f64; 2]; 3] = [[0.1, 0.0], [0.05, 0.0], [-0.03, 0.0]];

/// Masses in kg: the known one and 20 % less and more.
const MASSES: [f64; 3] = [1.5, 1.2, 1.8];

/// A step of the force in N, and its times in parts of the motion.
const STEP: f64 = 0.5;
const TIMES: [f64; 3] = [0.5, 0.875, 0.95];

/// Viscous friction in N s/m.
const FRICTION: f64 = 2.0;

/// A design with the true plant.
pub(super) struct Stage {
    pub(super) spec: Spec,
    pub(super) plant: Plant,
}

impl Stage {
    /// Reads the design of a file.
    pub(super) fn read(path: &Path) -> Result<Self> {
        let read = Self::of(&std::fs::read_to_string(path).while_doing(path.display())?);
        read.map_err(|wrong| Failure::new(format!("{}: {}", path.display(), wrong.message)))
    }

    /// Reads a design of the stage.
    pub(super) fn of(text: &str) -> Result<Self> {
        let (spec, plant) = designed(&format!("{text}{PLANT}"))?;
        let plant = plant.ok_or_else(|| Failure::new("no plant"))?;
        Ok(Self { spec, plant })
    }
}

/// Reads a design, and its plant where the text has one.
pub(super) fn designed(text: &str) -> Result<(Spec, Option<Plant>)> {
    let wrong = |found| Failure::new(format!("{found:?}"));
    let (entries, found) = design::read(text, &mut |_| Place(0));
    if !found.is_empty() {
        return Err(wrong(found));
    }
    let (spec, plant) = read_design(&entries).map_err(wrong)?;
    Ok((Resolved::of(&spec).spec, plant))
}

/// Returns what a motion may meet: other masses, a step of the force, friction.
pub(super) fn disturbances(stage: &Stage) -> Result<Vec<Vec<Piece>>> {
    let known = Values::of(&stage.spec, &stage.plant);
    let [push, friction, mass] = ["push", "friction", "mass"].map(Name::new);
    let all = push.zip(friction).zip(mass);
    let ((push, friction), mass) = all.ok_or_else(|| Failure::new("no such name"))?;
    let with = |name: Name, value: f64| known.clone().with(Parameter::Named(name), value);
    let whole = |values: Values| vec![(vec![1.0, 0.0], values)];
    let mut cases: Vec<_> = MASSES.iter().map(|own| whole(with(mass, *own))).collect();
    let force = known.get(Parameter::Named(push)) + STEP;
    cases.extend(
        TIMES.iter().map(|time| {
            vec![(vec![1.0, 1.0 - time], known.clone()), (vec![0.0], with(push, force))]
        }),
    );
    cases.push(whole(with(friction, FRICTION)));
    Ok(cases)
}

/// Returns the scenarios of a design.
pub(super) fn settings(stage: &Stage) -> Result<Vec<Setting>> {
    let known = Values::of(&stage.spec, &stage.plant);
    let around = Loop::of(&stage.spec);
    let setting = |(pieces, x0): (&Vec<Piece>, &[f64; 2])| Setting {
        values: first(pieces, &known),
        x0: x0.to_vec(),
        pieces: pieces.clone(),
        around: around.clone(),
    };
    let cases = disturbances(stage)?;
    let all = cases.iter().flat_map(|pieces| STARTS.iter().map(move |x0| (pieces, x0)));
    Ok(all.map(setting).collect())
}

/// The values with which a run begins.
pub(super) fn first(pieces: &[Piece], known: &Values) -> Values {
    pieces.first().map_or_else(|| known.clone(), |(_, values)| values.clone())
}
