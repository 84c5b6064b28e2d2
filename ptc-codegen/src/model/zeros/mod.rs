//! The zero dynamics: what the plant does beside outputs that are held at their values, at its rest point.

mod number;
mod plant;
mod rest;

pub(crate) use plant::Plant;

use num_traits::{ToPrimitive, Zero};

use super::Values;
use super::decide::with;
use crate::algebra::BigRational;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::stability::{is_bounded, is_hurwitz};
use crate::diagnostic::digits;
use crate::expression::effort::bounded;
use crate::expression::enclosure::{Interval, Range};
use crate::expression::evaluator::Names;
use crate::expression::{Expression, Variable};
use crate::parameter::Parameter;
use number::{Number, characteristic, has_both_signs, solved, times, unstable_roots};
use rest::{Equations, Point};

/// Result on the zero dynamics at a rest point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Zeros {
    /// The law divides by 0 there.
    Singular,
    /// There are none.
    None,
    /// The roots of their linearisation have negative real parts.
    Stable(Polynomial),
    /// One of its roots has a positive real part.
    Unstable(Polynomial),
    /// Roots on the imaginary axis, or too near to it to tell, and no others to the right.
    Critical(Polynomial),
    /// Why they are not known.
    Open(String),
}

/// The zero dynamics at one rest point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct AtRest {
    /// Rest point, in words: `the origin`.
    pub(crate) place: String,
    pub(crate) zeros: Zeros,
}

impl AtRest {
    fn nowhere(why: impl Into<String>) -> Vec<Self> {
        vec![Self { place: NOWHERE.to_owned(), zeros: Zeros::Open(why.into()) }]
    }
}

/// Reference of the outputs.
pub(crate) enum Followed<'a> {
    /// Constants.
    Constant(&'a [Expression]),
    /// Known functions of time, over a run of this length from this start, where these are known.
    Moving { references: &'a [Expression], run: Option<[BigRational; 2]> },
    /// Values that each call is given.
    Given,
}

/// The place of what has no rest point that is known.
const NOWHERE: &str = "no rest point";

/// Cells of time in each of which a reference has a rest point of its own.
const CELLS: u32 = 64;

/// The zero dynamics of a plant at its rest points, that of the origin alone if it is one. `divisor` is what the law
/// divides by.
pub(crate) fn zeros(
    plant: &Plant<'_>,
    divisor: Option<&Expression>,
    followed: &Followed<'_>,
    values: &Values,
) -> Vec<AtRest> {
    bounded(|| {
        let mut parts = plant.parts().chain(divisor);
        let open = parts.find_map(|e| with(e, values).parameters().into_iter().next());
        let divisor = divisor.map(|e| with(e, values));
        if plant.degree() == plant.order() {
            let none = || vec![AtRest { place: String::new(), zeros: Zeros::None }];
            // What the law divides by is looked at where a rest point is known.
            let is_number =
                divisor.as_ref().is_none_or(|e| e.number().is_some_and(|g| !g.is_zero()));
            let found = match is_number || open.is_some() {
                true => none(),
                false => found(plant, divisor.as_ref(), followed, values),
            };
            let is_known = found.iter().all(|at| at.place != NOWHERE);
            if is_known {
                return found;
            }
            let at_origin = at_origin(plant, divisor.as_ref(), followed);
            return at_origin.map_or_else(none, |at| vec![at]);
        }
        if let Some(open) = open {
            return AtRest::nowhere(format!("`{}` is left to run time", open.spelling()));
        }
        found(plant, divisor.as_ref(), followed, values)
    })
}

/// The origin, where all outputs come to rest there and it is not certain that the law does not divide by 0 at it.
fn at_origin(
    plant: &Plant<'_>,
    divisor: Option<&Expression>,
    followed: &Followed<'_>,
) -> Option<AtRest> {
    let Followed::Constant(references) = followed else { return None };
    let divisor = divisor.filter(|_| references.iter().all(|r| *r == Expression::integer(0)))?;
    let mut equations = Equations::new(plant, &[], Names::new());
    let origin = Point::Exact(vec![BigRational::zero(); equations.unknowns.len()]);
    let zeros = match of_divisor(plant, divisor, &mut equations, &origin)? {
        // The other states may be elsewhere when the outputs are at rest.
        Zeros::Singular => Zeros::Open(format!(
            "{} is 0 at the origin, which is not known to be a rest point: the law divides by it",
            plant.text(divisor)
        )),
        open => open,
    };
    Some(AtRest { place: "the origin".to_owned(), zeros })
}

/// The same without parameters that are left to run time.
fn found(
    plant: &Plant<'_>,
    divisor: Option<&Expression>,
    followed: &Followed<'_>,
    values: &Values,
) -> Vec<AtRest> {
    if let Some(kink) = plant.parts().find(|e| e.any(&Expression::is_kink)) {
        let kink = plant.text(kink);
        return AtRest::nowhere(format!("{kink} has a kink: it has no linearisation"));
    }
    let references: &[Expression] = match followed {
        Followed::Constant(references) | Followed::Moving { references, .. } => references,
        Followed::Given => &[],
    };
    let references: Vec<_> = references.iter().map(|e| with(e, values)).collect();
    let mut equations = Equations::new(plant, &references, Names::new());
    let is_linear = equations.constant().is_some();
    match followed {
        // The slopes of a linear plant are the same everywhere.
        Followed::Moving { .. } | Followed::Given if is_linear => {
            let origin = Point::Exact(vec![BigRational::zero(); equations.unknowns.len()]);
            let zeros = judged(plant, divisor, &mut equations, &origin);
            vec![AtRest { place: "every point".to_owned(), zeros }]
        }
        Followed::Given => {
            AtRest::nowhere("each call is given the reference, and the plant is not linear")
        }
        Followed::Moving { run: None, .. } => AtRest::nowhere(
            "the reference moves for a time that is left to run time, and the plant is not linear",
        ),
        Followed::Moving { run: Some(run), .. } => along(plant, divisor, &references, run),
        Followed::Constant(_) => {
            let points = equations.points(plant.order());
            if points.is_empty() {
                return AtRest::nowhere(
                    "no isolated rest point is found with the output at its value",
                );
            }
            let at = |point: &Point| AtRest {
                place: place(plant, point),
                zeros: judged(plant, divisor, &mut equations, point),
            };
            points.iter().map(at).collect()
        }
    }
}

/// The zero dynamics at all values of a reference that moves: those at which they are not stable, or all.
fn along(
    plant: &Plant<'_>,
    divisor: Option<&Expression>,
    references: &[Expression],
    [start, tau]: &[BigRational; 2],
) -> Vec<AtRest> {
    let at = |share: u32| tau * BigRational::new(share.into(), CELLS.into());
    let names = |from: u32, to: u32| {
        let within = |low: BigRational, high: BigRational| Interval::between(&low, Some(&high));
        Names::from([
            (Variable::Elapsed.into(), within(at(from), at(to))),
            (Variable::Time.into(), within(start + at(from), start + at(to))),
        ])
    };
    let mut near = vec![0.0; plant.unknowns().len()];
    let (mut last, mut undecided) = (None, None);
    for cell in 0..CELLS {
        let from =
            || format!("t = {} s of the reference", digits(at(cell).to_f64().unwrap_or(f64::NAN)));
        let here = Equations::new(plant, references, names(cell, cell)).newton(near.clone());
        let mut equations = Equations::new(plant, references, names(cell, cell + 1));
        let point = here.as_ref().and_then(|here| equations.proved(here));
        near = here.unwrap_or(near);
        let Some(point) = point else {
            let why = format!("the rest point at {} is not enclosed", from());
            undecided = undecided.or(AtRest::nowhere(why).pop());
            continue;
        };
        let zeros = judged(plant, divisor, &mut equations, &point);
        let place = format!("the rest point at {}", from());
        match zeros {
            Zeros::Stable(_) | Zeros::None => last = Some(zeros),
            Zeros::Unstable(_) | Zeros::Singular => return vec![AtRest { place, zeros }],
            Zeros::Critical(_) | Zeros::Open(_) => {
                undecided.get_or_insert(AtRest { place, zeros });
            }
        }
    }
    let place = "every value of the reference".to_owned();
    let decided = last.map(|zeros| AtRest { place, zeros });
    undecided.or(decided).into_iter().collect()
}

/// Describes a rest point.
fn place(plant: &Plant<'_>, point: &Point) -> String {
    let about = point.about();
    if about[..plant.order()].iter().all(|x| *x == 0.0) {
        return "the origin".to_owned();
    }
    let of = |(name, x): (Parameter, &f64)| format!("{} = {}", name.spelling(), digits(*x));
    let all: Vec<_> = plant.names().map(Parameter::Named).zip(&about).map(of).collect();
    format!("the rest point {}", all.join(", "))
}

/// The zero dynamics at one of the rest points.
fn judged(
    plant: &Plant<'_>,
    divisor: Option<&Expression>,
    equations: &mut Equations,
    point: &Point,
) -> Zeros {
    if let Some(zeros) = divisor.and_then(|own| of_divisor(plant, own, equations, point)) {
        return zeros;
    }
    let exact = match point {
        Point::Exact(at) => {
            let number = |e: &Expression| equations.number(e, at);
            let row = |row: &Vec<Expression>| row.iter().map(number).collect::<Option<Vec<_>>>();
            equations.slopes.iter().map(row).collect::<Option<Vec<_>>>()
        }
        Point::Near(_) => None,
    };
    if let Some(slopes) = exact {
        return match polynomial(plant, &slopes) {
            None => Zeros::Singular,
            Some(_) if plant.degree() == plant.order() => Zeros::None,
            Some(p) => of_polynomial(Polynomial::new(p)),
        };
    }
    let slopes = equations.slopes.clone();
    let mut row = |row: &Vec<Expression>| row.iter().map(|e| equations.at(e, point)).collect();
    let slopes: Option<Vec<Vec<Range>>> = slopes.iter().map(&mut row).collect();
    let Some(p) = slopes.and_then(|slopes| polynomial(plant, &slopes)) else {
        return Zeros::Open("the linearisation is not enclosed".to_owned());
    };
    if plant.degree() == plant.order() {
        return Zeros::None;
    }
    let about = p.iter().map(|c| BigRational::from_float(c.middle())).collect::<Option<Vec<_>>>();
    let about = Polynomial::new(about.unwrap_or_default());
    match unstable_roots(&p) {
        Some(0) => Zeros::Stable(about),
        Some(_) => Zeros::Unstable(about),
        None if has_both_signs(&p) => Zeros::Unstable(about),
        None => Zeros::Critical(about),
    }
}

/// Result at a point where the law divides by 0, or may do so.
fn of_divisor(
    plant: &Plant<'_>,
    divisor: &Expression,
    equations: &mut Equations,
    point: &Point,
) -> Option<Zeros> {
    if let Point::Exact(at) = point
        && let Some(value) = equations.number(divisor, at)
    {
        return value.is_zero().then_some(Zeros::Singular);
    }
    let is = match equations.at(divisor, point) {
        Some(value) if value.is_apart() => return None,
        Some(_) => "may be 0",
        None => "has no value that is known",
    };
    Some(Zeros::Open(format!("{} {is}: the law divides by it", plant.text(divisor))))
}

fn of_polynomial(p: Polynomial) -> Zeros {
    if is_hurwitz(&p) {
        return Zeros::Stable(p);
    }
    // Repeated roots on the axis are counted once.
    if is_bounded(&p.radical()) { Zeros::Critical(p) } else { Zeros::Unstable(p) }
}

/// The characteristic polynomial of the linearised zero dynamics; `None` where the inputs do not move the outputs one
/// by one. With the feedback that holds the outputs of z' = A z + B v, y = C z at 0, v = -D^-1 (C_k A^(r_k) z) with
/// D = (C_k A^(r_k - 1) B), it is what is left of that of the loop without its roots at 0, one for each degree.
fn polynomial<T: Number>(plant: &Plant<'_>, slopes: &[Vec<T>]) -> Option<Vec<T>> {
    let states = plant.order();
    let (rates, outputs) = slopes.split_at(states);
    let a: Vec<Vec<T>> = rates.iter().map(|row| row[..states].to_vec()).collect();
    let b: Vec<Vec<T>> = rates.iter().map(|row| row[states..].to_vec()).collect();
    let (mut decoupling, mut forced) = (Vec::new(), Vec::new());
    for (row, degree) in outputs.iter().zip(&plant.degrees) {
        let mut row = row[..states].to_vec();
        for _ in 1..*degree {
            row = times(&row, &a);
        }
        decoupling.push(times(&row, &b));
        forced.push(times(&row, &a));
    }
    let held = solved(decoupling, forced)?;
    let closed: Vec<Vec<T>> = a
        .iter()
        .zip(&b)
        .map(|(own, through)| {
            let pulled = times(through, &held);
            own.iter().zip(pulled).map(|(own, pulled)| own.clone() - pulled).collect()
        })
        .collect();
    Some(characteristic(&closed).split_off(plant.degree()))
}
