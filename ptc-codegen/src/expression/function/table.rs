//! The table: a row a function, in the order of the enum.

use super::{Domain, Function, Parity, Pieces, Signs, Slope};
use Function::{
    Abs, Acos, Asin, Atan, Atanh, Cbrt, Cos, Cosh, Exp, Ln, Sign, Sin, Sinh, Sqrt, Tan, Tanh,
};
use Parity::{Even, Odd};

/// Properties of a function.
pub(crate) struct Row {
    pub(crate) function: Function,
    /// The name that users write; those of the libraries of all languages are the same.
    pub(crate) name: &'static str,
    /// The values of the platform.
    pub(crate) double: fn(f64) -> f64,
    pub(crate) single: fn(f32) -> f32,
    /// True if every platform returns the exact value, rounded once.
    pub(crate) is_exact: bool,
    pub(crate) parity: Option<Parity>,
    pub(crate) domain: Domain,
    pub(crate) pieces: Pieces,
    /// Bounds of the values.
    pub(crate) bounds: [Option<i64>; 2],
    pub(crate) signs: Signs,
    /// True if it has a kink or a jump where its argument is 0.
    pub(crate) has_kink: bool,
    pub(crate) slope: Slope,
    /// Integers at which the value is an integer, and that.
    pub(crate) known: &'static [[i64; 2]],
    /// A function that undoes it on the branch on which mappings lie.
    pub(crate) inverse: Option<Function>,
}

/// A rising odd function of all numbers, computed by a library: what most rows differ from in a few fields.
const PLAIN: Row = Row {
    function: Sinh,
    name: "",
    double: f64::sinh,
    single: f32::sinh,
    is_exact: false,
    parity: Some(Odd),
    domain: Domain::Everywhere,
    pieces: Pieces::Rising,
    bounds: [None, None],
    signs: Signs::Argument,
    has_kink: false,
    slope: Slope::Zero,
    known: &[[0, 0]],
    inverse: None,
};

pub(super) const TABLE: [Row; 16] = [
    Row {
        function: Abs,
        name: "abs",
        double: f64::abs,
        single: f32::abs,
        is_exact: true,
        parity: Some(Even),
        pieces: Pieces::Valley,
        bounds: [Some(0), None],
        signs: Signs::Size,
        has_kink: true,
        slope: Slope::Sign,
        ..PLAIN
    },
    Row {
        function: Sign,
        name: "sign",
        double: |a| sign(a, 0.0, 1.0),
        single: |a| sign(a, 0.0, 1.0),
        is_exact: true,
        bounds: [Some(-1), Some(1)],
        has_kink: true,
        ..PLAIN
    },
    Row {
        function: Sqrt,
        name: "sqrt",
        double: f64::sqrt,
        single: f32::sqrt,
        is_exact: true,
        parity: None,
        domain: Domain::NotNegative,
        bounds: [Some(0), None],
        signs: Signs::NotNegative,
        slope: Slope::HalfReciprocal,
        known: &[[0, 0], [1, 1]],
        ..PLAIN
    },
    Row {
        function: Exp,
        name: "exp",
        double: f64::exp,
        single: f32::exp,
        parity: None,
        bounds: [Some(0), None],
        signs: Signs::Positive,
        slope: Slope::Own,
        known: &[[0, 1]],
        inverse: Some(Ln),
        ..PLAIN
    },
    Row {
        function: Ln,
        name: "ln",
        double: f64::ln,
        single: f32::ln,
        parity: None,
        domain: Domain::Positive,
        signs: Signs::ArgumentLessOne,
        slope: Slope::Reciprocal,
        known: &[[1, 0]],
        inverse: Some(Exp),
        ..PLAIN
    },
    Row {
        function: Sin,
        name: "sin",
        double: f64::sin,
        single: f32::sin,
        pieces: Pieces::Wave(1),
        bounds: [Some(-1), Some(1)],
        signs: Signs::ArgumentWithin(1),
        slope: Slope::Partner(Cos, 1),
        ..PLAIN
    },
    Row {
        function: Cos,
        name: "cos",
        double: f64::cos,
        single: f32::cos,
        parity: Some(Even),
        pieces: Pieces::Wave(0),
        bounds: [Some(-1), Some(1)],
        signs: Signs::PositiveWithin(2),
        slope: Slope::Partner(Sin, -1),
        known: &[[0, 1]],
        ..PLAIN
    },
    Row {
        function: Tan,
        name: "tan",
        double: f64::tan,
        single: f32::tan,
        domain: Domain::OffPoles,
        pieces: Pieces::Branches,
        signs: Signs::ArgumentWithin(2),
        slope: Slope::OneAndSquare(1),
        ..PLAIN
    },
    Row {
        function: Atan,
        name: "atan",
        double: f64::atan,
        single: f32::atan,
        bounds: [Some(-2), Some(2)],
        slope: Slope::OverOneAndSquare(1),
        inverse: Some(Tan),
        ..PLAIN
    },
    Row { function: Sinh, name: "sinh", slope: Slope::Partner(Cosh, 1), ..PLAIN },
    Row {
        function: Cosh,
        name: "cosh",
        double: f64::cosh,
        single: f32::cosh,
        parity: Some(Even),
        pieces: Pieces::Valley,
        bounds: [Some(1), None],
        signs: Signs::Positive,
        slope: Slope::Partner(Sinh, 1),
        known: &[[0, 1]],
        ..PLAIN
    },
    Row {
        function: Tanh,
        name: "tanh",
        double: f64::tanh,
        single: f32::tanh,
        bounds: [Some(-1), Some(1)],
        slope: Slope::OneAndSquare(-1),
        inverse: Some(Atanh),
        ..PLAIN
    },
    Row {
        function: Atanh,
        name: "atanh",
        double: f64::atanh,
        single: f32::atanh,
        domain: Domain::InsideOne,
        slope: Slope::OverOneAndSquare(-1),
        inverse: Some(Tanh),
        ..PLAIN
    },
    Row {
        function: Asin,
        name: "asin",
        double: f64::asin,
        single: f32::asin,
        domain: Domain::WithinOne,
        bounds: [Some(-2), Some(2)],
        slope: Slope::OverCircle(1),
        inverse: Some(Sin),
        ..PLAIN
    },
    Row {
        function: Acos,
        name: "acos",
        double: f64::acos,
        single: f32::acos,
        parity: None,
        domain: Domain::WithinOne,
        pieces: Pieces::Falling,
        bounds: [Some(0), Some(4)],
        signs: Signs::NeverNegative,
        slope: Slope::OverCircle(-1),
        known: &[[1, 0]],
        inverse: Some(Cos),
        ..PLAIN
    },
    Row {
        function: Cbrt,
        name: "cbrt",
        double: f64::cbrt,
        single: f32::cbrt,
        slope: Slope::ThirdReciprocalSquare,
        known: &[[0, 0], [1, 1], [-1, -1]],
        ..PLAIN
    },
];

/// The functions by name.
pub(super) const fn names() -> [(&'static str, Function); TABLE.len()] {
    let mut all = [("", Abs); TABLE.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = (TABLE[i].name, TABLE[i].function);
        i += 1;
    }
    all
}

/// 1, -1, or a itself where it is a zero or no number.
fn sign<R: PartialOrd + std::ops::Neg<Output = R> + Copy>(a: R, zero: R, one: R) -> R {
    if a > zero {
        one
    } else if a < zero {
        -one
    } else {
        a
    }
}
