//! Reference of the output: an expression in time with its derivatives, or an input of each call.

use super::Reader;
use crate::algebra::integer;
use crate::expression::effort::bounded;
use crate::expression::enclosure::{Interval, Range};
use crate::expression::evaluator::{Evaluator, Names};
use crate::expression::existence::{Condition, needs};
use crate::expression::normal::normal;
use crate::expression::period::is_met_all_round;
use crate::expression::sign::{Sign, sign};
use crate::expression::{Expression, Scope, Subject, Variable, resolve};
use crate::parameter::{Fixed, Parameter};
use crate::request::{Feedback, MAX_ORDER, Reference, Spec, What};
use crate::syntax::{Node, Value};

/// Help text on references that differ between axes.
pub(super) const OF_AXES: &str = "with a clock in time give `reference` = input: each call is given those of all axes; a clock in samples takes an expression for each axis, and a plant with `inputs` and `outputs` one for each output";

impl Reader<'_> {
    /// The reference of a chain of order `n`; 0 is none at all.
    pub(super) fn reference(&mut self, n: Option<usize>, known: &[Parameter]) -> Option<Reference> {
        let node = self.keys.get("reference").copied()?;
        if matches!(&node.value, Value::Word(word) if word == "input") {
            return Some(Reference::Input);
        }
        if matches!(node.value, Value::List(_)) {
            let message = "a list of references, where there is one output".to_owned();
            let help = match self.keys.contains_key("axes") {
                true => OF_AXES,
                false => "give one expression in t; several outputs have one for each",
            };
            self.wrong("reference", Some(node.place), message, help.to_owned());
            return None;
        }
        let all = self.followed(node, n, known)?;
        let rests = all[0] == Expression::integer(0);
        (!rests).then_some(Reference::Known(all))
    }

    /// An expression in time with its derivatives, up to that of order `n`.
    pub(super) fn followed(
        &mut self,
        node: &Node,
        n: Option<usize>,
        known: &[Parameter],
    ) -> Option<Vec<Expression>> {
        let scope =
            Scope { subject: Subject::Reference, n: n.unwrap_or(MAX_ORDER), known, own: &[] };
        let given = resolve(node, scope, &mut self.found)?;
        if !self.is_of_time(node, &given) {
            return None;
        }
        let (message, help) = if let Some(kink) = kink(&given) {
            (
                format!("{kink} has a kink, and the reference is differentiated"),
                "take a smooth function in its place: tanh(w/small) for sign(w); or give the derivatives with each call, `reference` = input",
            )
        } else {
            match derivatives(&given, n?) {
                Ok(all) => return Some(all),
                Err(order) => (
                    format!(
                        "derivative {order} of the reference is larger than an expression may be"
                    ),
                    "take a simpler reference, or give the derivatives with each call, `reference` = input",
                ),
            }
        };
        self.wrong("reference", Some(node.place), message, help.to_owned());
        None
    }

    /// Refuses what has no meaning beside a reference.
    pub(super) fn fits_reference(&mut self, spec: &Spec, samples: bool) {
        if spec.reference.is_none() {
            return;
        }
        let latches = |v: &Expression| {
            matches!(v.variable(), Some(Variable::StateAtStart(_) | Variable::XiAtStart(_)))
        };
        let of_start = matches!(&spec.feedback, Feedback::Expression(law) if law.any(&latches));
        let beside = [
            (
                "what",
                spec.what == What::Associated || !samples && spec.what == What::Observer,
                "a reference belongs to a controller: the infinite-time system is that of the error, whatever it is",
                "leave `reference` out",
            ),
            (
                "pi0",
                of_start,
                "beside a reference pi0 is an expression in xi1..xin and t",
                "leave states at the start out",
            ),
        ];
        self.against(&beside);
    }

    /// Refuses a reference that names a time which a controller in samples does not know.
    pub(super) fn reference_in_samples(&mut self, spec: &Spec) {
        let place = self.keys.get("reference").map(|node| node.place);
        let given = spec.known_references().flatten().flat_map(Expression::parameters);
        for parameter in crate::collect::set(given) {
            let (message, help) = match parameter {
                Parameter::StartTime => (
                    "`t0` in a reference in samples",
                    "its t counts from the tick at which the controller is armed: leave t0 out",
                ),
                Parameter::Tau if !spec.fixed.contains_key(&parameter) => (
                    "`tau` in a reference, and it is left to run time as a number of samples",
                    "give `tau`, or a parameter of another name under [params]",
                ),
                _ => continue,
            };
            self.found.push("bad-expression", "reference", place, message, help);
        }
    }

    /// Refuses a reference whose derivatives are not shown to exist from the start on: they do where each
    /// of its operations is analytic. What depends on parameters alone is left to run time, as far as
    /// they are.
    pub(super) fn reference_exists(&mut self, spec: &Spec, samples: bool) {
        let known = |p: &Parameter| spec.fixed.contains_key(p) || spec.bounds.contains_key(p);
        let decided = |part: &Expression| moves(part) || part.parameters().iter().all(known);
        // A root has a value at 0, and no derivative there.
        let analytic = |(part, condition): (Expression, Condition)| match condition {
            Condition::NotNegative => (part, Condition::Positive),
            condition => (part, condition),
        };
        let names = names(spec, samples);
        let mut evaluator = Evaluator::new();
        let mut met = |part: &Expression, condition: Condition| {
            let value = evaluator.value(part, &names);
            value.is_some_and(|value| condition.is_met(&value.interval))
                || sign(part, &|name| sign_of(name, &names))
                    .is_some_and(|sign| condition.is_met_by(sign))
                || is_met_all_round(part, condition, &names)
        };
        let given = spec.known_references().map(|all| &all[0]);
        let mut wanted = given.flat_map(needs).map(analytic);
        let open = wanted.find(|(part, condition)| decided(part) && !met(part, *condition));
        let Some((part, condition)) = open else { return };
        let place = self.keys.get("reference").map(|node| node.place);
        let message = format!(
            "the reference is not shown to have derivatives at all t >= {}: {part} has to be {}",
            if samples { "0" } else { "t0" },
            condition.words()
        );
        let start = if samples { "" } else { "t0, and " };
        let help = format!(
            "give {start}values or bounds of the parameters under [params]; write a sum of squares as one; or give the derivatives with each call, `reference` = input"
        );
        self.wrong("reference", place, message, help);
    }
}

/// The sign of the values of a name; an interval that ends at infinity loses that of a reciprocal.
fn sign_of(name: &Expression, names: &Names) -> Option<Sign> {
    let values = names.get(name)?;
    match (values.is_positive(), values.is_not_negative()) {
        (true, _) => Some(Sign::Positive),
        (_, true) => Some(Sign::NotNegative),
        _ => None,
    }
}

/// Returns true if an expression changes with time.
fn moves(e: &Expression) -> bool {
    e.contains(Variable::Time) || e.contains(Variable::Elapsed)
}

/// The first part that has a kink in time.
fn kink(e: &Expression) -> Option<Expression> {
    e.first(&mut |e| (e.is_kink() && moves(e)).then(|| e.clone()))
}

/// r and its derivatives up to that of order `n`, or the order of the first that is too large.
pub(crate) fn derivatives(r: &Expression, n: usize) -> Result<Vec<Expression>, usize> {
    bounded(|| {
        let parts: Vec<_> = needs(r).into_iter().map(|(part, _)| part).collect();
        let mut all = vec![r.clone()];
        for order in 1..=n {
            let last = &all[order - 1];
            last.differentiable().ok_or(order)?;
            // t and dt pass alike.
            let rate = last.derivative(Variable::Time).add(last.derivative(Variable::Elapsed));
            let rate = tidied(rate, &parts);
            if !rate.is_kept() {
                return Err(order);
            }
            all.push(rate);
        }
        Ok(all)
    })
}

/// The shorter one of a derivative and its normal form, in which the `parts` that the reference divides by,
/// or takes a root or a logarithm of, stay as they are: multiplied out they are long, and lose digits
/// where they are small.
fn tidied(rate: Expression, parts: &[Expression]) -> Expression {
    // States of the infinite-time system stand for them, which no reference knows.
    let stand_in = |index: usize| Expression::from(Variable::Xi(index + 1));
    let kept = rate.substitute(&|e| parts.iter().position(|part| part == e).map(stand_in));
    let form = normal(&kept).substitute(&|e| match e.variable()? {
        Variable::Xi(index) => parts.get(index - 1).cloned(),
        _ => None,
    });
    if form.size() <= rate.size() { form } else { rate }
}

/// Returns the enclosures of time, which in samples counts from the start, and of the parameters.
fn names(spec: &Spec, samples: bool) -> Names {
    let exact = |p: Parameter| spec.fixed.get(&p).and_then(Fixed::number);
    let zero = integer(0);
    let start = if samples { Some(&zero) } else { exact(Parameter::StartTime) };
    let from =
        |low: Option<_>| low.map_or_else(|| Interval::WHOLE, |low| Interval::between(low, None));
    let mut names = Names::from([
        (Variable::Time.into(), from(start)),
        (Variable::Elapsed.into(), from(Some(&zero))),
    ]);
    for parameter in spec.parameters() {
        let bounds = spec.bounds.get(&parameter);
        let bounds = bounds.and_then(|(least, most)| Some((least.number()?, most.number()?)));
        let range = match (exact(parameter), bounds, spec.ends(parameter)) {
            (Some(value), ..) => Interval::exact(value),
            (None, Some((least, most)), _) => Interval::between(least, Some(most)),
            (None, None, Some((least, most))) => Interval::from(Range::new(least, most)),
            (None, None, None) => Interval::WHOLE,
        };
        names.insert(parameter.into(), range);
    }
    names
}
