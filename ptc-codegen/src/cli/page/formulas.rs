//! The formulas of a design: plant, mapping, closed forms, law and gains.

mod coupled;

use ptc_codegen::algebra::{Kind, Symbol};
use ptc_codegen::expression::{Expression, Subject as Meaning, Variable, family_form};
use ptc_codegen::family::Family;
use ptc_codegen::law::{Form, Law};
use ptc_codegen::mapping::{Form as Computed, TimeMapping};
use ptc_codegen::model::Model;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::plant::Plant;
use ptc_codegen::request::{Feedback, Spec};

use crate::cli::mathml::{
    self, Math, applied, bold, dot, equal, fenced, fraction, name, named, number, of_expression,
    of_poly, operator, prime, product, relation, row, sub, sub_sup, sup, variable, words,
};
use crate::cli::report::Failure;
use crate::cli::show::{self, Subject};

/// Formulas of one subject.
pub(super) struct Group {
    pub(super) title: &'static str,
    /// What they are, in a sentence or two.
    pub(super) told: String,
    pub(super) formulas: Vec<Math>,
}

/// All formulas of a design with its plant.
pub(super) fn groups(spec: &Spec, plant: &Plant) -> Result<Vec<Group>, Failure> {
    if let Some(coupled) = &spec.coupled {
        return coupled::groups((spec, coupled), plant);
    }
    let plant = match &spec.model {
        Some(model) => model_group((spec, model), plant),
        None => plant_group(spec, plant),
    };
    Ok(vec![plant, mapping(spec), r(spec)?, matrix(spec)?, law(spec)?])
}

fn minus(left: Math, right: Math) -> Math {
    relation(left, "\u{2212}", right)
}

fn elapsed() -> Math {
    variable(Variable::Elapsed)
}

/// The order n, which is a number here.
fn n(spec: &Spec) -> Math {
    number(spec.n)
}

/// The plant with a model, and the chain that the law takes its output to be.
fn model_group((spec, model): (&Spec, &Model), plant: &Plant) -> Group {
    let of = |e: &Expression| of_expression(&model.named(e));
    let rates = |rates: &[Expression], at: &dyn Fn(Math) -> Math| {
        let all = model.states.iter().zip(rates);
        let all = all.map(|(state, rate)| equal(at(dot(name(state.text()))), of(rate)));
        all.collect::<Vec<_>>()
    };
    let mut formulas = rates(&plant.dynamics, &|rate| rate);
    let mut told = "The plant, and the chain of its output that the law brings to rest.".to_owned();
    if plant.dynamics != model.dynamics {
        formulas.extend(rates(&model.dynamics, &|rate| sub(rate, words("model"))));
        told.push_str(" The controller takes other rates than the plant has, those of the model.");
    }
    let coordinates = (1..).zip(&model.coordinates);
    formulas.extend(coordinates.map(|(j, e)| equal(sub(name("x"), number(j)), of(e))));
    let known = [("f", &spec.drift), ("g", &spec.input_gain)];
    formulas.extend(known.into_iter().filter_map(|(f, e)| Some(equal(name(f), of(e.as_ref()?)))));
    told.push_str(&format!(" The u of the law is {}.", model.input));
    Group { title: "Plant", told, formulas }
}

fn plant_group(spec: &Spec, plant: &Plant) -> Group {
    let rate = |index: Math| sub(dot(name("x")), index);
    let state = |j: usize| sub(name("x"), number(j));
    let mut formulas = Vec::new();
    let index = name("j");
    match spec.n {
        1 => {}
        2 => formulas.push(equal(rate(number(1)), state(2))),
        n => formulas.push(row([
            rate(index.clone()),
            operator("="),
            sub(name("x"), relation(index.clone(), "+", number(1))),
            operator(","),
            words("  "),
            index,
            operator("="),
            row([number(1), operator(","), name("\u{2026}"), operator(","), number(n - 1)]),
        ])),
    }
    let control = name("u");
    let last = relation(name("f"), "+", product(name("g"), control));
    formulas.push(equal(rate(n(spec)), last));
    formulas.push(equal(name("f"), of_expression(&plant.f)));
    let own = spec.input_gain.clone().unwrap_or(Expression::integer(1));
    let g = plant.g.as_ref().unwrap_or(&own);
    formulas.push(equal(name("g"), of_expression(g)));
    let told = match &plant.g {
        Some(g) if *g != own => {
            formulas.push(equal(sub(name("g"), words("law")), of_expression(&own)));
            "The controller takes another g than the plant has, the last one.".to_owned()
        }
        _ => "A chain of integrators, moved by f and by u.".to_owned(),
    };
    Group { title: "Plant", told, formulas }
}

fn mapping(spec: &Spec) -> Group {
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

fn r(spec: &Spec) -> Result<Group, Failure> {
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

fn matrix(spec: &Spec) -> Result<Group, Failure> {
    let told = "The partial Bell polynomials of r_k: entry (i, j) of BB_n is B_{i-1,j-1}(r_1, r_2, ...) \
                [III-3], and b_n is the next row.";
    let formulas = show::formulas(Subject::Matrix, spec)?;
    Ok(Group { title: "Matrix BB_n and row b_n", told: told.to_owned(), formulas })
}

fn law(spec: &Spec) -> Result<Group, Failure> {
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
    let quantity = mathml::of_poly(&ptc_codegen::algebra::Poly::symbol(symbol));
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
