//! Bounds of every value of a program for inputs from intervals and a stretch of time-to-go.

use std::collections::BTreeMap;

use super::computed::{Computed, apply, outward};
use super::regular::Regular;
use crate::expression::Function;
use crate::program::{Input, Op, Program, Root, Stage, Value, rows};

/// A program's values as intervals.
#[derive(Clone)]
pub(crate) struct Bounds<'a> {
    program: &'a Program,
    input: &'a dyn Fn(Input) -> Computed,
    known: Vec<Option<Computed>>,
    arrays: BTreeMap<Value, Vec<Computed>>,
    /// Bounds of the matrices of eliminations that were found otherwise.
    regular: BTreeMap<Value, Regular>,
    /// Values that represent a stretch of time-to-go: `late`, and the time past the deadline in it.
    held: Vec<Value>,
}

impl<'a> Bounds<'a> {
    /// The bounds of what is known before time is.
    pub(crate) fn new(program: &'a Program, input: &'a dyn Fn(Input) -> Computed) -> Self {
        let late = program.limits.late;
        let mut held = vec![late];
        if let Op::Min(a, b) = program.get(late).op {
            held.extend([a, b].into_iter().filter(|v| program.get(*v).stage == Stage::Tick));
        }
        let mut bounds = Self::open(program, input, held);
        for (index, definition) in program.values.iter().enumerate() {
            if definition.stage < Stage::Tick {
                bounds.settle(Value(index));
            }
        }
        bounds
    }

    fn open(program: &'a Program, input: &'a dyn Fn(Input) -> Computed, held: Vec<Value>) -> Self {
        let (known, arrays) = (vec![None; program.values.len()], BTreeMap::new());
        Self { program, input, known, arrays, regular: BTreeMap::new(), held }
    }

    /// The bounds of some values, and of what they need, for all times.
    pub(super) fn only(
        program: &'a Program,
        input: &'a dyn Fn(Input) -> Computed,
        values: &[Value],
    ) -> Self {
        let mut bounds = Self::open(program, input, Vec::new());
        for needed in program.needed(values) {
            bounds.settle(needed);
        }
        bounds
    }

    /// Takes a bound that was found otherwise; it holds for every time.
    pub(super) fn set(&mut self, value: Value, bound: Computed) {
        self.known[value.0] = Some(bound);
    }

    /// Takes the bounds of the matrix of an elimination, which hold for every time.
    pub(super) fn set_regular(&mut self, elimination: Value, bounds: Regular) {
        self.regular.insert(elimination, bounds);
    }

    /// The bounds for time-to-go from `low` to `high`. Time itself is not needed: `late` is set, as
    /// the digits it has left near the deadline would be lost in an interval of t - deadline, and the
    /// elapsed time that goes with it.
    pub(crate) fn at(&self, low: f64, high: f64) -> Self {
        let mut bounds = self.clone();
        for held in &self.held {
            bounds.known[held.0] = Some(outward(-high, -low, self.program.precision));
        }
        if let Some((elapsed, tau)) = self.program.limits.elapsed {
            let tau = self.get(tau);
            // Time-to-go is known up to its own roundings, which near the deadline are those of tau.
            let slack = 4.0 * self.program.precision.epsilon() * tau.range.high();
            let (least, most) =
                ((tau.range.low() - high - slack).max(0.0), tau.range.high() - low + slack);
            bounds.known[elapsed.0] = Some(outward(least, most, self.program.precision));
        }
        bounds
    }

    /// Returns true if a value is set together with the time-to-go.
    fn is_set(&self, value: Value) -> bool {
        let elapsed = self.program.limits.elapsed;
        self.held.contains(&value) || elapsed.is_some_and(|(elapsed, _)| elapsed == value)
    }

    /// Returns the values that represent a stretch of time-to-go.
    #[cfg(feature = "lab")]
    pub(crate) fn held(&self) -> &[Value] {
        &self.held
    }

    /// The bound of a value that has been computed.
    pub(crate) fn get(&self, value: Value) -> Computed {
        self.known[value.0].unwrap_or(Computed::ANY)
    }

    /// The bounds of several.
    pub(super) fn all(&self, values: &[Value]) -> Vec<Computed> {
        values.iter().map(|value| self.get(*value)).collect()
    }

    /// Computes what `roots` need and returns the first value that may leave the range.
    pub(crate) fn first_excess(&mut self, roots: &[Value]) -> Option<Value> {
        let needed = self.needed(roots);
        for value in &needed {
            if self.known[value.0].is_none() && !self.program.get(*value).looped {
                self.settle(*value);
            }
        }
        let computed = needed.into_iter().filter(|value| !self.program.get(*value).looped);
        computed.into_iter().find(|value| self.get(*value).special)
    }

    /// Gives the gains, once computed, to what `axis` takes as inputs.
    pub(crate) fn hand_over_gains(&mut self) {
        for (index, definition) in self.program.values.iter().enumerate() {
            let given = match definition.op {
                Op::Input(Input::Gain(j)) => self.program.gains.get(j - 1),
                Op::Input(Input::Divisor) => self.program.divisors.first(),
                _ => None,
            };
            if let Some(given) = given {
                self.known[index] = Some(self.get(*given));
            }
        }
    }

    /// The values needed for `roots`, without what only serves those that are held.
    pub(crate) fn needed(&self, roots: &[Value]) -> Vec<Value> {
        let mut wanted = vec![false; self.known.len()];
        for root in roots {
            wanted[root.0] = true;
        }
        for index in (0..wanted.len()).rev() {
            if wanted[index] && !self.is_set(Value(index)) {
                for operand in self.program.values[index].op.operands() {
                    wanted[operand.0] = true;
                }
            }
        }
        (0..wanted.len()).filter(|index| wanted[*index]).map(Value).collect()
    }

    fn settle(&mut self, value: Value) {
        let op = &self.program.get(value).op;
        if let Op::Rows { tail, weights, fused } = op {
            self.arrays.insert(value, self.rows(tail, weights, *fused));
        }
        if let Op::Elimination { matrix, right } = op {
            self.arrays.insert(value, self.solution(value, matrix, right));
        }
        self.known[value.0] = Some(self.compute(op));
    }

    fn compute(&self, op: &Op) -> Computed {
        match op {
            Op::Input(input) => (self.input)(*input),
            Op::Root(root) => self.root(root),
            // The array as a whole; an excess within reaches one of its elements.
            Op::Rows { .. } | Op::Elimination { .. } => Computed::point(0.0),
            Op::Element(array, index) => self.arrays[array][*index],
            op => apply(op, &self.all(&op.operands()), self.program.precision),
        }
    }

    /// Bounds the solution of a system; any value is possible where the matrix may be singular.
    fn solution(&self, elimination: Value, matrix: &[Value], right: &[Value]) -> Vec<Computed> {
        let [matrix, right] = [matrix, right].map(|values| self.all(values));
        let known = self.regular.get(&elimination).copied();
        let known = known.or_else(|| Regular::of(&matrix, self.program.precision).ok());
        let solution = known.and_then(|known| known.solution(&right));
        solution.unwrap_or_else(|| vec![Computed::ANY; right.len() + 1])
    }

    /// The loops of an array, operation by operation.
    fn rows(&self, tail: &[Value], weights: &[Value], fused: bool) -> Vec<Computed> {
        let [tail, weights] = [tail, weights].map(|values| self.all(values));
        let on = |op: &Op, of: &[Computed]| apply(op, of, self.program.precision);
        rows::by_operations(&tail, &weights, fused, on)
    }

    /// Returns where the iteration may end: its bracket, cut to where the residual, which decreases, is not certain to
    /// have one sign, widened by the largest length of the last step. Intermediate values of the loop do not count: the
    /// iteration bisects where they are not numbers.
    fn root(&self, root: &Root) -> Computed {
        let [low, high, start, tolerance] =
            [root.low, root.high, root.start, root.tolerance].map(|value| self.get(value));
        if [low, high, start, tolerance].iter().any(|bound| bound.special) {
            return Computed::ANY;
        }
        let (least, most) =
            (low.range.least(&start.range).low(), high.range.most(&start.range).high());
        let body: Vec<_> = self.needed(&[root.residual]);
        let body: Vec<_> = body.into_iter().filter(|v| self.program.get(*v).looped).collect();
        let mut scratch = self.clone();
        let mut residual = |y: f64| {
            scratch.known[root.unknown.0] = Some(Computed::point(y));
            for value in body.iter().filter(|value| **value != root.unknown) {
                scratch.settle(*value);
            }
            scratch.get(root.residual)
        };
        let size = &self.program.get(root.size).op;
        let of_residual = *size == Op::Call(Function::Abs, root.residual);
        // Where the last step begins, the residual may still have this size.
        let last = if of_residual { tolerance.range.high() } else { 0.0 };
        let is_left = |found: Computed| !found.special && found.range.low() > last;
        let is_right = |found: Computed| !found.special && found.range.high() < -last;
        let far = beyond(least, most, &mut |y| is_right(residual(y)));
        let left = edge(least, far, &mut |y| is_left(residual(y)));
        let right = edge(far, left, &mut |y| is_right(residual(y)));
        // A step to the root from where the residual is as small is no longer than all that stretch.
        let reach = if of_residual { right - left } else { tolerance.range.high() };
        outward((left - reach).max(least), (right + reach).min(most), self.program.precision)
    }
}

/// A point beyond `from` at which `certain` holds, of the size of the least one; `to` where none is
/// found. A bracket may reach up to numbers with which what is computed leaves the range.
fn beyond(from: f64, to: f64, certain: &mut dyn FnMut(f64) -> bool) -> f64 {
    let steps = (-20..=50).map(|k| from + 16f64.powi(k));
    steps.take_while(|y| *y < to).find(|y| certain(*y)).unwrap_or(to)
}

/// The last point from `from` towards `to` at which `certain` holds; `from` where it never does.
fn edge(from: f64, to: f64, certain: &mut dyn FnMut(f64) -> bool) -> f64 {
    let (mut inside, mut outside) = (from, to);
    // More halvings would gain less than the last step of the iteration takes away.
    for _ in 0..24 {
        let between = 0.5 * (inside + outside);
        if certain(between) {
            inside = between;
        } else {
            outside = between;
        }
    }
    inside
}
