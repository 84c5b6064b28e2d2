//! Structured Text of IEC 61131-3: a function block for programmable controllers.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use askama::Template;

use super::frame::Frame;
use super::print::{self, RootText, Syntax};
use super::{Controller, Declared, File, Language, Target, declared, header, names, text_of, tidy};
use crate::diagnostic::Diagnostics;
use crate::expression::{Expression, Function, Subject};
use crate::parameter::{Parameter, Precision};
use crate::program::{Input, Op, Program};
use crate::request::{After, Feedback, Guard, Spec, What};

pub(super) const TARGET: Target = Target {
    language: Language::StructuredText,
    name: "st",
    about: "a function block in IEC 61131-3 Structured Text",
    comment: ("(* ", " *)"),
    is_word,
    refuse,
    files,
};

/// Keywords, types and standard functions, none of which tells capitals apart, and what the function
/// block calls its own.
const WORDS: &str = "
    abs acos action add and any array arm arrow asin at atan before begin bool by byte case char
    concat configuration constant continue cos date date_and_time delete dint div do dt dword else
    elsif end exit exp expt extends f_edge false fb find for from function function_block if
    implements init initial_step insert int interface internal interval ld ldate left legal len
    limit lint ln log lreal ltime lword max method mid min mod move mul mux namespace ne no not null
    of on or overlap override program public protected private r_edge read_only read_write ready
    real ref replace repeat resource retain return right rol ror sel shl shr sin sint sqrt start_time
    step string struct sub super tan task task then this time time_of_day to tod transition true
    trunc type udint uint ulint until usint using var var_access var_config var_external var_global
    var_in_out var_input var_output var_temp wchar while with word wstring xor
";

pub(super) fn is_word(word: &str) -> bool {
    let word = word.to_lowercase();
    WORDS.split_whitespace().any(|one| one == word)
}

fn refuse(spec: &Spec, program: Option<&Program>, found: &mut Diagnostics) {
    if spec.what == What::Associated {
        found.push(
            "unsupported",
            "what",
            None,
            "the infinite-time system is not emitted in st",
            "it is for simulation, not for a controller: emit it in another language",
        );
    }
    let mut seen = BTreeSet::new();
    for key in spec.run_time_parameters().map(Parameter::key).collect::<BTreeSet<_>>() {
        if !seen.insert(key.to_lowercase()) {
            found.push(
                "reserved-name",
                format!("params.{key}"),
                None,
                format!("{key} and another parameter differ in capitals alone, which st reads as one name"),
                format!("give it another name, for example {key}_1"),
            );
        }
    }
    for (key, name) in names(spec) {
        if name.contains("__") || name.ends_with('_') {
            found.push(
                "reserved-name",
                key,
                None,
                format!("{name} is no identifier in st"),
                "leave out underscores that end it or stand side by side",
            );
        }
    }
    let absent = [Function::Sinh, Function::Cosh, Function::Tanh, Function::Atanh];
    for function in absent {
        let calls = |op: &Op| matches!(op, Op::Call(called, _) if *called == function);
        if program.is_some_and(|p| p.values.iter().any(|value| calls(&value.op))) {
            let (name, key) = (function.name(), key_of(spec, function));
            found.push(
                "unsupported",
                key,
                None,
                format!("the controller calls {name}, which st does not have"),
                "write the mapping or the law with exp or ln, or emit it in another language",
            );
        }
    }
}

/// Refuses a name that a variable of the function block has too.
pub(super) fn names_itself(spec: &Spec, files: &[File], found: &mut Diagnostics) {
    let name = spec.name();
    if files.iter().any(|file| occurrences(&file.text, &name) > 1) {
        found.push(
            "reserved-name",
            "name",
            None,
            format!("the function block has a variable {name}, which st reads as its own name"),
            format!("give it another name, for example {name}_1"),
        );
    }
}

/// How often code outside of comments has `name`, in capitals or not.
fn occurrences(text: &str, name: &str) -> usize {
    let code = text.split("(*").map(|part| part.split_once("*)").map_or(part, |(_, code)| code));
    let words = |code: &str| {
        let words = code.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
        words.filter(|word| word.eq_ignore_ascii_case(name)).count()
    };
    code.map(words).sum()
}

/// The key whose expression calls `function`; that of the mapping where it comes from its inverse.
fn key_of(spec: &Spec, function: Function) -> &'static str {
    let calls = |e: &Expression| e.any(&|e| matches!(e, Expression::Call(f, _) if *f == function));
    match (&spec.feedback, &spec.input_gain, spec.custom()) {
        (Feedback::Expression(law), ..) if calls(law) => "pi0",
        (_, Some(gain), _) if calls(gain) => "g",
        (.., Some(custom)) if custom.subject == Subject::Kappa => "kappa",
        _ => "mu",
    }
}

fn files(controller: &Controller<'_>) -> Vec<File> {
    let spec = controller.spec();
    let name = spec.name();
    let syntax = StructuredText::new(spec);
    let real = syntax.real;
    let frame = Frame::new(controller, real, &syntax);
    for local in frame
        .locals
        .iter()
        .map(|local| local.name.clone())
        .chain((1..=spec.n).map(|j| format!("x{j}")).chain(["t0".to_owned(), "v".to_owned()]))
    {
        syntax.declare(&local, Kind::Real);
    }
    for j in &frame.latched_states {
        syntax.declare(&format!("x{j}_0"), Kind::Real);
    }
    let comment = |line: &String| line.replace("(*", "( *").replace("*)", "* )");
    let divides = controller.program.values.iter().any(|v| matches!(v.op, Op::Quotient(..)));
    let block = Block {
        name: &name,
        head: &header::lines(controller, Language::StructuredText)
            .iter()
            .map(comment)
            .collect::<Vec<_>>(),
        parameters: &declared(spec, Language::StructuredText),
        variables: &syntax
            .declared
            .take()
            .into_iter()
            .map(|(name, kind)| Variable { name, kind: kind.text(real) })
            .collect::<Vec<_>>(),
        greatest: greatest(spec.precision),
        huge: syntax.literal(if spec.precision == Precision::F32 { "1e38" } else { "1e308" }),
        divides,
        frame: &frame,
    };
    let text = tidy(&text_of(block.render()));
    vec![File { name: format!("{name}.st"), text }]
}

/// What a temporary variable holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Real,
    Array(usize),
    Counter,
}

impl Kind {
    fn text(self, real: &str) -> String {
        match self {
            Self::Real => real.to_owned(),
            Self::Array(length) => format!("ARRAY[1..{length}] OF {real}"),
            Self::Counter => "DINT".to_owned(),
        }
    }
}

struct Variable {
    name: String,
    kind: String,
}

/// A literal with its type, for controllers differ in the one that a bare number has.
pub(super) fn literal(text: &str, precision: Precision) -> String {
    let (real, text) = match precision {
        Precision::F32 => ("REAL", print::through_double(text)),
        Precision::F64 => ("LREAL", text.to_owned()),
    };
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, ""));
    let point = if digits.contains('.') { "" } else { ".0" };
    let sign = if exponent.starts_with('-') { "" } else { "+" };
    match exponent {
        "" => format!("{real}#{digits}{point}"),
        _ => format!("{real}#{digits}{point}E{sign}{exponent}"),
    }
}

/// The greatest finite number.
pub(super) fn greatest(precision: Precision) -> String {
    let digits = match precision {
        Precision::F32 => "3.4028235e38",
        Precision::F64 => "1.7976931348623157e308",
    };
    literal(digits, precision)
}

pub(super) struct StructuredText<'a> {
    spec: &'a Spec,
    name: String,
    real: &'static str,
    /// Each variable that a statement sets has to be declared before all statements.
    declared: RefCell<BTreeMap<String, Kind>>,
}

impl<'a> StructuredText<'a> {
    pub(super) fn new(spec: &'a Spec) -> Self {
        let real = match spec.precision {
            Precision::F32 => "REAL",
            Precision::F64 => "LREAL",
        };
        Self { spec, name: spec.name(), real, declared: RefCell::default() }
    }

    fn declare(&self, name: &str, kind: Kind) {
        self.declared.borrow_mut().insert(name.to_owned(), kind);
    }

    fn array(&self, name: &str, values: &[String]) -> Vec<String> {
        self.declare(name, Kind::Array(values.len()));
        let numbered = values.iter().enumerate();
        numbered.map(|(index, value)| format!("{name}[{}] := {value};", index + 1)).collect()
    }
}

impl Syntax for StructuredText<'_> {
    /// Capitals and small letters are one, and `K1` stands beside `k1`.
    fn name(&self, name: &str) -> String {
        let letter = |c: char| match c.is_ascii_uppercase() {
            true => format!("cap_{}", c.to_ascii_lowercase()),
            false => c.to_string(),
        };
        name.chars().map(letter).collect()
    }

    fn literal(&self, text: &str) -> String {
        literal(text, self.spec.precision)
    }

    fn field(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn built(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn gains_field(&self, name: &str) -> String {
        name.to_owned()
    }

    fn finite(&self, name: &str) -> String {
        format!("(ABS({name}) <= {})", greatest(self.spec.precision))
    }

    fn kept(&self, product: &str, factor: &str) -> String {
        format!("{}_kept(product := {product}, factor := {factor})", self.name)
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = if function == "pow" { "EXPT".to_owned() } else { function.to_uppercase() };
        format!("{function}({})", arguments.join(", "))
    }

    fn abs(&self, a: &str) -> String {
        format!("ABS({a})")
    }

    fn sign(&self, a: &str, zero: &str, one: &str) -> String {
        format!("SEL({a} > {zero}, SEL({a} < {zero}, {a}, -{one}), {one})")
    }

    fn quotient(&self, a: &str, b: &str, _zero: &str) -> String {
        format!("{}_quotient({a}, {b})", self.name)
    }

    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("SEL({condition}, {no}, {yes})")
    }

    fn after(&self) -> String {
        format!("{}_after(x, t)", self.name)
    }

    fn law(&self, xi: &[String], time: &str) -> (Vec<String>, String) {
        (self.array("xi", xi), format!("{}_pi0(xi, {time})", self.name))
    }

    fn max(&self, a: &str, b: &str) -> String {
        format!("SEL({a} < {b}, {a}, {b})")
    }

    fn define(&self, name: &str, expression: &str) -> String {
        self.declare(name, Kind::Real);
        format!("{name} := {expression};")
    }

    fn min(&self, a: &str, b: &str) -> String {
        format!("SEL({a} < {b}, {b}, {a})")
    }

    fn input(&self, _input: Input, name: &str) -> String {
        name.to_owned()
    }

    /// A function gives no array, so the loops stand where they are needed.
    fn rows_function(&self, _weights: usize) -> Vec<String> {
        Vec::new()
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{}]", index + 1)
    }

    fn rows(&self, name: &str, tail: &[String], weights: &[String]) -> Vec<String> {
        for counter in ["row_k", "row_m", "row_first"] {
            self.declare(counter, Kind::Counter);
        }
        self.declare("row_v", Kind::Real);
        self.declare("q", Kind::Array(tail.len() - 1));
        let mut lines = self.array("p", tail);
        lines.extend(self.array(name, weights));
        let (tail, weights) = (tail.len(), weights.len());
        lines.extend([
            format!("FOR row_k := 1 TO {} DO", tail - 1),
            "    row_v := p[row_k] + p[row_k];".to_owned(),
            "    FOR row_m := 1 TO row_k - 1 DO".to_owned(),
            "        row_v := row_v + (p[row_m] * p[row_k - row_m]);".to_owned(),
            "    END_FOR;".to_owned(),
            "    q[row_k] := row_v;".to_owned(),
            "END_FOR;".to_owned(),
            format!("FOR row_first := 1 TO {tail} BY 2 DO"),
            format!("    FOR row_k := row_first TO {tail} DO"),
            format!("        row_v := {name}[row_k];"),
            format!("        FOR row_m := row_k + 1 TO {weights} DO"),
            "            IF row_k = row_first THEN".to_owned(),
            format!("                row_v := row_v + (p[row_m - row_k] * {name}[row_m]);"),
            "            ELSE".to_owned(),
            format!("                row_v := row_v + (q[row_m - row_k] * {name}[row_m]);"),
            "            END_IF;".to_owned(),
            "        END_FOR;".to_owned(),
            format!("        {name}[row_k] := row_v;"),
            "    END_FOR;".to_owned(),
            "END_FOR;".to_owned(),
        ]);
        lines
    }

    fn root(&self, root: &RootText<'_>) -> Vec<String> {
        let y = root.unknown;
        for suffix in ["", "_low", "_high", "_next", "_size"] {
            self.declare(&format!("{y}{suffix}"), Kind::Real);
        }
        self.declare("attempt", Kind::Counter);
        let mut lines = vec![
            format!("{y} := {};", root.start),
            format!("{y}_low := {};", root.low),
            format!("{y}_high := {};", root.high),
            format!("FOR attempt := 1 TO {} DO", root.rounds),
        ];
        lines.extend(root.body.iter().map(|line| format!("    {line}")));
        lines.extend([
            format!("    {y}_next := {};", root.next),
            format!("    {y}_size := {};", root.size),
            format!("    IF {} > {} THEN", root.residual, root.zero),
            format!("        {y}_low := {y};"),
            "    ELSE".to_owned(),
            format!("        {y}_high := {y};"),
            "    END_IF;".to_owned(),
            format!("    IF ({y}_next >= {y}_low) AND ({y}_next <= {y}_high) THEN"),
            format!("        {y} := {y}_next;"),
            "    ELSE".to_owned(),
            format!("        {y} := {} * ({y}_low + {y}_high);", root.half),
            "    END_IF;".to_owned(),
            format!("    IF {y}_size <= {} THEN", root.tolerance),
            "        EXIT;".to_owned(),
            "    END_IF;".to_owned(),
            "END_FOR;".to_owned(),
        ]);
        lines
    }
}

#[derive(Template)]
#[template(path = "controller.st.txt", escape = "none")]
struct Block<'a> {
    name: &'a str,
    head: &'a [String],
    parameters: &'a [Declared],
    variables: &'a [Variable],
    /// The greatest finite number.
    greatest: String,
    /// A number whose square overflows.
    huge: String,
    /// Whether it divides by what may be 0.
    divides: bool,
    frame: &'a Frame,
}
