//! Sums over x and u in the loop that runs: random claims next to the truth, which a simulator of its own gives, between
//! the samples too.

use crate::support;

use ptc_codegen::verify;
use ptc_codegen::verify::bound::Proof;

const PERIOD: f64 = 0.02;
const SAMPLES: usize = 50;
const HELD: f64 = 0.1;

/// Instants of a sample that are looked at.
const INSTANTS: usize = 40;

/// Parts of a sample in each of which a force that varies is constant.
const PARTS: usize = 8;

/// Numbers between -1 and 1 from a seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 2f64.powi(52) - 1.0
    }

    /// One with three digits, so that its text is its value.
    fn short(&mut self, size: f64) -> f64 {
        format!("{:.3}", size * self.next()).parse().expect("a number")
    }

    fn interval(&mut self, size: f64) -> [f64; 2] {
        let (a, b) = (self.short(size), self.short(size));
        [a.min(b), a.max(b)]
    }
}

/// A claim on a chain of integrators of gain `g` under the law with poles -4, -5, ..., whose inputs act `delay` samples late.
#[derive(Debug)]
struct Claim {
    g: f64,
    delay: usize,
    start: Vec<[f64; 2]>,
    force: [f64; 2],
    /// True if the force is any signal between its bounds; false if it is constant.
    varies: bool,
    noise: Vec<f64>,
    weights: Vec<f64>,
    input: f64,
    rest: f64,
}

impl Claim {
    fn random(random: &mut Random, n: usize) -> Self {
        Self {
            g: 0.5 + random.short(0.4).abs(),
            delay: usize::from(random.next() > 0.5),
            start: (0..n).map(|_| random.interval(1.0)).collect(),
            force: if random.next() > 0.0 { random.interval(0.5) } else { [0.0, 0.0] },
            varies: random.next() > 0.0,
            noise: (0..n).map(|_| random.short(1e-2).abs()).collect(),
            weights: (0..n).map(|_| random.short(2.0)).collect(),
            input: if random.next() > 0.0 { random.short(0.1) } else { 0.0 },
            rest: random.short(1.0),
        }
    }

    fn gains(&self, k: usize) -> Vec<f64> {
        let left = ((SAMPLES - k) as f64 * PERIOD).max(HELD);
        let of_poles = [vec![4.0], vec![20.0, 8.0], vec![120.0, 60.0, 12.0]];
        // x1 is a sum of T^4, T^5, ..
        let n = self.weights.len();
        let gain = |(j, k): (usize, &f64)| -k / left.powi((n - j) as i32) / self.g;
        of_poles[n - 1].iter().enumerate().map(gain).collect()
    }

    /// x after a time under an input and a force.
    fn moved(&self, x: &[f64], input: f64, time: f64) -> Vec<f64> {
        let n = x.len();
        let factorial = |m: usize| (1..=m).map(|i| i as f64).product::<f64>();
        let state = |i: usize| {
            let own = (i..n).map(|j| x[j] * time.powi((j - i) as i32) / factorial(j - i));
            own.sum::<f64>() + input * time.powi((n - i) as i32) / factorial(n - i)
        };
        (0..n).map(state).collect()
    }

    fn value(&self, x: &[f64], u: f64) -> f64 {
        self.weights.iter().zip(x).map(|(weight, x)| weight * x).sum::<f64>() + self.input * u
    }

    /// The sum at all instants of a run from x, with a force in some parts of samples and with an error of one measurement.
    fn run(
        &self,
        x: &[f64],
        force: &dyn Fn(usize) -> f64,
        error: Option<(usize, usize)>,
    ) -> Vec<f64> {
        let mut x = x.to_vec();
        let mut late = vec![0.0; self.delay];
        let mut seen = Vec::new();
        for k in 0..=SAMPLES {
            let mut measured = x.clone();
            if let Some((at, j)) = error
                && at == k
            {
                measured[j] += 1.0;
            }
            let gains = self.gains(k);
            late.push(gains.iter().zip(&measured).map(|(gain, x)| gain * x).sum());
            let u = late.remove(0);
            seen.push(self.value(&x, u));
            let count = if k < SAMPLES { INSTANTS } else { 0 };
            for i in 0..count {
                let part = k * PARTS + i * PARTS / INSTANTS;
                x = self.moved(&x, self.g * u + force(part), PERIOD / INSTANTS as f64);
                seen.push(self.value(&x, u));
            }
        }
        seen
    }

    /// The least and the greatest value of the sum.
    fn truth(&self) -> [f64; 2] {
        let n = self.weights.len();
        let unit = |j: usize| (0..n).map(|i| f64::from(u8::from(i == j))).collect::<Vec<_>>();
        let mut causes: Vec<_> =
            (0..n).map(|j| (self.start[j], self.run(&unit(j), &|_| 0.0, None))).collect();
        let rest = vec![0.0; n];
        if self.varies && self.force[0] < self.force[1] {
            for part in 0..SAMPLES * PARTS {
                let force = |own: usize| f64::from(u8::from(own == part));
                causes.push((self.force, self.run(&rest, &force, None)));
            }
        } else {
            causes.push((self.force, self.run(&rest, &|_| 1.0, None)));
        }
        for k in 0..=SAMPLES {
            for j in 0..n {
                let bounds = [-self.noise[j], self.noise[j]];
                causes.push((bounds, self.run(&rest, &|_| 0.0, Some((k, j)))));
            }
        }
        let at = |i: usize, side: f64| {
            let ends = causes.iter().map(|(bounds, run)| {
                bounds.map(|end| side * end * run[i]).into_iter().fold(f64::MIN, f64::max)
            });
            ends.sum::<f64>()
        };
        let most = |side: f64| (0..causes[0].1.len()).map(|i| at(i, side)).fold(f64::MIN, f64::max);
        [self.rest - most(-1.0), self.rest + most(1.0)]
    }

    /// A design that claims the truth and a part of it more.
    fn design(&self, [low, high]: [f64; 2], part: f64) -> String {
        let n = self.weights.len();
        let more = part * (high - low);
        let poles = &["-4", "-4, -5", "-4, -5, -6"][n - 1];
        let start: String = (0..n).map(|i| format!("x{} = {:?}\n", i + 1, self.start[i])).collect();
        let force = match self.force {
            [low, high] if low < high => {
                let kind = if self.varies { "[disturbance]\nd = \"any\"\n" } else { "" };
                format!("f = \"d\"\nd = {:?}\n{kind}", self.force)
            }
            _ => "f = 0\n".to_owned(),
        };
        let terms = (0..n).map(|i| format!("{:?}*x{}", self.weights[i], i + 1));
        let h: Vec<_> =
            terms.chain([format!("{:?}*u", self.input), format!("{:?}", self.rest)]).collect();
        format!(
            "n = {n}\nmu = \"exp(a=1)\"\npoles = [{poles}]\ng = \"{:?}\"\nsample_time = {PERIOD}\neps = {HELD}\n\
             noise = {:?}\ndelay = {}\nallow = [\"sampling\"]\n[params]\ntau = 1\nu_max = inf\n[plant]\n{force}\
             [verify]\n{start}\
             [[objective]]\nbound = \"within\"\nh = \"{h}\"\nlow = {:e}\n\
             [[objective]]\nbound = \"within\"\nh = \"{h}\"\nhigh = {:e}\n",
            self.g,
            self.noise,
            self.delay,
            low - more,
            high + more,
            h = h.join(" + "),
        )
    }
}

fn proofs(text: &str) -> Vec<Proof> {
    let entries = support::entries(text);
    let spec = ptc_codegen::request::read(&entries).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    let read = verify::read_with_plant(&entries, &spec);
    verify::bound::proved(&read.unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}")))
}

#[test]
fn sums_of_states_and_u_are_proved_tightly() {
    let mut random = Random(3);
    for seed in 0..18 {
        let claim = Claim::random(&mut random, 1 + seed % 3);
        let truth = claim.truth();
        let above = proofs(&claim.design(truth, 0.02));
        assert!(above.iter().all(Proof::is_proved), "{seed}: {above:?}\n{truth:?} {claim:?}");
        let below = proofs(&claim.design(truth, -1e-3));
        assert!(!below.iter().any(Proof::is_proved), "{seed}: {below:?}\n{truth:?} {claim:?}");
    }
}
