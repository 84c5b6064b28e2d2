//! Laws of least energy, against the inputs with the least weighted sum of squares of all that end at rest: the solution
//! of the conditions of rest, whose numbers are runs of the exact plant.

use num_traits::{ToPrimitive, Zero};
use ptc_codegen::algebra::{BigInt, BigRational};
use ptc_codegen::code::{Instance, Status};

use super::plant::{Plant, double, number};
use super::rest::{PLANTS, REST, listed, rows};
use super::{code, read};

/// Effort of a loop: the weighted sum of u^2, and the greatest |u|.
struct Effort {
    energy: f64,
    peak: f64,
}

impl Effort {
    fn of(u: &[f64], weight: u32) -> Self {
        let count = u.len() as u32;
        let energy = (0..).zip(u).map(|(k, u)| u * u / weighted(count - k, weight)).sum();
        Self { energy, peak: u.iter().fold(0.0, |most, u| most.max(u.abs())) }
    }
}

fn weighted(left: u32, weight: u32) -> f64 {
    (0..weight).map(|i| f64::from(left + i)).product()
}

/// A plant under the units of every input and of the state at the start.
struct Runs {
    plant: Plant,
    samples: u32,
}

impl Runs {
    /// x at sample N of a state at the start and an input at one sample.
    fn end(&self, start: Option<usize>, input: Option<u32>) -> Vec<BigRational> {
        let mut plant = self.plant.clone();
        let one = || BigInt::from(1) << 400;
        plant.x = (0..plant.x.len())
            .map(|j| if start == Some(j) { one() } else { BigInt::zero() })
            .collect();
        for k in 0..self.samples {
            plant.step(if input == Some(k) { 1.0 } else { 0.0 });
        }
        plant.x.iter().map(|x| BigRational::new(x.clone(), one())).collect()
    }

    /// The inputs that act by sample N, with the least sum of u^2/w.
    fn least(&self, start: usize, late: u32, weight: u32) -> Vec<f64> {
        let count = self.samples - late;
        let n = self.plant.x.len();
        let columns: Vec<_> = (0..count).map(|k| self.end(None, Some(k))).collect();
        let weights: Vec<_> = (0..count)
            .map(|k| BigRational::from_float(weighted(count - k, weight)).expect("a number"))
            .collect();
        let gramian = |i: usize, j: usize| {
            columns.iter().zip(&weights).map(|(x, w)| &x[i] * &x[j] * w).sum::<BigRational>()
        };
        let free = self.end(Some(start), None);
        let system = (0..n)
            .map(|i| (0..n).map(|j| gramian(i, j)).chain([free[i].clone()]).collect::<Vec<_>>());
        let shadow = solved(system.collect());
        let input = |(x, w): (&Vec<BigRational>, &BigRational)| {
            let sum: BigRational = x.iter().zip(&shadow).map(|(x, y)| x * y).sum();
            -(sum * w).to_f64().expect("a double")
        };
        columns.iter().zip(&weights).map(input).collect()
    }
}

/// The solution of a system with its right side behind it.
fn solved(mut system: Vec<Vec<BigRational>>) -> Vec<BigRational> {
    let n = system.len();
    for i in 0..n {
        let pivot = (i..n).find(|row| !system[*row][i].is_zero()).expect("a regular system");
        system.swap(i, pivot);
        let own = system[i].clone();
        for (_, other) in system.iter_mut().enumerate().filter(|(row, _)| *row != i) {
            let factor = &other[i] / &own[i];
            other.iter_mut().zip(&own).for_each(|(entry, own)| *entry -= &factor * own);
        }
    }
    (0..n).map(|i| &system[i][n] / &system[i][i]).collect()
}

/// The loop of an emitted controller of the states: every u until what it gives no longer acts by sample N.
fn run(text: &str, mut plant: Plant, start: usize, samples: u32, late: u32) -> (Vec<f64>, f64) {
    let mut controller = Instance::new(&code(text), &[]).expect("legal parameters");
    plant.x = (0..plant.x.len())
        .map(|j| if j == start { BigInt::from(1) << 400 } else { BigInt::zero() })
        .collect();
    let mut u = Vec::new();
    for k in 0..samples {
        let x: Vec<_> = plant.x.iter().map(double).collect();
        let outcome = controller.call("step", &[("k", &[f64::from(k)][..]), ("x", &x)]);
        assert_eq!(outcome.status, Status::Ok, "sample {k}");
        u.push(outcome.results["u"][0]);
        plant.step(u[k as usize]);
    }
    u.truncate((samples - late) as usize);
    let left = plant.left();
    (u, left)
}

fn design([a, b, _, h]: [&str; 4], samples: u32, delay: &str, weight: u32) -> (String, Plant) {
    let text = format!(
        "sample_time = {h}\ntau = \"{samples}*{h}\"\neps = 0\ndelay = {delay}\n\
         poles = \"least-energy(weight={weight})\"\n[plant]\nA = {}\nB = [{b}]\n",
        listed(a)
    );
    let n = b.split(',').count();
    let unit = |i: usize| (0..n).map(|j| if i == j { "1" } else { "0" }).collect::<Vec<_>>();
    let ones: Vec<_> = (0..n).map(|i| unit(i).join(",")).collect();
    let [a, b, c] = [a, b, ones.join(";").as_str()].map(rows);
    (text, Plant::new(&a, &b[0], &c, &number(h), delay, &number("0")))
}

/// No other input that ends at rest needs less, whatever the delay and the weight.
#[test]
fn energy_and_peak_are_the_least() {
    for (name, plant) in PLANTS {
        for (delay, late) in [("0", 0), ("0.3", 1), ("2", 2)] {
            for (samples, weight) in [(24, 0), (24, 2), (90, 1)] {
                let (text, exact) = design(plant, samples, delay, weight);
                let runs = Runs { plant: exact.clone(), samples };
                let start = (samples as usize + late as usize) % exact.x.len();
                let least = Effort::of(&runs.least(start, late, weight), weight);
                let (u, left) = run(&text, exact, start, samples, late);
                let own = Effort::of(&u, weight);
                let about = format!("{name}, d = {delay}, N = {samples}, weight {weight}");
                assert!(left <= REST, "{about}: {left}");
                let [energy, peak] = [own.energy / least.energy, own.peak / least.peak];
                assert!((1.0 - 1e-9..1.001).contains(&energy), "{about}: energy {energy}");
                assert!(peak < 1.01, "{about}: peak {peak}");
            }
        }
    }
}

/// A table of a few bytes costs energy, not rest.
#[test]
fn limited_table_ends_at_rest() {
    let (text, exact) = design(PLANTS[0].1, 900, "1", 0);
    let small = text.replace("[plant]", "gain_bytes = 600\n[plant]");
    let bytes = |text: &str| code(text).tables[0].bytes(ptc_codegen::parameter::Precision::F64);
    assert!(bytes(&small) <= 600 && bytes(&text) > 600, "{} {}", bytes(&small), bytes(&text));
    let [(full, _), (few, left)] = [text, small].map(|text| run(&text, exact.clone(), 0, 900, 1));
    assert!(left <= REST, "{left}");
    let [full, few] = [full, few].map(|u| Effort::of(&u, 0));
    assert!(few.energy < 1.1 * full.energy, "{} {}", few.energy, full.energy);
}

#[test]
fn invalid_tables_are_refused_once() {
    let refused = |text: &str, wanted: &str| {
        let found = read(text).expect_err(text);
        let [one] = found.as_slice() else { panic!("{text}: {found:?}") };
        assert!(format!("{} {}", one.message, one.help).contains(wanted), "{text}: {one:?}");
    };
    let plant = "poles = \"least-energy\"\nsample_time = 0.01\n";
    let matrices = "[plant]\nA = [[0,1],[-4,0]]\nB = [0,1]\n";
    refused(&format!("{plant}{matrices}"), "without a number for tau");
    refused(&format!("{plant}tau = 1\ndeadbeat = 9\n{matrices}"), "the last of these gains");
    refused(&format!("{plant}tau = 1\ngain_bytes = 40\n{matrices}"), "the coarsest one takes");
    refused(&format!("{plant}tau = 1\ngain_bytes = 0\n{matrices}"), "an integer from 1");
    refused(&format!("{plant}tau = 1.005\n{matrices}"), "sample periods");
    let ends = "tau = 1\ndeadbeat = 9\npoles_end = \"least-energy\"\nend_samples = 9\n";
    refused(&format!("{plant}{ends}{matrices}"), "two ends");
    let negative = plant.replace("least-energy", "least-energy(weight=-1)");
    refused(&format!("{negative}tau = 1\n{matrices}"), "not the weight");
    refused(&format!("{plant}tau = 2000\n{matrices}"), "has 200000 samples; the limit is 131072");
    refused(&format!("{plant}tau = 1\ngain_bytes = 999\nn = 2\n"), "without a table of gains");
}
