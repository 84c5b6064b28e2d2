//! Deadlines in flight of several axes: one sample of rest for all, at the smallest N that every axis can keep.

use ptc_codegen::code::{Code, Status};

use super::code;
use super::flight::{Chain, Draw, ROUNDED, Run, count};

/// The keys that axes have of their own.
struct Axis {
    poles: &'static str,
    limit: &'static str,
    state_max: &'static str,
    gain: &'static str,
}

const AXES: [Axis; 3] = [
    Axis { poles: "[-2, -3]", limit: "5", state_max: "[inf, 0.8]", gain: "1" },
    Axis { poles: "[-3, -4]", limit: "40", state_max: "[inf, inf]", gain: "1/3" },
    Axis { poles: "[-2, -3]", limit: "2", state_max: "[2, 1.5]", gain: "2" },
];

/// The true input gains.
const GAINS: [f64; 3] = [1.0, 1.0 / 3.0, 2.0];

/// Limits of u and of the second state.
const LIMITS: [(f64, f64); 3] = [(5.0, 0.8), (40.0, f64::INFINITY), (2.0, 1.5)];

/// A design at 100 Hz of chains of order 2.
fn design(more: &[(&str, &str)]) -> Code {
    let mut keys = vec![
        ("n", "2"),
        ("tau", "1"),
        ("sample_time", "0.01"),
        ("eps", "0"),
        ("in_flight", "true"),
        ("poles_end", "least-energy(weight=2)"),
        ("end_samples", "12"),
    ];
    keys.extend(more);
    code(&keys)
}

/// The first axes of [`AXES`] as one controller.
fn together(count: usize, more: &[(&str, &str)]) -> Code {
    let listed = |of: fn(&Axis) -> &'static str| {
        let all: Vec<_> = AXES[..count].iter().map(of).collect();
        format!("[{}]", all.join(", "))
    };
    let number = count.to_string();
    let [poles, limits, bounds, gains] = [
        listed(|own| own.poles),
        listed(|own| own.limit),
        listed(|own| own.state_max),
        listed(|own| own.gain),
    ];
    let mut keys = vec![
        ("axes", number.as_str()),
        ("poles", poles.as_str()),
        ("limits", limits.as_str()),
        ("state_max", bounds.as_str()),
        ("g", gains.as_str()),
    ];
    keys.extend(more);
    design(&keys)
}

/// Each of them alone.
fn alone(count: usize, more: &[(&str, &str)]) -> Vec<Run> {
    let one = |own: &Axis| {
        let mut keys = vec![
            ("poles", own.poles),
            ("u_max", own.limit),
            ("state_max", own.state_max),
            ("g", own.gain),
        ];
        keys.extend(more);
        Run::new(&design(&keys), "x", 2)
    };
    AXES[..count].iter().map(one).collect()
}

/// The chains of the axes, and their states one after the other.
struct Plants(Vec<Chain>);

impl Plants {
    fn new(x: &[f64]) -> Self {
        Self(x.chunks(2).map(|x| Chain::new(x, 0)).collect())
    }

    fn x(&self) -> Vec<f64> {
        self.0.iter().flat_map(|own| own.x.clone()).collect()
    }

    fn step(&mut self, u: &[f64]) {
        for ((own, u), gain) in self.0.iter_mut().zip(u).zip(GAINS) {
            own.step(gain * u);
        }
    }

    fn size(&self) -> f64 {
        self.0.iter().map(Chain::size).fold(0.0, f64::max)
    }

    /// The limits that are kept.
    fn keep(&self, u: &[f64]) -> bool {
        let mut each = self.0.iter().zip(u).zip(LIMITS);
        each.all(|((own, u), (most, speed))| {
            u.abs() <= most * ROUNDED && own.x[1].abs() <= speed * ROUNDED
        })
    }
}

/// The number found is the least that every axis keeps by itself, each N being tried, up to the search.
#[test]
fn soonest_is_the_least_that_all_axes_keep() {
    let mut draw = Draw(11);
    for count in [2, 3] {
        let mut run = Run::new(&together(count, &[]), "x", 2 * count);
        let mut each = alone(count, &[("late", "refuse")]);
        let mut exact = 0;
        for _ in 0..25 {
            let x = draw.state(2 * count, 0.5);
            let mut kept = |samples: u32| {
                each.iter_mut().zip(x.chunks(2)).all(|(own, x)| {
                    let samples = [f64::from(samples)];
                    own.call("arm_for", &[("k", &[0.0]), ("samples", &samples), ("x", x)])
                        == Status::Ok
                })
            };
            let found = run.soonest(&x).expect("a deadline");
            assert!(kept(found), "{count} {x:?}: {found}");
            assert!(!kept(found - 1), "{count} {x:?}: {found} and one less");
            let least = (3..=found).find(|samples| kept(*samples));
            exact += u32::from(least == Some(found));
        }
        assert!(exact > 20, "{count}: {exact}");
    }
}

/// With the soonest deadline no limit is exceeded, and all axes are at rest at it; the inputs are those of each axis alone.
#[test]
fn axes_arrive_together_within_their_limits() {
    let mut draw = Draw(12);
    for count_of in [2, 3] {
        let mut run = Run::new(&together(count_of, &[]), "x", 2 * count_of);
        let mut each = alone(count_of, &[]);
        for _ in 0..15 {
            let x = draw.state(2 * count_of, 0.6);
            let samples = run.soonest(&x).expect("a deadline");
            let k = count(draw.between(0.0, 4_294_967_295.0));
            assert_eq!(run.arm_for(k, samples), Status::Ok);
            assert_eq!(run.deadline(), k.wrapping_add(samples));
            each.iter_mut().for_each(|own| assert_eq!(own.arm_for(k, samples), Status::Ok));
            let mut own = Plants::new(&x);
            for elapsed in 0..samples {
                let k = k.wrapping_add(elapsed);
                let (u, status) = run.steps(k, &own.x());
                assert_eq!(status, Status::Ok, "{x:?} at {elapsed} of {samples}");
                assert!(own.keep(&u), "{x:?} at {elapsed} of {samples}: {u:?} {:?}", own.x());
                for ((alone, chain), u) in each.iter_mut().zip(&own.0).zip(&u) {
                    assert_eq!(alone.step(k, &chain.x).0.to_bits(), u.to_bits());
                }
                own.step(&u);
            }
            assert!(own.size() < 1e-10, "{x:?}: {:?}", own.x());
        }
    }
}

/// An axis that is held puts the deadline of all off: they are at rest together at the deadline that is told.
#[test]
fn held_axis_puts_all_off() {
    let mut draw = Draw(13);
    for pace in ["deadline", "soonest"] {
        let more = [("late", "extend"), ("pace", pace)];
        let mut run = Run::new(&together(3, &more), "x", 6);
        for _ in 0..10 {
            let x = draw.state(6, 0.3);
            run.arm_for(0, 60);
            let held = count(draw.between(20.0, 120.0));
            let axis = usize::from(count(draw.between(0.0, 3.0)) as u8).min(2);
            let mut own = Plants::new(&x);
            let (mut deadline, mut late, mut k) = (run.deadline(), 0, 0);
            while k < run.deadline().max(held + 1) {
                let (u, status) = run.steps(k, &own.x());
                let now = run.deadline();
                assert_eq!(status == Status::Late, now > deadline, "{x:?} at {k}");
                assert!(pace == "soonest" || now >= deadline, "{x:?} at {k}");
                assert_ne!(status, Status::Saturated, "{x:?} at {k}");
                assert!(own.keep(&u), "{x:?} at {k}: {u:?} {:?}", own.x());
                (deadline, late) = (now, late + u32::from(status == Status::Late));
                own.step(&u);
                if k < held {
                    own.0[axis].x = x[2 * axis..2 * axis + 2].to_vec();
                }
                k += 1;
            }
            assert!(late > 0 && own.size() < 1e-10, "{x:?}: {late} {:?}", own.x());
        }
    }
}

/// A call that fails leaves the deadline as it was.
#[test]
fn failed_step_keeps_the_deadline() {
    let mut run = Run::new(&together(2, &[("late", "extend")]), "x", 4);
    run.arm_for(5, 80);
    for wrong in [f64::NAN, f64::INFINITY, 1e308] {
        let (u, status) = run.steps(6, &[0.1, 0.0, wrong, wrong]);
        assert!(matches!(status, Status::Input | Status::Range), "{wrong}: {status:?}");
        assert_eq!((u, run.deadline()), (vec![0.0; 2], 85));
    }
    assert_eq!(run.soonest(&[0.1, 0.9, 0.0, 0.0]), None, "beyond its bound already");
}
