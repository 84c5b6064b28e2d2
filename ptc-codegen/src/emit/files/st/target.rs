//! Structured Text of IEC 61131-3: a function block for programmable controllers.

use std::collections::BTreeSet;

use super::super::literal::through_double;
use super::super::{File, Language, Print, Target, names, refuse_fma};
use crate::diagnostic::Diagnostics;
use crate::expression::{Expression, Function, Node, Subject};
use crate::parameter::{Parameter, Precision};
use crate::program::{Op, Program};
use crate::request::{Feedback, Spec, What};

pub(in crate::emit) const TARGET: Target = Target {
    language: Language::StructuredText,
    name: "st",
    about: "a function block in IEC 61131-3 Structured Text",
    comment: ("(* ", " *)"),
    is_word,
    refuse,
    print: Print::Program(|program| vec![super::file(program)]),
};

/// Keywords, types and standard functions, all case-insensitive, and what the function
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

pub(in crate::emit) fn is_word(word: &str) -> bool {
    let word = word.to_lowercase();
    WORDS.split_whitespace().any(|one| one == word)
}

fn refuse(spec: &Spec, program: Option<&Program>, found: &mut Diagnostics) {
    refuse_fma(spec, "Structured Text", found);
    if spec.what == What::Associated {
        found.push(
            "unsupported",
            "what",
            None,
            "the infinite-time system is not emitted in st",
            "it is for simulation, not for a controller: emit it in another language",
        );
    }
    let several = spec.axes.as_ref().is_some_and(|axes| axes.count > 1);
    if several && spec.feedback == Feedback::Extern {
        found.push(
            "unsupported",
            "pi0",
            None,
            "a user-defined law of several inputs returns an array, which no function in st can",
            "write the law in the design, or emit it in another language",
        );
    }
    let mut seen = BTreeSet::new();
    for key in crate::collect::set(spec.run_time_parameters().map(Parameter::key)) {
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
                format!("{name} is not an identifier in st"),
                "leave out underscores that end it or stand side by side",
            );
        }
    }
    let all = Function::ALL.into_iter().map(|(_, function)| function);
    for function in all.filter(|function| !function.words().structured_text) {
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
pub(in crate::emit) fn names_itself(spec: &Spec, file: &File, found: &mut Diagnostics) {
    let name = spec.name();
    if occurrences(&file.text, &name) > 1 {
        found.push(
            "reserved-name",
            "name",
            None,
            format!("the function block has a variable {name}, which st reads as its own name"),
            format!("give it another name, for example {name}_1"),
        );
    }
}

/// Counts the occurrences of `name` in code outside of comments, ignoring case.
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
    let calls = |e: &Expression| e.any(&|e| matches!(e.node(), Node::Call(f, _) if *f == function));
    match (&spec.feedback, &spec.input_gain, spec.custom()) {
        (Feedback::Expression(law), ..) if calls(law) => "pi0",
        (_, Some(gain), _) if calls(gain) => "g",
        _ if spec.drift.as_ref().is_some_and(calls) => "f",
        _ if (0..=spec.n).filter_map(|i| spec.derivative(i)).any(calls) => "reference",
        (.., Some(custom)) if custom.subject == Subject::Kappa => "kappa",
        _ => "mu",
    }
}

/// A literal with its type, for controllers differ in the one that a bare number has.
pub(in crate::emit) fn literal(text: &str, precision: Precision) -> String {
    let (real, text) = match precision {
        Precision::F32 => ("REAL", through_double(text)),
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

/// The digits of the greatest finite number.
pub(in crate::emit) fn greatest(precision: Precision) -> &'static str {
    match precision {
        Precision::F32 => "3.4028235e38",
        Precision::F64 => "1.7976931348623157e308",
    }
}

/// Returns true if a REAL holds a number as large or as small as `digits`.
pub(in crate::emit) fn is_narrow(digits: &str) -> bool {
    let value: f64 = digits.parse().unwrap_or(f64::NAN);
    value == 0.0 || (NARROW[0]..=NARROW[1]).contains(&value)
}

/// Bounds of the numbers that are written as one literal, within the normal numbers of a REAL.
const NARROW: [f64; 2] = [1e-37, 3e38];

/// Literals that a REAL can hold and whose product, from left to right, is exactly an LREAL.
pub(in crate::emit) fn factors(digits: &str) -> Vec<String> {
    let [small, large] = [-120, 120].map(|exponent| 2f64.powi(exponent));
    let mut first: f64 = digits.parse().unwrap_or(f64::NAN);
    let mut factors = Vec::new();
    while first > NARROW[1] {
        first *= small;
        factors.push(large);
    }
    while first < NARROW[0] {
        first *= large;
        factors.push(small);
    }
    let text = |factor: f64| literal(&format!("{factor:e}"), Precision::F64);
    let mut texts: Vec<_> = factors.into_iter().map(text).collect();
    // Rounded to a REAL, the first factor of the greatest number is 2^64, and the product overflows.
    let power = 2f64.powi(64);
    let first = match first < power && first as f32 == power as f32 {
        true => format!("({} - {})", text(power), text(power - first)),
        false => text(first),
    };
    texts.insert(0, first);
    texts
}
