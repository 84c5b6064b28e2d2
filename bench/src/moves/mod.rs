//! `moves`: motions to rest of a linear stage with an unknown load, by designs of ours and by the controllers that
//! `ptc-codegen compare` knows.

mod arrivals;
mod costs;
mod draw;
mod driver;
mod emitted;
mod scene;
mod scenes;

use std::path::PathBuf;

use ptc_codegen::compare::{Entrants, Figures, Nominal, Operations, measured};
use ptc_codegen::simulate::{Control, Process};
use serde::{Deserialize, Serialize};

use crate::case::{Case, VARIANTS};
use crate::failure::{Failure, Result};
use crate::tools::{parallel, scratch, workspace};
use crate::{c, callgrind};

pub(crate) use arrivals::Arrival;
pub(crate) use costs::Cost;

use emitted::Emitted;
use scenes::{Stage, settings};

/// Our designs: their names in the table, and their files.
const DESIGNS: [(&str, &str); 6] = [
    ("the README's stage", "examples/encoder.toml"),
    ("least energy, held at 10, stationary observer", "bench/moves/least_energy.toml"),
    ("soft end from 250, calm stationary observer", "bench/moves/soft_calm.toml"),
    ("soft end from 250, quick stationary observer", "bench/moves/soft_quick.toml"),
    ("soft end from 400, fast prescribed observer", "bench/moves/soft_fast.toml"),
    ("order 3, steeper from 250", "bench/moves/extended.toml"),
];

/// A controller, and the worst of its motions.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Move {
    pub(crate) name: String,
    /// True for a design of ours.
    pub(crate) ours: bool,
    /// |x1| at the deadline in m.
    pub(crate) error: f64,
    /// Largest |u| in N.
    pub(crate) peak: f64,
    /// Energy in N^2 s.
    pub(crate) energy: f64,
    /// Ripple after the deadline in N.
    pub(crate) ripple: f64,
    /// Products and sums of a step.
    pub(crate) operations: usize,
    /// Mean instructions of a step; `None` for a rival, which has no C.
    pub(crate) instructions: Option<f64>,
}

/// Figures of `moves`.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Measured {
    /// Motions of a fixed length.
    pub(crate) moves: Vec<Move>,
    /// Motions with deadlines in flight.
    pub(crate) arrivals: Vec<Arrival>,
    /// Costs of these deadlines.
    pub(crate) costs: Vec<Cost>,
    /// Mean time in s in which Ruckig plans a profile of order 3.
    pub(crate) plan: f64,
}

/// Measures all of it.
pub(crate) fn measure() -> Result<Measured> {
    callgrind::available()?;
    let arrivals = arrivals::measure()?;
    Ok(Measured { moves: moves()?, arrivals, costs: costs::measure()?, plan: costs::plan()? })
}

fn moves() -> Result<Vec<Move>> {
    let folder = scratch("moves")?;
    let stages = DESIGNS.map(|(_, path)| Stage::read(&workspace().join(path)));
    let stages = stages.into_iter().collect::<Result<Vec<_>>>()?;
    let cases: Vec<_> = stages
        .iter()
        .map(|stage| Case { variant: VARIANTS[0], spec: stage.spec.clone() })
        .collect();
    c::compile(&cases, &folder)?;
    let all: Vec<_> = stages.iter().zip(&cases).zip(DESIGNS).collect();
    let mut found = parallel(&all, |((stage, case), (name, _))| {
        let home = folder.join(case.name());
        std::fs::create_dir_all(&home)?;
        ours(name, stage, emitted::link(case, &folder, &home)?)
    })?;
    // The rivals know the plant alone, which all designs share.
    if let Some(stage) = stages.first() {
        found.extend(rivals(stage)?);
    }
    Ok(found)
}

fn ours(name: &str, stage: &Stage, program: PathBuf) -> Result<Move> {
    let step = format!("{}_step", stage.spec.name());
    let profile = callgrind::profile(&program, &["count"], &program.with_extension("callgrind"))?;
    let operations = Operations::of(&stage.spec);
    let worst = worst(stage, &mut Emitted::new(program))?;
    let instructions = Some(profile.of(&step)?.mean());
    Ok(Move { ours: true, instructions, ..row(name, &worst, operations) })
}

fn rivals(stage: &Stage) -> Result<Vec<Move>> {
    let nominal = Nominal::of(&stage.spec).map_err(|wrong| Failure::new(wrong.to_string()))?;
    let entrants = Entrants::new(&stage.spec, &nominal, None);
    let entrants = entrants.map_err(|wrong| Failure::new(wrong.to_string()))?;
    let rivals = entrants.all.into_iter().skip(1).map(|mut own| {
        let worst = worst(stage, &mut own.control)?;
        let bandwidth = own.bandwidth.unwrap_or(f64::NAN);
        let name = format!("{} ({bandwidth:.0} rad/s)", own.name);
        Ok(row(&name, &worst, own.operations))
    });
    rivals.collect()
}

/// The worst figures of a controller in all scenarios.
fn worst(stage: &Stage, control: &mut dyn Control) -> Result<Figures> {
    let failed = |wrong: ptc_codegen::simulate::Failure| Failure::new(wrong.to_string());
    let nominal = Nominal::of(&stage.spec).map_err(failed)?;
    let mut process = Process::new(&stage.spec, &stage.plant);
    let mut worst = Figures::default();
    for setting in settings(stage)? {
        let own = measured(&mut process, control, &setting, (&nominal, 0.0)).map_err(failed)?;
        worst = worst.worst(own);
    }
    Ok(worst)
}

fn row(name: &str, worst: &Figures, operations: Operations) -> Move {
    Move {
        name: name.to_owned(),
        ours: false,
        error: worst.error.first().copied().unwrap_or(f64::NAN),
        peak: worst.peak,
        energy: worst.energy,
        ripple: worst.ripple,
        operations: operations.count(),
        instructions: None,
    }
}
