//! Controllers in samples of linear plants: against reference values of 40 digits, in the loop with
//! the exact plant, and what is refused. What runs is the program that is emitted, in its arithmetic.

mod support;

use std::collections::VecDeque;

use num_traits::{FromPrimitive, One, Signed, ToPrimitive, Zero};
use ptc_codegen::algebra::{BigInt, BigRational};
use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Code, Instance, Status};
use ptc_codegen::diagnostic::Diagnostic;
use ptc_codegen::request::{self, Spec};
use ptc_codegen::samples;
use serde_json::Value;
use support::entries;

/// Error of a gain in parts of the largest of a row, a few roundings.
const GAIN: f64 = 1e-14;

/// Gains at 40 digits: `python3 tools/samples.py gains COMMAND`.
const REFERENCE: &str = include_str!("../../tests/data/sampled_plants.json");

/// What stands above the table [plant].
const ABOVE: &str = "mu = \"exp(a=1)\"\nclock = \"samples\"\nu_max = inf\n";

fn read(text: &str) -> Result<Spec, Vec<Diagnostic>> {
    request::read(&entries(&format!("{ABOVE}{text}")))
}

fn code(text: &str) -> Code {
    let spec = read(text).unwrap_or_else(|found| panic!("{text}: {found:?}"));
    let code = samples::controller(&spec, spec.sampled().expect("samples"), Vec::new());
    code.check().expect("a program in order");
    code
}

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

type Rows = Vec<Vec<BigRational>>;

/// The exact plant x' = A x + B u, y = C x.
struct Plant {
    whole: Fixed,
    c: Fixed,
    x: Fixed,
    late: VecDeque<BigInt>,
    largest: BigInt,
}

fn number(text: &str) -> BigRational {
    let (whole, part) = text.trim().split_once('.').unwrap_or((text.trim(), ""));
    let digits: BigInt = format!("{whole}{part}").parse().expect("digits");
    BigRational::new(digits, num_traits::pow(BigInt::from(10), part.len()))
}

fn rows(text: &str) -> Rows {
    let row = |row: &str| row.split(',').map(number).collect();
    text.split(';').map(row).collect()
}

/// Numbers of the exact plant are multiples of 2^-BITS: nothing beside what is asked for.
const BITS: usize = 400;

type Fixed = Vec<Vec<BigInt>>;

fn fixed(value: &BigRational) -> BigInt {
    (value * BigRational::from_integer(BigInt::one() << BITS)).to_integer()
}

fn double(value: &BigInt) -> f64 {
    BigRational::new(value.clone(), BigInt::one() << BITS).to_f64().expect("a double")
}

fn product(a: &Fixed, b: &Fixed) -> Fixed {
    let entry = |row: &Vec<BigInt>, j: usize| {
        let products = row.iter().zip(b).map(|(a, row)| a * &row[j]);
        products.fold(BigInt::zero(), |sum, product| sum + product) >> BITS
    };
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

impl Plant {
    fn new(a: &str, b: &str, c: &str, h: &str, delay: usize) -> Self {
        let (a, b, h) = (rows(a), rows(b).swap_remove(0), number(h));
        let n = b.len();
        // exp by its series for 2^-12 h, squared.
        let h = h / (BigInt::one() << 12);
        let row = |i: usize| a[i].iter().chain([&b[i]]).map(|e| fixed(&(e * &h))).collect();
        let mut all: Fixed = (0..n).map(row).collect();
        all.push(vec![BigInt::zero(); n + 1]);
        let one = || BigInt::one() << BITS;
        let unit = |i: usize, j: usize| if i == j { one() } else { BigInt::zero() };
        let mut sum: Fixed = (0..=n).map(|i| (0..=n).map(|j| unit(i, j)).collect()).collect();
        let mut term = sum.clone();
        for k in 1..40 {
            term = product(&term, &all);
            term.iter_mut().flatten().for_each(|entry| *entry /= BigInt::from(k));
            for (sum, term) in sum.iter_mut().flatten().zip(term.iter().flatten()) {
                *sum += term;
            }
        }
        for _ in 0..12 {
            sum = product(&sum, &sum);
        }
        let x = (0..n).map(|i| vec![one() / (i + 2)]).collect();
        let late = vec![BigInt::zero(); delay].into();
        let c = rows(c).iter().map(|row| row.iter().map(fixed).collect()).collect();
        Self { whole: sum, c, x, late, largest: one() }
    }

    fn measured(&self) -> Vec<f64> {
        product(&self.c, &self.x).iter().map(|y| double(&y[0])).collect()
    }

    fn step(&mut self, u: f64, disturbance: &BigRational) {
        self.late.push_back(fixed(&BigRational::from_f64(u).expect("a finite u")));
        let acting = self.late.pop_front().expect("an input") + fixed(disturbance);
        let mut given = self.x.clone();
        given.push(vec![acting]);
        self.x = product(&self.whole, &given);
        self.x.pop();
        self.largest = self.x.iter().map(|x| x[0].abs()).fold(self.largest.clone(), BigInt::max);
    }

    /// The largest state, in parts of the largest on the way.
    fn left(&self) -> f64 {
        let most = self.x.iter().map(|x| x[0].abs()).max().expect("a state");
        BigRational::new(most, self.largest.clone()).to_f64().expect("a number")
    }
}

/// A, B, C and h.
const PLANTS: [(&str, [&str; 4]); 7] = [
    ("motor", ["0,1,0;0,-0.5,1500;0,-15,-600", "0,0,500", "1,0,0", "0.001"]),
    (
        "joint",
        ["0,1,0,0;-900,-0.6,900,0.6;0,0,0,1;400,0.3,-400,-0.3", "0,0,0,1", "1,0,0,0", "0.005"],
    ),
    (
        "two encoders",
        [
            "0,1,0,0;-900,-0.6,900,0.6;0,0,0,1;400,0.3,-400,-0.3",
            "0,0,0,1",
            "1,0,0,0;0,0,1,0",
            "0.001",
        ],
    ),
    ("unstable", ["0,1;49,0", "0,-1.3", "1,0.1", "0.01"]),
    ("mixed", ["3.1,-2,0.4;1.2,-7,1;0.3,0.9,-1.5", "1,-0.4,0.7", "1,0,2;0,1,-1", "0.1"]),
    ("stiff", ["-9000,3;2,-0.5", "1,0.25", "0.3,1", "0.001"]),
    ("first", ["-0.25", "2", "4", "0.5"]),
];

fn listed(rows: &str) -> String {
    format!("[[{}]]", rows.replace(';', "],["))
}

fn poles(count: usize) -> String {
    let each: Vec<_> = (0..count).map(|i| format!("-{}", count + i)).collect();
    each.join(",")
}

fn run(code: &Code, plant: &mut Plant, samples: u32, disturbance: &str) {
    let mut controller = Instance::new(code, &[]).expect("legal parameters");
    let disturbance = number(disturbance);
    for k in 0..samples {
        let y = plant.measured();
        let x: Vec<_> = plant.x.iter().map(|x| double(&x[0])).collect();
        let outcome = controller.call("step", &[("k", &[f64::from(k)][..]), ("x", &x), ("y", &y)]);
        assert_eq!(outcome.status, Status::Ok, "sample {k}");
        plant.step(outcome.results["u"][0], &disturbance);
    }
}

#[test]
fn comes_to_rest_with_all_states() {
    for (name, [a, b, _, h]) in PLANTS {
        let n = b.split(',').count();
        for delay in 0..=2 {
            let order = n + delay;
            for samples in [2 * order as u32, 60] {
                let mut chosen = poles(order);
                if order > 1 && samples == 60 {
                    chosen = format!("-{order}+2i,-{order}-2i,{}", poles(order));
                    chosen = chosen.split(',').take(order).collect::<Vec<_>>().join("\",\"");
                    chosen = format!("\"{chosen}\"");
                }
                let code = code(&format!(
                    "sample_time = {h}\ntau = \"{samples}*{h}\"\ndelay = {delay}\npoles = [{chosen}]\n\
                     [plant]\nA = {}\nB = [{b}]\n",
                    listed(a)
                ));
                let ones: Vec<_> = (0..n)
                    .map(|i| {
                        (0..n).map(|j| if i == j { "1" } else { "0" }).collect::<Vec<_>>().join(",")
                    })
                    .collect();
                let mut plant = Plant::new(a, b, &ones.join(";"), h, delay);
                run(&code, &mut plant, samples, "0");
                assert!(
                    plant.left() <= 1e-24,
                    "{name}, d = {delay}, N = {samples}: {}",
                    plant.left()
                );
            }
        }
    }
}

#[test]
fn comes_to_rest_with_an_observer() {
    for (name, [a, b, c, h]) in PLANTS {
        let n = b.split(',').count();
        for (delay, disturbance) in [(0, "0"), (1, "0"), (1, "0.3"), (2, "0.3")] {
            let estimates = n + usize::from(disturbance != "0");
            let known = c.split(';').count() == n && disturbance == "0";
            let own = match known {
                true => String::new(),
                false => format!("observer_poles = [{}]\n", poles(estimates)),
            };
            let constant = if disturbance == "0" { "none" } else { "constant" };
            let samples = 100;
            let rounds = 2 * (estimates + n + delay);
            let code = code(&format!(
                "sample_time = {h}\ntau = \"{samples}*{h}\"\ndelay = {delay}\npoles = [{}]\n{own}deadbeat = {rounds}\n\
                 disturbance = \"{constant}\"\n[plant]\nA = {}\nB = [{b}]\nC = {}\n",
                poles(n + delay),
                listed(a),
                listed(c),
            ));
            let mut plant = Plant::new(a, b, c, h, delay);
            run(&code, &mut plant, samples, disturbance);
            // What is left of a constant is the rounding of its estimate.
            let allowed = if disturbance == "0" { 1e-20 } else { 1e-12 };
            assert!(
                plant.left() <= allowed,
                "{name}, d = {delay}, {disturbance}: {}",
                plant.left()
            );
        }
    }
}

/// A chain given as a linear plant is the chain.
#[test]
fn a_chain_is_one_of_them() {
    let above = "sample_time = 0.01\ntau = 0.6\ndelay = 1\npoles = [-4,-5,-6]\n";
    let (chain, linear) = (
        code(&format!("n = 2\ng = 3\n{above}")),
        code(&format!("{above}[plant]\nA = [[0, 1], [0, 0]]\nB = [0, 3]\n")),
    );
    let [mut one, mut other] =
        [&chain, &linear].map(|code| Instance::new(code, &[]).expect("legal"));
    for k in 0..70_u32 {
        let x = [f64::from(k % 7) - 3.0, f64::from(k % 5) - 1.5];
        let call = |controller: &mut Instance<'_>| {
            controller.call("step", &[("k", &[f64::from(k)][..]), ("x", &x)]).results["u"][0]
        };
        let (one, other) = (call(&mut one), call(&mut other));
        assert!((one - other).abs() <= 1e-12 * one.abs(), "{k}: {one} {other}");
    }
}

/// After the deadline of the observer an error decays as its poles say.
#[test]
fn after_observer_places_the_poles() {
    let s = |re: f64, im: f64, h: f64| {
        // z^2 - 2 exp(re h) cos(im h) z + exp(2 re h)
        ((re * h).exp() * 2.0 * (im * h).cos(), (2.0 * re * h).exp())
    };
    let (h, (sum, product)) = (0.002_f64, s(-50.0, 30.0, 0.002));
    let above = "sample_time = 0.002\ntau = 0.2\npoles = [-4,-5]\nobserver_poles = [-4,-5]\n\
                 after_observer = [\"-50+30i\",\"-50-30i\"]\n";
    let mut phi = [[1.0, h], [0.0, 1.0]];
    let mut gamma = [h * h / 2.0, h];
    for linear in [false, true] {
        let code = match linear {
            false => code(&format!("n = 2\nmeasured = [\"x1\"]\n{above}")),
            true => {
                let decay: f64 = (-3.0 * h).exp();
                phi = [[1.0, (1.0 - decay) / 3.0], [0.0, decay]];
                gamma = [(h - (1.0 - decay) / 3.0) / 3.0, (1.0 - decay) / 3.0];
                code(&format!("{above}[plant]\nA = [[0,1],[0,-3]]\nB = [0,1]\nC = [1,0]\n"))
            }
        };
        let mut controller = Instance::new(&code, &[]).expect("legal parameters");
        let mut x = [0.4, -0.2];
        let mut errors = Vec::new();
        for k in 0..75_u32 {
            let given = [("k", &[f64::from(k)][..]), ("y", &x[..1])];
            let u = controller.call("step", &given).results["u"][0];
            let estimate = controller.call("estimate", &[]).results["xhat"].clone();
            errors.push([x[0] - estimate[0], x[1] - estimate[1]]);
            x = [0, 1].map(|i| phi[i][0] * x[0] + phi[i][1] * x[1] + gamma[i] * u);
            if k == 55 {
                x[0] += 1.0;
                x[1] -= 2.0;
            }
        }
        assert!(errors[52].iter().all(|e| e.abs() < 1e-9), "{:?}", errors[52]);
        for k in 57..72 {
            let after = errors[k].iter().zip(&errors[k + 1]).zip(&errors[k + 2]);
            for (i, ((a, b), c)) in after.take(2).enumerate() {
                let off = c - sum * b + product * a;
                assert!(off.abs() <= 1e-9 * (a.abs() + b.abs()), "{linear} {k} {i}: {a} {b} {c}");
            }
        }
    }
}

/// The worst case of the check is the worst corner of simulated runs.
#[cfg(feature = "lab")]
#[test]
fn the_check_and_the_simulation_judge_one_plant() {
    use ptc_codegen::plant::Plant;
    use ptc_codegen::simulate::{Loop, Sampled, Values};

    for (own, n) in [
        (
            "sample_time = 0.001\ntau = 0.1\ndelay = 1\npoles = [-4,-5,-6,-7]\neps = 0.03\n\
          measured = [\"x1\"]\nobserver_poles = [-4,-5,-6]\nobserver_eps = 0.02\n\
          [plant]\nA = [[0,1,0],[0,-0.5,1500],[0,-15,-600]]\nB = [0,0,500]\n",
            3,
        ),
        (
            "sample_time = 0.01\ntau = 0.4\npoles = [-3,-4]\neps = 0.1\n\
          [plant]\nA = [[0,1],[49,0]]\nB = [0,-1.3]\nC = [[1,0.5],[0.2,-1]]\n",
            2,
        ),
    ] {
        let corner = vec!["0.5"; n].join(",");
        let spec = read(&format!("x0_max = [{corner}]\nerror = 1e9\n{own}")).expect("a design");
        let report = examine(&spec);
        let worst = report.worst.unwrap_or_else(|| panic!("{:?}", report.outcomes));
        let mut most = vec![0.0_f64; n];
        let delay = spec.promises.delay.unwrap_or(0);
        let (period, tau) = if n == 3 { (0.001, 0.1) } else { (0.01, 0.4) };
        let around = Loop { period, delay, ..Loop::default() };
        let plant = Plant::default();
        let values = Values::of(&spec, &plant);
        for signs in 0..1_u32 << n {
            let x0: Vec<_> = (0..n).map(|j| if signs >> j & 1 == 0 { 0.5 } else { -0.5 }).collect();
            let mut end = Vec::new();
            let mut run = Sampled::new(&spec, &plant).expect("a loop");
            run.run(&values, &x0, &around, &mut |sample| {
                if (sample.t - tau).abs() < 1e-9 {
                    end = sample.x.to_vec();
                }
            })
            .expect("a run");
            most.iter_mut().zip(&end).for_each(|(most, x)| *most = most.max(x.abs()));
        }
        for (bound, most) in worst.states.iter().zip(&most) {
            assert!((bound.x0 / most - 1.0).abs() < 1e-6, "{bound:?} {most}");
            assert!(bound.rounding < 0.05 * bound.x0, "{bound:?}");
        }
    }
}

#[test]
fn what_is_hardly_controllable_or_observable_is_refused() {
    let with = |above: &str, plant: &str| {
        read(&format!("tau = \"100*{above}\"\nsample_time = {above}\n{plant}"))
            .map(|_| ())
            .map_err(|found| format!("{}: {}", found[0].key, found[0].message))
    };
    let twin = |gap: &str| format!("[plant]\nA = [[-1,0],[0,-1{gap}]]\nB = [1,1]\n");
    assert_eq!(with("0.01", &twin(".1")), Ok(()));
    assert_eq!(with("0.01", &twin(".001")), Ok(()));
    let refused = with("0.01", &twin(".0000001")).expect_err("nearly equal modes");
    assert!(refused.contains("B: the sampled plant is not controllable"), "{refused}");
    assert!(refused.contains("condition number 4e9"), "{refused}");
    assert!(refused.contains("the mode s = -1 1/s"), "{refused}");
    // A mode that the input does not reach, in other coordinates.
    let hidden = "[plant]\nA = [[-2,1],[0,-3]]\nB = [1,0]\n";
    let refused = with("0.01", hidden).expect_err("a mode without input");
    assert!(refused.contains("infinite condition number"), "{refused}");
    assert!(refused.contains("s = -3 1/s"), "{refused}");
    // Half a period of an oscillation in a sample.
    let swing = "[plant]\nA = [[0,314.159265358979],[-314.159265358979,0]]\nB = [0,1]\n";
    let refused = with("0.01", swing).expect_err("aliased");
    assert!(refused.contains("s = 0 +- 314.2i 1/s"), "{refused}");
    assert_eq!(with("0.009", swing), Ok(()));
    // Speed and current do not show the angle.
    let motor = "[plant]\nA = [[0,1,0],[0,-0.5,1500],[0,-15,-600]]\nB = [0,0,500]\n";
    let poles = "observer_poles = [-4,-5,-6]\n";
    let refused = with("0.001", &format!("measured = [\"x2\",\"x3\"]\n{poles}{motor}"));
    let refused = refused.expect_err("no angle");
    assert!(refused.contains("measured: the sampled plant is not observable"), "{refused}");
    assert!(refused.contains("the mode s = 0 1/s"), "{refused}");
    assert_eq!(with("0.001", &format!("measured = [\"x3\",\"x1\"]\n{poles}{motor}")), Ok(()));
    // A washout passes no constant on.
    let washout =
        "disturbance = \"constant\"\nobserver_poles = [-4,-5]\n[plant]\nA = [[-1]]\nB = [0]\n";
    let refused = with("0.001", washout).expect_err("no input at all");
    assert!(refused.contains("not controllable"), "{refused}");
    let speed = "disturbance = \"constant\"\nmeasured = [\"x2\"]\nobserver_poles = [-4,-5,-6]\n\
                 [plant]\nA = [[0,1],[-1,-1]]\nB = [0,1]\n";
    let refused = with("0.01", speed).expect_err("a zero at 0");
    assert!(refused.contains("not observable"), "{refused}");
    assert!(refused.contains("the mode s = 0 1/s"), "{refused}");
    let fast = with("1", "[plant]\nA = [[-5000]]\nB = [1]\n").expect_err("a fast mode");
    assert!(fast.contains("more than e^1000"), "{fast}");
    // Single precision takes fewer digits.
    let single = format!("precision = \"f32\"\n{}", twin(".001"));
    assert!(with("0.01", &single).is_err());
}

#[test]
fn mistakes_are_named() {
    let above = "sample_time = 0.01\ntau = 1\n";
    let plant = "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1]\n";
    let cases = [
        ("", "[plant]\nB = [0,1]\n", "`B` without `A`"),
        ("", "[plant]\nA = [[0,1],[-1,0]]\n", "`B` is missing"),
        ("n = 3\n", plant, "A has 2 rows for order n = 3"),
        ("", "[plant]\nA = [[0,1],[-1]]\nB = [0,1]\n", "a row of A has 1 numbers"),
        ("", "[plant]\nA = [[0,1],[-1,inf]]\nB = [0,1]\n", "A holds `inf`"),
        ("", "[plant]\nA = [[0,1],[-1,0]]\nB = [0,\"x1\"]\n", "B holds `x1`"),
        ("", "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1,2]\n", "a row of B has 3 numbers"),
        ("", "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1]\nC = [[1,0],[0,1],[1,1]]\n", "C has 3 rows"),
        (
            "",
            "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1]\nC = [[1,2],[2,4]]\n",
            "a row of C is a combination",
        ),
        (
            "measured = [\"x1\"]\n",
            "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1]\nC = [1,0]\n",
            "`measured` beside `C`",
        ),
        ("measured = [\"x3\"]\n", plant, "not a choice of states"),
        ("measured = [\"x1\",\"x1\"]\n", plant, "not a choice of states"),
        ("measured = [\"x1\"]\n", plant, "`observer_poles` is missing"),
        ("g = 2\n", plant, "`g` beside `A`"),
        ("f = 2\n", plant, "`f` beside `A`"),
        ("delay = 1\npoles = [-3,-4]\n", plant, "2 poles for order n = 3"),
        ("observer_poles = [-3,-4]\n", plant, "`observer_poles` without an observer"),
        (
            "measured = [\"x1\"]\nobserver_poles = [-3,-4]\nafter_observer = [-3]\n",
            plant,
            "1 poles for 2",
        ),
        (
            "measured = [\"x1\"]\nobserver_poles = [-3,-4]\nafter_observer = [-3,1]\n",
            plant,
            "a real part of 1",
        ),
        ("after_observer = [-3,-4]\n", plant, "`after_observer` without an observer"),
    ];
    for (top, table, wanted) in cases {
        let found = read(&format!("{top}{above}{table}")).expect_err(wanted);
        let shown: Vec<_> = found.iter().map(|d| format!("{}; {}", d.message, d.help)).collect();
        assert!(shown.iter().any(|text| text.contains(wanted)), "{wanted}: {shown:?}");
    }
    let open = read(plant).expect_err("no period");
    assert!(open.iter().any(|d| d.message == "`sample_time` is missing"), "{open:?}");
    let timed = request::read(&entries(&format!("mu = \"exp(a=1)\"\n{plant}"))).expect_err("time");
    assert!(timed.iter().any(|d| d.message == "`A` needs a clock in samples"), "{timed:?}");
    let nine = format!("[{}]", ["0"; 9].join(","));
    let nine = format!("{above}[plant]\nA = [{}]\nB = {nine}\n", vec![nine.clone(); 9].join(","));
    let found = read(&nine).expect_err("order 9");
    assert!(found[0].message.contains("A has 9 rows"), "{found:?}");
    // The plant of a simulation is that of the controller.
    let both = entries(&format!("{ABOVE}{above}{plant}f = \"-x2\"\n"));
    let spec = request::read(&both).expect("a controller");
    let found = ptc_codegen::plant::read(&both, &spec).expect_err("two plants");
    assert!(found[0].message.contains("`f` beside `A`"), "{found:?}");
}

/// The command in the head gives the same controller.
#[test]
fn its_command_gives_the_same() {
    let spec = read(
        "sample_time = 0.01\ntau = 1\npoles = [-4,-5,-6]\nmeasured = [\"x2\"]\nobserver_poles = [-3,-4]\n\
         after_observer = [\"-30+5i\",\"-30-5i\"]\ndelay = 1\n[plant]\nA = [[0,1],[-1,\"-1/3\"]]\nB = [0.25,1]\n",
    );
    let command = spec.expect("a design").command();
    let wanted = [
        "--A=\"[[0,1],[-1,-1/3]]\" --B=\"[0.25,1]\" --C=\"[[0,1]]\"",
        "--after-observer=-30+5i,-30-5i",
    ];
    for wanted in wanted {
        assert!(command.contains(wanted), "{command}");
    }
}
