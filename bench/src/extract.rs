//! The cheapest expression of an e-graph, a shared value counted once.
//!
//! Finding the best one is NP-hard. Two starts: the expression that was put in, and greedily the
//! set of nodes that computes each class most cheaply from its children's sets. Each is improved
//! by exchanging the node of one class at a time until no exchange helps.

use std::collections::{BTreeMap, BTreeSet};

use egg::{EGraph, Id, Language, RecExpr};

use crate::rewrites::{Early, Node};

/// The node that computes each class.
type Selection = BTreeMap<Id, Node>;

/// Nodes that compute a class, and what they cost together.
#[derive(Clone, Default)]
struct Choice {
    cycles: usize,
    nodes: Selection,
}

/// The cost and the expression found for `given`, which is in the graph.
pub(crate) fn extract(
    graph: &EGraph<Node, Early>,
    given: &RecExpr<Node>,
) -> Option<(usize, RecExpr<Node>)> {
    let best = greedy(graph);
    let mut own: Selection = BTreeMap::new();
    for (id, choice) in &best {
        own.insert(*id, choice.nodes.get(id)?.clone());
    }
    let mut ids: Vec<Id> = Vec::new();
    let mut as_given = own.clone();
    for node in given.as_ref() {
        let node = node.clone().map_children(|child| ids[usize::from(child)]);
        let id = graph.find(graph.lookup(node.clone())?);
        ids.push(id);
        // A leaf of the class, where there is one, is as good as anything.
        if !graph[id].data {
            as_given.insert(id, node);
        }
    }
    let root = *ids.last()?;
    let greedy = best.get(&root)?.nodes.clone();
    let from_greedy = own.into_iter().chain(greedy).collect();
    let starts = [as_given, from_greedy];
    let improved = starts.into_iter().filter_map(|start| improve(graph, start, root));
    let (cycles, selection) = improved.min_by_key(|(cycles, _)| *cycles)?;
    let mut expression = RecExpr::default();
    write(graph, &selection, root, &mut BTreeMap::new(), &mut expression)?;
    Some((cycles, expression))
}

/// Exchanges the node of one class at a time while that lowers the cost of `root`.
fn improve(
    graph: &EGraph<Node, Early>,
    mut selection: Selection,
    root: Id,
) -> Option<(usize, Selection)> {
    let (mut cycles, mut used) = cost(graph, &selection, root)?;
    loop {
        let mut improved = false;
        for id in used.clone() {
            for node in &graph[id].nodes {
                let before = selection.insert(id, node.clone());
                match cost(graph, &selection, root) {
                    Some((less, now)) if less < cycles => {
                        (cycles, used, improved) = (less, now, true);
                    }
                    _ => selection.extend(before.map(|before| (id, before))),
                }
            }
        }
        if !improved {
            return Some((cycles, selection));
        }
    }
}

/// Returns the cost of `root` and the classes it uses; `None` if the selection is circular.
fn cost(
    graph: &EGraph<Node, Early>,
    selection: &Selection,
    root: Id,
) -> Option<(usize, BTreeSet<Id>)> {
    let mut done = BTreeMap::new();
    write(graph, selection, root, &mut done, &mut RecExpr::default())?;
    let used: BTreeSet<Id> = done.into_keys().collect();
    let late = used.iter().filter(|id| !graph[**id].data).filter_map(|id| selection.get(id));
    Some((late.map(Node::cycles).sum(), used))
}

/// The cheapest set of nodes seen for each class, from its children's sets.
fn greedy(graph: &EGraph<Node, Early>) -> BTreeMap<Id, Choice> {
    let mut best: BTreeMap<Id, Choice> = BTreeMap::new();
    loop {
        let mut improved = false;
        for class in graph.classes() {
            for node in &class.nodes {
                let Some(choice) = choose(graph, &best, class.id, node) else { continue };
                if best.get(&class.id).is_none_or(|known| choice.cycles < known.cycles) {
                    best.insert(class.id, choice);
                    improved = true;
                }
            }
        }
        if !improved {
            return best;
        }
    }
}

/// `node` for `class` on its children's best sets; `None` if one is not known yet or needs
/// `class` itself.
fn choose(
    graph: &EGraph<Node, Early>,
    best: &BTreeMap<Id, Choice>,
    class: Id,
    node: &Node,
) -> Option<Choice> {
    let mut merged = Choice::default();
    for child in node.children() {
        let choice = best.get(&graph.find(*child))?;
        if merged.nodes.is_empty() {
            merged = choice.clone();
        } else {
            for (id, node) in &choice.nodes {
                merged.nodes.entry(*id).or_insert_with(|| node.clone());
            }
        }
    }
    if merged.nodes.insert(class, node.clone()).is_some() {
        return None;
    }
    let late = merged.nodes.iter().filter(|(id, _)| !graph[**id].data);
    merged.cycles = late.map(|(_, node)| node.cycles()).sum();
    Some(merged)
}

/// Appends the class and what it needs; `None` if the choices are circular.
fn write(
    graph: &EGraph<Node, Early>,
    selection: &Selection,
    class: Id,
    done: &mut BTreeMap<Id, Option<Id>>,
    expression: &mut RecExpr<Node>,
) -> Option<Id> {
    if let Some(id) = done.get(&class) {
        return *id;
    }
    done.insert(class, None);
    let mut node = selection.get(&class)?.clone();
    for child in node.children_mut() {
        *child = write(graph, selection, graph.find(*child), done, expression)?;
    }
    let id = expression.add(node);
    done.insert(class, Some(id));
    Some(id)
}
