//! `verify` of a design with a sample period: what is judged is the loop that runs.

use crate::support;

use support::{example, folder_with, run_in};

/// A chain of two integrators under noise, with a force that is not known.
const NOISY: &str = "n = 2
mu = \"exp(a=1)\"
poles = [-4, -5]
sample_time = 1e-2
eps = 0.1
noise = [1e-3, 1e-3]
[params]
tau = 1
[plant]
f = \"d\"
d = [-0.1, 0.1]
[disturbance]
d = \"any\"
[verify]
x1 = [-1, 1]
x2 = [-0.5, 0.5]
scenarios = 200
search = 100
";

fn verify(test: &str, text: &str, more: &[&str]) -> (i32, String, String) {
    let folder = folder_with(test, "design.toml", text);
    let (exit, stdout, stderr) = run_in(&folder, &[&["verify", "design.toml"], more].concat());
    (exit.expect("an exit code"), stdout, stderr)
}

fn attractive(error: f64) -> String {
    format!("[[objective]]\nbound = \"attractive\"\nerror = {error}\n")
}

/// The worst |x_i| at the deadline, of `check`.
fn worst(test: &str, text: &str) -> Vec<f64> {
    let folder = folder_with(test, "design.toml", text);
    let given = ["check", "design.toml", "--x0-max", "1,0.5", "--error", "9", "--format", "json"];
    let (_, json, stderr) = run_in(&folder, &given);
    let found: serde_json::Value = serde_json::from_str(&json).expect(&stderr);
    let checks = found["checks"].as_array().expect("checks");
    let own = checks.iter().find(|check| check["name"] == "loop").expect("the loop");
    let all = own["worst"]["final"].as_array().unwrap_or_else(|| panic!("{json}"));
    all.iter().map(|x| x.as_f64().expect("a number")).collect()
}

#[test]
fn the_worst_case_proves_and_refutes() {
    let bounds = worst("running_worst", NOISY);
    let norm = bounds.iter().map(|x| x * x).sum::<f64>().sqrt();
    // What rounding adds to the bounds is far less.
    let above = format!("{NOISY}{}", attractive(norm * 1.000_001));
    let (exit, told, _) = verify("running_above", &above, &[]);
    assert!(exit == 0 && told.contains("holds, proved by the worst case, for every x0"), "{told}");
    assert!(!told.contains("Theorem 1"), "{told}");
    // x2 alone reaches this, in no draw.
    let below = format!("{NOISY}{}", attractive(bounds[1] * 0.999));
    let (exit, told, _) = verify("running_below", &below, &[]);
    assert!(exit == 1 && told.contains("0 of 200 draws"), "{told}");
    assert!(told.contains("the worst signals of the loop reach |x2| at the deadline"), "{told}");
    // A box need not be around 0.
    let (exit, told, _) = verify("running_open", &below.replace("[-1, 1]", "[-1, 0.99]"), &[]);
    assert!(exit == 1 && told.contains("the worst signals of the loop reach |x2|"), "{told}");
    // Bounds of any signal say nothing of some.
    let (exit, told, _) = verify("running_open", &below.replace("\"any\"", "\"sine\""), &[]);
    assert!(exit == 0 && told.contains("200 independent draws without a failure"), "{told}");
    assert!(told.contains("with signals that are not all in this campaign"), "{told}");
    assert!(told.contains("nothing is claimed of its worst case"), "{told}");
    // No signal is known to reach the norm of what each state reaches by itself.
    let between = format!("{NOISY}{}", attractive(0.5 * (norm + bounds[1])));
    let (exit, told, _) = verify("running_between", &between, &[]);
    assert!(exit == 3 && told.contains("not proved: |x| may reach"), "{told}");
}

#[test]
fn random_noise_is_sampled_and_not_proved() {
    let text = NOISY.replace("noise =", "noise_rms =");
    let (exit, told, _) = verify("running_random", &format!("{text}{}", attractive(1.0)), &[]);
    assert!(exit == 0 && told.contains("noise_rms` has no bound"), "{told}");
    assert!(told.contains("normal noise at each sample"), "{told}");
}

/// Gains that are held too late are stable until the deadline, and not after it.
#[test]
fn what_follows_the_deadline_is_judged() {
    let quiet = NOISY
        .replace("noise = [1e-3, 1e-3]\n", "")
        .replace("f = \"d\"\nd = [-0.1, 0.1]\n[disturbance]\nd = \"any\"\n", "f = 0\n")
        .replace("eps = 0.1", "eps = 0.015");
    let text = |until: &str| {
        quiet.replace("scenarios", &format!("until = {until}\nscenarios")) + &attractive(0.1)
    };
    let (exit, told, _) = verify("running_until", &text("0"), &[]);
    assert!(exit == 0 && told.contains("every 0.01 s from t0 to the deadline"), "{told}");
    let (exit, told, _) = verify("running_beyond", &text("-0.5"), &[]);
    assert!(exit == 1 && told.contains("to T/tau = -0.5"), "{told}");
    let held = text("-0.5").replace("eps = 0.015", "eps = 0.1");
    let (exit, told, _) = verify("running_held", &held, &[]);
    assert!(exit == 0 && told.contains("proved by the worst case"), "{told}");
}

/// A law that is exact in samples, at a period at which that of time diverges.
#[test]
fn a_clock_in_samples_is_verified() {
    let text = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 0.2\n[params]\ntau = 1\n\
                [verify]\nx1 = [-1, 1]\nx2 = [-1, 1]\nscenarios = 100\nuntil = -1\n";
    let text = format!("{text}{}", attractive(1e-9));
    let in_samples = text.replace("poles", "clock = \"samples\"\npoles");
    let (exit, told, stderr) = verify("running_samples", &in_samples, &[]);
    assert!(exit == 0 && told.contains("proved by the worst case"), "{told}{stderr}");
    let (exit, told, _) = verify("running_time", &text.replace("poles", "eps = 0.2\npoles"), &[]);
    assert_eq!(exit, 1, "{told}");
    let stage = example("encoder.toml");
    let stage = stage
        + "[verify]\nx1 = [-0.1, 0.1]\nx2 = 0\nscenarios = 20\nsearch = 20\n"
        + &attractive(1e-3);
    let (exit, told, stderr) = verify("running_stage", &stage, &[]);
    assert!(exit == 0 && told.contains("proved by the worst case"), "{told}{stderr}");
}

/// With a clock in samples the mapping is `exp`, and the law of least energy is the first that is tried.
#[test]
fn a_wish_in_samples_is_met() {
    let wish = NOISY
        .replace("mu = \"exp(a=1)\"\npoles = [-4, -5]\n", "clock = \"samples\"\ndelay = 1\n")
        .replace("eps = 0.1\n", "");
    let folder = folder_with("running_wish", "wish.toml", wish + &attractive(0.3));
    let (exit, design, told) = run_in(&folder, &["design", "wish.toml"]);
    assert_eq!(exit, Some(0), "{design}{told}");
    assert!(design.contains("mu = \"exp(a=1)\""), "{design}");
    assert!(design.lines().any(|line| line == "poles = \"least-energy\""), "{design}");
    assert!(design.contains("holds, proved by the worst case"), "{design}");
    assert!(design.contains("of the worst |x2| at the deadline"), "{design}");
}

/// A printed scenario runs again with the same draws of its sensors.
#[test]
fn a_scenario_is_replayed() {
    let text = format!("g_error = [0.9, 1.1]\n{NOISY}{}", attractive(1.0));
    let (_, told, _) = verify("running_replay", &text, &[]);
    let line = told.lines().find_map(|line| line.strip_prefix("worst trajectory, "));
    let scenario = line.unwrap_or_else(|| panic!("{told}"));
    assert!(scenario.contains("gain = ") && scenario.contains("seed = "), "{scenario}");
    let (exit, csv, stderr) = verify("running_again", &text, &["--scenario", scenario]);
    assert_eq!(exit, 0, "{stderr}");
    let last = csv.lines().last().expect("rows");
    let mut words =
        told.lines().rev().find(|l| l.contains("1.000000")).expect("the end").split(' ');
    let shown: Vec<_> = words.by_ref().filter(|word| word.contains('e')).collect();
    let (x1, x2) = (last.split(',').nth(2).expect("x1"), last.split(',').nth(3).expect("x2"));
    for (whole, short) in [x1, x2].iter().zip(shown) {
        let [whole, short] = [*whole, short].map(|text| text.parse::<f64>().expect("a number"));
        // The table has five digits.
        assert!((whole - short).abs() <= 1e-4 * whole.abs(), "{whole} {short}");
    }
    let without = scenario.split(", seed").next().expect("text");
    let (exit, _, stderr) = verify("running_seedless", &text, &["--scenario", without]);
    assert!(exit == 2 && stderr.contains("the scenario has no seed"), "{stderr}");
}

#[test]
fn mistakes_are_told() {
    for (from, to, told) in [
        ("scenarios = 200", "until = 1", "verify.until is not legal"),
        ("scenarios = 200", "until = -1e9", "verify.until is not legal"),
        ("sample_time = 1e-2", "sample_time = 1e-7", "samples, more than"),
        ("eps = 0.1\nnoise = [1e-3, 1e-3]\n[params]\ntau = 1\n", "[params]\n", "tau has no value"),
        ("[params]\ntau = 1\n", "clock = \"samples\"\n", "tau has no value"),
        (
            "sample_time = 1e-2\neps = 0.1",
            "sample_time = 1e-2\nclock = \"samples\"",
            "proved by the worst case",
        ),
        (
            "scenarios = 200",
            "tau = [0.5, 1]\nscenarios = 200",
            "`tau` = 1 is compiled into the controller, and [0.5, 1] under [verify]",
        ),
    ] {
        let text = format!("{NOISY}{}", attractive(1.0)).replace(from, to);
        let (_, stdout, stderr) = verify("running_mistakes", &text, &[]);
        assert!(format!("{stdout}{stderr}").contains(told), "{to}: {stdout}{stderr}");
    }
}
