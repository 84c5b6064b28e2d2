//! The reference of a controller in samples in the head of an emitted file.

use super::{coupled, formulas};
use crate::linear::Following;
use crate::request::{Reference, Sampled, Spec};

/// When t of a known reference is, and what its rho is.
const MIDDLE: &str = "t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in which u acts:";

/// Describes the tracking error, and how the reference enters the law; empty without a reference.
pub(super) fn lines(spec: &Spec, sampled: &Sampled) -> Vec<String> {
    if spec.axes.is_some() {
        return of_several(spec);
    }
    if let Some(follows) = &sampled.follows {
        return of_plant(spec, sampled, follows);
    }
    let n = spec.n;
    let (what, given) = match &spec.reference {
        None => return Vec::new(),
        Some(Reference::Known(_)) => (MIDDLE.to_owned(), formulas::of_reference(spec)),
        Some(Reference::Input) => (
            format!(
                "e_i = x_i - r[i-1] with r[0]..r[{}] the reference and its derivatives at tick k, and rho = r[{n}], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.",
                n - 1
            ),
            Vec::new(),
        ),
    };
    let under_way = under_way(sampled);
    let over = if spec.model.is_some() { "u = (w + rho - f)/g" } else { "u = w + rho/g" };
    let left = if n == 1 { 3 } else { n + 2 };
    let order = if n == 1 { format!("h^{left}") } else { format!("h^({left}-i)") };
    let head = format!(
        "With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and {over}{under_way}. At sample N e is 0 where r^(n) is constant over each sample; else an error of order {order} is left in e_i."
    );
    [head, what].into_iter().chain(given).collect()
}

fn under_way(sampled: &Sampled) -> String {
    let [_, letter] = sampled.followed_letters();
    match sampled.delay.inputs() {
        0 => String::new(),
        _ => format!(", where the inputs under way count less the {letter} of their own samples"),
    }
}

/// The same of a linear plant.
fn of_plant(spec: &Spec, sampled: &Sampled, follows: &Following) -> Vec<String> {
    let n = spec.n;
    let (r, what, given) = match &spec.reference {
        None => return Vec::new(),
        Some(Reference::Known(all)) => (
            format!("= {}", all[0]),
            "t counts from the tick at which it was armed, and u_r is that in the middle of the time in which u acts. To four digits:".to_owned(),
            (1..=n).filter_map(|i| Some(format!("  r^({i}) = {}", spec.derivative(i)?))).collect(),
        ),
        Some(Reference::Input) => (
            format!("with its derivatives r[0]..r[{}] at tick k", n - 1),
            format!(
                "r[{n}] is r^({n}) over the sample in which u acts: its mean, (r^({last})(t + h) - r^({last})(t))/h, or that in its middle. u_r is the mean over that sample. To four digits, the last at one time:",
                last = n - 1
            ),
            Vec::new(),
        ),
    };
    let order = if n == 1 { "h^3".to_owned() } else { format!("h^({}-i)", n + 2) };
    let states: Vec<_> = (1..=n).map(|j| format!("x{j}")).collect();
    let head = format!(
        "With the reference r {r}, x - x_r is in place of x above, and u = w + u_r{}: with them the output y = {} is r, and stays so. At sample N x = x_r where u_r is constant over each sample; else an error of order {order} is left in y^(i-1).",
        under_way(sampled),
        coupled::sum(follows.output(), &states)
    );
    let rates: Vec<_> =
        ["r".to_owned()].into_iter().chain((1..=n).map(|i| format!("r^({i})"))).collect();
    let of = |i: usize| if i == n { "u_r".to_owned() } else { format!("x_r{}", i + 1) };
    let rows = follows.rows().iter().enumerate();
    let rows = rows.map(|(i, row)| format!("  {} = {}", of(i), coupled::sum(row, &rates)));
    [head, what].into_iter().chain(given).chain(rows).collect()
}

/// The same of several outputs, or axes.
fn of_several(spec: &Spec) -> Vec<String> {
    let (each, enters) = match spec.decoupled() {
        Some(_) => ("output", "law_i = v_i + rho of output i is in place of v_i"),
        None => ("axis", "u = w + rho/g of each axis"),
    };
    let (what, given) = match &spec.reference {
        None => return Vec::new(),
        Some(Reference::Known(_)) => (MIDDLE.to_owned(), coupled::known_references(spec, each)),
        Some(Reference::Input) => (
            format!(
                "Row i of r is of {each} i, of order n: in its places 0..n-1 the reference and its derivatives at tick k, and in place n rho, r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle."
            ),
            Vec::new(),
        ),
    };
    let head = format!(
        "With a reference r of each {each}, e_i = x_i - r^(i-1) is in place of x_i above, and {enters}. What r^(n) changes over a sample leaves an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there."
    );
    [head, what].into_iter().chain(given).collect()
}
