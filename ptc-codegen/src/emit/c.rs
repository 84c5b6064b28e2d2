//! C99: a header and a source file.

use askama::Template;

use super::acsl::{self, Contracts};
use super::apart::apart;
use super::frame::Frame;
use super::print::{RootText, Syntax};
use super::{Controller, Declared, File, Language, Target, declared, eva, header, text_of, tidy};
use crate::parameter::Precision;
use crate::program::Input;
use crate::request::{After, Feedback, Guard, Spec, What};

pub(super) const TARGET: Target = Target {
    language: Language::C,
    name: "c",
    about: "a header and a source file, C99",
    comment: ("/* ", " */"),
    is_word: |_| false,
    refuse: |_, _, _| {},
    files,
};

/// The header and the source of a controller.
pub(super) fn files(controller: &Controller<'_>) -> Vec<File> {
    sources(controller, false)
}

/// The same with contracts and case splits in comments, and the harness of the proof.
pub(super) fn files_with_proof(controller: &Controller<'_>) -> Vec<File> {
    sources(controller, true)
}

fn sources(controller: &Controller<'_>, annotated: bool) -> Vec<File> {
    let spec = controller.spec();
    let name = spec.name();
    let frame = Frame::new(controller, real(spec), &C { annotated, ..C::new(spec) });
    let head = header::lines(controller, Language::C);
    let contracts = match annotated {
        true => Contracts::new(controller, &frame),
        false => Contracts::default(),
    };
    let externs = externs(spec, &name);
    let hold = match spec.after {
        After::Hold => "PTC_HOLD",
        After::Zero | After::Extern => "(past >= 0.0) ? PTC_AFTER : PTC_HOLD",
    };
    let hold = hold.replace("0.0", &frame.zero);
    let header = Header {
        name: &name,
        head: &head,
        parameters: &declared(spec, Language::C),
        externs: &externs,
        contracts: &contracts,
        frame: &frame,
    };
    let mut lines = frame.step.iter().chain(&frame.functions);
    let loops = lines.any(|line| line.contains("uint32_t"));
    let pad = if spec.guard == Guard::Full { "        " } else { "    " };
    let abs = if spec.precision == Precision::F32 { "fabsf" } else { "fabs" };
    let source = Source { name: &name, loops, pad, hold, abs, externs: &externs, frame: &frame };
    let proof = annotated.then(|| eva::harness(controller, &frame, &externs));
    [(format!("{name}.h"), header.render()), (format!("{name}.c"), source.render())]
        .into_iter()
        .map(|(name, text)| File { name, text: tidy(&text_of(text)) })
        .chain(proof)
        .map(|file| apart(file, &name))
        .collect()
}

/// Type and name of what `step` takes beside time and state: the user's functions, and what is
/// handed on to them.
pub(super) fn externs(spec: &Spec, name: &str) -> Vec<(String, &'static str)> {
    let mut externs = Vec::new();
    if spec.feedback == Feedback::Extern {
        externs.push((format!("{name}_pi0 "), "pi0"));
    }
    if spec.after == After::Extern {
        externs.push((format!("{name}_after "), "after"));
    }
    if !externs.is_empty() {
        externs.push(("void *".to_owned(), "context"));
    }
    externs
}

/// The type of numbers.
pub(super) fn real(spec: &Spec) -> &'static str {
    match spec.precision {
        Precision::F32 => "float",
        Precision::F64 => "double",
    }
}

/// A number as C writes it.
pub(super) fn number(text: &str, precision: Precision) -> String {
    match precision {
        Precision::F32 => format!("{text}f"),
        Precision::F64 => text.to_owned(),
    }
}

pub(super) struct C<'a> {
    spec: &'a Spec,
    name: String,
    real: &'static str,
    /// Whether cases are split for Eva, in comments.
    annotated: bool,
}

impl<'a> C<'a> {
    pub(super) fn new(spec: &'a Spec) -> Self {
        Self { spec, name: spec.name(), real: real(spec), annotated: false }
    }
}

impl Syntax for C<'_> {
    fn literal(&self, text: &str) -> String {
        number(text, self.spec.precision)
    }

    fn field(&self, name: &str) -> String {
        format!("self->{name}")
    }

    fn built(&self, name: &str) -> String {
        format!("built.{name}")
    }

    fn gains_field(&self, name: &str) -> String {
        format!("gains->{name}")
    }

    fn finite(&self, name: &str) -> String {
        format!("isfinite({name})")
    }

    fn kept(&self, product: &str, factor: &str) -> String {
        format!("({}_kept({product}, {factor}) != 0)", self.spec.name())
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let suffix = if self.spec.precision == Precision::F32 { "f" } else { "" };
        let function = if function == "ln" { "log" } else { function };
        format!("{function}{suffix}({})", arguments.join(", "))
    }

    fn abs(&self, a: &str) -> String {
        self.call("fabs", &[a.to_owned()])
    }

    fn sign(&self, a: &str, zero: &str, one: &str) -> String {
        format!("({a} > {zero}) ? {one} : (({a} < {zero}) ? -{one} : {a})")
    }

    fn quotient(&self, a: &str, b: &str, zero: &str) -> String {
        // A quotient between ? and : is a breach of MISRA's rule 12.1 as cppcheck reads it.
        format!("{a} / ((({b} < {zero}) || ({b} > {zero})) ? {b} : ({})NAN)", self.real)
    }

    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("({condition}) ? {yes} : ({no})")
    }

    fn after(&self) -> String {
        "after(context, x, t)".to_owned()
    }

    fn law(&self, xi: &[String], time: &str) -> (Vec<String>, String) {
        // The infinite-time system is given xi as it is.
        let given = self.spec.what == What::Associated;
        let array = format!("const {} xi[{}] = {{{}}};", self.real, xi.len(), xi.join(", "));
        let array = (!given).then_some(array);
        (array.into_iter().collect(), format!("pi0(context, xi, {time})"))
    }

    fn max(&self, a: &str, b: &str) -> String {
        format!("({a} < {b}) ? {b} : {a}")
    }

    fn define(&self, name: &str, expression: &str) -> String {
        format!("const {} {name} = {expression};", self.real)
    }

    fn min(&self, a: &str, b: &str) -> String {
        format!("({a} < {b}) ? {a} : {b}")
    }

    fn input(&self, input: Input, name: &str) -> String {
        match input {
            // Behind a full guard the states are copies that have been checked.
            Input::State(j) if self.spec.guard != Guard::Full => format!("x[{}]", j - 1),
            Input::Gain(j) => format!("gains->gain[{}]", j - 1),
            _ => name.to_owned(),
        }
    }

    fn rows_function(&self, weights: usize) -> Vec<String> {
        let (name, real, tail) = (&self.name, self.real, weights - 1);
        let lines = [
            &format!("static void {name}_rows({real} row[{weights}], const {real} p[{tail}])"),
            "{",
            &format!("    {real} q[{}]; /* p^2 */", tail - 1),
            "",
            &format!("    for (uint32_t k = 0U; k < {}U; k++) {{", tail - 1),
            &format!("        {real} v = p[k] + p[k];"),
            "        for (uint32_t m = 0U; m < k; m++) {",
            "            v += p[m] * p[k - m - 1U];",
            "        }",
            "        q[k] = v;",
            "    }",
            &format!("    for (uint32_t round = 0U; round < {tail}U; round += 2U) {{"),
            &format!("        for (uint32_t k = round; k < {tail}U; k++) {{"),
            &format!("            const {real} *const f = (k == round) ? p : q;"),
            &format!("            {real} v = row[k];"),
            &format!("            for (uint32_t m = k + 1U; m < {weights}U; m++) {{"),
            "                v += f[m - k - 1U] * row[m];",
            "            }",
            "            row[k] = v;",
            "        }",
            "    }",
            "}",
        ];
        lines.map(str::to_owned).to_vec()
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{index}]")
    }

    fn rows(&self, name: &str, tail: &[String], weights: &[String]) -> Vec<String> {
        let array = |name: &str, values: &[String]| {
            format!("{} {name}[{}] = {{{}}};", self.real, values.len(), values.join(", "))
        };
        vec![
            array(name, weights),
            format!("const {}", array("p", tail)),
            format!("{}_rows({name}, p);", self.name),
        ]
    }

    fn root(&self, root: &RootText<'_>) -> Vec<String> {
        let (real, y) = (self.real, root.unknown);
        let mut lines = vec![
            format!("{real} {y} = {};", root.start),
            format!("{real} {y}_low = {};", root.low),
            format!("{real} {y}_high = {};", root.high),
            format!("for (uint32_t round = 0U; round < {}U; round++) {{", root.rounds),
        ];
        lines.extend(root.body.iter().map(|line| format!("    {line}")));
        lines.extend([
            format!("    const {real} {y}_next = {};", root.next),
            format!("    const {real} {y}_size = {};", root.size),
            format!("    if ({} > {}) {{", root.residual, root.zero),
            format!("        {y}_low = {y};"),
            "    } else {".to_owned(),
            format!("        {y}_high = {y};"),
            "    }".to_owned(),
            format!("    if (({y}_next >= {y}_low) && ({y}_next <= {y}_high)) {{"),
            format!("        {y} = {y}_next;"),
            "    } else {".to_owned(),
            format!("        {y} = {} * ({y}_low + {y}_high);", root.half),
            "    }".to_owned(),
            format!("    if ({y}_size <= {}) {{", root.tolerance),
            "        break;".to_owned(),
            "    }".to_owned(),
            "}".to_owned(),
        ]);
        if self.annotated {
            lines.extend(acsl::split_root(y, root.tolerance, real));
        }
        lines
    }
}

#[derive(Template)]
#[template(path = "controller.h.txt", escape = "none")]
struct Header<'a> {
    name: &'a str,
    head: &'a [String],
    parameters: &'a [Declared],
    /// Type and name of what `step` takes beside time and state.
    externs: &'a [(String, &'static str)],
    contracts: &'a Contracts,
    frame: &'a Frame,
}

#[derive(Template)]
#[template(path = "controller.c.txt", escape = "none")]
struct Source<'a> {
    name: &'a str,
    /// Whether it counts rounds.
    loops: bool,
    /// Indentation of the work in `tick`.
    pad: &'static str,
    /// Status where the gains are held or the deadline is over.
    hold: String,
    /// The absolute value of the precision.
    abs: &'static str,
    externs: &'a [(String, &'static str)],
    frame: &'a Frame,
}
