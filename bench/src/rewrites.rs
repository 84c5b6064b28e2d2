//! The operations in an e-graph, what they cost, and the equalities between them.

use egg::{Analysis, DidMerge, EGraph, Id, Rewrite, define_language, rewrite};
use ptc_codegen::program::cost::{Cost, X86_64};

define_language! {
    /// A value of a program; a leaf is `v<index>`, or 1 or -1.
    pub(crate) enum Node {
        "+" = Add([Id; 2]),
        "-" = Sub([Id; 2]),
        "*" = Mul([Id; 2]),
        "/" = Div([Id; 2]),
        "neg" = Neg(Id),
        "min" = Min([Id; 2]),
        One(i32),
        Leaf(egg::Symbol),
    }
}

impl Node {
    /// Cycles of the operation in the model of x86-64.
    pub(crate) fn cycles(&self) -> usize {
        let cost = match self {
            Self::Add(_) | Self::Sub(_) | Self::Neg(_) | Self::Min(_) => {
                Cost { add: 1, ..Cost::default() }
            }
            Self::Mul(_) => Cost { mul: 1, ..Cost::default() },
            Self::Div(_) => Cost { div: 1, ..Cost::default() },
            Self::One(_) | Self::Leaf(_) => Cost::default(),
        };
        cost.cycles(&X86_64)
    }
}

/// Marks the classes that are known before the time: all leaves except the time and the states, and nodes of these.
#[derive(Default)]
pub(crate) struct Early;

impl Analysis<Node> for Early {
    type Data = bool;

    fn make(graph: &mut EGraph<Node, Self>, node: &Node, _: Id) -> bool {
        match node {
            Node::Leaf(name) => !name.as_str().starts_with("late"),
            node => egg::Language::all(node, |child| graph[child].data),
        }
    }

    fn merge(&mut self, to: &mut bool, from: bool) -> DidMerge {
        egg::merge_max(to, from)
    }
}

/// Equalities of the real numbers.
pub(crate) fn rules() -> Vec<Rewrite<Node, Early>> {
    let mut rules = vec![
        rewrite!("add-commutes"; "(+ ?a ?b)" => "(+ ?b ?a)"),
        rewrite!("mul-commutes"; "(* ?a ?b)" => "(* ?b ?a)"),
        rewrite!("times-one"; "(* ?a 1)" => "?a"),
        rewrite!("times-minus-one"; "(* ?a -1)" => "(neg ?a)"),
        rewrite!("neg-neg"; "(neg (neg ?a))" => "?a"),
        rewrite!("twice"; "(+ ?a ?a)" => "(* ?a (+ 1 1))"),
    ];
    for both in [
        rewrite!("add-associates"; "(+ (+ ?a ?b) ?c)" <=> "(+ ?a (+ ?b ?c))"),
        rewrite!("mul-associates"; "(* (* ?a ?b) ?c)" <=> "(* ?a (* ?b ?c))"),
        rewrite!("distribute"; "(* ?a (+ ?b ?c))" <=> "(+ (* ?a ?b) (* ?a ?c))"),
        rewrite!("factor-one"; "(+ ?a (* ?a ?b))" <=> "(* ?a (+ 1 ?b))"),
        rewrite!("sub"; "(- ?a ?b)" <=> "(+ ?a (neg ?b))"),
        rewrite!("neg-add"; "(neg (+ ?a ?b))" <=> "(+ (neg ?a) (neg ?b))"),
        rewrite!("neg-mul"; "(neg (* ?a ?b))" <=> "(* (neg ?a) ?b)"),
        rewrite!("div"; "(/ ?a ?b)" <=> "(* ?a (/ 1 ?b))"),
        rewrite!("reciprocals"; "(* (/ 1 ?a) (/ 1 ?b))" <=> "(/ 1 (* ?a ?b))"),
        rewrite!("neg-div"; "(/ 1 (neg ?a))" <=> "(neg (/ 1 ?a))"),
    ] {
        rules.extend(both);
    }
    rules
}
