//! The way in which scenarios are run: by the interpreter, or by the controller in C with its plant, compiled.

use clap::ValueEnum;

use super::program::{Program, Wrong};
use crate::accepted::Accepted;
use crate::check::examine::examine_resolved;
use crate::cli::progress::checking;
use crate::cli::report::{self, Failure, Notice};
use crate::emit::campaign;
use crate::internal::Internal;
use crate::verify::{Agreement, Campaign, Trial};

/// The flag `--runner`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Runner {
    /// Compiled, if that is known to be faster
    #[default]
    Auto,
    /// By the interpreter of the emitted code
    Interpreted,
    /// By the emitted C, compiled
    Compiled,
}

/// Samples of a campaign from which on it takes longer than a compiler does.
const LONG: f64 = 2e6;

/// Largest difference, as a part of the largest value of a run, where both ways call another mathematical library.
const CLOSE: f64 = 1e-9;

/// Why scenarios are not run by a compiled program.
enum Why {
    /// The campaign is none of those, or is short.
    Plain(String),
    /// A tool failed, with what it said.
    Tool(Wrong),
}

/// Prepares a trial to run so many scenarios, and says how it does. The program is there as long as what is returned.
pub(super) fn prepare(
    runner: Runner,
    campaign: &Campaign,
    trial: &mut Trial,
    scenarios: u64,
) -> Result<Option<Program>, Failure> {
    if runner == Runner::Interpreted || (runner == Runner::Auto && !is_long(campaign, scenarios)) {
        return Ok(None);
    }
    let judged = match compiled(campaign, trial) {
        Ok(candidate) => candidate.judged(runner)?,
        Err(why) => Err(why),
    };
    let why = match judged {
        Ok((program, told)) => {
            report::note(&told);
            return Ok(Some(program));
        }
        Err(why) => why,
    };
    trial.interpreted();
    match (runner, why) {
        (Runner::Compiled, why) => Err(why.failure()),
        (_, Why::Plain(told) | Why::Tool(Wrong { told, .. })) => {
            report::note(&format!("runner: interpreted, as {told}"));
            Ok(None)
        }
    }
}

/// Says which scenarios the interpreter had to run in place of a compiled program.
pub(super) fn faults(trial: &Trial) {
    let faults = trial.faults();
    if !faults.is_empty() {
        report::print(&[Notice {
            notes: faults.iter().take(5).cloned().collect(),
            help: Some(
                "their rows are those of the interpreter; run one with --scenario, and report what ends the \
                 compiled controller"
                    .to_owned(),
            ),
            warns: true,
            ..Notice::of(format!("the compiled controller was ended by {} scenarios", faults.len()))
        }]);
    }
}

/// Returns true if so many scenarios are worth a compiler.
#[allow(clippy::cast_precision_loss)]
fn is_long(campaign: &Campaign, scenarios: u64) -> bool {
    let samples = |period: f64| campaign.tau.1 * campaign.length() / period * scenarios as f64;
    campaign.around.as_ref().is_some_and(|around| samples(around.period) >= LONG)
}

/// A program, and how its runs compare with those of the interpreter.
struct Candidate {
    program: Program,
    /// True if its controller calls a mathematical library.
    calls_library: bool,
    /// `None` if it runs no scenario.
    agreement: Option<Agreement>,
    /// How a scenario ended its process, if one did.
    fault: Option<String>,
}

fn compiled(campaign: &Campaign, trial: &mut Trial) -> Result<Candidate, Why> {
    let script = trial.script(campaign).map_err(|why| Why::Plain(why.to_owned()))?;
    let files = checking(|| files(campaign, script.sizes()))?;
    let program = Program::compile(&files.files).map_err(Why::Tool)?;
    let agreement = checking(|| trial.compiled(campaign, script, program.path()));
    let fault = trial.faults().into_iter().next();
    Ok(Candidate { program, calls_library: files.calls_library, agreement, fault })
}

/// The sources: the controller as it is emitted, and what runs it.
fn files(campaign: &Campaign, sizes: &campaign::Sizes) -> Result<campaign::Program, Why> {
    let refused = || Why::Plain("its controller is not emitted: see `check`".to_owned());
    let spec = &campaign.spec;
    let report = match campaign.design.spec.command() == spec.command() {
        true => examine_resolved(campaign.design.clone(), None),
        false => crate::check::examine::examine(spec),
    };
    let accepted = Accepted::of(report).map_err(|_| refused())?;
    let program = accepted.campaign(sizes).map_err(|_| refused())?;
    program
        .ok_or_else(|| Why::Plain("its controller is called with more than its state".to_owned()))
}

impl Candidate {
    /// The program with what is said of it, or why it is not used.
    ///
    /// # Errors
    /// Its runs are not those of the interpreter.
    fn judged(self, runner: Runner) -> Result<Result<(Program, String), Why>, Failure> {
        let Self { program, calls_library, agreement, fault } = self;
        let internal = |told: String| Err(Failure::internal(&Internal::from(told)));
        let Some(Agreement { scenarios, difference }) = agreement else {
            let fault = fault.map(|fault| format!(": {fault}")).unwrap_or_default();
            return Ok(Err(Why::Plain(format!("the compiled program does not run{fault}"))));
        };
        if let Some(fault) = fault {
            return internal(format!("a scenario ends the compiled controller: {fault}"));
        }
        let way = program.way();
        let told = format!("runner: compiled, {way}; {scenarios} scenarios interpreted too");
        if difference == 0.0 {
            return Ok(Ok((program, format!("{told}, with the same bits"))));
        }
        let apart = format!(
            "compiled and interpreted runs differ by {difference:.1e} of their largest value"
        );
        if !calls_library || difference > CLOSE {
            return internal(apart);
        }
        let library = "the mathematical library of the compiler rounds otherwise";
        Ok(match runner {
            Runner::Compiled => Ok((program, format!("{told}: {apart}, as {library}"))),
            _ => Err(Why::Plain(format!("{library}: {apart}"))),
        })
    }
}

impl Why {
    /// The failure where a compiled program was asked for.
    fn failure(self) -> Failure {
        let (told, notes) = match self {
            Self::Plain(why) => (why, Vec::new()),
            Self::Tool(wrong) => (wrong.told, wrong.notes),
        };
        Failure::bad_input(vec![Notice {
            notes,
            help: Some(
                "leave --runner out: the interpreter gives the same rows; CC names another C compiler"
                    .to_owned(),
            ),
            ..Notice::of(format!("--runner compiled: {told}"))
        }])
    }
}
