//! Compares the output shown on the pages with that of their commands.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::{
    AXES, BARRIER, CART, DESIGN, DRIVE, ELASTIC, ENCODER, FILTER, GANTRY, GUIDE, GUIDE_AXES,
    GUIDE_MODEL, GUIDE_QUADROTOR, GUIDE_STATES, GUIDE_TARGET, GUIDE_UNCERTAIN, GUIDE_VERIFY,
    MODELS, MOTOR, MOVES, PENDULUM, QUADROTOR, REFERENCES, RESONANCE, ROBOT, ROBOTS, ROBUST,
    SAMPLES, SIMULATE, TABLE, TANK, TIME, TRACK, VERIFY, blocks_of, folder, pages, shell,
};

/// Returns the output of `line` in `folder`; a refused design is not a failure.
pub(super) fn printed(line: &str, folder: &Path) -> String {
    let binary = format!("'{}'", env!("CARGO_BIN_EXE_ptc-codegen"));
    let command = line.replacen("ptc-codegen", &binary, 1);
    let output = Command::new("sh").args(["-c", &command]).current_dir(folder).output();
    let output = output.expect("a shell");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(matches!(output.status.code(), Some(0 | 1)), "{line}\n{told}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// Puts what `line` prints now into its page, in place of what is shown there.
fn write(name: &str, line: &str, shown: &str, told: &str) {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs").join(name);
    let text = fs::read_to_string(&page).expect("a page");
    // A session within a list stands further in.
    let session = |output: &str, indent: &str| {
        let all = format!("$ {line}\n{output}");
        let within = |line: &str| match line.is_empty() {
            true => "\n".to_owned(),
            false => format!("{indent}{line}\n"),
        };
        all.lines().map(within).collect::<String>()
    };
    let new = ["", "  ", "    "]
        .into_iter()
        .map(|indent| text.replace(&session(shown, indent), &session(told, indent)))
        .find(|new| *new != text);
    fs::write(&page, new.unwrap_or_else(|| panic!("docs/{name} does not show {line}")))
        .expect("writable");
    println!("docs/{name}: {line}");
}

#[test]
fn pages_show_what_is_printed() {
    let folder = folder("pages");
    let [stage, carriage, event] = &blocks_of(SIMULATE, "toml")[..] else { panic!("designs") };
    let late = ENCODER.replace("[params]", "late = \"extend\"\n[params]");
    fs::write(folder.join("events.toml"), format!("{late}\n{event}")).expect("writable");
    fs::write(folder.join("stage.toml"), stage).expect("writable");
    fs::write(folder.join("carriage.toml"), carriage).expect("writable");
    assert_eq!(blocks_of(RESONANCE, "toml"), [ELASTIC]);
    fs::write(folder.join("elastic.toml"), ELASTIC).expect("writable");
    let [uncertain, energy, belt] = &blocks_of(VERIFY, "toml")[..] else { panic!("designs") };
    fs::write(folder.join("uncertain.toml"), uncertain).expect("writable");
    fs::write(folder.join("energy.toml"), energy).expect("writable");
    let [axis] = &blocks_of(GUIDE_VERIFY, "toml")[..] else { panic!("a design") };
    fs::write(folder.join("axis.toml"), axis).expect("writable");
    fs::write(folder.join("belt.toml"), belt).expect("writable");
    // The second one takes a minute, and has a test of its own.
    let [wish, _] = &blocks_of(DESIGN, "toml")[..] else { panic!("two wishes") };
    fs::write(folder.join("wish.toml"), wish).expect("writable");
    fs::write(folder.join("encoder.toml"), ENCODER).expect("writable");
    let [flight, settled, gate, motor] = &blocks_of(SAMPLES, "toml")[..] else { panic!("designs") };
    let in_flight = ENCODER.replace("[params]", &format!("{flight}\n[params]"));
    fs::write(folder.join("flight.toml"), in_flight).expect("writable");
    let [duration] = &blocks_of(TIME, "toml")[..] else { panic!("a design") };
    fs::write(folder.join("duration.toml"), duration).expect("writable");
    let [moves, random] = &blocks_of(MOVES, "toml")[..] else { panic!("events") };
    let (keys, events) = moves.split_once("[[event]]").expect("keys and events");
    let moves = ENCODER.replace("[params]", &format!("{keys}\n[params]"));
    fs::write(folder.join("moves.toml"), format!("{moves}\n[[event]]{events}")).expect("writable");
    fs::write(folder.join("random.toml"), format!("{moves}\n{random}")).expect("writable");
    let of_round = ["observer_poles", "observer_samples", "observer_eps"];
    let lines = ENCODER.lines().filter(|line| !of_round.iter().any(|key| line.starts_with(key)));
    let lines: Vec<_> = lines.collect();
    let stationary = lines.join("\n").replace("[params]", &format!("{settled}\n[params]"));
    fs::write(folder.join("stationary.toml"), stationary).expect("writable");
    let gated = ENCODER.replace("[params]", &format!("{gate}\n[params]"));
    fs::write(folder.join("gated.toml"), gated).expect("writable");
    let [uncertain_stage] = &blocks_of(ROBUST, "toml")[..] else { panic!("a plant") };
    let robust = format!("{ENCODER}\n{uncertain_stage}");
    fs::write(folder.join("robust.toml"), robust).expect("writable");
    assert_eq!(motor, MOTOR);
    fs::write(folder.join("motor.toml"), MOTOR).expect("writable");
    let [shown @ .., uncertain] = &blocks_of(MODELS, "toml")[..] else { panic!("designs") };
    let [tank, robot, barrier] = shown else { panic!("designs") };
    assert_eq!([tank, robot], [TANK, ROBOT]);
    assert_eq!(blocks_of(GUIDE_UNCERTAIN, "toml"), [PENDULUM]);
    assert_eq!(blocks_of(GUIDE_MODEL, "toml"), [DRIVE]);
    let (_, law) = barrier.split_once('\n').expect("a comment and a law");
    assert!(BARRIER.contains(law), "{law}");
    fs::write(folder.join("barrier_arm.toml"), BARRIER).expect("writable");
    fs::write(folder.join("arm.toml"), format!("{ROBOT}\n{uncertain}")).expect("writable");
    fs::write(folder.join("drive.toml"), DRIVE).expect("writable");
    fs::write(folder.join("pendulum.toml"), PENDULUM).expect("writable");
    fs::write(folder.join("tank.toml"), TANK).expect("writable");
    fs::write(folder.join("two_link.toml"), ROBOT).expect("writable");
    fs::write(folder.join("cart.toml"), CART).expect("writable");
    let [pick] = &blocks_of(REFERENCES, "toml")[..] else { panic!("a design") };
    assert_eq!(blocks_of(GUIDE_TARGET, "toml"), [TRACK]);
    fs::write(folder.join("track.toml"), TRACK).expect("writable");
    fs::write(folder.join("pick.toml"), pick).expect("writable");
    assert_eq!(blocks_of(GUIDE_AXES, "toml"), [GANTRY]);
    assert_eq!(blocks_of(GUIDE_QUADROTOR, "toml"), [QUADROTOR]);
    let [coupling, hall] = &blocks_of(AXES, "toml")[..] else { panic!("designs") };
    fs::write(folder.join("hall.toml"), hall).expect("writable");
    fs::write(folder.join("coupled.toml"), format!("{GANTRY}\n{coupling}")).expect("writable");
    fs::write(folder.join("gantry.toml"), GANTRY).expect("writable");
    fs::write(folder.join("quadrotor.toml"), QUADROTOR).expect("writable");
    assert_eq!(blocks_of(GUIDE, "toml"), [TABLE]);
    fs::write(folder.join("table.toml"), TABLE).expect("writable");
    let [robot] = &blocks_of(ROBOTS, "xml")[..] else { panic!("a robot") };
    fs::write(folder.join("scara.urdf"), robot).expect("writable");
    let [reach, functions] = &blocks_of(ROBOTS, "toml")[..] else { panic!("designs") };
    fs::write(folder.join("reach.toml"), reach).expect("writable");
    fs::write(folder.join("scara.toml"), functions).expect("writable");
    let [stop] = &blocks_of(FILTER, "toml")[..] else { panic!("a filter") };
    fs::write(folder.join("stop.toml"), stop).expect("writable");
    let [lift] = &blocks_of(GUIDE_STATES, "toml")[..] else { panic!("a design") };
    fs::write(folder.join("lift.toml"), lift).expect("writable");
    // Those of one command, to refresh a few pages in seconds.
    let only = std::env::var("PTC_SESSIONS").ok();
    let campaigns = blocks_of(VERIFY, "sh").concat();
    for line in campaigns.lines().filter(|_| only.is_none()) {
        assert!(!printed(line, &folder).is_empty(), "{line}");
    }
    let pages = pages();
    for (name, page) in &pages {
        for block in blocks_of(page, "console") {
            let session = block.strip_prefix("$ ").expect("a command").replace("\n$ ", "\n\0");
            for part in session.split('\0') {
                let (line, shown) = part.split_once('\n').expect("a command and its output");
                if only.as_ref().is_some_and(|only| !line.contains(only)) {
                    continue;
                }
                if line.contains("--engine symbolica")
                    && std::env::var_os("PTC_ENGINE_PROGRAM").is_none()
                {
                    continue;
                }
                let told = printed(line, &folder);
                if told != shown && std::env::var_os("UPDATE_GOLDEN").is_some() {
                    write(name, line, shown, &told);
                    continue;
                }
                assert_eq!(told, shown, "docs/{name}: {line}");
            }
        }
    }
    // What the guide shows is what its commands draw.
    for picture in [
        "axes.svg",
        "choose.svg",
        "feasible.svg",
        "feasible_set.svg",
        "moves.svg",
        "noise.svg",
        "period.svg",
        "python.svg",
        "robust.svg",
        "sensors.svg",
        "torque.svg",
    ] {
        let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide").join(picture);
        let drawn = folder.join(picture);
        if only.is_some() && !drawn.exists() {
            continue;
        }
        if std::env::var_os("UPDATE_GOLDEN").is_some() {
            fs::copy(&drawn, &kept).expect("writable");
        }
        let [kept, drawn] = [kept, drawn].map(|path| fs::read_to_string(path).expect("a picture"));
        assert!(kept == drawn, "docs/guide/{picture} is another picture");
    }
    if only.is_some() {
        return;
    }
    for (name, page) in [("gantry", AXES), ("quadrotor", GUIDE_QUADROTOR)] {
        let [program] = &blocks_of(page, "c")[..] else { panic!("one program") };
        let [shown] = &blocks_of(page, "text")[..] else { panic!("one output") };
        fs::write(folder.join("main.c"), program).expect("writable");
        let strict = format!(
            "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -ffp-contract=off -Iaxes main.c axes/{name}.c -lm -o {name} && ./{name}"
        );
        assert_eq!(&shell(&strict, &folder), shown, "{name}");
    }
    let [program] = &blocks_of(ROBOTS, "c")[..] else { panic!("one program") };
    let [shown] = &blocks_of(ROBOTS, "text")[..] else { panic!("one output") };
    fs::write(folder.join("main.c"), program).expect("writable");
    let strict = "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -ffp-contract=off -Iscara main.c scara/scara.c -lm -o demo && ./demo";
    assert_eq!(&shell(strict, &folder), shown, "scara");
    let (programs, shown) = (blocks_of(FILTER, "c"), blocks_of(FILTER, "text"));
    fs::write(folder.join("main.c"), &programs[0]).expect("writable");
    let strict = "cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -ffp-contract=off -Istop main.c stop/stop_filter.c -lm -o demo && ./demo";
    assert_eq!(shell(strict, &folder), shown[0], "stop");
    for check in ["membership", "growth", "sampling", "deadline", "loop", "envelope"] {
        let page = pages.iter().find(|(name, _)| *name == format!("checks/{check}.md"));
        let shown = blocks_of(&page.expect("a page").1, "console").concat();
        assert!(shown.contains(&format!("refused: {check}")), "{check} shows no refusal");
    }
    assert!(blocks_of(MODELS, "console").concat().contains("refused: zeros"), "models.md");
}
