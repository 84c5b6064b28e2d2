//! The mathematics in the head of an emitted file: the mapping, its closed forms and the law.

use super::Controller;
use super::declared::linear;
use crate::algebra::{self, Kind, Poly, Symbol};
use crate::collect::set;
use crate::expansion::{self, Expanded};
use crate::expression::{Expression, Subject};
use crate::family::FamilyInfo;
use crate::internal::fault;
use crate::law::{Form as LawForm, Law};
use crate::mapping::{Custom, Form, Mapping, TimeMapping};
use crate::model::Coupled;
use crate::request::{Feedback, Reference, Spec};

/// Order up to which the head shows the closed forms in full; beyond it they fill pages.
const SHOWN: usize = 6;

/// The polynomial in `row_j` and `xi_i`.
const SERIES: &str =
    "  p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i";

/// The time mapping and its closed forms.
pub(in crate::emit) fn mapping(controller: &Controller<'_>) -> Vec<String> {
    let spec = controller.spec();
    let head = [
        String::new(),
        "Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is the stretched time since t0:".to_owned(),
    ];
    let own = match &spec.time_mapping {
        TimeMapping::Family { family, rates } => {
            closed_forms(controller, family.info(), &Mapping::of(*family, *rates))
        }
        TimeMapping::Custom(custom) => as_given(custom, controller),
    };
    head.into_iter().chain(own).collect()
}

/// A user-defined mapping.
fn as_given(custom: &Custom, controller: &Controller<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    let given = if custom.subject == Subject::Mu { "mu(t) " } else { "kappa(dt)" };
    lines.push(format!("  {given} = {}", custom.given));
    match &custom.form {
        Form::Complement(form) => {
            lines.push(format!("  tau - mu(t) = {form}"));
            lines
                .push("  kappa = the root t of tau - mu(t) = T, by a bounded iteration".to_owned());
        }
        Form::Kappa(kappa) => {
            lines.push(format!("  kappa = {}", kappa.form));
            lines.push(format!("  r_1 = T*({})", kappa.rate));
        }
    }
    match (&controller.report.expanded, controller.spec().engine) {
        (Some(Expanded::Custom(r)), Some(engine)) => {
            lines.push(format!(
                "Derivatives r_k = mu^(k)(kappa(Dt)), expanded by the engine {engine}:"
            ));
            let shown = r.iter().take(SHOWN).enumerate();
            lines.extend(shown.map(|(index, r)| format!("  r_{} = {r}", index + 1)));
        }
        _ if matches!(controller.law.form, LawForm::Rows { .. }) => lines.push(
            "r_k/r_1 are polynomials in z and 1/F, from which come the gains below.".to_owned(),
        ),
        _ => lines.push(
            "r_k and BB_n are computed from the Taylor series of mu at each call.".to_owned(),
        ),
    }
    lines
}

/// The closed forms of a family.
fn closed_forms(controller: &Controller<'_>, info: &FamilyInfo, ring: &Mapping) -> Vec<String> {
    let spec = controller.spec();
    let shown = spec.n.min(SHOWN);
    let mut lines =
        vec![format!("  mu(t)     = {}", info.mu), format!("  kappa(Dt) = {}", info.kappa)];
    if info.atoms != "T = time-to-go" {
        lines.push(format!("  in terms of {}", info.atoms));
    }
    lines.push("Derivatives r_k = mu^(k)(kappa(Dt)):".to_owned());
    lines.push(format!("  r_k = {}", info.r));
    let forms = controller.report.expanded.as_ref().and_then(Expanded::family);
    let r = forms.map_or_else(|| expansion::r(ring, shown), |forms| forms.r[..shown].to_vec());
    for (index, r) in r.iter().enumerate() {
        lines.push(format!("  r_{} = {}", index + 1, algebra::text(r)));
    }
    lines.push(
        "Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:"
            .to_owned(),
    );
    let table = match forms {
        Some(forms) => forms.bell[..=shown].to_vec(),
        None if info.family.is_iterated() => expansion::bell::bell_table(shown),
        None => expansion::table(ring, shown),
    };
    for (i, row) in table.iter().enumerate() {
        let columns = if i == shown { &row[..i] } else { &row[..] };
        for (j, entry) in columns.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
            lines.push(format!("  B_{{{i},{j}}} = {}", algebra::text(entry)));
        }
    }
    if shown < spec.n {
        lines.push(format!(
            "  (to order {shown}; all of them: ptc-codegen show matrix --n {} --mu {})",
            spec.n, info.name
        ));
    }
    lines
}

/// The law pi0 in words.
pub(super) fn pi0(spec: &Spec) -> String {
    match &spec.feedback {
        Feedback::Linear => linear(spec.n),
        Feedback::Expression(law) => spec.law_named(law).to_string(),
        Feedback::Extern => "a user-defined function of xi and t_kappa".to_owned(),
        Feedback::LeastEnergy(_) => fault("pi0 of a table of gains"),
    }
}

/// Describes f and g, and x where it is not the state itself.
pub(super) fn of_plant(spec: &Spec) -> Vec<String> {
    let text = |e: &Expression| match &spec.model {
        Some(model) => model.text(e),
        None => e.to_string(),
    };
    let coordinates = spec.model.iter().flat_map(|model| &model.coordinates);
    let x = (1..).zip(coordinates).map(|(j, e)| format!("  x_{j} = {}", text(e)));
    let f = spec.drift.iter().map(|f| format!("  f = {}", text(f)));
    let own = spec.axes.as_ref().is_some_and(|axes| !axes.input_gains.is_empty());
    let g = spec.input_gain.iter().filter(|_| !own).map(|g| format!("  g = {}", text(g)));
    x.chain(f).chain(g).collect()
}

/// Describes the reference, and the tracking error that the law sees.
pub(super) fn of_reference(spec: &Spec) -> Vec<String> {
    let n = spec.n;
    match &spec.reference {
        None => Vec::new(),
        Some(Reference::Input) => {
            vec![format!(
                "  e_i = x_i - r^(i-1), where r^(0)..r^({n}) are the reference and its derivatives, r[0]..r[{n}] of each call"
            )]
        }
        Some(Reference::Known(derivatives)) => {
            let rates =
                (1..=n).filter_map(|i| Some(format!("  r^({i}) = {}", spec.derivative(i)?)));
            let head = format!("  e_i = x_i - r^(i-1), with the reference r = {}", derivatives[0]);
            [head].into_iter().chain(rates).collect()
        }
    }
}

/// Theorem 1, specialised.
pub(in crate::emit) fn law(controller: &Controller<'_>) -> Vec<String> {
    let spec = controller.spec();
    let rate = match (spec.references(), spec.derivative(spec.n)) {
        (0, None) => String::new(),
        _ => format!(" + r^({})", spec.n),
    };
    let less = if spec.drift.is_some() { " - f" } else { "" };
    let less = format!("{rate}{less}");
    let x = if spec.reference.is_some() { "e" } else { "x" };
    let of_axes = spec.axes.iter().any(|axes| !axes.input_gains.is_empty());
    let over_gain = if spec.input_gain.is_some() || of_axes { "/g" } else { "" };
    if let Some(coupled) = &spec.coupled {
        return of_outputs(controller, coupled);
    }
    let mut lines = vec![
        String::new(),
        format!("Law, Theorem 1, with xi = BB_n {x} and t_kappa = kappa(Dt) + t0:"),
        match less.as_str() {
            "" => format!("  u = kappa'^n (pi0(xi, t_kappa) - b_n^T {x}){over_gain}"),
            _ => format!("  u = (kappa'^n (pi0(xi, t_kappa) - b_n^T {x}){less}){over_gain}"),
        },
        format!("  pi0 = {}", pi0(spec)),
    ];
    lines.extend(of_reference(spec));
    lines.extend(of_plant(spec));
    if spec.feedback == Feedback::Linear {
        lines.push(match (less.as_str(), over_gain) {
            ("", "") => format!("  u = sum_j gain_j {x}_j"),
            _ => format!("  u = (sum_j gain_j {x}_j{less}){over_gain}"),
        });
    }
    lines.extend(forms(spec, controller.law, x));
    lines
}

/// The law of each output of a plant with several inputs, and u from it.
fn of_outputs(controller: &Controller<'_>, coupled: &Coupled) -> Vec<String> {
    let spec = controller.spec();
    let linear_law = spec.feedback == Feedback::Linear;
    let (x, rate) = if spec.reference.is_some() { ("e", " + r^(n)") } else { ("x", "") };
    let v = format!("  v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T {x}){rate}");
    let mut lines = vec![
        String::new(),
        format!("Law of each output, Theorem 1, with xi = BB_n {x} and t_kappa = kappa(Dt) + t0:"),
        if linear_law { format!("{v} = sum_j gain_j {x}_j{rate}") } else { v },
    ];
    lines.extend(super::coupled::references(spec));
    let laws = (1..).zip(spec.laws());
    if spec.feedback == Feedback::Extern {
        let of = match spec.laws_at_once() {
            Some(_) => {
                "  pi0 of all v_i: a user-defined function of the xi of all outputs, t_kappa and kappa'"
            }
            None => "  pi0 of v_1: a user-defined function of xi and t_kappa",
        };
        lines.push(of.to_owned());
    }
    lines.extend(laws.map(|(i, law)| format!("  pi0 of v_{i} = {}", spec.law_named(law))));
    let mut orders = coupled.orders();
    orders.sort_unstable();
    orders.dedup();
    for order in orders.iter().copied() {
        let law = match order == controller.law.n {
            true => controller.law.clone(),
            false => Law::of(&Spec { n: order, ..spec.clone() }),
        };
        if orders.len() > 1 {
            lines.push(format!("Order n = {order}:"));
        }
        if linear_law {
            lines.push(format!("  pi0 = {}", linear(order)));
        }
        lines.extend(forms(spec, &law, x));
    }
    lines.extend(super::coupled::law(coupled));
    lines
}

/// The gains as they are computed.
fn forms(spec: &Spec, law: &Law, x: &str) -> Vec<String> {
    let mut lines = Vec::new();
    match &law.form {
        LawForm::Rows { base_inverse, rows, values } => {
            let base = base_inverse.map(|s| format!("{}^(n+1-j) ", s.text())).unwrap_or_default();
            lines.push(format!("  gain_j = {base}row_j"));
            let text = |poly: &Poly| algebra::named_text(poly, &|symbol| named(symbol, values));
            let rate = text(&law.rate);
            let rate = if rate.contains(['*', '^', '/']) { format!("({rate})") } else { rate };
            lines.push(format!("  K1, K2, ...: K_i = k_i/{rate}^(n+1-i)"));
            for (j, row) in rows.iter().take(SHOWN).enumerate() {
                lines.push(format!("  row_{} = {}", j + 1, text(row)));
            }
            lines.extend(definitions(*base_inverse, rows, values));
            if rows.len() > SHOWN {
                lines.push(format!(
                    "  (the first {SHOWN}; all of them: ptc-codegen show law --n {} --mu {})",
                    law.n,
                    spec.mapping_name()
                ));
            }
        }
        LawForm::Series => {
            lines.push("  gain_j = r_1^-(n+1-j) row_j".to_owned());
            lines.push(
                "  row_j = -1/(j-1)! sum_{i=j..n+1} k_i (i-1)! [z^(i-1)] p(z)^(j-1), with k_(n+1) = 1"
                    .to_owned(),
            );
            lines.push(SERIES.to_owned());
        }
        LawForm::State => {
            lines
                .push(format!("  xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) {x}_j"));
            lines.push(SERIES.to_owned());
        }
    }
    lines
}

/// A symbol as it is written: a parameter of a user-defined mapping by its name.
fn named(symbol: Symbol, values: &[(Symbol, Expression)]) -> String {
    match values.iter().find(|(own, _)| *own == symbol && own.kind == Kind::Kernel) {
        Some((_, value)) if value.height() > 0 => format!("({value})"),
        Some((_, value)) => value.to_string(),
        None => symbol.text(),
    }
}

/// Definitions of the quantities in the rows that are no atoms.
fn definitions(
    base_inverse: Option<Symbol>,
    rows: &[Poly],
    values: &[(Symbol, Expression)],
) -> Vec<String> {
    let used = set(rows.iter().flat_map(Poly::symbols).chain(base_inverse));
    let definition = |s: Symbol| {
        let own = values.iter().find(|(own, _)| *own == s && s.kind != Kind::Kernel);
        let meaning = match own {
            Some((_, value)) => value.to_string(),
            None => s.definition()?.to_owned(),
        };
        Some(format!("  {} = {meaning}", s.text()))
    };
    used.into_iter().filter_map(definition).collect()
}
