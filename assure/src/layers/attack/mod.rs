//! The command under attack: killed, started twice, with damaged files, full disks and odd outputs.

mod corruption;
mod disk;
mod injection;
mod inputs;
mod kill;
mod memory;
mod outputs;
mod owners;
mod power;
mod readings;
mod streams;
mod world;

use anyhow::Result;

use crate::context::Context;
use crate::layer::{Finding, Layer, Table};
use world::World;

pub(super) const LAYER: Layer = Layer {
    name: "attack",
    claim: "A campaign that is killed at any instant resumes to the bytes, verdict and exit code of \
            one run, and so does one whose rows under way a power cut left torn or zero; one process at a \
            time has it; every flipped bit of its files is reported; and a full disk, a read-only folder, devices, links and colliding outputs lose no file. Every \
            input ends in 4 s and 500 MB, with output or a message and a documented exit code; long runs fit \
            into 500 MB, and threads that cannot be had and full outputs end no work silently. A reading that is wild or lost leads no observer with a gate astray. No text of \
            a design is read as code in an emitted file, or as an element in a report.",
    tools: &[],
    run,
};

/// One kind of attack: it says what was done, and records what went wrong.
type Attack = fn(&World, &mut Finding) -> Result<String>;

/// All of them, by name.
const ATTACKS: &[(&str, Attack)] = &[
    ("injection", injection::attack),
    ("kills", kill::attack),
    ("owners", owners::attack),
    ("damage", corruption::attack),
    ("power", power::attack),
    ("disk", disk::attack),
    ("outputs", outputs::attack),
    ("streams", streams::attack),
    ("memory", memory::attack),
    ("readings", readings::attack),
    ("inputs", inputs::attack),
];

fn run(context: &Context) -> Result<Finding> {
    let world = World::new(context)?;
    let mut finding = Finding::default();
    let mut rows = Vec::new();
    for (name, attack) in ATTACKS {
        let done = attack(&world, &mut finding)?;
        rows.push(vec![(*name).to_owned(), done]);
    }
    let all: Vec<_> = rows.iter().map(|row| row[1].as_str()).collect();
    finding.summary = all.join("; ");
    finding.tables.push(Table { title: "Attacks".to_owned(), head: vec!["", "done"], rows });
    Ok(finding)
}
