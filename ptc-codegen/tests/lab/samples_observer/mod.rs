//! The observer in samples alone: emitted C in the loop with the exact plant and a user-defined law,
//! against the observer of a controller, and what is refused.

mod emitted;
mod exact;
mod gate;
mod gate_costs;
mod moving;
use crate::support::exact_plant as plant;
mod requests;
mod same;
mod stationary;
use crate::support;

use ptc_codegen::code::{Code, Instance, Outcome};
use ptc_codegen::request::{self, Spec};
use ptc_codegen::samples;

/// First lines of every design.
const ABOVE: &str = "mu = \"exp(a=1)\"\nclock = \"samples\"\n";

fn read(text: &str) -> Result<Spec, String> {
    request::read(&support::entries(&format!("{ABOVE}{text}"))).map_err(|found| {
        found.iter().map(|d| format!("{}: {}; {}\n", d.key, d.message, d.help)).collect()
    })
}

fn legal(text: &str) -> Spec {
    read(text).unwrap_or_else(|found| panic!("{text}: {found}"))
}

fn code(spec: &Spec) -> Code {
    let code = samples::controller(spec, spec.sampled().expect("samples"), Vec::new());
    code.check().expect("a program in order");
    code
}

fn update(observer: &mut Instance, k: u32, y: &[f64], u: f64) -> Outcome {
    observer.call("update", &[("k", &[f64::from(k)]), ("y", y), ("u", &[u])])
}

/// The estimates, and that of d behind them where there is one.
fn estimates(instance: &mut Instance, code: &Code) -> Vec<f64> {
    let mut all = instance.call("estimate", &[]).results["xhat"].clone();
    if code.function("disturbance").is_some() {
        all.extend(&instance.call("disturbance", &[]).results["d"]);
    }
    all
}

/// Numbers without a pattern, the same in every run.
struct Random(u64);

impl Random {
    /// From 0 to 1.
    #[allow(clippy::cast_precision_loss)]
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Poles, some of them complex.
    fn poles(&mut self, count: usize) -> String {
        let mut poles = Vec::new();
        while poles.len() < count {
            let re = format!("{:.2}", -1.0 - 8.0 * self.next());
            match poles.len() + 1 < count && self.next() < 0.4 {
                true => {
                    let im = format!("{:.2}", 0.1 + 3.0 * self.next());
                    poles.push(format!("\"{re}+{im}i\""));
                    poles.push(format!("\"{re}-{im}i\""));
                }
                false => poles.push(re),
            }
        }
        poles.join(", ")
    }
}
