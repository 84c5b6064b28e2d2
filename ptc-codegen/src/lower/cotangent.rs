//! th cot(th) for th in (0, pi/2], as a polynomial in z = (2 th/pi)^2.

use crate::algebra::BigRational;
use crate::spec::{Precision, number};

/// Chebyshev interpolation of (th cot(th) - 1)/z on z in [0, 1]; `tools/cotangent.py` computes the
/// digits. The error of the polynomial is below 1e-17 for doubles and 1e-9 for floats, under their
/// rounding; its value at z = 0 is exactly 1.
const DOUBLE: [&str; 16] = [
    "1",
    "-0.8224670334241132251796298",
    "-0.1352904042138891511353634",
    "-0.03179197068724655390115685",
    "-0.007844354338480026265218381",
    "-0.001955067633906800998450036",
    "-0.0004884004503196425541004726",
    "-0.0001220835203284645535345076",
    "-0.00003049467456647585869177472",
    "-0.000007696335899623562375345749",
    "-0.000001770960718378077593529401",
    "-0.0000006748341805449632731463499",
    "8.247582914168543903952877e-8",
    "-0.0000001686793943368802314616409",
    "5.218809974156137767076461e-8",
    "-1.491088565005930170909682e-8",
];

const SINGLE: [&str; 9] = [
    "1",
    "-0.8224670327180559214258792",
    "-0.1352904944127121567446691",
    "-0.03179009535467763703261663",
    "-0.007859068568899917047875992",
    "-0.001899098360419394660155544",
    "-0.0006016576053287794326543454",
    "-7.244605171761672856672724e-9",
    "-0.00009254479389159899052654278",
];

/// The coefficients by ascending power of z.
pub(super) fn coefficients(precision: Precision) -> Vec<BigRational> {
    let digits: &[&str] = match precision {
        Precision::F64 => &DOUBLE,
        Precision::F32 => &SINGLE,
    };
    digits.iter().filter_map(|text| number(text)?.number().cloned()).collect()
}

#[cfg(test)]
mod tests {
    use num_traits::ToPrimitive;

    use super::*;

    fn error(precision: Precision) -> f64 {
        let coefficients: Vec<f64> =
            coefficients(precision).iter().map(|c| c.to_f64().unwrap_or(f64::NAN)).collect();
        (1..=1000)
            .map(|i| {
                let z = f64::from(i) / 1000.0;
                let angle = std::f64::consts::FRAC_PI_2 * z.sqrt();
                let sum = coefficients.iter().rev().fold(0.0, |sum, c| sum * z + c);
                (sum - angle / angle.tan()).abs()
            })
            .fold(0.0, f64::max)
    }

    /// Against the library's tangent, whose own error and that of the angle is a few ulp of 1.
    #[test]
    fn the_polynomials_are_th_cot_th() {
        assert!(error(Precision::F64) < 5e-16, "{}", error(Precision::F64));
        assert!(error(Precision::F32) < 2e-9, "{}", error(Precision::F32));
    }
}
