//! `peers`: the C of other generators beside ours, in one binary.
//!
//! A peer is a folder of files `<mapping>_n<n>.c` (or `.cc`), each with one function
//! `double ptc_u(const double *x, double t, const double *k, double tau, double t0, double a)`.
//! Mappings are named by kappa: `atanh` is the family tanh. All are given the rate a = 1, for peers
//! that know no other: a gain k_i of a reference vector becomes k_i a^(i-1-n), which is the same u.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use ptc_codegen::family::Family;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Guard;
use serde::{Deserialize, Serialize};

use crate::calls::{CALLS, states, times};
use crate::case::{Case, VARIANTS};
use crate::failure::{Failure, Result, While};
use crate::tools::{run, scratch, workspace};
use crate::vectors::Vector;
use crate::{c, callgrind, evaluate, vectors};

/// Our families by the name of the peers' mapping.
const MAPPINGS: [(&str, Family); 5] = [
    ("exp", Family::Exp),
    ("rational", Family::Rational),
    ("tan", Family::Tan),
    ("atanh", Family::Tanh),
    ("algebraic", Family::Algebraic),
];

const ORDERS: [usize; 3] = [3, 6, 12];

/// One contestant at one mapping and order.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Entry {
    pub(crate) name: String,
    pub(crate) family: String,
    pub(crate) n: usize,
    /// Mean instructions of a call.
    pub(crate) step: f64,
    /// Bytes of code.
    pub(crate) text: u64,
    /// Worst scaled error where T/tau is at least 0.01; `None` if a result is not finite.
    pub(crate) early: Option<f64>,
    /// Worst scaled error up to the deadline, to T/tau = 1e-12.
    pub(crate) deadline: Option<f64>,
}

/// The name under which ours is listed.
pub(crate) const OURS: &str = "ptc-codegen";

/// A peer's compiled function.
struct Peer {
    name: String,
    family: Family,
    n: usize,
    symbol: String,
    object: PathBuf,
    text: u64,
}

/// Commands that set up the contestants.
const SET_UP: &str = "
    python3 -m venv bench/peers/venv
    bench/peers/venv/bin/pip install sympy symengine casadi symforce python-flint mpmath
    bench/peers/venv/bin/python bench/peers/generate.py";

/// Measures the peers in `contestants`, or in the folder that `generate.py` writes, and ours;
/// nothing where the folder is not there.
pub(crate) fn measure(contestants: Option<&Path>) -> Result<Vec<Entry>> {
    let written = workspace().join("bench/peers/contestants");
    let contestants = contestants.unwrap_or(&written);
    if !contestants.is_dir() {
        println!("peers: not run, there is no {}; make it with{SET_UP}", contestants.display());
        return Ok(Vec::new());
    }
    callgrind::available()?;
    let folder = scratch("peers")?;
    let peers = compile(contestants, &folder)?;
    let mut cases = Vec::new();
    for (_, family) in MAPPINGS {
        let variant = VARIANTS.into_iter().find(|variant| variant.family == family);
        let variant = variant.ok_or_else(|| Failure::new("a family is not measured"))?;
        for n in ORDERS {
            cases.push(Case::new(variant, n, Precision::F64, Guard::None));
        }
    }
    let sizes = c::compile(&cases, &folder)?;
    let objects: Vec<_> = peers.iter().map(|peer| peer.object.clone()).collect();
    let program = c::link(&driver(&cases, &peers), &cases, &objects, &folder)?;
    let profile = callgrind::profile(&program, &["count"], &folder.join("callgrind"))?;
    let vectors: Vec<_> = vectors::read(Precision::F64)?
        .into_iter()
        .map(Vector::with_unit_rate)
        .collect::<Result<_>>()?;

    let mut entries = Vec::new();
    let ours = cases.iter().zip(&sizes).enumerate().filter_map(|(index, (case, size))| {
        let step = format!("{}_step", case.name());
        Some((OURS, case.spec.family()?, case.spec.n, index, step, size.text))
    });
    let theirs = peers.iter().enumerate().map(|(index, peer)| {
        let Peer { name, family, n, symbol, text, .. } = peer;
        (name.as_str(), *family, *n, cases.len() + index, symbol.clone(), *text)
    });
    for (name, family, n, index, symbol, text) in ours.chain(theirs) {
        let mut of_it = Vec::new();
        for vector in &vectors {
            if vector.family()? == family && vector.n == n {
                of_it.push(vector);
            }
        }
        let lines: String = of_it.iter().map(|vector| evaluate::line(index, vector)).collect();
        let values = evaluate::evaluate(&program, &lines)?;
        let (mut early, mut deadline) = (0.0_f64, 0.0_f64);
        for (vector, u) in of_it.iter().zip(values) {
            let error = vector.error(u)?;
            deadline = deadline.max(error);
            if vector.time_to_go() >= 0.01 {
                early = early.max(error);
            }
        }
        let finite = |error: f64| error.is_finite().then_some(error);
        entries.push(Entry {
            name: name.to_owned(),
            family: family.name().to_owned(),
            n,
            step: profile.of(&symbol)?.mean(),
            text,
            early: finite(early),
            deadline: finite(deadline),
        });
    }
    Ok(entries)
}

/// Compiles every file of the mappings and orders, each function under a name of its own.
fn compile(contestants: &Path, folder: &Path) -> Result<Vec<Peer>> {
    let mut names: Vec<_> = std::fs::read_dir(contestants)
        .while_doing(contestants.display())?
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .collect();
    names.sort();
    let mut peers = Vec::new();
    for name in &names {
        for (mapping, family) in MAPPINGS {
            for n in ORDERS {
                let stem = contestants.join(name).join(format!("{mapping}_n{n}"));
                let source = ["c", "cc"].map(|extension| stem.with_extension(extension));
                let Some(source) = source.iter().find(|path| path.is_file()) else { continue };
                let symbol = format!("peer_{name}_{mapping}_n{n}");
                let object = folder.join(format!("{symbol}.o"));
                let is_c = source.extension().is_some_and(|extension| extension == "c");
                let mut compiler = Command::new(if is_c { "gcc" } else { "g++" });
                compiler.args(["-O2", "-w"]);
                run(compiler.arg("-c").arg(source).arg("-o").arg(&object))?;
                let text = c::symbol_sizes(&object)?.values().sum();
                run(Command::new("objcopy").arg("--keep-global-symbol=ptc_u").arg(&object))?;
                run(Command::new("objcopy")
                    .arg(format!("--redefine-sym=ptc_u={symbol}"))
                    .arg(&object))?;
                peers.push(Peer { name: name.clone(), family, n, symbol, object, text });
            }
        }
    }
    Ok(peers)
}

/// Points on the standard input, or with the argument `count` the calls that are counted.
fn driver(cases: &[Case], peers: &[Peer]) -> String {
    let mut peer_cases = String::new();
    let mut text = String::new();
    for (index, peer) in peers.iter().enumerate() {
        let (symbol, n) = (&peer.symbol, peer.n);
        let _ = writeln!(
            text,
            "double {symbol}(const double *, double, const double *, double, double, double);"
        );
        let _ = writeln!(
            peer_cases,
            "    case {}: return {symbol}(p + {x}, p[2], p + 6, p[0], p[1], p[4]);",
            cases.len() + index,
            x = 6 + n,
        );
    }
    let widest = ORDERS.into_iter().max().unwrap_or(1);
    let rows: Vec<_> = states(widest).iter().map(|row| format!("{{ {} }}", c::list(row))).collect();
    let _ = write!(
        text,
        "static double any(int which, const double *p)
{{
    switch (which) {{
{peer_cases}    default: return evaluate(which, p);
    }}
}}
static const double X[{CALLS}][{widest}] = {{ {} }};
static const double TIME[{CALLS}] = {{ {} }};
static const int N[] = {{ {} }};
int main(int argc, char **argv)
{{
    int which, length;
    double p[64];
    (void)argv;
    if (argc > 1) {{
        volatile double sum = 0.0;
        for (which = 0; which < {}; which++) for (int i = 0; i < {CALLS}; i++) {{
            int n = N[which];
            p[0] = 8.0; p[1] = 0.5; p[2] = TIME[i]; p[3] = 0.001; p[4] = 1.0; p[5] = 0.0;
            for (int j = 0; j < n; j++) {{ p[6 + j] = 1.5 + j % 3; p[6 + n + j] = X[i][j]; }}
            sum += any(which, p);
        }}
        return 0;
    }}
    while (scanf(\"%d %d\", &which, &length) == 2) {{
        for (int i = 0; i < length; i++) if (scanf(\"%lf\", &p[i]) != 1) return 1;
        printf(\"%.17g\\n\", any(which, p));
    }}
    return 0;
}}
",
        rows.join(", "),
        c::list(&times().collect::<Vec<_>>()),
        cases
            .iter()
            .map(|case| case.spec.n)
            .chain(peers.iter().map(|peer| peer.n))
            .map(|n| n.to_string())
            .collect::<Vec<_>>()
            .join(", "),
        cases.len() + peers.len(),
    );
    evaluate::driver(cases, &text)
}
