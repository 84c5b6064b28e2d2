//! The time mapping with its closed forms: r_k, BB_n and b_n.

use crate::expression::{Expression, Subject as Meaning, family_form};
use crate::family::Family;
use crate::mapping::{Form as Computed, TimeMapping};
use crate::parameter::Parameter;
use crate::request::Spec;

use super::group::{Group, elapsed, minus};
use crate::cli::mathml::{
    applied, equal, fenced, fraction, name, named, number, of_expression, of_poly, prime, sub, sup,
};
use crate::cli::report::Failure;
use crate::cli::show::{self, Subject};

pub(super) fn mapping(spec: &Spec) -> Group {
    let mu = applied(named("mu"), name("t"));
    let kappa = applied(named("kappa"), elapsed());
    let slope = prime(named("kappa"));
    let to_go = equal(name("T"), minus(named("tau"), elapsed()));
    let mut formulas = Vec::new();
    let mut told =
        "mu maps stretched time t to the time since the start, and kappa is its inverse."
            .to_owned();
    match &spec.time_mapping {
        TimeMapping::Family { family, .. } => {
            let info = family.info();
            let form = match family {
                Family::ExpSum => {
                    let tau = Expression::from(Parameter::Tau);
                    spec.time_mapping.complement().map(|complement| tau.sub(complement))
                }
                _ => family_form(info, Meaning::Mu),
            };
            formulas.extend(form.map(|form| equal(mu, of_expression(&form))));
            match family_form(info, Meaning::Family) {
                Some(form) => formulas.push(equal(kappa, of_expression(&form))),
                None => told.push_str(&format!(" kappa(Dt) is {}.", info.kappa)),
            }
            told.push_str(&format!(" Where {}.", info.atoms));
        }
        TimeMapping::Custom(custom) => {
            told.push_str(" T is the time-to-go.");
            let left = if custom.subject == Meaning::Mu { mu } else { kappa.clone() };
            formulas.push(equal(left, of_expression(&custom.given)));
            match &custom.form {
                Computed::Kappa(form) if custom.subject == Meaning::Mu => {
                    formulas.push(equal(kappa, of_expression(&form.form)));
                }
                Computed::Kappa(_) => {}
                Computed::Complement(_) => {
                    told.push_str(
                        " kappa(Dt) is the root of mu(t) = Dt, by a bracketed iteration.",
                    );
                }
            }
        }
    }
    formulas.push(to_go);
    let first = sub(name("r"), number(1));
    let inverse = fraction(number(1), first);
    let closed = spec.ring().and_then(|ring| ring.r1.inverse()).map(|poly| of_poly(&poly));
    formulas.push(match closed {
        Some(closed) => equal(equal(slope, inverse), closed),
        None => equal(slope, inverse),
    });
    Group { title: "Time mapping", told, formulas }
}

pub(super) fn r(spec: &Spec) -> Result<Group, Failure> {
    let order = fenced("(", name("k"), ")");
    let meaning = applied(sup(named("mu"), order), applied(named("kappa"), elapsed()));
    let mut formulas = vec![equal(sub(name("r"), name("k")), meaning)];
    formulas.extend(show::formulas(Subject::SmallR, spec)?);
    let told = match spec.family() {
        Some(_) => "Derivatives of mu at the stretched time, with the values that are fixed.",
        None => "Derivatives of mu at the stretched time, in those of kappa, for every mapping.",
    };
    Ok(Group { title: "Derivatives r_k", told: told.to_owned(), formulas })
}

pub(super) fn matrix(spec: &Spec) -> Result<Group, Failure> {
    let told = "The partial Bell polynomials of r_k: entry (i, j) of BB_n is B_{i-1,j-1}(r_1, r_2, ...) \
                [III-3], and b_n is the next row.";
    let formulas = show::formulas(Subject::Matrix, spec)?;
    Ok(Group { title: "Matrix BB_n and row b_n", told: told.to_owned(), formulas })
}
