//! Readings that an observer does not believe: what they cost, when a call is refused, and what `arm` makes of it.

use ptc_codegen::code::{Code, Instance, Status};

use super::{code, estimates, legal, read, update};

/// The stage of `examples/encoder.toml` with a gate.
const STAGE: &str = "name = \"stage\"\nn = 2\ng = \"1/1.5\"\nsample_time = 1e-3\ntau = 0.8\ndelay = 1\nu_max = 6\n\
     poles = [-4, -5, -6]\nmeasured = [\"x1\"]\nsensor_step = [1e-6, 0]\ndisturbance = \"constant\"\n\
     observer_poles = [-4, -5, -6]\nobserver_samples = 200\nobserver_eps = 0.03\n";
const GATE: &str = "innovation_max = 1e-3\ncoast = 5\n";

/// Samples to the deadline.
const END: u32 = 800;

/// The stage, moved by the force of the last sample and one that is not known, with its controller.
struct Stage {
    control: Instance,
    x: [f64; 2],
    late: f64,
    tick: u32,
}

impl Stage {
    fn new(code: &Code, x1: f64) -> Self {
        let control = Instance::new(code, &[]).expect("legal parameters");
        Self { control, x: [x1, 0.0], late: 0.0, tick: 0 }
    }

    /// A sample with the reading that `read` makes of the position in whole steps of the encoder.
    fn step(&mut self, read: impl Fn(f64) -> f64) -> (Status, f64) {
        let y = read((self.x[0] / 1e-6).round() * 1e-6);
        let outcome = self.control.call("step", &[("k", &[f64::from(self.tick)]), ("y", &[y])]);
        let u = outcome.results.get("u").map_or(0.0, |u| u[0]);
        let (h, acts) = (1e-3, (self.late + 0.3) / 1.5);
        self.x = [self.x[0] + h * self.x[1] + h * h / 2.0 * acts, self.x[1] + h * acts];
        self.late = u;
        self.tick += 1;
        (outcome.status, u)
    }

    /// Samples with good readings until tick `end`.
    fn until(&mut self, end: u32) -> Vec<Status> {
        (self.tick..end).map(|_| self.step(|y| y).0).collect()
    }

    fn arm(&mut self) {
        self.control.call("arm", &[("k", &[f64::from(self.tick)])]);
    }
}

fn stage(gate: &str) -> Code {
    code(&legal(&format!("{STAGE}{gate}")))
}

/// The errors of the estimates of position and speed that 2^31 counts leave, and how many samples are saturated.
fn after_a_wild_reading(code: &Code) -> (f64, usize) {
    let mut stage = Stage::new(code, 0.1);
    stage.until(400);
    let wild = stage.step(|_| 2_147.483_648);
    let saturated = stage.until(END);
    let saturated = saturated.iter().chain([&wild.0]).filter(|s| **s == Status::Saturated).count();
    (stage.x[0].abs(), saturated)
}

#[test]
fn gate_suppresses_a_wild_reading() {
    let (open, gated) = (stage(""), stage(GATE));
    let (off, saturated) = after_a_wild_reading(&open);
    assert!(off > 0.1 && saturated > 100, "{off}, {saturated}");
    let (off, saturated) = after_a_wild_reading(&gated);
    assert!(off < 1e-5 && saturated == 0, "{off}, {saturated}");
}

#[test]
fn rejected_readings_are_gated_up_to_the_coast_limit() {
    let code = stage(&format!("{GATE}measurement_max = 2\n"));
    for wrong in [f64::NAN, f64::INFINITY, 1e100, -2.5, 0.05] {
        let mut stage = Stage::new(&code, 0.1);
        assert!(stage.until(20).iter().all(|status| *status == Status::Ok));
        for _ in 0..5 {
            let (status, u) = stage.step(|_| wrong);
            assert!(status == Status::Gated && u != 0.0 && u.abs() < 6.0, "{wrong}: {status:?}");
        }
        // A reading that is believed begins the count again.
        assert_eq!(stage.step(|y| y).0, Status::Ok);
        assert!((0..5).all(|_| stage.step(|_| wrong).0 == Status::Gated));
        let before = stage.control.clone();
        for _ in 0..3 {
            assert_eq!(stage.step(|_| wrong), (Status::Input, 0.0));
            assert_eq!(
                estimates(&mut stage.control, &code),
                estimates(&mut before.clone(), &code),
                "a call that is refused changes nothing"
            );
        }
        // The stage has hardly moved in three samples: the prediction is still good.
        assert_eq!(stage.step(|y| y).0, Status::Ok);
        stage.until(END);
        assert!(stage.x[0].abs() < 2e-5, "{wrong}: {:?}", stage.x);
    }
}

#[test]
fn arm_resets_unusable_estimates() {
    let code = stage(GATE);
    // Without a prediction the first reading is believed, and every good one behind it is not.
    let mut stage = Stage::new(&code, 0.1);
    assert_eq!(stage.step(|_| 1e100).0, Status::Saturated);
    assert!((0..5).all(|_| stage.step(|y| y).0 == Status::Gated));
    assert!((0..50).all(|_| stage.step(|y| y).0 == Status::Input));
    stage.arm();
    assert_eq!(stage.step(|y| y).0, Status::Ok);
    let start = stage.tick - 1;
    stage.until(start + END);
    assert!(stage.x[0].abs() < 2e-5, "{:?}", stage.x);
    // Estimates that may be used are kept: the next reading is compared with its prediction.
    stage.arm();
    assert_eq!(stage.step(|_| 0.01).0, Status::Gated);
    // A plant that was moved is not believed until then.
    stage.x[0] += 0.05;
    assert!((0..4).all(|_| stage.step(|y| y).0 == Status::Gated));
    assert_eq!(stage.step(|y| y).0, Status::Input);
    stage.arm();
    assert_eq!(stage.step(|y| y).0, Status::Ok);
    assert!((estimates(&mut stage.control, &code)[0] - stage.x[0]).abs() < 1e-4);
}

#[test]
fn first_reading_must_be_within_the_sensor_range() {
    for gate in [GATE, ""] {
        let code = stage(&format!("{gate}measurement_max = 0.5\n"));
        let mut stage = Stage::new(&code, 0.1);
        for wrong in [f64::NAN, 1e100, 0.6, -0.6] {
            assert_eq!(stage.step(|_| wrong), (Status::Input, 0.0), "{wrong}");
        }
        assert_eq!(stage.step(|_| 0.5).0, Status::Ok);
        // Without `coast` no reading is done without.
        let wanted = if gate.is_empty() { Status::Input } else { Status::Gated };
        assert_eq!(stage.step(|_| 0.6).0, wanted);
    }
}

/// A motor in f32, whose observer predicts the next sample.
const MOTOR: &str = "sample_time = 1e-3\ntau = 0.3\npoles = [-4, -5, -6]\nprecision = \"f32\"\nu_max = 12\n\
     observer_poles = [-4, -5, -6]\nobserver_samples = 100\n[plant]\n\
     A = [[0, 1, 0], [0, -0.5, 15], [0, -15, -60]]\nB = [0, 0, 50]\nC = [[1, 0, 0]]\n";

/// Readings up to the end of the range of numbers, whose predictions may leave it where u does not.
fn extremes() -> impl Iterator<Item = f64> {
    (20..39).flat_map(|exponent| [1.0, -2.5].map(|size| size * 10_f64.powi(exponent)))
}

/// Calls of `step` with a reading each, behind one another.
struct Calls {
    control: Instance,
    tick: u32,
}

impl Calls {
    fn new(code: &Code) -> Self {
        Self { control: Instance::new(code, &[]).expect("legal parameters"), tick: 0 }
    }

    fn step(&mut self, y: f64) -> Status {
        let outcome = self.control.call("step", &[("k", &[f64::from(self.tick)]), ("y", &[y])]);
        self.tick += 1;
        outcome.status
    }

    fn arm(&mut self) {
        self.control.call("arm", &[("k", &[f64::from(self.tick)])]);
    }
}

/// The reading is wild where the gain of the observer is large: its prediction overflows, and u does not show it.
#[test]
fn non_finite_prediction_is_discarded() {
    let code = code(&legal(MOTOR));
    let mut refused = 0;
    for wild in [1e34, -1e35, 3e38] {
        let mut motor = Calls::new(&code);
        assert!((0..97).all(|_| motor.step(0.5) != Status::Range));
        refused += usize::from(motor.step(wild) == Status::Range);
        assert!((0..9).all(|_| motor.step(0.5) != Status::Range), "{wild:e}");
    }
    assert_eq!(refused, 3);
}

#[test]
fn arm_makes_an_observer_usable_after_any_reading() {
    let gated = format!("innovation_max = 0.5\ncoast = 2\n{MOTOR}");
    let f32_stage = format!("{STAGE}{GATE}precision = \"f32\"\n");
    for text in [gated, MOTOR.to_owned(), format!("{STAGE}{GATE}"), f32_stage] {
        let code = code(&legal(&text));
        let mut stuck = 0;
        for (wild, late) in extremes().flat_map(|wild| [0, 97].map(|late| (wild, late))) {
            let mut motor = Calls::new(&code);
            assert!((0..late).all(|_| motor.step(0.5) != Status::Range));
            motor.step(wild);
            let after = (0..9).map(|_| motor.step(0.5)).last();
            let was_stuck = matches!(after, Some(Status::Range | Status::Input));
            stuck += usize::from(was_stuck);
            motor.arm();
            let first = motor.step(0.25);
            assert!(!was_stuck || first == Status::Ok, "{wild:e}, {late}: {first:?}: {text}");
        }
        assert!(stuck > 3, "{stuck}: {text}");
    }
}

/// One reading that is not believed takes the others with it.
#[test]
fn readings_of_one_sample_are_accepted_together() {
    let motor = "what = \"observer\"\nsample_time = 1e-3\nobserver_poles = [-4, -5, -6]\nobserver_samples = 30\n\
         innovation_max = [0.1, 2]\ncoast = 3\n[plant]\n\
         A = [[0, 1, 0], [0, -0.5, 1500], [0, -15, -600]]\nB = [0, 0, 500]\nC = [[1, 0, 0], [0, 0, 1]]\n";
    let code = code(&legal(motor));
    let mut observer = Instance::new(&code, &[]).expect("legal parameters");
    assert_eq!(update(&mut observer, 0, &[0.25, 0.0], 0.0).status, Status::Ok);
    let mut other = observer.clone();
    for (k, y) in [(1, [0.5, 0.0]), (2, [0.25, 2.5]), (3, [0.25, f64::NAN])] {
        assert_eq!(update(&mut observer, k, &y, 0.0).status, Status::Gated);
        assert_eq!(update(&mut other, k, &[f64::NAN; 2], 0.0).status, Status::Gated);
        assert_eq!(estimates(&mut observer, &code), estimates(&mut other, &code));
    }
    assert_eq!(update(&mut observer, 4, &[0.25, 2.5], 0.0).status, Status::Input);
    assert_eq!(update(&mut observer, 4, &[0.25, 1.0], 0.0).status, Status::Ok);
    assert_eq!(update(&mut observer, 5, &[0.25, 0.0], f64::NAN).status, Status::Input);
}

#[test]
fn invalid_gate_settings_are_reported() {
    let cases = [
        ("innovation_max = 1e-3\n", "`innovation_max` without `coast`", "coast = 5"),
        ("innovation_max = 0\ncoast = 1\n", "is not finite and > 0", "a number > 0"),
        ("innovation_max = [1, 2]\ncoast = 1\n", "innovation_max: 2 numbers", "one number for all"),
        ("coast = 1.5\n", "coast = `1.5` is not a number of samples", "0..=65535"),
        ("coast = 65536\n", "coast = `65536`", "0..=65535"),
        ("coast = 2\nguard = \"none\"\n", "`coast` with guard = none", "guard = full"),
        ("measurement_max = -1\n", "is not finite and > 0", "a number > 0"),
    ];
    for (gate, message, help) in cases {
        let found = read(&format!("{STAGE}{gate}")).expect_err(gate);
        assert!(found.contains(message) && found.contains(help), "{gate}: {found}");
        assert_eq!(found.lines().count(), 1, "{found}");
    }
    let several = STAGE
        .replace("[\"x1\"]", "[\"x1\", \"x2\"]")
        .replace("[-4, -5, -6]\nobserver_s", "[-4, -5]\nobserver_s");
    let found = read(&format!("{several}{GATE}")).expect_err("two measured states");
    assert!(found.contains("beside 2 measured states") && found.contains("A, B and C"), "{found}");
    let known = "n = 2\nsample_time = 1e-3\ntau = 0.8\npoles = [-4, -5]\ncoast = 2\n";
    let found = read(known).expect_err("no observer");
    assert!(found.contains("`coast` without an observer"), "{found}");
    let axes = "n = 2\naxes = 2\nsample_time = 1e-3\ntau = 0.8\npoles = [-4, -5]\ncoast = 2\n";
    assert!(read(axes).expect_err("axes").contains("`coast` without an observer"));
}

/// The command in the head of a file gives the gate back.
#[test]
fn command_reproduces_the_gate() {
    let spec = legal(&format!("{STAGE}{GATE}measurement_max = 0.5\n"));
    let command = spec.command();
    for part in ["--innovation-max=1e-3", "--measurement-max=0.5", "--coast=5"] {
        assert!(command.contains(part), "{command}");
    }
    assert_ne!(spec.fingerprint(), legal(STAGE).fingerprint());
}
