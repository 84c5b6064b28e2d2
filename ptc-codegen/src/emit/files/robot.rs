//! The files of the functions of a robot.

use super::super::code::short;
use super::File;
use super::head::lines_of_robot;
use super::language::{Language, Print};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::robot::{Request, code};
use crate::urdf::Robot;

/// The languages in which the functions of a robot are printed.
const ROBOT_LANGUAGES: [Language; 4] =
    [Language::C, Language::Cpp, Language::Rust, Language::Python];

/// The source files of the functions of a robot in `language`.
///
/// # Errors
/// A language in which they are not printed, a feature that it cannot express, and a name that is one of its words.
pub fn emit_robot(
    request: &Request,
    robot: &Robot,
    language: Language,
) -> Result<Vec<File>, Vec<Diagnostic>> {
    let mut found = Diagnostics::default();
    let target = language.target();
    let print = match &target.print {
        Print::Program(print) if ROBOT_LANGUAGES.contains(&language) => *print,
        _ => {
            let names = ROBOT_LANGUAGES.map(Language::name).join(", ");
            let message = format!("the functions of a robot are not printed in {}", target.name);
            found.push("unsupported", "what", None, message, format!("emit one of {names}"));
            return found.finish(None);
        }
    };
    if request.fma && language == Language::Python {
        let help = "leave `fma` out, or emit c, cpp or rust";
        found.push("unsupported", "fma", None, "python has no fused multiply-add", help);
    }
    let name = request.name(robot);
    if (target.is_word)(&name) {
        let message = format!("{name} has a meaning of its own in {}", target.name);
        found.push("reserved-name", "name", None, message, "give it another name, for example arm");
    }
    if !found.is_empty() {
        return found.finish(None);
    }
    let mut code = short(code(request, robot));
    code.head = lines_of_robot(request, robot, language);
    found.finish(Some(print(&code)))
}
