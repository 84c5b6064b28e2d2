//! Deadlines that change while the controller runs, in the loop with a chain of the test's own.

use ptc_codegen::code::{Code, Instance, Status};

use super::{code, read};

const SOONEST: &str = include_str!("../../../../tests/data/soonest.json");

/// Sample period of all of them, in s.
const H: f64 = 0.01;

/// Share of a limit that roundings may take.
pub(super) const ROUNDED: f64 = 1.0 + 1e-9;

/// Numbers that look random, the same in every run.
pub(super) struct Draw(pub(super) u64);

impl Draw {
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        #[allow(clippy::cast_precision_loss)]
        let part = (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
        low + (high - low) * part
    }

    pub(super) fn state(&mut self, n: usize, size: f64) -> Vec<f64> {
        (0..n).map(|_| self.between(-size, size)).collect()
    }
}

/// x_i' = x_{i+1}, x_n' = u + force, u held for a sample and as many samples late as there are inputs under way.
pub(super) struct Chain {
    pub(super) x: Vec<f64>,
    under_way: Vec<f64>,
    force: f64,
}

impl Chain {
    pub(super) fn new(x: &[f64], late: usize) -> Self {
        Self { x: x.to_vec(), under_way: vec![0.0; late], force: 0.0 }
    }

    pub(super) fn step(&mut self, u: f64) {
        self.under_way.push(u);
        let acts = self.under_way.remove(0) + self.force;
        for i in 0..self.x.len() {
            let (mut sum, mut share) = (0.0, 1.0);
            for (power, value) in (1_u32..).zip(self.x[i..].iter().chain([&acts])) {
                sum += value * share;
                share *= H / f64::from(power);
            }
            self.x[i] = sum;
        }
    }

    pub(super) fn size(&self) -> f64 {
        self.x.iter().fold(0.0, |most, x| most.max(x.abs()))
    }
}

/// A controller that runs.
pub(super) struct Run {
    own: Instance,
    given: &'static str,
    measured: usize,
}

impl Run {
    pub(super) fn new(code: &Code, given: &'static str, measured: usize) -> Self {
        Self { own: Instance::new(code, &[]).expect("legal parameters"), given, measured }
    }

    pub(super) fn call(&mut self, name: &str, given: &[(&str, &[f64])]) -> Status {
        self.own.call(name, given).status
    }

    pub(super) fn soonest(&mut self, x: &[f64]) -> Option<u32> {
        let given: &[(&str, &[f64])] = if self.given == "x" { &[("x", x)] } else { &[] };
        let outcome = self.own.call("soonest", given);
        let samples = outcome.results.get("samples").map(|all| all[0]);
        (outcome.status == Status::Ok).then(|| count(samples.expect("a count")))
    }

    pub(super) fn arm_for(&mut self, k: u32, samples: u32) -> Status {
        self.call("arm_for", &[("k", &[f64::from(k)]), ("samples", &[f64::from(samples)])])
    }

    pub(super) fn deadline(&mut self) -> u32 {
        count(self.own.call("deadline", &[]).results["k"][0])
    }

    pub(super) fn step(&mut self, k: u32, x: &[f64]) -> (f64, Status) {
        let (u, status) = self.steps(k, x);
        (u[0], status)
    }

    /// Every u.
    pub(super) fn steps(&mut self, k: u32, x: &[f64]) -> (Vec<f64>, Status) {
        let given = [("k", &[f64::from(k)][..]), (self.given, &x[..self.measured])];
        let outcome = self.own.call("step", &given);
        (outcome.results["u"].clone(), outcome.status)
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(super) fn count(value: f64) -> u32 {
    value as u32
}

/// The design of a chain at 100 Hz with u from -5 to 5.
fn chain(n: usize, more: &[(&str, &str)]) -> Code {
    let n = n.to_string();
    let mut keys = vec![
        ("n", n.as_str()),
        ("tau", "1"),
        ("sample_time", "0.01"),
        ("eps", "0"),
        ("poles", "least-energy"),
        ("u_max", "5"),
        ("in_flight", "true"),
    ];
    keys.retain(|(key, _)| !more.iter().any(|(own, _)| own == key));
    keys.extend(more);
    code(&keys)
}

/// The least N that is kept of known cases, found by trying each N: `soonest` finds it, or one a little later.
#[test]
fn soonest_deadlines_are_the_least_that_are_kept() {
    let cases: serde_json::Value = serde_json::from_str(SOONEST).expect("JSON");
    let mut seen = 0;
    for case in cases.as_array().expect("a list") {
        let n = usize::try_from(case["n"].as_u64().expect("an order")).expect("a small order");
        let poles = format!("least-energy(weight={})", case["weight"]);
        let most = case["u_max"].to_string();
        let code = chain(n, &[("poles", &poles), ("u_max", &most)]);
        let x: Vec<f64> =
            case["x0"].as_array().expect("a state").iter().filter_map(|x| x.as_f64()).collect();
        let found = Run::new(&code, "x", n).soonest(&x).expect("a deadline");
        if let Some(first) = case["first_feasible"].as_u64() {
            let first = u32::try_from(first).expect("a count");
            assert!(
                found >= first && f64::from(found) <= 1.15 * f64::from(first),
                "{case}: {found}"
            );
            seen += 1;
        }
    }
    assert!(seen > 20, "{seen} cases");
}

/// With the soonest deadline nothing is clipped, no state exceeds its bound, and the chain is at rest.
#[test]
fn soonest_deadlines_keep_every_limit() {
    let mut draw = Draw(1);
    let designs: [(usize, &[(&str, &str)]); 7] = [
        (1, &[("poles", "least-energy(weight=1)")]),
        (2, &[]),
        (2, &[("state_max", "[inf, 0.8]")]),
        (2, &[("poles_end", "least-energy(weight=1)"), ("end_samples", "30")]),
        (2, &[("poles", "[-4, -5]"), ("u_min", "-2"), ("u_max", "5")]),
        (3, &[("state_max", "[inf, 0.8, 6]"), ("reserve", "0.2")]),
        (3, &[("poles_end", "least-energy(weight=2)"), ("end_samples", "25")]),
    ];
    for (n, more) in designs {
        let code = chain(n, more);
        let mut run = Run::new(&code, "x", n);
        let mut found = 0;
        for _ in 0..25 {
            let x = draw.state(n, 0.7);
            let Some(samples) = run.soonest(&x) else { continue };
            found += 1;
            let k = count(draw.between(0.0, 4_294_967_295.0));
            assert_eq!(run.arm_for(k, samples), Status::Ok);
            assert_eq!(run.deadline(), k.wrapping_add(samples));
            let mut own = Chain::new(&x, 0);
            for elapsed in 0..samples {
                let (u, status) = run.step(k.wrapping_add(elapsed), &own.x);
                let about = format!("{n} {more:?} {x:?}: u = {u} at {elapsed} of {samples}");
                assert_eq!(status, Status::Ok, "{about}");
                assert!(u.abs() <= 5.0 * ROUNDED, "{about}");
                let bounded = more.iter().any(|(key, _)| *key == "state_max");
                assert!(!bounded || own.x[1].abs() <= 0.8 * ROUNDED, "{about}: {:?}", own.x);
                own.step(u);
            }
            assert!(own.size() < 1e-10, "{n} {more:?} {x:?}: {:?}", own.x);
        }
        assert!(found > 15, "{n} {more:?}: {found} deadlines");
    }
}

/// Between limits that differ a plan may take more of one than of the other, up to the last sample.
#[test]
fn soonest_deadlines_are_kept_between_limits_that_differ() {
    let mut draw = Draw(3);
    let designs: [(usize, &[(&str, &str)]); 4] = [
        (1, &[]),
        (2, &[]),
        (2, &[("poles", "[-4, -5]"), ("state_max", "[inf, 0.8]")]),
        (3, &[("poles", "least-energy(weight=1)")]),
    ];
    for (n, more) in designs {
        let limits = [("late", "extend"), ("u_min", "-2"), ("u_max", "5")];
        let code = chain(n, &[more, &limits].concat());
        let mut run = Run::new(&code, "x", n);
        let mut found = 0;
        for _ in 0..40 {
            let x = draw.state(n, 0.7);
            let Some(samples) = run.soonest(&x) else { continue };
            found += 1;
            assert_eq!(run.arm_for(0, samples), Status::Ok);
            let mut own = Chain::new(&x, 0);
            for k in 0..samples {
                let (u, status) = run.step(k, &own.x);
                let about = format!("{n} {more:?} {x:?}: u = {u} at {k} of {samples}");
                assert_eq!(status, Status::Ok, "{about}");
                assert!((-2.0 * ROUNDED..=5.0 * ROUNDED).contains(&u), "{about}");
                own.step(u);
            }
            assert!(own.size() < 1e-10, "{n} {more:?} {x:?}: {:?}", own.x);
        }
        assert!(found > 25, "{n} {more:?}: {found} deadlines");
    }
}

/// A chain that is held, and one that is kicked: the deadline is put off, never moved forward, nothing is clipped, and
/// the chain is at rest at the deadline that is told.
#[test]
fn late_deadlines_are_put_off() {
    let mut draw = Draw(2);
    for (n, more) in [(2, &[][..]), (3, &[("precision", "f32")][..])] {
        let code = chain(n, &[more, &[("late", "extend")]].concat());
        for _ in 0..10 {
            let x = draw.state(n, 0.5);
            let (held, kicked) = (count(draw.between(0.0, 60.0)), count(draw.between(60.0, 250.0)));
            let mut run = Run::new(&code, "x", n);
            let mut own = Chain::new(&x, 0);
            let (mut deadline, mut late, mut k) = (run.deadline(), 0, 0);
            while k < deadline.max(300) {
                let (u, status) = run.step(k, &own.x);
                let now = run.deadline();
                assert!(now >= deadline, "{n} {x:?}: {deadline} and then {now} at {k}");
                assert_eq!(status == Status::Late, now > deadline, "{n} {x:?} at {k}");
                assert_ne!(status, Status::Saturated, "{n} {x:?} at {k}");
                (deadline, late) = (now, late + u32::from(status == Status::Late));
                own.step(u);
                if k < held {
                    own.x.clone_from(&x);
                }
                if k == kicked {
                    own.x[n - 1] += 1.0;
                }
                k += 1;
            }
            let allowed = if more.is_empty() { 1e-10 } else { 1e-4 };
            assert!(own.size() < allowed, "{n} {x:?}: {:?}", own.x);
            assert!(late > 0 || held < 5, "{n} {x:?}: never late");
        }
    }
}

/// A pace brings the chain to rest sooner, and no later than the soonest deadline from the start.
#[test]
fn pace_lowers_the_deadline() {
    let mut draw = Draw(3);
    let code = chain(2, &[("poles", "least-energy(weight=1)"), ("pace", "soonest")]);
    for _ in 0..10 {
        let x = draw.state(2, 0.5);
        let mut run = Run::new(&code, "x", 2);
        let first = run.soonest(&x).expect("a deadline");
        run.arm_for(0, first);
        let mut own = Chain::new(&x, 0);
        let mut k = 0;
        while k < run.deadline() {
            let (u, status) = run.step(k, &own.x);
            assert!(matches!(status, Status::Ok), "{x:?}: {status:?} at {k}");
            own.step(u);
            k += 1;
        }
        assert!(k <= first && own.size() < 1e-10, "{x:?}: {k} of {first}, {:?}", own.x);
    }
}

/// `arm_for` of a controller that refuses takes the soonest deadline, and changes nothing for one sample less.
#[test]
fn too_soon_is_refused() {
    let code = chain(2, &[("late", "refuse")]);
    let mut run = Run::new(&code, "x", 2);
    let x = [0.4, -0.1];
    let soonest = run.soonest(&x).expect("a deadline");
    let asked = |run: &mut Run, samples: u32| {
        let samples = [f64::from(samples)];
        run.call("arm_for", &[("k", &[7.0]), ("samples", &samples), ("x", &x)])
    };
    assert_eq!(asked(&mut run, soonest - 1), Status::Soon);
    assert_eq!(run.deadline(), 100);
    assert_eq!(asked(&mut run, soonest), Status::Ok);
    assert_eq!(run.deadline(), 7 + soonest);
}

/// What a design cannot mean is a status, and changes nothing.
#[test]
fn bad_input_changes_nothing() {
    let code = chain(2, &[("measured", "[x1]"), ("observer_poles", "[-4, -5]"), ("delay", "1")]);
    let mut run = Run::new(&code, "y", 1);
    for samples in [0, 1, 2, (1 << 31) + 1, u32::MAX] {
        assert_eq!(run.arm_for(3, samples), Status::Param, "{samples}");
    }
    for value in [f64::NAN, f64::INFINITY] {
        assert_eq!(run.call("move", &[("dx", &[value])]), Status::Input);
        assert_eq!(run.call("applied", &[("u", &[value])]), Status::Input);
        assert_eq!(run.call("assume", &[("xhat", &[0.0, value])]), Status::Input);
    }
    assert_eq!(run.deadline(), 100);
    assert_eq!(run.own.call("estimate", &[]).results["xhat"], [0.0, 0.0]);
    let free = chain(2, &[("state_max", "[inf, 0.5]")]);
    assert_eq!(Run::new(&free, "x", 2).soonest(&[0.1, 0.6]), None, "beyond its bound already");
}

/// Targets that move, states and forces that are known, inputs that the drive changed, deadlines: in any order the
/// chain is at rest at the last one.
#[test]
fn corrections_in_any_order_end_at_rest() {
    let mut draw = Draw(4);
    let keys = [
        ("measured", "[x1]"),
        ("disturbance", "constant"),
        ("observer_poles", "[-4, -5, -6]"),
        ("observer_samples", "40"),
        ("delay", "2"),
        ("delay_law", "predict"),
        ("u_max", "inf"),
    ];
    let code = chain(2, &keys);
    for _ in 0..20 {
        let mut run = Run::new(&code, "y", 1);
        let mut own = Chain::new(&draw.state(2, 0.5), 2);
        own.force = draw.between(-1.0, 1.0);
        let mut k = 0;
        for _ in 0..6 {
            for _ in 0..count(draw.between(1.0, 60.0)) {
                let (mut u, _) = run.step(k, &own.x);
                if draw.between(0.0, 1.0) < 0.1 {
                    u *= draw.between(0.5, 1.0);
                    assert_eq!(run.call("applied", &[("u", &[u])]), Status::Ok);
                }
                own.step(u);
                k += 1;
            }
            match count(draw.between(0.0, 3.0)) {
                0 => {
                    let dx = draw.between(-0.2, 0.2);
                    assert_eq!(run.call("move", &[("dx", &[dx])]), Status::Ok);
                    own.x[0] -= dx;
                }
                1 => {
                    own.x[1] += draw.between(-0.3, 0.3);
                    run.call("assume_disturbance", &[("d", &[own.force])]);
                    assert_eq!(run.call("assume", &[("xhat", &own.x)]), Status::Ok);
                }
                _ => {}
            }
            assert_eq!(run.arm_for(k, 120), Status::Ok);
        }
        for _ in 0..125 {
            let (u, _) = run.step(k, &own.x);
            own.step(u);
            k += 1;
        }
        assert!(own.size() < 1e-9, "{:?}", own.x);
    }
}

/// Designs without a plan are refused with the reason.
#[test]
fn deadlines_without_a_plan_are_refused() {
    let base = [
        ("mu", "exp(a=1)"),
        ("clock", "samples"),
        ("n", "2"),
        ("tau", "1"),
        ("sample_time", "0.01"),
        ("eps", "0"),
        ("u_max", "5"),
    ];
    for (more, message) in [
        (&[("poles", "[-4, -5]"), ("reserve", "0.1")][..], "without a deadline that is planned"),
        (&[("poles", "[-2.5, -4]"), ("late", "extend")], "no closed form to its end"),
        (&[("poles", "least-energy"), ("late", "extend"), ("u_max", "inf")], "without a limit"),
        (&[("poles", "least-energy"), ("late", "extend"), ("reference", "input")], "a reference"),
        (&[("poles", "least-energy"), ("late", "refuse"), ("pace", "soonest")], "another `late`"),
        (&[("poles", "least-energy"), ("late", "extend"), ("reserve", "1")], "not a part"),
        (&[("poles", "least-energy"), ("late", "extend"), ("state_max", "[0, 1]")], "not > 0"),
        (
            &[("poles", "least-energy"), ("late", "extend"), ("axes", "2"), ("reference", "input")],
            "a reference",
        ),
        (
            &[
                ("poles", "least-energy"),
                ("late", "extend"),
                ("axes", "2"),
                ("state_max", "[[inf, 1]]"),
            ],
            "1 value of `state_max` for 2 axes",
        ),
        (
            &[("poles", "least-energy"), ("late", "extend"), ("state_max", "[[inf, 1], [1, 1]]")],
            "`axes` is not given",
        ),
    ] {
        let mut keys = base.to_vec();
        keys.retain(|(key, _)| !more.iter().any(|(own, _)| own == key));
        keys.extend(more);
        let found = read(&keys).expect_err("a mistake");
        assert!(found.contains(message) && found.lines().count() == 1, "{message}: {found}");
    }
}
