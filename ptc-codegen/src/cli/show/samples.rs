//! `show law` with a clock in samples: the law as it is emitted, with its numbers where they are known.

use crate::algebra::Poly;
use crate::check::resolved::Resolved;
use crate::emit::sampled_law;
use crate::request::Spec;
use crate::samples::Numbers;

use super::sheet::{Block, Forms, Sheet};

/// The law of a resolved design.
pub(super) fn sheet(design: &Resolved) -> Sheet {
    let spec = &design.spec;
    let mut sheet = Sheet { heading: sampled_law(spec), blocks: Vec::new(), design: None };
    if spec.sampled().is_some_and(|own| own.delay.inputs() > 0) {
        let behind = "Behind the states x holds the inputs under way, the latest first.";
        sheet.heading.push(behind.to_owned());
    }
    let Some(numbers) = Numbers::of(spec) else {
        let text = "u = -K_M x, with M samples to go".to_owned();
        sheet.blocks.push(Block::Words { key: "law", text, latex: "u = -K_M x".to_owned() });
        return sheet;
    };
    sheet.blocks.push(formula(spec, numbers.rows.len()));
    sheet.blocks.push(Block::Numbers { key: "S", rows: numbers.s });
    let rows = numbers.rows.into_iter().map(Poly::constant).collect();
    sheet.forms(Forms { latex: "c", ..Forms::counted("row", &["j"], rows) });
    sheet
}

/// u of a loop of order m, with c_j for row_j in LaTeX. The heading says what w of a model and the drift are.
fn formula(spec: &Spec, m: usize) -> Block {
    let is_linear = spec.sampled().is_some_and(|sampled| sampled.linear.is_some());
    let input = if spec.model_in_samples().is_some() { "w" } else { "u" };
    let (left, power, drift) = match is_linear {
        true => (input.to_owned(), "", " less the drift of z"),
        false => (format!("{input} h^{m}"), " h^(j-1)", ""),
    };
    let product = match m {
        1 => "M".to_owned(),
        _ => format!("((M-j+1)...(M-{}))", m - 1),
    };
    let text = format!("{left} = sum_{{j=1..{m}}} row_j z_j{power}/{product}{drift}, z = S x");
    let (left, power, drift) = match is_linear {
        true => (input.to_owned(), "", r" - \text{drift of } z"),
        false => (format!("{input}\\,h^{{{m}}}"), " h^{j-1}", ""),
    };
    let product = match m {
        1 => "M".to_owned(),
        _ => format!(r"(M-j+1) \cdots (M-{})", m - 1),
    };
    let latex = format!(
        r"{left} = \sum_{{j=1}}^{{{m}}} \frac{{c_j z_j{power}}}{{{product}}}{drift}, \quad z = S x"
    );
    Block::Words { key: "law", text, latex }
}
