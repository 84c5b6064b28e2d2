//! Ranges from which the harness draws each parameter.

use super::super::Controller;
use super::{literal, rounded};
use crate::parameter::{Parameter, Precision};

/// A value that the harness draws, as macros NAME_MIN and NAME_MAX.
pub(super) struct Range {
    /// The macros' name up to `_MIN` and `_MAX`.
    pub(super) stem: String,
    pub(super) least: String,
    pub(super) greatest: String,
    /// True if a user may give other values; false where the design fixes the value.
    pub(super) open: bool,
}

pub(super) fn stem(prefix: &str, parameter: Parameter) -> String {
    format!("{prefix}_{}", parameter.spelling().to_uppercase())
}

/// Range of each parameter in finite mode. Those of time are included even where they are fixed, as time itself is
/// drawn around them.
pub(super) fn ranges(controller: &Controller<'_>, prefix: &str) -> Vec<Range> {
    let spec = controller.spec();
    let own = |p: Parameter| match (spec.fixed.get(&p), spec.bounds.get(&p)) {
        (Some(fixed), _) => Some((rounded(fixed, spec), rounded(fixed, spec))),
        (None, Some((least, greatest))) => Some((rounded(least, spec), rounded(greatest, spec))),
        (None, None) => None,
    };
    let tau = own(Parameter::Tau).unwrap_or((1.0, 1.0));
    // The gains of order 6 stay in the range of f32 down to here.
    let share = if spec.precision == Precision::F32 { 16.0 } else { 64.0 };
    let greatest = |p: Parameter| {
        let limited = controller.report.greatest.as_ref().filter(|(of, _)| *of == p);
        limited.map_or(f64::INFINITY, |(_, greatest)| rounded(greatest, spec))
    };
    let default = |p: Parameter| match p {
        Parameter::Tau | Parameter::A | Parameter::Named(_) => (1.0, 1.0),
        Parameter::StartTime => (0.0, 0.0),
        Parameter::Eps => {
            let eps = (tau.0 / share).min(greatest(p));
            (eps, eps)
        }
        Parameter::UMax => (10.0, 10.0),
        Parameter::UMin => (-10.0, -10.0),
        Parameter::M => (1.5, 1.5),
        Parameter::Start => (0.25, 0.25),
        #[allow(clippy::cast_precision_loss)]
        Parameter::Rate(i) => (i as f64 - 0.5, i as f64 - 0.5),
        Parameter::Gain(_) => (-100.0, 100.0),
        Parameter::Samples | Parameter::SampleTime | Parameter::Deadbeat => (1.0, 1.0),
    };
    let of_time =
        |p: &Parameter| matches!(p, Parameter::Tau | Parameter::StartTime | Parameter::Eps);
    let parameters = spec.parameters().into_iter();
    let range = |p: Parameter| {
        let (least, greatest) = own(p).unwrap_or_else(|| default(p));
        Range {
            stem: stem(prefix, p),
            least: literal(least, spec.precision),
            greatest: literal(greatest, spec.precision),
            open: !spec.fixed.contains_key(&p),
        }
    };
    parameters.filter(|p| of_time(p) || !spec.fixed.contains_key(p)).map(range).collect()
}
