//! `fma`: what fused products and sums save in C, beside the plain controllers.

use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Guard;
use serde::{Deserialize, Serialize};

use crate::calls::c_driver;
use crate::case::{Case, Key, ORDERS};
use crate::counts::{cases, works};
use crate::failure::Result;
use crate::tools::scratch;
use crate::{c, callgrind};

/// A controller of guard `none` in f64.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Fused {
    pub(crate) key: Key,
    /// Mean instructions of a `step` without `fma`, for a processor that has the instruction.
    pub(crate) plain: f64,
    /// The same with `fma`.
    pub(crate) fused: f64,
    /// The same for a processor without the instruction, which calls the library.
    pub(crate) called: f64,
}

/// Measures each of them.
pub(crate) fn measure() -> Result<Vec<Fused>> {
    callgrind::available()?;
    let plain = cases(Precision::F64, &ORDERS, &[Guard::None]);
    let mut fused = plain.clone();
    fused.iter_mut().for_each(|case| case.spec.fma = true);
    let with = ["-mfma"].as_slice();
    let plain_steps = steps("fma-plain", &plain, with)?;
    let fused_steps = steps("fma-fused", &fused, with)?;
    let called_steps = steps("fma-called", &fused, &[])?;
    let found = plain.iter().zip(plain_steps).zip(fused_steps).zip(called_steps);
    let one = |(((case, plain), fused), called): (((&Case, f64), f64), f64)| Fused {
        key: case.key("c"),
        plain,
        fused,
        called,
    };
    Ok(found.map(one).collect())
}

/// Mean instructions of `step`, compiled with these flags more.
fn steps(name: &str, cases: &[Case], flags: &[&str]) -> Result<Vec<f64>> {
    let folder = scratch(name)?;
    c::compile_with(cases, flags, &folder)?;
    let program = c::link(&c_driver(cases), cases, &[], &folder)?;
    works(&program)?;
    let profile = callgrind::profile(&program, &[], &program.with_extension("callgrind"))?;
    cases.iter().map(|case| Ok(profile.of(&format!("{}_step", case.name()))?.mean())).collect()
}
