//! `simulate` of designs with a model, against plants and laws by hand.

use super::plants::{PENDULUM, along, drive, held, hold_magnet, hold_pendulum, magnet, pendulum};
use super::support::{example, folder_with, run_in, without_design};

/// The head and the rows of a run, and what is said beside it.
fn run(test: &str, design: &str, further: &[&str]) -> (String, Vec<Vec<f64>>, String) {
    let folder = folder_with(&format!("models_simulated_{test}"), "plant.toml", design);
    let all = [&["simulate", "plant.toml"], further].concat();
    let (code, csv, stderr) = run_in(&folder, &all);
    assert_eq!(code, Some(0), "{stderr}");
    let number = |cell: &str| cell.parse().ok();
    let row = |line: &str| line.split(',').filter_map(number).collect();
    let (head, rows) = csv.split_once('\n').expect("a head");
    (head.to_owned(), rows.lines().map(row).collect(), stderr)
}

fn near(found: &[f64], wanted: &[f64], within: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?}, not {wanted:?}");
    let off = found.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= within, "{found:?}, not {wanted:?}");
}

/// A motor with eps, and without the bound of its voltage.
fn motor() -> String {
    example("drive.toml").replace("u_max = 24 ", "eps = 4e-3\nu_max = inf ")
}

#[test]
fn motor_follows_its_polynomial() {
    let at = ["--x0", "1,0,0", "--at", "0,0.3,0.5,0.9,0.98"];
    let (head, rows, told) = run("motor", &motor(), &at);
    assert_eq!(head, "tau,t,q,w,i,V");
    assert!(told.contains("the design has no [plant]: the plant is its model"), "{told}");
    for (row, part) in rows.iter().zip([0.0, 0.3, 0.5, 0.9, 0.98]) {
        let (x, voltage) = drive(1.0 - part);
        near(&row[2..], &[x[0], x[1], x[2], voltage], 1e-9);
    }
}

/// A resistance that the law does not know leaves the coordinates of the chain as they are: the chain
/// has f and g by hand, and the plant's f has the other resistance.
#[test]
fn linear_model_equals_its_chain_in_other_coordinates() {
    let at = ["--x0", "1,0,0", "--at", "0.2,0.7,0.97"];
    let model = format!("{}[plant]\nR = 1.5\n", motor());
    let (_, rows, told) = run("linear", &model, &at);
    assert_eq!(without_design(&told), "");
    // i = (J x3 + b x2)/k, and x3' = k/(J L) (V - R i - k x2) - b/J x3.
    let f = |resistance: f64| {
        format!("-{resistance}*(2e-5*x3 + 1e-5*x2)/(2e-5*2e-3) - 0.03^2*x2/(2e-5*2e-3) - 0.5*x3")
    };
    let chain = format!(
        "n = 3\nmu = \"exp(a=1)\"\npoles = [-4, -5, -6]\nf = \"{}\"\ng = \"0.03/(2e-5*2e-3)\"\n\
         [params]\ntau = 0.4\n[plant]\nf = \"{}\"\n",
        f(1.2),
        f(1.5)
    );
    let (_, chain, _) = run("chain", &chain, &at);
    for (row, chain) in rows.iter().zip(&chain) {
        let current = (2e-5 * chain[4] + 1e-5 * chain[3]) / 0.03;
        near(&row[2..], &[chain[2], chain[3], current, chain[5]], 1e-8);
    }
    // It is another run than that of the plant that the law knows.
    assert!((rows[1][2] - drive(0.3).0[0]).abs() > 1e-3, "{rows:?}");
}

/// With the gains held from eps on, until almost the deadline, and a plant of another stiffness.
#[test]
fn pendulum_matches_manual_integration() {
    let design = format!("{PENDULUM}[plant]\nstiffness = 24\n");
    let at = ["--x0=-2,1", "--at", "0,0.4,0.9,0.97,0.999"];
    let (head, rows, _) = run("pendulum", &design, &at);
    assert_eq!(head, "tau,t,q,w,M");
    let grid = [0.0, 0.4, 0.9, 0.97, 0.999];
    let wanted = along(&pendulum(24.0), &hold_pendulum, (&grid, 4000), &[-2.0, 1.0]);
    for ((row, x), t) in rows.iter().zip(&wanted).zip(grid) {
        near(&row[2..], &[x[0], x[1], hold_pendulum(t, x)], 1e-8);
    }
    // Another rate is the same plant by another way.
    let other = "[plant]\ndynamics = { w = \"M/inertia - drag*w - extra*sin(q)\" }\nextra = 24\n";
    near(&run("rates", &format!("{PENDULUM}{other}"), &at).1.concat(), &rows.concat(), 1e-10);
    let flags = [&at[..], &["--plant", "dynamics=w, M/inertia - drag*w - 24*sin(q)"]].concat();
    near(&run("flags", PENDULUM, &flags).1.concat(), &rows.concat(), 1e-10);
}

#[test]
fn torque_is_clipped_at_every_instant() {
    let design = PENDULUM.replace("eps", "u_max = 0.3\neps");
    let (_, rows, _) = run("bounded", &design, &["--x0", "1,0", "--at", "0.2,0.6,0.9"]);
    let clipped = |t: f64, x: &[f64]| hold_pendulum(t, x).clamp(-0.3, 0.3);
    let wanted = along(&pendulum(20.0), &clipped, (&[0.0, 0.2, 0.6, 0.9], 20_000), &[1.0, 0.0]);
    for (row, x) in rows.iter().zip(&wanted[1..]) {
        near(&row[2..4], x, 1e-8);
    }
    assert!(rows.iter().any(|row| row[4].abs() == 0.3), "{rows:?}");
}

/// Dry friction is a jump of the last rate: where it holds the pendulum, nothing moves.
#[test]
fn dry_friction_stops_or_slows_a_pendulum() {
    let dry = |size: f64| {
        format!(
            "{PENDULUM}[plant]\ndry = {size}\ndynamics = {{ w = \"M/inertia - stiffness*sin(q) - drag*w - dry*sign(w)\" }}\n"
        )
    };
    let (_, rows, _) = run("passes", &dry(2.0), &["--x0", "1,1", "--at", "0.3,0.6"]);
    let rates = |t: f64, x: &[f64], u: f64| {
        let smooth = pendulum(20.0)(t, x, u);
        vec![smooth[0], smooth[1] - 2.0 * x[1].signum()]
    };
    let wanted = along(&rates, &hold_pendulum, (&[0.0, 0.3, 0.6], 100_000), &[1.0, 1.0]);
    for (row, x) in rows.iter().zip(&wanted[1..]) {
        near(&row[2..4], x, 1e-5);
    }
    // The law wants 12/T^2, which is less than 100 as long as T is above 0.35.
    let (_, rows, _) = run("holds", &dry(100.0), &["--x0", "1,0", "--at", "0.3,0.6,0.7"]);
    near(&rows[0][2..4], &[1.0, 0.0], 0.0);
    near(&rows[1][2..4], &[1.0, 0.0], 0.0);
    assert!(rows[2][3] < -0.1, "{rows:?}");
}

/// A jump of a rate in the middle is followed as one of the last rate.
#[test]
fn sliding_holds_the_state_for_any_rate() {
    let design = format!(
        "{}[plant]\ndry = 1e4\ndynamics = {{ w = \"(k*i - b*w)/J - dry*sign(w)\" }}\n",
        motor()
    );
    let further = ["--x0", "1,0,0", "--at", "0.1"];
    let (_, rows, _) = run("slides", &design, &further);
    near(&rows[0][2..4], &[1.0, 0.0], 0.0);
    // The drive is held at rest, and its current is that of a coil.
    let last = design.replace("[\"q\", \"w\", \"i\"]", "[\"q\", \"i\", \"w\"]");
    let (_, other, _) = run("slides_last", &last, &further);
    near(&[other[0][2], other[0][4]], &[1.0, 0.0], 0.0);
    near(&[rows[0][4], rows[0][5]], &[other[0][3], other[0][5]], 1e-9);
}

#[test]
fn sampled_pendulum_saturates_like_manual_integration() {
    let design = PENDULUM.replace("eps", "u_max = 0.3\neps");
    let (head, rows, _) = run("sampled", &design, &["--x0", "1,0", "--sample-time", "0.01"]);
    assert_eq!(head, "tau,t,q,w,M,y1,y2,status");
    let clipped = |t: f64, x: &[f64]| hold_pendulum(t, x).clamp(-0.3, 0.3);
    let wanted = held(&pendulum(20.0), &clipped, (0.01, 100), &[1.0, 0.0]);
    assert_eq!(rows.len(), wanted.len());
    for (row, (x, u)) in rows.iter().zip(&wanted) {
        near(&row[2..], &[x[0], x[1], *u, x[0], x[1]], 1e-8);
    }
    assert!(wanted.iter().any(|(_, u)| u.abs() == 0.3), "the torque reaches its bound");
}

/// The gain of the magnet depends on its state; its resistance is other than the law takes it to be.
#[test]
fn sampled_magnet_matches_manual_integration() {
    let design = example("levitation.toml").replace("[params]", "[params]\ntau = 0.5");
    let design = design.replace("eps = 1e-3 ", "eps = 0.02 ").replace("[0.1, 5]", "0.8");
    let design =
        design.replace("[5e-3, 2e-2]", "0.01").replace("grav = ", "L = 0.02\nR = 1.5\ngrav = ");
    let flags = ["--x0", "1e-3,0,0.08", "--sample-time", "1e-3", "--plant", "R=1.55"];
    let (_, rows, _) = run("magnet", &design, &flags);
    let law = |t: f64, x: &[f64]| hold_magnet((0.5 - t).max(0.02), x);
    let wanted = held(&magnet(1.55), &law, (1e-3, 500), &[1e-3, 0.0, 0.08]);
    for (row, (x, u)) in rows.iter().zip(&wanted) {
        near(&row[2..5], x, 1e-8);
        near(&row[5..6], &[*u], 1e-6);
    }
}

/// Noise, steps and a late input are around the states of the model, each with a bound of its own.
#[test]
fn noise_steps_and_delay_apply_to_the_model_states() {
    let around =
        ["--noise", "1e-3,0.1", "--sensor-step", "0.01,0", "--u-step", "0.25", "--delay", "1"];
    let flags = [&["--x0", "1,0", "--sample-time", "0.01"][..], &around].concat();
    let (_, rows, _) = run("around", PENDULUM, &flags);
    for row in &rows {
        assert!((row[5] - row[2]).abs() <= 1e-3 + 0.005 + 1e-12, "{row:?}");
        assert!((row[5] / 0.01 - (row[5] / 0.01).round()).abs() < 1e-9, "{row:?}");
        assert!((row[6] - row[3]).abs() <= 0.1 && (row[4] * 4.0).fract() == 0.0, "{row:?}");
    }
    assert!(rows.iter().any(|row| (row[6] - row[3]).abs() > 0.05), "there is noise on w");
    assert_eq!(rows[0][4], 0.0, "nothing acts before the delay");
}

#[test]
fn output_follows_its_reference() {
    let design = format!("reference = \"0.3*sin(2*dt)\"\n{PENDULUM}");
    let (_, rows, told) = run("reference", &design, &["--x0", "1,0", "--at", "0.5,0.9"]);
    for (row, dt) in rows.iter().zip([0.5_f64, 0.9]) {
        // The error is c (4 s^3 - 3 s^4) + d (s^3 - s^4) from x1 - r = 1 and its slope -0.6 at s = 1.
        let s = 1.0 - dt;
        let error = 4.0 * s.powi(3) - 3.0 * s.powi(4) + 0.6 * (s.powi(4) - s.powi(3));
        near(&row[2..3], &[0.3 * (2.0 * dt).sin() + error], 1e-9);
    }
    assert!(told.contains("tracking error at t = 0.9 s: e1 = "), "{told}");
}

#[test]
fn reports_and_pictures_name_the_states() {
    let folder = folder_with("models_simulated_page", "plant.toml", PENDULUM);
    let files = ["--x0", "1,0", "-o", "run.csv", "--plot", "run.svg", "--report", "run.html"];
    let (code, _, stderr) = run_in(&folder, &[&["simulate", "plant.toml"], &files[..]].concat());
    assert_eq!(code, Some(0), "{stderr}");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("a file");
    for (file, parts) in [
        ("run.csv", ["tau,t,q,w,M\n"].as_slice()),
        ("run.svg", &[">\nq\n<", ">\nw\n<", ">\nM"]),
        ("run.html", &["The emitted controller at every instant", "inertia", ">w</th>"]),
    ] {
        let text = read(file);
        for part in parts {
            assert!(text.contains(part), "{file}: {part}");
        }
    }
}

#[test]
fn errors_for_model_plants_suggest_a_fix() {
    let without = PENDULUM.replace("eps = 0.05\n", "");
    for (design, flags, told) in [
        (
            PENDULUM,
            ["--x0", "1"].as_slice(),
            "give one number for each of q, w, separated by commas",
        ),
        (&without, &["--x0", "1,0"], "eps has no value in the design"),
        (PENDULUM, &["--x0", "1,0", "--plant", "f=0"], "nothing of the plant is called `f`"),
        (PENDULUM, &["--x0", "1,0", "--plant", "drg=0"], "did you mean `drag`?"),
        (PENDULUM, &["--x0", "1,0", "--plant", "dynamics=w"], "1 rate for 2 states"),
        (PENDULUM, &["--x0", "1,0", "--plant", "drag=[0, 1]"], "give --plant drag=VALUE"),
    ] {
        let folder = folder_with("models_simulated_mistakes", "plant.toml", design);
        let (code, _, stderr) = run_in(&folder, &[&["simulate", "plant.toml"], flags].concat());
        assert_eq!(code, Some(2), "{stderr}");
        assert!(stderr.contains(told), "{told}: {stderr}");
    }
}
