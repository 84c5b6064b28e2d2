//! Wishes for loops in samples: the law of least energy first, the keys that are left open, and bounded work.

use std::fs;

use super::{designed, folder, is_taken, numbers};
use crate::support::{command_in, run_in as run};

/// A stage of 1.5 kg with an encoder and a force that is not known.
const STAGE: &str = "name = \"stage\"\nn = 2\ng = \"1/1.5\"\nclock = \"samples\"\nsample_time = 1e-3\ndelay = 1\n\
    measured = [\"x1\"]\nsensor_step = [1e-6, 0]\ndisturbance = \"constant\"\nobserver_poles = [-4, -5, -6]\n\
    observer_samples = 200\nobserver_eps = 0.03\nu_max = 3\n[params]\ntau = 0.8\n[plant]\nf = \"load/1.5\"\n\
    load = [-0.5, 0.5]\n[verify]\nx1 = [-0.1, 0.1]\nx2 = 0\nscenarios = 40\nsearch = 20\nseed = 7\n\
    [[objective]]\nbound = \"attractive\"\nerror = 1e-3\n[[objective]]\nbound = \"input\"\nupsilon = \"2\"\n";

/// Two masses and a belt between them, of which the first one is driven and measured.
const BELT: &str = "n = 4\nname = \"belt\"\nclock = \"samples\"\nsample_time = 5e-4\ndelay = 1\n\
    sensor_step = 7.7e-6\ndisturbance = \"constant\"\nx0_max = [0.3, 0.3, 1e-3, 1e-3]\n[params]\nu_max = 100\n\
    tau = 0.5\n[plant]\nA = [[0,0,1,0],[0,0,0,1],[-4e5,4e5,-120,120],[66666.67,-66666.67,20,-20]]\n\
    B = [0,0,2,0]\nC = [1,0,0,0]\n[verify]\nx1 = 0.3\nx2 = 0.3\nx3 = 0\nx4 = 0\nscenarios = 40\nsearch = 20\n\
    [[objective]]\nbound = \"input\"\nupsilon = 1e-3\n[[objective]]\nbound = \"attractive\"\nerror = 1e-3\n";

/// Returns the value of a key in a design.
fn value<'a>(design: &'a str, key: &str) -> Option<&'a str> {
    design.lines().find_map(|line| line.strip_prefix(&format!("{key} = ")))
}

/// The number of tries in a report.
fn tries(told: &str) -> usize {
    let number = told.split(" tr").next().and_then(|text| text.split(' ').next_back());
    number.expect("tries").parse().expect("a number")
}

#[test]
fn least_energy_comes_first_and_its_end_is_chosen() {
    let folder = folder("limit", STAGE);
    let (design, told) = designed(&folder);
    // With the law alone the steps of the encoder take u beyond 2 N in the last samples.
    assert!(
        told.contains("the first try, mu = \"exp(a=1)\", poles = \"least-energy\": "),
        "{told}"
    );
    assert_eq!(value(&design, "poles"), Some("\"least-energy\""), "{design}");
    assert_eq!(value(&design, "poles_end"), Some("\"least-energy(weight=1)\""), "{design}");
    assert!(told.contains("chosen: poles = \"least-energy\": the law of least energy"), "{told}");
    assert!(told.contains("|u| <= 2: holds, proved by the worst case"), "{told}");
    assert!(tries(&told) <= 20, "{told}");
    is_taken(&folder);
}

#[test]
fn keys_of_the_file_are_kept() {
    let given = "delay_law = \"predict\"\npoles_end = \"least-energy(weight=2)\"\nend_samples = 100\nn = 2\n";
    let wish = STAGE.replacen("n = 2\n", given, 1).replace("\"2\"", "\"2.4\"");
    let path = folder("kept", &wish.replace("tau = 0.8\n", "tau = 0.8\neps = 0\n"));
    let (design, told) = designed(&path);
    for line in wish.lines() {
        assert!(design.lines().any(|own| own == line), "{line} is lost\n{design}");
    }
    let keys =
        ["delay_law", "poles_end", "end_samples", "eps", "observer_poles", "observer_samples"];
    for key in keys {
        assert!(!told.contains(&format!("chosen: {key} ")), "{key}: {told}");
        assert_eq!(design.matches(&format!("\n{key} = ")).count(), 1, "{key}: {design}");
    }
    is_taken(&path);

    // Nothing is open beside a law and an observer that are given.
    let whole =
        STAGE.replacen("n = 2\n", "n = 2\nmu = \"exp(a=1)\"\npoles = \"least-energy\"\n", 1);
    let path = folder("kept_whole", &whole);
    let (code, told, wrong) = run(&path, &["design", "wish.toml", "-o", "roll.toml"]);
    assert_eq!((code, told.as_str()), (Some(1), ""), "{wrong}");
    assert!(
        wrong.contains("objective 2, |u| <= 2, fails, and nothing is left to choose"),
        "{wrong}"
    );
}

#[test]
fn open_observer_is_chosen() {
    let lines = STAGE.lines().filter(|line| !line.starts_with("observer_"));
    let open = lines.collect::<Vec<_>>().join("\n").replace("\"2\"", "\"2.4\"");
    let given = open.replacen("n = 2\n", "n = 2\nmu = \"exp(a=1)\"\npoles = \"least-energy\"\n", 1);
    for (test, wish) in [("observer", &given), ("observer_and_law", &open)] {
        let path = folder(test, wish);
        let (design, told) = designed(&path);
        // Position, speed and force.
        assert_eq!(numbers(&design, "observer_poles").len(), 3, "{design}");
        assert!(told.contains("chosen: observer_poles = ["), "{told}");
        assert_eq!(told.contains("chosen: poles ="), test != "observer", "{told}");
        is_taken(&path);
    }
    // One that is to be stationary lacks the drift of its force.
    let law = "n = 2\nobserver = \"stationary\"\npoles_end = \"least-energy(weight=1)\"\nend_samples = 400\n";
    let stationary = given.replacen("n = 2\n", law, 1).replace("u_max = 3", "u_max = 6");
    let path = folder("observer_stationary", &stationary);
    let (design, told) = designed(&path);
    assert!(value(&design, "disturbance_walk").is_some(), "{design}\n{told}");
    assert!(!told.contains("chosen: observer "), "{told}");
    is_taken(&path);
}

/// The wish of the page on `design` that bounds error, force and energy at once, with an observer that spares a minute.
#[test]
fn error_force_and_energy_are_bounded_at_once() {
    let page = include_str!("../../../../docs/design.md");
    let wish = page.split("```toml\n").nth(2).and_then(|rest| rest.split("```").next());
    let observer = "disturbance_walk = 6\nobserver_poles = [-3, -4, -5]\nobserver_samples = 186\n\
                    observer_eps = 0.015\nafter_observer = \"stationary\"\nn = 2\n";
    let wish = wish.expect("a second wish").replacen("n = 2\n", observer, 1);
    let folder = folder("precise", &wish);
    let (_, told) = designed(&folder);
    for number in 1..=3 {
        let line = told.lines().find(|line| line.starts_with(&format!("objective {number}, ")));
        assert!(line.is_some_and(|line| line.contains(": holds, by sampling, ")), "{told}");
    }
    let (code, told, wrong) = run(&folder, &["verify", "roll.toml", "--seed=9281"]);
    assert_eq!((code, wrong.as_str()), (Some(0), ""), "{told}");
}

#[test]
fn belt_ends_within_its_tries() {
    let folder = folder("belt", BELT);
    let (code, told, wrong) =
        run(&folder, &["design", "wish.toml", "--tries=6", "-o", "roll.toml"]);
    // Nobody moves 0.3 m in half a second with a thousandth of a newton.
    assert_eq!((code, told.as_str()), (Some(1), ""), "{wrong}");
    assert!(wrong.contains("the best of 6 tries") && wrong.contains("--tries"), "{wrong}");
    assert!(!folder.join("roll.toml").exists());
}

/// A first SIGINT ends the search with the best choice so far.
#[cfg(target_os = "linux")]
/// A joint of two masses by A and B, with neither n nor poles: the gains of least energy are the first try.
#[test]
fn linear_plant_gets_gains_of_least_energy() {
    let wish = "name = \"joint\"\nclock = \"samples\"\nsample_time = 1e-3\ndelay = 1\n[params]\n\
        tau = 0.3\nu_max = 20\n[plant]\n\
        A = [[0,1,0,0],[-900,-0.6,900,0.6],[0,0,0,1],[400,0.3,-400,-0.3]]\nB = [0,0,0,1]\n[verify]\n\
        x1 = [-0.001, 0.001]\nx2 = 0\nx3 = [-0.001, 0.001]\nx4 = 0\nscenarios = 20\nsearch = 10\n\
        [[objective]]\nbound = \"attractive\"\nerror = [1e-3, 0.1, 1e-3, 0.1]\n\
        [[objective]]\nbound = \"input\"\nupsilon = 10\n";
    let path = folder("joint", wish);
    let (design, told) = designed(&path);
    let poles = value(&design, "poles").expect("poles");
    assert!(poles.starts_with("\"least-energy"), "{design}\n{told}");
    assert!(tries(&told) <= 5, "{told}");
    is_taken(&path);
}

#[test]
fn interrupt_reports_the_best_choice() {
    use std::process::{Command, Stdio};

    let folder = folder("interrupted", BELT);
    let mut child = command_in(&folder, &["design", "wish.toml", "-o", "roll.toml"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("runs");
    // Bit 1 of the caught signals is SIGINT.
    let status = format!("/proc/{}/status", child.id());
    let is_caught = || {
        let text = fs::read_to_string(&status).expect("it is still running");
        let mask = text.lines().find_map(|line| line.strip_prefix("SigCgt:")).expect("a mask");
        u64::from_str_radix(mask.trim(), 16).expect("a mask") & 2 != 0
    };
    while !is_caught() {
        // A shell in the background may have had SIGINT ignored.
        assert!(child.try_wait().expect("a child").is_none(), "it never caught SIGINT");
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("runs").success());
    let ended = child.wait_with_output().expect("ends");
    let wrong = String::from_utf8_lossy(&ended.stderr);
    assert_eq!(ended.status.code(), Some(130), "{wrong}");
    for part in ["the best of ", "objective 1, |u| <= 1/1000: at ", "help: interrupted"] {
        assert!(wrong.contains(part), "no {part:?} in {wrong}");
    }
    assert!(!folder.join("roll.toml").exists());
}
