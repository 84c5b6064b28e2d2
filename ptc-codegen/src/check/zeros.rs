//! The zero dynamics of a model: what its other states do while the outputs are at rest.

use super::{Outcome, Verdict};
use crate::algebra::BigRational;
use crate::algebra::polynomial::Polynomial;
use crate::collect::map;
use crate::expression::Expression;
use crate::linear::roots;
use crate::model::zeros::{AtRest, Followed, Plant, Zeros, zeros};
use crate::model::{Coupled, Inverse, Values};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Reference, Spec};

/// Name of the check.
pub(crate) const NAME: &str = "zeros";

/// Limits of the verdict on a robot.
const OF_ROBOT: &str = "the plant is taken to be the rigid bodies of the URDF with the rotors and the friction of the design: springs and limits of positions are not looked at";

/// The values of the parameters that are fixed.
fn values(spec: &Spec) -> Values {
    let number = |value: &Fixed| value.number().cloned();
    map(spec.fixed.iter().filter_map(|(p, value)| Some((*p, number(value)?))))
}

/// The check of a plant with several inputs and outputs.
pub(crate) fn of_coupled(spec: &Spec, coupled: &Coupled) -> Outcome {
    let orders = coupled.orders();
    let all: Vec<_> = orders.iter().map(ToString::to_string).collect();
    let degrees = format!("the relative degrees are {}", all.join(", "));
    let values = values(spec);
    let states = coupled.states.len();
    let none = format!("none: {degrees}, whose sum is the number of states");
    let words = Words {
        none,
        degree: format!("{degrees} of {states} states"),
        order: states.saturating_sub(orders.iter().sum()),
        divisor: match &coupled.inverse {
            Inverse::Adjugate { determinant, .. } => {
                format!("the determinant of the decoupling matrix, {}", coupled.text(determinant))
            }
            _ => "the determinant of the decoupling matrix".to_owned(),
        },
        outputs: "outputs",
        singular: "take outputs that the inputs move one by one at rest",
    };
    let Some(plant) = Plant::of_coupled(coupled, &values) else {
        let mut outcome =
            words.outcome(spec, &[AtRest { place: String::new(), zeros: Zeros::None }]);
        outcome.details.extend(spec.arm().map(|_| OF_ROBOT.to_owned()));
        return outcome;
    };
    // An inertia matrix is regular.
    let is_inertia = matches!(coupled.inverse, Inverse::Inertia { .. });
    let divisor = coupled.determinant().filter(|_| !is_inertia);
    words.outcome(spec, &at_rest(spec, &plant, divisor.as_ref(), &values))
}

/// The check of a design that has a model.
pub(crate) fn outcome(spec: &Spec) -> Option<Outcome> {
    // One output of several has no dynamics of its own.
    let model = spec.model.as_ref().filter(|model| !model.dynamics.is_empty())?;
    let values = values(spec);
    let one = Expression::integer(1);
    let gain = spec.input_gain.as_ref().unwrap_or(&one);
    let (r, states) = (spec.n, model.states.len());
    let words = Words {
        none: format!("none: the relative degree is {r}, the number of states"),
        degree: format!("the relative degree is {r} of {states} states"),
        order: states.saturating_sub(r),
        divisor: format!("the gain of u, {}", model.text(gain)),
        outputs: "output",
        singular: "take an output whose derivative of that order u moves at rest",
    };
    let plant = Plant::of_model(model, &values);
    Some(words.outcome(spec, &at_rest(spec, &plant, Some(gain), &values)))
}

/// The zero dynamics where the outputs are at their references.
fn at_rest(
    spec: &Spec,
    plant: &Plant<'_>,
    divisor: Option<&Expression>,
    values: &Values,
) -> Vec<AtRest> {
    let references: Vec<_> =
        spec.known_references().map(|all| all.first().cloned().unwrap_or_else(zero)).collect();
    let number = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number).cloned();
    let start = match spec.sampled() {
        Some(_) => Some(BigRational::default()),
        None => number(Parameter::StartTime),
    };
    let followed = if spec.reference == Some(Reference::Input) {
        Followed::Given
    } else if moves(spec) {
        let run = start.zip(number(Parameter::Tau)).map(|(start, tau)| [start, tau]);
        Followed::Moving { references: &references, run }
    } else {
        Followed::Constant(&references)
    };
    zeros(plant, divisor, &followed, values)
}

fn zero() -> Expression {
    Expression::integer(0)
}

/// Returns true if a reference changes with time.
fn moves(spec: &Spec) -> bool {
    let any = |all: &[Expression]| all.iter().skip(1).any(|e| *e != zero());
    spec.reference == Some(Reference::Input) || spec.known_references().any(any)
}

/// Names the place where a linearisation holds.
fn near(at: &AtRest) -> &str {
    if at.place == "the origin" { &at.place } else { "this point" }
}

/// Terms for the parts of an outcome.
struct Words {
    none: String,
    degree: String,
    order: usize,
    divisor: String,
    outputs: &'static str,
    singular: &'static str,
}

impl Words {
    /// The outcome at the rest points that were found, the nearest to the origin first.
    fn outcome(&self, spec: &Spec, points: &[AtRest]) -> Outcome {
        let Some((first, others)) = points.split_first() else {
            return Outcome::not_checked(NAME, "no rest point is known");
        };
        let (mut verdict, mut summary, mut fix) = self.at(first);
        let is_sound = |at: &AtRest| matches!(at.zeros, Zeros::Stable(_) | Zeros::None);
        let fails = verdict == Verdict::Unsound;
        if fails && others.iter().any(is_sound) {
            verdict = Verdict::Undecided;
            summary = format!(
                "{summary}; at another rest point they are stable, and to which one the plant comes is not examined"
            );
            fix = None;
        }
        let mut details = match (self.order, &first.zeros) {
            (0, _) | (_, Zeros::Open(_) | Zeros::Singular) => Vec::new(),
            _ => vec![format!("from the linearisation: it holds near {}", near(first))],
        };
        details.extend(others.iter().map(|at| {
            let (verdict, summary, _) = self.at(at);
            format!("{}: {summary}", verdict.text())
        }));
        if self.order > 0 && moves(spec) {
            let driven = format!(
                "with the {} at rest: on a reference that moves it drives the other states",
                self.outputs
            );
            details.push(driven);
        }
        Outcome { name: NAME, verdict, summary, details, fix }
    }

    /// Verdict, summary and fix at one of them.
    fn at(&self, AtRest { place, zeros }: &AtRest) -> (Verdict, String, Option<String>) {
        let Self { degree, order, .. } = self;
        let at = |p: &Polynomial| match roots(p) {
            Some(roots) => {
                let roots: Vec<_> = roots.iter().map(ToString::to_string).collect();
                let roots = roots.join(", ");
                format!("{degree}; at {place} the zero dynamics have the roots {roots} 1/s")
            }
            None => format!("{degree}; the zero dynamics are of order {order}"),
        };
        match zeros {
            Zeros::None => (Verdict::Sound, self.none.clone(), None),
            Zeros::Singular => (
                Verdict::Unsound,
                format!("{}, is 0 at {place}: the law divides by it", self.divisor),
                Some(self.singular.to_owned()),
            ),
            Zeros::Stable(p) => (Verdict::Sound, at(p), None),
            Zeros::Unstable(p) => {
                let leave = if place == "the origin" { place } else { "it" };
                let stable =
                    "take an output with stable zero dynamics, or more of the states in it";
                (
                    Verdict::Unsound,
                    format!(
                        "{}: with the {} at rest other states leave {leave}",
                        at(p),
                        self.outputs
                    ),
                    Some(stable.to_owned()),
                )
            }
            Zeros::Critical(p) => (
                Verdict::Undecided,
                format!("{}: on the imaginary axis the linearisation does not decide", at(p)),
                None,
            ),
            Zeros::Open(why) => (
                Verdict::Undecided,
                format!("{degree}; the zero dynamics are of order {order}: {why}"),
                None,
            ),
        }
    }
}
