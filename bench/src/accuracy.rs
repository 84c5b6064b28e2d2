//! `accuracy`: the worst scaled error of each family and order against the reference vectors.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::case::{PRECISIONS, precision_name};
use crate::failure::Result;
use crate::tools::scratch;
use crate::{c, evaluate, vectors};

/// The worst of one family, order and precision.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Accuracy {
    pub(crate) family: String,
    pub(crate) n: usize,
    pub(crate) precision: String,
    /// Worst |u - reference|/scale; `None` if a result is not finite.
    pub(crate) worst: Option<f64>,
    /// T/tau where it is the worst.
    pub(crate) at: f64,
    pub(crate) points: usize,
    /// The smallest T/tau of the points.
    pub(crate) nearest: f64,
}

/// Evaluates all vectors with generated C.
pub(crate) fn measure() -> Result<Vec<Accuracy>> {
    let root = scratch("accuracy")?;
    let mut all = Vec::new();
    for precision in PRECISIONS {
        let vectors = vectors::read(precision)?;
        let references: Vec<_> = vectors.iter().collect();
        let folder = root.join(precision_name(precision));
        std::fs::create_dir_all(&folder)?;
        let (cases, indices) = evaluate::cases_for(&references, precision)?;
        c::compile(&cases, &folder)?;
        let driver = evaluate::driver(&cases, evaluate::MAIN);
        let program = c::link(&driver, &cases, &[], &folder)?;
        let lines: String =
            vectors.iter().zip(&indices).map(|(v, index)| evaluate::line(*index, v)).collect();
        let values = evaluate::evaluate(&program, &lines)?;
        let mut worst: BTreeMap<_, Accuracy> = BTreeMap::new();
        for (vector, u) in vectors.iter().zip(values) {
            let family = vector.family()?;
            let entry = worst.entry((family, vector.n)).or_insert_with(|| Accuracy {
                family: family.name().to_owned(),
                n: vector.n,
                precision: precision_name(precision).to_owned(),
                worst: Some(0.0),
                at: 1.0,
                points: 0,
                nearest: 1.0,
            });
            let error = vector.error(u)?;
            if entry.worst.is_some_and(|worst| error > worst) {
                entry.worst = error.is_finite().then_some(error);
                entry.at = vector.time_to_go();
            }
            entry.points += 1;
            entry.nearest = entry.nearest.min(vector.time_to_go());
        }
        all.extend(worst.into_values());
    }
    Ok(all)
}
