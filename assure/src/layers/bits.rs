//! C, Rust and the interpreter, before and after every pass, give the same bits where no function
//! of a mathematical library is called. A difference ends the layer: it panics with both outcomes.

use std::collections::BTreeMap;

use anyhow::Result;
use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{self, Code, Instance, Status};
use ptc_codegen::controller::{self, Controller};
use ptc_codegen::emit::Language;
use ptc_codegen::family::Family;
use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, Program, Value, passes};
use ptc_codegen::request::{Guard, Spec};

use super::seeded::with_defect;
use crate::context::Context;
use crate::harness::machine::Machine;
use crate::harness::program::{Outcome, Record, in_c, in_c_from, in_rust};
use crate::harness::random::Random;
use crate::harness::records::records;
use crate::harness::specs::{calls_a_library, families, spec};
use crate::harness::{STRICT, in_pairs, optimised};
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, RUSTC};

pub(super) const LAYER: Layer = Layer {
    name: "bits",
    claim: "C, Rust, the interpreter of the program before and after every pass, and that of the whole \
            controller give the same bits where no function of a mathematical library is called, also \
            with `fma` and `latency`.",
    tools: &[GCC, RUSTC],
    run,
};

/// Records for each spec.
const RECORDS: usize = 1000;

/// Every how many of them the interpreter sees: it is exact arithmetic at heart, and slow.
const INTERPRETED: usize = 41;

/// Every kind of spec of the families that call no library.
fn specs(family: Family) -> Vec<Spec> {
    let mut specs = Vec::new();
    for precision in [Precision::F64, Precision::F32] {
        let of_order = |n| Spec { precision, ..Spec::new(n, family) };
        specs.extend([1, 2, 3, 5, 8].map(of_order));
        specs.extend([Guard::Result, Guard::None].map(|guard| Spec { guard, ..of_order(3) }));
        let mu = format!("{}(a=0.7)", family.name());
        let fixed = spec(&[
            ("n", "4"),
            ("mu", &mu),
            ("gains", "24,-50.1,35,10"),
            ("tau", "1.7"),
            ("allow", "growth"),
        ]);
        specs.push(Spec { precision, ..fixed });
    }
    specs
}

/// Returns the results of `program` and the frame around it for a record that `init` takes.
fn interpreted(program: &Program, spec: &Spec, record: &Record) -> [(i32, f64); 2] {
    let free: Vec<_> = spec.run_time_parameters().collect();
    let parameter = |wanted| free.iter().position(|p| *p == wanted).map(|at| record.parameters[at]);
    let input = |gains: &[f64], input: Input| match input {
        Input::Parameter(p) => parameter(p).expect("a run-time parameter"),
        Input::StartTime => parameter(Parameter::StartTime).expect("a run-time start"),
        Input::Time => record.t,
        Input::State(j) => record.x[j - 1],
        Input::Reference(order) => record.x[spec.states() + order],
        Input::Gain(j) => gains[j - 1],
        Input::Divisor => gains[spec.n],
        Input::ReferenceOf(..)
        | Input::StateAtStart(_)
        | Input::Drift
        | Input::Control
        | Input::Wanted(_) => f64::NAN,
    };
    let early = parameter(Parameter::StartTime).is_some_and(|t0| record.t < t0);
    let finite = record.t.is_finite() && record.x.iter().all(|x| x.is_finite());
    if spec.guard == Guard::Full && (early || !finite) {
        return [(-2, 0.0); 2];
    }
    let at_step = |i| input(&[], i);
    let mut step = Interpreter::new(program, &at_step);
    let u = step.value(program.step);
    let step = outcome(program, &mut step, u);
    let mut tick = Interpreter::new(program, &at_step);
    let gains: Vec<_> = program.handed_over().map(|gain: &Value| tick.value(*gain)).collect();
    let at_axis = |i| input(&gains, i);
    let u = Interpreter::new(program, &at_axis).value(program.axis.expect("a linear law"));
    [step, outcome(program, &mut tick, u)]
}

/// The status and u that follow from the u of the law.
fn outcome(program: &Program, interpreter: &mut Interpreter<'_>, u: f64) -> (i32, f64) {
    let (late, hold_from) =
        (interpreter.value(program.limits.late), interpreter.value(program.limits.hold_from));
    let held = i32::from(late >= hold_from);
    match program.limits.u_max.map(|limit| interpreter.value(limit)) {
        // An overflow is not clipped to a limit: it fails with u = 0.
        _ if !u.is_finite() => (-3, 0.0),
        Some(limit) if u > limit => (2, limit),
        Some(limit) if u < -limit => (2, -limit),
        _ => (held, u),
    }
}

/// Returns the results of the program of the whole controller for a record: of `step` and `axis`, or the status of
/// `init` where it fails.
fn whole(code: &Code, spec: &Spec, record: &Record) -> Result<[(i32, f64); 2], i32> {
    let given = spec.run_time_parameters().zip(record.parameters.iter().copied());
    let mut controller = Instance::with_parameters(code, given).map_err(Status::number)?;
    let (x, r) = record.x.split_at(spec.states());
    let (t, x, r) = (("t", [record.t]), ("x", x), ("r", r));
    let t = (t.0, t.1.as_slice());
    let given: &[_] = if spec.references() > 0 { &[t, x, r] } else { &[t, x] };
    let outcome = |found: &code::Outcome| {
        (found.status.number(), found.results.get("u").map_or(0.0, |u| u[0]))
    };
    let step = outcome(&controller.call("step", given));
    let gains = controller.call("tick", &[t]);
    let axis = match gains.status.number() {
        failed if failed < 0 => (failed, 0.0),
        _ => outcome(&controller.gains(&gains).call("axis", &given[1..])),
    };
    Ok([step, axis])
}

/// The program before the passes and after each of them, by name; from the last pass on that changes
/// roundings.
fn stages(spec: &Spec) -> Vec<(&'static str, Program)> {
    let program = lower(spec, &Law::of(spec));
    assert_eq!(program.check(), Ok(()));
    let mut stages = vec![("lower", program.clone())];
    passes::optimise(program, &mut |pass, program| stages.push((pass.name, program.clone())));
    let changed = [(spec.fma, "fuse"), (spec.latency, "balance")];
    if let Some((_, last)) = changed.iter().find(|(is_set, _)| *is_set) {
        stages.drain(..stages.iter().position(|(name, _)| name == last).expect("the pass"));
    }
    stages
}

fn agree(spec: &Spec, records: &[Record], c: &[Outcome], rust: &[Outcome]) {
    for ((record, c), rust) in records.iter().zip(c).zip(rust) {
        assert_eq!(c.bits(), rust.bits(), "C {c:?}, Rust {rust:?}\n{spec:?}\n{record:?}");
    }
    for (pass, program) in stages(spec) {
        let calls = records.iter().zip(c).filter(|(_, outcome)| outcome.init == 0);
        for (record, c) in calls.step_by(INTERPRETED) {
            let bits = |(status, u): (i32, f64)| (status, u.to_bits());
            let found = interpreted(&program, spec, record).map(bits);
            let wanted = [c.step, c.axis].map(bits);
            assert_eq!(found, wanted, "after {pass}: C {c:?}\n{spec:?}\n{record:?}");
        }
    }
}

/// The whole controller gives what C gives, whatever the record.
fn agrees_as_a_whole(spec: &Spec, records: &[Record], c: &[Outcome]) {
    let report = examine(spec);
    let law = Law::of(spec);
    let program = optimised(spec);
    let code = controller::whole(&Controller {
        report: &report,
        law: &law,
        program: &program,
        measured: &[],
    });
    for (record, c) in records.iter().zip(c).step_by(INTERPRETED) {
        let bits = |(status, u): (i32, f64)| (status, u.to_bits());
        let wanted = if c.init == 0 { Ok([c.step, c.axis].map(bits)) } else { Err(c.init) };
        let found = whole(&code, spec, record).map(|calls| calls.map(bits));
        assert_eq!(found, wanted, "C {c:?}\n{spec:?}\n{record:?}");
    }
}

fn run(context: &Context) -> Result<Finding> {
    let (specs, statuses) = plain(context);
    let forms = other_forms(context);
    let calls: usize = statuses.values().sum();
    let summary = format!(
        "{specs} controllers, {calls} calls in both languages, and {forms} with fused operations or \
         trees: equal bits after every pass"
    );
    let mut finding = Finding { summary, ..Finding::default() };
    seeded(context, &mut finding)?;
    Ok(finding)
}

/// The example with one rounding more in a coefficient.
fn seeded(context: &Context, finding: &mut Finding) -> Result<()> {
    let (folder, spec) = (context.scratch("bits_seeded"), examine(&context.example()).spec);
    let defect = ("k1 / (a * a)", "k1 / a / a", "one rounding more in a coefficient");
    let files = with_defect(&folder, &spec, Language::C, defect)?;
    let sources: Vec<_> =
        files.into_iter().filter(|file| file.extension().is_some_and(|e| e == "c")).collect();
    let flags = STRICT.map(str::to_owned);
    let c = in_c_from(Machine::Host, &folder, &spec, &sources, &flags);
    let rust = in_rust(&folder, std::slice::from_ref(&spec)).remove(0);
    let records = records(&spec, &mut Random(context.seed), RECORDS);
    let (c, rust) = (c.run(&records), rust.run(&records));
    let differs = c.iter().zip(&rust).any(|(c, rust)| c.bits() != rust.bits());
    finding.seed(defect.2, differs.then(|| "the bits of Rust".to_owned()));
    Ok(())
}

/// Returns the outcomes of each spec for random records, in C as in Rust and in the interpreters.
fn compared(context: &Context, name: &str, specs: &[Spec], count: usize) -> Vec<Vec<Outcome>> {
    let (folder, count) = (context.scratch(name), context.records(count));
    let programs: Vec<_> =
        specs.iter().zip(in_c(&folder, specs)).zip(in_rust(&folder, specs)).enumerate().collect();
    in_pairs(&programs, |(index, ((spec, c), rust))| {
        let mut random = Random(*index as u64);
        let records = records(spec, &mut random, count);
        let (c, rust) = (c.run(&records), rust.run(&records));
        agree(spec, &records, &c, &rust);
        agrees_as_a_whole(spec, &records, &c);
        c
    })
}

/// Returns the number of specs that were compared, and their calls by status.
fn plain(context: &Context) -> (usize, BTreeMap<i32, usize>) {
    let specs: Vec<_> = families()
        .filter(|family| *family != Family::ExpSum && *family != Family::Power)
        .flat_map(specs)
        .filter(|spec| !calls_a_library(spec))
        .collect();
    for family in [Family::Exp, Family::Rational, Family::Tanh] {
        assert!(
            specs.iter().any(|spec| spec.family() == Some(family)),
            "{family:?} calls a library"
        );
    }
    // The loops over the powers of a Taylor series, which belong to high orders.
    let looped = ["f64", "f32"].map(|precision| {
        spec(&[("n", "9"), ("kappa", "tau*dt/(tau - dt) + dt"), ("precision", precision)])
    });
    for spec in &looped {
        let files = ptc_codegen::generate(spec, Language::C).expect("a legal spec");
        assert!(!calls_a_library(spec) && files[1].text.contains("_row_sums("), "{spec:?}");
    }
    let following = ["f64", "f32"].map(|precision| {
        spec(&[("n", "3"), ("mu", "rational"), ("reference", "input"), ("precision", precision)])
    });
    let divided = ["2", "1/mass"].map(|g| spec(&[("n", "2"), ("mu", "exp"), ("g", g)]));
    let specs: Vec<_> = specs.into_iter().chain(looped).chain(following).chain(divided).collect();
    let specs = context.in_turn(specs);
    let outcomes = compared(context, "bits", &specs, RECORDS);
    let mut statuses = BTreeMap::new();
    for outcome in outcomes.iter().flatten() {
        let status = if outcome.init == 0 { outcome.step.0 } else { outcome.init };
        *statuses.entry(status).or_insert(0) += 1;
    }
    // Every outcome has been compared, so the records are not of one kind.
    assert!(
        (-3..=2)
            .all(|status| statuses.get(&status).is_some_and(|count| *count > context.records(100))),
        "{statuses:?}"
    );
    (specs.len(), statuses)
}

/// With products and sums fused, with polynomials as trees, and with both.
fn other_forms(context: &Context) -> usize {
    let families = [Family::Exp, Family::Rational, Family::Tan, Family::Tanh, Family::Algebraic];
    let orders = families.iter().flat_map(|family| [1, 3, 6, 12].map(|n| Spec::new(n, *family)));
    let own = [
        spec(&[("n", "3"), ("kappa", "tau*dt/(tau - dt) + dt"), ("reference", "input")]),
        spec(&[("n", "2"), ("mu", "exp"), ("g", "1/mass")]),
    ];
    let plain: Vec<_> = orders.chain(own).filter(|spec| !calls_a_library(spec)).collect();
    assert!(plain.len() > 18, "{}", plain.len());
    let forms = [(true, false), (false, true), (true, true)];
    let of = |(index, plain): (usize, &Spec)| {
        [(0, Precision::F64), (1, Precision::F32)].map(|(offset, precision)| {
            let (fma, latency) = forms[(index + offset) % forms.len()];
            Spec { precision, fma, latency, ..plain.clone() }
        })
    };
    let looped = [("f64", "fma(f["), ("f32", "fmaf(f[")].map(|(precision, fused)| {
        let kappa = ("kappa", "tau*dt/(tau - dt) + dt");
        let looped = spec(&[("n", "12"), kappa, ("precision", precision), ("fma", "true")]);
        let files = ptc_codegen::generate(&looped, Language::C).expect("a legal spec");
        assert!(files[1].text.contains(fused), "{looped:?}");
        looped
    });
    let specs: Vec<_> = plain.iter().enumerate().flat_map(of).chain(looped).collect();
    let differs = |spec: &&Spec| {
        let plain = Spec { fma: false, latency: false, ..(*spec).clone() };
        optimised(spec).values.len() != optimised(&plain).values.len()
    };
    // Order 1 has no sum of products, and low orders no polynomial that a tree shortens.
    let other = specs.iter().filter(differs).count();
    assert!(other > specs.len() / 2, "{other} of {}", specs.len());
    let specs = context.in_turn(specs);
    compared(context, "forms", &specs, RECORDS / 4);
    specs.len()
}
