//! Points through compiled C: one driver reads `case tau t0 t eps a m rates k x` a line, with start in place
//! of m where a family has that, and writes u a line. An unused parameter is 0.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use ptc_codegen::mapping::TimeMapping;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Guard;

use crate::c;
use crate::case::{Case, VARIANTS};
use crate::failure::{Failure, Result};
use crate::tools::run_with;
use crate::vectors::Vector;

/// Controllers for the family, order and number of rates of each vector, every parameter at run
/// time, and the index of its controller for each vector.
pub(crate) fn cases_for(
    vectors: &[&Vector],
    precision: Precision,
) -> Result<(Vec<Case>, Vec<usize>)> {
    let mut found: BTreeMap<_, usize> = BTreeMap::new();
    let mut cases = Vec::new();
    let mut indices = Vec::new();
    for vector in vectors {
        let (family, rates) = (vector.family()?, vector.params.rates.len());
        let index = *found.entry((family, vector.n, rates)).or_insert_with(|| {
            let variant = VARIANTS.into_iter().find(|variant| variant.family == family);
            let variant = variant.unwrap_or(VARIANTS[0]);
            let mut case = Case::new(variant, vector.n, precision, Guard::None);
            case.spec.time_mapping = TimeMapping::Family { family, rates };
            case.spec.name = Some(format!("{}_n{}_r{rates}", family.name(), vector.n));
            cases.push(case);
            cases.len() - 1
        });
        indices.push(index);
    }
    Ok((cases, indices))
}

/// The function `evaluate(case, p, &u)` for `cases`, and the `main` that calls it.
pub(crate) fn driver(cases: &[Case], more: &str) -> String {
    let mut text = String::from("#include <stdio.h>\n#include <math.h>\n");
    for case in cases {
        let _ = writeln!(text, "#include \"{}.h\"", case.name());
    }
    text.push_str("static double evaluate(int which, const double *p)\n{\n    switch (which) {\n");
    for (index, case) in cases.iter().enumerate() {
        let (name, real, n, rates) = (case.name(), case.c_real(), case.spec.n, case.spec.rates());
        let field = |field: &str, from: usize, length: usize| {
            let values = (from..from + length).map(|i| format!("({real})p[{i}]")).collect();
            (field.to_owned(), values)
        };
        let mut fields = vec![field("tau", 0, 1), field("t0", 1, 1), field("eps", 3, 1)];
        let run_time = case.parameters();
        for (name, from, length) in [("a", 4, 1), ("m", 5, 1), ("start", 5, 1), ("rates", 6, rates)]
        {
            if run_time.iter().any(|(f, _)| *f == name) {
                fields.push(field(name, from, length));
            }
        }
        fields.push(field("k", 6 + rates, n));
        let fields: Vec<_> =
            fields.iter().map(|(f, v): &(String, _)| (f.as_str(), Vec::clone(v))).collect();
        let parameters = c::parameters(&fields);
        let _ = writeln!(
            text,
            "    case {index}: {{
        {name} self; {real} u = 0, x[{n}];
        const {name}_params params = {parameters};
        for (int i = 0; i < {n}; i++) x[i] = ({real})p[{x} + i];
        if ({name}_init(&self, &params) != PTC_OK) return NAN;
        if ({name}_step(&self, ({real})p[2], x, &u) < 0) return NAN;
        return u;
    }}",
            x = 6 + rates + n,
        );
    }
    text.push_str("    default: return NAN;\n    }\n}\n");
    text.push_str(more);
    text
}

/// A `main` that evaluates the points on its standard input.
pub(crate) const MAIN: &str = "int main(void)
{
    int which, length;
    double p[64];
    while (scanf(\"%d %d\", &which, &length) == 2) {
        for (int i = 0; i < length; i++) if (scanf(\"%lf\", &p[i]) != 1) return 1;
        printf(\"%.17g\\n\", evaluate(which, p));
    }
    return 0;
}
";

/// The line of one point.
pub(crate) fn line(which: usize, vector: &Vector) -> String {
    let Vector { params, tau, t0, t, k, x, .. } = vector;
    // Below every time-to-go of the vectors, so that none is held.
    let eps = tau * 1e-14;
    // No family has both m and start; what a family lacks is 0.
    let mut values = vec![*tau, *t0, *t, eps, params.a, params.m + params.start];
    values.extend(params.rates.iter().chain(k).chain(x));
    let digits: Vec<_> = values.iter().map(|value| format!("{value:e}")).collect();
    format!("{which} {} {}\n", digits.len(), digits.join(" "))
}

/// u of each line, by `program`.
pub(crate) fn evaluate(program: &Path, lines: &str) -> Result<Vec<f64>> {
    let text = run_with(&mut Command::new(program), lines)?;
    let read =
        |word: &str| word.parse().map_err(|_| Failure::new(format!("`{word}` is not a number")));
    let values: Vec<f64> = text.lines().map(read).collect::<Result<_>>()?;
    if values.len() == lines.lines().count() {
        return Ok(values);
    }
    Err(Failure::new("the driver stopped early"))
}
