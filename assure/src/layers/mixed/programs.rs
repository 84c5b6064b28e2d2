//! Programs in C, C++, Rust and Python around a controller, with its calls written out.

use ptc_codegen::code::{Shape, Variable};
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::calls::Calls;
use super::words::Words;

impl Calls {
    /// The parameters as members, each behind what `before` makes of its name.
    fn members(&self, words: &Words, before: impl Fn(&str) -> String) -> String {
        let member = |parameter: &Variable| {
            let value = words.value(parameter.shape, &self.parameters[&parameter.name]);
            format!("{}{value}", before(&parameter.name))
        };
        self.code.parameters.iter().map(member).collect::<Vec<_>>().join(", ")
    }

    /// The state that is latched.
    fn state(&self) -> Option<&Variable> {
        self.code.start.as_ref()?.state.as_ref()
    }

    /// The program that prints a line for `init`, and one for each call.
    pub(super) fn program(&self, spec: &Spec, language: Language) -> String {
        let words = Words::of(language, spec.precision);
        match language {
            Language::C => self.in_c(spec, &words),
            Language::Cpp => self.in_cpp(spec, &words),
            Language::Rust => self.in_rust(spec, &words),
            _ => self.in_python(spec, &words),
        }
    }

    fn in_c(&self, spec: &Spec, words: &Words) -> String {
        let (name, real) = (spec.name(), words.real);
        let members = match self.code.parameters.is_empty() {
            true => ".none = 0".to_owned(),
            false => self.members(words, |name| format!(".{name} = ")),
        };
        let array = |variable: &Variable, values: &[f64]| {
            let length = match variable.shape {
                Shape::Lists(count, length) => format!("[{count}][{length}]"),
                shape => format!("[{}]", shape.length().unwrap_or(1)),
            };
            let value = words.value(variable.shape, values);
            format!("const {real} {}{length} = {value}; ", variable.name)
        };
        let state = self.state().map(|state| array(state, &self.parameters[&state.name]));
        let state_given = self.state().map(|state| format!(", {}", state.name));
        let count = self.code.axes();
        let (results, given) = match count {
            Some(m) => (format!("{real} u[{m}]; ptc_status axes[{m}]; "), "u, axes"),
            None => (format!("{real} u[1]; "), "&u[0]"),
        };
        let m = count.unwrap_or(1);
        let axes = match count {
            Some(m) => {
                format!("for (int i = 0; i < {m}; i++) {{ printf(\" %d\", (int)axes[i]); }} ")
            }
            None => String::new(),
        };
        let call = |arguments: &Vec<Vec<f64>>| {
            let step = &self.step().arguments;
            let pairs = || step.iter().zip(arguments);
            let is_array = |(argument, _): &(&Variable, _)| argument.shape.length().is_some();
            let arrays: String =
                pairs().filter(is_array).map(|(a, values)| array(a, values)).collect();
            let list = pairs().map(|pair| match is_array(&pair) {
                true => pair.0.name.clone(),
                false => words.value(pair.0.shape, pair.1),
            });
            let list = list.collect::<Vec<_>>().join(", ");
            format!(
                "    {{ {arrays}{results}printf(\"%d\", (int){name}_step(&c, {list}, {given})); \
                 for (int i = 0; i < {m}; i++) {{ show((double)u[i]); }} {axes}printf(\"\\n\"); }}\n"
            )
        };
        let calls: String = self.all.iter().map(call).collect();
        let (state, state_given) = (state.unwrap_or_default(), state_given.unwrap_or_default());
        format!(
            "#include \"{name}.h\"\n#include <inttypes.h>\n#include <math.h>\n#include <stdio.h>\n#include <string.h>\n\n\
             static void show(double u)\n{{\n    uint64_t bits;\n    memcpy(&bits, &u, sizeof bits);\n    printf(\" 0x%\" PRIx64, bits);\n}}\n\n\
             int main(void)\n{{\n    static {name} c;\n    const {name}_params p = {{ {members} }};\n    {state}\n    \
             const int status = (int){name}_init(&c, &p{state_given});\n    printf(\"%d\\n\", status);\n    \
             if (status < 0) {{ return 0; }}\n{calls}    return 0;\n}}\n"
        )
    }

    fn in_cpp(&self, spec: &Spec, words: &Words) -> String {
        let (name, kind, real) = (spec.name(), spec.type_name(), words.real);
        let kind_of = |shape: Shape| match shape {
            Shape::Lists(count, length) => {
                format!("std::array<std::array<{real}, {length}>, {count}>")
            }
            shape => format!("std::array<{real}, {}>", shape.length().unwrap_or(1)),
        };
        let given = |variable: &Variable, values: &[f64]| {
            let value = words.value(variable.shape, values);
            match variable.shape.length() {
                Some(_) => format!("{}{value}", kind_of(variable.shape)),
                None => value,
            }
        };
        let state = self.state().map(|state| given(state, &self.parameters[&state.name]));
        let state = state.map(|state| format!(", {state}")).unwrap_or_default();
        let show = match self.code.axes() {
            Some(_) => {
                "for (const auto u : found.u) { show(u); } for (const auto own : found.axes) { std::printf(\" %d\", static_cast<int>(own)); }"
            }
            None => "show(found.u);",
        };
        let call = |arguments: &Vec<Vec<f64>>| {
            let list = self.step().arguments.iter().zip(arguments);
            let list: Vec<_> = list.map(|(argument, values)| given(argument, values)).collect();
            format!(
                "    {{ const auto found = c.step({}); std::printf(\"%d\", static_cast<int>(found.status)); {show} std::printf(\"\\n\"); }}\n",
                list.join(", ")
            )
        };
        let calls: String = self.all.iter().map(call).collect();
        // In the order of the members, whose names C++17 cannot give.
        let members = self.members(words, |_| String::new());
        format!(
            "#include \"{name}.hpp\"\n#include <cinttypes>\n#include <cmath>\n#include <cstdio>\n#include <cstring>\n\n\
             [[maybe_unused]] static void show(double u)\n{{\n    std::uint64_t bits;\n    std::memcpy(&bits, &u, sizeof bits);\n    std::printf(\" 0x%\" PRIx64, bits);\n}}\n\n\
             int main()\n{{\n    ptc::{kind} c;\n    const ptc::{kind}::Params p{{{members}}};\n    \
             const int status = static_cast<int>(c.init(p{state}));\n    std::printf(\"%d\\n\", status);\n    \
             if (status < 0) {{ return 0; }}\n{calls}    return 0;\n}}\n"
        )
    }

    fn in_rust(&self, spec: &Spec, words: &Words) -> String {
        let (name, kind) = (spec.name(), spec.type_name());
        let given = |variable: &Variable, values: &[f64]| {
            let by = if variable.shape.length().is_some() { "&" } else { "" };
            format!("{by}{}", words.value(variable.shape, values))
        };
        let state = self.state().map(|state| given(state, &self.parameters[&state.name]));
        let state = state.map(|state| format!(", {state}")).unwrap_or_default();
        let show = match self.code.axes() {
            Some(_) => {
                "{ let found = FOUND; print!(\"{:?}\", found.status); found.u.iter().for_each(|u| show(f64::from(*u))); found.axes.iter().for_each(|status| print!(\" {status:?}\")); }"
            }
            None => {
                "match FOUND { Ok(found) => { print!(\"{:?}\", found.status); show(f64::from(found.u)); } Err(error) => { print!(\"{error:?}\"); show(0.0); } }"
            }
        };
        let call = |arguments: &Vec<Vec<f64>>| {
            let list = self.step().arguments.iter().zip(arguments);
            let list: Vec<_> = list.map(|(argument, values)| given(argument, values)).collect();
            let found = format!("c.step({})", list.join(", "));
            format!("    {}\n    println!();\n", show.replace("FOUND", &found))
        };
        let calls: String = self.all.iter().map(call).collect();
        let members = self.members(words, |name| format!("{name}: "));
        format!(
            "#![allow(dead_code, unused_mut)]\nmod {name};\nuse {name}::*;\n\n\
             fn show(u: f64) {{\n    print!(\" {{:#x}}\", u.to_bits());\n}}\n\n\
             fn main() {{\n    let mut c = match {kind}::new({kind}Params {{ {members} }}{state}) {{\n        Ok(c) => c,\n        Err(error) => return println!(\"{{error:?}}\"),\n    }};\n    println!(\"Ok\");\n{calls}}}\n"
        )
    }

    /// All calls of a law in t as one batch, those of a controller with memory one by one.
    fn in_python(&self, spec: &Spec, words: &Words) -> String {
        let (name, kind) = (spec.name(), spec.type_name());
        let (step, is_batch) = (self.step(), spec.sampled().is_none());
        let state =
            self.state().map(|state| words.value(state.shape, &self.parameters[&state.name]));
        let state = state.map(|state| format!(", {state}")).unwrap_or_default();
        let column = |(place, argument): (usize, &Variable)| {
            let of_call = |call: &Vec<Vec<f64>>| words.value(argument.shape, &call[place]);
            words.list(&self.all.iter().map(of_call).collect::<Vec<_>>())
        };
        let columns: Vec<_> = step.arguments.iter().enumerate().map(column).collect();
        let columns = columns.join(",\n    ");
        let calls = match is_batch {
            true => {
                "all = c.step(*given)\nfor index in range(len(given[0])):\n    show(all, index)\n"
            }
            false => "for call in zip(*given):\n    show(c.step(*call), ...)\n",
        };
        let axes =
            if self.code.axes().is_some() { "np.atleast_1d(found.axes[index])" } else { "[]" };
        let members = self.members(words, |name| format!("{name}="));
        format!(
            "import sys\nimport numpy as np\nimport {name} as module\n\nnan = float(\"nan\")\ninf = float(\"inf\")\n\n\
             def show(found, index):\n    u = np.atleast_1d(np.asarray(found.u)[index]).astype(np.float64)\n    \
             axes = {axes}\n    bits = [hex(one) for one in u.view(np.uint64)]\n    \
             print(int(np.asarray(found.status)[index]), *bits, *[int(one) for one in axes])\n\n\
             try:\n    c = module.{kind}(module.Params({members}){state})\nexcept ValueError:\n    print(-1)\n    sys.exit()\n\
             print(0)\ngiven = [\n    {columns},\n]\n{calls}"
        )
    }
}
