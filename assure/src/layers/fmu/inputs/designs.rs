//! Controllers of several inputs and of axes.

use ptc_codegen::request::Spec;

use crate::harness::specs::spec;

/// Axes with gains, limits and g of their own, with what they follow, and with all left open; plants of outputs of
/// different orders, mechanical, and solved by elimination; each clock.
pub(super) fn designs() -> Vec<Spec> {
    let own = [
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("axes", "3"),
        ("poles", "[[-3,-4],[-5,-6],[-7,-8]]"),
        ("limits", "20,30,0.5"),
        ("g", "[2, b, 1]"),
    ];
    let mixed = [
        ("mu", "exp(a=1)"),
        ("poles", "[[-3,-4],[-5]]"),
        ("states", "p, v, h"),
        ("inputs", "a, b"),
        ("outputs", "p, h"),
        ("dynamics", "v, -v + (2 + sin(p))*a + h*b, v*h + h*a + (2 + h^2)*b"),
    ];
    let four = [
        ("mu", "rational"),
        ("states", "p, q, r, s"),
        ("inputs", "a, b, c, d"),
        ("outputs", "p, q, r, s"),
        ("dynamics", "q*b + 3*c, 2*a + m*d + p*r, r*a + (3 + q^2)*b, a - p*c + 4*d"),
    ];
    let arm = [
        ("mu", "exp"),
        ("states", "q1, q2, w1, w2"),
        ("inputs", "F1, F2"),
        ("inertia", "[[m + q2^2, q2], [q2, 1]]"),
        ("bias", "[m*q2*w1*w2, w1^2/2 - q1]"),
    ];
    let linear = [
        ("mu", "exp(a=1)"),
        ("poles", "[[-3,-4],[-4]]"),
        ("tau", "0.9"),
        ("states", "s, v, i"),
        ("inputs", "F, V"),
        ("outputs", "s, i"),
        ("dynamics", "v, 3*i - 2*s - v/2 + F, V - 4*i + s/8"),
    ];
    let time = |keys: &[(&str, &str)], more: &[(&str, &str)]| {
        spec(&[keys, more, &[("allow", "zeros")]].concat())
    };
    let clock = [("clock", "samples"), ("sample_time", "0.01")];
    let sampled =
        |keys: &[(&str, &str)], more: &[(&str, &str)]| spec(&[keys, &clock, more].concat());
    vec![
        time(&own, &[("name", "own")]),
        time(&own, &[("name", "follows"), ("reference", "input"), ("precision", "f32")]),
        time(&[("n", "3"), ("mu", "rational"), ("axes", "2")], &[("name", "shared")]),
        time(&mixed, &[("name", "mixed"), ("reference", "input")]),
        time(&four, &[("name", "solved")]),
        time(&arm, &[("name", "two_links"), ("u_min", "runtime"), ("u_max", "5")]),
        sampled(&own, &[("name", "own_sampled"), ("params.b", "2"), ("tau", "0.9")]),
        sampled(&arm, &[("name", "links_sampled"), ("precision", "f32")]),
        sampled(&linear, &[("name", "linear_sampled"), ("reference", "input")]),
    ]
}
