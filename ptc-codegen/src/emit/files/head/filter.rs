//! The head's lines about a filter.

use crate::parameter::Fixed;
use crate::request::{Keep, Spec};
use crate::syntax::constant;

/// Describes the bounds and the limits of u that keep them.
pub(super) fn purpose(spec: &Spec, keep: &Keep) -> Vec<String> {
    let n = spec.n;
    let poles: Vec<_> = keep.poles.iter().map(constant::text).collect();
    vec![
        format!(
            "Goal: {}, at and between all samples, under any controller, from every state from which that is possible and as long as nothing else acts on the plant.",
            bounds(keep, n)
        ),
        format!(
            "Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta + a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles {} 1/s. In this cone all states are safe: x_i stays within its bound b as long as all q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is the limit of u.",
            poles.join(", ")
        ),
        format!(
            "From any other state u is held to the law {} of the chain of each x_i less its bound too, so that x_i is within it at the latest N samples after the last safe one, as long as neither the limits of u nor those by other bounds are in the way.",
            keep.law
        ),
    ]
}

/// The bounds of the states in a list.
fn bounds(keep: &Keep, n: usize) -> String {
    let number = |all: &[Fixed], i: usize| all.get(i).filter(|own| own.number().is_some()).cloned();
    let one = |i: usize| match (number(&keep.above, i), number(&keep.below, i)) {
        (Some(above), Some(below)) => Some(format!("{above} <= x{} <= {below}", i + 1)),
        (Some(above), None) => Some(format!("x{} >= {above}", i + 1)),
        (None, Some(below)) => Some(format!("x{} <= {below}", i + 1)),
        (None, None) => None,
    };
    (0..n).filter_map(one).collect::<Vec<_>>().join(", ")
}

/// Describes the statuses.
pub(super) fn behaviour() -> [String; 3] {
    [
        "k counts samples and may wrap; call step at least once within 2^32 - N samples.".to_owned(),
        "u is u_nominal where no bound is near (status OK), and else the nearest that they allow (SATURATED).".to_owned(),
        "INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before those of x2 and so on, the limits of u before all.".to_owned(),
    ]
}
