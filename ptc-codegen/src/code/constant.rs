//! Numbers with a name, which a file declares once.

use num_traits::ToPrimitive;

use super::{Code, Expr, Function, Shape};
use crate::algebra::BigRational;
use crate::parameter::Precision;
use crate::program::number;

/// A number that is known when the code is generated, and has a meaning.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// Its name, as that of the field that would hold it if it were left to run time.
    pub name: String,
    /// Its meaning.
    pub about: String,
    /// [`Shape::Real`], or [`Shape::Count`].
    pub shape: Shape,
    /// Its value; that of a floating-point number is rounded once.
    pub value: BigRational,
}

impl Expr {
    /// Returns it with a name, where it is a number or a count that is known.
    #[must_use]
    pub fn named(self, name: &str, about: &str) -> Self {
        let (shape, value) = match self {
            Self::Number(value) => (Shape::Real, value),
            Self::Count(count) => (Shape::Count, BigRational::from_integer(count.into())),
            other => return other,
        };
        let (name, about) = (name.to_owned(), about.to_owned());
        Self::Constant(Box::new(Constant { name, about, shape, value }))
    }
}

impl Constant {
    /// Its value, where it is a count.
    pub fn count(&self) -> Option<u32> {
        self.value.to_u32().filter(|_| self.shape == Shape::Count)
    }

    /// Returns its value as it is computed with.
    pub fn rounded(&self, precision: Precision) -> f64 {
        self.count().map_or_else(|| number::round(&self.value, precision), f64::from)
    }

    /// Returns its meaning, behind its exact value where that is a fraction of few digits.
    pub fn described(&self) -> String {
        let (numerator, denominator) = (self.value.numer(), self.value.denom());
        let exact = format!("{numerator}/{denominator}");
        match self.value.is_integer() || exact.len() > FRACTION {
            true => self.about.clone(),
            false => format!("{exact}, {}", self.about),
        }
    }
}

/// Characters of a fraction that a reader still takes in.
const FRACTION: usize = 16;

impl Function {
    /// The constants that it reads, each once.
    pub fn constants(&self) -> Vec<Constant> {
        let mut all = Vec::new();
        self.visit(&mut |value| add(value, &mut all));
        all
    }
}

impl Code {
    /// The constants that its functions read, each once.
    pub fn constants(&self) -> Vec<Constant> {
        let mut all = Vec::new();
        self.visit(&mut |value| add(value, &mut all));
        all
    }
}

fn add(value: &Expr, all: &mut Vec<Constant>) {
    if let Expr::Constant(own) = value
        && !all.iter().any(|known| known.name == own.name)
    {
        all.push((**own).clone());
    }
}
