//! balance: evaluates polynomials by Estrin's scheme, whose chains of operations are short.

use std::collections::HashMap;

use super::{append, rebuild, uses};
use crate::parameter::Precision;
use crate::program::{Definition, Op, Program, Stage, Value};

/// A polynomial that Horner's rule evaluates: sum of `coefficients[k] variable^k`; none is 0.
struct Polynomial {
    variable: Value,
    coefficients: Vec<Option<Term>>,
}

/// A value, or its negative.
#[derive(Clone, Copy)]
struct Term {
    value: Value,
    negative: bool,
}

/// Lowest degree at which a tree is shorter than Horner's chain by more than the square it needs.
const DEGREE: usize = 3;

/// Writes each polynomial of a tick or a step that Horner's rule evaluates, c_0 + z (c_1 + z (c_2 + ...)), with sums or
/// differences, as a tree, if the program sets `latency`: the pairs c_k + z c_(k+1) do not wait for each other, and
/// neither do pairs of these with z^2, and so on. That takes one multiplication more for each square, and some log2 of
/// the degree in place of the degree operations in a row.
///
/// A power of a large z may leave the range before the sum does, where small coefficients meet z one by one
/// in Horner's rule. So powers end at z^4 in doubles and at z^2 in floats, which hold for z < 1e77 and
/// z < 1e19, and Horner's rule goes on in the last. Where every coefficient is a number, z is the bounded
/// variable of an approximation, and powers go on to the end.
pub(super) fn run(program: Program) -> Program {
    if !program.latency {
        return program;
    }
    let polynomials = polynomials(&program);
    let mut map: Vec<Value> = Vec::with_capacity(program.values.len());
    let mut index = 0;
    rebuild(&program, &mut |new, definition| {
        let polynomial = polynomials.get(&index);
        index += 1;
        let Definition { op, name, .. } = definition;
        let value = match polynomial.and_then(|one| tree(new, &program, one, &map)) {
            Some(root) => {
                new.values[root.0].name = name;
                root
            }
            None => append(new, op, name),
        };
        map.push(value);
        value
    })
}

/// The polynomials of the program that are part of no larger one, by the index of their value.
fn polynomials(program: &Program) -> HashMap<usize, Polynomial> {
    let uses = uses(program);
    let mut found = HashMap::new();
    let mut inner = vec![false; program.values.len()];
    for (index, definition) in program.values.iter().enumerate().rev() {
        if definition.stage < Stage::Tick || uses[index] == 0 || inner[index] {
            continue;
        }
        let (polynomial, parts) = longest(program, &uses, Value(index));
        if polynomial.coefficients.len() > DEGREE {
            parts.into_iter().for_each(|part| inner[part.0] = true);
            found.insert(index, polynomial);
        }
    }
    found
}

/// The polynomial of highest degree that ends in `root`, with the values on the way that nothing else
/// uses.
fn longest(program: &Program, uses: &[usize], root: Value) -> (Polynomial, Vec<Value>) {
    let none = || (Polynomial { variable: root, coefficients: Vec::new() }, Vec::new());
    let factors = |value: Value| match program.get(value).op {
        Op::Mul(a, b) => vec![a, b],
        _ => Vec::new(),
    };
    let candidates = match program.get(root).op {
        Op::Mul(a, b) => vec![a, b],
        Op::Add(a, b) | Op::Sub(a, b) => [factors(a), factors(b)].concat(),
        _ => Vec::new(),
    };
    let of = |variable| peeled(program, uses, root, variable);
    let length = |(polynomial, _): &(Polynomial, _)| polynomial.coefficients.len();
    // Of several of one degree the first, so that the choice depends on the program alone.
    candidates.into_iter().map(of).rev().max_by_key(length).unwrap_or_else(none)
}

/// Returns the coefficients of Horner's rule in `variable` that computes `root`, from the lowest up.
fn peeled(
    program: &Program,
    uses: &[usize],
    root: Value,
    variable: Value,
) -> (Polynomial, Vec<Value>) {
    let home = program.get(root);
    // A part that something else uses is computed anyway, and one of an earlier stage is computed before.
    let free = |value: Value| {
        let part = program.get(value);
        uses[value.0] == 1 && part.stage == home.stage && part.looped == home.looped
    };
    let shifted = |value: Value| match program.get(value).op {
        Op::Mul(a, b) if b == variable => Some(a),
        Op::Mul(a, b) if a == variable => Some(b),
        _ => None,
    };
    let (mut coefficients, mut parts) = (Vec::new(), Vec::new());
    let (mut rest, mut negative) = (root, false);
    loop {
        if rest != root {
            if !free(rest) {
                break;
            }
            parts.push(rest);
        }
        if let Some(higher) = shifted(rest) {
            coefficients.push(None);
            rest = higher;
            continue;
        }
        let (a, b, difference) = match program.get(rest).op {
            Op::Add(a, b) => (a, b, false),
            Op::Sub(a, b) => (a, b, true),
            _ => break,
        };
        let product = |value: Value| shifted(value).filter(|_| free(value));
        match (product(a), product(b)) {
            (Some(higher), _) => {
                parts.push(a);
                coefficients.push(Some(Term { value: b, negative: negative ^ difference }));
                rest = higher;
            }
            (None, Some(higher)) => {
                parts.push(b);
                coefficients.push(Some(Term { value: a, negative }));
                (rest, negative) = (higher, negative ^ difference);
            }
            (None, None) => break,
        }
    }
    // The last one is a coefficient, not a part.
    if parts.last() == Some(&rest) {
        parts.pop();
    }
    coefficients.push(Some(Term { value: rest, negative }));
    (Polynomial { variable, coefficients }, parts)
}

/// A polynomial as a tree; none without coefficients.
fn tree(new: &mut Program, old: &Program, polynomial: &Polynomial, map: &[Value]) -> Option<Value> {
    let is_number =
        |c: &Option<Term>| c.is_none_or(|c| matches!(old.get(c.value).op, Op::Number(_)));
    let highest = match old.precision {
        _ if polynomial.coefficients.iter().all(is_number) => usize::MAX,
        Precision::F64 => 4,
        Precision::F32 => 2,
    };
    let mut power = 1;
    let mut variable = map[polynomial.variable.0];
    let mapped = |c: Term| Term { value: map[c.value.0], ..c };
    let mut level: Vec<_> = polynomial.coefficients.iter().map(|c| c.map(mapped)).collect();
    while level.len() > 2 && power < highest {
        level = level.chunks(2).map(|pair| joined(new, variable, pair)).collect();
        variable = append(new, Op::Mul(variable, variable), None);
        power *= 2;
    }
    while level.len() > 2 {
        let last = level.split_off(level.len() - 2);
        let last = joined(new, variable, &last);
        level.push(last);
    }
    let Term { value, negative } = joined(new, variable, &level)?;
    Some(if negative { append(new, Op::Neg(value), None) } else { value })
}

/// c_0 + z c_1; none for 0.
fn joined(new: &mut Program, variable: Value, pair: &[Option<Term>]) -> Option<Term> {
    let (low, high) = (pair[0], pair.get(1).copied().flatten());
    let product = high.map(|Term { value, negative }| Term {
        value: append(new, Op::Mul(value, variable), None),
        negative,
    });
    let (Some(low), Some(product)) = (low, product) else { return low.or(product) };
    let (a, b) = (product.value, low.value);
    let (op, negative) = match (product.negative, low.negative) {
        (false, false) => (Op::Add(a, b), false),
        (false, true) => (Op::Sub(a, b), false),
        (true, false) => (Op::Sub(b, a), false),
        (true, true) => (Op::Add(a, b), true),
    };
    Some(Term { value: append(new, op, None), negative })
}
