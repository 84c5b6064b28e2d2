//! Python: one typed module on NumPy, each call of which takes a batch of times and states.

use askama::Template;

use super::frame::Frame;
use super::print::{self, RootText, Syntax};
use super::{
    Controller, Declared, File, Language, Target, declared, header, refuse_class, text_of, tidy,
};
use crate::parameter::{Precision, type_name};
use crate::program::Input;
use crate::request::{After, Guard, Spec};

pub(super) const TARGET: Target = Target {
    language: Language::Python,
    name: "python",
    about: "one typed module on NumPy, for batches of times and states",
    comment: ("# ", ""),
    is_word: |word| {
        WORDS.split_whitespace().any(|one| one == word)
            || CLASSES.split_whitespace().any(|one| one == type_name(word))
    },
    refuse: |spec, _, found| refuse_class(spec, &[], found),
    files,
};

/// Keywords, modules that one of this name would hide, and names whose class the module has already.
const WORDS: &str = "
    False None True and as assert async await break class continue def del elif else except finally
    for from global if import in is lambda nonlocal not or pass raise return try while with yield
    any array array_like callable int_enum named_tuple sequence cmath collections dataclasses enum math np numpy typing
";

/// The module's own classes and those that it imports: one of a controller would hide them.
const CLASSES: &str = "
    Array ArrayLike Callable Control Gains IntEnum NDArray NamedTuple None Params Rate Sequence Status
";

fn files(controller: &Controller<'_>) -> Vec<File> {
    let spec = controller.spec();
    let frame = Frame::new(controller, real(spec), &Python::new(spec));
    // In a text of the module a backslash would begin an escape.
    let head: Vec<_> = header::lines(controller, Language::Python)
        .into_iter()
        .map(|line| line.replace('\\', "\\\\"))
        .collect();
    let (type_name, parameters) = (spec.type_name(), declared(spec, Language::Python));
    let mut public = vec!["Control", "Params", "Status", &type_name];
    public.extend((!frame.gains.is_empty()).then_some("Gains"));
    public.extend(frame.associated.then_some("Rate"));
    public.sort_unstable();
    let calls = frame.extern_law || frame.after == After::Extern;
    let arrays = parameters.iter().any(|parameter| parameter.length.is_some());
    let sequences = arrays || !frame.functions.is_empty();
    let imported = calls.then_some("Callable").into_iter().chain(sequences.then_some("Sequence"));
    let module = Module {
        type_name: &type_name,
        public: &public,
        imported: imported.collect(),
        head: &head,
        parameters: &parameters,
        frame: &frame,
    };
    let text = tidy(&text_of(module.render()));
    vec![File { name: format!("{}.py", spec.name()), text }]
}

fn real(spec: &Spec) -> &'static str {
    match spec.precision {
        Precision::F32 => "float32",
        Precision::F64 => "float64",
    }
}

pub(super) struct Python<'a> {
    spec: &'a Spec,
}

impl<'a> Python<'a> {
    pub(super) fn new(spec: &'a Spec) -> Self {
        Self { spec }
    }
}

impl Syntax for Python<'_> {
    /// A Python float beside a NumPy scalar of single precision would make a double of it before
    /// NumPy 2.
    fn literal(&self, text: &str) -> String {
        match self.spec.precision {
            Precision::F32 => format!("_R({})", print::through_double(text)),
            Precision::F64 => text.to_owned(),
        }
    }

    fn field(&self, name: &str) -> String {
        format!("self._{name}")
    }

    fn built(&self, name: &str) -> String {
        format!("self._{name}")
    }

    fn gains_field(&self, name: &str) -> String {
        format!("self.{name}")
    }

    fn finite(&self, name: &str) -> String {
        format!("np.isfinite({name})")
    }

    fn kept(&self, product: &str, factor: &str) -> String {
        format!("_kept({product}, {factor})")
    }

    fn call(&self, function: &str, arguments: &[String]) -> String {
        let function = match function {
            "ln" => "log",
            "pow" => "power",
            "atan" => "arctan",
            "atanh" => "arctanh",
            function => function,
        };
        format!("np.{function}({})", arguments.join(", "))
    }

    fn abs(&self, a: &str) -> String {
        format!("np.abs({a})")
    }

    fn sign(&self, a: &str, zero: &str, one: &str) -> String {
        format!("np.where({a} > {zero}, {one}, np.where({a} < {zero}, -{one}, {a}))")
    }

    fn quotient(&self, a: &str, b: &str, zero: &str) -> String {
        format!("np.where(({b} < {zero}) | ({b} > {zero}), {a} / {b}, _R(np.nan))")
    }

    fn select(&self, condition: &str, yes: &str, no: &str) -> String {
        format!("np.where({condition}, {yes}, {no})")
    }

    fn after(&self) -> String {
        "np.asarray(after(np.asarray(x, dtype=_R), t), dtype=_R)".to_owned()
    }

    fn law(&self, xi: &[String], time: &str) -> (Vec<String>, String) {
        let states = format!("xi = np.stack(np.broadcast_arrays({}), axis=-1)", xi.join(", "));
        (vec![states], format!("np.asarray(pi0(xi, np.asarray({time})), dtype=_R)"))
    }

    fn max(&self, a: &str, b: &str) -> String {
        format!("np.where({a} < {b}, {b}, {a})")
    }

    fn define(&self, name: &str, expression: &str) -> String {
        format!("{name} = {expression}")
    }

    fn min(&self, a: &str, b: &str) -> String {
        format!("np.where({a} < {b}, {a}, {b})")
    }

    fn input(&self, input: Input, name: &str) -> String {
        match input {
            Input::Gain(j) => format!("self.gain[..., {}]", j - 1),
            _ => name.to_owned(),
        }
    }

    fn rows_function(&self, weights: usize) -> Vec<String> {
        let tail = weights - 1;
        let lines = [
            "def _rows(weights: Sequence[ArrayLike], tail: list[Array]) -> list[Array]:",
            "    \"\"\"Loops over the powers of the Taylor series of mu, for the gains of all states.\"\"\"",
            "    row = [np.asarray(weight, dtype=_R) for weight in weights]",
            "    p = tail",
            "    q: list[Array] = []  # p^2",
            &format!("    for k in range({}):", tail - 1),
            "        v = p[k] + p[k]",
            "        for m in range(k):",
            "            v = v + p[m] * p[k - m - 1]",
            "        q.append(v)",
            &format!("    for first in range(0, {tail}, 2):"),
            &format!("        for k in range(first, {tail}):"),
            "            power = p if k == first else q",
            "            v = row[k]",
            &format!("            for m in range(k + 1, {weights}):"),
            "                v = v + power[m - k - 1] * row[m]",
            "            row[k] = v",
            "    return row",
        ];
        lines.map(str::to_owned).to_vec()
    }

    fn element(&self, array: &str, index: usize) -> String {
        format!("{array}[{index}]")
    }

    fn rows(&self, name: &str, tail: &[String], weights: &[String]) -> Vec<String> {
        let (tail, weights) = (tail.join(", "), weights.join(", "));
        vec![format!("{name} = _rows([{weights}], [{tail}])")]
    }

    /// Each element of the batch stays as it is from its own last round on.
    fn root(&self, root: &RootText<'_>) -> Vec<String> {
        let y = root.unknown;
        let mut lines = vec![
            format!("{y} = np.asarray({})", root.start),
            format!("{y}_low = np.asarray({})", root.low),
            format!("{y}_high = np.asarray({})", root.high),
            "done = np.asarray(False)".to_owned(),
            format!("for _ in range({}):", root.rounds),
        ];
        lines.extend(root.body.iter().map(|line| format!("    {line}")));
        lines.extend([
            format!("    {y}_next = {}", root.next),
            format!("    {y}_size = {}", root.size),
            format!("    right = {} > {}", root.residual, root.zero),
            format!("    {y}_low = np.where(right, {y}, {y}_low)"),
            format!("    {y}_high = np.where(right, {y}_high, {y})"),
            format!("    inside = ({y}_next >= {y}_low) & ({y}_next <= {y}_high)"),
            format!(
                "    {y}_next = np.where(inside, {y}_next, {} * ({y}_low + {y}_high))",
                root.half
            ),
            format!("    {y} = np.where(done, {y}, {y}_next)"),
            format!("    done = done | ({y}_size <= {})", root.tolerance),
            "    if done.all():".to_owned(),
            "        break".to_owned(),
        ]);
        lines
    }
}

#[derive(Template)]
#[template(path = "controller.py.txt", escape = "none")]
struct Module<'a> {
    type_name: &'a str,
    /// The names that the module offers.
    public: &'a [&'a str],
    /// What it takes from `collections.abc`.
    imported: Vec<&'static str>,
    head: &'a [String],
    parameters: &'a [Declared],
    frame: &'a Frame,
}
