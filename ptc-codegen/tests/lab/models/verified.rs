//! `verify` of designs with a model: bounds just above and just below what plants by hand reach.

use super::plants::{PENDULUM, along, drive, from_rest, held, hold_pendulum, pendulum};
use super::support::{example, folder_with, run_in};

/// The exit code and what is printed.
fn verify(test: &str, design: &str, further: &[&str]) -> (i32, String) {
    let folder = folder_with(&format!("models_verified_{test}"), "plant.toml", design);
    let (code, told, stderr) = run_in(&folder, &[&["verify", "plant.toml"], further].concat());
    (code.expect("an exit code"), told + &stderr)
}

/// Holds a bound just above `truth`, and refutes one just below.
fn is_worst(test: &str, truth: f64, design: &dyn Fn(f64) -> String) {
    let (code, told) = verify(test, &design(1.001 * truth), &[]);
    assert!(code == 0 && told.contains("holds, by sampling"), "{told}");
    let (code, told) = verify(test, &design(0.999 * truth), &[]);
    assert!(code == 1 && told.contains(": fails"), "{told}");
}

fn drive_within(q: &str, objective: &str) -> String {
    let motor = example("drive.toml").replace("u_max = 24 ", "eps = 4e-3\nu_max = inf ");
    format!(
        "{motor}[verify]\nq = {q}\nw = 0\ni = 0\nscenarios = 20\nuntil = 0.02\n[[objective]]\n{objective}\n"
    )
}

/// The largest of a function of T/tau from 1 to 0.02.
fn largest(of: impl Fn(f64) -> f64) -> f64 {
    (0..=98_000).map(|i| of(1.0 - f64::from(i) * 1e-5).abs()).fold(0.0, f64::max)
}

#[test]
fn a_state_of_a_motor_is_bounded_by_what_its_polynomial_reaches() {
    let speed = largest(|s| drive(s).0[1]);
    is_worst("speed", speed, &|bound| {
        drive_within(
            "[-1, 1]",
            &format!("bound = \"within\"\nh = \"w\"\nlow = {}\nhigh = {bound}", -bound),
        )
    });
    let voltage = largest(|s| drive(s).1);
    is_worst("voltage", voltage, &|bound| {
        drive_within("[0.5, 1]", &format!("bound = \"input\"\nupsilon = {bound}"))
    });
    // The input has the name of the model too.
    is_worst("named", voltage, &|bound| {
        drive_within("[0.5, 1]", &format!("bound = \"within\"\nh = \"abs(V)\"\nhigh = {bound}"))
    });
}

/// `attractive` and `state` are of the chain, whose third state is the acceleration; so are x1..x3.
#[test]
fn the_chain_of_a_motor_is_bounded_at_the_end() {
    let [q, w, a, _] = from_rest(0.4, 0.02);
    let size = (q * q + w * w + a * a).sqrt();
    is_worst("attractive", size, &|bound| {
        drive_within("[-1, 1]", &format!("bound = \"attractive\"\nerror = {bound}"))
    });
    let size = largest(|s| {
        let [q, w, a, _] = from_rest(0.4, s);
        (q * q + w * w + a * a).sqrt()
    });
    is_worst("state", size, &|bound| {
        drive_within("[0.5, 1]", &format!("bound = \"state\"\nsigma = {bound}"))
    });
    let last = largest(|s| from_rest(0.4, s)[2]);
    is_worst("chain", last, &|bound| {
        drive_within("[-1, 1]", &format!("bound = \"within\"\nh = \"abs(x3)\"\nhigh = {bound}"))
    });
}

/// The law knows a parameter that is set at run time. The speed is that of the polynomial for any drawn resistance, and
/// the voltage is the largest over the resistances.
#[test]
fn a_parameter_at_run_time_is_drawn_for_plant_and_law() {
    let design = |h: &str, bound: f64| {
        let objective = format!("bound = \"within\"\nh = \"abs({h})\"\nhigh = {bound}");
        drive_within("[0.5, 1]", &objective).replace("R = 1.2 ", "R = [1.0, 2.0] ")
    };
    let speed = largest(|s| drive(s).0[1]);
    is_worst("known_speed", speed, &|bound| design("w", bound));
    let voltage = |resistance: f64| {
        largest(|s| {
            let ([_, _, i], voltage) = drive(s);
            voltage + (resistance - 1.2) * i
        })
    };
    let voltage = voltage(1.0).max(voltage(2.0));
    is_worst("known_voltage", voltage, &|bound| design("V", bound));
}

fn swinging(plant: &str, further: &str, objective: &str) -> String {
    format!(
        "{further}{PENDULUM}[plant]\n{plant}\n[verify]\nq = [0.5, 1.5]\nw = 0\nscenarios = 20\nsearch = 100\nuntil = 0.1\n\
         [[objective]]\n{objective}\n"
    )
}

/// Both signs of the error of a stiffness that is uncertain, at the start that is worst.
#[test]
fn a_pendulum_of_uncertain_stiffness_is_bounded_by_its_worst_corner() {
    let grid: Vec<_> = (0..=90).map(|i| f64::from(i) * 0.01).collect();
    let speed = |stiffness: f64, start: f64| {
        let run = along(&pendulum(stiffness), &hold_pendulum, (&grid, 20), &[start, 0.0]);
        run.iter().map(|x| x[1].abs()).fold(0.0, f64::max)
    };
    let corners = [(16.0, 0.5), (24.0, 0.5), (16.0, 1.5), (24.0, 1.5)];
    let worst = corners.map(|(k, q)| speed(k, q)).into_iter().fold(0.0, f64::max);
    is_worst("stiffness", worst, &|bound| {
        let objective = format!("bound = \"within\"\nh = \"abs(w)\"\nhigh = {bound}");
        swinging("stiffness = [16, 24]", "", &objective)
    });
}

#[test]
fn a_sampled_pendulum_is_bounded_by_its_worst_corner() {
    let torque = |stiffness: f64, start: f64| {
        let run = held(&pendulum(stiffness), &hold_pendulum, (0.01, 90), &[start, 0.0]);
        run.iter().map(|(_, u)| u.abs()).fold(0.0, f64::max)
    };
    let corners = [(16.0, 0.5), (24.0, 0.5), (16.0, 1.5), (24.0, 1.5)];
    let worst = corners.map(|(k, q)| torque(k, q)).into_iter().fold(0.0, f64::max);
    is_worst("sampled", worst, &|bound| {
        let objective = format!("bound = \"input\"\nupsilon = {bound}");
        swinging("stiffness = [16, 24]", "sample_time = 0.01\n", &objective)
    });
}

/// A force that varies is moved over its interval: the verdict is that of a search, and never a proof.
#[test]
fn a_load_that_varies_is_searched() {
    let plant = "load = [-1, 1]\ndynamics = { w = \"-stiffness*sin(q) - drag*w + M/inertia + load\" }\n\
                 [disturbance]\nload = \"any\"";
    let objective = "bound = \"within\"\nh = \"abs(q)\"\nhigh = 1.6";
    let (code, told) = verify("load", &swinging(plant, "", objective), &[]);
    assert!(code == 0, "{told}");
    assert!(
        told.contains("not proved: the plant is a model, and proofs are of chains of integrators"),
        "{told}"
    );
    assert!(told.contains("objective 1, abs(q) <= 8/5: holds, by sampling"), "{told}");
    // A constant load at its bound ends farther away than the law alone would.
    let tight = "bound = \"within\"\nh = \"abs(q)\"\nhigh = \"2*(4*(1 - dt)^3 - 3*(1 - dt)^4)\"";
    let (code, told) = verify("load_tight", &swinging(plant, "", tight), &[]);
    assert!(code == 1 && told.contains("load"), "{told}");
}

/// Parts merge to the bytes of the whole, whose columns have the names of the states.
#[test]
fn parts_of_a_campaign_merge() {
    let objective = "bound = \"within\"\nh = \"abs(w)\"\nhigh = 10";
    let design = swinging("stiffness = [16, 24]", "", objective);
    let folder = folder_with("models_verified_parts", "plant.toml", &design);
    let run = |further: &[&str]| {
        let (code, told, stderr) = run_in(&folder, &[&["verify", "plant.toml"], further].concat());
        assert_eq!(code, Some(0), "{told}{stderr}");
        told
    };
    run(&["--out", "whole.parquet", "--worst", "worst.csv", "--report", "page.html"]);
    run(&["--out", "one.parquet", "--shard", "1/2"]);
    run(&["--out", "two.parquet", "--shard", "2/2"]);
    run(&["--merge", "one.parquet", "two.parquet", "--out", "merged.parquet"]);
    let read = |name: &str| std::fs::read(folder.join(name)).expect("a file");
    assert!(read("whole.parquet") == read("merged.parquet"), "the parts are the whole");
    let csv = String::from_utf8(read("worst.csv")).expect("text");
    assert!(csv.starts_with("t,time_to_go,q,w,M,excess1\n"), "{csv}");
    let page = String::from_utf8(read("page.html")).expect("text");
    assert!(page.contains(">q</th>") && page.contains("[16, 24]"), "the page names the states");
    let replayed = run(&["--scenario", "tau = 1, q = 1, w = 0, stiffness = 20"]);
    let last: Vec<f64> = replayed
        .lines()
        .last()
        .expect("a row")
        .split(',')
        .map(|c| c.parse().expect("a number"))
        .collect();
    // T/tau is 0.1: q = 4 s^3 - 3 s^4.
    assert!((last[2] - 3.7e-3).abs() < 1e-9, "{last:?}");
}

#[test]
fn mistakes_of_a_campaign_with_a_model_say_the_way_out() {
    let objective = "bound = \"within\"\nh = \"abs(w)\"\nhigh = 10";
    let whole = swinging("stiffness = [16, 24]", "", objective);
    for (from, to, told) in [
        ("q = [0.5, 1.5]\n", "", "one [lower, upper] for each of q, w"),
        ("q = [0.5, 1.5]\n", "x1 = [0.5, 1.5]\n", "q"),
        ("high = 10", "high = \"w\"", "w"),
        ("h = \"abs(w)\"", "h = \"abs(v)\"", "v"),
    ] {
        let (code, stderr) = verify("mistakes", &whole.replacen(from, to, 1), &[]);
        assert!(code == 2 && stderr.contains(told), "{told}: {stderr}");
    }
    let named =
        whole.replace("\"q\"", "\"seed\"").replace("q = ", "seed = ").replace("(q)", "(seed)");
    let (code, stderr) = verify("named", &named, &[]);
    assert!(code == 2 && stderr.contains("has the name of a key of [verify]"), "{stderr}");
}
