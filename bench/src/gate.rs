//! `gate`: compares counts of a small subset with those kept in `baseline.json`.

use std::collections::BTreeMap;
use std::path::PathBuf;

use ptc_codegen::request::Guard;
use serde::{Deserialize, Serialize};

use crate::case::guard_name;
use crate::failure::{Failure, Result, While};
use crate::{callgrind, counts, samples, tools};

/// The orders of the subset with a clock in time: every family, both precisions, in C.
const ORDERS: [usize; 4] = [1, 3, 6, 12];

/// Its guards: the leanest and the default, whose counts have its name behind them.
const GUARDS: [(Guard, &str); 2] = [(Guard::None, ""), (Guard::Full, " full")];

/// Accepted ratio of a count to its baseline.
const TOLERANCE: f64 = 1.02;

/// The counts that are kept.
#[derive(Debug, Serialize, Deserialize)]
struct Baseline {
    /// Tools that counted; other versions may count differently.
    counted_with: Vec<String>,
    counts: BTreeMap<String, f64>,
}

/// Fails when a count rose; `update` writes the counts of now instead.
pub(crate) fn gate(update: bool) -> Result<()> {
    callgrind::available()?;
    let mut now = BTreeMap::new();
    for count in counts::in_c("gate", &ORDERS, &GUARDS.map(|(guard, _)| guard))? {
        let key = format!("{} n={} {}", count.key.variant, count.key.n, count.key.precision);
        let of_guard = |(guard, _): &&(Guard, &str)| guard_name(*guard) == count.key.guard;
        let behind = GUARDS.iter().find(of_guard).map_or("", |(_, behind)| behind);
        for (function, value) in [("step", count.step), ("tick", count.tick), ("axis", count.axis)]
        {
            now.insert(format!("{key} {function}{behind}"), rounded(value));
        }
    }
    now.extend(samples::counts()?.iter().map(|count| (count.key(), rounded(count.step))));
    let path: PathBuf = tools::workspace().join("bench/baseline.json");
    // The compilers and the library; not the processor, whose kind does not change a count.
    let counted_with = tools::machine().into_iter().skip(1).collect();
    if update {
        let baseline = Baseline { counted_with, counts: now };
        std::fs::write(&path, serde_json::to_string_pretty(&baseline)? + "\n")?;
        println!("wrote {} counts to bench/baseline.json", baseline.counts.len());
        return Ok(());
    }
    let text = std::fs::read_to_string(&path).while_doing("bench/baseline.json")?;
    let baseline: Baseline = serde_json::from_str(&text).while_doing("bench/baseline.json")?;
    if baseline.counted_with != counted_with {
        println!("note: the baseline was counted with {}", baseline.counted_with.join("; "));
        println!("      and this run with {}", counted_with.join("; "));
    }
    compare(&baseline.counts, &now)
}

/// With two decimals.
fn rounded(count: f64) -> f64 {
    (count * 100.0).round() / 100.0
}

fn compare(baseline: &BTreeMap<String, f64>, now: &BTreeMap<String, f64>) -> Result<()> {
    let (mut worse, mut better) = (0, 0);
    for (key, count) in now {
        let Some(before) = baseline.get(key) else {
            println!("new       {key}: {count}");
            worse += 1;
            continue;
        };
        let percent = 100.0 * (count / before - 1.0);
        if *count > before * TOLERANCE {
            println!("worse     {key}: {before} -> {count} ({percent:+.1} %)");
            worse += 1;
        } else if count < before {
            println!("improved  {key}: {before} -> {count} ({percent:+.1} %)");
            better += 1;
        }
    }
    let gone = baseline.keys().filter(|key| !now.contains_key(*key)).count();
    println!("{} counts: {worse} worse or new, {better} improved, {gone} gone", now.len());
    if worse + gone == 0 {
        return Ok(());
    }
    Err(Failure::new(
        "counts rose above the baseline; if that is meant: cargo run --release -p ptc-bench -- gate --update",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_percent_pass_and_three_do_not() {
        let baseline = BTreeMap::from([("a".to_owned(), 100.0)]);
        let now = |count| BTreeMap::from([("a".to_owned(), count)]);
        assert!(compare(&baseline, &now(102.0)).is_ok());
        assert!(compare(&baseline, &now(50.0)).is_ok());
        assert!(compare(&baseline, &now(103.0)).is_err());
        assert!(compare(&baseline, &BTreeMap::new()).is_err());
    }
}
