//! `list`: the families of time mappings and the parameters of a controller, or the catalogue.

use std::fmt::Write;

use crate::family::{FAMILIES, FamilyInfo};
use crate::parameter::Parameter;
use crate::request::Spec;
use clap::Args;
use serde_json::{Value, json};

use super::catalogue;
use super::flags::ListFormat;

pub(crate) const EXAMPLES: &str = "\
Examples:
  ptc-codegen list
  ptc-codegen list --format json
  ptc-codegen list --catalogue    published controllers, for `new --from`";

/// The flags of `list`.
#[derive(Debug, Args)]
pub(crate) struct List {
    /// List published controllers in place of families
    #[arg(long)]
    pub(crate) catalogue: bool,
    /// Notation
    #[arg(long, value_enum, default_value = "text")]
    pub(crate) format: ListFormat,
}

/// Row of `list` for a parameter.
struct Line {
    key: String,
    unit: &'static str,
    domain: &'static str,
    meaning: &'static str,
}

/// Runs `list`.
pub(crate) fn list(request: &List) -> String {
    match (request.catalogue, request.format) {
        (false, ListFormat::Text) => text(),
        (false, ListFormat::Json) => format!("{}\n", json()),
        (true, ListFormat::Text) => catalogue::text(),
        (true, ListFormat::Json) => format!("{}\n", catalogue::json()),
    }
}

/// The parameters of a controller of `info`'s family: its own, and those that all have.
fn parameters(info: &FamilyInfo) -> (Vec<Line>, Vec<Line>) {
    let (own, common) = Spec::new(1, info.family)
        .parameters()
        .into_iter()
        .filter(|p| p.index().unwrap_or(0) == 0)
        .partition::<Vec<_>, _>(|p| info.parameters.contains(&p.key()));
    let line = |p: Parameter| Line {
        key: p.key().to_owned(),
        unit: p.unit(),
        domain: p.domain().text(),
        meaning: p.meaning(),
    };
    (own.into_iter().map(line).collect(), common.into_iter().map(line).collect())
}

fn text() -> String {
    let mut out = String::from(
        "Families of time mappings: t is the stretched time since t0, Dt the time since t0,\n\
         T = tau - Dt the time-to-go.\n",
    );
    for info in &FAMILIES {
        let _ = write!(
            out,
            "\n{}\n  mu(t)      = {}\n  kappa(Dt)  = {}\n  r_k        = {}\n  atoms:       {}\n  \
             decay rate of mu': {}\n  parameters:\n",
            info.name, info.mu, info.kappa, info.r, info.atoms, info.decay_rate
        );
        table(&mut out, &parameters(info).0);
    }
    out.push_str("\nParameters of every controller\n");
    if let Some(info) = FAMILIES.first() {
        table(&mut out, &parameters(info).1);
    }
    out
}

fn table(out: &mut String, lines: &[Line]) {
    for Line { key, unit, domain, meaning } in lines {
        let unit = format!("[{unit}]");
        let _ = writeln!(out, "    {key:<6} {unit:<12} {domain:<21} {meaning}");
    }
}

fn json() -> Value {
    let lines = |lines: Vec<Line>| -> Vec<Value> {
        lines
            .iter()
            .map(
                |l| json!({"key": l.key, "unit": l.unit, "domain": l.domain, "meaning": l.meaning}),
            )
            .collect()
    };
    let families: Vec<_> = FAMILIES
        .iter()
        .map(|info| {
            json!({
                "name": info.name,
                "mu": info.mu,
                "kappa": info.kappa,
                "r": info.r,
                "atoms": info.atoms,
                "decay_rate": info.decay_rate,
                "parameters": lines(parameters(info).0),
            })
        })
        .collect();
    let common = FAMILIES.first().map(|info| lines(parameters(info).1)).unwrap_or_default();
    json!({"families": families, "parameters": common})
}
