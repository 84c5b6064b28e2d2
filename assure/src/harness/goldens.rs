//! The controllers whose sources are kept in generated/: the families, and what they do not show.

use ptc_codegen::request::Spec;

use super::specs::{families, spec};

/// A few of them: an explicit family, an iterated one, one in single precision, one that latches its state, and one that
/// calls functions of the user's.
pub const FEW: [&str; 5] =
    ["ptc_exp3", "ptc_exp_sum2", "ptc_exp3_f32", "ptc_own_law1_latched", "ptc_tanh3_extern"];

/// Every one of them.
pub fn controllers() -> Vec<Spec> {
    let mut all: Vec<_> =
        families().flat_map(|family| (1..=5).map(move |n| Spec::new(n, family))).collect();
    all.extend([
        spec(&[("n", "3"), ("mu", "exp"), ("name", "ptc_exp3_f32"), ("precision", "f32")]),
        spec(&[("n", "3"), ("mu", "exp"), ("name", "ptc_exp3_result"), ("guard", "result")]),
        spec(&[("n", "3"), ("mu", "exp"), ("name", "ptc_exp3_trusting"), ("guard", "none")]),
        spec(&[("n", "2"), ("mu", "exp_sum(3)"), ("name", "ptc_exp_sum2_of_three")]),
        spec(&[("n", "9"), ("mu", "exp_sum"), ("name", "ptc_exp_sum9_in_loops")]),
        spec(&[
            ("n", "3"),
            ("mu", "exp(a=1)"),
            ("name", "ptc_exp3_fixed"),
            ("gains", "120,74,15"),
            ("tau", "2"),
            ("t0", "0"),
            ("eps", "1e-3"),
            ("u_max", "50"),
        ]),
        spec(&[
            ("n", "2"),
            ("mu", "power(a=0.5,m=2)"),
            ("name", "ptc_power2_unbounded"),
            ("gains", "1,2"),
            ("u_max", "inf"),
        ]),
        spec(&[("n", "2"), ("mu", "power(m=3/2)"), ("name", "ptc_power2_by_root")]),
    ]);
    all.extend(features());
    all
}

/// Controllers of several axes, the calls of which are others; of order 12, where u is a sum of four sums, too.
pub fn of_axes() -> [Spec; 3] {
    [
        spec(&[("n", "2"), ("axes", "3"), ("mu", "exp"), ("name", "ptc_exp2_axes3")]),
        spec(&[("n", "12"), ("axes", "2"), ("mu", "exp"), ("name", "ptc_exp12_axes2")]),
        spec(&[
            ("n", "3"),
            ("axes", "3"),
            ("mu", "exp(a=1)"),
            ("poles", "[[-4,-5,-6],[-4,-5,-6],[-6,-7,-8]]"),
            ("limits", "40,40,15"),
            ("g", "[1/m, 1/m, 2]"),
            ("name", "ptc_exp3_axes3_own"),
        ]),
    ]
}

/// Plants with two inputs: of outputs of different orders, and of which nothing is left to run time.
pub fn of_two_inputs() -> [Spec; 2] {
    let plant = [
        ("mu", "exp(a=1)"),
        ("poles", "[[-4,-5],[-3]]"),
        ("states", "p, v, h"),
        ("inputs", "a, b"),
        ("outputs", "p, h"),
        ("dynamics", "v, -v + (2 + sin(p))*a + h*b, v*h + h*a + (2 + h^2)*b"),
    ];
    let fixed = [("tau", "1"), ("eps", "1e-2"), ("limits", "40, 15"), ("guard", "result")];
    [
        spec(&[&plant[..], &[("name", "mix")]].concat()),
        spec(&[&plant[..], &fixed, &[("name", "mix_fixed")]].concat()),
    ]
}

/// A plant with more inputs than have a closed form, which its step solves for.
pub fn of_inputs() -> Spec {
    spec(&[
        ("mu", "rational"),
        ("name", "ptc_rational_inputs4"),
        ("states", "p, q, r, s"),
        ("inputs", "a, b, c, d"),
        ("outputs", "p, q, r, s"),
        (
            "dynamics",
            "sin(q)*b + 3*c + r*d, 2*a + p*b + m*d + p*r, r*a + (3 + q^2)*b + s*c, a - p*c + 4*d",
        ),
        ("allow", "zeros"),
    ])
}

/// User-defined mappings, laws, ends and divisors, latched states, and a duration that changes in flight.
fn features() -> [Spec; 7] {
    [
        spec(&[
            ("n", "2"),
            ("kappa", "tau*dt/(tau - dt) + dt"),
            ("after", "zero"),
            ("name", "ptc_own_kappa2"),
        ]),
        spec(&[
            ("n", "2"),
            ("mu", "mean(rational(a=1), tanh(a=a))"),
            ("name", "ptc_own_mu2_iterated"),
        ]),
        spec(&[
            ("n", "1"),
            ("mu", "tau*(1 - (2/(1 + t + sqrt(1 + t^2)))^(1/10))"),
            ("name", "ptc_own_mu1_bisected"),
        ]),
        spec(&[
            ("n", "1"),
            ("mu", "exp(a=1)"),
            ("pi0", "-2*xi1 - xi1*xi1_0"),
            ("name", "ptc_own_law1_latched"),
        ]),
        spec(&[
            ("n", "2"),
            ("mu", "rational"),
            ("g", "2 + x1*x1"),
            ("name", "ptc_rational2_input_gain"),
        ]),
        spec(&[
            ("n", "3"),
            ("mu", "tanh"),
            ("pi0", "extern"),
            ("after", "extern"),
            ("name", "ptc_tanh3_extern"),
        ]),
        spec(&[("n", "2"), ("mu", "tan"), ("in_flight", "true"), ("name", "ptc_tan2_in_flight")]),
    ]
}
