//! Effect of a resonance of the plant on the loop: bands of `check` against runs of the loop just inside and outside
//! of them, and the eps that takes it into account.

use ptc_codegen::check::examine::{Report, examine};
use ptc_codegen::check::sampled::{Damped, stability};
use ptc_codegen::check::{Outcome, Verdict};
use ptc_codegen::parameter::{Fixed, Parameter};
use ptc_codegen::plant::{Plant, as_one, read_design};
use ptc_codegen::simulate::{Loop, Sampled, Values};

use super::support::{entries, folder_with, run_in};

fn damped(report: &Report) -> Damped {
    let found = stability(&report.spec, None).unwrap_or_else(|why| panic!("{why}"));
    found.resonance.expect("a resonance")
}

fn read(text: &str) -> (Report, Plant) {
    let (spec, plant) =
        read_design(&entries(text)).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
    (examine(&spec), plant.expect("a plant"))
}

/// Growth factor of a loop per length of tau, long after its deadline, with a resonance at `hertz`.
fn growth((report, plant): &(Report, Plant), hertz: f64) -> f64 {
    let (spec, plant) = as_one(report.spec.clone(), Some(plant.clone()));
    let plant = plant.expect("a plant");
    let symbol = |name: &str| {
        let mut all = plant.symbols(&spec).into_iter();
        all.find(|p| p.spelling() == name).unwrap_or_else(|| panic!("{name}"))
    };
    let values = Values::of(&spec, &plant).with(symbol("resonance_frequency_hz"), hertz);
    let tau = values.get(Parameter::Tau);
    let around = Loop { until: Some(10.0 * tau), ..Loop::of(&spec).expect("a period") };
    let mut sizes = [0.0_f64; 10];
    let mut sampled = Sampled::new(&spec, &plant).expect("a loop");
    let x0 = [1e-3, 0.0, 0.0, 0.0];
    let run = sampled.run(&values, &x0, &around, &mut |sample| {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let part = ((sample.t / tau) as usize).min(9);
        let x = sample.x;
        // The twist is small where the spring is stiff.
        let size = x[0].abs() + 1e-2 * x[1].abs() + 1e2 * x[2].abs() + 1e-2 * x[3].abs();
        sizes[part] = sizes[part].max(size);
    });
    match run {
        // What overflows has u = 0 from then on.
        Ok(()) if sizes.iter().any(|size| *size > 1e30) => f64::INFINITY,
        Ok(()) => (sizes[9] / sizes[4]).powf(0.2),
        Err(_) => f64::INFINITY,
    }
}

/// A rigid law with no limit of u, and a resonance from 5 to 60 Hz.
fn design(clock: &str, more: &str, resonance: &str) -> String {
    format!(
        "n = 2\nmu = \"exp(a=1)\"\nclock = \"{clock}\"\nsample_time = 2e-3\ng = \"1/3.5\"\n{more}\n[params]\ntau = 0.4\n\
         u_max = inf\n[plant]\nresonance = {{ frequency_hz = [5, 60], {resonance} }}\n"
    )
}

#[test]
fn loops_diverge_exactly_in_the_reported_bands() {
    let observed = "poles = [-3, -3.7, -4.4]\ndelay = 1\neps = 0.04\nmeasured = \"x1\"\n\
         observer_poles = [-5, -6, -7]\ndisturbance = \"constant\"";
    let late = "poles = [-3, -3.7, -4.4, -5.1]\ndelay = 1.4\neps = 0.08";
    let in_time = "poles = [-4, -5]\ndelay = 1\neps = 0.02\nallow = [\"sampling\", \"deadline\"]";
    let mut edges = 0;
    for (clock, more, resonance) in [
        ("samples", observed, "damping = 0.05, inertia_ratio = 3, measured = \"motor\""),
        ("samples", observed, "damping = 0.1, inertia_ratio = 1, measured = \"load\""),
        ("samples", late, "damping = 0.02, inertia_ratio = 6, measured = \"motor\""),
        ("samples", late, "damping = 0.05, inertia_ratio = 0.5, measured = \"load\""),
        ("time", in_time, "damping = 0.02, inertia_ratio = 0.2, measured = \"load\""),
        ("time", in_time, "damping = 0.05, inertia_ratio = 6, measured = \"motor\""),
    ] {
        let text = design(clock, more, resonance);
        let found = read(&text);
        let Damped { examined: [low, high], unstable, .. } = damped(&found.0);
        let is_unstable = |hertz: f64| unstable.iter().any(|[a, b]| *a <= hertz && hertz <= *b);
        let near = unstable.iter().flatten().flat_map(|edge| [0.97 * edge, 1.03 * edge]);
        let even = (1..6).map(|i| low * (high / low).powf(f64::from(i) / 6.0));
        for hertz in near.chain(even).filter(|hertz| (low..=high).contains(hertz)) {
            let growth = growth(&found, hertz);
            assert_eq!(
                growth > 1.0,
                is_unstable(hertz),
                "{hertz} Hz: {growth}, {unstable:?}\n{text}"
            );
            edges += 1;
        }
    }
    assert!(edges > 40, "{edges}");
}

#[test]
fn resonance_is_refused_within_an_unstable_band_only() {
    let observed = "poles = [-3, -3.7, -4.4]\ndelay = 1\neps = 0.04\nmeasured = \"x1\"\n\
         observer_poles = [-5, -6, -7]\ndisturbance = \"constant\"\nx0_max = [0.1, 0]\nerror = [1, 100]";
    let spring = "damping = 0.05, inertia_ratio = 3, measured = \"motor\"";
    let text = design("samples", observed, spring);
    let (report, _) = read(&text);
    let looped = |report: &Report| {
        report.outcomes.iter().find(|outcome| outcome.name == "loop").expect("a loop").clone()
    };
    let own = looped(&report);
    assert_eq!(own.verdict, Verdict::Unsound, "{own:?}");
    assert!(own.summary.contains("unstable for resonances from 5 to "), "{own:?}");
    let last = damped(&report).above().expect("stable above");
    assert!(own.fix.as_ref().is_some_and(|fix| fix.contains("Hz leaves it stable")), "{own:?}");
    let stiff = text.replace("[5, 60]", &format!("[{}, {}]", 1.01 * last, 4.0 * last));
    let own = looped(&read(&stiff).0);
    assert_eq!(own.verdict, Verdict::Undecided, "{own:?}");
    assert!(own.summary.contains("a resonance that the law does not know"), "{own:?}");
    // A wider range of damping, or of inertia, is no better.
    for wider in [
        spring.replace("0.05", "[0.05, 0.2]"),
        spring.replace("inertia_ratio = 3", "inertia_ratio = [1, 3]"),
    ] {
        let bands = damped(&read(&design("samples", observed, &wider)).0);
        let [own] = &bands.unstable[..] else { panic!("{bands:?}") };
        assert!(own[1] >= last * (1.0 - 1e-3), "{bands:?}, not {last}");
    }
    // Only the refusal is part of `loop`: all bands are part of the margins.
    let told = |own: &Outcome| own.details.iter().any(|line| line.contains("unstable for"));
    assert!(!told(&looped(&report)) && !told(&own), "{own:?}");
    assert_eq!(report.margins().matches("unstable for resonances").count(), 1);
    // The command says so, and runs it all the same.
    let folder = folder_with("resonance_command", "design.toml", &text);
    let (code, told, _) = run_in(&folder, &["check", "design.toml"]);
    assert_eq!(code, Some(1), "{told}");
    assert!(told.contains("refused: loop"), "{told}");
    let run = ["simulate", "design.toml", "--x0", "0.1,0", "--plant", "resonance_frequency_hz=20"];
    let (code, csv, stderr) = run_in(&folder, &run);
    assert_eq!(code, Some(0), "{stderr}");
    assert!(csv.starts_with("tau,t,x1,x2,twist,twist_rate,u,y1,status"), "{csv}");
    assert!(stderr.contains("unstable for resonances at 20 Hz"), "{stderr}");
}

/// An open eps is chosen so that the loop resists the resonance, which takes a larger eps.
#[test]
fn open_eps_is_chosen_to_tolerate_the_resonance() {
    let text = |plant: &str| {
        format!(
            "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\npoles = [-4, -4.5, -5]\nsample_time = 2e-3\ndelay = 1\n\
             sensor_step = 7.7e-6\nmeasured = \"x1\"\ndisturbance = \"constant\"\nobserver_poles = [-5, -6, -7]\n\
             observer_samples = 60\nx0_max = [0.3, 1e-6]\nerror = [0.1, 10]\n[params]\nu_max = inf\ntau = 0.5\n[plant]\n{plant}"
        )
    };
    let spring = "resonance = { frequency_hz = [60, 90], damping = 0.05, inertia_ratio = 2, measured = \"motor\" }\n";
    let (rigid, _) = read(&text("f = 0\n"));
    let (flexible, _) = read(&text(spring));
    let eps = |report: &Report| report.spec.fixed.get(&Parameter::Eps).cloned().expect("an eps");
    let number = |eps: &Fixed| eps.number().cloned().expect("a number");
    assert!(number(&eps(&flexible)) > number(&eps(&rigid)), "{:?}", eps(&flexible));
    assert!(damped(&flexible).exceeded().is_empty(), "{:?}", damped(&flexible));
    // With the eps of the rigid plant it is not stable.
    let mut fixed = flexible.spec.clone();
    fixed.fixed.insert(Parameter::Eps, eps(&rigid));
    let own = stability(&fixed, None).expect("stable as a rigid one").resonance.expect("one");
    assert!(!own.exceeded().is_empty(), "{own:?}");
}

/// A resonance is joined to one chain: beside several axes the message says what to do, and that is legal.
#[test]
fn resonance_of_an_axis_needs_a_design_of_its_own() {
    let spring = "damping = 0.05, inertia_ratio = 3, measured = \"motor\"";
    let alone = design("time", "poles = [-4, -5]\neps = 0.02", spring);
    let wrong = read_design(&entries(&format!("axes = 2\n{alone}"))).expect_err("several axes");
    let [wrong] = &wrong[..] else { panic!("{wrong:?}") };
    assert!(wrong.message.starts_with("`resonance` beside several axes: "), "{wrong:?}");
    assert!(wrong.help.contains("check each axis as a design of its own"), "{wrong:?}");
    assert!(read(&alone).1.resonance.is_some());
}
