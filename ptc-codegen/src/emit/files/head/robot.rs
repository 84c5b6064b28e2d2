//! The head of the files of a robot.

use super::Language;
use super::time::wrap;
use crate::robot::{Quantity, Request};
use crate::urdf::{Body, Robot, plain};

/// Lines of the head, without comment signs.
pub(in crate::emit) fn lines(request: &Request, robot: &Robot, language: Language) -> Vec<String> {
    let names: Vec<_> = request.quantities.iter().map(|own| own.word().replace('-', " ")).collect();
    let (name, lang) = (request.name(robot), language.name());
    let gravity = request.source.gravity_text(", ");
    let tip = robot.tip.as_ref().map(|tip| format!(" Tip: {}.", plain(&tip.link)));
    let mut lines = vec![
        format!("Robot {name}: {}.", names.join(", ")),
        String::new(),
        "DO NOT EDIT. Made by:".to_owned(),
        // A command is one line, to be copied.
        format!("  ptc-codegen emit --lang {lang} {}", request.command()),
    ];
    let mut rest = vec![
        format!("Version {}, of {}.", env!("CARGO_PKG_VERSION"), plain(&robot.name)),
        String::new(),
        format!("Joints, in the order of all arrays: {}.", listed(robot.joints())),
        format!(
            "Base: {}, gravity ({gravity}) m/s^2 in its axes.{}",
            plain(&robot.base),
            tip.unwrap_or_default()
        ),
    ];
    if !robot.held.is_empty() {
        rest.push(format!(
            "Held at position 0: {}.",
            listed(robot.held.iter().map(String::as_str))
        ));
    }
    if request.quantities.contains(&Quantity::InverseDynamics) {
        rest.push("Inverse dynamics by the recursive Newton-Euler algorithm.".to_owned());
        rest.push(robot.left_out());
    }
    let drives: Vec<_> = robot.bodies.iter().filter_map(drive).collect();
    if !drives.is_empty() {
        rest.push(format!("Drives: {}.", drives.join("; ")));
    }
    for (part, _) in request.source.of_file(robot) {
        rest.push(format!("{} of the joints: <dynamics> of the URDF.", part.key()));
    }
    if request.quantities.iter().any(|own| *own != Quantity::Jacobian) {
        rest.push(
            "What of the inertia of a body acts on its parent in the same way at every position of the joint is added to that of the parent."
                .to_owned(),
        );
    }
    lines.extend(rest.into_iter().flat_map(|line| wrap(&line)));
    lines
}

fn drive(body: &Body) -> Option<String> {
    Some(format!("{} {}", plain(&body.joint), body.drive.text()?))
}

fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.map(plain).collect::<Vec<_>>().join(", ")
}
