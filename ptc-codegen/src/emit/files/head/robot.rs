//! The head of the files of a robot.

use super::Language;
use super::time::wrap;
use crate::robot::{Quantity, Request, plain};
use crate::syntax::constant;
use crate::urdf::Robot;

/// Lines of the head, without comment signs.
pub(in crate::emit) fn lines(request: &Request, robot: &Robot, language: Language) -> Vec<String> {
    let names: Vec<_> = request.quantities.iter().map(|own| own.word().replace('-', " ")).collect();
    let (name, lang) = (request.name(robot), language.name());
    let gravity: Vec<_> = request.gravity.iter().map(constant::text).collect();
    let tip = robot.tip.as_ref().map(|tip| format!(" Tip: {}.", plain(&tip.link)));
    let mut lines = vec![
        format!("Robot {name}: {}.", names.join(", ")),
        String::new(),
        "DO NOT EDIT. Made by:".to_owned(),
        // A command is one line, to be copied.
        format!("  ptc-codegen emit --lang {lang} {}", plain_command(&request.command())),
    ];
    let mut rest = vec![
        format!("Version {}, of {}.", env!("CARGO_PKG_VERSION"), plain(&robot.name)),
        String::new(),
        format!("Joints, in the order of all arrays: {}.", listed(robot.joints())),
        format!(
            "Base: {}, gravity ({}) m/s^2 in its axes.{}",
            plain(&robot.base),
            gravity.join(", "),
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
        rest.push(
            "Inverse dynamics by the recursive Newton-Euler algorithm, of rigid bodies: friction, springs and the inertia of rotors are not modelled."
                .to_owned(),
        );
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

/// A command in characters that a comment can hold.
fn plain_command(command: &str) -> String {
    let legal = |c: char| c.is_ascii_graphic() && c != '*' || c == ' ';
    command.chars().map(|c| if legal(c) { c } else { '_' }).collect()
}

fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.map(plain).collect::<Vec<_>>().join(", ")
}
