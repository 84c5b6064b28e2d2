//! Instruction counts, from the call records of one valgrind run.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use crate::failure::{Failure, Result, While};
use crate::tools::run;

/// Calls of a function and the instructions they took, callees included.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cost {
    pub(crate) calls: u64,
    pub(crate) instructions: u64,
}

impl Cost {
    /// Instructions a call.
    pub(crate) fn mean(self) -> f64 {
        self.instructions as f64 / self.calls.max(1) as f64
    }
}

/// Record of one run.
#[derive(Debug, Default)]
pub(crate) struct Profile {
    /// Instructions of the whole process.
    pub(crate) total: u64,
    functions: BTreeMap<String, Cost>,
}

impl Profile {
    /// The cost of calls of `function`.
    pub(crate) fn of(&self, function: &str) -> Result<Cost> {
        self.functions
            .get(function)
            .copied()
            .ok_or_else(|| Failure::new(format!("`{function}` was not called, or was inlined")))
    }
}

/// Stops early where valgrind is not installed.
pub(crate) fn available() -> Result<()> {
    run(Command::new("valgrind").arg("--version")).map(drop)
}

/// Runs `program` under callgrind; `out` takes the record.
pub(crate) fn profile(program: &Path, arguments: &[&str], out: &Path) -> Result<Profile> {
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=callgrind", "--compress-strings=no", "--compress-pos=no"]);
    valgrind.arg(format!("--callgrind-out-file={}", out.display()));
    run(valgrind.arg(program).args(arguments))?;
    let text = std::fs::read(out).while_doing(out.display())?;
    Ok(parse(&String::from_utf8_lossy(&text)))
}

/// Reads the records `cfn=`, `calls=` and the line of inclusive cost that follows them.
fn parse(text: &str) -> Profile {
    let mut profile = Profile::default();
    let mut callee = "";
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if let Some(name) = line.strip_prefix("cfn=") {
            callee = name;
        } else if let Some(calls) = line.strip_prefix("calls=") {
            let cost = profile.functions.entry(callee.to_owned()).or_default();
            cost.calls += first_number(calls);
            let inclusive = lines.next().and_then(|line| line.split_whitespace().nth(1));
            cost.instructions += inclusive.map_or(0, first_number);
        } else if let Some(total) = line.strip_prefix("totals:") {
            profile.total = first_number(total);
        }
    }
    profile
}

fn first_number(text: &str) -> u64 {
    text.split_whitespace().next().and_then(|word| word.parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn call_records_are_summed_by_callee() {
        let text = "fn=run\n0 5\ncfn=f_step\ncalls=64 0\n0 640\n0 1\ncfn=f_step\ncalls=1 0\n0 20\ntotals: 700\n";
        let profile = parse(text);
        let cost = profile.of("f_step").expect("it was called");
        assert_eq!((cost.calls, cost.instructions, profile.total), (65, 660, 700));
        assert!(profile.of("f_tick").is_err());
    }
}
