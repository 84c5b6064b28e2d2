//! Rest points of a plant: states and inputs with which nothing moves and every output is at its value.
//!
//! The equations are f(z, u) = 0 and h(z) = r. Where they are linear they are solved exactly. Elsewhere Newton's method
//! is run from several starts, and what it finds is proved: exactly where it is rational, else by Krawczyk's
//! operator K(X) = m - Y F(m) + (1 - Y F'(X))(X - m), which has a zero of F in X if it maps X into itself.

use num_traits::{ToPrimitive, Zero};

use super::number::{consistent, inverse};
use super::plant::Plant;
use crate::algebra::BigRational;
use crate::expression::enclosure::{Interval, Range};
use crate::expression::evaluator::{Evaluator, Existence, Names};
use crate::expression::existence::needs;
use crate::expression::normal::normal;
use crate::expression::{Expression, Variable};

/// Starts of Newton's method, steps of each, and rest points after which no other is looked for.
const STARTS: u32 = 24;
const STEPS: usize = 40;
const POINTS: usize = 3;

/// Largest denominator of a rest point that is tried as a rational one.
const DENOMINATOR: u32 = 1000;

/// Rounds in which the box around a rest point is widened.
const ROUNDS: u32 = 12;

/// States and inputs, one after the other.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Point {
    Exact(Vec<BigRational>),
    /// A box that holds exactly one rest point.
    Near(Vec<Range>),
}

impl Point {
    /// The numbers, about.
    pub(super) fn about(&self) -> Vec<f64> {
        match self {
            Self::Exact(all) => all.iter().map(|x| x.to_f64().unwrap_or(f64::NAN)).collect(),
            Self::Near(all) => all.iter().map(|x| x.middle()).collect(),
        }
    }
}

/// The equations of a rest point, with the values of parameters in place.
pub(super) struct Equations {
    pub(super) unknowns: Vec<Variable>,
    pub(super) values: Vec<Expression>,
    pub(super) slopes: Vec<Vec<Expression>>,
    /// The time in which the reference has its values.
    time: Names,
    evaluator: Evaluator,
}

impl Equations {
    /// Returns the equations of a plant that follows these references, at these times.
    pub(super) fn new(plant: &Plant<'_>, references: &[Expression], time: Names) -> Self {
        let unknowns = plant.unknowns();
        let zero = Expression::integer(0);
        let missed = plant
            .outputs
            .iter()
            .enumerate()
            .map(|(k, h)| h.clone().sub(references.get(k).unwrap_or(&zero).clone()));
        let values: Vec<_> = plant.dynamics.iter().cloned().chain(missed).collect();
        let row = |e: &Expression| unknowns.iter().map(|x| normal(&e.derivative(*x))).collect();
        let slopes = values.iter().map(row).collect();
        Self { unknowns, values, slopes, time, evaluator: Evaluator::new() }
    }

    /// The slopes, where all of them are numbers: the plant is linear.
    pub(super) fn constant(&self) -> Option<Vec<Vec<BigRational>>> {
        let row = |row: &Vec<Expression>| row.iter().map(|e| e.number().cloned()).collect();
        self.slopes.iter().map(row).collect()
    }

    /// An expression at an exact point, if that is a number and certainly exists.
    pub(super) fn number(&self, e: &Expression, at: &[BigRational]) -> Option<BigRational> {
        let placed = |e: &Expression| {
            e.substitute(&|leaf| {
                let place = self.unknowns.iter().position(|x| leaf.variable() == Some(*x))?;
                Some(Expression::from(at[place].clone()))
            })
        };
        let form = normal(&placed(e));
        let exists = needs(e).into_iter().all(|(part, condition)| {
            let value = Evaluator::new().value(&placed(&part), &Names::new());
            value.is_some_and(|value| condition.is_certain(&value.interval))
        });
        form.number().filter(|_| exists).cloned()
    }

    /// An expression over a box, if it certainly exists on all of it.
    pub(super) fn enclosed(&mut self, e: &Expression, at: &[Range]) -> Option<Range> {
        let mut names = self.time.clone();
        for (unknown, range) in self.unknowns.iter().zip(at) {
            names.insert(Expression::from(*unknown), Interval::from(*range));
        }
        let value = self.evaluator.again().value(e, &names)?;
        let range = Range::from(&value.interval);
        (value.existence == Existence::Certain && range.is_bounded()).then_some(range)
    }

    /// The same at any point: a number where it is one.
    pub(super) fn at(&mut self, e: &Expression, point: &Point) -> Option<Range> {
        match point {
            Point::Near(all) => self.enclosed(e, all),
            Point::Exact(all) => {
                let all: Vec<_> = all.iter().map(|x| Range::from(&Interval::exact(x))).collect();
                self.enclosed(e, &all)
            }
        }
    }

    /// The rest points that are found, that of the origin alone if it is one. None may be there.
    pub(super) fn points(&mut self, states: usize) -> Vec<Point> {
        let zeros = vec![BigRational::zero(); self.unknowns.len()];
        if let Some(origin) = self.at_origin(&zeros, states) {
            return vec![origin];
        }
        if let Some(slopes) = self.constant() {
            let right = self.values.iter().map(|e| Some(-self.number(e, &zeros)?));
            let solved = right.collect::<Option<Vec<_>>>().map(|right| consistent(slopes, right));
            if let Some(solved) = solved {
                return solved.map(Point::Exact).into_iter().collect();
            }
        }
        let mut found: Vec<Point> = Vec::new();
        for start in 0..STARTS {
            let begin = (0..self.unknowns.len()).map(|i| start_at(start, i)).collect();
            let Some(point) = self.newton(begin).and_then(|near| self.proved(&near)) else {
                continue;
            };
            let apart = |other: &Point| {
                let pairs = other.about().into_iter().zip(point.about());
                pairs.map(|(a, b)| (a - b).abs() / (1.0 + a.abs())).fold(0.0, f64::max) > 1e-6
            };
            if found.iter().all(apart) {
                found.push(point);
            }
            if found.len() == POINTS {
                break;
            }
        }
        let size = |point: &Point| point.about()[..states].iter().map(|x| x * x).sum::<f64>();
        found.sort_by(|a, b| size(a).total_cmp(&size(b)));
        found
    }

    /// The origin with the input that keeps the plant there.
    fn at_origin(&self, zeros: &[BigRational], states: usize) -> Option<Point> {
        let of_inputs = |row: &Vec<Expression>| {
            row[states..].iter().map(|e| self.number(e, zeros)).collect::<Option<Vec<_>>>()
        };
        let slopes = self.slopes[..states].iter().map(of_inputs).collect::<Option<Vec<_>>>()?;
        let right = self.values[..states].iter().map(|e| Some(-self.number(e, zeros)?));
        let inputs = consistent(slopes, right.collect::<Option<_>>()?)?;
        let mut point = zeros[..states].to_vec();
        point.extend(inputs);
        self.rests(&point).then_some(Point::Exact(point))
    }

    /// Returns true if an exact point solves the equations.
    fn rests(&self, point: &[BigRational]) -> bool {
        self.values.iter().all(|e| self.number(e, point).is_some_and(|value| value.is_zero()))
    }

    fn about(&mut self, e: &Expression, at: &[f64]) -> Option<f64> {
        let at: Vec<_> = at.iter().map(|x| Range::from(*x)).collect();
        Some(self.enclosed(e, &at)?.middle())
    }

    fn values_at(&mut self, at: &[f64]) -> Option<Vec<f64>> {
        let values = self.values.clone();
        values.iter().map(|e| self.about(e, at)).collect()
    }

    fn slopes_at(&mut self, at: &[f64]) -> Option<Vec<Vec<f64>>> {
        let slopes = self.slopes.clone();
        let mut row = |row: &Vec<Expression>| row.iter().map(|e| self.about(e, at)).collect();
        slopes.iter().map(&mut row).collect()
    }

    /// Runs Newton's method from a start, with shorter steps where a whole one leads away.
    pub(super) fn newton(&mut self, mut x: Vec<f64>) -> Option<Vec<f64>> {
        let size = |values: &[f64]| values.iter().map(|v| v * v).sum::<f64>();
        let mut values = self.values_at(&x)?;
        for _ in 0..STEPS {
            let slopes = self.slopes_at(&x)?;
            let step = inverse(&slopes)?;
            let step =
                step.iter().map(|row| row.iter().zip(&values).map(|(a, b)| a * b).sum::<f64>());
            let step: Vec<f64> = step.collect();
            let length =
                step.iter().zip(&x).map(|(s, x)| s.abs() / (1.0 + x.abs())).fold(0.0, f64::max);
            if !length.is_finite() {
                return None;
            }
            if length < 1e-13 || size(&values) == 0.0 {
                return Some(x);
            }
            let tried = (0..12).find_map(|halvings| {
                let part = 0.5_f64.powi(halvings);
                let next: Vec<_> = x.iter().zip(&step).map(|(x, s)| x - part * s).collect();
                let there = self.values_at(&next)?;
                (size(&there) < size(&values)).then_some((next, there))
            });
            match tried {
                Some((next, there)) => (x, values) = (next, there),
                // As near as doubles come.
                None => return (length < 1e-9).then_some(x),
            }
        }
        None
    }

    /// The rest point next to `near`, proved.
    pub(super) fn proved(&mut self, near: &[f64]) -> Option<Point> {
        let guess: Option<Vec<_>> = near.iter().map(|x| fraction(*x)).collect();
        if let Some(guess) = guess.filter(|guess| self.rests(guess)) {
            return Some(Point::Exact(guess));
        }
        let near_inverse = inverse(&self.slopes_at(near)?)?;
        let middle: Vec<_> = near.iter().map(|x| Range::from(*x)).collect();
        let values = self.values.clone();
        let here = values.iter().map(|e| self.enclosed(e, &middle)).collect::<Option<Vec<_>>>()?;
        let through = |row: &Vec<f64>, column: &dyn Fn(usize) -> Range| -> Range {
            row.iter().enumerate().map(|(k, y)| Range::from(*y) * column(k)).sum()
        };
        let moved: Vec<_> = near_inverse.iter().map(|row| through(row, &|k| here[k])).collect();
        let mut wide: Vec<_> = moved
            .iter()
            .zip(near)
            .map(|(moved, x)| 2.0 * moved.size().high() + 1e-13 * (1.0 + x.abs()))
            .collect();
        for _ in 0..ROUNDS {
            let offsets: Vec<_> = wide.iter().map(|w| Range::from(*w).both_signs()).collect();
            let within: Vec<_> = middle.iter().zip(&offsets).map(|(m, d)| *m + *d).collect();
            let all = self.slopes.clone();
            let slopes = all
                .iter()
                .map(|row| {
                    row.iter().map(|e| self.enclosed(e, &within)).collect::<Option<Vec<_>>>()
                })
                .collect::<Option<Vec<_>>>()?;
            let image: Vec<f64> = near_inverse
                .iter()
                .enumerate()
                .map(|(i, row)| {
                    let rest: Range = (0..wide.len())
                        .map(|j| {
                            let own = Range::from(f64::from(u8::from(i == j)));
                            (own - through(row, &|k| slopes[k][j])) * offsets[j]
                        })
                        .sum();
                    (rest - moved[i]).size().high()
                })
                .collect();
            if image.iter().zip(&wide).all(|(image, wide)| image < wide) {
                return Some(Point::Near(within));
            }
            wide = image.iter().zip(&wide).map(|(image, wide)| 2.0 * image.max(*wide)).collect();
        }
        None
    }
}

/// Component `i` of a start: the origin first, then points of a box around it.
fn start_at(start: u32, i: usize) -> f64 {
    if start == 0 {
        return 0.0;
    }
    let seed = f64::from(start) * 0.754_877_666_2
        + 0.569_840_290_9 * (i as u32 as f64 + 1.0) * f64::from(start);
    let reach = if start.is_multiple_of(3) { 5.0 } else { 1.5 };
    reach * (2.0 * seed.fract() - 1.0)
}

/// The fraction with a small denominator that a number is next to.
fn fraction(x: f64) -> Option<BigRational> {
    (1..=DENOMINATOR).find_map(|q| {
        let scaled = x * f64::from(q);
        let near = (scaled - scaled.round()).abs() <= 1e-9 * (1.0 + scaled.abs());
        let whole = BigRational::from_float(scaled.round())?;
        near.then(|| whole / BigRational::from_integer(q.into()))
    })
}
