//! The passes: named, in one visible list, each keeping every bit except `balance` and `fuse`, which are opt-in.

mod balance;
mod chains;
mod fold;
mod fuse;
mod prune;
mod share;
#[cfg(test)]
mod tests;

use super::{Definition, Least, Op, Program, Value};

/// A pass over a program.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// Name, for `emit --dump`.
    pub name: &'static str,
    /// Description.
    pub doc: &'static str,
    run: fn(Program) -> Program,
}

/// All passes, in the order in which they run.
pub static PASSES: [Pass; 8] = [
    Pass { name: "fold", doc: "computes what is known at generation", run: fold::run },
    Pass { name: "chains", doc: "writes powers as multiplication chains", run: chains::run },
    Pass { name: "refold", doc: "computes powers of what is known at generation", run: fold::run },
    Pass { name: "share", doc: "keeps one of several equal values", run: share::run },
    Pass { name: "balance", doc: "writes polynomials as trees where asked", run: balance::run },
    Pass { name: "reshare", doc: "keeps one of several equal squares", run: share::run },
    Pass { name: "fuse", doc: "fuses products and sums where asked", run: fuse::run },
    Pass { name: "prune", doc: "drops values that nothing uses", run: prune::run },
];

/// Runs all passes; `watch` sees the program after each. The invariants are checked in between.
///
/// # Panics
/// When a pass breaks an invariant of the program, which is a defect of this crate.
pub fn optimise(mut program: Program, watch: &mut dyn FnMut(&Pass, &Program)) -> Program {
    for pass in &PASSES {
        program = (pass.run)(program);
        debug_assert_eq!(program.check(), Ok(()), "after the pass {}", pass.name);
        watch(pass, &program);
    }
    program
}

/// Rebuilds a program value by value: `rewrite` sees each operation with its operands already
/// mapped, and returns the value that stands for it.
fn rebuild(
    program: &Program,
    rewrite: &mut dyn FnMut(&mut Program, Definition) -> Value,
) -> Program {
    let mut new = Program { values: Vec::with_capacity(program.values.len()), ..program.clone() };
    let mut map: Vec<Value> = Vec::with_capacity(program.values.len());
    for definition in &program.values {
        let op = definition.op.map(|v| map[v.0]);
        let value = rewrite(&mut new, Definition { op, ..definition.clone() });
        map.push(value);
    }
    let to = |v: Value| map[v.0];
    new.step = to(program.step);
    new.others = program.others.iter().copied().map(to).collect();
    new.axis = program.axis.map(to);
    for part in new.parts.iter_mut().flatten() {
        *part = to(*part);
    }
    new.gains = program.gains.iter().copied().map(to).collect();
    new.divisors = program.divisors.iter().copied().map(to).collect();
    new.bounds = program.bounds.iter().copied().map(to).collect();
    new.lower = program.lower.iter().copied().map(to).collect();
    new.determinant = program.determinant.map(to);
    new.watched = program.watched.iter().copied().map(to).collect();
    new.limits.start_time = program.limits.start_time.map(to);
    new.limits.u_max = program.limits.u_max.map(to);
    if let Least::Own(value) = &mut new.limits.u_min {
        *value = to(*value);
    }
    new.limits.past = program.limits.past.map(to);
    new.limits.late = to(program.limits.late);
    new.limits.hold_from = to(program.limits.hold_from);
    new.limits.eps = to(program.limits.eps);
    new.limits.elapsed = program.limits.elapsed.map(|(elapsed, tau)| (to(elapsed), to(tau)));
    new
}

/// Appends an operation, with its stage and side of the loop.
pub(crate) fn append(program: &mut Program, op: Op, name: Option<(String, String)>) -> Value {
    let (stage, looped) = (program.stage_of(&op), program.looped(&op));
    program.values.push(Definition { op, stage, name, looped });
    Value(program.values.len() - 1)
}

/// Counts the uses of each value by the operations that the outputs need, and as an output.
fn uses(program: &Program) -> Vec<usize> {
    let mut uses = vec![0; program.values.len()];
    let outputs = program.outputs();
    for value in program.needed(&outputs) {
        program.get(value).op.each_operand(|operand| uses[operand.0] += 1);
    }
    outputs.iter().for_each(|output| uses[output.0] += 1);
    uses
}
