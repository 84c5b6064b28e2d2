//! A robot read from its URDF file.

use num_traits::Zero;

use super::robot::{NO_TIP, driven, known, part_of, payload_of};
#[cfg(feature = "cli")]
use super::{Entry, robot::asked_for};
use crate::algebra::BigRational;
use crate::diagnostic::{Diagnostics, Place};
#[cfg(feature = "cli")]
use crate::request::What;
use crate::syntax::{Node, Value, number};
use crate::urdf::{self, Drives, Ends, Part, Payload, Robot, Source};

/// Returns true if entries describe functions of a robot, and not its controller.
#[cfg(feature = "cli")]
pub(crate) fn asks_for_functions(entries: &[Entry]) -> bool {
    let given = |key: &str| entries.iter().find(|entry| entry.key == key);
    let of_controller = |entry: &Entry| {
        let what = asked_for(entry);
        What::NAMES.iter().any(|(name, _)| *name == what)
    };
    given("urdf").is_some() && given("what").is_some_and(|entry| !of_controller(entry))
}

/// Reads the source of a robot.
pub(crate) fn robot_source<'a>(
    value: &dyn Fn(&str) -> Option<&'a Node>,
    found: &mut Diagnostics,
) -> Option<Source> {
    let urdf = value("urdf")?;
    let path = urdf.value.to_string();
    if path.is_empty() {
        let help = "give the path of a URDF file";
        found.push("bad-value", "urdf", Some(urdf.place), "urdf is empty", help);
    }
    let base = value("base").map(|node| node.value.to_string());
    let tips = value("tip").map(names).unwrap_or_default();
    let (gravity, payload) = (gravity(value("gravity"), found), payload(value("payload"), found));
    let drives = drives(value, found);
    let (gravity, payload, drives) = (gravity?, payload?, drives?);
    Some(Source { urdf: path, ends: Ends { base, tips }, gravity, payload, drives })
}

fn gravity(node: Option<&Node>, found: &mut Diagnostics) -> Option<[BigRational; 3]> {
    let Some(node) = node else {
        let down = number("-9.81").and_then(|own| own.number().cloned())?;
        return Some([BigRational::zero(), BigRational::zero(), down]);
    };
    let numbers: Option<Vec<BigRational>> = match &node.value {
        Value::List(items) => items.iter().map(known).collect(),
        _ => None,
    };
    let vector = numbers.and_then(|own| <[BigRational; 3]>::try_from(own).ok());
    if vector.is_none() {
        let message = format!("gravity = {}", node.value);
        let help =
            "give three numbers in m/s^2 along the axes of the base, for example 0, 0, -9.81";
        found.push("bad-value", "gravity", Some(node.place), message, help);
    }
    vector
}

/// The payload, if there is one; `None` if it cannot be read.
fn payload(node: Option<&Node>, found: &mut Diagnostics) -> Option<Option<Payload>> {
    node.map(|node| payload_of(node, "payload", found)).map_or(Some(None), |own| own.map(Some))
}

/// The parts of the drives that are given; `None` if one cannot be read.
fn drives<'a>(value: &dyn Fn(&str) -> Option<&'a Node>, found: &mut Diagnostics) -> Option<Drives> {
    let given = Part::ALL.into_iter().filter_map(|part| Some((part, value(part.key())?)));
    let read: Vec<_> =
        given.map(|(part, node)| Some((part, part_of(part, node, part.key(), found)?))).collect();
    Some(Drives(read.into_iter().collect::<Option<_>>()?))
}

/// The names in a list, or in a text with commas.
fn names(node: &Node) -> Vec<String> {
    match &node.value {
        Value::List(items) => items.iter().flat_map(names).collect(),
        other => other.to_string().split(',').map(|name| name.trim().to_owned()).collect(),
    }
}

/// The robot of the value of `urdf`; with mass in everything that moves, if it `has_inertia`. `place` gives those of the
/// other keys.
pub(crate) fn robot_of(
    node: &Node,
    source: &Source,
    has_inertia: bool,
    place: &dyn Fn(&str) -> Option<Place>,
    found: &mut Diagnostics,
) -> Option<Robot> {
    let (path, file) = (&source.urdf, node.place);
    let text = match &node.value {
        Value::File(_, Ok(text)) => text,
        Value::File(_, Err(why)) => {
            let help = "give a text file that can be read";
            found.push("bad-value", "urdf", Some(file), why, help);
            return None;
        }
        _ => {
            let message = format!("{path} has not been read");
            let help = "use the command `ptc-codegen`, which reads files beside the design";
            found.push("bad-value", "urdf", Some(file), message, help);
            return None;
        }
    };
    let robot = match urdf::read(text, &source.ends) {
        Ok(robot) => robot,
        Err(wrong) => {
            let line = wrong.line.map(|line| format!(", line {line}")).unwrap_or_default();
            let message = format!("{path}{line}: {}", wrong.message);
            found.push("bad-value", "urdf", Some(file), message, wrong.help);
            return None;
        }
    };
    if let Some(joint) = robot.without_mass().filter(|_| has_inertia) {
        let message = format!("{path}: what joint `{joint}` moves has no inertia");
        let help = "give <inertial> with <mass> and <inertia> to its child link, or to a link that is fixed to it";
        found.push("bad-value", "urdf", Some(file), message, help);
        return None;
    }
    let carried = match &source.payload {
        None => Some(robot),
        Some(payload) => robot.carrying(Some(payload), None),
    };
    if carried.is_none() {
        let (message, help) = NO_TIP;
        found.push("bad-value", "payload", place("payload"), message, help);
    }
    driven(&carried?, &source.drives, &|key| (key.to_owned(), place(key)), found)
}
