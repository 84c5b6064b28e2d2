//! Controllers of several axes, and of plants with several inputs.

use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::Spec;

use super::support::specs::spec;

/// Shared and own gains, limits and input gains, references, both precisions, guards that trust, and an order
/// at which u is a sum of four sums.
pub(super) fn specs() -> Vec<Spec> {
    let own: [(&str, &str); 8] = [
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("tau", "1"),
        ("t0", "0"),
        ("eps", "1e-2"),
        ("poles", "[[-3,-4],[-5,-6],[-7,-8]]"),
        ("limits", "20,30,0.5"),
        ("g", "[2, b, 1]"),
    ];
    let with = |keys: &[(&str, &str)], further: &[(&str, &str)]| spec(&[keys, further].concat());
    let poles = [10, 11].map(|first| {
        let own: Vec<_> = (first..first + 9).map(|pole| format!("-{pole}.5")).collect();
        format!("[{}]", own.join(","))
    });
    let poles = format!("[{}]", poles.join(","));
    vec![
        with(&[("n", "3"), ("mu", "exp")], &[("axes", "3"), ("name", "shared")]),
        with(
            &[("n", "2"), ("mu", "rational")],
            &[("axes", "1"), ("name", "alone"), ("limits", "5")],
        ),
        with(&own, &[("axes", "3"), ("name", "own")]),
        with(
            &[("n", "2"), ("mu", "rational")],
            &[("axes", "3"), ("name", "apart"), ("limits", "[[-1,5],[0,3],2]")],
        ),
        with(
            &[("n", "2"), ("mu", "exp(a=1)")],
            &[("axes", "2"), ("name", "apart_shared"), ("u_min", "runtime"), ("guard", "none")],
        ),
        with(&own, &[("axes", "3"), ("name", "follows"), ("reference", "input")]),
        with(&own, &[("axes", "3"), ("name", "little"), ("precision", "f32")]),
        with(&own, &[("axes", "3"), ("name", "trusting"), ("guard", "none")]),
        with(&own, &[("axes", "3"), ("name", "half_trusting"), ("guard", "result")]),
        with(
            &[("n", "2"), ("mu", "tanh(a=0.5)"), ("gains", "[[20,9],[42,13]]")],
            &[("axes", "2"), ("name", "two"), ("u_max", "inf"), ("g", "1/mass")],
        ),
        with(&[("n", "12"), ("mu", "exp(a=4)")], &[("axes", "3"), ("name", "high")]),
        // The sums of gains in a subroutine, which is applied for each axis.
        with(
            &[("n", "9"), ("mu", "exp_sum(rates=[0.75,0.875])"), ("poles", &poles)],
            &[("axes", "2"), ("name", "sums"), ("limits", "20,30")],
        ),
        with(
            &[("n", "12"), ("mu", "exp(a=4)"), ("reference", "input"), ("precision", "f32")],
            &[("axes", "3"), ("name", "high_own"), ("g", "[2, b, 1]"), ("limits", "20,30,0.5")],
        ),
        quadrotor(),
    ]
}

/// The design of the guide: four axes with references, and g, gains and limits of their own.
fn quadrotor() -> Spec {
    let text = include_str!("../../../../examples/quadrotor.toml");
    let (entries, found) = ptc_codegen::design::read(text, &mut |_| Place(0));
    assert_eq!(found, []);
    ptc_codegen::request::read(&entries).expect("a design")
}

/// Outputs of different orders, of three at once, and of a mechanical plant, with the same ways to ask. The
/// matrix of the first is singular at 0.
pub(super) fn coupled() -> Vec<Spec> {
    let mixed: [(&str, &str); 9] = [
        ("mu", "exp(a=1)"),
        ("tau", "1"),
        ("t0", "0"),
        ("eps", "1e-2"),
        ("poles", "[[-3,-4],[-5]]"),
        ("states", "p, v, h"),
        ("inputs", "a, b"),
        ("outputs", "p, h"),
        ("dynamics", "v, -v + p*a + h*b, v*h + h*a + (2 + h^2)*b"),
    ];
    let with = |keys: &[(&str, &str)], further: &[(&str, &str)]| {
        spec(&[keys, &[("allow", "zeros")], further].concat())
    };
    // Solved by elimination, with zeros where the first pivots would be.
    let four = [
        ("mu", "rational"),
        ("states", "p, q, r, s"),
        ("inputs", "a, b, c, d"),
        ("outputs", "p, q, r, s"),
        (
            "dynamics",
            "sin(q)*b + 3*c + r*d, 2*a + p*b + m*d + p*r, r*a + (3 + q^2)*b + s*c, a - p*c + 4*d",
        ),
    ];
    let unruled: Vec<_> = mixed.into_iter().filter(|(key, _)| *key != "poles").collect();
    vec![
        with(&mixed, &[("name", "mixed")]),
        with(&mixed, &[("name", "mixed_small"), ("precision", "f32"), ("limits", "20,0.5")]),
        with(&mixed, &[("name", "mixed_trusting"), ("guard", "none"), ("u_max", "inf")]),
        with(&mixed, &[("name", "mixed_half"), ("guard", "result")]),
        with(&mixed, &[("name", "mixed_apart"), ("limits", "[[0,20],[-0.5,30]]")]),
        with(&mixed, &[("name", "mixed_open"), ("u_min", "runtime")]),
        spec(&[
            ("mu", "rational"),
            ("name", "three"),
            ("states", "p, q, r"),
            ("inputs", "a, b, c"),
            ("outputs", "p, q, r"),
            ("dynamics", "m*a + p*b + q*c + q^2, r*a + 4*b + p*c - p*r, q*a + r*b + 5*c"),
        ]),
        with(&four, &[("name", "four")]),
        with(
            &four,
            &[
                ("name", "four_small"),
                ("precision", "f32"),
                ("limits", "9,8,7,6"),
                ("guard", "none"),
            ],
        ),
        spec(&[
            ("mu", "tanh(a=0.5)"),
            ("name", "two_links"),
            ("poles", "[[-3,-4],[-5,-6]]"),
            ("states", "p, q, v, w"),
            ("inputs", "a, b"),
            ("inertia", "[[2 + q^2, q], [q, m]]"),
            ("bias", "v*w*q, -v^2 + 9.81*p"),
        ]),
        // Laws of all outputs, one with time and a wall, of outputs of different orders and of an arm.
        with(
            &unruled,
            &[
                ("name", "mixed_laws"),
                (
                    "pi0",
                    "-12*xi1_1 - 7*xi2_1 + xi1_2*sin(t) - h*T, -5*xi1_2*(1 + kappa_rate*xi1_1^2)",
                ),
            ],
        ),
        // Outputs that follow: what each call is given, with rows of different lengths, and expressions.
        with(&mixed, &[("name", "mixed_follows"), ("reference", "input")]),
        with(
            &mixed,
            &[("name", "mixed_follows_half"), ("reference", "input"), ("guard", "result")],
        ),
        with(&mixed, &[("name", "mixed_targets"), ("reference", "amp*sin(2*t), exp(-dt)")]),
        with(
            &unruled,
            &[
                ("name", "mixed_follows_laws"),
                ("reference", "input"),
                ("pi0", "-12*xi1_1 - 7*xi2_1 + sin(xi1_2), -5*xi1_2*(1 + x1_1^2)"),
            ],
        ),
        spec(&[
            ("mu", "tanh(a=0.5)"),
            ("name", "arm_follows"),
            ("poles", "[[-3,-4],[-5,-6]]"),
            ("reference", "input"),
            ("precision", "f32"),
            ("states", "p, q, v, w"),
            ("inputs", "a, b"),
            ("inertia", "[[2 + q^2, q], [q, m]]"),
            ("bias", "v*w*q, -v^2 + 9.81*p"),
        ]),
        // A law of all outputs that each call is given.
        with(&unruled, &[("name", "mixed_extern"), ("pi0", "extern"), ("reference", "input")]),
        with(
            &unruled,
            &[
                ("name", "mixed_extern_small"),
                ("pi0", "extern"),
                ("precision", "f32"),
                ("limits", "20,3"),
            ],
        ),
        // Of several axes, which are chains.
        spec(&[
            ("n", "2"),
            ("axes", "2"),
            ("mu", "exp(a=1)"),
            ("eps", "1e-2"),
            ("name", "axes_law"),
            ("pi0", "extern"),
            ("limits", "20,3"),
            ("g", "[2, b]"),
        ]),
        spec(&[
            ("n", "2"),
            ("axes", "2"),
            ("mu", "exp(a=1)"),
            ("tau", "1"),
            ("t0", "0"),
            ("name", "axes_law_follows"),
            ("pi0", "extern"),
            ("reference", "input"),
            ("precision", "f32"),
            ("guard", "result"),
        ]),
        spec(&[
            ("mu", "rational(a=2)"),
            ("name", "guarded"),
            (
                "pi0",
                "inverse_inertia_1_1*(-k*xi1_1/(1 - xi1_1^2/9) - xi2_1), inverse_inertia_2_2*bias_2 - x1_2 - 4*x2_2",
            ),
            ("states", "p, q, v, w"),
            ("inputs", "a, b"),
            ("inertia", "[[2 + q^2, q], [q, m]]"),
            ("bias", "v*w*q, -v^2 + 9.81*p"),
        ]),
    ]
}
