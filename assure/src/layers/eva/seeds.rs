//! Defects in emitted C, each of which has to raise an alarm.

use std::path::Path;

use anyhow::Result;
use ptc_codegen::family::Family;
use ptc_codegen::request::Spec;

use super::{MODES, analyse};
use crate::context::Context;
use crate::harness::{empty, in_pairs, in_samples, write_with_proof};
use crate::layer::Finding;
use crate::layers::seeded::{Defect, put_in};

/// Defects of the example, and the mode in which each is seen.
const DEFECTS: [(Defect, usize); 10] = [
    ((" && PTC_FINITE_F64(x[0])", "", "the guard of x1 left out"), 0),
    (
        (
            "if (t >= self->t0) {",
            "if (t >= (self->t0 - (4.0 * self->tau))) {",
            "the guard of t0 left out",
        ),
        1,
    ),
    (("&& (x != NULL)", "", "the check of x for NULL left out"), 0),
    (("        *u = 0.0;\n", "        ;\n", "u not set to 0 first"), 0),
    (("(v < -self->u_max)", "(v < (-2.0 * self->u_max))", "the lower clamp too low"), 1),
    (("hold_from = -eps", "hold_from = eps", "the bound of the hold with the wrong sign"), 1),
    (("(past < self->hold_from) ? past : self->hold_from", "past", "the hold at eps left out"), 1),
    (("                built.c2 = c2;\n", "", "a field that nothing sets"), 1),
    (("self->c2 * x[1]", "self->c2 * x[2]", "a state beyond the array"), 0),
    (
        (
            "            const double hold_from",
            "            self->eps = eps;\n            const double hold_from",
            "a refused init that writes",
        ),
        0,
    ),
];

/// Defects where loops are.
const IN_LOOPS: [(Defect, usize); 1] =
    [(("row[7] = w;", "row[9] = w;", "a row written beyond the array"), 0)];

/// Defects of the example in samples.
const IN_SAMPLES: [(Defect, usize); 6] = [
    (("PTC_FINITE_F64(y[0])", "y[0] < 1e300", "the guard of y left out"), 0),
    ((" && (y != NULL)", "", "the check of y for NULL left out"), 0),
    (("y[0] - p1", "y[1] - p1", "a measurement beyond the array"), 0),
    (("(xhat != NULL)", "(self != NULL)", "the check of xhat for NULL left out"), 0),
    (
        ("(v < -STAGE_U_MAX)", "(v < (-2.0 * STAGE_U_MAX))", "the lower clamp too low, in samples"),
        1,
    ),
    (("(elapsed < 97U)", "(elapsed < 103U)", "the law used where it does not exist"), 1),
];

/// All defects, each with the controller that it is put in; `example` is that of a clock in time.
fn all(example: &Spec) -> Vec<(Spec, &'static (Defect, usize))> {
    let looped = Spec::new(9, Family::ExpSum);
    let of_samples = in_samples::example();
    let defects = DEFECTS.iter().map(|defect| (example.clone(), defect));
    let defects = defects.chain(IN_LOOPS.iter().map(|defect| (looped.clone(), defect)));
    defects.chain(IN_SAMPLES.iter().map(|defect| (of_samples.clone(), defect))).collect()
}

/// Puts each defect in and records whether Eva reports it.
pub(super) fn seeded(folder: &Path, context: &Context, finding: &mut Finding) -> Result<()> {
    let defects = context.in_turn(all(&context.example()));
    let defects: Vec<_> = defects.into_iter().enumerate().collect();
    let told = in_pairs(&defects, |(index, (spec, (defect, mode)))| {
        let folder = empty(&folder.join(format!("seeded{index}")));
        let files = write_with_proof(&folder, spec);
        let source: Vec<_> =
            files.iter().filter(|f| f.ends_with(format!("{}.c", spec.name()))).cloned().collect();
        put_in(&source, *defect)?;
        let log = analyse(&folder, &[spec.name()], &files, MODES[*mode])?;
        anyhow::Ok(log.alarms.first().cloned())
    });
    for ((_, (_, (defect, mode))), caught) in defects.iter().zip(told) {
        let caught = caught?;
        finding.seed(defect.2, caught.map(|alarm| format!("{}: {}", MODES[*mode].0, alarm.trim())));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harness::write;

    /// Not every run puts every defect in: its text is looked for here.
    #[test]
    fn emitted_code_contains_the_text_of_every_defect() {
        let folder = std::env::temp_dir().join(format!("ptc-seeds-{}", std::process::id()));
        for (index, (spec, (defect, _))) in all(&Spec::new(2, Family::Exp)).iter().enumerate() {
            let folder = empty(&folder.join(index.to_string()));
            let files = write(&folder, spec, ptc_codegen::emit::Language::C);
            put_in(&files, *defect).expect("its text");
        }
        std::fs::remove_dir_all(&folder).expect("the folder goes");
    }
}
