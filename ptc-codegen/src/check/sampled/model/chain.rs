//! The chain of one output, whose loop is known.

use num_traits::{ToPrimitive, Zero};

use super::Lacking;
use crate::algebra::BigRational;
use crate::diagnostic::digits;
use crate::internal::fault;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Clock, PlantBounds, Promises, Spec};

/// Squares of the samples of several outputs, times their orders, that are looked at: seconds.
const SAMPLES: f64 = 5e6;

/// # Errors
/// Fails if the loops of all these outputs together have more samples than are looked at in seconds.
pub(super) fn few_samples(designs: &[Spec]) -> Result<(), Lacking> {
    let number =
        |value: Option<&Fixed>| value.and_then(Fixed::number).and_then(ToPrimitive::to_f64);
    let all = designs.iter().map(|own| {
        let tau = number(own.fixed.get(&Parameter::Tau)).unwrap_or(0.0);
        let samples = tau / number(own.promises.sample_time.as_ref()).unwrap_or(f64::INFINITY);
        (samples, samples * samples * own.n.to_f64().unwrap_or(f64::INFINITY))
    });
    let (samples, work) =
        all.fold((0.0_f64, 0.0), |(most, sum), (samples, work)| (most.max(samples), sum + work));
    if work <= SAMPLES {
        return Ok(());
    }
    let (samples, count) = (digits(samples.round()), designs.len());
    Err(Lacking::Proof(format!(
        "{samples} samples are more than it looks at with {count} outputs: a longer sample_time, or a shorter tau, may bound it"
    )))
}

/// The chain that w moves, under a force that is any signal within a bound.
pub(super) fn chain(spec: &Spec, sensors: &[f64], force: f64) -> Spec {
    // Bounds that are not finite are refused where they arise.
    let exact = |value: f64| {
        BigRational::from_float(value).unwrap_or_else(|| fault("a bound that is not finite"))
    };
    let fixed = |value: f64| Fixed::Number { value: exact(value), text: value.to_string() };
    let zero = BigRational::zero;
    let mut chain = Spec {
        model: None,
        drift: None,
        input_gain: None,
        reference: None,
        promises: Promises {
            noise: sensors.iter().copied().map(fixed).collect(),
            noise_rms: Vec::new(),
            sensor_step: Vec::new(),
            u_step: None,
            g_error: Vec::new(),
            x_max: Vec::new(),
            plant: (force > 0.0).then(|| PlantBounds::Bounded {
                middle: zero(),
                constant: zero(),
                varying: exact(force),
                gain: None,
            }),
            ..spec.promises.clone()
        },
        ..spec.clone()
    };
    // u is clipped, not w.
    chain.remove_limits();
    if let Clock::Samples(sampled) = &mut chain.clock {
        sampled.measured = spec.n;
    }
    chain
}
