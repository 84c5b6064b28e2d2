//! `models`: a step of designs with a model of the plant, beside the C of tools that are given the same
//! plant: the files that bench/peers/models.py writes, each with a function `ptc_model(x, t, u)`.

mod driver;

use std::path::{Path, PathBuf};
use std::process::Command;

use ptc_codegen::design;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::{Entry, read};
use ptc_codegen::syntax::parse;
use serde::{Deserialize, Serialize};

use crate::case::{Case, VARIANTS};
use crate::failure::{Failure, Result, While};
use crate::peers::OURS;
use crate::tools::{run, scratch, workspace};
use crate::{c, callgrind};

use driver::{difference, driver, values};

/// A design of examples/, and what is set beside it: all parameters are numbers, as the peers have them.
struct Design {
    name: &'static str,
    tau: f64,
    outputs: usize,
    /// Factors that scale the states of the calls, drawn in -2..2.
    scale: &'static [f64],
    set: &'static [(&'static str, &'static str)],
}

const DESIGNS: [Design; 5] = [
    Design { name: "drive", tau: 0.4, outputs: 1, scale: &[0.5, 2.0, 1.0], set: &[] },
    Design { name: "pendulum", tau: 0.8, outputs: 1, scale: &[1.0, 1.0], set: &[] },
    Design {
        name: "cart",
        tau: 2.0,
        outputs: 1,
        scale: &[0.5, 0.5, 0.5, 1.0],
        set: &[("allow", "zeros")],
    },
    Design {
        name: "levitation",
        tau: 0.5,
        outputs: 1,
        scale: &[1e-3, 0.1, 0.1],
        set: &[
            ("params.z0", "0.01"),
            ("params.i0", "0.8"),
            ("params.R", "2"),
            ("params.L", "0.02"),
        ],
    },
    Design { name: "two_link", tau: 20.0, outputs: 2, scale: &[1.0; 4], set: &[] },
];

/// Largest relative difference of u that is no other law.
const SAME: f64 = 1e-12;

/// One contestant at one design.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Model {
    pub(crate) design: String,
    pub(crate) name: String,
    /// Mean instructions of a call.
    pub(crate) step: f64,
    /// Instructions that divide, in the code.
    pub(crate) divisions: usize,
    /// Bytes of code.
    pub(crate) text: u64,
    /// Largest relative difference of u from ours.
    pub(crate) difference: f64,
    /// Name and version of the tool, for a peer.
    pub(crate) version: Option<String>,
}

struct Peer {
    design: usize,
    name: String,
    version: String,
    symbol: String,
    object: PathBuf,
}

/// Measures what lies in `contestants`, or where models.py writes, beside ours.
pub(crate) fn measure(contestants: Option<&Path>) -> Result<Vec<Model>> {
    callgrind::available()?;
    let written = workspace().join("bench/peers/contestants");
    let folder = scratch("models")?;
    let cases = DESIGNS.iter().map(case).collect::<Result<Vec<_>>>()?;
    let sizes = c::compile(&cases, &folder)?;
    let peers = compile(contestants.unwrap_or(&written), &folder)?;
    if peers.is_empty() {
        println!("models: ours alone; bench/peers/models.py writes the others, and tells how");
    }
    let objects: Vec<_> = peers.iter().map(|peer| peer.object.clone()).collect();
    let program = c::link(&driver(&peers), &cases, &objects, &folder)?;
    let values = values(&run(&mut Command::new(&program))?)?;
    let profile = callgrind::profile(&program, &[], &folder.join("callgrind"))?;
    let mut found = Vec::new();
    for (at, (design, case)) in DESIGNS.iter().zip(&cases).enumerate() {
        let step = format!("{}_step", case.name());
        let ours = values.get(&step).ok_or_else(|| Failure::new(format!("no {step}")))?;
        found.push(Model {
            design: design.name.to_owned(),
            name: OURS.to_owned(),
            step: profile.of(&step)?.mean(),
            divisions: divisions(&folder.join(format!("{}.o", case.name())), Some(&step))?,
            text: sizes[at].text,
            difference: 0.0,
            version: None,
        });
        for peer in peers.iter().filter(|peer| peer.design == at) {
            let theirs = values.get(&peer.symbol).map_or(&[][..], Vec::as_slice);
            let difference = difference(ours, theirs);
            if difference > SAME {
                let (name, design) = (&peer.name, design.name);
                return Err(Failure::new(format!("{name}, {design}: u differs by {difference:e}")));
            }
            found.push(Model {
                design: design.name.to_owned(),
                name: peer.name.clone(),
                step: profile.of(&peer.symbol)?.mean(),
                divisions: divisions(&peer.object, None)?,
                text: c::symbol_sizes(&peer.object)?.values().sum(),
                difference,
                version: Some(peer.version.clone()),
            });
        }
    }
    Ok(found)
}

/// The design with its numbers, without limits and guards, held at a time-to-go that no call reaches.
fn case(design: &Design) -> Result<Case> {
    let path = workspace().join(format!("examples/{}.toml", design.name));
    let text = std::fs::read_to_string(&path).while_doing(path.display())?;
    let (mut entries, wrong) = design::read(&text, &mut |_| Place(0));
    if !wrong.is_empty() {
        return Err(Failure::new(format!("{}: {wrong:?}", path.display())));
    }
    let (tau, eps) = (design.tau.to_string(), (0.01 * design.tau).to_string());
    let common = [("tau", &*tau), ("eps", &*eps), ("t0", "0"), ("u_max", "inf"), ("guard", "none")];
    for (key, text) in common.iter().chain(design.set) {
        let value = parse(key, text, &mut |_| Place(0));
        let value = value.map_err(|found| Failure::new(format!("{key} = {text}: {found:?}")))?;
        entries.retain(|entry| entry.key != *key && entry.key != "limits");
        entries.push(Entry { key: (*key).to_owned(), place: Place(0), value });
    }
    let spec = read(&entries);
    let spec = spec.map_err(|found| Failure::new(format!("{}: {found:?}", path.display())))?;
    Ok(Case { variant: VARIANTS[0], spec })
}

/// Compiles every peer's file of every design, each function under a name of its own.
fn compile(contestants: &Path, folder: &Path) -> Result<Vec<Peer>> {
    let mut names: Vec<_> = match std::fs::read_dir(contestants) {
        Ok(names) => names.filter_map(|name| name.ok()?.file_name().into_string().ok()).collect(),
        Err(_) => return Ok(Vec::new()),
    };
    names.sort();
    let mut peers = Vec::new();
    for (design, Design { name: of, .. }) in DESIGNS.iter().enumerate() {
        for name in &names {
            let source = contestants.join(name).join(format!("model_{of}.c"));
            let Ok(text) = std::fs::read_to_string(&source) else { continue };
            let version = text.lines().next().unwrap_or_default();
            let version = version.trim_matches(|c| "/* ".contains(c)).to_owned();
            let symbol = format!("peer_{name}_{of}");
            let object = folder.join(format!("{symbol}.o"));
            let mut gcc = Command::new("gcc");
            run(gcc.args(c::FLAGS).args(["-w", "-c"]).arg(&source).arg("-o").arg(&object))?;
            run(Command::new("objcopy").arg("--keep-global-symbol=ptc_model").arg(&object))?;
            let renamed = format!("--redefine-sym=ptc_model={symbol}");
            run(Command::new("objcopy").arg(renamed).arg(&object))?;
            peers.push(Peer { design, name: name.clone(), version, symbol, object });
        }
    }
    Ok(peers)
}

/// Instructions that divide in `function` of an object, or in all of it.
fn divisions(object: &Path, function: Option<&str>) -> Result<usize> {
    let mut objdump = Command::new("objdump");
    objdump.args(["-d", "--no-show-raw-insn"]);
    objdump.args(function.map(|name| format!("--disassemble={name}")));
    let listing = run(objdump.arg(object))?;
    Ok(listing.split_whitespace().filter(|word| matches!(*word, "divsd" | "divpd")).count())
}
