//! The controller of a simulation is the emitted one: its whole code, run by the interpreter, gives the same bits.

use ptc_codegen::check::examine::examine;
use ptc_codegen::code::Instance;
use ptc_codegen::controller::{self, Controller as Emitted};
use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::plant::{Plant, as_one};
use ptc_codegen::program::passes;
use ptc_codegen::request::Spec;
use ptc_codegen::simulate::{Controller, Values};

use super::of_axes::{GANTRY, SHARED};
use super::support::{QUADROTOR, design};
use super::{UNICYCLE, example};

/// Even numbers between -1 and 1, from a linear congruence.
struct Draw(u64);

impl Draw {
    fn even(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 33).expect("31 bits")) / f64::from(1_u32 << 30) - 1.0
    }
}

/// Every u and the status of calls at random times and states, each from both; how often each status was met.
fn agree((spec, plant): (&Spec, Plant), scale: &[f64], met: &mut [usize; 7]) {
    let (one, plant) = as_one(spec.clone(), Some(plant));
    let values = Values::of(&one, &plant.unwrap_or_default());
    let (report, law) = (examine(spec), Law::of(spec));
    let program = passes::optimise(lower(spec, &law), &mut |_, _| {});
    let emitted = Emitted { report: &report, law: &law, program: &program, measured: &[] };
    let code = controller::whole(&emitted);
    let given = spec.run_time_parameters().map(|parameter| (parameter, values.get(parameter)));
    let mut whole = Instance::with_parameters(&code, given).expect("legal parameters");
    let mut simulated = Controller::new(&one).expect("a controller");
    simulated.init(&values, &vec![0.0; scale.len()]).expect("legal parameters");
    let tau = values.get(ptc_codegen::parameter::Parameter::Tau);
    let mut draw = Draw(7);
    for call in 0..2000 {
        let t = tau * (0.55 + 0.6 * draw.even());
        let mut x: Vec<_> = scale.iter().map(|scale| scale * draw.even()).collect();
        if call % 50 == 0 {
            x[2] = 0.0;
        }
        let outcome = whole.call("step", &[("t", &[t]), ("x", &x)]);
        let (u, status) = simulated.step(t, &x);
        let bits = |u: &[f64]| u.iter().map(|u| u.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(u), bits(&outcome.results["u"]), "at {t}, {x:?}");
        assert_eq!(status, outcome.status.into(), "at {t}, {x:?}");
        met[usize::try_from(outcome.status.number() + 3).expect("a status")] += 1;
    }
}

#[test]
fn the_whole_code_gives_the_same_bits() {
    let arm = example("two_link.toml");
    let mut met = [0; 7];
    for (text, scale) in [
        (arm.clone(), &[3.0, 3.0, 4.0, 4.0][..]),
        (
            arm.replace("name =", "guard = \"result\"\nprecision = \"f32\"\nname ="),
            &[3.0, 3.0, 4.0, 4.0],
        ),
        (example("barrier_arm.toml"), &[1.5, 1.0, 4.0, 4.0]),
        (example("tank.toml"), &[0.9, 40.0, 40.0]),
        (UNICYCLE.to_owned(), &[1.0, 1.0, 2.0, 3.0]),
        (UNICYCLE.replace("u_max = inf", "u_max = 12"), &[1.0, 1.0, 2.0, 3.0]),
        (QUADROTOR.to_owned(), &[1.0, 1.0, 0.9, 0.9, 0.9, 2.0, 2.0, 2.0]),
        (
            QUADROTOR.replace("name =", "precision = \"f32\"\nname ="),
            &[1.0, 1.0, 3.0, 3.0, 3.0, 2.0, 2.0, 2.0],
        ),
        (GANTRY.to_owned(), &[1.0, 9.0, 1.0, 9.0, 1.0, 9.0]),
        (GANTRY.replace("name =", "guard = \"none\"\nname ="), &[1.0, 9.0, 1.0, 9.0, 1.0, 9.0]),
        (SHARED.to_owned(), &[1e300, 1e300, 1e300, 1.0]),
    ] {
        let (spec, plant) = design(&text);
        agree((&spec, plant), scale, &mut met);
    }
    // E_RANGE, E_INPUT, OK, HOLD and SATURATED are all met; parameters are legal, and no law follows the deadline.
    for (status, met) in [-3, -2, 0, 1, 2]
        .into_iter()
        .map(|s: i32| (s, met[usize::try_from(s + 3).expect("a place")]))
    {
        assert!(met > 20, "{status}: {met}");
    }
}
