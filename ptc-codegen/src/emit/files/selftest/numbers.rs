//! Numbers and parameters as constants of C.

use crate::code::{Shape, Variable};
use crate::parameter::Precision;
use crate::program::number;

/// Numbers of one precision as constants of C.
pub(super) struct Numbers<'a> {
    pub(super) precision: Precision,
    /// The run-time parameters as they are declared.
    pub(super) declared: &'a [Variable],
}

impl Numbers<'_> {
    pub(super) fn number(&self, value: f64) -> String {
        let (real, suffix) = match self.precision {
            Precision::F32 => ("float", "f"),
            Precision::F64 => ("double", ""),
        };
        let sign = if value.is_sign_negative() { "-" } else { "" };
        match value {
            _ if value.is_nan() => format!("({real})NAN"),
            _ if value.is_infinite() => format!("{sign}({real})INFINITY"),
            _ => format!("{sign}{}{suffix}", number::literal(value.abs(), self.precision)),
        }
    }

    pub(super) fn list(&self, values: &[f64]) -> String {
        values.iter().map(|value| self.number(*value)).collect::<Vec<_>>().join(", ")
    }

    /// The fields of the parameters, by name.
    pub(super) fn parameters(&self, values: &[f64]) -> String {
        let mut rest = values;
        let mut fields = Vec::new();
        for field in self.declared {
            let (own, others) = rest.split_at(field.shape.length().unwrap_or(1).min(rest.len()));
            rest = others;
            let value = match (field.shape, own) {
                (Shape::Count, [count]) => format!("{count}U"),
                (Shape::Reals(_), _) => format!("{{{}}}", self.list(own)),
                _ => self.list(own),
            };
            fields.push(format!(".{} = {value}", field.name));
        }
        if fields.is_empty() { ".none = (char)0".to_owned() } else { fields.join(", ") }
    }
}
