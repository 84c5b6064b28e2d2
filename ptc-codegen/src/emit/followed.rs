//! The reference of a controller in samples in the head of an emitted file.

use super::formulas;
use crate::request::{Reference, Sampled, Spec};

/// What becomes of the tracking error, and how the reference enters the law; nothing without one.
pub(super) fn lines(spec: &Spec, sampled: &Sampled) -> Vec<String> {
    let n = spec.n;
    let (what, given) = match &spec.reference {
        None => return Vec::new(),
        Some(Reference::Known(_)) => {
            let middle = "t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in which u acts:";
            (middle.to_owned(), formulas::of_reference(spec))
        }
        Some(Reference::Input) => (
            format!(
                "e_i = x_i - r[i-1] with r[0]..r[{}] the reference and its derivatives at tick k, and rho = r[{n}], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.",
                n - 1
            ),
            Vec::new(),
        ),
    };
    let under_way = match sampled.delay.inputs() {
        0 => "",
        _ => ", where the inputs under way count less the rho of their own samples",
    };
    let over = if spec.model.is_some() { "u = (w + rho - f)/g" } else { "u = w + rho/g" };
    let left = if n == 1 { 3 } else { n + 2 };
    let order = if n == 1 { format!("h^{left}") } else { format!("h^({left}-i)") };
    let head = format!(
        "With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and {over}{under_way}. At sample N e is 0 where r^(n) is constant over each sample; else an error of order {order} is left in e_i."
    );
    [head, what].into_iter().chain(given).collect()
}
