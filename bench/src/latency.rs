//! `latency`: how long u waits for t in C, of the plain form, of polynomials as trees and of what is
//! written by hand, in one run.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use ptc_codegen::family::Family;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Guard;
use serde::{Deserialize, Serialize};

use crate::calls::{CALLS, states, times};
use crate::case::{Case, VARIANTS};
use crate::failure::{Failure, Result};
use crate::tools::{run, scratch, workspace};
use crate::{c, callgrind};

/// Families and the names of their kernels in bench/peers/hand.py.
const MAPPINGS: [(Family, &str); 5] = [
    (Family::Exp, "exp"),
    (Family::Rational, "rational"),
    (Family::Tan, "tan"),
    (Family::Tanh, "atanh"),
    (Family::Algebraic, "algebraic"),
];

/// The orders that are measured.
pub(crate) const ORDERS: [usize; 5] = [2, 3, 6, 8, 12];

/// The order that is written out by hand.
const BY_HAND: usize = 3;

/// Rounds, of which the quickest counts: what else the machine does only adds.
const ROUNDS: usize = 21;

/// A family at an order, guard `none`, in f64.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Latency {
    pub(crate) family: String,
    pub(crate) n: usize,
    /// The plain form.
    pub(crate) plain: Step,
    /// With `latency = true`.
    pub(crate) trees: Step,
    /// Written by hand, where it is: with u by a pointer, and returned.
    pub(crate) hand: Option<[Step; 2]>,
}

/// Cost of a call.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Step {
    /// Mean instructions.
    pub(crate) instructions: f64,
    /// Nanoseconds from t to u, each t waiting for the u before it.
    pub(crate) time: f64,
}

/// A function that is timed: its symbol, and how it is called for u.
struct Contestant {
    symbol: String,
    set_up: String,
    call: String,
}

/// Measures each of them.
pub(crate) fn measure() -> Result<Vec<Latency>> {
    callgrind::available()?;
    let folder = scratch("latency")?;
    let mut cases = Vec::new();
    for (family, _) in MAPPINGS {
        let variant = VARIANTS.into_iter().find(|variant| variant.family == family);
        let variant = variant.ok_or_else(|| Failure::new("a family is not measured"))?;
        for n in ORDERS {
            let plain = Case::new(variant, n, Precision::F64, Guard::None);
            let mut trees = plain.clone();
            trees.spec.latency = true;
            trees.spec.name = Some(format!("{}_trees", plain.name()));
            cases.extend([plain, trees]);
        }
    }
    c::compile(&cases, &folder)?;
    let (mut objects, mut contestants) = (Vec::new(), Vec::new());
    contestants.extend(cases.iter().map(ours));
    for (_, kernel) in MAPPINGS {
        let (object, both) = by_hand(kernel, &folder)?;
        objects.push(object);
        contestants.extend(both);
    }
    let program = c::link(&driver(&cases, &contestants), &cases, &objects, &folder)?;
    let profile = callgrind::profile(&program, &["count"], &folder.join("callgrind"))?;
    let times = least(&run(&mut Command::new(&program))?, contestants.len())?;
    let step = |index: usize| -> Result<Step> {
        let instructions = profile.of(&contestants[index].symbol)?.mean();
        Ok(Step { instructions, time: times[index] })
    };
    let mut found = Vec::new();
    for (index, pair) in cases.chunks(2).enumerate() {
        let spec = &pair[0].spec;
        let hand = match spec.n {
            BY_HAND => {
                let first = cases.len() + 2 * (index / ORDERS.len());
                Some([step(first)?, step(first + 1)?])
            }
            _ => None,
        };
        let family = MAPPINGS[index / ORDERS.len()].0.name().to_owned();
        let (plain, trees) = (step(2 * index)?, step(2 * index + 1)?);
        found.push(Latency { family, n: spec.n, plain, trees, hand });
    }
    Ok(found)
}

fn ours(case: &Case) -> Contestant {
    let name = case.name();
    let fields = case.parameters();
    let fields: Vec<_> = fields.iter().map(|(f, values)| (*f, c::digits(values))).collect();
    let parameters = c::parameters(&fields);
    Contestant {
        symbol: format!("{name}_step"),
        set_up: format!(
            "static {name} self; static const {name}_params params = {parameters};\n    if ({name}_init(&self, &params) != PTC_OK) return 1.0;"
        ),
        call: format!("{name}_step(&self, t, X[i], &u)"),
    }
}

/// Writes and compiles the kernel of order 3 that is written by hand. It returns u, and by a second function
/// gives it where ours do, which return a status: by a pointer, so that the next call waits for memory.
fn by_hand(kernel: &str, folder: &Path) -> Result<(PathBuf, [Contestant; 2])> {
    let source = folder.join(format!("hand_{kernel}.c"));
    let script = format!("import hand; print(hand.hand('{kernel}', {BY_HAND}))");
    let mut python = Command::new("python3");
    let text = run(python.args(["-c", &script]).current_dir(workspace().join("bench/peers")))?;
    let (given, returned) = (format!("hand_{kernel}_given"), format!("hand_{kernel}"));
    let more = format!(
        "void {given}(const double *x, double t, const double *k, double tau, double t0, double a, double *u)\n\
         {{\n    *u = {returned}(x, t, k, tau, t0, a);\n}}\n"
    );
    std::fs::write(&source, text.replace("ptc_u", &returned) + &more)?;
    let object = source.with_extension("o");
    run(Command::new("gcc").args(c::FLAGS).arg("-c").arg(&source).arg("-o").arg(&object))?;
    let contestant = |symbol: &String, call: String| Contestant {
        symbol: symbol.clone(),
        set_up: "static const double k[3] = { 2.5, 4.75, 1.25 };".to_owned(),
        call,
    };
    let contestants = [
        contestant(&given, format!("{given}(X[i], t, k, 8.0, 0.5, 1.0, &u)")),
        contestant(&returned, format!("u = {returned}(X[i], t, k, 8.0, 0.5, 1.0)")),
    ];
    Ok((object, contestants))
}

/// The rounds of all contestants in turn; with an argument one round of few calls, for the profiler.
fn driver(cases: &[Case], contestants: &[Contestant]) -> String {
    let widest = ORDERS.into_iter().max().unwrap_or(1);
    let rows: Vec<_> = states(widest).iter().map(|row| format!("{{ {} }}", c::list(row))).collect();
    let mut text = String::from("#include <stdio.h>\n#include <time.h>\n");
    for case in cases {
        let _ = writeln!(text, "#include \"{}.h\"", case.name());
    }
    let arguments = "const double *, double, const double *, double, double, double";
    for pair in contestants[cases.len()..].chunks(2) {
        let [given, returned] = [0, 1].map(|place| &pair[place].symbol);
        let _ = writeln!(text, "void {given}({arguments}, double *);");
        let _ = writeln!(text, "double {returned}({arguments});");
    }
    let _ = writeln!(
        text,
        "static const double X[{CALLS}][{widest}] = {{ {} }};\nstatic const double TIME[{CALLS}] = {{ {} }};",
        rows.join(", "),
        c::list(&times().collect::<Vec<_>>())
    );
    for (index, Contestant { set_up, call, .. }) in contestants.iter().enumerate() {
        // What is added is 0, and the compiler may not know it: u may be infinite.
        let _ = writeln!(
            text,
            "static double time_{index}(long rounds)
{{
    double u = 0.0;
    clock_t start;
    {set_up}
    start = clock();
    for (long r = 0; r < rounds; r++) for (int i = 0; i < {CALLS}; i++) {{
        const double t = TIME[i] + 0.0 * u;
        {call};
    }}
    return u != u ? -1.0 : (double)(clock() - start) * (1e9 / CLOCKS_PER_SEC) / ((double)rounds * {CALLS});
}}"
        );
    }
    let names: Vec<_> = (0..contestants.len()).map(|index| format!("time_{index}")).collect();
    let _ = writeln!(
        text,
        "int main(int argc, char **argv)
{{
    static double (*const timed[])(long) = {{ {} }};
    (void)argv;
    for (int round = 0; round < (argc > 1 ? 1 : {ROUNDS}); round++)
        for (int i = 0; i < {}; i++) printf(\"%d %.4f\\n\", i, timed[i](argc > 1 ? 1 : 4000));
    return 0;
}}",
        names.join(", "),
        contestants.len()
    );
    text
}

/// The least time of each contestant over the rounds.
fn least(printed: &str, count: usize) -> Result<Vec<f64>> {
    let mut least = vec![f64::INFINITY; count];
    for line in printed.lines() {
        let mut words = line.split(' ');
        let mut next = || words.next().ok_or_else(|| Failure::new("a line without two numbers"));
        let index: usize = next()?.parse().map_err(|_| Failure::new(line))?;
        let time: f64 = next()?.parse().map_err(|_| Failure::new(line))?;
        if time <= 0.0 {
            return Err(Failure::new(format!("contestant {index} gives no number")));
        }
        least[index] = least[index].min(time);
    }
    Ok(least)
}
