//! The calls of all functions of a controller, and what they are called with.

use super::super::outline::Outline;

/// Returns the arguments of `step` or `rate` besides time and state: functions of the harness, and a null context.
pub(super) fn handed(name: &str, externs: &[(String, &'static str)]) -> String {
    let one = |(_, argument): &(String, &'static str)| match *argument {
        "context" => "NULL, ".to_owned(),
        function => format!("{name}_eva_{function}, "),
    };
    externs.iter().map(one).collect()
}

/// A function of the controller: what it is called with, and which of that are pointers.
pub(super) struct Call {
    pub(super) function: &'static str,
    pub(super) arguments: Vec<String>,
    pub(super) pointers: Vec<usize>,
}

impl Call {
    pub(super) fn text(&self, name: &str, missing: Option<usize>) -> String {
        let given = self.arguments.iter().enumerate();
        let given: Vec<_> = given
            .map(|(at, argument)| if missing == Some(at) { "NULL" } else { argument.as_str() })
            .collect();
        format!("{name}_{}({})", self.function, given.join(", "))
    }
}

/// The calls of all functions that take time or a state.
pub(super) fn calls(name: &str, frame: &Outline, externs: &[(String, &'static str)]) -> Vec<Call> {
    let mut arguments = vec!["&self".to_owned(), "t".to_owned(), "x".to_owned()];
    let mut pointers = vec![0, 2];
    if frame.references > 0 {
        pointers.push(arguments.len());
        arguments.push("r".to_owned());
    }
    if frame.associated {
        arguments.push(frame.zero.to_owned());
    }
    for (_, argument) in externs {
        if *argument == "context" {
            arguments.push("NULL".to_owned());
        } else {
            pointers.push(arguments.len());
            arguments.push(format!("{name}_eva_{argument}"));
        }
    }
    pointers.push(arguments.len());
    let (function, last) = if frame.associated { ("rate", "xi_dot") } else { ("step", "&u") };
    arguments.push(last.to_owned());
    let mut calls = vec![Call { function, arguments, pointers }];
    if frame.associated {
        calls.extend(ways(&calls[0]));
    }
    if !frame.gains.is_empty() {
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
        let tick = words(&["&self", "t", "&gains"]);
        calls.push(Call { function: "tick", arguments: tick, pointers: vec![0, 2] });
        let given = if frame.references > 0 {
            &["&gains", "x", "r", "&u"][..]
        } else {
            &["&gains", "x", "&u"]
        };
        let pointers = (0..given.len()).collect();
        calls.push(Call { function: "axis", arguments: words(given), pointers });
    }
    calls
}

/// The other calls of the associated system, after that of `rate`: its arguments are self, t, xi, f, what
/// the user's law takes, and xi_dot.
fn ways(rate: &Call) -> Vec<Call> {
    let call = |function, arguments: Vec<String>| {
        let pointer =
            |index: &usize| arguments[*index].as_str() != "t" && arguments[*index] != "NULL";
        let pointers = (0..arguments.len()).filter(pointer).collect();
        Call { function, arguments, pointers }
    };
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
    let externs = &rate.arguments[4..rate.arguments.len() - 1];
    let control = [words(&["&self", "t", "x"]), externs.to_vec(), words(&["&xi_dot[0]"])].concat();
    vec![
        call("state", words(&["&self", "t", "x", "xi_dot"])),
        call("control", control),
        call("time", words(&["&self", "t", "&xi_dot[0]"])),
        call("start", words(&["&self", "x", "xi_dot"])),
    ]
}
