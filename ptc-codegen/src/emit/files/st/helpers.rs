//! Functions beside the block, and what its head says of its use.

use super::library::{Member, Scope, Section, Unit};
use crate::code::{Code, Shape};

/// A function of values of type `kind`.
fn function(
    (name, names): (String, &[&str]),
    kind: &'static str,
    about: &str,
    body: String,
) -> Unit {
    let members = names.iter().map(|name| Member::plain(name, kind)).collect();
    let sections = vec![Section { scope: Scope::Input, members }];
    Unit { name, about: about.to_owned(), returns: Some(kind), sections, body }
}

/// The difference of two counts.
pub(super) fn ticks(name: &str) -> Unit {
    let body = format!(
        "\
IF b <= a THEN
    {name}_ticks := a - b;
ELSE
    {name}_ticks := (UDINT#4294967295 - b) + a + UDINT#1;
END_IF;"
    );
    function((format!("{name}_ticks"), &["a", "b"]), "UDINT", "a - b, modulo 2^32.", body)
}

/// Function that returns the remainder of a count, or 0.
pub(super) fn left(name: &str) -> Unit {
    let body = format!(
        "\
IF b < a THEN
    {name}_left := a - b;
ELSE
    {name}_left := UDINT#0;
END_IF;"
    );
    function((format!("{name}_left"), &["a", "b"]), "UDINT", "a - b, 0 where b is greater.", body)
}

/// A quotient.
pub(super) fn quotient(name: &str, real: &'static str, numbers: [&str; 2]) -> Unit {
    let about = "a / b, and not a number where b is 0: some controllers stop at a division by 0.";
    let names = (format!("{name}_quotient"), &["a", "b"][..]);
    unless_zero(names, real, ["b", "a / b"], about, numbers)
}

/// A divisor.
pub(super) fn divisor(name: &str, real: &'static str, numbers: [&str; 2]) -> Unit {
    let about = "a, and not a number where a is 0: some controllers stop at a division by 0.";
    let names = (format!("{name}_divisor"), &["a"][..]);
    unless_zero(names, real, ["a", "a"], about, numbers)
}

/// A function that returns a value unless a number is 0: then it returns NaN, the difference of two infinities.
fn unless_zero(
    (name, names): (String, &[&str]),
    real: &'static str,
    [divisor, value]: [&str; 2],
    about: &str,
    [zero, huge]: [&str; 2],
) -> Unit {
    let body = format!(
        "\
IF ({divisor} < {zero}) OR ({divisor} > {zero}) THEN
    {name} := {value};
ELSE
    huge := {huge};
    FOR i := 1 TO 4 DO
        huge := huge * huge;
    END_FOR;
    {name} := huge - huge;
END_IF;"
    );
    let mut unit = function((name, names), real, about, body);
    let members = vec![Member::plain("huge", real), Member::plain("i", "DINT")];
    unit.sections.push(Section { scope: Scope::Local, members });
    unit
}

/// The name of the type of an array.
pub(super) fn array(name: &str, shape: Shape) -> String {
    match shape {
        Shape::Lists(rows, columns) => format!("{name}_matrix{rows}x{columns}"),
        Shape::Statuses(count) => format!("{name}_statuses{count}"),
        shape => format!("{name}_vector{}", shape.length().unwrap_or(1)),
    }
}

/// The name of a number beyond the range of a REAL.
pub(super) fn wide(index: usize) -> String {
    format!("wide{}", index + 1)
}

/// The name of a local value of a subroutine, whose statements are among those of the block.
pub(super) fn of_subroutine(name: &str) -> String {
    format!("row_{name}")
}

/// The further status of a filter.
const INFEASIBLE: &str =
    "   6  infeasible: not all bounds can be kept from here, u is the nearest to them\n";

/// The statuses of an observer.
const UPDATE: &str = "\
status; on a negative one nothing has changed:
   0  tracking, or init or arm done
   1  hold: the round of the observer is over
  -1  a parameter outside its domain, or coefficients that overflow; arm without init
  -2  an argument is not finite, or no init before
  -3  an estimate is not finite
Numbers are those of IEEE 754.";

/// The statuses of a deadline in flight.
const FLIGHT: &str = "\
Of a deadline in flight:
   5  late: the deadline was put off, as a limit would have been exceeded; u is valid
   6  infeasible: no deadline was found that keeps the limits; N stays, u is valid
  -4  a deadline too soon for the limits, or none that keeps them";

/// The statuses of several inputs.
const SEVERAL: &str = "\
u[i] is input i and axes[i] its status, with the same numbers. status is negative if one of axes
is, and then every u is 0; otherwise it is 2 if an input was clipped.";

/// Describes the usage of the function block.
pub(super) fn about(code: &Code, real: &str, commands: Option<String>) -> String {
    let (start, again, call) = match code.start {
        None => ("at tick 0", "tick k", "once for each tick k"),
        Some(_) => ("at params.t0 (or the fixed t0)", "start_time", "at each time t"),
    };
    let (lasting, neither) = match code.changes_duration() {
        true => ("\nwith arm_for the same for the duration arm_for_tau;", "none of them"),
        false => ("", "neither"),
    };
    let calls = format!(
        "\
Call it with init once, which takes params and starts {start};
with arm to start again at {again};{lasting} then with {neither}, {call}.
One call does one of these."
    );
    let commands = commands.map_or(String::new(), |text| format!("\n{text}"));
    let calls = format!("{calls}{commands}");
    if code.function("update").is_some() {
        return format!("{calls}\n\n{UPDATE}");
    }
    let infeasible = if code.is_filter() { INFEASIBLE } else { "" };
    let mut text = format!(
        "\
{calls}

status; on a negative one u is 0 and nothing has changed; u is 0 after init and arm too:
   0  tracking, or init or arm done
   1  hold: time-to-go held at eps, the deadline is near or over, u is valid
   2  saturated: u clipped to its limits; wins over 1 and 3
   3  after: the deadline is over, u is 0 or that of the user-defined law
   4  gated: a reading was not believed, u by prediction alone; wins over all above
  -1  a parameter outside its domain, or coefficients that overflow; arm without init
  -2  an argument is not finite or out of its domain, or no init before
  -3  u not finite
{infeasible}Numbers are those of IEEE 754; an infinite u_max is given as the greatest finite number."
    );
    if code.function("deadline").is_some() {
        text.push_str("\n\n");
        text.push_str(FLIGHT);
    }
    if code.axes().is_some() {
        text.push_str("\n\n");
        text.push_str(SEVERAL);
    }
    let step = code.function("step");
    let length = step.and_then(|step| step.arguments.iter().find_map(|a| a.shape.length()));
    for callback in step.into_iter().flat_map(|step| &step.callbacks) {
        let (name, given, n) = (callback.name, callback.array, length.unwrap_or(1));
        text.push_str(&format!(
            "\n{}\n  It is a FUNCTION {}_{name} : {real} of the project, with the inputs\n  {given} : {} and t : {real}.",
            callback.about,
            code.name,
            array(&code.name, Shape::Reals(n))
        ));
    }
    text
}
