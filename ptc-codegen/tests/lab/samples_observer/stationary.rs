//! The stationary observer: its gains against an iteration of the covariance, and the loops that it closes.

use num_traits::ToPrimitive;
use ptc_codegen::code::Instance;
use ptc_codegen::request::{Lasting, Spec};

use super::{Random, code, legal, read};

/// A stage of 1.5 kg at 1 kHz with an encoder of 1 um.
const STAGE: &str = "n = 2\ng = \"1/1.5\"\nsample_time = 1e-3\ntau = 0.4\npoles = \"least-energy\"\nmeasured = \"x1\"\n\
     sensor_step = [1e-6, 0]\ndisturbance = \"constant\"\neps = 0\nu_max = inf\ndelay = 1\n";

/// A motor whose angle and current are measured.
const MOTOR: &str = "sample_time = 1e-3\ntau = 0.2\npoles = [-4, -5, -6]\ndisturbance = \"constant\"\neps = 0.01\n\
     noise = [1e-5, 1e-3]\nu_max = inf\n";

const PLANT: &str = "[plant]\nA = [[0, 1, 0], [0, -0.5, 1500], [0, -15, -600]]\nB = [0, 0, 500]\nC = [[1, 0, 0], [0, 0, 1]]\n";

fn gains(spec: &Spec) -> Vec<Vec<f64>> {
    let observer = spec.sampled().and_then(|own| own.observer.as_ref()).expect("an observer");
    let Lasting::Stationary(own) = &observer.lasting else { panic!("no stationary observer") };
    let double = |gain: &ptc_codegen::algebra::BigRational| gain.to_f64().expect("a double");
    own.gains.iter().map(|row| row.iter().map(double).collect()).collect()
}

/// The covariance of x1, x2 and d, sample by sample, until it stays.
#[test]
fn gains_are_those_of_the_settled_covariance() {
    let found = gains(&legal(&format!("observer = \"stationary\"\ndisturbance_walk = 2\n{STAGE}")));
    let (h, g) = (1e-3_f64, 1.0 / 1.5);
    let phi = [[1.0, h, g * h * h / 2.0], [0.0, 1.0, g * h], [0.0, 0.0, 1.0]];
    let (walk, noise) = (4.0 * h, 1e-12 / 12.0);
    let mut p = [[0.0; 3]; 3];
    (0..3).for_each(|i| p[i][i] = [1e-6, 1e-2, 1.0][i]);
    let mut gain = [0.0; 3];
    for _ in 0..5000 {
        gain = [0, 1, 2].map(|i| p[i][0] / (p[0][0] + noise));
        let known = |i: usize, j: usize| p[i][j] - gain[i] * p[0][j];
        let row =
            |i: usize| [0, 1, 2].map(|j| (0..3).map(|k| phi[i][k] * known(k, j)).sum::<f64>());
        let moved = [0, 1, 2].map(row);
        let back = |i: usize, j: usize| (0..3).map(|k| moved[i][k] * phi[j][k]).sum::<f64>();
        p = [0, 1, 2].map(|i| [0, 1, 2].map(|j| back(i, j)));
        p[2][2] += walk;
    }
    for (found, wanted) in found.iter().zip(gain) {
        assert!((found[0] / wanted - 1.0).abs() < 1e-6, "{found:?}, not {wanted}");
    }
}

/// The error of the estimates decays from the first sample on, and with it the loop ends at rest.
#[test]
fn loop_ends_at_rest() {
    let spec = legal(&format!("observer = \"stationary\"\ndisturbance_walk = 2\n{STAGE}"));
    let code = code(&spec);
    let mut controller = Instance::new(&code, &[]).expect("legal parameters");
    let (mut x, mut late, force) = ([0.1, 0.0], 0.0, 0.3);
    for k in 0..400_u32 {
        let u = controller.call("step", &[("k", &[f64::from(k)]), ("y", &x[..1])]).results["u"][0];
        let a = (late + force) / 1.5;
        x = [x[0] + 1e-3 * x[1] + 5e-7 * a, x[1] + 1e-3 * a];
        late = u;
    }
    assert!(x[0].abs() < 1e-12 && x[1].abs() < 1e-10, "{x:?}");
    assert!((controller.call("disturbance", &[]).results["d"][0] - force).abs() < 1e-9);
}

/// Behind a round the gains are those without one, also where the round mixes several measured values.
#[test]
fn gains_behind_a_round_are_the_same() {
    let of_round = "observer_poles = [-4, -5, -6, -7]\nobserver_samples = 60\nafter_observer = \"stationary\"\n";
    let designs = [format!("observer = \"stationary\"\n{MOTOR}"), format!("{of_round}{MOTOR}")];
    let specs = designs.map(|own| legal(&format!("disturbance_walk = 0.5\n{own}{PLANT}")));
    assert_eq!(gains(&specs[0]), gains(&specs[1]));
    let programs = specs.map(|spec| code(&spec));
    let mut inputs = programs.iter().map(|code| {
        let mut controller = Instance::new(code, &[]).expect("legal parameters");
        let mut random = Random(7);
        let mut call = |k: u32| {
            // Readings of an angle and a current that no plant makes: what is told to both is the same.
            let y = [1e-4 * (random.next() - 0.5), 1e-2 * (random.next() - 0.5)];
            controller.call("step", &[("k", &[f64::from(k)]), ("y", &y)]).results["u"][0]
        };
        (0..900).map(&mut call).collect::<Vec<f64>>()
    });
    let [alone, behind] = [(); 2].map(|()| inputs.next().expect("a run"));
    let most = alone[800..].iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    for (k, (a, b)) in alone.iter().zip(&behind).enumerate().skip(800) {
        assert!((a - b).abs() < 1e-6 * most, "sample {k}: {a}, {b}");
    }
}

#[test]
fn mistakes_of_a_stationary_observer_are_named() {
    let stage = |more: &str, without: &str| {
        let lines = STAGE.lines().filter(|line| without.is_empty() || !line.starts_with(without));
        format!("observer = \"stationary\"\n{more}{}\n", lines.collect::<Vec<_>>().join("\n"))
    };
    let walk = "disturbance_walk = 1\n";
    for (design, wanted) in [
        (stage("", ""), "`disturbance_walk` is missing"),
        (stage("disturbance_walk = 0\n", ""), "not a finite number > 0"),
        (stage(walk, "disturbance"), "without a disturbance"),
        (stage(walk, "sensor_step"), "measurement 1 is exact"),
        (
            stage(&format!("{walk}observer_poles = [-4, -5, -6]\n"), ""),
            "beside a stationary observer",
        ),
        (stage(&format!("{walk}what = \"observer\"\n"), ""), "a stationary observer alone"),
        (stage(walk, "").replace("stationary", "kalman"), "is not one of prescribed, stationary"),
        (
            stage(walk, "").replace("observer = \"stationary\"", "observer_poles = [-4, -5, -6]"),
            "`disturbance_walk` without a stationary observer",
        ),
    ] {
        let found = read(&design).expect_err(wanted);
        assert!(found.contains(wanted), "{wanted}: {found}");
    }
}
