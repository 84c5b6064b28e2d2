//! Parameters at run time, calls that fail, and the command of a design.

use ptc_codegen::code::{Instance, Status};

use super::{AT_RUN_TIME, FOUR, changed, decoupled, program};
use crate::support::{example, spec};

#[test]
fn inputs_that_do_not_decouple_are_refused_at_run_time() {
    let tank = changed(&example("tank.toml"), "sample_time = 0.25", "");
    let code = program(&tank);
    let mut controller = Instance::new(&code, &[]).expect("legal parameters");
    let mut call = |x: &[f64]| {
        let outcome = controller.call("step", &[("k", &[3.0]), ("x", x)]);
        (outcome.status, outcome.results["u"].clone(), outcome.results["axes"].clone())
    };
    let number = |status: Status| f64::from(status.number());
    // The determinant is 1 + h.
    let (status, u, _) = call(&[-1.0, 3.0, 2.0]);
    assert_eq!((status, u), (Status::Range, vec![0.0; 2]));
    let (status, u, axes) = call(&[0.5, f64::NAN, 2.0]);
    assert_eq!((status, u, axes), (Status::Input, vec![0.0; 2], vec![number(Status::Input); 2]));
    let (status, u, axes) = call(&[0.5, 1e3, 2.0]);
    assert_eq!((status, u[1].abs()), (Status::Saturated, 50.0));
    assert_eq!(axes, [number(Status::Ok), number(Status::Saturated)]);
    let mut four = program(&changed(
        FOUR,
        "poles = [[-4], [-3, -4], [-5], [-2.5, -6]]\nsample_time = 0.02",
        "tau = 1\nu_max = inf",
    ));
    four.head.clear();
    let mut four = Instance::new(&four, &[]).expect("legal parameters");
    let outcome = four.call("step", &[("k", &[3.0]), ("x", &[0.0, 2.0, 1.0, 0.0, 0.5, 0.0])]);
    assert_eq!((outcome.status, &outcome.results["u"]), (Status::Range, &vec![0.0; 4]));
}

#[test]
fn parameters_at_run_time_act_as_fixed_ones() {
    let fixed = decoupled(&[
        ("tau", "0.5"),
        ("sample_time", "1/128"),
        ("poles", "-3,-4"),
        ("deadbeat", "5"),
    ]);
    let open = decoupled(&[("mu", "exp")]);
    let mut fixed = Instance::new(&fixed, &[]).expect("legal parameters");
    let mut open = Instance::new(&open, &AT_RUN_TIME).expect("legal parameters");
    for k in 0..66_u32 {
        let given = [("k", &[f64::from(k)][..]), ("x", &[0.3, -1.0, 2.0, 0.5])];
        let [found, wanted] = [&mut open, &mut fixed].map(|c| c.call("step", &given));
        assert_eq!(found.status, wanted.status, "{k}");
        for (found, wanted) in found.results["u"].iter().zip(&wanted.results["u"]) {
            assert!((found / wanted - 1.0).abs() < 1e-14, "{k}: {found}, not {wanted}");
        }
    }
    let mut short = AT_RUN_TIME;
    short[0] = ("samples", &[1.0]);
    let open = decoupled(&[("mu", "exp")]);
    assert_eq!(Instance::new(&open, &short).err(), Some(Status::Param));
}

/// The command of a design gives it back.
#[test]
fn the_command_gives_the_design() {
    for (name, top) in [
        ("tank.toml", "poles = [[-4], [-3, -4]]\nsample_time = 0.25\ndeadbeat = 12"),
        (
            "two_link.toml",
            "mu = \"exp(a=1.25)\"\nsample_time = 0.05\nprecision = \"f32\"\nguard = \"none\"",
        ),
    ] {
        let wanted = spec(&changed(&example(name), top, ""));
        let found = crate::command::spec_of(&wanted.command()).expect("a legal command");
        assert_eq!(found, wanted, "{}", wanted.command());
    }
}
