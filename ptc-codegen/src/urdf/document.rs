//! Elements of a URDF file: links with their inertia, and joints.

use std::collections::BTreeSet;

use num_traits::{Signed, Zero};
use roxmltree::{Node, ParsingOptions};

use super::Wrong;
use super::angle::Angle;
use super::drive::Drive;
use super::geometry::{Placement, Vector, roll_pitch_yaw};
use super::inertia::Inertia;
use crate::algebra::{BigRational, integer};
use crate::limits::URDF_ELEMENTS;
use crate::syntax::number;

/// A file.
pub(super) struct Document {
    pub(super) name: String,
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
}

/// A link.
pub(super) struct Link {
    pub(super) name: String,
    /// Its inertia about the origin of its frame; none if the file gives none.
    pub(super) inertia: Inertia,
}

/// A joint.
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) line: u32,
    pub(super) kind: Kind,
    /// Name of the link that carries it.
    pub(super) parent: String,
    /// Name of the link that it moves.
    pub(super) child: String,
    /// Frame of the child in that of the parent, at position 0.
    pub(super) placement: Placement,
    /// Axis in the frame of the child.
    pub(super) axis: Vector,
    /// Name of the joint that it follows.
    pub(super) mimics: Option<String>,
    /// Largest torque or force; `None` where the file has none above 0.
    pub(super) effort: Option<BigRational>,
    /// Its friction; none where the file gives none.
    pub(super) drive: Drive,
}

/// Kind of joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Fixed,
    Revolute,
    Prismatic,
    Floating,
    Planar,
}

/// Kinds of joints by their names.
const KINDS: [(&str, Kind); 6] = [
    ("fixed", Kind::Fixed),
    ("revolute", Kind::Revolute),
    ("continuous", Kind::Revolute),
    ("prismatic", Kind::Prismatic),
    ("floating", Kind::Floating),
    ("planar", Kind::Planar),
];

impl Document {
    pub(super) fn read(text: &str) -> Result<Self, Wrong> {
        let nodes_limit = u32::try_from(URDF_ELEMENTS.most).unwrap_or(u32::MAX);
        let options = ParsingOptions { nodes_limit, ..ParsingOptions::default() };
        let parsed = roxmltree::Document::parse_with_options(text, options).map_err(|error| {
            let message = match error {
                roxmltree::Error::NodesLimitReached => URDF_ELEMENTS.beyond("the file"),
                other => format!("it is not well-formed XML: {other}"),
            };
            Wrong::whole(message, "give a URDF file; run xacro on a .xacro file first")
        })?;
        let robot = parsed.root_element();
        if !robot.has_tag_name("robot") {
            let message = format!("its element is <{}>, not <robot>", robot.tag_name().name());
            return Err(wrong(robot, message, "give a URDF file: <robot> with links and joints"));
        }
        let mut document = Self {
            name: robot.attribute("name").unwrap_or("robot").to_owned(),
            links: Vec::new(),
            joints: Vec::new(),
        };
        let mut names = BTreeSet::new();
        for element in robot.children().filter(Node::is_element) {
            let kind = element.tag_name().name();
            if !matches!(kind, "link" | "joint") {
                continue;
            }
            let name = attribute(element, "name")?;
            if !names.insert((kind, name)) {
                let message = format!("there are two {kind}s called `{name}`");
                return Err(wrong(element, message, "give each its own name"));
            }
            match kind {
                "link" => document.links.push(link(element, name)?),
                _ => document.joints.push(joint(element, name)?),
            }
        }
        Ok(document)
    }
}

fn link(element: Node<'_, '_>, name: &str) -> Result<Link, Wrong> {
    let Some(inertial) = child(element, "inertial") else {
        return Ok(Link { name: name.to_owned(), inertia: Inertia::none() });
    };
    let of = |node: Node<'_, '_>, key: &str| {
        let text = attribute(node, key)?;
        decimal(node, key, text)
    };
    let needed = |tag: &str| {
        child(inertial, tag).ok_or_else(|| {
            let message = format!("the inertia of link `{name}` has no <{tag}>");
            wrong(
                inertial,
                message,
                "give <mass value=\"..\"/> and <inertia ixx=\"..\" ../>, or no <inertial>",
            )
        })
    };
    let mass_element = needed("mass")?;
    let mass = of(mass_element, "value")?;
    if mass.is_negative() {
        let message = format!("the mass of link `{name}` is negative");
        return Err(wrong(mass_element, message, "give a mass >= 0 in kg"));
    }
    let tensor = needed("inertia")?;
    let zero = BigRational::zero;
    let mut entries = [zero(), zero(), zero(), zero(), zero(), zero()];
    for (entry, key) in entries.iter_mut().zip(["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]) {
        *entry = of(tensor, key)?;
    }
    if entries[..3].iter().any(Signed::is_negative) {
        let message = format!("a moment of inertia of link `{name}` is negative");
        return Err(wrong(tensor, message, "give ixx, iyy and izz >= 0 in kg m^2"));
    }
    let inertia = Inertia::central(mass, entries).placed(&origin(inertial)?);
    Ok(Link { name: name.to_owned(), inertia })
}

fn joint(element: Node<'_, '_>, name: &str) -> Result<Joint, Wrong> {
    let written = attribute(element, "type")?;
    let Some((_, kind)) = KINDS.iter().find(|(name, _)| *name == written) else {
        let message = format!("joint `{name}` has the unknown type `{written}`");
        return Err(wrong(element, message, "legal: revolute, continuous, prismatic or fixed"));
    };
    let linked = |tag: &str| {
        let found = child(element, tag).ok_or_else(|| {
            let message = format!("joint `{name}` has no <{tag}>");
            wrong(element, message, "give <parent link=\"..\"/> and <child link=\"..\"/>")
        })?;
        attribute(found, "link").map(str::to_owned)
    };
    let axis = match child(element, "axis") {
        Some(axis) => numbers(axis, "xyz")?,
        None => [1, 0, 0].map(integer),
    };
    if axis.iter().all(Zero::is_zero) && !matches!(kind, Kind::Fixed | Kind::Floating) {
        let message = format!("the axis of joint `{name}` is 0");
        return Err(wrong(element, message, "give a direction, for example <axis xyz=\"0 0 1\"/>"));
    }
    Ok(Joint {
        name: name.to_owned(),
        line: line(element),
        kind: *kind,
        parent: linked("parent")?,
        child: linked("child")?,
        placement: origin(element)?,
        axis,
        mimics: match child(element, "mimic") {
            Some(mimic) => Some(attribute(mimic, "joint")?.to_owned()),
            None => None,
        },
        effort: effort(element)?,
        drive: drive(element, name)?,
    })
}

/// The effort of `<limit>`. Files without one often say 0.
fn effort(joint: Node<'_, '_>) -> Result<Option<BigRational>, Wrong> {
    let Some(limit) = child(joint, "limit") else { return Ok(None) };
    let Some(text) = limit.attribute("effort") else { return Ok(None) };
    Ok(Some(decimal(limit, "effort", text)?).filter(Signed::is_positive))
}

/// The damping and friction of `<dynamics>`.
fn drive(joint: Node<'_, '_>, name: &str) -> Result<Drive, Wrong> {
    let mut drive = Drive::none();
    let Some(dynamics) = child(joint, "dynamics") else { return Ok(drive) };
    let own = [("damping", &mut drive.damping), ("friction", &mut drive.friction)];
    for (key, value) in own {
        let Some(text) = dynamics.attribute(key) else { continue };
        *value = decimal(dynamics, key, text)?;
        if value.is_negative() {
            let message = format!("the {key} of joint `{name}` is negative");
            return Err(wrong(dynamics, message, format!("give {key} >= 0, or leave it out")));
        }
    }
    Ok(drive)
}

/// The placement of `<origin xyz rpy>` in an element; the frames coincide where there is none.
fn origin(element: Node<'_, '_>) -> Result<Placement, Wrong> {
    let mut placement = Placement::identity();
    let Some(origin) = child(element, "origin") else { return Ok(placement) };
    if origin.has_attribute("xyz") {
        placement.origin = numbers(origin, "xyz")?;
    }
    if let Some(text) = origin.attribute("rpy") {
        let angles: Option<Vec<Angle>> = text.split_whitespace().map(Angle::read).collect();
        let Some(angles) = angles.and_then(|all| <[Angle; 3]>::try_from(all).ok()) else {
            return Err(three_numbers(origin, "rpy", text));
        };
        placement.rotation = roll_pitch_yaw(&angles);
    }
    Ok(placement)
}

fn numbers(node: Node<'_, '_>, key: &str) -> Result<Vector, Wrong> {
    let text = attribute(node, key)?;
    let read = |part: &str| number(part).and_then(|own| own.number().cloned());
    let all: Option<Vec<BigRational>> = text.split_whitespace().map(read).collect();
    let all = all.and_then(|all| Vector::try_from(all).ok());
    all.ok_or_else(|| three_numbers(node, key, text))
}

fn three_numbers(node: Node<'_, '_>, key: &str, text: &str) -> Wrong {
    let message =
        format!("{key} = \"{text}\" of <{}> is not three numbers", node.tag_name().name());
    wrong(node, message, "give three decimal numbers, for example \"0 0 0.333\"")
}

fn decimal(node: Node<'_, '_>, key: &str, text: &str) -> Result<BigRational, Wrong> {
    let read = number(text.trim()).and_then(|own| own.number().cloned());
    read.ok_or_else(|| {
        let message = format!("{key} = \"{text}\" of <{}> is not a number", node.tag_name().name());
        wrong(node, message, "give a decimal number")
    })
}

fn attribute<'a>(node: Node<'a, '_>, key: &str) -> Result<&'a str, Wrong> {
    node.attribute(key).ok_or_else(|| {
        let message = format!("<{}> has no attribute `{key}`", node.tag_name().name());
        wrong(node, message, format!("give {key}=\"..\""))
    })
}

fn child<'a, 'b>(node: Node<'a, 'b>, tag: &str) -> Option<Node<'a, 'b>> {
    node.children().find(|own| own.has_tag_name(tag))
}

fn line(node: Node<'_, '_>) -> u32 {
    node.document().text_pos_at(node.range().start).row
}

fn wrong(node: Node<'_, '_>, message: impl Into<String>, help: impl Into<String>) -> Wrong {
    Wrong { line: Some(line(node)), message: message.into(), help: help.into() }
}
