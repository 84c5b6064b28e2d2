//! The observer after its deadline.

use ptc_codegen::code::Instance;

use super::code;

/// After the deadline of the observer an error decays as its poles say.
#[test]
fn after_observer_places_the_poles() {
    let s = |re: f64, im: f64, h: f64| {
        // z^2 - 2 exp(re h) cos(im h) z + exp(2 re h)
        ((re * h).exp() * 2.0 * (im * h).cos(), (2.0 * re * h).exp())
    };
    let (h, (sum, product)) = (0.002_f64, s(-50.0, 30.0, 0.002));
    let above = "sample_time = 0.002\ntau = 0.2\npoles = [-4,-5]\nobserver_poles = [-4,-5]\n\
                 after_observer = [\"-50+30i\",\"-50-30i\"]\n";
    let mut phi = [[1.0, h], [0.0, 1.0]];
    let mut gamma = [h * h / 2.0, h];
    for linear in [false, true] {
        let code = match linear {
            false => code(&format!("n = 2\nmeasured = [\"x1\"]\n{above}")),
            true => {
                let decay: f64 = (-3.0 * h).exp();
                phi = [[1.0, (1.0 - decay) / 3.0], [0.0, decay]];
                gamma = [(h - (1.0 - decay) / 3.0) / 3.0, (1.0 - decay) / 3.0];
                code(&format!("{above}[plant]\nA = [[0,1],[0,-3]]\nB = [0,1]\nC = [1,0]\n"))
            }
        };
        let mut controller = Instance::new(&code, &[]).expect("legal parameters");
        let mut x = [0.4, -0.2];
        let mut errors = Vec::new();
        for k in 0..75_u32 {
            let given = [("k", &[f64::from(k)][..]), ("y", &x[..1])];
            let u = controller.call("step", &given).results["u"][0];
            let estimate = controller.call("estimate", &[]).results["xhat"].clone();
            errors.push([x[0] - estimate[0], x[1] - estimate[1]]);
            x = [0, 1].map(|i| phi[i][0] * x[0] + phi[i][1] * x[1] + gamma[i] * u);
            if k == 55 {
                x[0] += 1.0;
                x[1] -= 2.0;
            }
        }
        assert!(errors[52].iter().all(|e| e.abs() < 1e-9), "{:?}", errors[52]);
        for k in 57..72 {
            let after = errors[k].iter().zip(&errors[k + 1]).zip(&errors[k + 2]);
            for (i, ((a, b), c)) in after.take(2).enumerate() {
                let off = c - sum * b + product * a;
                assert!(off.abs() <= 1e-9 * (a.abs() + b.abs()), "{linear} {k} {i}: {a} {b} {c}");
            }
        }
    }
}
