//! The calls that are counted, the same in both languages: 64 calls with time-to-go spread evenly
//! from tau to 0.03 tau and states in -2..2.

use std::fmt::Write as _;

use crate::c;
use crate::case::Case;

/// Calls of each function.
pub(crate) const CALLS: usize = 64;

/// The states, one row a call, from a linear congruential generator.
pub(crate) fn states(n: usize) -> Vec<Vec<f64>> {
    let mut seed: u32 = 12345;
    let mut draw = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        // Multiples of 2^-10, exact in both precisions.
        f64::from(seed >> 20) / 1024.0 - 2.0
    };
    (0..CALLS).map(|_| (0..n).map(|_| draw()).collect()).collect()
}

/// The times, for t0 = 0.5 and tau = 8.
pub(crate) fn times() -> impl Iterator<Item = f64> {
    (0..CALLS).map(|i| 0.5 + 8.0 * 0.97 * i as f64 / (CALLS - 1) as f64)
}

/// The driver in C: for each case one function that sets it up and makes the calls. It prints the
/// name of each case that does not set up, or in which a call fails.
pub(crate) fn c_driver(cases: &[Case]) -> String {
    let real = cases.first().map_or("double", Case::c_real);
    let widest = cases.iter().map(|case| case.spec.n).max().unwrap_or(1);
    let mut text = String::from("#include <stdio.h>\n");
    for case in cases {
        let _ = writeln!(text, "#include \"{}.h\"", case.name());
    }
    let rows: Vec<_> = states(widest).iter().map(|row| format!("{{ {} }}", c::list(row))).collect();
    let _ = writeln!(text, "static const {real} X[{CALLS}][{widest}] = {{ {} }};", rows.join(", "));
    let _ = writeln!(
        text,
        "static const {real} TIME[{CALLS}] = {{ {} }};",
        c::list(&times().collect::<Vec<_>>())
    );
    for case in cases {
        let name = case.name();
        let fields = case.parameters();
        let fields: Vec<_> = fields.iter().map(|(f, values)| (*f, c::digits(values))).collect();
        let parameters = c::parameters(&fields);
        let _ = writeln!(
            text,
            "int run_{name}(void) {{
    {name} self; {name}_gains gains; {real} u; int failed = 0;
    const {name}_params params = {parameters};
    if ({name}_init(&self, &params) != PTC_OK) return 1;
    for (int i = 0; i < {CALLS}; i++) failed += {name}_step(&self, TIME[i], X[i], &u) < 0;
    for (int i = 0; i < {CALLS}; i++) {{
        failed += {name}_tick(&self, TIME[i], &gains) < 0;
        failed += {name}_axis(&gains, X[i], &u) < 0;
    }}
    return failed;
}}"
        );
    }
    text.push_str("int main(void) {\n");
    for case in cases {
        let name = case.name();
        let _ = writeln!(text, "    if (run_{name}()) puts(\"{name}\");");
    }
    text + "    return 0;\n}\n"
}

/// The driver in Rust. Each function is called through a wrapper that is not inlined and into
/// which it is.
pub(crate) fn rust_driver(cases: &[Case]) -> String {
    let real = cases.first().map_or("f64", Case::real);
    let mut text = String::from("use std::hint::black_box;\n");
    for case in cases {
        let (name, n, own) = (case.name(), case.spec.n, case.spec.type_name());
        let rows: Vec<_> = states(n).iter().map(|row| format!("[{}]", c::list(row))).collect();
        let rows = rows.join(", ");
        let times = c::list(&times().collect::<Vec<_>>());
        let parameters: Vec<_> = case
            .parameters()
            .iter()
            .map(|(field, values)| {
                let values = c::list(values);
                if Case::is_array(field) {
                    format!("{field}: [{values}]")
                } else {
                    format!("{field}: {values}")
                }
            })
            .collect();
        let parameters = parameters.join(", ");
        let _ = writeln!(
            text,
            "mod {name};
mod run_{name} {{
    use std::hint::black_box;
    use super::{name}::{{Control, Error, {own}, {own}Gains, {own}Params}};
    #[unsafe(no_mangle)]
    #[inline(never)]
    pub fn {name}_step(c: &{own}, t: {real}, x: &[{real}; {n}]) -> Result<Control<{real}>, Error> {{
        c.step(t, x)
    }}
    #[unsafe(no_mangle)]
    #[inline(never)]
    pub fn {name}_tick(c: &{own}, t: {real}) -> Result<{own}Gains, Error> {{
        c.tick(t)
    }}
    #[unsafe(no_mangle)]
    #[inline(never)]
    pub fn {name}_axis(g: &{own}Gains, x: &[{real}; {n}]) -> Result<Control<{real}>, Error> {{
        g.axis(x)
    }}
    static X: [[{real}; {n}]; {CALLS}] = [{rows}];
    static TIME: [{real}; {CALLS}] = [{times}];
    pub fn run() -> Result<(), Error> {{
        let c = black_box({own}::new({own}Params {{ {parameters} }})?);
        for (t, x) in TIME.iter().zip(&X) {{
            black_box({name}_step(&c, *t, x)?);
        }}
        for (t, x) in TIME.iter().zip(&X) {{
            black_box({name}_axis(&{name}_tick(&c, *t)?, x)?);
        }}
        Ok(())
    }}
}}"
        );
    }
    text.push_str("fn main() {\n");
    for case in cases {
        let name = case.name();
        let _ = writeln!(
            text,
            "    if black_box(run_{name}::run()).is_err() {{ println!(\"{name}\"); }}"
        );
    }
    text + "}\n"
}
