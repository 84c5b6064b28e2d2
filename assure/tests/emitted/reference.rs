//! The long arithmetic of `ptc_codegen::reference` against the references of tests/data, which
//! another library computed from the definitions.

use crate::support;

use ptc_codegen::expression::{Expression, Variable};
use ptc_codegen::mapping::TimeMapping;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::reference::{Call, Outcome, Status, evaluate};
use ptc_codegen::request::Spec;
use support::in_pairs;
use support::specs::spec as read_spec;
use support::vectors::{Vector, lines};

/// Half a unit of the 30th digit of a u, the last that the data holds, is at most this part of it.
const LAST_DIGIT: f64 = 5.000001e-30;

fn of_family(vector: &Vector, precision: Precision) -> Spec {
    let (family, rates) = (vector.family, vector.rates.len());
    let mut spec = Spec::of(vector.n, TimeMapping::Family { family, rates });
    spec.precision = precision;
    spec
}

fn outcome(spec: &Spec, vector: &Vector, laws: &[Expression]) -> Outcome {
    let values = vector.values(1e-13);
    let parameter = |p: Parameter| match p {
        Parameter::Named(name) => match name.text() {
            "a" => vector.a,
            "m" => vector.m,
            "start" => vector.start,
            "a1" => vector.rates[0],
            "a2" => vector.rates[1],
            other => panic!("{other}"),
        },
        p => values.get(p),
    };
    let call = Call { parameter: &parameter, x0: &[], t: vector.t, x: &vector.x, laws, after: 0.0 };
    evaluate(spec, &call).expect("enough digits")
}

fn judge(file: &str, precision: Precision) {
    let vectors = lines(file);
    let errors = in_pairs(&vectors, |(vector, u)| {
        let found = outcome(&of_family(vector, precision), vector, &[]);
        assert_eq!(found.status, Status::Ok, "{vector:?}");
        let control = found.control.expect("a law");
        let scale = (control.scale() - vector.scale).abs() / vector.scale;
        assert!(scale < 1e-14, "scale {:e} for {vector:?}", control.scale());
        let error = control.error_of_text(u).expect("a decimal number");
        let allowed = LAST_DIGIT * vector.u.abs() / vector.scale;
        assert!(error <= allowed, "{error:e} > {allowed:e} for {vector:?}");
        error
    });
    let worst = errors.iter().copied().fold(0.0, f64::max);
    println!("{file}: {} vectors, worst |u - u_ref|/scale {worst:.1e}", errors.len());
}

#[test]
fn every_digit_of_the_vectors() {
    judge("vectors.jsonl", Precision::F64);
}

#[test]
fn every_digit_near_the_deadline() {
    judge("deadline.jsonl", Precision::F64);
}

#[test]
fn every_digit_in_single_precision() {
    judge("single.jsonl", Precision::F32);
}

/// A family written out as a mapping of the user's, by mu and by kappa, and the law as an
/// expression, is the family.
#[test]
fn expressions_are_evaluated_as_they_are_written() {
    for (index, (vector, u)) in lines("deadline.jsonl").into_iter().enumerate() {
        if vector.n > 5 || index % 7 != 0 || vector.rates.len() > 2 {
            continue;
        }
        let n = vector.n.to_string();
        let info = vector.family.info();
        let mu = if vector.rates.is_empty() {
            format!("1*({})", info.mu)
        } else {
            "tau*mean(1 - exp(-a1*t), 1 - exp(-a2*t))".to_owned()
        };
        let kappa = info.kappa_in_time_to_go.replace('T', "(tau - dt)");
        let mappings = [("mu", mu.as_str()), ("kappa", &kappa)];
        for mapping in mappings.into_iter().filter(|(_, text)| !text.is_empty()) {
            let spec = read_spec(&[("n", &n), mapping, ("pi0", "extern")]);
            let term = |(i, k): (usize, &f64)| {
                let gain = ptc_codegen::program::number::exact(*k).expect("a finite gain");
                Expression::from(gain).mul(Variable::Xi(i + 1).into())
            };
            let law = vector.k.iter().enumerate().map(term).reduce(Expression::add);
            let found = outcome(&spec, &vector, &[law.expect("a law").neg()]);
            let error = found.control.expect("a law").error_of_text(&u).expect("a number");
            let allowed = LAST_DIGIT * vector.u.abs() / vector.scale;
            assert!(error <= allowed, "{error:e} > {allowed:e} by {mapping:?} for {vector:?}");
        }
    }
}
