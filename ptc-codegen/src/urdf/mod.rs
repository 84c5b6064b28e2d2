//! Robots from URDF: the tree of rigid bodies that joints move, with exact numbers.
//!
//! [`read`] takes the text of a URDF file and gives a [`Robot`]: links that fixed joints connect are one body, every
//! joint turns about or slides along the z axis of its body, and mass, first moment and second moments of a body are
//! those about the origin of its frame.

// The macro reads no files, and leaves unused what only their reader needs.
#[cfg_attr(not(feature = "urdf"), allow(dead_code))]
mod angle;
#[cfg(feature = "urdf")]
mod document;
mod drive;
#[cfg_attr(not(feature = "urdf"), allow(dead_code))]
mod geometry;
#[cfg_attr(not(feature = "urdf"), allow(dead_code))]
mod inertia;
mod payload;
mod source;
#[cfg(feature = "urdf")]
mod tree;

pub use drive::{Drive, Drives, Part};
pub use geometry::{Matrix, Placement, Vector};
pub use inertia::Inertia;
pub use payload::Payload;
pub(crate) use source::payload_text;
pub use source::{Ends, Source};

use crate::algebra::BigRational;
#[cfg(feature = "urdf")]
use document::Document;

/// A mistake in a URDF file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wrong {
    /// Line of the file, from 1; `None` for the file as a whole.
    pub line: Option<u32>,
    /// What is wrong.
    pub message: String,
    /// What is legal, and the likely fix.
    pub help: String,
}

#[cfg(feature = "urdf")]
impl Wrong {
    fn whole(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { line: None, message: message.into(), help: help.into() }
    }
}

/// Motion of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Rotation about z.
    Revolute,
    /// Translation along z.
    Prismatic,
}

/// A body with the joint that moves it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Body {
    /// Name of the joint.
    pub joint: String,
    /// Motion of the joint.
    pub motion: Motion,
    /// Largest torque or force of the joint, if the file gives one.
    pub effort: Option<BigRational>,
    /// The body that carries the joint; `None` for the base.
    pub parent: Option<usize>,
    /// Frame of the body in that of its parent, at position 0.
    pub placement: Placement,
    /// Inertia of the body in its own frame.
    pub inertia: Inertia,
    /// What the drive of the joint adds.
    pub drive: Drive,
}

/// A robot: bodies with one degree of freedom each, parents before children.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Robot {
    /// Name in the file.
    pub name: String,
    /// Name of the link that does not move.
    pub base: String,
    /// The bodies.
    pub bodies: Vec<Body>,
    /// The frame whose motion is described; `None` if the robot has several ends.
    pub tip: Option<Tip>,
    /// Joints that are held at position 0, by name.
    pub held: Vec<String>,
}

/// A frame on a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tip {
    /// Name of the link.
    pub link: String,
    /// Its body; `None` for the base.
    pub body: Option<usize>,
    /// Its frame in that of the body.
    pub placement: Placement,
}

impl Robot {
    /// Returns the names of its joints, in the order of their positions.
    pub fn joints(&self) -> impl Iterator<Item = &str> {
        self.bodies.iter().map(|body| body.joint.as_str())
    }

    /// Returns the first joint that moves a body without mass.
    pub fn without_mass(&self) -> Option<&str> {
        let empty = |body: &&Body| body.inertia == Inertia::none();
        self.bodies.iter().find(empty).map(|body| body.joint.as_str())
    }
}

/// Reads the robot between two links of a URDF file.
///
/// # Errors
/// The first mistake: XML that is not well-formed, an element without what it needs, a number that is not one, links
/// that joints do not connect to one tree, or a joint of a kind that is not supported.
#[cfg(feature = "urdf")]
pub fn read(text: &str, ends: &Ends) -> Result<Robot, Wrong> {
    let document = Document::read(text)?;
    tree::robot(&document, ends)
}

/// A number rounded to a multiple of 2^-`bits`, so that products of many stay short.
fn rounded(value: &BigRational, bits: usize) -> BigRational {
    let scale = BigRational::from_integer(num_bigint::BigInt::from(1) << bits);
    (value * &scale).round() / scale
}

/// Bits behind the point of what is irrational: some thirty digits, twice those of a double.
const BITS: usize = 110;

/// A name of a URDF file in characters that every comment can hold.
pub(crate) fn plain(name: &str) -> String {
    let legal = |c: char| c.is_ascii_alphanumeric() || "_-.+: ".contains(c);
    name.chars().map(|c| if legal(c) { c } else { '_' }).collect()
}
