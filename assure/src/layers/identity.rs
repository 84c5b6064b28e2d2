//! The same records on every machine, in C and in Rust: equal bits.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::Result;
use ptc_codegen::family::Family;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;

use crate::context::Context;
use crate::harness::machine::{EMULATED, Machine};
use crate::harness::program::{Outcome, Program, Record, in_c, in_c_on, in_rust, in_rust_on, real};
use crate::harness::random::Random;
use crate::harness::records::records;
use crate::harness::specs::calls_a_library;
use crate::harness::{STRICT, empty, ieee_addition, in_pairs};
use crate::layer::{Finding, Layer, Table};
use crate::tool::{
    ARM_GCC, GCC, NEWLIB, PICOLIBC, QEMU_ARM, QEMU_RISCV, RISCV_GCC, RUSTC, ShownBy, Source, Tool,
};

const RECORDS: usize = 1000;

/// The standard library of a target of the Rust compiler.
const fn rust_target(name: &'static str, arguments: &'static [&'static str]) -> Tool {
    // It prints nothing where the target's library is there.
    Tool {
        name,
        shown_by: ShownBy::Command(arguments),
        source: Source::Rustup(&[
            "target",
            "add",
            "thumbv6m-none-eabi",
            "thumbv7em-none-eabihf",
            "riscv32imac-unknown-none-elf",
        ]),
    }
}

pub(super) const LAYER: Layer = Layer {
    name: "identity",
    claim: "C and Rust give the same bits on x86-64, Cortex-M0, M4F and M7 and on 32-bit RISC-V \
            where no function of a mathematical library is called, and nearly the same elsewhere.",
    tools: &[
        GCC,
        RUSTC,
        ARM_GCC,
        NEWLIB,
        QEMU_ARM,
        RISCV_GCC,
        PICOLIBC,
        QEMU_RISCV,
        rust_target("Rust for Arm and RISC-V", RUST_TARGETS),
    ],
    run,
};

/// Command that tests for the target libraries, without which rustc cannot compile a crate without std for each.
const RUST_TARGETS: &[&str] = &[
    "sh",
    "-c",
    "for target in thumbv6m-none-eabi thumbv7em-none-eabihf riscv32imac-unknown-none-elf; do \
     test -d \"$(rustc --print sysroot)/lib/rustlib/$target/lib\" || exit 1; done",
];

/// Comparison of the outcomes of one program with those of C on this machine.
#[derive(Clone, Copy, Default)]
struct Comparison {
    /// Records.
    compared: usize,
    /// Records of which any bit differs.
    differing: usize,
    /// The greatest relative difference of u, where both gave one.
    greatest: f64,
    /// Records with another status.
    statuses: usize,
}

impl Comparison {
    fn of(wanted: &[Outcome], found: &[Outcome]) -> Self {
        let mut all = Self { compared: wanted.len(), ..Self::default() };
        for (a, b) in wanted.iter().zip(found) {
            all.differing += usize::from(a.bits() != b.bits());
            let statuses = |o: &Outcome| (o.init, o.step.0, o.axis.0);
            if statuses(a) != statuses(b) {
                all.statuses += 1;
                continue;
            }
            for (u, v) in [(a.step.1, b.step.1), (a.axis.1, b.axis.1)] {
                let size = u.abs().max(v.abs());
                if size > 0.0 && size.is_finite() {
                    all.greatest = all.greatest.max((u - v).abs() / size);
                }
            }
        }
        all
    }

    fn add(&mut self, other: Self) {
        self.compared += other.compared;
        self.differing += other.differing;
        self.statuses += other.statuses;
        self.greatest = self.greatest.max(other.greatest);
    }
}

/// A side of the comparison: where, in which language, and its program of each controller.
struct Side {
    name: String,
    language: &'static str,
    /// True if arithmetic on this side is IEEE 754, so that equal bits are due.
    exact: bool,
    programs: Vec<Program>,
}

impl Side {
    fn new(place: &str, language: &'static str, programs: Vec<Program>) -> Self {
        Self { name: format!("{place}, {language}"), language, exact: true, programs }
    }
}

/// Every side but C on this machine.
fn sides(folder: &Path, specs: &[Spec]) -> Vec<Side> {
    let mut sides = vec![Side::new(Machine::Host.name(), "Rust", in_rust(folder, specs))];
    for machine in EMULATED {
        let home = folder.join(machine.stem());
        let rust = in_rust_on(machine, &home, specs);
        let mut flags = STRICT.map(str::to_owned).to_vec();
        if machine == Machine::CortexM4f {
            let own = in_c_on(machine, &empty(&home.join("own")), specs, &flags);
            sides.push(Side {
                exact: false,
                ..Side::new("Cortex-M4F with libgcc's addition", "C", own)
            });
            flags.extend(ieee_addition(machine, &home));
        }
        sides.push(Side::new(machine.name(), "C", in_c_on(machine, folder, specs, &flags)));
        sides.push(Side::new(machine.name(), "Rust", rust));
    }
    sides
}

fn run(context: &Context) -> Result<Finding> {
    let folder = context.scratch("identity");
    let specs = [context.families(context.order(4)), context.random(24)].concat();
    let specs = context.in_turn(specs);
    let records: Vec<_> = specs
        .iter()
        .enumerate()
        .map(|(index, spec)| records(spec, &mut Random(context.seed ^ index as u64), RECORDS))
        .collect();
    let wanted = outcomes(&in_c(&folder, &specs), &records);
    let mut finding = Finding::default();
    let mut equal = BTreeMap::<String, Comparison>::new();
    let mut near = BTreeMap::<(String, &str), Comparison>::new();
    let mut differing = 0;
    for side in sides(&folder, &specs) {
        let found = outcomes(&side.programs, &records);
        for ((spec, wanted), found) in specs.iter().zip(&wanted).zip(&found) {
            let comparison = Comparison::of(wanted, found);
            if calls_a_library(spec) {
                near.entry((group(spec), side.language)).or_default().add(comparison);
                continue;
            }
            equal.entry(side.name.clone()).or_default().add(comparison);
            if side.exact && comparison.differing > 0 {
                differing += comparison.differing;
                let told = format!(
                    "{}: {}: {} records differ",
                    side.name,
                    spec.name(),
                    comparison.differing
                );
                finding.failures.push(told);
            }
        }
    }
    let exact = specs.iter().filter(|spec| !calls_a_library(spec)).count();
    finding.summary = format!(
        "{exact} controllers of {RECORDS} records on {} machines in C and Rust: {differing} differing \
         outcomes; {} more that call a library",
        EMULATED.len() + 1,
        specs.len() - exact
    );
    tables(&mut finding, &equal, &near);
    negative_control(context, &mut finding);
    Ok(finding)
}

/// Mapping and precision, which is what the differences of libraries depend on.
fn group(spec: &Spec) -> String {
    format!("{} {}", spec.mapping_name(), real(spec.precision))
}

fn outcomes(programs: &[Program], records: &[Vec<Record>]) -> Vec<Vec<Outcome>> {
    let calls: Vec<_> = programs.iter().zip(records).collect();
    in_pairs(&calls, |(program, records)| program.run(records))
}

/// The machines differ in their libraries: glibc here, newlib on Arm, picolibc on RISC-V, the crate
/// libm in Rust without std.
fn tables(
    finding: &mut Finding,
    equal: &BTreeMap<String, Comparison>,
    near: &BTreeMap<(String, &str), Comparison>,
) {
    let rows = equal.iter().map(|(side, c)| {
        vec![
            side.clone(),
            c.compared.to_string(),
            c.differing.to_string(),
            format!("{:.1e}", c.greatest),
        ]
    });
    let difference = "greatest relative difference of u";
    finding.tables.push(Table {
        title: "Against C on this machine, no library function".to_owned(),
        head: vec!["where", "records", "differing", difference],
        rows: rows.collect(),
    });
    let rows = near.iter().map(|((group, language), c)| {
        vec![
            group.clone(),
            (*language).to_owned(),
            c.compared.to_string(),
            c.differing.to_string(),
            c.statuses.to_string(),
            format!("{:.1e}", c.greatest),
        ]
    });
    finding.tables.push(Table {
        title: "Against C on this machine, with exp, log or pow of each machine's own library"
            .to_owned(),
        head: vec!["mapping", "language", "records", "differing", "other status", difference],
        rows: rows.collect(),
    });
    finding.notes.push(
        "Equal bits need arithmetic as IEEE 754 has it. libgcc's addition of doubles for Armv7-M \
         without a double-precision unit has not: for y from 2^-33 to 2^-32 it rounds 1 - y to the \
         wrong neighbour in about half of all cases (1.0 - 0x1.4b8e875f7d1bdp-33 is one). So C on \
         the Cortex-M4F is compared twice: linked with the addition of Rust's compiler_builtins, \
         where equal bits are due, and as that compiler comes."
            .to_owned(),
    );
}

/// Contraction to fused multiply-adds must be seen as different bits.
fn negative_control(context: &Context, finding: &mut Finding) {
    let folder = context.scratch("identity_control");
    let specs = [Spec { precision: Precision::F32, ..Spec::new(3, Family::Exp) }];
    let records = [records(&specs[0], &mut Random(context.seed), RECORDS)];
    let strict = STRICT.map(str::to_owned);
    let fused = strict.clone().map(|flag| flag.replace("-ffp-contract=off", "-ffp-contract=fast"));
    let [strict, fused] = [strict, fused].map(|flags| {
        outcomes(&in_c_on(Machine::CortexM4f, &folder, &specs, &flags), &records).remove(0)
    });
    let differing = Comparison::of(&strict, &fused).differing;
    let caught = (differing > 0).then(|| format!("{differing} of {RECORDS} records differ"));
    finding.seed("fused multiply-add allowed on the Cortex-M4F (-ffp-contract=fast)", caught);
}
