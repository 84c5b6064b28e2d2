//! MATLAB: one function file for each function, for MATLAB, its Coder, Simulink, and GNU Octave.

use askama::Template;

use super::frame::Frame;
use super::print::{self, RootText, Syntax};
use super::{Controller, Declared, File, Language, Target, declared, header, text_of, tidy};
use crate::diagnostic::Diagnostics;
use crate::parameter::Precision;
use crate::program::{Input, Program};
use crate::request::{After, Guard, Spec, What};

pub(super) const TARGET: Target = Target {
    language: Language::Matlab,
    name: "matlab",
    about: "a function file for each function, MATLAB and GNU Octave",
    comment: ("% ", ""),
    is_word: |word| WORDS.split_whitespace().any(|one| one == word),
    refuse,
    files,
};

/// Keywords of MATLAB and Octave.
const WORDS: &str = "
    break case catch classdef continue do else elseif end end_try_catch end_unwind_protect
    endclassdef endenumeration endevents endfor endfunction endif endmethods endparfor
    endproperties endswitch endwhile enumeration events for function global if methods otherwise
    parfor persistent properties return spmd switch try until unwind_protect
    unwind_protect_cleanup while
";

/// Longest name that MATLAB tells from others.
const LONGEST: usize = 63;

fn refuse(spec: &Spec, _: Option<&Program>, found: &mut Diagnostics) {
    let name = spec.name();
    let longest = LONGEST - "_init".len();
    if name.len() > longest {
        found.push(
            "bad-value",
            "name",
            None,
            format!("{name}_init is longer than the {LONGEST} characters that MATLAB reads"),
            format!("give a name of at most {longest} characters"),
        );
    }
}

/// The files by the function that each holds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Init,
    Arm,
    Step,
    Rate,
    Tick,
    Axis,
}

fn files(controller: &Controller<'_>) -> Vec<File> {
    let spec = controller.spec();
    let syntax = Matlab::new(spec);
    let frame = Frame::new(controller, syntax.real, &syntax);
    let mut parts = vec![(Part::Init, "init"), (Part::Arm, "arm")];
    match spec.what {
        What::Controller => parts.push((Part::Step, "step")),
        What::Associated => parts.push((Part::Rate, "rate")),
    }
    if !frame.gains.is_empty() {
        parts.extend([(Part::Tick, "tick"), (Part::Axis, "axis")]);
    }
    let name = spec.name();
    let (head, parameters) =
        (header::lines(controller, Language::Matlab), declared(spec, Language::Matlab));
    let file = |(part, function): (Part, &str)| {
        let template =
            FunctionFile { part, name: &name, head: &head, parameters: &parameters, frame: &frame };
        let mut text = text_of(template.render());
        for helper in HELPERS {
            if text.contains(&format!("{}(", helper.name)) {
                text.push_str(helper.text);
            }
        }
        if text.contains("row_sums(") {
            text.push('\n');
            text.extend(frame.functions.iter().flat_map(|line| [line, "\n"]));
        }
        File { name: format!("{name}_{function}.m"), text: tidy(&text) }
    };
    parts.into_iter().map(file).collect()
}

/// A function that a file ends with where it is called.
struct Helper {
    name: &'static str,
    text: &'static str,
}

/// There is no conditional expression, and real functions leave the real numbers silently.
const HELPERS: [Helper; 5] = [
    Helper {
        name: "pick",
        text: "
function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
",
    },
    Helper {
        name: "real_sqrt",
        text: "
function r = real_sqrt(a)
if a >= 0
    r = sqrt(a);
else
    r = a * NaN;
end
end
",
    },
    Helper {
        name: "real_log",
        text: "
function r = real_log(a)
if a >= 0
    r = log(a);
else
    r = a * NaN;
end
end
",
    },
    Helper {
        name: "real_pow",
        text: "
function r = real_pow(a, b)
if a >= 0
    r = a ^ b;
else
    r = a * NaN;
end
end
",
    },
    Helper {
        name: "real_atanh",
        text: "
function r = real_atanh(a)
if abs(a) <= 1
    r = atanh(a);
else
    r = a * NaN;
end
end
",
    },
];

pub(super) struct Matlab<'a> {
    spec: &'a Spec,
    real: &'static str,
}

impl<'a> Matlab<'a> {
    pub(super) fn new(spec: &'a Spec) -> Self {
        let real = match spec.precision {
            Precision::F32 => "single",
            Precision::F64 => "double",
        };
        Self { spec, real }
    }
}

impl Syntax for Matlab<'_> {
    fn literal(&self, text: &str) -> String {
        match self.spec.precision {
            Precision::F32 => format!("single({})", print::through_double(text)),
            Precision::F64 => text.to_owned(),
        }
    }

    fn field(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn built(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn gains_field(&self, name: &str) -> String {
        format!("gains.{name}")
    }

    fn finite(&self, name: &str) -> String {
        format!("isfinite({name})")
    }

    fn kept(&self, product: &str, factor: &str) -> String {
        format!("kept({product}, {factor})")
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = match function {
            "sqrt" => "real_sqrt",
            "ln" => "real_log",
            "pow" => "real_pow",
            "atanh" => "real_atanh",
            function => function,
        };
        format!("{function}({})", arguments.join(", "))
    }

    fn abs(&self, a: &str) -> String {
        format!("abs({a})")
    }

    fn sign(&self, a: &str, zero: &str, one: &str) -> String {
        format!("pick({a} > {zero}, {one}, pick({a} < {zero}, -{one}, {a}))")
    }

    fn quotient(&self, a: &str, b: &str, zero: &str) -> String {
        format!("pick(({b} < {zero}) || ({b} > {zero}), {a} / {b}, {}(NaN))", self.real)
    }

    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("pick({condition}, {yes}, {no})")
    }

    fn after(&self) -> String {
        format!("{}(after(x, t))", self.real)
    }

    fn law(&self, xi: &[String], time: &str) -> (Vec<String>, String) {
        (Vec::new(), format!("{}(pi0([{}], {time}))", self.real, xi.join("; ")))
    }

    fn max(&self, a: &str, b: &str) -> String {
        format!("pick({a} < {b}, {b}, {a})")
    }

    fn define(&self, name: &str, expression: &str) -> String {
        format!("{name} = {expression};")
    }

    fn min(&self, a: &str, b: &str) -> String {
        format!("pick({a} < {b}, {a}, {b})")
    }

    fn input(&self, input: Input, name: &str) -> String {
        match input {
            Input::Gain(j) => format!("gains.gain({j})"),
            _ => name.to_owned(),
        }
    }

    fn rows_function(&self, weights: usize) -> Vec<String> {
        let tail = weights - 1;
        let lines = [
            "% Loops over the powers of the Taylor series of mu, for the gains of all states at once.",
            "function row = row_sums(row, p)",
            &format!("q = zeros(1, {}, '{}'); % p^2", tail - 1, self.real),
            &format!("for k = 1:{}", tail - 1),
            "    v = p(k) + p(k);",
            "    for m = 1:(k - 1)",
            "        v = v + (p(m) * p(k - m));",
            "    end",
            "    q(k) = v;",
            "end",
            &format!("for first = 1:2:{tail}"),
            &format!("    for k = first:{tail}"),
            "        v = row(k);",
            &format!("        for m = (k + 1):{weights}"),
            "            if k == first",
            "                v = v + (p(m - k) * row(m));",
            "            else",
            "                v = v + (q(m - k) * row(m));",
            "            end",
            "        end",
            "        row(k) = v;",
            "    end",
            "end",
            "end",
        ];
        lines.map(str::to_owned).to_vec()
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}({})", index + 1)
    }

    fn rows(&self, name: &str, tail: &[String], weights: &[String]) -> Vec<String> {
        let (tail, weights) = (tail.join(", "), weights.join(", "));
        vec![format!("{name} = row_sums([{weights}], [{tail}]);")]
    }

    fn root(&self, root: &RootText<'_>) -> Vec<String> {
        let y = root.unknown;
        let mut lines = vec![
            format!("{y} = {};", root.start),
            format!("{y}_low = {};", root.low),
            format!("{y}_high = {};", root.high),
            format!("for attempt = 1:{}", root.rounds),
        ];
        lines.extend(root.body.iter().map(|line| format!("    {line}")));
        lines.extend([
            format!("    {y}_next = {};", root.next),
            format!("    {y}_size = {};", root.size),
            format!("    if {} > {}", root.residual, root.zero),
            format!("        {y}_low = {y};"),
            "    else".to_owned(),
            format!("        {y}_high = {y};"),
            "    end".to_owned(),
            format!("    if ({y}_next >= {y}_low) && ({y}_next <= {y}_high)"),
            format!("        {y} = {y}_next;"),
            "    else".to_owned(),
            format!("        {y} = {} * ({y}_low + {y}_high);", root.half),
            "    end".to_owned(),
            format!("    if {y}_size <= {}", root.tolerance),
            "        break;".to_owned(),
            "    end".to_owned(),
            "end".to_owned(),
        ]);
        lines
    }
}

#[derive(Template)]
#[template(path = "controller.m.txt", escape = "none")]
struct FunctionFile<'a> {
    part: Part,
    name: &'a str,
    head: &'a [String],
    parameters: &'a [Declared],
    frame: &'a Frame,
}
