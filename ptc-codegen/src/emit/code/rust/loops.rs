//! The loops over the powers of a series, and those of an elimination.

use super::super::text::Text;
use super::Rust;
use crate::code::Shape;

impl Rust<'_> {
    /// The function that forms so many rows.
    pub(super) fn rows_function(&mut self, weights: usize, fused: bool) {
        let (real, tail) = (self.type_of(Shape::Real), weights - 1);
        let part = tail - 1;
        let more = |a: &str, b: &str| {
            let operands = [a, b, "*sum"].map(str::to_owned);
            match self.fused(&operands).filter(|_| fused) {
                Some(fused) => format!("*sum = {fused}"),
                None => format!("*sum += {a} * {b}"),
            }
        };
        let (of_square, of_row) = (more("*a", "*b"), more("*coefficient", "*row"));
        self.out.line(format!(
            "
/// Loops over the powers of the Taylor series of mu, for the gains of all states at once.
fn rows(mut rows: [{real}; {weights}], tail: &[{real}; {tail}]) -> [{real}; {weights}] {{
    let mut square = [0.0; {part}];
    for (d, (sum, own)) in square.iter_mut().zip(tail).enumerate() {{
        *sum = *own + *own;
        for (a, b) in tail.iter().take(d).zip(tail.iter().take(d).rev()) {{
            {of_square};
        }}
    }}
    let mut round: &mut [_] = &mut rows;
    while !round.is_empty() {{
        let mut power: &[_] = tail;
        let mut part = &mut *round;
        while let Some((sum, later)) = part.split_first_mut() {{
            for (coefficient, row) in power.iter().zip(later.iter()) {{
                {of_row};
            }}
            power = &square;
            part = later;
        }}
        round = round.get_mut(2..).unwrap_or_default();
    }}
    rows
}}"
        ));
    }

    /// The function that solves so many equations.
    pub(super) fn elimination_function(&mut self, m: usize) {
        let real = self.type_of(Shape::Real);
        self.out.line(format!(
            "
/// Solves a x = b, with a row by row, by elimination with the largest pivot of each column. No numbers where a
/// is singular.
fn eliminate(mut a: [{real}; {}], mut b: [{real}; {m}]) -> [{real}; {m}] {{
    let size = |v: {real}| if v < 0.0 {{ -v }} else {{ v }};
    for k in 0..{m} {{
        let mut most = k;
        for i in k + 1..{m} {{
            if size(a[{m} * most + k]) < size(a[{m} * i + k]) {{
                most = i;
            }}
        }}
        b.swap(k, most);
        for j in k..{m} {{
            a.swap({m} * k + j, {m} * most + j);
        }}
        if a[{m} * k + k] == 0.0 {{
            a[{m} * k + k] = {real}::NAN;
        }}
        for i in k + 1..{m} {{
            let factor = a[{m} * i + k] / a[{m} * k + k];
            for j in k + 1..{m} {{
                a[{m} * i + j] -= factor * a[{m} * k + j];
            }}
            b[i] -= factor * b[k];
        }}
    }}
    for k in (0..{m}).rev() {{
        for j in k + 1..{m} {{
            b[k] -= a[{m} * k + j] * b[j];
        }}
        b[k] /= a[{m} * k + k];
    }}
    b
}}",
            m * m
        ));
    }
}
