//! Pictures of the feasible set, by `check --plot`.

use std::fs;

use crate::support;

const DESIGN: &str = "name = \"stage\"\nn = 3\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\n\
    poles = \"least-energy\"\nunits = \"mm\"\nlate = \"extend\"\nreserve = 0.1\nstate_max = [inf, 2, inf]\n\
    [params]\ntau = 1\neps = 0\nu_max = 8\n";

#[test]
fn pictures_are_written_beside_the_report() {
    let folder = support::folder_with("written", "stage.toml", DESIGN);
    let (code, report, told) = support::run_in(&folder, &["check", "stage.toml"]);
    assert_eq!(code, Some(0), "{report}{told}");
    for (name, head) in [("set.svg", "<svg"), ("set.png", "\u{fffd}PNG"), ("set.pdf", "%PDF")] {
        let (code, same, told) = support::run_in(&folder, &["check", "stage.toml", "--plot", name]);
        assert_eq!((code, &same), (Some(0), &report), "{told}");
        assert!(told.contains(&format!("wrote {name}")), "{told}");
        let bytes = fs::read(folder.join(name)).expect("a picture");
        assert!(String::from_utf8_lossy(&bytes).starts_with(head), "{name}");
    }
    let svg = fs::read_to_string(folder.join("set.svg")).expect("a picture");
    for text in [
        "stage: deadlines within the limits, x3 = 0",
        "kept at tau = 1 s",
        "soonest deadline, without the reserve:",
        "0.5 s",
        "1.25 s",
        "x1 in mm",
        "x2 in mm/s",
        "prefers-color-scheme: dark",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    let json = ["check", "stage.toml", "--format", "json", "--plot", "set.svg"];
    let (_, json, _) = support::run_in(&folder, &json);
    assert!(serde_json::from_str::<serde_json::Value>(&json).is_ok(), "{json}");
    assert_eq!(fs::read_to_string(folder.join("set.svg")).expect("a picture"), svg);
}

#[test]
fn pictures_that_cannot_be_drawn_are_refused() {
    let folder = support::folder("refused");
    let without = |line: &str| DESIGN.replace(line, "");
    let plain = without("late = \"extend\"\nreserve = 0.1\nstate_max = [inf, 2, inf]\n");
    let in_time = plain.replace("clock = \"samples\"\n", "").replace("eps = 0", "eps = 0.1");
    for (text, why) in [
        (in_time.replace("\"least-energy\"", "[-4, -5, -6]"), "known of a clock in samples"),
        (plain.replace("u_max = 8", "u_max = inf"), "u has no limit"),
        (plain.replace("n = 3", "n = 1"), "a chain of order 1 has no plane"),
        (plain.replace("\"least-energy\"", "[-4.5, -6, -8]"), "no bounds in closed form"),
    ] {
        fs::write(folder.join("stage.toml"), &text).expect("a file");
        let (code, out, told) =
            support::run_in(&folder, &["check", "stage.toml", "--plot", "set.svg"]);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{text}{told}");
        assert!(told.contains(why) && told.matches("error").count() == 1, "{why}: {told}");
        assert!(!folder.join("set.svg").exists(), "{why}");
    }
    fs::write(folder.join("stage.toml"), DESIGN).expect("a file");
    for (name, why) in [("set.jpg", "unsupported image type"), ("stage.toml/set.svg", "--plot")] {
        let (code, out, told) = support::run_in(&folder, &["check", "stage.toml", "--plot", name]);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{told}");
        assert!(told.contains(why), "{told}");
    }
}
