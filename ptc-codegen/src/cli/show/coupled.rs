//! `show` of a plant with several outputs: the plant with its decoupling, and the law of each output.

use crate::emit::coupled::law;
use crate::model::Coupled;
use crate::parameter::Parameter;
use crate::request::{Feedback, Spec};

use super::super::report::{Failure, Notice};
use super::args::Subject;
use super::sheet::Sheet;

/// The sheets of a subject, where `one` gives that of a chain.
///
/// # Errors
/// A law that is not a sum of gains, or that of `one`.
pub(super) fn sheets(
    subject: Subject,
    (spec, coupled): (&Spec, &Coupled),
    one: impl Fn(&Spec) -> Result<Sheet, Failure>,
) -> Result<Vec<Sheet>, Failure> {
    let chains: Vec<_> = spec.designs().into_iter().map(chain).collect();
    if subject != Subject::Law {
        // The forms of a lower order are the first of those of a higher one.
        let highest = chains.iter().max_by_key(|chain| chain.n);
        return highest.map(one).into_iter().collect();
    }
    if spec.feedback != Feedback::Linear {
        let message = "the laws of these outputs are not sums of gains";
        let help = "`show matrix` has BB_n, which gives the xi that they see; the head of the emitted code has the laws";
        let notice = Notice { help: Some(help.to_owned()), ..Notice::of(message.to_owned()) };
        return Err(Failure::refused(vec![notice]));
    }
    let mut plant = Sheet { heading: coupled.lines(), blocks: Vec::new(), design: None };
    plant.heading.extend(law(coupled));
    plant.heading.push("where v_i is the u of the chain of output i:".to_owned());
    let mut all = vec![plant];
    let alike = chains.windows(2).all(|pair| own(&pair[0]) == own(&pair[1]));
    for (output, chain) in (1..).zip(&chains).take(if alike { 1 } else { chains.len() }) {
        let mut sheet = one(chain)?;
        let of = if alike { "each output".to_owned() } else { format!("output {output}") };
        sheet.heading.insert(0, format!("{of}, of order n = {}", chain.n));
        all.push(sheet);
    }
    Ok(all)
}

/// The chain of one output, without what its plant does.
fn chain(design: Spec) -> Spec {
    Spec { model: None, drift: None, input_gain: None, ..design }
}

/// Returns the order and the gains, from which the law of a chain is computed.
fn own(chain: &Spec) -> (usize, Vec<Option<String>>) {
    let gain = |i| chain.fixed.get(&Parameter::Gain(i)).map(ToString::to_string);
    (chain.n, (1..=chain.n).map(gain).collect())
}
