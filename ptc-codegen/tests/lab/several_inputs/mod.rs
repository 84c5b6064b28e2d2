//! Plants with several inputs in closed loop: `simulate` and `verify` against plants, laws and integrators
//! by hand.

mod barrier;
mod by_hand;
mod campaigns;
mod ends;
mod of_axes;
mod runs;
mod sampled;

use crate::support;

use support::{UNICYCLE, example, folder_with, run_in, without_design};

/// The head and the rows of a run of `simulate`, and what is said beside it.
fn run(test: &str, design: &str, further: &[&str]) -> (String, Vec<Vec<f64>>, String) {
    let folder = folder_with(&format!("several_inputs_{test}"), "plant.toml", design);
    let (code, csv, stderr) = run_in(&folder, &[&["simulate", "plant.toml"], further].concat());
    assert_eq!(code, Some(0), "{stderr}");
    let (head, rows) = csv.split_once('\n').expect("a head");
    (head.to_owned(), rows.lines().map(numbers).collect(), stderr)
}

/// The numbers of a line of CSV.
fn numbers(line: &str) -> Vec<f64> {
    line.split(',').filter_map(|cell| cell.parse().ok()).collect()
}

fn near(found: &[f64], wanted: &[f64], within: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?}, not {wanted:?}");
    let off = found.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= within, "{found:?}, not {wanted:?}");
}
