//! A mapping that approaches the deadline so slowly that Newton's method needs more rounds than it is
//! given: bisection finds the stretched time, against its closed form.

use crate::support;

use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;
use support::program::{Record, in_c, in_rust};
use support::specs::spec;
use support::{folder, tolerance};

/// Power of the decay of mu.
const P: f64 = 0.02;

fn slow(precision: &str) -> Spec {
    spec(&[
        ("n", "1"),
        ("mu", "tau*(1 - (2/(1 + t + sqrt(1 + t^2)))^0.02)"),
        ("tau", "1"),
        ("t0", "-1"),
        ("eps", "1e-10"),
        ("gains", "3"),
        ("u_max", "inf"),
        ("precision", precision),
        ("name", "slow"),
    ])
}

/// u = -k x kappa' at this time-to-go. With z = t + sqrt(1 + t^2), the time-to-go is (2/(1 + z))^p, and
/// dz/dt = 2 z^2/(1 + z^2).
fn wanted(time_to_go: f64, x: f64) -> f64 {
    let z = 2.0 * time_to_go.powf(-1.0 / P) - 1.0;
    let rate = P * time_to_go * 2.0 / (1.0 + (1.0 / z).powi(2)) / (1.0 + z);
    -3.0 * x / rate
}

/// A call at a time-to-go.
fn at(time_to_go: f64, precision: Precision) -> Record {
    let t = support::specs::rounded(-time_to_go, precision);
    Record { parameters: vec![], x0: vec![], t, x: vec![0.5] }
}

#[test]
fn a_slow_mapping_is_inverted() {
    // Where t^2 leaves the range, the expression has no value: docs/limits.md.
    for (precision, type_, least) in [("f64", Precision::F64, 1e-3), ("f32", Precision::F32, 0.5)] {
        let spec = slow(precision);
        let steps = 0..60;
        let records: Vec<_> =
            steps.map(|step| at((f64::from(step) / 59.0 * f64::ln(least)).exp(), type_)).collect();
        let home = folder(&format!("bisection_{precision}"));
        let specs = [spec];
        for program in [in_c(&home, &specs).remove(0), in_rust(&home, &specs).remove(0)] {
            for (record, found) in records.iter().zip(program.run(&records)) {
                let (status, u) = found.step;
                assert_eq!((found.init, status), (0, 0), "{record:?}");
                let wanted = wanted(-record.t, record.x[0]);
                let error = (u / wanted - 1.0).abs();
                assert!(error <= tolerance::slow(type_), "{record:?}: {u:e} {wanted:e} {error:e}");
            }
        }
    }
}

/// There Newton's method does not end within its rounds, so that those of bisection decide u and its status.
#[test]
fn languages_agree_where_the_root_leaves_the_range() {
    let home = folder("bisection_beyond");
    let specs = [slow("f64")];
    let records: Vec<_> =
        (0..60).map(|step| at(1e-3 * 0.76_f64.powi(step), Precision::F64)).collect();
    let [in_c, in_rust] =
        [in_c(&home, &specs), in_rust(&home, &specs)].map(|all| all[0].run(&records));
    for ((record, c), rust) in records.iter().zip(in_c).zip(in_rust) {
        let bits = |(status, u): (i32, f64)| (status, u.to_bits());
        assert_eq!(bits(c.step), bits(rust.step), "{record:?}");
    }
}
