//! Filters in the loop with an exact chain of the test's own, which is looked at between samples too.

use num_traits::ToPrimitive;
use ptc_codegen::algebra::{BigInt, BigRational};
use ptc_codegen::check::Verdict;
use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Instance, Status};
use ptc_codegen::samples;

use super::flight::Draw;
use super::read;

/// A state counts as within its bounds up to this part of the greatest one.
const TOLERANCE: f64 = 1.0 / 1_073_741_824.0;

/// x_i' = x_{i+1}, x_n' = g u with u held for 1/64 s, in rational numbers.
struct Chain {
    x: Vec<BigRational>,
    gain: BigRational,
}

fn exact(value: f64) -> BigRational {
    BigRational::from_float(value).expect("a finite number")
}

fn double(value: &BigRational) -> f64 {
    value.to_f64().expect("a double")
}

impl Chain {
    fn new(x: &[f64], gain: f64) -> Self {
        Self { x: x.iter().copied().map(exact).collect(), gain: exact(gain) }
    }

    fn after(&self, u: f64, time: &BigRational) -> Vec<BigRational> {
        let acts = exact(u) * &self.gain;
        let all: Vec<_> = self.x.iter().chain([&acts]).collect();
        let state = |i: usize| {
            let mut share = exact(1.0);
            let mut sum = exact(0.0);
            for (k, value) in (1..).zip(&all[i..]) {
                sum += &share * *value;
                share = share * time / BigInt::from(k);
            }
            sum
        };
        (0..self.x.len()).map(state).collect()
    }

    /// Goes on by a sample; gives the states at the quarters of it.
    fn step(&mut self, u: f64) -> Vec<Vec<f64>> {
        let quarters = (1..=4).map(|part| self.after(u, &exact(f64::from(part) / 256.0)));
        let quarters: Vec<_> = quarters.collect();
        // To 2^-120, as fractions grow with each sample.
        let scale = BigRational::from_integer(BigInt::from(1) << 120_u32);
        self.x = quarters[3].iter().map(|x| (x * &scale).round() / &scale).collect();
        quarters.iter().map(|x| x.iter().map(double).collect()).collect()
    }

    fn now(&self) -> Vec<f64> {
        self.x.iter().map(double).collect()
    }
}

/// Keys of a filter at 64 Hz.
pub(super) fn keys<'a>(n: &'a str, more: &[(&'a str, &'a str)]) -> Vec<(&'a str, &'a str)> {
    let mut all = vec![
        ("name", "own"),
        ("what", "filter"),
        ("n", n),
        ("sample_time", "0.015625"),
        ("tau", "0.625"),
        ("u_max", "inf"),
    ];
    all.retain(|(key, _)| !more.iter().any(|(own, _)| own == key));
    all.extend(more);
    all
}

pub(super) fn instance(keys: &[(&str, &str)]) -> Instance {
    let spec = read(keys).expect("a legal design");
    let code = samples::controller(&spec, spec.sampled().expect("samples"), Vec::new());
    code.check().expect("a program in order");
    Instance::new(&code, &[]).expect("legal parameters")
}

pub(super) fn step(own: &mut Instance, k: u32, x: &[f64], nominal: f64) -> (f64, Status) {
    let given = [("k", &[f64::from(k)][..]), ("x", x), ("u_nominal", &[nominal])];
    let outcome = own.call("step", &given);
    (outcome.results.get("u").map_or(0.0, |u| u[0]), outcome.status)
}

/// Order, bounds and poles of a filter, its upper bounds as numbers, u_max and g.
type Design = (&'static str, [&'static str; 3], [f64; 4], &'static str, f64);

/// Filters of each order for which no bound gives way.
const SOUND: [Design; 5] = [
    ("1", ["0.5", "-0.25", "-20"], [0.5, 0.0, 0.0, 0.0], "3", 1.0),
    ("2", ["0.5, 0.8", "-0.25, -1", "-10, -30"], [0.5, 0.8, 0.0, 0.0], "10", 1.0),
    ("2", ["0.5, 0.8", "-0.25, -1", "-10, -30"], [0.5, 0.8, 0.0, 0.0], "4", -2.5),
    ("3", ["1, 1, 6", "-1, -1, -6", "-5, -10, -15"], [1.0, 1.0, 6.0, 0.0], "150", 1.0),
    ("4", ["1, 1, 4, 60", "-1, -1, -4, -60", "-2, -5, -6, -7"], [1.0, 1.0, 4.0, 60.0], "1000", 1.0),
];

#[test]
fn bounds_are_kept_between_samples_under_any_controller() {
    let mut draw = Draw(11);
    for (n, [below, above, poles], upper, u_max, gain) in SOUND {
        let gain_text = gain.to_string();
        let more = [
            ("keep_below", below),
            ("keep_above", above),
            ("keep_poles", poles),
            ("u_max", u_max),
            ("g", gain_text.as_str()),
        ];
        let keys = keys(n, &more);
        let order = upper.iter().filter(|bound| **bound > 0.0).count();
        let lower: Vec<f64> = above.split(", ").map(|text| text.parse().expect("f64")).collect();
        for kind in 0..3 {
            let (mut own, mut plant) = (instance(&keys), Chain::new(&vec![0.0; order], gain));
            let mut changed = 0;
            for k in 0..300 {
                let nominal = match kind {
                    0 => 1e4,
                    1 => draw.between(-1.0, 1.0) * 10_f64.powf(draw.between(-2.0, 4.0)),
                    _ => {
                        if k / 40 % 2 == 0 {
                            -1e3
                        } else {
                            1e3
                        }
                    }
                };
                let (u, status) = step(&mut own, k, &plant.now(), nominal);
                match status {
                    Status::Ok => assert_eq!(u.to_bits(), nominal.to_bits()),
                    Status::Saturated => changed += usize::from(u != nominal),
                    other => panic!("n = {n}, sample {k}: {other:?}"),
                }
                for x in plant.step(u) {
                    for (i, x) in x.iter().enumerate() {
                        let room = TOLERANCE * upper[i].max(-lower[i]);
                        let within = lower[i] - room <= *x && *x <= upper[i] + room;
                        assert!(within, "n = {n}, sample {k}: x{} = {x}", i + 1);
                    }
                }
            }
            assert!(changed > 10, "n = {n}: the filter was not asked for anything");
        }
    }
}

#[test]
fn sound_means_that_no_bound_gives_way() {
    for (n, [below, above, poles], _, u_max, gain) in SOUND {
        let gain = gain.to_string();
        let of = |u_max: &str| {
            let more = [
                ("keep_below", below),
                ("keep_above", above),
                ("keep_poles", poles),
                ("u_max", u_max),
                ("g", gain.as_str()),
            ];
            let report = examine(&read(&keys(n, &more)).expect("a legal design"));
            let looped = report.outcomes.iter().find(|outcome| outcome.name == "loop");
            let looped = looped.expect("the check of the loop");
            (looped.verdict, looped.summary.clone())
        };
        assert_eq!(of(u_max).0, Verdict::Sound, "n = {n}: {}", of(u_max).1);
        // A chain of one integrator can always stop.
        let wanted = if n == "1" { Verdict::Sound } else { Verdict::Undecided };
        assert_eq!(of("0.01").0, wanted, "n = {n}: {}", of("0.01").1);
    }
    let one =
        read(&keys("2", &[("keep_below", "0.5"), ("keep_poles", "-10, -30"), ("u_max", "9")]));
    let report = examine(&one.expect("a legal design"));
    let looped = report.outcomes.iter().find(|outcome| outcome.name == "loop").expect("a check");
    assert!(looped.summary.contains("without an upper bound of x2"), "{}", looped.summary);
}

/// The edge of the cone at the greatest speed is where the whole limit of u is needed: with less of it the bound of x1
/// goes first, and the status says so.
#[test]
fn limits_of_u_are_needed_in_full() {
    // a_1 times the greatest speed.
    let rate = (1.0 - (-10.0_f64 / 64.0).exp()) * 64.0;
    let speed = 0.8;
    let z1 = 0.5 - speed / rate;
    let x = [z1 + speed / 128.0, speed];
    for (share, wanted) in [(1.001, Status::Saturated), (0.999, Status::Infeasible)] {
        let limit = (rate * speed * share).to_string();
        let more = [
            ("keep_below", "0.5, 0.8"),
            ("keep_above", "-0.5, -0.8"),
            ("keep_poles", "-10, -30"),
            ("u_max", &limit),
        ];
        let (_, status) = step(&mut instance(&keys("2", &more)), 0, &x, 5.0);
        assert_eq!(status, wanted, "{share} of what is needed");
    }
}

#[test]
fn starts_outside_return_by_the_deadline() {
    let mut draw = Draw(3);
    for n in ["1", "2", "3", "4"] {
        let poles = ["-3", "-7", "-20", "-25"];
        let order: usize = n.parse().expect("an order");
        let poles = poles[..order].join(", ");
        for weight in ["least-energy", "least-energy(weight=1)"] {
            let more = [("keep_below", "0.25"), ("keep_poles", poles.as_str()), ("poles", weight)];
            let keys = keys(n, &more);
            for _ in 0..4 {
                let x: Vec<_> = (0..order).map(|_| draw.between(-2.0, 2.0)).collect();
                let (mut own, mut plant) = (instance(&keys), Chain::new(&x, 1.0));
                for k in 0..80 {
                    let (u, status) = step(&mut own, k, &plant.now(), draw.between(-10.0, 50.0));
                    assert!(k < 60 || status != Status::Infeasible, "n = {n}, sample {k}");
                    for x in plant.step(u) {
                        assert!(k < 40 || x[0] <= 0.25 + 1e-9, "n = {n}, sample {k}: {}", x[0]);
                    }
                }
            }
        }
    }
}

#[test]
fn mistakes_are_named() {
    let filter = [("keep_below", "0.5, 0.8"), ("keep_above", "-0.5"), ("keep_poles", "-10, -30")];
    let cases = [
        ("mu", "exp(a=1)", "leave it out: a filter changes the u of any controller"),
        ("measured", "x1", "`measured` beside a filter, which has no law"),
        ("n", "5", "keeps the bounds of a chain of order 1..=4"),
        ("keep_poles", "-10", "give 2 numbers < 0"),
        ("keep_poles", "-10, 3", "give 2 numbers < 0"),
        ("keep_below", "1, 2, 3", "give the values of x1, x2, ... in this order"),
        ("keep_below", "-inf", "keep_below is a number or inf for each"),
        ("keep_below", "-0.6", "leave no room"),
        ("keep_below", "0.5, -1", "keep_below of x2 excludes 0, where x1 is at rest"),
        ("keep_above", "-1, 0.5", "keep_above of x2 excludes 0"),
        ("keep_tolerance", "0", "keep_tolerance is a number > 0"),
        ("poles", "-3, -4", "returns by least-energy"),
        ("f", "load", "give the known constant force as a number"),
        ("tau", "0.015625", "too few to come to rest"),
        ("clock", "time", "leave it out: a filter counts samples"),
    ];
    for (key, value, wanted) in cases {
        let mut all = keys("2", &filter);
        all.retain(|(own, _)| *own != key);
        all.push((key, value));
        let found = read(&all).expect_err(key);
        assert!(found.contains(wanted), "{key} = {value}: {found}");
        assert_eq!(found.lines().count(), 1, "{key} = {value}: {found}");
    }
    let missing = |key: &str| {
        let mut all = keys("2", &filter);
        all.retain(|(own, _)| *own != key);
        read(&all).expect_err(key)
    };
    for key in ["tau", "sample_time", "keep_poles", "n"] {
        assert!(missing(key).contains(&format!("`{key}` is missing")), "{key}: {}", missing(key));
    }
    let law = [("n", "2"), ("mu", "exp(a=1)"), ("keep_below", "1")];
    assert!(read(&law).expect_err("bounds").contains("`keep_below` without a filter"));
}

/// A filter written as a command is the same filter.
#[test]
fn commands_give_the_filter_back() {
    let more = [
        ("keep_below", "0.5, inf"),
        ("keep_above", "-inf, -0.8"),
        ("keep_poles", "-30, -10"),
        ("keep_tolerance", "1e-3, 1e-2"),
        ("poles", "least-energy(weight=1)"),
        ("delay", "1"),
        ("g", "2"),
        ("u_max", "10"),
        ("u_min", "-8"),
    ];
    let spec = read(&keys("2", &more)).expect("a legal design");
    let command = spec.command();
    for flag in ["--what filter", "--keep-below=0.5,inf", "--keep-poles=-10,-30", "--delay=1"] {
        assert!(command.contains(flag), "{flag}: {command}");
    }
    assert!(!command.contains("--mu") && !command.contains("--clock"), "{command}");
}

/// In single precision a bound of 0 and one that approaches it differ by less than the rounding of u.
#[test]
fn rounding_makes_no_bound_give_way() {
    let more = [
        ("sample_time", "1e-3"),
        ("tau", "0.4"),
        ("keep_below", "0.5, 0.8"),
        ("keep_above", "-0.5, 0"),
        ("keep_poles", "-10, -40"),
        ("u_max", "10"),
        ("precision", "f32"),
    ];
    let mut own = instance(&keys("2", &more));
    let mut x = [0.0_f32; 2];
    for k in 0..4000 {
        let given = x.map(f64::from);
        let (u, status) = step(&mut own, k, &given, 1e3);
        assert_eq!(status, Status::Saturated, "{x:?} at {k}");
        #[allow(clippy::cast_possible_truncation)]
        let next = [given[0] + 1e-3 * given[1] + 5e-7 * u, given[1] + 1e-3 * u].map(|x| x as f32);
        x = next;
    }
    assert!((x[0] - 0.5).abs() < 1e-3, "{x:?}");
}

/// Bounds of position and speed with these tolerances, and the limit of u.
fn tolerant<'a>(tolerance: &'a str, u_max: &'a str) -> Vec<(&'a str, &'a str)> {
    let more = [
        ("keep_below", "0.5, 0.8"),
        ("keep_above", "-0.5, -0.8"),
        ("keep_poles", "-10, -30"),
        ("keep_tolerance", tolerance),
        ("u_max", u_max),
    ];
    keys("2", &more)
}

/// Samples in which a bound has to give way, from random states that are safe up to the tolerance.
fn given_way(keys: &[(&str, &str)], tolerance: [f64; 2]) -> usize {
    let (h, mut draw) = (1.0 / 64.0, Draw(5));
    let slowest = (1.0 - f64::exp(-10.0 * h)) / h;
    let mut count = 0;
    for run in 0..40 {
        let side = if run % 2 == 0 { 1.0 } else { -1.0 };
        let inside = 1.0 - 1e-9;
        let part = match run % 4 < 2 {
            true => draw.between(0.9, inside),
            false => draw.between(0.0, 0.2),
        };
        let speed = side * (0.8 + tolerance[1]) * part;
        // On the edge of the cone: z_1 + z_2/a = b.
        let flat = side * (0.5 + tolerance[0]) * inside - speed / slowest;
        let x = [flat + h / 2.0 * speed, speed];
        let (mut own, mut plant) = (instance(keys), Chain::new(&x, 1.0));
        for k in 0..20 {
            let nominal = draw.between(-1.0, 1.0) * 1e3;
            let (u, status) = step(&mut own, k, &plant.now(), nominal);
            count += usize::from(status == Status::Infeasible);
            plant.step(u);
        }
    }
    count
}

/// A state that is beyond its bounds by their tolerance counts as safe, so that what is promised from there needs more of
/// the limits.
#[test]
fn tolerance_counts_in_the_condition_on_u() {
    let designs = [
        ("0.001, 0.1", [0.001, 0.1], "7.5", Verdict::Undecided),
        ("0.001, 0.1", [0.001, 0.1], "8.4", Verdict::Sound),
        ("0.1, 0.001", [0.1, 0.001], "100", Verdict::Undecided),
        ("0.05, 0.001", [0.05, 0.001], "100", Verdict::Sound),
    ];
    for (tolerance, numbers, u_max, verdict) in designs {
        let keys = tolerant(tolerance, u_max);
        let spec = read(&keys).expect("a legal design");
        let report = examine(&spec);
        let of_loop = report.outcomes.iter().find(|own| own.name == "loop").expect("a check");
        assert_eq!(of_loop.verdict, verdict, "{tolerance}, {u_max}: {}", of_loop.summary);
        let count = given_way(&keys, numbers);
        assert_eq!(count == 0, verdict == Verdict::Sound, "{tolerance}, {u_max}: {count}");
    }
}

/// The limit of u that `check` names is enough, as it is printed.
#[test]
fn named_limit_is_enough() {
    let told = |u_max: &str| {
        let spec = read(&tolerant("0.001, 0.1", u_max)).expect("a legal design");
        let report = examine(&spec);
        let of_loop = report.outcomes.into_iter().find(|own| own.name == "loop");
        of_loop.expect("a check").summary
    };
    let named = told("7.5");
    let number = named.split("u = -").nth(1).and_then(|rest| rest.split(',').next());
    let number = number.expect("a limit").to_owned();
    assert!(told(&number).starts_with("from every safe state"), "{number}: {}", told(&number));
}
