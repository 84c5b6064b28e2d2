//! The sections that put ours beside other tools.

use std::fmt::Write as _;

use super::tables::section;
use crate::axes::{FLAGS, Step};
use crate::equality::{Found, Outcome};
use crate::generator::Bell;
use crate::models::Model;
use crate::peers::{Entry, OURS};

const AXES: &str = "\
One controller for several axes, `axes = m`: exp in C and f64, guard `full`, counted as above. In each cell:
a `step` of all axes, and `tick` once with `axis` for each axis, without the loop and the statuses of all that a
caller needs, compiled by `gcc -std=c99` with the flags above the column. `step` forms the gains in place and computes
u of all axes before it tests one: at n = 12 as four sums of three products each, whose states are adjacent, so
that four of them fill a vector of AVX2; at lower orders as a line for each axis. It looks at each axis by itself
only where one is not within its bounds. Where there are no vectors, the four sums cost more than
one.";

pub(super) fn axes(text: &mut String, steps: &[Step]) {
    section(text, "Several axes", "axes", AXES);
    let flags =
        FLAGS.map(|flags| if flags.is_empty() { "-O2".to_owned() } else { flags.join(" ") });
    let _ =
        writeln!(text, "\n| n | m | {} |\n| ---: | ---: | ---: | ---: | ---: |", flags.join(" | "));
    for Step { n, count, found } in steps {
        let cells: Vec<_> =
            found.iter().map(|(step, each)| format!("{step:.0}, {each:.0}")).collect();
        let _ = writeln!(text, "| {n} | {count} | {} |", cells.join(" | "));
    }
}

const PEERS: &str = "\
Other generators' C and C++ for the same law beside ours, in one binary, all parameters at run time,
double precision, `gcc -O2`. The others are given kappa and mu as the paper writes them, and by
`_diff` and `_mu` two ways to r_k; `sympy_cse` is plain SymPy, `sympy_tuned` simplifies each r_k and
writes powers as products; `hand` and `hand_loop` are written by hand. They have one function, which
computes from the parameters at each call what ours keeps from `init`. Errors are scaled as in [Accuracy](steps.md#accuracy):
first for T/tau >= 0.01, then to 1e-12. The ratio is of instructions, to the best of the others at
that family and order. A peer that is not listed took longer than 60 s to generate or wrote more
than 1 MB. Set up and generate with

    python3 -m venv bench/peers/venv
    bench/peers/venv/bin/pip install sympy symengine casadi symforce python-flint mpmath
    bench/peers/venv/bin/python bench/peers/generate.py
";

pub(super) fn peers(text: &mut String, peers: &[Entry]) {
    section(text, "Beside other generators", "peers", PEERS);
    text.push_str("| family | n | generator | instructions | to the best other | bytes of code | error | error at the deadline |\n");
    text.push_str("| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: |\n");
    let mut sorted: Vec<_> = peers.iter().collect();
    sorted.sort_by(|a, b| (&a.family, a.n).cmp(&(&b.family, b.n)).then(a.step.total_cmp(&b.step)));
    let error = |value: Option<f64>| match value {
        Some(value) => format!("{value:.1e}"),
        None => "not finite".to_owned(),
    };
    for entry in sorted {
        let Entry { name, family, n, step, text: bytes, early, deadline } = entry;
        let (early, deadline) = (error(*early), error(*deadline));
        let others = peers.iter().filter(|other| {
            other.name != OURS && (&other.family, other.n) == (&entry.family, entry.n)
        });
        let best = others.map(|other| other.step).fold(f64::INFINITY, f64::min);
        let ratio = step / best;
        let _ = writeln!(
            text,
            "| {family} | {n} | {name} | {step:.0} | {ratio:.2} | {bytes} | {early} | {deadline} |"
        );
    }
}

const MODELS: &str = "\
A step of designs in examples/ with a model of the plant, in C and f64, guard `none`, without limits, every parameter
fixed, beside C that other tools write for the same plant: u = (v - L_f^r h)/(L_g L_f^(r-1) h), or M v + bias
for the arm. All are compiled by `gcc -std=c99 -O2` and counted in one run, the mathematical library included: the
mean over 64 calls with time-to-go from tau to 0.03 tau. Every u agrees with ours to a relative 1e-12. The tools
differentiate the plant and eliminate common subexpressions themselves; v is given to them in Horner's form in 1/T
with its coefficients as numbers, so the mapping costs them nothing. `sympy` is `cse` and `ccode` of that quotient,
`sympy_simplified` of v/g - f/g with `simplify` of 1/g and f/g; `casadi` is SX with `cse` and its code generator.

They return no status, hold nothing at eps, do not test u and keep no low part of t0 + tau: on the pendulum that is
the whole difference. On the magnet a test that the divisor is not 0 is in it too. Divisions are those in the compiled code. Set up
and generate with

    python3 -m venv bench/peers/venv
    bench/peers/venv/bin/pip install sympy casadi
    bench/peers/venv/bin/python bench/peers/models.py";

/// Writes the table of models below a summary of the designs in which ours is not ahead.
pub(super) fn models(text: &mut String, models: &[Model]) {
    let best = |design: &str| {
        let others = models.iter().filter(|one| one.design == design && one.name != OURS);
        others.map(|one| one.step).min_by(f64::total_cmp)
    };
    let ratio = |one: &Model| best(&one.design).map(|best| one.step / best);
    let ours = models.iter().filter(|one| one.name == OURS);
    let behind: Vec<_> = ours
        .filter_map(|one| Some((&one.design, ratio(one)?)))
        .filter(|(_, ratio)| *ratio >= 1.0)
        .map(|(design, ratio)| format!("{design} ({ratio:.2})"))
        .collect();
    let behind = match behind.is_empty() {
        true if models.iter().all(|one| one.name == OURS) => {
            "The other tools were not run".to_owned()
        }
        true => "Ahead of all others".to_owned(),
        false => format!(
            "Not ahead, with the ratio of instructions to the best other: {}",
            behind.join(", ")
        ),
    };
    let about = format!("{behind}.\n\n{MODELS}\n");
    section(text, "Models beside other tools", "models", &about);
    text.push_str("| design | code of | instructions | to the best other | divisions | bytes of code | difference of u |\n");
    text.push_str("| --- | --- | ---: | ---: | ---: | ---: | ---: |\n");
    for one in models {
        let Model { design, name, step, divisions, text: bytes, difference, version } = one;
        let name = version.as_ref().map_or(name.clone(), |version| format!("{name}, {version}"));
        let ratio = ratio(one).map_or(String::new(), |ratio| format!("{ratio:.2}"));
        let difference = match version {
            Some(_) if *difference > 0.0 => format!("{difference:.0e}"),
            Some(_) => "0".to_owned(),
            None => String::new(),
        };
        let _ = writeln!(
            text,
            "| {design} | {name} | {step:.0} | {ratio} | {divisions} | {bytes} | {difference} |"
        );
    }
}

pub(super) fn bells(text: &mut String, bells: &[Bell]) {
    text.push_str(
        "\nAll B_{i,j} in free symbols beside other tools, the textbook recurrence with each tool's own\n\
         expansion (`bench/peers/bell.py`), best of 5, ours in process, best of 20:\n\n",
    );
    if bells.iter().all(|bell| bell.tool == OURS) {
        text.push_str("The other tools were not run: their Python is not set up.\n\n");
    }
    text.push_str("| up to | terms | tool | ms |\n| ---: | ---: | --- | ---: |\n");
    let mut sorted: Vec<_> = bells.iter().collect();
    sorted.sort_by(|a, b| a.n.cmp(&b.n).then(a.seconds.total_cmp(&b.seconds)));
    for Bell { tool, n, seconds, terms } in sorted {
        let _ = writeln!(text, "| {n} | {terms} | {tool} | {:.2} |", seconds * 1e3);
    }
}

const SATURATION: &str = "\
What equality saturation (the crate egg) finds beyond the passes: the part of `step` that time or the
state decides, rewritten by commutativity, associativity, distributivity, signs and reciprocals in an
e-graph of at most 100,000 nodes. The cost is the generator's model of x86-64, a shared value counted
once, what parameters alone decide for nothing. Extraction is greedy with exchanges, so a cost is an
upper bound of the best. First the time-to-go T is kept as it is computed, then it may be rewritten
too; the difference is of u from the program's, relative, at t0 = 1000.1 with T/tau from 1 to 1e-9.";

pub(super) fn saturation(text: &mut String, found: &[Found]) {
    section(text, "Equality saturation", "egg", SATURATION);
    text.push_str("\n| family | n | cycles before | T kept: best | nodes, classes | ms | ended by | T rewritten: best | difference |\n");
    text.push_str("| --- | ---: | ---: | ---: | ---: | ---: | --- | ---: | ---: |\n");
    for Found { family, n, before, kept, free } in found {
        let Outcome { after, nodes, classes, seconds, stopped, .. } = kept;
        let _ = writeln!(
            text,
            "| {family} | {n} | {before} | {after} | {nodes}, {classes} | {:.1} | {stopped} | {} | {:.0e} |",
            seconds * 1e3,
            free.after,
            free.difference
        );
    }
    let lower = found.iter().filter(|one| one.kept.after < one.before).count();
    let saved = found.iter().map(|one| one.before.saturating_sub(one.free.after)).max();
    let off = found.iter().map(|one| one.free.difference).fold(0.0, f64::max);
    let _ = write!(
        text,
        "\nWith T kept it lowers the cost of {lower} of {} kernels. With T rewritten it saves at most {} \
         cycles,\nand u is then wrong by up to {off:.0e} near the deadline: ",
        found.len(),
        saved.unwrap_or(0)
    );
    text.push_str(if lower == 0 {
        "the saving is the compensation of the\nrounded deadline, left out. It does not earn its place in the generator.\n"
    } else {
        "that saving must not be taken,\nthe others may be worth a pass.\n"
    });
}
