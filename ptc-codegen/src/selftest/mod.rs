//! Self-test of a controller: parameters, calls, and the expected results.
//!
//! What must come is computed in long arithmetic from the definition ([`crate::reference`]). The
//! program decides nothing but which calls are worth asking: those that take a branch of the emitted
//! code the other way, and those whose numbers leave the range on the way to u.

mod branches;
mod calls;
mod maker;
mod overflow;
mod parameters;
mod range;
mod refused;
pub mod samples;
mod trial;
mod wrong;
mod zero;

use crate::check::examine::Report;
use crate::controller::Controller;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::{Expression, Variable};
use crate::limits;
use crate::program::machine::Machine;
use crate::reference::{Status, Work};
use crate::request::{Spec, What};

/// Random calls among which those are kept that take a branch no other took.
const CANDIDATES: usize = 400;

/// A call of `step`, and of `tick` and `axis` where there are gains.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// Time, s.
    pub t: f64,
    /// State; behind it the reference and its derivatives, of each output, where each call is given them.
    pub x: Vec<f64>,
    /// The status that it must give.
    pub status: Status,
    /// Expected result for each input.
    pub inputs: Vec<Wanted>,
    /// The status of `axis` after `tick`; `None` if they are not called.
    pub axis: Option<Status>,
}

/// Expected result of a call for an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// Its status, of several inputs.
    pub status: Status,
    /// u.
    pub u: f64,
    /// Largest allowed error of u.
    pub tolerance: f64,
}

impl Wanted {
    /// No u, with a status.
    fn none(status: Status) -> Self {
        Self { status, u: 0.0, tolerance: 0.0 }
    }
}

/// Parameters that `init` takes, and calls with them.
#[derive(Clone, Debug, PartialEq)]
pub struct Session {
    /// Run-time parameters in the order of the emitted struct.
    pub parameters: Vec<f64>,
    /// The state at the start; empty where none is latched.
    pub x0: Vec<f64>,
    /// The start before the calls, where the controller is armed again.
    pub again: Option<Again>,
    /// The calls, at least one.
    pub calls: Vec<Call>,
}

/// Another start than that of `init`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Again {
    /// The start time.
    pub start: f64,
    /// The duration that `arm_for` is given; `None` for a call of `arm` alone.
    pub duration: Option<f64>,
    /// True if `arm` is called, after `arm_for` where that is.
    pub arms: bool,
}

/// A condition of the emitted code that no input makes false.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Always {
    /// One of the [checks](crate::controller::checked) of `init`, by its index.
    Init(usize),
    /// One of the checks of `arm`.
    Arm(usize),
    /// One of the checks of `arm_for`.
    ArmFor(usize),
    /// The condition that a factor of a product is not 0: the check of the product in `init`, and the factor.
    NotZero(usize, usize),
    /// The same in `arm_for`.
    NotZeroFor(usize, usize),
    /// Another, as it is emitted in C.
    Written(String),
}

/// Such a condition, and the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreachable {
    /// The condition.
    pub condition: Always,
    /// Why it holds always.
    pub reason: String,
}

/// A self-test.
#[derive(Clone, Debug, PartialEq)]
pub struct SelfTest {
    /// Sessions that must succeed, the first of them an undisturbed approach to the deadline.
    pub sessions: Vec<Session>,
    /// Parameters that `init` must refuse.
    pub refused: Vec<Vec<f64>>,
    /// Starts with states that `arm` must refuse to latch; with the first of them so must `init`.
    pub refused_states: Vec<(f64, Vec<f64>)>,
    /// Durations that `arm_for` must refuse.
    pub refused_durations: Vec<f64>,
    /// True if a start time can make the deadline overflow with the parameters alone.
    pub tau_is_kept: bool,
    /// Checks that cannot fail.
    pub unreachable: Vec<Unreachable>,
}

impl SelfTest {
    /// The self-test of a controller.
    ///
    /// # Errors
    /// The associated system has none; neither has a design whose reference values are not found.
    pub fn new(controller: &Controller<'_>) -> Result<Self, Vec<Diagnostic>> {
        let spec = controller.spec();
        if spec.arm().is_some() {
            return Err(refusal(
                "urdf",
                "a robot has no self-test",
                "leave it out, or compare the torques with another library",
            ));
        }
        if spec.what == What::Associated {
            return Err(refusal(
                "what",
                "the associated system has no self-test: it is not what runs on a target",
                "leave out `--selftest`, or `what = associated`",
            ));
        }
        match &spec.axes {
            Some(axes) if spec.coupled.is_none() => {
                let program = controller.program.clone().of_all_axes(spec.n, axes.count);
                let spec = spec.clone().as_one_plant();
                let report = Report { spec, ..controller.report.clone() };
                Self::of(&Controller { report: &report, program: &program, ..*controller })
            }
            _ => Self::of(controller),
        }
    }

    /// Builds the self-test of one plant.
    fn of(controller: &Controller<'_>) -> Result<Self, Vec<Diagnostic>> {
        let spec = controller.spec();
        let chosen = parameters::Chosen::new(controller);
        let machine = Machine::new(controller.program, &[]);
        let trials = Trials::new(controller);
        let (sessions, never) = calls::sessions(controller, &machine, &chosen, &trials);
        let overflow = overflow::find(controller, &machine, &chosen, &trials);
        if trials.work.is_spent() {
            return Err(refusal(
                "selftest",
                &limits::SELFTEST.beyond(&format!("the self-test of {}", spec.name())),
                limits::SELFTEST.fix,
            ));
        }
        if sessions.first().is_none_or(|session| session.calls.is_empty()) {
            return Err(refusal(
                "selftest",
                "no call of this controller has a value that is known for certain",
                "fix the parameters of the mapping to values with which it is one, or test it by hand",
            ));
        }
        let taken = sessions.iter().map(|session| &session.parameters);
        let not_zero =
            zero::never(controller, &chosen, &machine, taken.chain(&overflow.parameters));
        let mut refused = refused::parameters(controller, &chosen);
        refused.extend(overflow.parameters);
        let mut refused_states =
            refused::states(spec, chosen.value(crate::parameter::Parameter::StartTime, 0.0));
        refused_states.extend(overflow.states);
        Ok(Self {
            sessions,
            refused,
            refused_states,
            refused_durations: refused::durations(controller, &chosen),
            tau_is_kept: chosen.place(crate::parameter::Parameter::Tau).is_some(),
            unreachable: [overflow.unreachable, not_zero, never].concat(),
        })
    }
}

/// The work of a self-test: that of the long arithmetic, and of the trials of the program.
struct Trials {
    work: Work,
    /// Work of one trial.
    steps: u64,
}

impl Trials {
    fn new(controller: &Controller<'_>) -> Self {
        // An operation takes some 50 ns with the look for what needs it; an iteration repeats some.
        let rounds = if controller.spec().is_iterated() { 2 } else { 1 };
        let steps = 50 * rounds * controller.program.values.len() as u64;
        Self { work: Work::of(limits::SELFTEST.most), steps }
    }

    /// The first `most` numbers, as far as there is work left for a trial each.
    fn rounds(&self, most: usize) -> impl Iterator<Item = usize> + use<> {
        let (work, steps) = (self.work.clone(), self.steps);
        (0..most).take_while(move |_| work.spend(steps))
    }
}

fn refusal(key: &str, message: &str, help: &str) -> Vec<Diagnostic> {
    let mut found = Diagnostics::default();
    found.push("selftest", key, None, message.to_owned(), help);
    found.finish::<()>(None).err().unwrap_or_default()
}

/// The law that a self-test substitutes for a user-defined one: t/8 - 3/2 (xi_1 + ... + xi_n).
pub fn own_law(n: usize) -> Expression {
    let weight = Expression::integer(3).div(Expression::integer(2));
    let time = Expression::from(Variable::StretchedTime).div(Expression::integer(8));
    (1..=n).fold(time, |sum, i| sum.sub(weight.clone().mul(Variable::Xi(i).into())))
}

/// The same for each output of a plant with several, output j with j kappa'/16 on top, of xi of all chains.
pub fn own_laws(spec: &Spec) -> Vec<Expression> {
    let of_all = spec.coupled.as_ref().filter(|_| spec.laws_at_once().is_some());
    let Some(coupled) = of_all else { return vec![own_law(spec.n)] };
    let orders = coupled.orders();
    let law = own_law(orders.iter().sum());
    let rate = Expression::from(Variable::KappaRate).div(Expression::integer(16));
    let law = |j: i64| law.clone().add(Expression::integer(j).mul(rate.clone()));
    (1..).take(orders.len()).map(law).collect()
}

/// Law that it substitutes after the deadline: t/8 - x_1.
pub fn own_rest(t: f64, x: &[f64]) -> f64 {
    t / 8.0 - x[0]
}

/// Pseudo-random numbers, the same for every spec and machine.
struct Draw(u64);

impl Draw {
    /// A number from `low` to `high`: SplitMix64, its upper 53 bits.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        #[allow(clippy::cast_precision_loss)]
        let unit = (z >> 11) as f64 / (1u64 << 53) as f64;
        low + (high - low) * unit
    }

    /// One of several.
    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        #[allow(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss
        )]
        let index = self.between(0.0, choices.len() as f64) as usize;
        choices[index.min(choices.len() - 1)]
    }
}
