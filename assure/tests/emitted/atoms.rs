//! Mappings of the user's whose differential ring closes: they cost what the family of the same
//! mathematics costs, and keep its digits.

use ptc_codegen::family::Family;
use ptc_codegen::law::{Form, Law};
use ptc_codegen::program::Stage;
use ptc_codegen::program::cost::{self, INSTRUCTIONS};
use ptc_codegen::request::Spec;

use crate::support;
use support::optimised;
use support::specs::spec;

/// Instructions of a step by the cost model, with the loads, the test and the status of any step.
fn instructions(spec: &Spec) -> usize {
    const FRAME: usize = 10;
    let program = optimised(spec);
    FRAME + cost::count(&program, &[program.step], Stage::Tick).cycles(&INSTRUCTIONS)
}

fn read(key: &str, mapping: &str, n: usize, fixed: &[(&str, &str)]) -> Spec {
    let n = n.to_string();
    let own = [("n", n.as_str()), (key, mapping), ("allow", "growth")];
    spec(&own.into_iter().chain(fixed.iter().copied()).collect::<Vec<_>>())
}

/// As bounds of the ratio, which is 1 for most.
#[test]
fn what_is_written_out_costs_what_its_family_costs() {
    for family in
        [Family::Exp, Family::Rational, Family::Power, Family::Tan, Family::Tanh, Family::Algebraic]
    {
        let info = family.info();
        let mu = format!("1*({})", info.mu);
        let kappa = info.kappa_in_time_to_go.replace('T', "(tau - dt)");
        let numbers = [("params.a", "1.5"), ("tau", "2")];
        let fixed_family = format!("{}(a=1.5)", info.name);
        for (fixed, name) in [(&[][..], info.name), (&numbers, &fixed_family)] {
            for n in 2..=8 {
                let of_family = instructions(&read("mu", name, n, &fixed[fixed.len().min(1)..]));
                for (key, mapping) in [("mu", &mu), ("kappa", &kappa)] {
                    let own = instructions(&read(key, mapping, n, fixed));
                    println!("{} {key} n = {n}: {own} of {of_family}", info.name);
                    assert!(10 * own <= 13 * of_family, "{} {key} n = {n}", info.name);
                }
            }
        }
    }
}

/// Returns true if the gains come from a ring.
fn closes(mu: &str, fixed: &[(&str, &str)]) -> bool {
    match Law::of(&read("mu", mu, 3, fixed)).form {
        Form::Rows { .. } => true,
        Form::Series | Form::State => false,
    }
}

#[test]
fn rings_close_by_algebra_not_by_spelling() {
    for mu in [
        "tau*(exp(a*t) - 1)/(exp(a*t) + 1)",
        "tau*sinh(a*t)/cosh(a*t)",
        "tau - tau/sqrt(1 + a*t)",
        "tau*(1 - ((1 + a*t)^2)^(-1/3))",
        "tau*(1 - exp(-a*t)*(1 + a*t/3))",
        "tau*(1 - exp(-a*t)/2 - exp(-2*a*t)/2)",
        "tau*(1 - exp(-a*t/2)/3 - 2*exp(-a*t)/3)",
        "2*tau/pi*(atan(a*t/2) + atan(a*t/2))",
    ] {
        assert!(closes(mu, &[]), "{mu}");
    }
    for mu in [
        "tau*(1 - exp(-a*t)/2 - exp(-b*t)/2)",
        "(tau*tanh(a*t) + tau*a*t/(1 + a*t))/2",
        "2*tau*atan(sinh(a*t))/pi*t/(1 + t)",
        "tau*tanh(sinh(a*t))",
        "tau*(1 - 1/ln(exp(1) + a*t))",
        "tau*t^3/(1 + t + t^3)",
    ] {
        assert!(!closes(mu, &[]), "{mu}");
    }
    let rates = [("params.a", "0.5"), ("params.b", "1.5"), ("params.m", "0.75")];
    assert!(closes("tau*(1 - (1 + a*t)^(-m)*exp(-b*t))", &rates));
    // Rates that are multiples of one only once they are numbers.
    assert!(closes("tau*(1 - exp(-a*t)/2 - exp(-b*t)/2)", &rates[..2]));
}
