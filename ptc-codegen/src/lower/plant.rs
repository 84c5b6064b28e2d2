//! The plant's share of u = (w - f)/g, and the chain of a model, in the form that takes the fewest
//! operations once the numbers of the design are in it.

use super::angle_sum::has_angle_sums;
use super::builder::Builder;
use super::coefficients::Coefficient;
use super::input_gain::{input_gain_number, over_input_gain, settled};
use super::jet::Motion;
use crate::algebra::{BigRational, integer};
use crate::expression::Expression;
use crate::expression::grouped::{Grouped, grouped, quotient};
use crate::internal::fault;
use crate::program::cost::{X86_64, count};
use crate::program::number::is_normal;
use crate::program::{Definition, Op, Program, Stage, Value};
use crate::request::Spec;

/// Operations of an expression from which on its plant is computed by jets wherever it can be; those of a chain of order
/// 7 whose rates are not linear, which takes three times the operations of jets.
const LONG: usize = 2_000;

/// The expressions of a plant in one of the forms that they may be computed in.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Form {
    /// The chain of a model.
    pub(super) coordinates: Vec<Expression>,
    drift: Option<Expression>,
    pub(super) input_gain: Option<Expression>,
    /// True if `drift` is f/g, which is subtracted from w/g: no digit of w or of f is lost by that, as their difference
    /// is rounded once either way.
    divided: bool,
    /// Factor of the rows of the law: 1/g, where that is a number and no gain is left.
    pub(super) scale: Option<BigRational>,
    /// Motion by which the chain is expanded in place of its expressions, and whether the gains of the inputs are, too.
    jets: Option<(Motion, bool)>,
    /// True if sines and cosines of sums of angles in equations of motion come by the addition theorem.
    splits_angles: bool,
}

impl Form {
    /// As the request has them.
    pub(super) fn own(spec: &Spec) -> Self {
        let model = spec.model.iter().flat_map(|model| &model.coordinates);
        Self {
            coordinates: model.cloned().collect(),
            drift: spec.drift.clone(),
            input_gain: spec.input_gain.clone(),
            divided: false,
            scale: None,
            jets: None,
            splits_angles: false,
        }
    }

    /// The others: what is affine grouped, f/g where that exists wherever f and g do, and 1/g in the
    /// coefficients of `linear` laws. Sums of angles are split where there are any.
    fn others(&self, spec: &Spec, linear: bool) -> Vec<Self> {
        let known = |e: &Expression| settled(spec, e);
        let lost = |e: &Expression| e.number().is_some_and(|n| !is_normal(n, spec.precision));
        let in_range = |form: &Grouped| !form.form.any(&lost);
        let affine = |e: &Expression| {
            let form = grouped(&known(e)).filter(|form| form.affine && in_range(form));
            form.map_or_else(|| e.clone(), |form| form.form)
        };
        let tidied = Self {
            coordinates: self.coordinates.iter().map(affine).collect(),
            drift: self.drift.as_ref().map(affine),
            ..self.clone()
        };
        let Some(g) = &self.input_gain else {
            let split =
                has_angle_sums(spec).then(|| Self { splits_angles: true, ..tidied.clone() });
            return std::iter::once(tidied).chain(split).collect();
        };
        let divided = match &self.drift {
            Some(f) => {
                quotient(&known(f), &known(g)).filter(in_range).map(|drift| Some(drift.form))
            }
            None => Some(None),
        };
        let divided = divided.map(|drift| Self { drift, divided: true, ..tidied.clone() });
        let one_over = input_gain_number(spec, g).map(|g| g.recip()).filter(|_| linear);
        let scaled = divided.clone().zip(one_over).map(|(form, one_over)| Self {
            input_gain: None,
            scale: Some(one_over),
            ..form
        });
        [Some(tidied), divided, scaled].into_iter().flatten().collect()
    }
}

impl Form {
    /// The forms in which the chain is expanded by Taylor arithmetic, with the gain of the input as it is written,
    /// as a number in the coefficients of `linear` laws, or differentiated in turn.
    pub(super) fn by_jets(&self, spec: &Spec, linear: bool) -> Vec<Self> {
        let mut forms = Vec::new();
        for motion in Motion::all(spec) {
            let with = |gains| Self { jets: Some((motion.clone(), gains)), ..self.clone() };
            let several = spec.decoupled().is_some();
            let number = self.input_gain.as_ref().map(|g| input_gain_number(spec, g));
            match number {
                None if !several => forms.push(with(false)),
                Some(Some(g)) if linear => forms.push(Self {
                    input_gain: None,
                    divided: true,
                    scale: Some(g.recip()),
                    ..with(false)
                }),
                Some(Some(_)) => forms.push(with(false)),
                _ => forms.extend([with(false), with(true)]),
            }
        }
        forms
    }

    /// From here on the plant is computed in this form; `None` if it has none.
    pub(super) fn enter(self, b: &mut Builder<'_>) -> Option<()> {
        b.splits_angles = self.splits_angles;
        if let Some((motion, gains)) = &self.jets {
            b.jets = Some(b.jets(motion, *gains)?);
        }
        // Several outputs have their plant in their decoupling.
        b.form = b.spec.decoupled().is_none().then_some(self);
        Some(())
    }
}

/// The cheapest of the programs that `lower` makes of the forms of the plant, the request's own first.
/// `linear` says whether the law is one of rows.
pub(super) fn cheapest(
    spec: &Spec,
    linear: bool,
    lower: &dyn Fn(Form) -> Option<Program>,
) -> Program {
    let own = Form::own(spec);
    let lost = |definition: &Definition| match &definition.op {
        Op::Number(number) => !is_normal(number, spec.precision),
        _ => false,
    };
    let cost = |program: &Program| {
        let roots = [program.controls(), program.watched.clone()].concat();
        count(program, &roots, Stage::Tick).cycles(&X86_64)
    };
    let jets = own.by_jets(spec, linear);
    let programs = |forms: Vec<Form>| {
        let all = forms.into_iter().filter_map(lower);
        all.filter(|program| !program.values.iter().any(lost)).collect::<Vec<_>>()
    };
    let cheaper =
        |best: Program, other: Program| if cost(&other) < cost(&best) { other } else { best };
    let jets = programs(jets);
    if is_long(spec)
        && let Some(best) = jets.iter().cloned().reduce(cheaper)
    {
        return best;
    }
    let Some(first) = lower(own.clone()) else { fault("a plant without its own form") };
    let others = own.others(spec, linear).into_iter().filter(|form| *form != own).collect();
    programs(others).into_iter().chain(jets).fold(first, cheaper)
}

/// Returns true if the derivatives of a model are so long as expressions that jets take a part of their operations, and
/// to find that out takes long.
fn is_long(spec: &Spec) -> bool {
    spec.expressions().any(|e| e.nodes() > LONG)
}

/// u = (w - f)/g, where w is what is wanted of xn': `law`, where that is for the tracking error.
pub(super) fn control(b: &mut Builder<'_>, law: Value) -> Value {
    let wanted = wanted(b, law);
    match b.form.as_ref().is_some_and(|form| form.divided) {
        true => {
            let u = over_input_gain(b, wanted);
            less_drift(b, u, "f/g, known of the plant")
        }
        false => {
            let less = less_drift(b, wanted, "f, known of the plant");
            over_input_gain(b, less)
        }
    }
}

/// Returns the rate xn' that the law demands, with r^(n) added if it is that of the tracking error, less f(x, t).
pub(super) fn without_drift(b: &mut Builder<'_>, law: Value) -> Value {
    let wanted = wanted(b, law);
    less_drift(b, wanted, "f, known of the plant")
}

fn wanted(b: &mut Builder<'_>, law: Value) -> Value {
    let Some(rate) = b.reference(b.spec.n) else { return law };
    let rate = match b.form.as_ref().and_then(|form| form.scale.clone()) {
        Some(scale) => {
            let scale = b.number(scale);
            b.mul(rate, scale)
        }
        None => rate,
    };
    b.add(law, rate)
}

fn less_drift(b: &mut Builder<'_>, value: Value, meaning: &str) -> Value {
    let own = b.form.as_ref().map_or(&b.spec.drift, |form| &form.drift);
    let Some(drift) = own.clone() else { return value };
    let drift = match b.derivative(b.spec.n) {
        Some(rate) => {
            let scale = b.form.as_ref().and_then(|form| form.scale.clone());
            let scale = Coefficient::Exact(scale.unwrap_or(integer(1)));
            let rate = b.scaled_jet(&rate, &scale);
            b.coefficient(&rate)
        }
        None => b.scalar(&drift),
    };
    let drift = b.name(drift, "drift", meaning);
    b.sub(value, drift)
}
