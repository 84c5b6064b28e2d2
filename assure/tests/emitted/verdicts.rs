//! Compares the check `growth` of the designs in tests/designs/table with runs: the controller in closed loop with
//! the chain of integrators, up to a millionth of tau before the deadline.
//!
//! In stretched time the loop is linear, so that x(T) = BB_n(T)^-1 exp(A t) BB_n(tau) x(0) needs no
//! integration; BB_n and t are those that the controller hands to a law, and u is what its program
//! gives for this x.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use nalgebra::{DMatrix, DVector};
use ptc_assure::context::workspace;
use ptc_assure::harness::optimised;
use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::examine;
use ptc_codegen::design;
use ptc_codegen::diagnostic::Place;
use ptc_codegen::parameter::{Fixed, Parameter, Precision};
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, Program, number};
use ptc_codegen::request::{Feedback, Guard, Spec, read};

/// Points of time-to-go in a decade: enough to meet the peaks of what swings.
const A_DECADE: i32 = 60;

/// The designs that decide what the gains do.
fn designs() -> Vec<PathBuf> {
    let folder = workspace().join("tests/designs/table");
    let entries = std::fs::read_dir(folder).expect("the designs");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<_> = paths.filter(|path| name(path).starts_with(['g', 'f'])).collect();
    paths.sort();
    paths
}

fn name(path: &Path) -> String {
    path.file_stem().expect("a name").to_string_lossy().into_owned()
}

fn spec(path: &Path) -> Spec {
    let text = std::fs::read_to_string(path).expect("a design");
    let (entries, found) = design::read(&text, &mut |_| Place(0));
    assert!(found.is_empty(), "{path:?}: {found:?}");
    read(&entries).unwrap_or_else(|found| panic!("{path:?}: {found:?}"))
}

/// The programs of a design whose law is linear.
struct Loop<'a> {
    /// Values of the parameters: 1 for tau and all that are not fixed. The deadline is at 0, so that time is -T.
    values: &'a dyn Fn(Parameter) -> f64,
    n: usize,
    controller: Program,
    /// The same for g = 1, whose gains are shown.
    plain: Program,
    /// The same mapping with a law that looks at xi and stretched time.
    observer: Program,
}

/// The loop at one time-to-go.
struct Seen {
    x: DVector<f64>,
    u: f64,
    /// Error bound of u, which is a sum of large terms.
    noise: f64,
}

impl<'a> Loop<'a> {
    fn new(spec: &Spec, values: &'a dyn Fn(Parameter) -> f64) -> Self {
        let mut spec = Spec { precision: Precision::F64, guard: Guard::None, ..spec.clone() };
        spec.fixed.remove(&Parameter::Eps);
        let plain = Spec { input_gain: None, ..spec.clone() };
        let observer = Spec { feedback: Feedback::Extern, ..plain.clone() };
        let [controller, plain, observer] = [&spec, &plain, &observer].map(optimised);
        Self { values, n: spec.n, controller, plain, observer }
    }

    fn input(&self, input: Input, time_to_go: f64, state: &dyn Fn(usize) -> f64) -> f64 {
        match input {
            Input::Parameter(Parameter::Eps) => 0.0,
            Input::Parameter(parameter) => (self.values)(parameter),
            Input::StartTime => -(self.values)(Parameter::Tau),
            Input::Time => -time_to_go,
            Input::State(j) | Input::StateAtStart(j) => state(j),
            Input::Reference(_)
            | Input::ReferenceOf(..)
            | Input::Gain(_)
            | Input::Divisor
            | Input::Drift
            | Input::Control
            | Input::Wanted(_) => f64::NAN,
        }
    }

    /// BB_n, column by column, and stretched time.
    fn mapping(&self, time_to_go: f64) -> (DMatrix<f64>, f64) {
        let mut columns = Vec::new();
        let mut stretched = f64::NAN;
        for column in 1..=self.n {
            let unit = |j| f64::from(u8::from(j == column));
            let input = |input| self.input(input, time_to_go, &unit);
            let seen = RefCell::new(Vec::new());
            let law = |arguments: &[f64]| {
                seen.borrow_mut().extend_from_slice(arguments);
                0.0
            };
            Interpreter::new(&self.observer, &input).with_law(&law).value(self.observer.step);
            let mut seen = seen.into_inner();
            // Stretched time begins with the start, which is at -tau.
            stretched = seen.pop().expect("stretched time") + (self.values)(Parameter::Tau);
            columns.push(DVector::from_vec(seen));
        }
        (DMatrix::from_columns(&columns), stretched)
    }

    /// The state and u at each time-to-go from `x0`.
    fn run(&self, x0: &DVector<f64>, times: impl Iterator<Item = f64>) -> Vec<Seen> {
        let tau = (self.values)(Parameter::Tau);
        let n = self.n;
        let closed_loop = DMatrix::from_fn(n, n, |i, j| match (i + 1 == n, j == i + 1) {
            (true, _) => -(self.values)(Parameter::Gain(j + 1)),
            (false, next) => f64::from(u8::from(next)),
        });
        let xi0 = self.mapping(tau).0 * x0;
        let at = |time_to_go| {
            let (bell, stretched) = self.mapping(time_to_go);
            let xi = (&closed_loop * stretched).exp() * &xi0;
            let x = bell.solve_lower_triangular(&xi).expect("a positive diagonal");
            let state = |j: usize| x[j - 1];
            let input = |input| self.input(input, time_to_go, &state);
            let u = Interpreter::new(&self.controller, &input).value(self.controller.step);
            let mut plain = Interpreter::new(&self.plain, &input);
            let gains = self.plain.gains.iter().map(|gain| plain.value(*gain));
            let terms: f64 = gains.zip(&x).map(|(gain, x)| (gain * x).abs()).sum();
            Seen { u, noise: 1e-12 * terms, x: x.clone() }
        };
        times.map(at).collect()
    }
}

/// Trend of a quantity towards the deadline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Trend {
    Vanishes,
    Stays,
    Grows,
}

/// From the largest values in the last decade and the one before it, and what they may be wrong by.
/// Between ln T, which grows by a tenth in a decade here, and the slowest power of T in the table,
/// T^0.2, there is room for what stays.
fn trend(before: f64, last: f64, noise: f64) -> Trend {
    if last == f64::INFINITY {
        Trend::Grows
    } else if last <= (0.9 * before).max(noise) {
        Trend::Vanishes
    } else if last <= 1.05 * before {
        Trend::Stays
    } else {
        Trend::Grows
    }
}

/// The trends of x and of u.
fn trends(spec: &Spec, free: &dyn Fn(Parameter) -> f64) -> (Trend, Trend) {
    let values = |parameter: Parameter| match spec.fixed.get(&parameter).and_then(Fixed::number) {
        Some(value) => number::round(value, Precision::F64),
        None => free(parameter),
    };
    let closed_loop = Loop::new(spec, &values);
    let x0 = DVector::from_fn(spec.n, |i, _| [0.7, -1.1, 0.4, 1.3][i % 4]);
    let tau = values(Parameter::Tau);
    let decade = |from: i32| {
        let times = (0..A_DECADE)
            .map(move |k| tau * 10f64.powf(-f64::from(from) - f64::from(k) / f64::from(A_DECADE)));
        let seen = closed_loop.run(&x0, times);
        // What is beyond all numbers is larger than all of them.
        let size = |value: f64| if value.is_finite() { value.abs() } else { f64::INFINITY };
        let most = |of: &dyn Fn(&Seen) -> f64| seen.iter().map(of).fold(0.0, f64::max);
        let x = most(&|seen| seen.x.iter().map(|x| size(*x)).fold(0.0, f64::max));
        (x, most(&|seen| size(seen.u)), most(&|seen| size(seen.noise)))
    };
    let (before, last) = (decade(4), decade(5));
    println!(
        "    x {:.1e} {:.1e}, u {:.1e} {:.1e} noise {:.1e}",
        before.0, last.0, before.1, last.1, last.2
    );
    let x = trend(before.0, last.0, 1e-12);
    let u = if last.1.is_finite() && last.1 <= last.2 {
        Trend::Vanishes
    } else {
        trend(before.1, last.1, 1e-12)
    };
    (x, u)
}

#[test]
fn each_verdict_on_growth_is_seen() {
    use Trend::{Grows, Stays, Vanishes};
    let (mut sound, mut unsound) = (0, 0);
    for path in designs() {
        let spec = spec(&path);
        if spec.n > 8 {
            // Its matrix exponential has no digits left.
            continue;
        }
        let report = examine(&spec);
        let growth = report.outcomes.iter().find(|outcome| outcome.name == "growth");
        let growth = growth.expect("the check");
        let said = |part: &str| growth.summary.contains(part);
        match growth.verdict {
            Verdict::Sound => sound += 1,
            Verdict::Unsound => unsound += 1,
            _ => continue,
        }
        println!("{}: {}", name(&path), growth.summary);
        let (x, u) = trends(&spec, &|_| 1.0);
        assert_eq!(x == Vanishes, !said("x does not go to 0"), "{path:?}: x {x:?}");
        let wanted: &[Trend] = if said("x and u go to 0") {
            &[Vanishes]
        } else if said("u stays bounded") {
            &[Stays]
        } else if said("u is unbounded") {
            &[Grows]
        } else {
            assert!(growth.details.iter().any(|told| told == "u stays bounded"), "{growth:?}");
            &[Vanishes, Stays]
        };
        assert!(wanted.contains(&u), "{path:?}: u {u:?} and not {wanted:?}");
    }
    assert!(sound >= 20 && unsound >= 14, "{sound} and {unsound}");
}

/// A pole on the line is bounded where T falls like e^-t, but not where it falls like e^-t/(1 + t).
#[test]
fn what_is_left_open_may_grow() {
    let folder = workspace().join("tests/designs/table");
    let spec = spec(&folder.join("growth_log_on_the_line.toml"));
    assert_eq!(trends(&spec, &|_| 1.0), (Trend::Vanishes, Trend::Grows));
}

/// A run-time rate is reported as good up to 1.99.
#[test]
fn the_largest_rate_is_seen() {
    let folder = workspace().join("tests/designs/table");
    let spec = spec(&folder.join("growth_free_rate.toml"));
    let at = |rate: f64| trends(&spec, &|p| if p == Parameter::A { rate } else { 1.0 });
    assert_eq!(at(1.7), (Trend::Vanishes, Trend::Vanishes));
    assert_eq!(at(2.0), (Trend::Vanishes, Trend::Stays));
    assert_eq!(at(2.2), (Trend::Vanishes, Trend::Grows));
}
