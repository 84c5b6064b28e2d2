//! The law of a state predicted over its delay, against the Gramian of the plant and the chain in exact numbers.

use num_traits::{Signed, ToPrimitive, Zero};
use ptc_codegen::algebra::BigRational;
use ptc_codegen::code::{Code, Instance};

use super::least_energy::least;
use super::{GAIN, code};

const SAMPLES: u32 = 30;

fn ratio(text: &str) -> BigRational {
    text.parse().expect("a ratio")
}

fn exact(value: f64) -> BigRational {
    BigRational::from_float(value).expect("a finite number")
}

/// The controller of a chain at 100 Hz with 30 samples to its deadline.
fn law(n: usize, delay: &str, more: &[(&str, &str)]) -> Code {
    let n = n.to_string();
    let mut keys = vec![
        ("n", n.as_str()),
        ("tau", "0.3"),
        ("sample_time", "0.01"),
        ("eps", "0"),
        ("poles", "least-energy"),
        ("delay", delay),
        ("delay_law", "predict"),
    ];
    keys.retain(|(key, _)| !more.iter().any(|(own, _)| own == key));
    keys.extend(more);
    code(&keys)
}

/// A chain behind a delay in samples, in exact numbers.
#[derive(Clone)]
struct Chain {
    x: Vec<BigRational>,
    /// Inputs under way, the latest first.
    inputs: Vec<BigRational>,
    /// Part of a sample in which the oldest of them acts.
    part: BigRational,
}

impl Chain {
    fn new(x: Vec<BigRational>, delay: &BigRational) -> Self {
        let inputs = delay.ceil().to_integer().to_usize().expect("a few samples");
        let part = delay - delay.ceil() + BigRational::from_integer(1.into());
        Self { x, inputs: vec![BigRational::zero(); inputs], part }
    }

    fn holds(&mut self, u: &BigRational, time: &BigRational) {
        for i in 0..self.x.len() {
            let (mut sum, mut share) = (BigRational::zero(), BigRational::from_integer(1.into()));
            for (power, value) in (1_u32..).zip(self.x[i..].iter().chain([u])) {
                sum += value * &share;
                share *= time / BigRational::from_integer(power.into());
            }
            self.x[i] = sum;
        }
    }

    fn step(&mut self, u: BigRational) {
        let h = ratio("1/100");
        self.inputs.insert(0, u);
        let oldest = self.inputs.pop().expect("the input itself");
        let next = self.inputs.last().cloned().unwrap_or_else(|| oldest.clone());
        let part = self.part.clone();
        self.holds(&oldest, &(&part * &h));
        self.holds(&next, &((BigRational::from_integer(1.into()) - part) * h));
    }

    fn measured(&self) -> Vec<f64> {
        self.x.iter().map(|x| x.to_f64().expect("a double")).collect()
    }

    fn size(&self) -> f64 {
        self.measured().into_iter().fold(0.0, |most, x| most.max(x.abs()))
    }
}

/// The inputs of all samples to the deadline.
fn run(code: &Code, chain: &mut Chain) -> Vec<f64> {
    let mut controller = Instance::new(code, &[]).expect("legal parameters");
    let mut step = |k: u32| {
        let x = chain.measured();
        let u = controller.call("step", &[("k", &[f64::from(k)]), ("x", &x)]).results["u"][0];
        chain.step(exact(u));
        u
    };
    (0..SAMPLES).map(&mut step).collect()
}

/// The inputs are those of the Gramian, of the state at which the input of now begins to act.
#[test]
fn inputs_are_those_of_the_plant_without_delay() {
    let h = ratio("1/100");
    for n in 1..=3 {
        for (weight, delay) in [(0, 1), (0, 2), (1, 3), (2, 4), (0, 8)] {
            let poles = format!("least-energy(weight={weight})");
            let code = law(n, &delay.to_string(), &[("poles", &poles)]);
            let late = BigRational::from_integer(delay.into());
            let x0 = (1..=n).map(|i| BigRational::new((2 - i as i64).into(), 7.into())).collect();
            let mut chain = Chain::new(x0, &late);
            let found = run(&code, &mut chain.clone());
            // Nothing acts before the first input does.
            (0..delay).for_each(|_| chain.step(BigRational::zero()));
            // Fewer samples than states do not reach every state.
            let most = found.iter().fold(1.0_f64, |most, u| most.max(u.abs()));
            for left in (n as u32..=SAMPLES - delay).rev() {
                let wanted = least(&chain.x, left, weight, &h);
                let k = (SAMPLES - delay - left) as usize;
                let [found, double] = [found[k], wanted.to_f64().expect("a double")];
                // The terms of a sum are larger than it is.
                assert!(
                    (found - double).abs() < 10.0 * GAIN * most,
                    "n = {n}, weight {weight}, delay {delay}, sample {k}: {found}, not {double}"
                );
                chain.inputs.fill(wanted.clone());
                chain.step(wanted);
            }
        }
    }
}

/// The chain is at rest at sample N behind any delay, whole or not, whatever acted before.
#[test]
fn chain_is_at_rest_behind_any_delay() {
    let laws: [&[(&str, &str)]; 4] = [
        &[],
        &[("poles", "least-energy(weight=2)")],
        &[("poles", "-6,-8.5"), ("n", "2")],
        &[("poles", "-4,-5"), ("n", "2"), ("deadbeat", "7")],
    ];
    for delay in ["1", "2", "3", "5", "8", "16", "0.25", "1.5", "3.75", "7.1"] {
        for (own, n) in laws.iter().flat_map(|own| (1..=3).map(move |n| (own, n))) {
            if own.contains(&("n", "2")) && n != 2 {
                continue;
            }
            let code = law(n, delay, own);
            let x0 = (1..=n).map(|i| BigRational::new(i.into(), 5.into())).collect();
            let delay: f64 = delay.parse().expect("a delay");
            let mut chain = Chain::new(x0, &exact(delay));
            let most = run(&code, &mut chain).into_iter().fold(0.0_f64, |m, u| m.max(u.abs()));
            let rest = chain.size();
            assert!(rest <= 1e-15 * most, "n = {n}, delay {delay}, {own:?}: {rest}, |u| {most}");
            let under_way = chain.inputs.iter().map(Signed::abs).max().unwrap_or_default();
            let under_way = under_way.to_f64().expect("a double");
            assert!(under_way <= 1e-9 * most, "delay {delay}, {own:?}: {under_way} under way");
        }
    }
}
