//! Controllers in samples of linear plants: against reference values of 40 digits, in the loop with
//! the exact plant, and what is refused. What runs is the program that is emitted, in its arithmetic.

#[cfg(feature = "lab")]
mod check;
#[cfg(feature = "lab")]
mod flight;
mod followed;
mod least_energy;
mod observer;
use crate::support::exact_plant as plant;
mod reference;
mod refusals;
mod rest;
use crate::support;

use ptc_codegen::code::{Code, Instance};
use ptc_codegen::diagnostic::Diagnostic;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::request::{self, Spec};
use ptc_codegen::samples;
use support::entries;

/// The keys above the table [plant].
const ABOVE: &str = "mu = \"exp(a=1)\"\nclock = \"samples\"\nu_max = inf\n";

fn read(text: &str) -> Result<Spec, Vec<Diagnostic>> {
    request::read(&entries(&format!("{ABOVE}{text}")))
}

fn code(text: &str) -> Code {
    let spec = read(text).unwrap_or_else(|found| panic!("{text}: {found:?}"));
    let code = samples::controller(&spec, spec.sampled().expect("samples"), Vec::new());
    code.check().expect("a program in order");
    code
}

/// Four factors of so many samples to go leave the range of single precision, so they are divided by in turn.
#[test]
fn single_precision_counts_down_from_any_number_of_samples() {
    let code =
        code("n = 4\nprecision = \"f32\"\nsample_time = 1\neps = 0\npoles = [-4,-5,-6,-7]\n");
    let samples = [(Parameter::Samples, 4e9)];
    let mut controller = Instance::with_parameters(&code, samples).expect("legal parameters");
    let outcome = controller.call("step", &[("k", &[0.0][..]), ("x", &[1e6, 0.0, 0.0, 0.0])]);
    let exact = -840.0 * 1e6 / 4e9_f64.powi(4);
    let u = outcome.results["u"][0];
    assert!((u / exact - 1.0).abs() < 1e-6, "{u:e}, not {exact:e}");
}

/// A chain given as a linear plant is the chain.
#[test]
fn a_chain_is_one_of_them() {
    let above = "sample_time = 0.01\ntau = 0.6\ndelay = 1\npoles = [-4,-5,-6]\n";
    let (chain, linear) = (
        code(&format!("n = 2\ng = 3\n{above}")),
        code(&format!("{above}[plant]\nA = [[0, 1], [0, 0]]\nB = [0, 3]\n")),
    );
    let [mut one, mut other] =
        [&chain, &linear].map(|code| Instance::new(code, &[]).expect("legal"));
    for k in 0..70_u32 {
        let x = [f64::from(k % 7) - 3.0, f64::from(k % 5) - 1.5];
        let call = |controller: &mut Instance| {
            controller.call("step", &[("k", &[f64::from(k)][..]), ("x", &x)]).results["u"][0]
        };
        let (one, other) = (call(&mut one), call(&mut other));
        assert!((one - other).abs() <= 1e-12 * one.abs(), "{k}: {one} {other}");
    }
}

/// The command in the head gives the same controller.
#[test]
fn its_command_gives_the_same() {
    let spec = read(
        "sample_time = 0.01\ntau = 1\npoles = [-4,-5,-6]\nmeasured = [\"x2\"]\nobserver_poles = [-3,-4]\n\
         after_observer = [\"-30+5i\",\"-30-5i\"]\ndelay = 1\nreference = \"sin(t)\"\n[model]\noutput = [4,-1]\n[plant]\nA = [[0,1],[-1,\"-1/3\"]]\nB = [0.25,1]\n",
    );
    let command = spec.expect("a design").command();
    let wanted = [
        "--A=\"[[0,1],[-1,-1/3]]\" --B=\"[0.25,1]\" --C=\"[[0,1]]\"",
        "--output=\"[4,-1]\"",
        "--after-observer=-30+5i,-30-5i",
    ];
    for wanted in wanted {
        assert!(command.contains(wanted), "{command}");
    }
}
