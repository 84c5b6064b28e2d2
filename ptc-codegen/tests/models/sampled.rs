//! Models with a clock in samples: linear ones are the plant of their matrices, others are refused.

use super::support::{example, folder_with, run_in, spec};

/// examples/motor.toml with the model of examples/drive.toml, whose numbers are the same.
fn motor() -> String {
    let (motor, drive) = (example("motor.toml"), example("drive.toml"));
    let matrices = motor.find("# J = 2e-5").expect("the plant");
    let named = motor[..matrices].replace("measured = [\"x1\"]", "measured = [\"q\"]");
    let numbers = drive.find("k = 0.03").expect("the numbers");
    format!("{}{}", named, &drive[numbers..])
}

#[test]
fn a_linear_model_is_the_plant_of_its_matrices() {
    assert_eq!(spec(&motor()), spec(&example("motor.toml")));
    // However its dynamics are spelt, and with each state measured.
    let spelt = motor()
        .replace("(k*i - b*w)/J", "-b/J*w + i/(J/k) + (w - q)*0")
        .replace("measured = [\"q\"]\n", "")
        .replace("sensor_step = 6e-6", "sensor_step = [6e-6, 0, 0]");
    let whole = example("motor.toml")
        .replace("measured = [\"x1\"]\n", "")
        .replace("sensor_step = 6e-6", "sensor_step = [6e-6, 0, 0]");
    assert_eq!(spec(&spelt), spec(&whole));
}

#[test]
fn what_is_not_linear_is_refused() {
    for (from, to, message, help) in [
        (
            "(k*i - b*w)/J",
            "(k*i - b*w*abs(w))/J",
            "w' = (k*i - b*w*abs(w))/J is not linear",
            "linearise the model at rest",
        ),
        ("(k*i - b*w)/J", "(k*i - b*sign(w))/J", "is not linear", "leave `clock` out"),
        ("(k*i - b*w)/J", "(k*i - b*w)/J - 9.81", "is not linear", "leave `clock` out"),
        ("J = 2e-5 ", "J = [1e-5, 2e-5] ", "needs a number for `J`", "under [params]"),
        ("mu = ", "n = 2\nmu = ", "n = 2, but the model has 3 states", "leave n out"),
        (
            "measured = [\"q\"]",
            "measured = [\"x1\"]",
            "is not a choice of states",
            "each measured state of q, w, i once",
        ),
        ("sample_time = 1e-3", "", "`sample_time` is missing", "give the period"),
    ] {
        let text = motor().replacen(from, to, 1);
        let folder = folder_with("models_sampled", "motor.toml", &text);
        let (code, stdout, stderr) = run_in(&folder, &["emit", "--lang", "c", "motor.toml"]);
        assert_eq!((code, stdout.as_str()), (Some(2), ""), "{text}{stderr}");
        assert!(stderr.contains(message) && stderr.contains(help), "{to}: {stderr}");
    }
}
