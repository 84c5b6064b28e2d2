//! Symbolica as an engine, from the side of the program that asks: one request to one worker.
//!
//! Symbolica ends its process where its licence does not let it run, and prints to the standard
//! output. So it lives in a program of its own, built by whoever may run it, and one runs at a time.

mod child;
mod postfix;
mod turn;
mod words;

use std::io::ErrorKind;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use crate::algebra::{Poly, Symbol};
use crate::expansion::ClosedForms;
use crate::expression::{Expression, Variable};
use crate::mapping::{Custom, Form, Mapping};
use serde_json::{Value, json};

use super::part::Part;
use crate::cli::report::Failure;
use child::Wrong;
use postfix::{Names, Polynomials};

/// The program that is the engine: beside this one, or where the system looks for programs.
const PROGRAM: &str = "ptc-engine-symbolica";

/// The variable of the environment with another path of it.
const PROGRAM_KEY: &str = "PTC_ENGINE_PROGRAM";

/// Time that a run waits for its turn, and then for its worker, unless the environment says otherwise.
const PATIENCE: Duration = Duration::from_secs(300);

/// The variable of the environment with that time in seconds.
const PATIENCE_KEY: &str = "PTC_ENGINE_TIMEOUT";

/// The closed forms of a ring: r_1 and D of each atom go to the worker.
pub(super) fn of_ring(n: usize, ring: &Mapping, part: Part) -> Result<ClosedForms, Failure> {
    let polys = || ring.derivations.iter().map(|(_, poly)| poly).chain([&ring.r1]);
    let atoms = ring.derivations.iter().map(|(atom, _)| *atom);
    let mut symbols: Vec<Symbol> = atoms.chain(polys().flat_map(Poly::symbols)).collect();
    symbols.sort_unstable();
    symbols.dedup();
    let place = |symbol: &Symbol| symbols.binary_search(symbol).unwrap_or(symbols.len());
    let derivation =
        |(atom, poly): &(Symbol, Poly)| json!([place(atom), postfix::of_poly(poly, &place)]);
    let answer = ask(&json!({
        "n": n,
        "r1": postfix::of_poly(&ring.r1, &place),
        "derivations": ring.derivations.iter().map(derivation).collect::<Vec<_>>(),
        "bell": part == Part::All,
    }))?;
    let poly = |text: &Value| {
        let poly = words::read(text.as_str()?, &Polynomials(&symbols))?;
        Some(ring.canonical(&poly))
    };
    let row = |row: &Value| row.as_array()?.iter().map(poly).collect::<Option<Vec<_>>>();
    let read = || {
        let r = row(&answer["r"])?;
        let bell = answer["bell"].as_array()?.iter().map(row).collect::<Option<Vec<_>>>()?;
        let rows = if part == Part::All { n + 1 } else { 0 };
        let whole = bell.iter().enumerate().all(|(i, row)| row.len() == i + 1);
        (r.len() == n && bell.len() == rows && whole).then_some(ClosedForms { r, bell })
    };
    read().ok_or_else(|| failure(&Wrong::Garbled(answer.to_string())))
}

/// r_1, ..., r_n of a mapping that the user wrote down: kappa, or tau - mu, goes to the worker.
pub(super) fn of_custom(n: usize, custom: &Custom) -> Result<Vec<Expression>, Failure> {
    let (key, form, variable) = match &custom.form {
        Form::Kappa(kappa) => ("kappa", &kappa.form, Variable::TimeToGo),
        Form::Complement(form) => ("complement", form, Variable::SinceStart),
    };
    let mut names = Names::new(variable.into());
    let text = postfix::of_expression(form, &mut names);
    let answer = ask(&json!({ "n": n, key: text }))?;
    let read = || {
        let expression = |text: &Value| words::read(text.as_str()?, &names);
        let r: Option<Vec<_>> = answer["r"].as_array()?.iter().map(expression).collect();
        r.filter(|r| r.len() == n)
    };
    read().ok_or_else(|| failure(&Wrong::Garbled(answer.to_string())))
}

/// The worker's answer, once no other run has one.
fn ask(request: &Value) -> Result<Value, Failure> {
    let patience = patience()?;
    let turn = turn::take(patience).map_err(|wrong| failure(&wrong))?;
    let answer = child::ask(Command::new(program()), &request.to_string(), patience);
    drop(turn);
    answer.map_err(|wrong| failure(&wrong))
}

/// The path of the engine, or its name.
fn program() -> PathBuf {
    if let Some(named) = std::env::var_os(PROGRAM_KEY).filter(|named| !named.is_empty()) {
        return named.into();
    }
    let name = format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX);
    let beside = std::env::current_exe().map(|own| own.with_file_name(&name));
    beside.ok().filter(|path| path.is_file()).unwrap_or_else(|| name.into())
}

fn patience() -> Result<Duration, Failure> {
    let Some(text) = std::env::var_os(PATIENCE_KEY) else { return Ok(PATIENCE) };
    let seconds = text.to_str().and_then(|text| text.parse().ok());
    seconds.and_then(|s| Duration::try_from_secs_f64(s).ok()).ok_or_else(|| {
        Failure::because(
            format!("{PATIENCE_KEY} is `{}`, which is no time", text.display()),
            "give a number of seconds, for example 300",
        )
    })
}

/// The error of a worker that gave no closed forms.
fn failure(wrong: &Wrong) -> Failure {
    let leave = "or leave `--engine` out";
    let help = match wrong {
        Wrong::Start(error) if error.kind() == ErrorKind::NotFound => format!(
            "build it with `cargo install --path engines/symbolica`, which needs Rust 1.89 or later (see \
             docs/engines.md for Symbolica's licence), or give its path in {PROGRAM_KEY}, {leave}"
        ),
        Wrong::Start(_) => format!("see that its file can be run, {leave}"),
        Wrong::Place(..) => {
            format!("give a file that can be locked in {}, {leave}", turn::FILE_KEY)
        }
        Wrong::Busy(..) | Wrong::Late(_) => {
            format!("wait for it to end, give more seconds in {PATIENCE_KEY}, {leave}")
        }
        Wrong::Aborted(_) => format!(
            "without a licence key Symbolica runs once for each user: end the other program that uses it, set \
             a key (https://symbolica.io/license/), {leave}"
        ),
        Wrong::Ended(..) => format!("try again; where memory is short give a lower n, {leave}"),
        Wrong::Refused(_) | Wrong::Garbled(_) => {
            format!(
                "the engine may be of another version: build it anew; else report it with the command, {leave}"
            )
        }
    };
    let mut failure = Failure::because(wrong.to_string(), &help);
    for notice in &mut failure.notices {
        notice.notes.extend(wrong.said());
    }
    failure
}
