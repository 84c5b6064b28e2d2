//! The program that is counted and timed: controllers with a fixed deadline, with one that is put off, and with one that
//! is planned at every sample, in this order for each kind.

use std::fmt::Write as _;

use super::costs::{ROUNDS, STATES};
use super::draw::Draw;
use crate::c;
use crate::case::Case;

/// States from which a loop is run to rest.
const RUNS: usize = 60;

/// Orders of the chains.
const ORDERS: std::ops::RangeInclusive<usize> = 2..=4;

/// With an argument: runs of each controller to rest, and `soonest` from every state. Otherwise the time of `soonest` in s,
/// a line a kind.
pub(super) fn driver(cases: &[Case]) -> String {
    let mut text = "#include <stdio.h>\n#include <time.h>\n#include <stdint.h>\n".to_owned();
    text.extend(cases.iter().map(|case| format!("#include \"{}.h\"\n", case.name())));
    let mut draw = Draw::default();
    let mut row = || format!("{{ {} }}", c::list(&[0; 4].map(|_| draw.even(-0.3, 0.3))));
    let rows: Vec<_> = (0..STATES).map(|_| row()).collect();
    let rows = rows.join(",\n");
    let _ = writeln!(text, "static const double X[{STATES}][4] = {{ {rows} }};");
    text.push_str("static volatile uint32_t sum;\n");
    text.extend(ORDERS.map(plant));
    let (mut counted, mut timed) = (String::new(), String::new());
    for kind in cases.chunks(3) {
        counted.extend(kind.iter().zip([false, true, true]).map(|(case, plans)| runs(case, plans)));
        if let Some(case) = kind.get(1) {
            counted.push_str(&format!("    {{ {} {} }}\n", begun(case), searches(case)));
            timed.push_str(&timing(case));
        }
    }
    for (name, body) in [("counted", counted), ("timed", timed)] {
        let _ = writeln!(
            text,
            "static int {name}(void) {{\n    int failed = 0;\n{body}    return failed;\n}}"
        );
    }
    text + "int main(int argc, char **argv) { (void)argv; return argc > 1 ? counted() : timed(); }\n"
}

/// A function that moves a chain by a sample: x_i at the next one is the sum of h^j/j! times the states behind it, and of u.
fn plant(n: usize) -> String {
    let mut text =
        format!("static void move_{n}(double *x, double u) {{\n    const double h = 1e-3;\n");
    for i in 0..n {
        let (mut sum, mut factor) = (format!("x[{i}]"), "h".to_owned());
        for j in i + 1..=n {
            let next = if j < n { format!("x[{j}]") } else { "u".to_owned() };
            let _ = write!(sum, " + {factor} * {next}");
            let _ = write!(factor, " * h / {}.0", j - i + 1);
        }
        let _ = writeln!(text, "    x[{i}] = {sum};");
    }
    text + "}\n"
}

/// Statements that set a controller up.
fn begun(case: &Case) -> String {
    let name = case.name();
    format!(
        "{name} self; const {name}_params params = {{ 0 }}; failed |= {name}_init(&self, &params) != PTC_OK;"
    )
}

/// Statements that call `soonest` for every state.
fn searches(case: &Case) -> String {
    let name = case.name();
    format!(
        "for (int i = 0; i < {STATES}; i++) {{ uint32_t samples; {name}_soonest(&self, X[i], &samples); sum += samples; }}"
    )
}

/// Runs to rest, with a deadline of 800 samples or one that is planned.
fn runs(case: &Case, plans: bool) -> String {
    let (name, n) = (case.name(), case.spec.n);
    let (starts, ends) = match plans {
        true => (
            format!("{name}_soonest(&self, x, &samples); {name}_arm_for(&self, 0u, samples);"),
            format!("{name}_deadline(&self, &samples);"),
        ),
        false => (format!("{name}_arm(&self, 0u);"), String::new()),
    };
    format!(
        "    {{
        double u, x[4];
        {}
        for (int i = 0; i < {RUNS}; i++) {{
            uint32_t samples = 800u;
            for (int j = 0; j < 4; j++) x[j] = X[i][j];
            {starts}
            for (uint32_t k = 0; k < samples; k++) {{
                failed |= {name}_step(&self, k, x, &u) < 0;
                move_{n}(x, u);
                {ends}
            }}
        }}
    }}
",
        begun(case)
    )
}

/// The mean time of `soonest`, in the quickest of all rounds.
fn timing(case: &Case) -> String {
    format!(
        "    {{
        {}
        double least = 1.0;
        for (int round = 0; round < {ROUNDS}; round++) {{
            const clock_t start = clock();
            for (int again = 0; again < 10; again++) {}
            const double time = (double)(clock() - start) / CLOCKS_PER_SEC / {STATES} / 10.0;
            if (time < least) least = time;
        }}
        printf(\"%.4e\\n\", least);
    }}
",
        begun(case),
        searches(case)
    )
}
