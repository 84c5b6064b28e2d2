//! Plants with other states than the law: rates by hand, matrices, and one resonance, against two inertias written
//! down as such and integrated here.

use super::support::{folder_with, run_in};

/// A run: the names of the columns, and the rows.
struct Course {
    head: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Course {
    fn of(test: &str, design: &str, further: &[&str]) -> Self {
        let folder = folder_with(&format!("larger_{test}"), "design.toml", design);
        let (code, csv, stderr) =
            run_in(&folder, &[&["simulate", "design.toml"], further].concat());
        assert_eq!(code, Some(0), "{design}\n{stderr}");
        let (head, rows) = csv.split_once('\n').expect("a head");
        let numbers = |line: &str| line.split(',').filter_map(|cell| cell.parse().ok()).collect();
        let head = head.split(',').map(str::to_owned).collect();
        Self { head, rows: rows.lines().map(numbers).collect() }
    }

    fn column(&self, name: &str) -> Vec<f64> {
        let place = self.head.iter().position(|own| own == name);
        let place = place.unwrap_or_else(|| panic!("{name} of {:?}", self.head));
        self.rows.iter().map(|row| row[place]).collect()
    }
}

fn near(what: &str, found: &[f64], wanted: &[f64], within: f64) {
    assert_eq!(found.len(), wanted.len(), "{what}");
    let size = wanted.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for (k, (a, b)) in found.iter().zip(wanted).enumerate() {
        assert!((a - b).abs() <= within * size, "{what}, row {k}: {a}, not {b}");
    }
}

/// A controller of a rigid axis of 1 + r = 3.5 kg in samples, with an observer and an input that acts a sample late.
const SAMPLES: &str = "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\ndelay = 1\n\
     poles = [-4, -4.5, -5]\nmeasured = \"x1\"\nobserver_poles = [-5, -6, -7]\ndisturbance = \"constant\"\n\
     g = \"1/3.5\"\neps = 0.1\n[params]\ntau = 0.5\n";

/// The same in time, held from an eps on.
const TIME: &str = "n = 2\nmu = \"exp(a=1)\"\nsample_time = 1e-3\npoles = [-4, -5]\ng = \"1/3.5\"\n[params]\n\
     tau = 0.5\neps = 0.1\n";

/// Two masses as four states: K of the spring from the frequency of both, with viscous friction on one of them.
struct TwoMasses {
    motor: f64,
    load: f64,
    spring: f64,
    damper: f64,
    /// Friction in N s/m of motor and load.
    friction: [f64; 2],
}

impl TwoMasses {
    /// Creates masses of 3.5 kg in the ratio 6, with a resonance in Hz and its damping ratio.
    fn new(hertz: f64, damping: f64, friction: [f64; 2]) -> Self {
        let (motor, load) = (0.5, 3.0);
        let reduced: f64 = 1.0 / (1.0 / motor + 1.0 / load);
        let omega = 2.0 * std::f64::consts::PI * hertz;
        Self {
            motor,
            load,
            spring: reduced * omega * omega,
            damper: 2.0 * damping * omega * reduced,
            friction,
        }
    }

    fn rates(&self, x: &[f64; 4], u: f64) -> [f64; 4] {
        let [a, b, v, w] = *x;
        let force = self.spring * (a - b) + self.damper * (v - w);
        [
            v,
            w,
            (u - force - self.friction[0] * v) / self.motor,
            (force - self.friction[1] * w) / self.load,
        ]
    }

    /// The state after a time in which u is held, by steps of Runge and Kutta.
    fn after(&self, mut x: [f64; 4], u: f64, time: f64) -> [f64; 4] {
        const STEPS: u32 = 400;
        let h = time / f64::from(STEPS);
        let plus = |x: &[f64; 4], k: &[f64; 4], part: f64| -> [f64; 4] {
            std::array::from_fn(|i| x[i] + part * h * k[i])
        };
        for _ in 0..STEPS {
            let k1 = self.rates(&x, u);
            let k2 = self.rates(&plus(&x, &k1, 0.5), u);
            let k3 = self.rates(&plus(&x, &k2, 0.5), u);
            let k4 = self.rates(&plus(&x, &k3, 1.0), u);
            for i in 0..4 {
                x[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
            }
        }
        x
    }

    /// The table `[plant]` with these masses as states, of which one side is measured.
    fn as_states(&self, measured: &str) -> String {
        let [a, b] = self.friction;
        let (m, l, k, c) = (self.motor, self.load, self.spring, self.damper);
        let outputs = if measured == "motor" { "\"motor\", \"v\"" } else { "\"load\", \"w\"" };
        format!(
            "[plant]\nstates = [\"motor\", \"load\", \"v\", \"w\"]\noutputs = [{outputs}]\n\
             dynamics = {{ motor = \"v\", load = \"w\", v = \"(u - {k:?}*(motor - load) - {c:?}*(v - w) - {a:?}*v)/{m:?}\", \
             w = \"({k:?}*(motor - load) + {c:?}*(v - w) - {b:?}*w)/{l:?}\" }}\n"
        )
    }

    /// The same with matrices, and friction beside them.
    fn as_matrices(&self, measured: &str) -> String {
        let [a, b] = self.friction;
        let (m, l) = (self.motor, self.load);
        let (k, c) = (self.spring, self.damper);
        let rows = if measured == "motor" {
            "[[1, 0, 0, 0], [0, 0, 1, 0]]"
        } else {
            "[[0, 1, 0, 0], [0, 0, 0, 1]]"
        };
        format!(
            "[plant]\nstates = [\"motor\", \"load\", \"v\", \"w\"]\nC = {rows}\nB = [0, 0, {:?}, 0]\n\
             A = [[0, 0, 1, 0], [0, 0, 0, 1], [{:?}, {:?}, {:?}, {:?}], [{:?}, {:?}, {:?}, {:?}]]\n\
             added = {{ v = \"-{:?}*v\", w = \"-{:?}*w\" }}\n",
            1.0 / m,
            -k / m,
            k / m,
            -c / m,
            c / m,
            k / l,
            -k / l,
            c / l,
            -c / l,
            a / m,
            b / l
        )
    }
}

/// The friction of one side as f of a resonance.
fn resonance(hertz: f64, damping: f64, measured: &str, friction: [f64; 2]) -> String {
    let (side, size) =
        if friction[0] > 0.0 { ("motor", friction[0]) } else { ("load", friction[1]) };
    format!(
        "[plant]\nf = \"-{size:?}*x2/3.5\"\nresonance = {{ frequency_hz = {hertz:?}, damping = {damping:?}, \
         inertia_ratio = 6, measured = \"{measured}\", f = \"{side}\" }}\n"
    )
}

#[test]
fn resonance_equals_two_masses_on_either_side() {
    for (clock, design) in [("samples", SAMPLES), ("time", TIME)] {
        for measured in ["motor", "load"] {
            for friction in [[2.0, 0.0], [0.0, 2.0]] {
                let (hertz, damping) = (400.0, 0.05);
                let masses = TwoMasses::new(hertz, damping, friction);
                let what = format!("{clock} {measured} {friction:?}");
                let name = what.replace([' ', '[', ']', ',', '.'], "");
                let spring = format!("{design}{}", resonance(hertz, damping, measured, friction));
                let spring = Course::of(&format!("{name}a"), &spring, &["--x0", "0.1,0"]);
                let rows = format!("{design}{}", masses.as_states(measured));
                let start = ["--x0", "0.1,0.1,0,0"];
                let states = Course::of(&format!("{name}b"), &rows, &start);
                let rows = format!("{design}{}", masses.as_matrices(measured));
                let matrices = Course::of(&format!("{name}c"), &rows, &start);
                let end = if clock == "samples" { "status" } else { "y2" };
                assert_eq!(states.head[2..6], ["motor", "load", "v", "w"], "{what}");
                assert_eq!(spring.head[2..6], ["x1", "x2", "twist", "twist_rate"], "{what}");
                assert!(states.head.iter().any(|own| own == end), "{what}: {:?}", states.head);
                let [x, v] = if measured == "motor" { ["motor", "v"] } else { ["load", "w"] };
                for (own, mass) in [("x1", x), ("x2", v), ("u", "u"), ("y1", "y1")] {
                    near(&what, &spring.column(own), &states.column(mass), 1e-7);
                }
                for name in ["motor", "load", "v", "w", "u"] {
                    near(&what, &matrices.column(name), &states.column(name), 1e-7);
                }
                let apart = |a: &str, b: &str| -> Vec<f64> {
                    states.column(a).iter().zip(states.column(b)).map(|(a, b)| a - b).collect()
                };
                near(&what, &spring.column("twist"), &apart("motor", "load"), 1e-5);
                near(&what, &spring.column("twist_rate"), &apart("v", "w"), 1e-5);
                // Each sample under the u that is reported.
                near(&what, &states.column("y1"), &states.column(x), 0.0);
                let u = states.column("u");
                for (k, pair) in states.rows.windows(2).enumerate() {
                    let from: [f64; 4] = pair[0][2..6].try_into().expect("four states");
                    near(&what, &pair[1][2..6], &masses.after(from, u[k], 1e-3), 1e-7);
                }
            }
        }
    }
}

/// The controller of the rigid axis is the same whatever plant it runs with.
#[test]
fn stiff_spring_approaches_the_rigid_plant() {
    for (test, design) in [("samples", SAMPLES), ("time", TIME)] {
        let rigid = format!("{design}[plant]\nf = \"-2*x2/3.5\"\n");
        let rigid = Course::of(&format!("rigid_{test}"), &rigid, &["--x0", "0.1,0"]);
        let stiff = format!("{design}{}", resonance(50_000.0, 0.5, "motor", [0.0, 2.0]));
        let stiff = Course::of(&format!("stiff_{test}"), &stiff, &["--x0", "0.1,0"]);
        for name in ["x1", "x2", "u"] {
            near(name, &stiff.column(name), &rigid.column(name), 1e-4);
        }
    }
}

/// Dry friction holds any state, also one whose rate jumps with another one.
#[test]
fn dry_friction_sticks_on_the_side_it_acts_on() {
    let on = |measured: &str, side: &str| {
        format!(
            "{SAMPLES}[plant]\nf = \"-1e4*sign(x2)\"\nresonance = {{ frequency_hz = 40, damping = 0.1, \
             inertia_ratio = 6, measured = \"{measured}\", f = \"{side}\" }}\n"
        )
    };
    for measured in ["motor", "load"] {
        for side in ["motor", "load"] {
            let test = format!("dry_{measured}_{side}");
            let run = Course::of(&test, &on(measured, side), &["--x0", "0.1,0", "--until", "0.1"]);
            let (x, twist) = (run.column("x2"), run.column("twist_rate"));
            let still = x.iter().zip(&twist).map(|(x, d)| match (measured, side) {
                ("motor", "load") => x - d,
                ("load", "motor") => x + d,
                _ => *x,
            });
            let most = still.map(f64::abs).fold(0.0, f64::max);
            assert!(most < 1e-9, "{test}: {most}");
            let moves = run.column("twist").iter().fold(0.0, |most: f64, d| most.max(d.abs()));
            assert!((moves > 1e-6) == (side == "load"), "{test}: {moves}");
        }
    }
}

#[test]
fn objectives_over_plant_states_hold_without_proof() {
    let verify = "[verify]\nmotor = [-0.1, 0.1]\nload = 0\nv = 0\nw = 0\nscenarios = 8\nsearch = 4\n\
        [[objective]]\nbound = \"within\"\nh = \"load - x1 - w*0\"\nlow = -0.2\nhigh = 0.2\n\
        [[objective]]\nbound = \"attractive\"\nerror = 0.5\n";
    let masses = TwoMasses::new(400.0, 0.05, [0.0, 2.0]);
    let design = format!("{SAMPLES}{}{verify}", masses.as_states("motor"));
    let folder = folder_with("larger_verify", "design.toml", &design);
    let (code, told, stderr) = run_in(&folder, &["verify", "design.toml"]);
    assert_eq!(code, Some(0), "{told}{stderr}");
    assert!(told.contains("load - x1"), "{told}");
    assert!(!told.contains("holds, proved"), "{told}");
    assert!(told.contains("states that the law does not know"), "{told}");
    // With a spring the rigid chain is not what runs, and nothing is proved of it either.
    let spring = verify
        .replace("motor = [-0.1, 0.1]\nload = 0\nv = 0\nw = 0", "x1 = [-0.1, 0.1]\nx2 = 0")
        .replace("load - x1 - w*0", "twist");
    let design = format!("{SAMPLES}{}{spring}", resonance(400.0, 0.05, "motor", [0.0, 2.0]));
    let folder = folder_with("larger_verify_spring", "design.toml", &design);
    let (code, told, stderr) = run_in(&folder, &["verify", "design.toml"]);
    assert_eq!(code, Some(0), "{told}{stderr}");
    assert!(!told.contains("holds, proved"), "{told}");
}
