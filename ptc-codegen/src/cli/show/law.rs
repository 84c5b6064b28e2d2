//! `show law`: the linear law with the gains as they are computed.

use crate::algebra::{Kind, Poly, Symbol};
use crate::expression::Expression;
use crate::internal::fault;
use crate::law::{Form, Law};
use crate::model::Model;
use crate::request::Spec;

use super::sheet::{Block, Forms, Sheet};

/// Writes the law of a mapping with these r_k; `fix` puts in the parameters whose values are known.
/// The model of the plant comes from `spec`, where there is a design.
pub(super) fn write(
    sheet: &mut Sheet,
    spec: Option<&Spec>,
    law: &Law,
    r: &[Poly],
    fix: impl Fn(&Poly) -> Poly,
) {
    let n = law.n;
    let pi0 = "pi0 = -(k1*xi_1 + ... + kn*xi_n)";
    match spec.and_then(|spec| Some((spec, spec.model.as_ref()?))) {
        Some((spec, model)) => {
            sheet.heading.push(pi0.to_owned());
            sheet.heading.extend(of_model(spec, model));
        }
        None => sheet.heading.push(format!("{pi0}, g = 1")),
    }
    if spec.is_some_and(|spec| spec.reference.is_some()) {
        let error = "x stands for the tracking error, x_j - r^(j-1); r^(n) is added to u";
        sheet.heading.push(error.to_owned());
    }
    match &law.form {
        Form::Rows { base_inverse, rows, .. } => {
            let rows: Vec<Poly> = rows.iter().map(&fix).collect();
            let tick = rows.iter().flat_map(Poly::symbols).chain(*base_inverse);
            let tick: std::collections::BTreeSet<Symbol> = tick.collect();
            let told = |s: Symbol| Some(format!("{} = {}", s.text(), s.definition()?));
            sheet.heading.extend(tick.into_iter().filter_map(told));
            sheet.blocks.push(factored(n, *base_inverse));
            let gains = scaled_gains(law).iter().map(&fix).collect();
            sheet.forms(Forms::counted("K", &["i"], gains));
            let mut rows = Forms::counted("row", &["j"], rows);
            rows.latex = "c";
            sheet.forms(rows);
        }
        Form::Series | Form::State => {
            sheet.blocks.push(series(n));
            let r = r.iter().map(&fix).collect();
            sheet.forms(Forms::counted("r", &["k"], r));
        }
    }
}

/// The plant, its chain, and what u of the chain stands for.
fn of_model(spec: &Spec, model: &Model) -> Vec<String> {
    let of = |name: &str, e: &Expression| format!("{name} = {}", model.text(e));
    let mut lines = model.lines();
    lines.extend((1..).zip(&model.coordinates).map(|(j, e)| of(&format!("x_{j}"), e)));
    lines.extend(spec.drift.iter().map(|f| of("f", f)));
    lines.extend(spec.input_gain.iter().map(|g| of("g", g)));
    let less = if spec.drift.is_some() { "(u - f)" } else { "u" };
    let over = if spec.input_gain.is_some() { "/g" } else { "" };
    lines.push(format!("{} = {less}{over}, with u of the chain:", model.input));
    lines
}

/// K_i = k_i rate^-(n+1-i).
fn scaled_gains(law: &Law) -> Vec<Poly> {
    // The rate of a mapping is a single term, so it has an inverse.
    let inverse = law.rate.inverse().unwrap_or_else(|| fault("the rate has no inverse"));
    let power = |i: usize| inverse.pow(u32::try_from(law.n + 1 - i).unwrap_or(u32::MAX));
    (1..=law.n).map(|i| Poly::symbol(Symbol::indexed(Kind::Gain, i)).times(&power(i))).collect()
}

fn factored(n: usize, base_inverse: Option<Symbol>) -> Block {
    let next = n + 1;
    let (text, latex) = match base_inverse {
        Some(symbol) => (
            format!("{}^({next}-j) * row_j", symbol.text()),
            match symbol.latex().strip_suffix("^{-1}") {
                Some(base) => format!(r"\frac{{c_j x_j}}{{{base}^{{{next}-j}}}}"),
                None => format!(r"\left({}\right)^{{{next}-j}} c_j x_j", symbol.latex()),
            },
        ),
        None => ("row_j".to_owned(), "c_j x_j".to_owned()),
    };
    Block::Words {
        key: "law",
        text: format!("u = sum_{{j=1..{n}}} gain_j x_j, gain_j = {text}"),
        latex: format!(r"u = \sum_{{j=1}}^{{{n}}} {latex}"),
    }
}

fn series(n: usize) -> Block {
    let next = n + 1;
    Block::Words {
        key: "law",
        text: format!(
            "u = sum_{{j=1..{n}}} gain_j x_j,\n\
             gain_j = -r1^-({next}-j) / (j-1)! * sum_{{i=j..{next}}} k_i (i-1)! [z^(i-1)] p(z)^(j-1), k{next} = 1,\n\
             where [z^i] takes the coefficient of z^i, and\n\
             p(z) = sum_{{l=1..{n}}} r_l/(r1 l!) z^l is the normalised Taylor series of mu"
        ),
        latex: format!(
            r"\begin{{aligned}}
    u &= \sum_{{j=1}}^{{{n}}} \mathrm{{gain}}_j x_j, \\
    \mathrm{{gain}}_j &= -\frac{{r_1^{{-({next}-j)}}}}{{(j-1)!}} \sum_{{i=j}}^{{{next}}} k_i (i-1)! [z^{{i-1}}] p(z)^{{j-1}}, \quad k_{{{next}}} = 1, \\
    p(z) &= \sum_{{l=1}}^{{{n}}} \frac{{r_l}}{{r_1 l!}} z^l
  \end{{aligned}}"
        ),
    }
}
