//! The program that calls every contestant, and what it prints.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::{DESIGNS, Design, Peer};
use crate::c;
use crate::calls::{CALLS, states};
use crate::failure::{Result, While};

/// Makes the calls of every function and prints its name and every u.
pub(super) fn driver(peers: &[Peer]) -> String {
    let mut text = String::from("#include <stdio.h>\n");
    let mut calls = String::new();
    for (at, Design { name, tau, outputs, scale, .. }) in DESIGNS.iter().enumerate() {
        let scaled = |row: &Vec<f64>| {
            c::list(&row.iter().zip(*scale).map(|(x, scale)| x * scale).collect::<Vec<_>>())
        };
        let rows = states(scale.len()).iter().map(scaled).collect::<Vec<_>>().join(" }, { ");
        let time = |call: usize| 0.97 * tau * call as f64 / (CALLS - 1) as f64;
        let times = c::list(&(0..CALLS).map(time).collect::<Vec<_>>());
        let _ = writeln!(
            text,
            "#include \"{name}.h\"
static const double X_{name}[{CALLS}][{n}] = {{ {{ {rows} }} }};
static const double TIME_{name}[{CALLS}] = {{ {times} }};",
            n = scale.len()
        );
        let mut call = |symbol: &str, of_it: &str| {
            let _ = writeln!(
                calls,
                "    for (int i = 0; i < {CALLS}; i++) {{
        {of_it};
        printf(\"{symbol}\");
        for (int j = 0; j < {outputs}; j++) printf(\" %.17g\", u[j]);
        puts(\"\");
    }}"
            );
        };
        let (t, x) = (format!("TIME_{name}[i]"), format!("X_{name}[i]"));
        let axes = if *outputs > 1 { ", axes" } else { "" };
        call(
            &format!("{name}_step"),
            &format!("if ({name}_step(&of_{name}, {t}, {x}, u{axes}) < PTC_OK) return 1"),
        );
        for Peer { symbol, .. } in peers.iter().filter(|peer| peer.design == at) {
            let _ = writeln!(text, "void {symbol}(const double *, double, double *);");
            call(symbol, &format!("{symbol}({x}, {t}, u)"));
        }
    }
    text.push_str("int main(void) {\n    double u[2]; ptc_status axes[2];\n");
    for Design { name, .. } in &DESIGNS {
        let _ = writeln!(
            text,
            "    {name} of_{name}; const {name}_params params_{name} = {{ 0 }};
    if ({name}_init(&of_{name}, &params_{name}) != PTC_OK) return 1;"
        );
    }
    text + &calls + "    return 0;\n}\n"
}

/// Every u of every function.
pub(super) fn values(text: &str) -> Result<BTreeMap<String, Vec<f64>>> {
    let mut all: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for line in text.lines() {
        let mut words = line.split(' ');
        let of_it = all.entry(words.next().unwrap_or_default().to_owned()).or_default();
        for word in words {
            of_it.push(word.parse().while_doing(line)?);
        }
    }
    Ok(all)
}

/// The largest relative difference; infinite where values are missing or no numbers.
pub(super) fn difference(ours: &[f64], theirs: &[f64]) -> f64 {
    if ours.len() != theirs.len() || ours.is_empty() {
        return f64::INFINITY;
    }
    let relative = |(a, b): (&f64, &f64)| if a == b { 0.0 } else { ((a - b) / a).abs() };
    ours.iter()
        .zip(theirs)
        .map(relative)
        .fold(0.0, |most: f64, one| if one.is_nan() { f64::INFINITY } else { most.max(one) })
}
