//! Costs of deadlines in flight: instructions of a step and of `soonest`, its time, and bytes of code.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use ptc_codegen::compare::{Nominal, soonest};
use ptc_codegen::program::range::Range;
use serde::{Deserialize, Serialize};

use super::draw::Draw;
use super::driver::driver;
use super::scenes::designed;
use crate::case::{Case, VARIANTS};
use crate::failure::{Failure, Result};
use crate::tools::{run, scratch};
use crate::{c, callgrind};

/// Random states.
pub(super) const STATES: usize = 1000;

/// Rounds over all states that are timed, of which the quickest counts.
pub(super) const ROUNDS: usize = 50;

/// Keys of a deadline that stays, of one that is put off, and of one that is planned at every sample.
const DEADLINES: [&str; 3] = ["", "late = \"extend\"\n", "late = \"extend\"\npace = \"soonest\"\n"];

/// Flags that choose the machine on which bytes count.
const CORTEX_M7: [&str; 4] = ["-mthumb", "-mcpu=cortex-m7", "-mfloat-abi=hard", "-mfpu=fpv5-d16"];

/// Costs of an order and a weight.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Cost {
    pub(crate) n: usize,
    pub(crate) weight: usize,
    /// Mean instructions of a step to a fixed deadline, one that is put off, and one that is planned at every sample.
    pub(crate) steps: [f64; 3],
    /// Mean instructions of `soonest`.
    pub(crate) soonest: f64,
    /// Mean time of `soonest` in s.
    pub(crate) time: f64,
    /// Bytes of code on a Cortex-M7 of a fixed deadline and of one that is put off; `None` without its compiler.
    pub(crate) code: Option<[u64; 2]>,
}

/// Measures orders 2 to 4.
pub(super) fn measure() -> Result<Vec<Cost>> {
    let folder = scratch("flight")?;
    let kinds: Vec<_> = (2..=4).flat_map(|n| [0, 1].map(|weight| (n, weight))).collect();
    let cases = kinds
        .iter()
        .flat_map(|(n, weight)| (0..DEADLINES.len()).map(move |index| case(*n, *weight, index)));
    let cases = cases.collect::<Result<Vec<_>>>()?;
    c::compile(&cases, &folder)?;
    let program = c::link(&driver(&cases), &cases, &[], &folder)?;
    let profile = callgrind::profile(&program, &["count"], &program.with_extension("callgrind"))?;
    let printed = run(&mut Command::new(&program))?;
    let times: Vec<f64> = printed.lines().filter_map(|line| line.parse().ok()).collect();
    let of_kind = |(((n, weight), cases), time): ((&(usize, usize), &[Case]), &f64)| {
        let of = |case: &Case, function: &str| {
            profile.of(&format!("{}_{function}", case.name())).map(callgrind::Cost::mean)
        };
        let [fixed, extend, planned] = cases else { return Err(Failure::new("a case is missing")) };
        Ok(Cost {
            n: *n,
            weight: *weight,
            steps: [of(fixed, "step")?, of(extend, "step")?, of(planned, "step")?],
            soonest: of(extend, "soonest")?,
            time: *time,
            code: code(fixed, &folder).zip(code(extend, &folder)).map(|(a, b)| [a, b]),
        })
    };
    kinds.iter().zip(cases.chunks(3)).zip(&times).map(of_kind).collect()
}

fn case(n: usize, weight: usize, index: usize) -> Result<Case> {
    let keys = DEADLINES[index];
    let (spec, _) = designed(&format!(
        "name = \"flight_n{n}_w{weight}_{index}\"\nn = {n}\nmu = \"exp(a=1)\"\nclock = \"samples\"\n\
         sample_time = 1e-3\npoles = \"least-energy(weight={weight})\"\n{keys}\
         [params]\ntau = 0.8\neps = 0\nu_max = 60\n"
    ))?;
    Ok(Case { variant: VARIANTS[0], spec })
}

/// Bytes of code and constants of a controller on a Cortex-M7; `None` if its compiler is not installed.
fn code(case: &Case, folder: &Path) -> Option<u64> {
    let name = case.name();
    let mut gcc = Command::new("arm-none-eabi-gcc");
    gcc.current_dir(folder).args(CORTEX_M7);
    let object = format!("{name}.arm.o");
    run(gcc.args(["-std=c99", "-Os", "-c", &format!("{name}.c"), "-o", &object])).ok()?;
    let sizes = run(Command::new("arm-none-eabi-size").current_dir(folder).arg(&object)).ok()?;
    sizes.lines().nth(1)?.split_whitespace().next()?.parse().ok()
}

/// Mean time in s in which Ruckig plans the shortest profile of order 3 from these states.
pub(super) fn plan() -> Result<f64> {
    let nominal = Nominal::of(&case(3, 0, 1)?.spec);
    let nominal = nominal.map_err(|wrong| Failure::new(wrong.to_string()))?;
    let mut draw = Draw::default();
    let states: Vec<_> = (0..STATES).map(|_| [0; 3].map(|_| draw.even(-0.3, 0.3))).collect();
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let found = states.iter().filter_map(|x| soonest(&nominal, Range::symmetric(60.0), x).ok());
        if found.sum::<f64>() <= 0.0 {
            return Err(Failure::new("no profile was planned"));
        }
        least = least.min(start.elapsed().as_secs_f64() / STATES as f64);
    }
    Ok(least)
}
