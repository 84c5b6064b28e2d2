//! The picture of a comparison: each controller in the worst scenario of the design.

use crate::compare::Comparison;
use crate::parameter::Parameter;
use crate::plot::{Figure, Quantity, Trace};
use crate::simulate::Failure;
use crate::verify::Campaign;

pub(super) fn figure(campaign: &Campaign, comparison: &Comparison) -> Result<Figure, Failure> {
    let spec = &campaign.spec;
    let values = campaign.setting(&comparison.worst).values;
    let deadline = values.get(Parameter::Tau);
    let mut traces = Vec::new();
    for row in comparison.rows.iter().filter(|row| row.figures.is_ok()) {
        let record = comparison.record(campaign, row)?;
        traces.push(Trace {
            label: row.entrant.name.to_owned(),
            deadline,
            stretched: vec![f64::NAN; record.t.len()],
            t: record.t,
            x: record.x,
            u: vec![record.u],
            held: true,
            ..Trace::default()
        });
    }
    Ok(Figure {
        title: format!("{}: {}, compared", spec.name(), spec.order_text()),
        states: Quantity::states(spec),
        inputs: Quantity::inputs(spec),
        traces,
        limits: values.limits(spec),
        ..Figure::default()
    })
}
