//! Proofs of `verify`: `drawn`, random loops against dense samples of exact solutions; `spelt`, expressions, reasons
//! and precisions; `sums`, x and u together under a force.

mod drawn;
mod loops;
mod spelt;
mod sums;
use crate::support;

use ptc_codegen::verify::bound::Proof;
use ptc_codegen::verify::{self, Campaign};

/// Returns true for each objective that is proved.
fn proved(text: &str) -> Vec<bool> {
    verify::bound::proved(&campaign(text)).iter().map(Proof::is_proved).collect()
}

fn campaign(text: &str) -> Campaign {
    let (spec, plant) = support::design(text);
    let read = verify::read(&support::entries(text), &spec, &plant);
    read.unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"))
}
