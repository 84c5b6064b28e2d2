//! The expansions of a mapping that the user wrote down: in r_k, with r_k as expressions.

use crate::algebra::Poly;
use crate::expansion::Expanded;
use crate::expression::{Expression, Subject as Given};
use crate::internal::fault;
use crate::law::Law;
use crate::mapping::{Custom, Form, Mapping};
use crate::parameter::Parameter;
use crate::request::Spec;

use super::super::engine::{Engine, Part};
use super::super::report::{Failure, Notice};
use super::args::Subject;
use super::forms::{bell, fixed_values, matrix};
use super::sheet::{Block, Sheet};
use super::{abstracts, law};

/// Builds the output of `show` for the mapping of `spec`.
///
/// # Errors
/// r_k take too much effort, or the engine gives no answer.
pub(super) fn sheet(subject: Subject, spec: &Spec, engine: Engine) -> Result<Sheet, Failure> {
    let custom = spec.custom().unwrap_or_else(|| fault("a mapping without a form"));
    let r = derivatives(spec, custom, engine)?;
    let mut sheet = Sheet::new(&given(custom));
    sheet.heading.push(match &custom.form {
        Form::Kappa(kappa) => format!("kappa = {}, T = tau - dt", kappa.form),
        Form::Complement(_) => "t = kappa(dt), found by an iteration".to_owned(),
    });
    sheet.heading.extend(fixed_values(spec));
    match subject {
        Subject::Bell => sheet.forms(bell(abstracts::bell(engine, spec.n)?)),
        Subject::Matrix => matrix(&mut sheet, abstracts::bell(engine, spec.n)?),
        Subject::Law => {
            let free = Mapping::free(spec.n);
            let forms = engine.expand(spec.n, &free, Part::All)?;
            let law = Law::new(spec.n, &free, Some(&forms));
            law::write(&mut sheet, Some(spec), &law, &forms.r, Poly::clone);
        }
        Subject::SmallR | Subject::BigR | Subject::Tables => {}
    }
    sheet.blocks.push(Block::Derivatives(r));
    Ok(sheet)
}

fn given(custom: &Custom) -> String {
    let name = if custom.subject == Given::Mu { "mu(t)" } else { "kappa(dt)" };
    format!("{name} = {}", custom.given)
}

/// r_1, ..., r_n, with the parameters that have a value.
fn derivatives(spec: &Spec, custom: &Custom, engine: Engine) -> Result<Vec<Expression>, Failure> {
    let r = match engine.prepare(&mut spec.clone())? {
        Some(Expanded::Custom(r)) => Some(r),
        _ => custom.r(spec.n),
    };
    let Some(r) = r else {
        let message = format!("r_1..r_{} of this mapping are too large to be written out", spec.n);
        let help = "take a smaller n, or fewer functions and fractions in each other";
        return Err(Failure::refused(vec![Notice {
            help: Some(help.to_owned()),
            ..Notice::of(message)
        }]));
    };
    let number = |p: Parameter| spec.fixed.get(&p)?.number().cloned();
    Ok(r.iter().map(|r| r.known(&number)).collect())
}
