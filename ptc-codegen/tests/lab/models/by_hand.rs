//! u of the emitted C against formulas that were derived by hand: those of the plant, and the law of
//! the chain for the mapping exp with a = 1, under which the pole -m leaves x1 = T^m.

use ptc_codegen::request::Spec;

use super::{LEVITATION, example, fixed, in_c, spec};

/// Poles -3 and -4: T^2 x1'' = -12 x1 - 6 T x1'.
fn second([x1, x2]: [f64; 2], to_go: f64) -> f64 {
    -12.0 * x1 / to_go.powi(2) - 6.0 * x2 / to_go
}

/// Poles -4, -5 and -6: T^3 x1''' = -120 x1 - 60 T x1' - 12 T^2 x1''.
fn third([x1, x2, x3]: [f64; 3], to_go: f64) -> f64 {
    -120.0 * x1 / to_go.powi(3) - 60.0 * x2 / to_go.powi(2) - 12.0 * x3 / to_go
}

/// u at each of these times and states, with static parameters `params`.
fn inputs<const N: usize>(
    test: &str,
    spec: &Spec,
    params: &str,
    calls: &[(f64, [f64; N])],
) -> Vec<f64> {
    let rows: Vec<_> = calls
        .iter()
        .map(|(t, x)| {
            let x: Vec<_> = x.iter().map(|x| format!("{x:e}")).collect();
            format!("{{ {t:e}, {} }}", x.join(", "))
        })
        .collect();
    let name = spec.name();
    let main = format!(
        "{params}\n\
         static const double calls[][{}] = {{ {} }};\n\
         int main(void)\n{{\n    {name} control;\n\
         \x20   if ({name}_init(&control, &params) != PTC_OK) {{ return 1; }}\n\
         \x20   for (unsigned i = 0; i < sizeof calls / sizeof calls[0]; i++) {{\n\
         \x20       double u;\n\
         \x20       if ({name}_step(&control, calls[i][0], calls[i] + 1, &u) < 0) {{ return 2; }}\n\
         \x20       printf(\"%.17g\\n\", u);\n    }}\n    return 0;\n}}\n",
        N + 1,
        rows.join(", ")
    );
    in_c::run(test, spec, &main).into_iter().map(|line| line[0]).collect()
}

/// Compares u at drawn states, within `reach` of 0, and times before `until`.
fn compare<const N: usize>(
    test: &str,
    (spec, params): (&Spec, &str),
    (reach, until): ([f64; N], f64),
    by_hand: impl Fn([f64; N], f64) -> f64,
) {
    let mut state = 12345u64;
    let mut draw = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let mut call = || {
        let x = reach.map(|reach| reach * draw());
        (until * 0.5 * (draw() + 1.0), x)
    };
    let calls: Vec<_> = (0..200).map(|_| call()).collect();
    let found = inputs(test, spec, params, &calls);
    assert_eq!(found.len(), calls.len());
    for ((t, x), u) in calls.iter().zip(found) {
        let wanted = by_hand(*x, *t);
        let off = (u - wanted).abs();
        assert!(off <= 1e-11 * wanted.abs().max(1e-3), "{test} at {t}, {x:?}: {u}, not {wanted}");
    }
}

#[test]
fn a_motor_with_its_electrical_pole() {
    let text = example("drive.toml").replace("u_max = 24 ", "u_max = inf ");
    let (k, j, b, r, l) = (0.03, 2e-5, 1e-5, 1.2, 2e-3);
    let by_hand = |[q, w, i]: [f64; 3], t: f64| {
        let rate = (k * i - b * w) / j;
        // w'' = (k i' - b w')/J, and i' = (V - R i - k w)/L.
        let drift = (k * (-r * i - k * w) / l - b * rate) / j;
        (third([q, w, rate], 0.4 - t) - drift) / (k / (j * l))
    };
    let text = text.replace("tau = 0.4 ", "eps = 1e-3\ntau = 0.4 ");
    let spec = spec(&text);
    compare("drive", (&spec, &fixed("drive", "")), ([3.0, 40.0, 8.0], 0.39), by_hand);
}

#[test]
fn a_cart_with_a_pendulum() {
    let text = example("cart.toml").replace("tau = 2 ", "eps = 1e-3\nu_max = inf\ntau = 2 ");
    let (cart, m, l, drag, g) = (1.0, 0.2, 0.5, 0.1, 9.81);
    // From (M + m) s'' + m l (a'' cos a - a'^2 sin a) = F - drag v and l a'' + s'' cos a = g sin a.
    let by_hand = |[s, v, a, w]: [f64; 4], t: f64| {
        let wanted = second([s, v], 2.0 - t);
        let turn = (g * a.sin() - wanted * a.cos()) / l;
        (cart + m) * wanted + m * l * (turn * a.cos() - w * w * a.sin()) + drag * v
    };
    let spec = spec(&format!("allow = \"zeros\"\n{text}"));
    compare("cart", (&spec, &fixed("cart", "")), ([1.0, 2.0, 1.0, 3.0], 1.9), by_hand);
}

#[test]
fn a_magnet_with_parameters_at_run_time() {
    let (l, r, i0, z0, g) = (0.02, 1.5, 0.8, 0.01, 9.81);
    let by_hand = |[z, v, i]: [f64; 3], t: f64| {
        let (c, d) = (1.0 + i / i0, 1.0 + z / z0);
        let x3 = g * (1.0 - (c / d).powi(2));
        // x3' = -2 g c/d (c'/d - c d'/d^2), c' = i'/i0, d' = v/z0, i' = (u - R i)/L.
        let of_rest = -2.0 * g * c / d * (-r * i / (l * i0) / d - c * v / z0 / (d * d));
        let of_input = -2.0 * g * c / d / (d * l * i0);
        (third([z, v, x3], 0.5 - t) - of_rest) / of_input
    };
    let spec = spec(&example("levitation.toml"));
    compare("levitation", (&spec, LEVITATION), ([2e-3, 0.5, 0.1], 0.45), by_hand);
}

#[test]
fn self_tests_agree_with_the_definition() {
    for name in ["drive.toml", "cart.toml", "levitation.toml"] {
        let text = format!("allow = \"zeros\"\n{}", example(name));
        assert_eq!(in_c::selftest(name, &spec(&text)), 0.0, "{name}");
    }
}

#[test]
fn a_known_f_is_cancelled() {
    let text = "name = \"swing\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n\
        f = \"-w^2*sin(x1) - drag*x2 + 0.1*t\"\ng = \"2 + cos(x1)\"\n\
        [params]\ntau = 2\neps = 1e-3\nu_max = inf\nw = 3\n";
    let by_hand = |[x1, x2]: [f64; 2], t: f64| {
        let f = -9.0 * x1.sin() - 0.25 * x2 + 0.1 * t;
        (second([x1, x2], 2.0 - t) - f) / (2.0 + x1.cos())
    };
    let spec = spec(text);
    compare("swing", (&spec, &fixed("swing", ", .drag = 0.25")), ([2.0, 3.0], 1.9), by_hand);
}
