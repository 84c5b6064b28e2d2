//! A sheet in JSON; the help of `show` documents its shape.

use crate::algebra::{Kind, Poly, Symbol};
use crate::check::resolved::follows;
use crate::cli::check::chosen;
use crate::expression::Expression;
use serde_json::{Map, Value, json};

use super::sheet::{Block, Forms, Sheet};

/// One sheet, or those of several outputs as a list.
pub(super) fn render(sheets: &[Sheet]) -> String {
    let mut value = match sheets {
        [sheet] => object(sheet),
        several => {
            let outputs = several.iter().filter(|sheet| !sheet.blocks.is_empty()).map(object);
            json!({ "outputs": outputs.collect::<Vec<_>>() })
        }
    };
    if let Some(design) = sheets.first().and_then(|sheet| sheet.design.as_ref()) {
        value["fingerprint"] = json!(design.spec.fingerprint());
        value["chosen"] = design.choices.iter().map(chosen).collect();
        value["follows"] = follows(&design.spec).iter().map(chosen).collect();
    }
    format!("{value}\n")
}

fn object(sheet: &Sheet) -> Value {
    let object: Map<String, Value> = sheet
        .blocks
        .iter()
        .map(|block| match block {
            Block::Words { key, text, .. } => ((*key).to_owned(), json!(text)),
            Block::Numbers { key, rows } => ((*key).to_owned(), json!(rows)),
            Block::Forms(forms) => (forms.key.to_owned(), list(forms)),
            Block::Derivatives(r) => {
                let form =
                    |(k, r): (usize, &Expression)| json!({"k": k, "expression": r.to_string()});
                ("r".to_owned(), (1..).zip(r).map(form).collect())
            }
        })
        .collect();
    Value::Object(object)
}

fn list(forms: &Forms) -> Value {
    let form = |form: &super::sheet::Form| {
        let index = forms.index.iter().zip(&form.index).map(|(k, v)| ((*k).to_owned(), json!(v)));
        let mut object: Map<String, Value> = index.collect();
        object.insert("terms".to_owned(), terms(&form.poly));
        Value::Object(object)
    };
    forms.forms.iter().map(form).collect()
}

fn terms(poly: &Poly) -> Value {
    poly.terms()
        .map(|(monomial, coefficient)| {
            let exponents: Map<String, Value> =
                monomial.factors().iter().map(|(s, e)| (key(*s), json!(e))).collect();
            json!({"coefficient": coefficient.to_string(), "exponents": exponents})
        })
        .collect()
}

fn key(symbol: Symbol) -> String {
    match symbol.kind {
        // An order says all where there is but one abstract sequence.
        Kind::Derivative | Kind::R => symbol.index.to_string(),
        _ => symbol.text(),
    }
}
