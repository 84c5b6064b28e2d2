//! u of the emitted C against formulas that were derived by hand.

use ptc_codegen::request::Spec;

use super::{Known, example, in_c, spec, wanted};

/// Numbers from -1 to 1, the same on any machine.
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // Three decimals, so that what a design reads is what is computed with here.
        let unit = (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
        (unit * 1000.0).round() / 1000.0
    }

    fn known(&mut self) -> Known {
        let rate = |draw: &mut Self| (draw.next().abs() * 4.0 * 1000.0).round() / 1000.0 + 0.1;
        Known {
            sines: (0..2).map(|_| [self.next(), rate(self), self.next()]).collect(),
            fading: [self.next(), rate(self)],
            polynomial: (0..4).map(|_| self.next()).collect(),
        }
    }
}

/// u at a time, a state and what the call is given of a reference.
fn inputs(test: &str, spec: &Spec, calls: &[(f64, Vec<f64>, Vec<f64>)]) -> Vec<f64> {
    let name = spec.name();
    let given = calls[0].2.len();
    let row = |(t, x, r): &(f64, Vec<f64>, Vec<f64>)| {
        let all = [t].into_iter().chain(x).chain(r).map(|v| format!("{v:e}"));
        format!("{{ {} }}", all.collect::<Vec<_>>().join(", "))
    };
    let rows: Vec<_> = calls.iter().map(row).collect();
    let n = calls[0].1.len();
    let r = if given > 0 { format!(", calls[i] + {}", 1 + n) } else { String::new() };
    let main = format!(
        "static const double calls[][{}] = {{ {} }};\n\
         int main(void)\n{{\n    {name} control;\n    {name}_params params = {{ 0 }};\n\
         \x20   if ({name}_init(&control, &params) != PTC_OK) {{ return 1; }}\n\
         \x20   for (unsigned i = 0; i < sizeof calls / sizeof calls[0]; i++) {{\n\
         \x20       double u;\n\
         \x20       if ({name}_step(&control, calls[i][0], calls[i] + 1{r}, &u) < 0) {{ return 2; }}\n\
         \x20       printf(\"%.17g\\n\", u);\n    }}\n    return 0;\n}}\n",
        1 + n + given,
        rows.join(", ")
    );
    in_c::run(test, spec, &main).into_iter().map(|line| line[0]).collect()
}

/// Orders 1 to 4, with random references, an f and a g that see the plant's own state; the same
/// reference given with each call leads to the same u.
#[test]
fn u_is_that_of_the_formula() {
    let mut draw = Draw(2026);
    for n in 1..=4usize {
        let poles: Vec<_> = (0..n).map(|i| (n + 1 + i) as f64).collect();
        let listed = poles.iter().map(|p| format!("-{p}")).collect::<Vec<_>>().join(", ");
        for index in 0..3 {
            let known = draw.known();
            let text = |reference: &str| {
                format!(
                    "name = \"follow\"\nn = {n}\nmu = \"exp(a=1)\"\npoles = [{listed}]\n\
                     f = \"-sin(x1) + 0.5*t\"\ng = \"2 + cos(x1)\"\nreference = \"{reference}\"\n\
                     [params]\ntau = 2\nt0 = 0\neps = 1e-3\nu_max = inf\n"
                )
            };
            let mut calls: Vec<_> = (0..100)
                .map(|_| {
                    let x = (0..n).map(|_| 2.0 * draw.next()).collect::<Vec<_>>();
                    (1.9 * draw.next().abs(), x, Vec::new())
                })
                .collect();
            let following =
                inputs(&format!("follow{n}{index}"), &spec(&text(&known.text())), &calls);
            for (t, _, r) in &mut calls {
                *r = (0..=n as i32).map(|order| known.derivative(order, *t)).collect();
            }
            let given = inputs(&format!("given{n}{index}"), &spec(&text("input")), &calls);
            for ((t, x, r), found) in calls.iter().zip(following.iter().zip(given)) {
                let error: Vec<_> = x.iter().zip(r).map(|(x, r)| x - r).collect();
                let drift = -x[0].sin() + 0.5 * t;
                let hand = (wanted(&poles, &error, 2.0 - t) + r[n] - drift) / (2.0 + x[0].cos());
                // The terms of u, from which what cancels in their sum is measured.
                let size = wanted(&poles, &error, 2.0 - t).abs()
                    + error.iter().map(|e| e.abs() * (2.0 - t).powi(-(n as i32))).sum::<f64>()
                        * 200.0
                    + r[n].abs();
                for u in [*found.0, found.1] {
                    let off = (u - hand).abs();
                    assert!(off <= 1e-13 * size, "n = {n} at {t}: {u}, not {hand}, of {size}");
                }
            }
        }
    }
}

/// Quotients and nested functions, to order 6, by closed formulas of their derivatives: that of 1/(1 + t^2) is
/// (-1)^k k! sin((k+1) a) sin(a)^(k+1) with the angle a of (t, 1), that of exp(-s^2) is (-1)^k H_k(s) exp(-s^2) with
/// the polynomials of Hermite.
#[test]
fn derivatives_of_quotients_and_bells_are_those_of_formulas() {
    let quotient = |k: i32, t: f64| {
        let angle = 1f64.atan2(t);
        let factorial: f64 = (1..=k).map(f64::from).product();
        (-1f64).powi(k) * factorial * (f64::from(k + 1) * angle).sin() * angle.sin().powi(k + 1)
    };
    let bell = |k: i32, t: f64| {
        let s = t - 1.0;
        let (mut last, mut hermite) = (0.0, 1.0);
        for i in 0..k {
            (last, hermite) = (hermite, 2.0 * s * hermite - 2.0 * f64::from(i) * last);
        }
        (-1f64).powi(k) * hermite * (-s * s).exp()
    };
    type Derivative<'a> = &'a dyn Fn(i32, f64) -> f64;
    let cases: [(&str, &str, Derivative<'_>); 2] =
        [("quotient", "1/(1 + t^2)", &quotient), ("bell", "exp(-(t - 1)^2)", &bell)];
    for (name, reference, derivative) in cases {
        for n in 1..=6usize {
            let poles: Vec<_> = (0..n).map(|i| (n + 1 + i) as f64).collect();
            let listed = poles.iter().map(|p| format!("-{p}")).collect::<Vec<_>>().join(", ");
            let text = format!(
                "name = \"{name}\"\nn = {n}\nmu = \"exp(a=1)\"\npoles = [{listed}]\n\
                 reference = \"{reference}\"\n[params]\ntau = 2\nt0 = 0\neps = 1e-3\nu_max = inf\n"
            );
            let calls: Vec<_> =
                (0..20).map(|i| (0.05 * f64::from(i), vec![0.0; n], Vec::new())).collect();
            for ((t, _, _), u) in calls.iter().zip(inputs(name, &spec(&text), &calls)) {
                let r: Vec<_> = (0..=n as i32).map(|k| derivative(k, *t)).collect();
                let error: Vec<_> = r[..n].iter().map(|r| -r).collect();
                let size: f64 = (0..n)
                    .map(|k| {
                        let mut one = vec![0.0; n];
                        one[k] = error[k];
                        wanted(&poles, &one, 2.0 - t).abs()
                    })
                    .sum();
                let hand = wanted(&poles, &error, 2.0 - t) + r[n];
                let allowed = 1e-13 * (size + r[n].abs());
                assert!((u - hand).abs() <= allowed, "{name}, n = {n} at {t}: {u}, not {hand}");
            }
        }
    }
}

/// dt runs with t, so that its derivative is 1 whatever the start.
#[test]
fn elapsed_time_passes_as_time_does() {
    let text = "name = \"since\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n\
                reference = \"dt*t + dt^3/tau\"\n\
                [params]\ntau = 2\nt0 = 3\neps = 1e-3\nu_max = inf\n";
    let calls: Vec<_> =
        (0..20).map(|i| (3.0 + 0.09 * f64::from(i), vec![0.5, -0.25], Vec::new())).collect();
    for ((t, x, _), u) in calls.iter().zip(inputs("since", &spec(text), &calls)) {
        let dt = t - 3.0;
        let r = [dt * t + dt.powi(3) / 2.0, t + dt + 1.5 * dt * dt, 2.0 + 3.0 * dt];
        let hand = wanted(&[3.0, 4.0], &[x[0] - r[0], x[1] - r[1]], 5.0 - t) + r[2];
        assert!((u - hand).abs() <= 1e-11 * hand.abs().max(1.0), "at {t}: {u}, not {hand}");
    }
}

/// A constant is subtracted from x1, and takes no other operation.
#[test]
fn a_constant_takes_one_subtraction() {
    let code = |keys: &str| {
        let text = format!(
            "name = \"hold\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n{keys}\n[params]\n\
             tau = 1\nt0 = 0\neps = 1e-3\nu_max = inf\n"
        );
        let files = ptc_codegen::generate(&spec(&text), ptc_codegen::emit::Language::C);
        let source = files.expect("a design").into_iter().find(|file| file.name == "hold.c");
        let text = source.expect("a source").text;
        // An expression, if only a number, is that of one axis.
        text.split("\nptc_status hold_tick").next().expect("step").trim_end().to_owned()
    };
    let rest = code("");
    let moved = code("reference = \"0.25\"");
    let subtracted = "            const double e1 = x[0] - 0.25;\n";
    let without = moved.replace(subtracted, "").replace("e1", "x[0]");
    assert!(moved.contains(subtracted), "{moved}");
    assert_eq!(without, rest);
    assert_eq!(code("reference = \"0\""), rest);
}

#[test]
fn self_tests_agree_with_the_definition() {
    let track = example("track.toml");
    let at_run_time = track.replace("phase = 0.3 ", "# ").replace("t0 = 0 ", "# ");
    let given = track.replace("0.1*sin(2*t + phase)", "input").replace("phase = 0.3 ", "# ");
    let model = example("drive.toml").replace("mu = ", "reference = \"input\"\nmu = ");
    let trusting = given.replace("mu = ", "guard = \"result\"\nmu = ");
    let single = given.replace("mu = ", "precision = \"f32\"\nmu = ").replace("g = ", "# ");
    for (index, text) in
        [track, at_run_time, given, model, trusting, single].into_iter().enumerate()
    {
        let failures = in_c::selftest(&format!("reference{index}"), &spec(&text));
        assert_eq!(failures, 0.0, "{text}");
    }
}

/// Two axes with references of their own share the gains of one tick.
#[test]
fn an_axis_takes_its_own_reference() {
    let text = "name = \"axes\"\nn = 2\nmu = \"exp(a=1)\"\npoles = [-3, -4]\nreference = \"input\"\n\
                [params]\ntau = 2\nt0 = 0\neps = 1e-3\nu_max = inf\n";
    let main = "int main(void)\n{\n    axes control;\n    axes_gains gains;\n    axes_params params = { 0 };\n\
        \x20   const double x[2] = { 0.5, -0.25 }, r[2][3] = { { 0.1, 0.2, 0.3 }, { -1.0, 0.5, 2.0 } };\n\
        \x20   double u, v;\n    (void)axes_init(&control, &params);\n    (void)axes_tick(&control, 1.25, &gains);\n\
        \x20   for (int i = 0; i < 2; i++) {\n        if (axes_axis(&gains, x, r[i], &u) != PTC_OK) { return 1; }\n\
        \x20       if (axes_step(&control, 1.25, x, r[i], &v) != PTC_OK) { return 2; }\n\
        \x20       printf(\"%.17g %.17g\\n\", u, v);\n    }\n    return 0;\n}\n";
    let found = in_c::run("axes", &spec(text), main);
    for (line, r) in found.iter().zip([[0.1, 0.2, 0.3], [-1.0, 0.5, 2.0]]) {
        let hand = wanted(&[3.0, 4.0], &[0.5 - r[0], -0.25 - r[1]], 0.75) + r[2];
        assert!(line.iter().all(|u| (u - hand).abs() < 1e-13 * hand.abs()), "{line:?}, not {hand}");
    }
    // An expression in t is that of one axis.
    let own = spec(&text.replace("input", "sin(t)"));
    let files = ptc_codegen::generate(&own, ptc_codegen::emit::Language::C).expect("a design");
    assert!(files.iter().all(|file| !file.text.contains("axes_tick")));
}
