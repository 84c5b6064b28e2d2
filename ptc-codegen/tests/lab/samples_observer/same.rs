//! The observer alone is that of the controller of the same design, bit for bit; and what `arm`, the
//! counter and a call that fails make of it.

use ptc_codegen::code::{Instance, Status};

use super::emitted::Emitted;
use super::{Random, code, estimates, legal, support, update};

/// Designs of controllers with an observer of 30 samples inside.
const DESIGNS: [&str; 7] = [
    "n = 2\nu_max = inf\nsample_time = 1e-3\ntau = 0.08\npoles = [-4, -5]\nmeasured = \"x1\"\nobserver_poles = [-4, -5]\n",
    "n = 3\nsample_time = 1e-3\ntau = 0.08\npoles = [-4, -5, -6, -7]\ndelay = 1\nmeasured = \"x1\"\n\
     disturbance = \"constant\"\nobserver_poles = [-4, \"-5+i\", \"-5-i\", -6]\nf = 0.5\ng = 2\nu_max = 3\n",
    "n = 2\nu_max = inf\nprecision = \"f32\"\nsample_time = 0.01\ntau = 0.8\npoles = [-4, -5, -6, -7]\ndelay = 2\nmeasured = \"x1\"\n\
     disturbance = \"constant\"\nobserver_poles = [-4, -5, -6]\nobserver_eps = 0.05\n",
    "n = 3\nu_max = inf\nsample_time = 1e-3\ntau = 0.08\npoles = [-4, -5, -6]\nmeasured = [\"x1\", \"x2\"]\n\
     observer_poles = [-4, -5.3]\nsensor_step = 1e-6\nguard = \"none\"\n",
    "n = 1\nu_max = inf\nsample_time = 1e-3\ntau = 0.08\npoles = [-4]\ndisturbance = \"constant\"\nobserver_poles = [-4, -5]\n\
     after_observer = [-90, -100]\n",
    "sample_time = 1e-3\ntau = 0.08\npoles = [-4, -5, -6, -7]\ndelay = 1\ndisturbance = \"constant\"\n\
     observer_poles = [-4, -5, -6, -7]\nafter_observer = [\"-90+20i\", \"-90-20i\", -100, -120]\nu_max = 20\n[plant]\n\
     A = [[0, 1, 0], [0, -0.5, 1500], [0, -15, -600]]\nB = [0, 0, 500]\nC = [[1, 0, 0], [0, 0, 1]]\n",
    "u_max = 40\nsample_time = 0.01\ntau = 0.8\npoles = [-4, -5]\nobserver_poles = [-4, -5]\nafter = \"zero\"\neps = 0.02\n[plant]\n\
     A = [[0, 1], [49, -0.1]]\nB = [0.1, -1.3]\nC = [1, 0.5]\n",
];

#[test]
fn as_that_of_the_controller() {
    for design in DESIGNS {
        let top = "observer_samples = 30\n";
        let controlled = code(&legal(&format!("{top}{design}")));
        let observed = code(&legal(&format!("what = \"observer\"\n{top}{design}")));
        assert!(controlled.function("step").is_some() && observed.function("step").is_none());
        let mut controller = Instance::new(&controlled, &[]).expect("legal parameters");
        let mut observer = Instance::new(&observed, &[]).expect("legal parameters");
        let measured = observed.function("update").expect("an update").arguments[1].shape;
        let measured = measured.length().expect("an array");
        let (mut random, mut last) = (Random(3), 0.0);
        let start = u32::MAX - 40;
        for elapsed in 0..150 {
            let k = start.wrapping_add(elapsed);
            if [0, 90].contains(&elapsed) {
                for instance in [&mut controller, &mut observer] {
                    instance.call("arm", &[("k", &[f64::from(k)])]);
                }
            }
            let y: Vec<_> = (0..measured).map(|_| 2.0 * random.next() - 1.0).collect();
            let outcome = controller.call("step", &[("k", &[f64::from(k)]), ("y", &y)]);
            assert!(outcome.status.number() >= 0, "{design}, sample {elapsed}: {outcome:?}");
            let status = update(&mut observer, k, &y, last).status;
            let over = elapsed % 90 >= 30;
            assert_eq!(status, if over { Status::Hold } else { Status::Ok }, "sample {elapsed}");
            let [found, wanted] = [(&mut observer, &observed), (&mut controller, &controlled)]
                .map(|(instance, code)| estimates(instance, code));
            let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&found), bits(&wanted), "{design}, sample {elapsed}");
            assert!(elapsed < 9 || found.iter().all(|value| *value != 0.0), "{found:?}");
            last = outcome.results["u"][0];
        }
    }
}

/// Fused products have the bits of C, and are not those of the plain code.
#[test]
fn fused_products_have_the_bits_of_c() {
    for (i, design) in DESIGNS.into_iter().enumerate().filter(|(_, own)| !own.contains("f32")) {
        let alone = format!("what = \"observer\"\nobserver_samples = 30\n{design}");
        let [plain, fused] = ["", "fma = true\n"].map(|key| legal(&format!("{key}{alone}")));
        let [plain, own] = [code(&plain), code(&fused)];
        let measured = own.function("update").expect("an update").arguments[1].shape;
        let measured = measured.length().expect("an array");
        let [mut unfused, mut instance] =
            [&plain, &own].map(|code| Instance::new(code, &[]).expect("legal parameters"));
        let home = support::folder(&format!("fused_observer_{i}"));
        let xhat = instance.call("estimate", &[]).results["xhat"].len();
        let mut emitted = Emitted::new(&home, &fused, xhat);
        let (mut random, mut differ) = (Random(5), 0);
        for k in 0..60 {
            let y: Vec<_> = (0..measured).map(|_| 2.0 * random.next() - 1.0).collect();
            let u = random.next();
            let (status, in_c) = emitted.update(k, &y, u);
            let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
            let [before, found] =
                [(&mut unfused, &plain), (&mut instance, &own)].map(|(instance, code)| {
                    assert_eq!(update(instance, k, &y, u).status.number(), status, "{design}");
                    bits(&estimates(instance, code))
                });
            assert_eq!(found, bits(&in_c), "{design}, sample {k}");
            differ += u32::from(found != before);
        }
        assert!(differ > 20, "{design}: {differ} samples differ");
    }
}

/// Only the difference to the start counts, so the counter may wrap.
#[test]
fn wherever_the_counter_stands() {
    let observed =
        code(&legal(&format!("what = \"observer\"\nobserver_samples = 30\n{}", DESIGNS[1])));
    let run = |start: u32| {
        let mut observer = Instance::new(&observed, &[]).expect("legal parameters");
        observer.call("arm", &[("k", &[f64::from(start)])]);
        let mut random = Random(9);
        let each = (0..60).map(|elapsed| {
            let (y, u) = ([random.next()], random.next());
            let status = update(&mut observer, start.wrapping_add(elapsed), &y, u).status;
            (status, estimates(&mut observer, &observed))
        });
        each.collect::<Vec<_>>()
    };
    let wanted = run(0);
    for start in [1, u32::MAX, u32::MAX - 29, 1 << 31] {
        assert_eq!(run(start), wanted, "from {start}");
    }
}

#[test]
fn a_call_that_fails_changes_nothing() {
    let mut refused = [0, 0];
    for (design, guarded) in [(DESIGNS[1], true), (DESIGNS[3], false), (DESIGNS[6], true)] {
        let observed =
            code(&legal(&format!("what = \"observer\"\nobserver_samples = 30\n{design}")));
        let arguments = &observed.function("update").expect("an update").arguments;
        let measured = arguments[1].shape.length().expect("an array");
        let mut one = Instance::new(&observed, &[]).expect("legal parameters");
        let mut other = one.clone();
        for k in 0..40 {
            for (y, u) in [(f64::NAN, 0.0), (0.5, f64::INFINITY), (0.5, f64::NAN), (1e308, 0.0)] {
                let status = update(&mut other, k, &vec![y; measured], u).status;
                let finite = y.is_finite() && u.is_finite();
                assert_eq!(status == Status::Input, guarded && !finite, "{design}, {k}: {y}, {u}");
                match status {
                    Status::Input => refused[0] += 1,
                    Status::Range => refused[1] += 1,
                    // An estimate may be as large; without a guard a u under way shows later.
                    _ => other = one.clone(),
                }
            }
            let y = vec![0.25; measured];
            assert_eq!(update(&mut one, k, &y, 0.5), update(&mut other, k, &y, 0.5), "{k}");
            assert_eq!(estimates(&mut one, &observed), estimates(&mut other, &observed));
        }
    }
    assert!(refused == [2 * 40 * 3, refused[1]] && refused[1] > 80, "{refused:?}");
}
