//! Gains at 40 digits.

use ptc_codegen::code::Instance;
use serde_json::Value;

use super::code;

/// Error of a gain in parts of the largest of a row, a few roundings.
const GAIN: f64 = 1e-14;

/// Gains at 40 digits: `python3 tools/samples.py gains COMMAND`.
const REFERENCE: &str = include_str!("../../../../tests/data/sampled_plants.json");

fn text(value: &Value) -> &str {
    value.as_str().expect("text")
}

#[test]
fn gains_are_those_of_the_reference() {
    let reference: Value = serde_json::from_str(REFERENCE).expect("JSON");
    let mut checked = 0;
    for case in reference.as_array().expect("cases") {
        let samples = &case["samples"];
        let poles: Vec<_> = case["poles"].as_array().expect("poles").iter().map(text).collect();
        let code = code(&format!(
            "sample_time = {h}\ntau = \"{samples}*{h}\"\npoles = [{}]\n[plant]\nA = {}\nB = {}\n",
            poles.join(","),
            text(&case["A"]),
            text(&case["B"]),
            h = text(&case["h"]),
        ));
        let mut controller = Instance::new(&code, &[]).expect("legal parameters");
        for (k, gains) in case["gains"].as_object().expect("gains") {
            let gains: Vec<f64> = gains
                .as_array()
                .expect("a row")
                .iter()
                .map(text)
                .map(|text| text.parse().expect("a number"))
                .collect();
            let k: f64 = k.parse().expect("a sample");
            for (j, gain) in gains.iter().enumerate() {
                let x: Vec<_> = (0..gains.len()).map(|i| f64::from(u8::from(i == j))).collect();
                let outcome = controller.call("step", &[("k", &[k]), ("x", &x)]);
                let u = outcome.results["u"][0];
                let name = &case["name"];
                assert!((u / gain - 1.0).abs() <= GAIN, "{name} {samples} {k} {j}: {u} {gain}");
                checked += 1;
            }
        }
    }
    assert!(checked > 120, "{checked}");
}
