//! Values that are sums of a constant, of states, inputs and time with constant slopes, and of waves.

use crate::program::Value;

/// Dependence of a value on state, inputs and time.
#[derive(Clone, Debug)]
pub(super) enum Sum {
    /// No dependence.
    Constant(Value),
    State(usize),
    Control,
    Time,
    Neg(usize),
    Add(usize, usize),
    Sub(usize, usize),
    /// The product with a constant.
    Mul(usize, usize),
    Div(usize, usize),
    /// a b + c with a constant b.
    Fused(usize, usize, usize),
    /// The sine of what goes with time alone, and whether it is a cosine.
    Wave(usize, bool),
    /// Any other dependence.
    Other,
}

impl Sum {
    /// The places of the sums that it is made of.
    fn operands(&self) -> impl Iterator<Item = usize> {
        let (first, others) = match *self {
            Self::Neg(a) | Self::Wave(a, _) => (Some(a), [None; 2]),
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => {
                (Some(a), [Some(b), None])
            }
            Self::Fused(a, b, c) => (Some(a), [Some(b), Some(c)]),
            Self::Constant(_) | Self::State(_) | Self::Control | Self::Time | Self::Other => {
                (None, [None; 2])
            }
        };
        first.into_iter().chain(others.into_iter().flatten())
    }
}

/// The places of what some sums are made of, and of themselves, operands first.
pub(super) fn needed(sums: &[Sum], roots: &[usize]) -> Vec<usize> {
    let mut wanted = vec![false; sums.len()];
    roots.iter().for_each(|root| wanted[*root] = true);
    for place in (0..sums.len()).rev() {
        if wanted[place] {
            sums[place].operands().for_each(|operand| wanted[operand] = true);
        }
    }
    (0..sums.len()).filter(|place| wanted[*place]).collect()
}

/// The terms of values, each at its place.
#[derive(Clone, Debug, Default)]
pub(super) struct Terms {
    pub(super) constant: Vec<f64>,
    pub(super) time: Vec<f64>,
    /// A row of slopes of the states and the inputs for each value.
    slopes: Vec<f64>,
    width: usize,
    /// The waves by the value that each one is.
    waves: Vec<Vec<(usize, f64)>>,
}

impl Terms {
    /// Before the sums of so many values of so many states and inputs.
    pub(super) fn begin(&mut self, values: usize, width: usize) {
        self.width = width;
        self.constant.resize(values, 0.0);
        self.time.resize(values, 0.0);
        self.slopes.resize(values * width, 0.0);
        self.waves.resize(values, Vec::new());
    }

    /// The slopes of a value.
    pub(super) fn slopes(&self, place: usize) -> &[f64] {
        &self.slopes[place * self.width..][..self.width]
    }

    /// Returns the factor of a wave in a value.
    pub(super) fn factor(&self, place: usize, wave: usize) -> f64 {
        let own = self.waves[place].iter().filter(|(own, _)| *own == wave);
        own.map(|(_, factor)| factor).sum()
    }

    /// Takes the terms of a value whose operands are known; of so many states.
    pub(super) fn sum(&mut self, to: usize, sum: &Sum, states: usize, get: impl Fn(Value) -> f64) {
        match *sum {
            Sum::Other => self.none(to),
            Sum::Constant(value) => {
                self.none(to);
                self.constant[to] = get(value);
            }
            Sum::State(j) => self.unit(to, j - 1),
            Sum::Control => self.unit(to, states),
            Sum::Time => {
                self.none(to);
                self.time[to] = 1.0;
            }
            Sum::Wave(..) => {
                self.none(to);
                self.waves[to].push((to, 1.0));
            }
            Sum::Neg(a) => self.map(to, a, |a| -a),
            Sum::Add(a, b) => self.plus(to, a, (b, |b| b)),
            Sum::Sub(a, b) => self.plus(to, a, (b, |b| -b)),
            Sum::Mul(a, b) => {
                let factor = self.constant[b];
                self.map(to, a, |a| a * factor);
            }
            Sum::Div(a, b) => {
                let divisor = self.constant[b];
                self.map(to, a, |a| a / divisor);
            }
            Sum::Fused(a, b, c) => {
                let factor = self.constant[b];
                self.map(to, a, |a| a * factor);
                self.plus(to, to, (c, |c| c));
            }
        }
    }

    fn none(&mut self, to: usize) {
        (self.constant[to], self.time[to]) = (0.0, 0.0);
        self.slopes[to * self.width..][..self.width].fill(0.0);
        self.waves[to].clear();
    }

    fn unit(&mut self, to: usize, place: usize) {
        self.none(to);
        self.slopes[to * self.width + place] = 1.0;
    }

    /// A function of each term of another value.
    fn map(&mut self, to: usize, a: usize, of: impl Fn(f64) -> f64) {
        (self.constant[to], self.time[to]) = (of(self.constant[a]), of(self.time[a]));
        for place in 0..self.width {
            self.slopes[to * self.width + place] = of(self.slopes[a * self.width + place]);
        }
        let mut waves = std::mem::take(&mut self.waves[to]);
        waves.clear();
        waves.extend(self.waves[a].iter().map(|(wave, factor)| (*wave, of(*factor))));
        self.waves[to] = waves;
    }

    /// The sum of another value, which may be this one, and a function of a second.
    fn plus(&mut self, to: usize, a: usize, (b, of): (usize, impl Fn(f64) -> f64)) {
        self.constant[to] = self.constant[a] + of(self.constant[b]);
        self.time[to] = self.time[a] + of(self.time[b]);
        for place in 0..self.width {
            let (a, b) = (a * self.width + place, b * self.width + place);
            self.slopes[to * self.width + place] = self.slopes[a] + of(self.slopes[b]);
        }
        let mut waves = std::mem::take(&mut self.waves[to]);
        if a != to {
            waves.clear();
            waves.extend_from_slice(&self.waves[a]);
        }
        waves.extend(self.waves[b].iter().map(|(wave, factor)| (*wave, of(*factor))));
        self.waves[to] = waves;
    }
}
