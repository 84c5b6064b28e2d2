//! The controllers of generated/ over their whole time to the deadline and past it.

use ptc_codegen::parameter::Parameter;
use ptc_codegen::reference::Status;
use ptc_codegen::request::{After, Spec};

use crate::support;
use support::folder;
use support::goldens::controllers;
use support::program::{Record, has_gains, in_c, in_rust};
use support::specs::Values;

/// The statuses that a golden may give at a time, where tau is 2 s and eps 2^-7 s.
fn possible(spec: &Spec, t: f64) -> [i32; 2] {
    let unclipped = match spec.after {
        After::Zero | After::Extern if t >= 2.0 => Status::After,
        _ if t < 1.99 => Status::Ok,
        _ => Status::Hold,
    };
    [unclipped, Status::Saturated].map(Status::code)
}

/// Each compiles without a warning and runs, in C and in Rust, over its whole time to the deadline and past it: the statuses
/// are those of the time, and the two languages agree up to the last digits of a library.
#[test]
fn every_golden_runs() {
    let controllers = controllers();
    let folder = folder("golden_runs");
    let programs = in_c(&folder, &controllers).into_iter().zip(in_rust(&folder, &controllers));
    for (spec, (c, rust)) in controllers.iter().zip(programs) {
        let gains: Vec<f64> = (1..=spec.n).map(|i| 2.0 + i as f64).collect();
        let values = Values {
            tau: 2.0,
            t0: 0.0,
            eps: 0.0078125,
            u_max: 1e30,
            a: 1.0,
            m: 1.5,
            start: 0.25,
            rates: &[0.5, 1.5, 2.5][..spec.rates()],
            k: &gains,
        };
        let times: Vec<f64> = (0..=17).map(|i| f64::from(i) / 8.0).collect();
        let parameter = |parameter| match parameter {
            Parameter::Named(_) => 1.0,
            of_family => values.get(of_family),
        };
        let x: Vec<f64> = (0..spec.n).map(|j| 0.01 * (j as f64 + 1.0)).collect();
        let record = |t: &f64| Record {
            parameters: spec.run_time_parameters().map(parameter).collect(),
            x0: if spec.latches() { x.clone() } else { Vec::new() },
            t: *t,
            x: x.clone(),
        };
        let records: Vec<_> = times.iter().map(record).collect();
        for ((t, c), rust) in times.iter().zip(c.run(&records)).zip(rust.run(&records)) {
            let name = spec.name();
            assert!(c.init == 0 && possible(spec, *t).contains(&c.step.0), "{name} at {t}: {c:?}");
            assert_eq!((c.step.0, c.axis.0), (rust.step.0, rust.axis.0), "{name} at {t}");
            let mut pairs = vec![(c.step.1, rust.step.1), (c.axis.1, rust.axis.1)];
            pairs.extend(has_gains(spec).then_some((c.step.1, c.axis.1)));
            for (u, v) in pairs {
                let near = 1e-5 * u.abs().max(1e-3);
                assert!(u.is_finite() && (u - v).abs() <= near, "{name} at {t}: {u} and {v}");
            }
        }
    }
}
