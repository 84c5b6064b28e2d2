//! Directives around a header: it is read once, and no macro may stand for one of its names.

use crate::code::Code;
use crate::request::hash;

/// A header that is read once. The guard has a hash of the content: a header of the same name with
/// other content is read too, and its declarations collide, where it would else be left out.
pub(in crate::emit) fn once(code: &Code, head: &str, content: &str, kind: &str) -> String {
    let number = hash([head, content]) >> 96;
    let guard = format!("{}_{number:08X}_{kind}", code.name.to_uppercase());
    let checks = macros(code);
    format!("{head}#ifndef {guard}\n#define {guard}\n\n{checks}{content}\n#endif\n")
}

/// Directives that refuse macros in place of parameters. By convention macros are in capitals.
fn macros(code: &Code) -> String {
    let capitals = |name: &&str| !name.contains(|c: char| c.is_ascii_lowercase());
    let names = code.parameters.iter().map(|parameter| parameter.name.as_str()).filter(capitals);
    let check = |name: &str| {
        format!(
            "#ifdef {name}\n#error \"a macro {name} takes the place of the parameter {name}: include this header before the one that defines it, or rename the parameter\"\n#endif\n\n"
        )
    };
    names.map(check).collect()
}
