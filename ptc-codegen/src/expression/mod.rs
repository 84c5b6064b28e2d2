//! Mathematical expressions in which users give mappings, laws and input gains.
//!
//! `resolve` makes one of a parsed value: names become variables, functions and parameters. What
//! is known by then is folded, exactly.

mod arithmetic;
mod compact;
pub(crate) mod constant;
pub(crate) mod crossing;
pub(crate) mod decaying;
mod derivative;
pub(crate) mod effort;
pub(crate) mod enclosure;
pub(crate) mod evaluator;
pub(crate) mod existence;
mod field;
pub(crate) mod function;
pub(crate) mod generator;
pub(crate) mod grouped;
pub(crate) mod leading;
mod names;
mod node;
pub(crate) mod normal;
pub(crate) mod period;
mod points;
mod print;
mod pythagoras;
mod quantity;
mod ratio;
mod resolve;
pub(crate) mod sign;
mod solve;
#[cfg(test)]
pub(crate) mod testing;
pub(crate) mod vanishing;
mod walk;

pub(crate) use arithmetic::power_bits;
pub use function::Function;
pub use names::Subject;
pub(crate) use names::is_known;
pub(crate) use node::Found;
pub use node::{Expression, Node};
pub(crate) use quantity::Quantity;
pub use resolve::{INTEGRAL, Scope, family_form, resolve};
pub use solve::solve;
pub(crate) use solve::unravel;

/// Variables that change while the controller runs, as opposed to its parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// Stretched time since the start, kappa(Dt): the `t` of a mapping mu(t).
    SinceStart,
    /// Stretched time kappa(Dt) + t0: `t_kappa`, and the `t` of a law pi0(xi, t).
    StretchedTime,
    /// Time t.
    Time,
    /// Elapsed time Dt = t - t0: `dt`.
    Elapsed,
    /// Time-to-go T = tau - Dt.
    TimeToGo,
    /// kappa'(Dt), the derivative of kappa: `kappa_rate`.
    KappaRate,
    /// r_k, derivative k of mu at the stretched time, from 1: `r_1` is 1/`kappa_rate`.
    R(usize),
    /// Control u.
    Control,
    /// State `x_j` of the plant, from 1.
    State(usize),
    /// State `xi_j` of the infinite-time system, from 1.
    Xi(usize),
    /// `x_j` latched at t0.
    StateAtStart(usize),
    /// `xi_j` latched at t0.
    XiAtStart(usize),
}
