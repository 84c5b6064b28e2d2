//! Deadlines in flight of linear plants, in the loop with the exact plant: what is planned keeps all limits and ends at
//! rest, and is not planned again.

use ptc_codegen::algebra::BigInt;
use ptc_codegen::check::sampled::FeasibleSet;
use ptc_codegen::code::{Code, Instance, Status};
use ptc_codegen::diagnostic::Diagnostic;
use ptc_codegen::request::{self, Spec};
use ptc_codegen::samples;

use super::plant::{Plant, double, number};
use super::rest::{listed, rows};
use super::support::entries;

/// A plant with its bounds, as a design gives them.
#[derive(Clone, Copy, Debug)]
struct Design {
    a: &'static str,
    b: &'static str,
    delay: &'static str,
    /// The bounds of the states.
    bounds: &'static str,
    /// Other keys.
    more: &'static str,
}

const DESIGNS: [Design; 4] = [
    Design { a: "0,1;0,-5", b: "0,40", delay: "0", bounds: "inf,0.6", more: "eps = 0\n" },
    Design { a: "0,1;-400,-2", b: "0,40", delay: "0.3", bounds: "inf,inf", more: "eps = 0\n" },
    Design {
        a: "0,1;9,1",
        b: "0,4",
        delay: "2",
        bounds: "inf,inf",
        more: "eps = 0\ndelay_law = \"predict\"\n",
    },
    Design {
        a: "0,1;0,-5",
        b: "0,40",
        delay: "0",
        bounds: "inf,inf",
        more: "eps = 0.08\npoles_end = \"least-energy(weight=1)\"\nend_samples = 12\n",
    },
];

const U_MAX: f64 = 5.0;
const STRETCH: f64 = 1.0 + 1e-9;

fn text(design: &Design, late: &str) -> String {
    let Design { a, b, delay, bounds, more } = design;
    format!(
        "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\ntau = 0.3\nu_max = {U_MAX}\ndelay = {delay}\n\
         poles = \"least-energy\"\nstate_max = [{bounds}]\n{late}\n{more}[plant]\nA = {}\nB = [{b}]\n",
        listed(a)
    )
}

fn read(text: &str) -> Result<Spec, Vec<Diagnostic>> {
    request::read(&entries(text))
}

fn code(spec: &Spec) -> Code {
    let code = samples::controller(spec, spec.sampled().expect("samples"), Vec::new());
    code.check().expect("a program in order");
    code
}

/// States of different sizes and directions.
fn states() -> impl Iterator<Item = [f64; 2]> {
    (0..12).map(|i| {
        let (sine, cosine) = (f64::from(i) * 1.7).sin_cos();
        let size = 0.06 * f64::from(1 + i % 5);
        [size * cosine, 2.0 * size * sine]
    })
}

/// The loop of one design.
struct Run {
    controller: Instance,
    plant: Plant,
    bounds: Vec<f64>,
    late: u32,
}

impl Run {
    fn new(design: &Design, late: &str, x: [f64; 2]) -> Self {
        let spec = read(&text(design, late)).unwrap_or_else(|found| panic!("{found:?}"));
        let Design { a, b, delay, bounds, .. } = *design;
        let [a, b, c] = [a, b, "1,0;0,1"].map(rows);
        let mut plant = Plant::new(&a, &b[0], &c, &number("0.01"), delay, &number("0"));
        plant.x = x.iter().map(|x| BigInt::from((x * 2f64.powi(60)) as i128) << 340).collect();
        Self {
            controller: Instance::new(&code(&spec), &[]).expect("legal parameters"),
            plant,
            bounds: bounds.split(',').map(|own| own.parse().expect("a bound")).collect(),
            late: if delay == "2" { 2 } else { 0 },
        }
    }

    fn state(&self) -> Vec<f64> {
        self.plant.x.iter().map(double).collect()
    }

    fn soonest(&mut self) -> Option<u32> {
        let outcome = self.controller.call("soonest", &[("x", &self.state())]);
        (outcome.status == Status::Ok).then(|| outcome.results["samples"][0] as u32)
    }

    fn deadline(&mut self) -> u32 {
        self.controller.call("deadline", &[]).results["k"][0] as u32
    }

    fn arm_for(&mut self, samples: u32) -> Status {
        let x = self.state();
        let given = [("k", &[0.0][..]), ("samples", &[f64::from(samples)]), ("x", &x)];
        self.controller.call("arm_for", &given).status
    }

    fn step(&mut self, k: u32) -> Status {
        let x = self.state();
        let outcome = self.controller.call("step", &[("k", &[f64::from(k)][..]), ("x", &x)]);
        let u = outcome.results["u"][0];
        assert!(u.abs() <= U_MAX * STRETCH, "{u} at {k}");
        // The inputs under way have decided the first states.
        let within = x.iter().zip(&self.bounds).all(|(x, most)| x.abs() <= most * STRETCH);
        assert!(within || k < self.late, "{x:?} at {k}");
        self.plant.step(u);
        outcome.status
    }
}

#[test]
fn planned_deadlines_keep_all_limits_and_end_at_rest() {
    for design in &DESIGNS {
        let mut found = 0;
        for x in states() {
            let mut run = Run::new(design, "in_flight = true\nreserve = 1e-9", x);
            let Some(samples) = run.soonest() else { continue };
            found += 1;
            assert_eq!(run.arm_for(samples), Status::Ok);
            for k in 0..samples {
                assert_ne!(run.step(k), Status::Saturated, "{design:?} {x:?} {k} of {samples}");
            }
            let left = run.plant.left();
            assert!(left < 1e-12 || design.more.contains("0.08"), "{design:?} {x:?}: {left}");
        }
        assert!(found > 3, "{design:?}: {found}");
    }
}

#[test]
fn deadlines_that_are_put_off_are_put_off_once() {
    for design in &DESIGNS {
        let mut put_off = 0;
        for x in states() {
            let mut run = Run::new(design, "late = \"extend\"", x);
            let Some(samples) = run.soonest() else { continue };
            run.arm_for(8);
            let first = run.step(0);
            let deadline = run.deadline();
            assert_eq!(first == Status::Late, deadline > 8, "{design:?} {x:?}: {first:?}");
            assert!(deadline <= samples.max(8), "{design:?} {x:?}: {deadline} {samples}");
            put_off += u32::from(first == Status::Late);
            for k in 1..deadline + 10 {
                let status = run.step(k);
                assert!(
                    matches!(status, Status::Ok | Status::Hold),
                    "{design:?} {x:?} {k}: {status:?}"
                );
                assert_eq!(run.deadline(), deadline, "{design:?} {x:?} {k}");
            }
        }
        assert!(put_off > 0, "{design:?}: {put_off}");
    }
}

#[test]
fn deadline_that_is_too_soon_is_refused() {
    for design in &DESIGNS {
        let mut run = Run::new(design, "late = \"refuse\"", [0.3, -0.2]);
        let samples = run.soonest().expect("a deadline");
        assert_eq!(run.arm_for(samples), Status::Ok, "{design:?} {samples}");
        assert_eq!(run.arm_for(6), Status::Soon, "{design:?}");
    }
}

/// The feasible set of `check` is that of the controller: from inside it tau is not put off.
#[test]
fn feasible_set_is_that_of_the_controller() {
    for design in &DESIGNS {
        let spec = read(&text(design, "late = \"refuse\"")).expect("a design");
        let set = FeasibleSet::of(&spec).unwrap_or_else(|none| panic!("{}", none.why));
        for (x1, x2) in set.kept.states.iter().step_by(30) {
            for (part, wanted) in [(0.999, Status::Ok), (1.001, Status::Soon)] {
                let mut run = Run::new(design, "late = \"refuse\"", [part * x1, part * x2]);
                assert_eq!(run.arm_for(30), wanted, "{design:?} {x1} {x2} {part}");
            }
        }
    }
}

#[test]
fn plans_that_no_table_bounds_are_refused() {
    let refused = |text: &str, wanted: &str| {
        let found = read(text).expect_err(wanted);
        let [one] = found.as_slice() else { panic!("{text}: {found:?}") };
        assert!(format!("{} {}", one.message, one.help).contains(wanted), "{text}: {one:?}");
    };
    let own = text(&DESIGNS[0], "late = \"extend\"");
    refused(&own.replace("\"least-energy\"", "[-4, -5]"), "beside A and B and a law of poles");
    refused(&own.replace("u_max = 5", "u_max = inf").replace("0.6", "inf"), "without a limit");
    let follows =
        own.replace("[plant]", "reference = \"input\"\n[model]\noutput = [1, 0]\n[plant]");
    refused(&follows, "the u that it will need is not known");
}
