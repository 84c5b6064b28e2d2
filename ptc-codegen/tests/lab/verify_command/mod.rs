//! `verify` as it is run: objectives with known answers, parts that merge exactly, runs that are
//! interrupted, and bad input.

mod mistakes;
mod parts;
use crate::support;
mod verdicts;

use std::path::{Path, PathBuf};
use std::process::Command;

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = support::command(&["verify"]);
    command.args(arguments).current_dir(folder);
    command
}

fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    support::told(&mut command(folder, arguments))
}

/// A folder of a test's own that holds `stage.toml`.
fn folder(test: &str, design: &str) -> PathBuf {
    support::folder_with(&format!("verify_{test}"), "stage.toml", design)
}

/// x1 = 3T^2 - 2T^3, x2 = -6T + 6T^2 and u = 3 - 6T from (1, 0) with tau = 1.
const STAGE: &str = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\ng = 2\ngains = [6, 5]\n\
                     [params]\ntau = 1\n[plant]\nf = 0\n\
                     [verify]\nx1 = 1\nx2 = 0\nscenarios = 2\nsearch = 2\n";

/// x' = -2x/T + d, |d| <= 1, from 0: the worst d is a bound throughout, with x = T - T^2.
const DRIVEN: &str = "n = 1\nmu = \"exp(a=1)\"\ngains = [2]\n[params]\ntau = 1\n\
                      [plant]\nf = \"d\"\nd = [-1, 1]\n[disturbance]\nd = \"worst\"\n\
                      [verify]\nx1 = 0\nscenarios = 4\nsearch = 200\n";

/// Gain and damping that are not known, a disturbance of any kind, boxes of x0 and tau.
const UNCERTAIN: &str = "n = 1\nmu = \"exp(a=1)\"\npoles = [-4]\n\
                         [plant]\nf = \"gust - damping*x1 + b*u\"\ndamping = [0, 0.5]\n\
                         gust = [-0.1, 0.1]\nb = [-0.2, 0.2]\n[disturbance]\ngust = \"any\"\n\
                         [verify]\nx1 = [-1, 1]\ntau = [0.5, 2]\nscenarios = 130\n\
                         search = 10\nseed = 11\n[[objective]]\nbound = \"attractive\"\n\
                         error = 1e-2\n[[objective]]\nbound = \"within\"\nh = \"x1\"\n\
                         low = -2\nhigh = 2\n";

/// Its start, its gain and the rate of its mapping not known either, with what it spends.
fn spending() -> String {
    let drawn = "[verify]\nt0 = [-5, 5]\na = [1, 1.5]\nk1 = [3.5, 4.5]\n";
    let spent = objective("bound = \"within\"\nh = \"integral(integral(u^2)) + x1\"\nhigh = 30");
    let design = UNCERTAIN.replace("exp(a=1)", "exp").replace("poles = [-4]\n", "");
    let design = design.replace("[verify]\n", drawn);
    format!("{}{spent}", design.replace("error = 1e-2", "error = 1"))
}

fn objective(text: &str) -> String {
    format!("[[objective]]\n{text}\n")
}
