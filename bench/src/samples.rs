//! `samples`: instructions of a step with a clock in samples, as a table or for the gate.

use std::fmt::Write as _;

use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::parse;

use crate::case::{Case, VARIANTS};
use crate::failure::{Failure, Result};
use crate::{c, callgrind, tools};

/// Samples of a run, over which the mean is taken.
const SAMPLES: u32 = 1000;

/// Orders of the chain.
const ORDERS: std::ops::RangeInclusive<usize> = 1..=4;

/// Samples of delay.
const DELAYS: std::ops::RangeInclusive<usize> = 0..=2;

/// A controller and its mean count.
pub(crate) struct Count {
    n: usize,
    delay: usize,
    /// Without guards and bound; otherwise with the default guard and a bound.
    bare: bool,
    pub(crate) step: f64,
}

impl Count {
    /// The name in the baseline.
    pub(crate) fn key(&self) -> String {
        let guard = if self.bare { "none" } else { "full" };
        format!("samples n={} delay={} {guard} step", self.n, self.delay)
    }
}

fn case(n: usize, delay: usize, bare: bool) -> Result<Case> {
    let poles: Vec<_> = (0..n).map(|i| format!("-{}", n + i)).collect();
    let guard = if bare { "none" } else { "full" };
    let keys = [
        ("name", format!("samples_n{n}_d{delay}_{guard}")),
        ("n", n.to_string()),
        ("mu", "exp(a=1)".to_owned()),
        ("clock", "samples".to_owned()),
        ("sample_time", "1e-3".to_owned()),
        ("tau", "1".to_owned()),
        ("delay", delay.to_string()),
        ("poles", poles.join(",")),
        ("guard", guard.to_owned()),
        ("u_max", if bare { "inf" } else { "1e30" }.to_owned()),
    ];
    Ok(Case { variant: VARIANTS[0], spec: spec(&keys)? })
}

fn spec(keys: &[(&str, String)]) -> Result<Spec> {
    let entry = |(key, text): &(&str, String)| {
        let value = parse(key, text, &mut |_| Place(0));
        let value = value.map_err(|found| Failure::new(format!("{key} = {text}: {found:?}")))?;
        Ok(Entry { key: (*key).to_owned(), place: Place(0), value })
    };
    let entries = keys.iter().map(entry).collect::<Result<Vec<_>>>()?;
    read(&entries).map_err(|found| Failure::new(format!("{keys:?}: {found:?}")))
}

/// Counts in C, by delay, then order, without guards first.
pub(crate) fn counts() -> Result<Vec<Count>> {
    callgrind::available()?;
    let folder = tools::scratch("samples")?;
    let designs: Vec<_> = DELAYS
        .flat_map(|delay| ORDERS.flat_map(move |n| [(n, delay, true), (n, delay, false)]))
        .collect();
    let cases = designs.iter().map(|(n, delay, bare)| case(*n, *delay, *bare));
    let cases = cases.collect::<Result<Vec<_>>>()?;
    c::compile(&cases, &folder)?;
    let program = c::link(&driver(&cases), &cases, &[], &folder)?;
    let profile = callgrind::profile(&program, &[], &program.with_extension("callgrind"))?;
    let count = |((n, delay, bare), case): ((usize, usize, bool), &Case)| {
        let step = profile.of(&format!("{}_step", case.name()))?.mean();
        Ok(Count { n, delay, bare, step })
    };
    designs.into_iter().zip(&cases).map(count).collect()
}

/// A program that runs each controller to its last sample, and fails where a step does.
fn driver(cases: &[Case]) -> String {
    let mut text = String::new();
    let mut runs = String::new();
    for case in cases {
        let name = case.name();
        let _ = writeln!(text, "#include \"{name}.h\"");
        let _ = writeln!(
            runs,
            "    {{
        {name} self; double u;
        const {name}_params params = {{ 0 }};
        failed |= {name}_init(&self, &params) != PTC_OK;
        for (uint32_t k = 0; k < {SAMPLES}u; k++) failed |= {name}_step(&self, k, x, &u) < 0;
    }}"
        );
    }
    let state = "static const double x[4] = { 0.5, 0.25, 0.125, 0.0625 };";
    text + &format!(
        "{state}\nint main(void) {{\n    int failed = 0;\n{runs}    return failed;\n}}\n"
    )
}

/// Prints a row of Markdown a delay: without guards and bound, and with both, for each order.
pub(crate) fn table() -> Result<()> {
    let counts = counts()?;
    for delay in DELAYS {
        let of_delay: Vec<_> = counts.iter().filter(|count| count.delay == delay).collect();
        let pair = |pair: &[&Count]| {
            pair.iter().map(|count| format!("{:.0}", count.step)).collect::<Vec<_>>().join(", ")
        };
        let cells: Vec<_> = of_delay.chunks(2).map(pair).collect();
        println!("| {delay} | {} |", cells.join(" | "));
    }
    Ok(())
}
