//! The law with its gains.

use crate::algebra::{Kind, Poly, Symbol};
use crate::law::{Form, Law};
use crate::request::{Feedback, Spec};

use super::group::{Group, elapsed, minus, n};
use crate::cli::mathml::{
    self, Math, applied, bold, equal, fenced, fraction, name, named, number, of_expression,
    operator, prime, product, relation, row, sub, sub_sup, sup, words,
};
use crate::cli::report::Failure;
use crate::cli::show::{self, Subject};

pub(super) fn law(spec: &Spec) -> Result<Group, Failure> {
    let pi0 = || sub(named("pi"), number(0));
    let index = || n(spec);
    let slope = sup(prime(named("kappa")), index());
    let stretched = sub(name("t"), named("kappa"));
    let xi = product(sub(bold("B"), index()), name("x"));
    let row_b = sub_sup(bold("b"), index(), mathml::transpose());
    let inner = minus(
        row([pi0(), fenced("(", row([xi.clone(), operator(","), stretched.clone()]), ")")]),
        product(row_b, name("x")),
    );
    let mut formulas = vec![
        equal(name("u"), product(fraction(slope, name("g")), fenced("(", inner, ")"))),
        row([
            equal(named("xi"), xi),
            operator(","),
            words("  "),
            equal(
                stretched,
                relation(applied(named("kappa"), elapsed()), "+", sub(name("t"), number(0))),
            ),
        ]),
    ];
    let mut told = "Theorem 1, [th:1-1].".to_owned();
    if spec.reference.is_some() {
        told.push_str(
            " Here x stands for the tracking error, x_i - r^(i-1), and r^(n) is added to g u.",
        );
    }
    match &spec.feedback {
        Feedback::Linear => {
            let term = product(sub(name("k"), name("i")), sub(named("xi"), name("i")));
            let sum = row([sum_to("i", index()), term]);
            formulas.push(equal(pi0(), row([operator("\u{2212}"), sum])));
            told.push_str(gains(spec, &mut formulas)?);
        }
        Feedback::Expression(law) => {
            formulas.push(equal(pi0(), of_expression(&spec.law_named(law))));
        }
        Feedback::Extern => told.push_str(" pi0 is a function of the program's."),
        // Its law is that of samples.
        Feedback::LeastEnergy(_) => {}
    }
    Ok(Group { title: "Law", told, formulas })
}

fn sum_to(index: &str, to: Math) -> Math {
    mathml::sum(equal(name(index), number(1)), to)
}

/// The gains in closed form, and what is to be said of them.
fn gains(spec: &Spec, formulas: &mut Vec<Math>) -> Result<&'static str, Failure> {
    let gain = || sub(name("gain"), name("j"));
    let sum = row([sum_to("j", n(spec)), product(gain(), sub(name("x"), name("j")))]);
    let wanted = match spec.drift {
        None => sum,
        Some(_) => minus(sum, name("f")),
    };
    let law = match (&spec.input_gain, &spec.drift) {
        (None, _) => equal(name("u"), wanted),
        (Some(_), None) => equal(name("u"), product(fraction(number(1), name("g")), wanted)),
        (Some(_), Some(_)) => equal(name("u"), fraction(wanted, name("g"))),
    };
    formulas.push(law);
    let next = spec.n + 1;
    let count = minus(number(next), name("j"));
    match Law::of(spec).form {
        Form::Rows { base_inverse, values, .. } if values.is_empty() => {
            let row_j = sub(name("row"), name("j"));
            formulas.push(equal(
                gain(),
                match base_inverse {
                    Some(symbol) => product(factor(symbol, count), row_j),
                    None => row_j,
                },
            ));
            formulas.extend(show::formulas(Subject::Law, spec)?);
            Ok(" The gains in closed form: what parameters decide is computed once.")
        }
        Form::Rows { .. } | Form::Series => {
            series(spec, formulas);
            Ok(" The gains by the Taylor series of mu: [z^i] takes the coefficient of z^i.")
        }
        Form::State => Ok(""),
    }
}

/// The quantity to a power.
fn factor(symbol: Symbol, exponent: Math) -> Math {
    let quantity = mathml::of_poly(&Poly::symbol(symbol));
    let minus = || operator("\u{2212}");
    match symbol.kind {
        Kind::InverseTimeToGo => sup(name("T"), row([minus(), fenced("(", exponent, ")")])),
        Kind::InverseSquare => {
            sup(name("T"), row([minus(), number(2), fenced("(", exponent, ")")]))
        }
        _ => sup(fenced("(", quantity, ")"), exponent),
    }
}

fn series(spec: &Spec, formulas: &mut Vec<Math>) {
    let next = number(spec.n + 1);
    let r1 = || sub(name("r"), number(1));
    let factorial = |of: Math| row([of, operator("!")]);
    let below = |letter: &str| minus(name(letter), number(1));
    let bracket = |letter: &str| fenced("(", below(letter), ")");
    let exponent = row([operator("\u{2212}"), fenced("(", minus(next.clone(), name("j")), ")")]);
    let front = fraction(sup(r1(), exponent), factorial(bracket("j")));
    let coefficient = fenced("[", sup(name("z"), below("i")), "]");
    let power = sup(applied(name("p"), name("z")), below("j"));
    let terms = row([
        mathml::sum(equal(name("i"), name("j")), next.clone()),
        product(sub(name("k"), name("i")), factorial(bracket("i"))),
        coefficient,
        power,
    ]);
    let gain = sub(name("gain"), name("j"));
    let value = row([operator("\u{2212}"), product(front, terms)]);
    formulas.push(row([
        equal(gain, value),
        operator(","),
        words("  "),
        equal(sub(name("k"), next), number(1)),
    ]));
    let share = fraction(sub(name("r"), name("l")), product(r1(), factorial(name("l"))));
    let sum = row([sum_to("l", n(spec)), product(share, sup(name("z"), name("l")))]);
    formulas.push(equal(applied(name("p"), name("z")), sum));
}
