//! Time to rest with deadlines that are planned in flight, against the least time that any input takes, and against a
//! profile of that length which an observer and a feedback follow.

use ptc_codegen::plant::Plant;
use ptc_codegen::simulate::Values;
use serde::{Deserialize, Serialize};

use super::draw::Draw;
use super::scene::{AT_ONCE, Scene};
use super::scenes::{Stage, designed, disturbances};
use crate::failure::{Result, While};
use crate::tools::{parallel, workspace};

/// Random states of a known chain.
const STATES: usize = 60;

/// Random positions of the stage, each with every disturbance.
const POSITIONS: usize = 20;

/// Values of `pace`.
const PACES: [&str; 2] = ["deadline", "soonest"];

/// Parts of the limits that plans on the stage leave.
const RESERVES: [&str; 3] = ["0.1", "0.2", "0.35"];

/// A controller, and its runs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Arrival {
    /// The chain or the stage that it moves.
    pub(crate) plant: String,
    pub(crate) name: String,
    pub(crate) runs: usize,
    /// Time to rest in parts of the least one: median and worst.
    pub(crate) time: [f64; 2],
    /// |x1| in m at the deadline that it keeps: median and worst.
    pub(crate) error: [f64; 2],
    /// Largest |u| in parts of the limit.
    pub(crate) peak: f64,
    /// Runs in which the limit cuts u.
    pub(crate) clipped: usize,
}

/// Measures all of them: on chains that are known, then on the stage.
pub(super) fn measure() -> Result<Vec<Arrival>> {
    let chains = [2, 3].into_iter().flat_map(|n| {
        let ours = [0, 1, 2]
            .into_iter()
            .flat_map(move |weight| PACES.map(move |pace| (n, weight, pace, true)));
        ours.chain([(n, 0, "deadline", false)])
    });
    let chains: Vec<_> = chains.collect();
    let mut all = parallel(&chains, |(n, weight, pace, is_ours)| {
        let scene = chain(*n, *weight, pace)?;
        let name = format!("weight {weight}, {}", about(pace));
        let plant = format!("chain, n = {n}");
        if *is_ours { scene.ours(&plant, &name) } else { scene.rival(&plant) }
    })?;
    all.extend(stages()?);
    Ok(all)
}

/// Returns the words of the page for a pace.
fn about(pace: &str) -> &'static str {
    if pace == "soonest" { "planned at every sample" } else { "kept" }
}

/// A chain that is known exactly, all of whose states are measured.
fn chain(n: usize, weight: usize, pace: &str) -> Result<Scene> {
    let (spec, _) = designed(&format!(
        "n = {n}\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\nlate = \"extend\"\npace = \"{pace}\"\n\
         poles = \"least-energy(weight={weight})\"\n[params]\neps = 0\nu_max = 10\n"
    ))?;
    let plant = Plant::default();
    let known = Values::of(&spec, &plant);
    let mut draw = Draw::default();
    let motions = (0..STATES).map(|_| {
        let start = (0..n).map(|_| draw.even(-1.0, 1.0)).collect();
        (start, vec![(vec![1.0, 0.0], known.clone())])
    });
    Scene::new(spec, plant, motions.collect())
}

/// The stage with its disturbances: ours with each pace, each also with the deadline fixed to the times that it takes, and
/// the follower.
fn stages() -> Result<Vec<Arrival>> {
    let path = workspace().join("bench/moves/flight.toml");
    let text = std::fs::read_to_string(&path).while_doing(path.display())?;
    let fixed = stage(&text)?;
    let mut all = Vec::new();
    for reserve in RESERVES {
        let plant = format!("stage, reserve {reserve}");
        let with = |pace: &str| {
            let keys = format!("late = \"extend\"\nreserve = {reserve}\npace = \"{pace}\"\n");
            stage(&(keys + &text))
        };
        for pace in PACES {
            let own = with(pace)?;
            let runs = own.runs(&mut own.controller()?, &|_| AT_ONCE)?;
            let same = fixed.runs(&mut fixed.controller()?, &|index| runs[index].samples)?;
            all.push(own.worst(&plant, about(pace), &runs));
            all.push(fixed.worst(&plant, "fixed to these times", &same));
        }
        all.push(with("deadline")?.rival(&plant)?);
    }
    Ok(all)
}

fn stage(text: &str) -> Result<Scene> {
    let Stage { spec, plant } = Stage::of(text)?;
    let all = disturbances(&Stage { spec: spec.clone(), plant: plant.clone() })?;
    let mut draw = Draw::default();
    let positions: Vec<_> = (0..POSITIONS)
        .map(|_| {
            let side = if draw.even(-1.0, 1.0) < 0.0 { -0.2 } else { 0.2 };
            side * 10f64.powf(draw.even(-1.0, 0.0))
        })
        .collect();
    let motions =
        positions.iter().flat_map(|x| all.iter().map(move |own| (vec![*x, 0.0], own.clone())));
    let motions = motions.collect();
    Scene::new(spec, plant, motions)
}
