//! `axes`: a step of several axes in C, as compilers make vectors of it, beside `tick` and then `axis` for
//! each.

use std::fmt::Write as _;

use ptc_codegen::family::Family;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::{Axes, Guard};
use serde::{Deserialize, Serialize};

use crate::calls::{CALLS, states, times};
use crate::case::{Case, VARIANTS};
use crate::counts::works;
use crate::failure::Result;
use crate::tools::{parallel, scratch};
use crate::{c, callgrind};

/// The orders that are measured.
const ORDERS: [usize; 3] = [3, 6, 12];

/// The numbers of axes.
const COUNTS: [usize; 4] = [1, 2, 4, 8];

/// Flags behind `-std=c99 -O2`.
pub(crate) const FLAGS: [&[&str]; 3] = [&[], &["-O3"], &["-O3", "-mavx2"]];

/// exp with guard `full` in f64, at one order and number of axes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Step {
    pub(crate) n: usize,
    pub(crate) count: usize,
    /// Mean instructions of a step with each of [`FLAGS`], and of `tick` and so many times `axis`.
    pub(crate) found: Vec<(f64, f64)>,
}

/// Measures each of them.
pub(crate) fn measure() -> Result<Vec<Step>> {
    callgrind::available()?;
    let exp = VARIANTS.into_iter().filter(|variant| variant.family == Family::Exp);
    let cases = exp.flat_map(|exp| ORDERS.map(|n| (exp, n))).flat_map(|(exp, n)| {
        COUNTS.map(|count| {
            let mut case = Case::new(exp, n, Precision::F64, Guard::Full);
            case.spec.axes = Some(Axes {
                count,
                gains: Vec::new(),
                poles: Vec::new(),
                exponents: Vec::new(),
                limits: Vec::new(),
                lower: Vec::new(),
                state_max: Vec::new(),
                input_gains: Vec::new(),
                laws: Vec::new(),
                references: Vec::new(),
            });
            case.spec.name = Some(format!("{}_of_{count}", case.name()));
            (case, count)
        })
    });
    let cases: Vec<_> = cases.collect();
    let columns = parallel(&FLAGS.map(|flags| flags), |flags| column(&cases, flags))?;
    let row = |(at, (case, count)): (usize, &(Case, usize))| Step {
        n: case.spec.n,
        count: *count,
        found: columns.iter().map(|column| column[at]).collect(),
    };
    Ok(cases.iter().enumerate().map(row).collect())
}

/// Measures each case, compiled with further flags.
fn column(cases: &[(Case, usize)], flags: &[&str]) -> Result<Vec<(f64, f64)>> {
    let folder = scratch(&format!("axes{}", flags.concat()))?;
    let only: Vec<_> = cases.iter().map(|(case, _)| case.clone()).collect();
    c::compile_with(&only, flags, &folder)?;
    let program = c::link(&driver(cases), &only, &[], &folder)?;
    works(&program)?;
    let profile = callgrind::profile(&program, &[], &program.with_extension("callgrind"))?;
    let one = |(case, count): &(Case, usize)| {
        let of = |function: &str| -> Result<f64> {
            Ok(profile.of(&format!("{}_{function}", case.name()))?.mean())
        };
        let (step, tick, axis) = (of("step")?, of("tick")?, of("axis")?);
        Ok((step, tick + *count as f64 * axis))
    };
    cases.iter().map(one).collect()
}

/// Calls `step`, then `tick` and `axis`, with a row of states for each axis.
fn driver(cases: &[(Case, usize)]) -> String {
    let mut text = String::from("#include <stdio.h>\n");
    for (case, count) in cases {
        let (name, n) = (case.name(), case.spec.n);
        let rows = states(n * count).iter().map(|row| c::list(row)).collect::<Vec<_>>().join(", ");
        let fields = case.parameters();
        let fields: Vec<_> = fields.iter().map(|(f, values)| (*f, c::digits(values))).collect();
        let (parameters, times) = (c::parameters(&fields), c::list(&Vec::from_iter(times())));
        let _ = writeln!(
            text,
            "#include \"{name}.h\"
static const double X_{name}[{CALLS}][{count}][{n}] = {{ {rows} }};
static const double TIME_{name}[{CALLS}] = {{ {times} }};
static int run_{name}(void) {{
    {name} self; {name}_gains gains; double u[{count}]; ptc_status axes[{count}]; int failed = 0;
    const {name}_params params = {parameters};
    if ({name}_init(&self, &params) != PTC_OK) return 1;
    for (int i = 0; i < {CALLS}; i++) {{
        failed += {name}_step(&self, TIME_{name}[i], X_{name}[i], u, axes) < 0;
        failed += {name}_tick(&self, TIME_{name}[i], &gains) < 0;
        for (int axis = 0; axis < {count}; axis++)
            failed += {name}_axis(&gains, X_{name}[i][axis], &u[axis]) < 0;
    }}
    return failed;
}}"
        );
    }
    text.push_str("int main(void) {\n");
    for (case, _) in cases {
        let name = case.name();
        let _ = writeln!(text, "    if (run_{name}()) puts(\"{name}\");");
    }
    text + "    return 0;\n}\n"
}
