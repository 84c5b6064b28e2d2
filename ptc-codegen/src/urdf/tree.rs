//! From links and joints to the bodies of a robot: which joints move, and which links are one body.

use std::collections::{BTreeMap, BTreeSet};

use super::document::{Document, Joint, Kind, Link};
use super::geometry::{Placement, toward, transposed};
use super::inertia::turned;
use super::{Body, Ends, Inertia, Motion, Robot, Tip, Wrong};
use crate::diagnostic::near_miss;
use crate::internal::fault;
use crate::limits::URDF_JOINTS;

/// The links and joints of a file as a tree.
struct Tree<'a> {
    links: BTreeMap<&'a str, &'a Link>,
    /// The joint that moves each link.
    above: BTreeMap<&'a str, &'a Joint>,
    /// The joints that each link carries, in the order of the file.
    below: BTreeMap<&'a str, Vec<&'a Joint>>,
    root: &'a str,
}

/// The robot between two links of a file.
pub(super) fn robot(document: &Document, ends: &Ends) -> Result<Robot, Wrong> {
    let tree = Tree::of(document)?;
    let base = tree.link(ends.base.as_deref().unwrap_or(tree.root), "base")?;
    let mut way = None;
    for tip in &ends.tips {
        let joints = tree.way(base, tree.link(tip, "tip")?)?;
        way.get_or_insert_with(BTreeSet::new).extend(joints);
    }
    let mut assembly =
        Assembly { tree: &tree, way, places: BTreeMap::new(), robot: empty(document, base) };
    assembly.assemble(base)?;
    let mut robot = assembly.robot;
    if !URDF_JOINTS.admits(robot.bodies.len()) {
        let message = URDF_JOINTS.exceeded("the robot", robot.bodies.len());
        return Err(Wrong::whole(message, URDF_JOINTS.fix));
    }
    if robot.bodies.is_empty() {
        let message = format!("no joint moves between `{base}` and its end");
        return Err(Wrong::whole(
            message,
            "give `base` and `tip` with a revolute, continuous or prismatic joint between them",
        ));
    }
    let tip = match ends.tips.as_slice() {
        [] => tree.only_end(base),
        [tip] => Some(tip.as_str()),
        _ => None,
    };
    robot.tip = tip.and_then(|link| {
        let (body, placement) = assembly.places.get(link)?.clone();
        Some(Tip { link: link.to_owned(), body, placement })
    });
    Ok(robot)
}

fn empty(document: &Document, base: &str) -> Robot {
    Robot {
        name: document.name.clone(),
        base: base.to_owned(),
        bodies: Vec::new(),
        tip: None,
        held: Vec::new(),
    }
}

impl<'a> Tree<'a> {
    fn of(document: &'a Document) -> Result<Self, Wrong> {
        let links: BTreeMap<_, _> =
            document.links.iter().map(|link| (link.name.as_str(), link)).collect();
        let mut above: BTreeMap<&str, &Joint> = BTreeMap::new();
        let mut below: BTreeMap<&str, Vec<&Joint>> = BTreeMap::new();
        for joint in &document.joints {
            for link in [&joint.parent, &joint.child] {
                if !links.contains_key(link.as_str()) {
                    let message = format!("joint `{}` names the unknown link `{link}`", joint.name);
                    return Err(at(joint, message, "name a <link> of the file"));
                }
            }
            if let Some(other) = above.insert(&joint.child, joint) {
                let message = format!(
                    "link `{}` is moved by `{}` and by `{}`: a loop",
                    joint.child, other.name, joint.name
                );
                return Err(at(
                    joint,
                    message,
                    "URDF describes trees: leave out one of the joints, or cut the loop",
                ));
            }
            below.entry(&joint.parent).or_default().push(joint);
        }
        let roots: Vec<_> =
            links.keys().filter(|link| !above.contains_key(*link)).copied().collect();
        let root = match roots.as_slice() {
            [root] => root,
            [] => {
                return Err(match document.joints.first() {
                    Some(joint) => at(
                        joint,
                        "every link is moved by a joint: a loop",
                        "leave out a joint, so that one link is the root",
                    ),
                    None => {
                        Wrong::whole("there is no link", "give a URDF file with links and joints")
                    }
                });
            }
            several => {
                let names = several.join(", ");
                let message = format!("no joint connects the links {names}");
                return Err(Wrong::whole(
                    message,
                    "connect all links to one tree, for example by fixed joints",
                ));
            }
        };
        let tree = Self { links, above, below, root };
        tree.reaches_all()?;
        Ok(tree)
    }

    /// A loop hangs at no root.
    fn reaches_all(&self) -> Result<(), Wrong> {
        let mut reached = BTreeSet::from([self.root]);
        let mut open = vec![self.root];
        while let Some(link) = open.pop() {
            for joint in self.below.get(link).into_iter().flatten() {
                reached.insert(&joint.child);
                open.push(&joint.child);
            }
        }
        match self.above.iter().find(|(link, _)| !reached.contains(*link)) {
            Some((link, joint)) => {
                let message = format!("link `{link}` is in a loop of joints");
                Err(at(joint, message, "URDF describes trees: leave out a joint of the loop"))
            }
            None => Ok(()),
        }
    }

    fn link(&self, name: &str, key: &str) -> Result<&'a str, Wrong> {
        if let Some((name, _)) = self.links.get_key_value(name) {
            return Ok(name);
        }
        let help = match near_miss(name, self.links.keys().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!(
                "the links are {}",
                self.links.keys().copied().collect::<Vec<_>>().join(", ")
            ),
        };
        Err(Wrong::whole(format!("there is no link `{name}`, which `{key}` names"), help))
    }

    /// The names of the joints from a link to another one.
    fn way(&self, base: &str, tip: &str) -> Result<BTreeSet<&'a str>, Wrong> {
        let mut way = BTreeSet::new();
        let mut link = tip;
        while link != base {
            let Some(joint) = self.above.get(link) else {
                let message = format!("`{tip}` is not carried by `{base}`");
                return Err(Wrong::whole(
                    message,
                    "give as `base` a link between the root and `tip`",
                ));
            };
            way.insert(joint.name.as_str());
            link = &joint.parent;
        }
        Ok(way)
    }

    /// The end of the only chain of links that a link carries.
    fn only_end(&self, base: &'a str) -> Option<&'a str> {
        let mut link = base;
        loop {
            match self.below.get(link).map(Vec::as_slice) {
                None => return Some(link),
                Some([joint]) => link = &joint.child,
                Some(_) => return None,
            }
        }
    }
}

/// A robot while links are added to it.
struct Assembly<'a> {
    tree: &'a Tree<'a>,
    /// The joints that may move; all of them where there is none.
    way: Option<BTreeSet<&'a str>>,
    /// The body of each link, and the frame of the link in that of the body.
    places: BTreeMap<&'a str, (Option<usize>, Placement)>,
    robot: Robot,
}

impl<'a> Assembly<'a> {
    /// Adds the links that a base carries: a branch in full before the next one.
    fn assemble(&mut self, base: &'a str) -> Result<(), Wrong> {
        self.places.insert(base, (None, Placement::identity()));
        let carried = |link: &str| self.tree.below.get(link).into_iter().flatten().rev().copied();
        let mut open: Vec<&'a Joint> = carried(base).collect();
        while let Some(joint) = open.pop() {
            let moves = self.moves(joint)?;
            let (parent, place) = match self.places.get(joint.parent.as_str()) {
                Some((parent, place)) => (*parent, place.then(&joint.placement)),
                None => fault("a link before the one that carries it"),
            };
            let own = match moves {
                Some(motion) => self.add_body(joint, motion, (parent, place)),
                None => (parent, place),
            };
            let link = self.tree.links.get(joint.child.as_str());
            if let (Some(body), Some(link)) = (own.0, link) {
                self.robot.bodies[body].inertia.add(&link.inertia.placed(&own.1));
            }
            self.places.insert(&joint.child, own);
            open.extend(self.tree.below.get(joint.child.as_str()).into_iter().flatten().rev());
        }
        Ok(())
    }

    /// The motion of a joint; `None` where it is fixed, or held.
    fn moves(&mut self, joint: &Joint) -> Result<Option<Motion>, Wrong> {
        let motion = match joint.kind {
            Kind::Fixed => return Ok(None),
            Kind::Revolute => Motion::Revolute,
            Kind::Prismatic => Motion::Prismatic,
            kind @ (Kind::Floating | Kind::Planar) => {
                let kind = if kind == Kind::Floating { "floating" } else { "planar" };
                let message = format!("joint `{}` is {kind}, which is not supported", joint.name);
                return Err(at(
                    joint,
                    message,
                    "legal: revolute, continuous, prismatic and fixed; give as `base` a link behind it",
                ));
            }
        };
        if self.way.as_ref().is_some_and(|way| !way.contains(joint.name.as_str())) {
            self.robot.held.push(joint.name.clone());
            return Ok(None);
        }
        if let Some(other) = &joint.mimics {
            let message =
                format!("joint `{}` mimics `{other}`, which is not supported", joint.name);
            return Err(at(
                joint,
                message,
                "give as `tip` a link before it, and it is held at position 0, or leave <mimic> out",
            ));
        }
        Ok(Some(motion))
    }

    /// Adds a body whose z axis is that of its joint. Returns the place of the link that the joint moves.
    fn add_body(
        &mut self,
        joint: &Joint,
        motion: Motion,
        (parent, place): (Option<usize>, Placement),
    ) -> (Option<usize>, Placement) {
        let Some(rotation) = toward(&joint.axis) else { fault("a joint without an axis") };
        let back = turned(transposed(&rotation));
        self.robot.bodies.push(Body {
            joint: joint.name.clone(),
            effort: joint.effort.clone(),
            motion,
            parent,
            placement: place.then(&turned(rotation)),
            inertia: Inertia::none(),
            drive: joint.drive.clone(),
        });
        (Some(self.robot.bodies.len() - 1), back)
    }
}

fn at(joint: &Joint, message: impl Into<String>, help: &str) -> Wrong {
    Wrong { line: Some(joint.line), message: message.into(), help: help.to_owned() }
}
