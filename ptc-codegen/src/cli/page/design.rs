//! Description of a design, in tables, and the command that runs it again.

use crate::check::examine::Report;
use crate::check::resolved::follows;
use crate::expression::Expression;
use crate::parameter::{Fixed, Parameter};
use crate::plant::Plant;
use crate::request::{After, Feedback, Guard, Reference, Spec};

use crate::cli::source::Source;

/// One line about a design.
pub(super) struct Fact {
    pub(super) name: &'static str,
    pub(super) value: String,
}

/// A parameter or a symbol, and what is known of it.
pub(super) struct Known {
    pub(super) name: String,
    pub(super) meaning: &'static str,
    pub(super) value: String,
    pub(super) unit: String,
}

/// The design in a few lines.
pub(super) fn facts(report: &Report) -> Vec<Fact> {
    let spec = &report.spec;
    let law = match &spec.feedback {
        Feedback::Linear => "pi0 = -(k1*xi1 + ... + kn*xin)".to_owned(),
        Feedback::Expression(_) => {
            let laws: Vec<_> = spec.laws().map(|law| spec.law_named(law).to_string()).collect();
            format!("pi0 = {}", laws.join(", "))
        }
        Feedback::Extern => "pi0 of the program".to_owned(),
        Feedback::LeastEnergy(_) => {
            "u = -(K_1*x1 + ... + K_n*xn), the gains of least energy".to_owned()
        }
    };
    let mapping = match (spec.family(), spec.custom()) {
        (Some(family), _) => format!("{}, mu(t) = {}", family.name(), family.info().mu),
        (None, Some(custom)) => format!("{} = {}", custom.subject.key(), custom.given),
        (None, None) => String::new(),
    };
    let after = match spec.after {
        After::Hold => "the gains stay as they are at eps",
        After::Zero => "u = 0",
        After::Extern => "a law of the program",
    };
    let guard = match spec.guard {
        Guard::Full => "full: every input is checked",
        Guard::Result => "result: the result is checked",
        Guard::None => "none: inputs are trusted",
    };
    let of_plant = |e: &Expression| match &spec.model {
        Some(model) => model.text(e),
        None => e.to_string(),
    };
    let gain = spec.input_gain.as_ref().map_or("1".to_owned(), of_plant);
    let mut facts = vec![fact("name", spec.name()), fact("fingerprint", spec.fingerprint())];
    facts.extend(report.choices.iter().map(|choice| fact("chosen", choice.told())));
    facts.extend(follows(&report.spec).iter().map(|choice| fact("follows", choice.told())));
    match &spec.coupled {
        Some(coupled) => facts.extend([
            fact("plant", coupled.order_text()),
            fact("time mapping", mapping),
            fact("law of each output", law),
        ]),
        None => facts.extend([
            fact("order n", spec.n.to_string()),
            fact("time mapping", mapping),
            fact("law", law),
            fact("input gain g", gain),
        ]),
    }
    facts.extend(spec.drift.as_ref().map(|f| fact("known f, cancelled", of_plant(f))));
    facts.extend(match &spec.reference {
        Some(Reference::Known(_)) => {
            let each: Vec<_> = spec.known_references().map(|r| r[0].to_string()).collect();
            Some(fact("reference", format!("r = {}", each.join(", "))))
        }
        Some(Reference::Input) => Some(fact("reference", "given with each call".to_owned())),
        None => None,
    });
    if !spec.poles.is_empty() {
        let each: Vec<_> = spec.designs().iter().map(Spec::written_poles).collect();
        facts.push(fact("poles", each.join("; ")));
    }
    facts.extend([
        fact("after the deadline", after.to_owned()),
        fact("guard", guard.to_owned()),
        fact("precision", spec.precision.name().to_owned()),
    ]);
    facts.extend(spec.fma.then(|| fact("products and sums", "fused: one rounding".to_owned())));
    facts.extend(spec.latency.then(|| fact("polynomials", "as trees".to_owned())));
    facts
}

fn fact(name: &'static str, value: String) -> Fact {
    Fact { name, value }
}

/// The parameters of the controller, and the symbols of the plant.
pub(super) fn known(spec: &Spec, plant: &Plant) -> Vec<Known> {
    let told = |fixed: Option<&Fixed>, bounds: Option<&(Fixed, Fixed)>| match (fixed, bounds) {
        (Some(value), _) => value.to_string(),
        (None, Some((least, greatest))) => format!("[{least}, {greatest}]"),
        (None, None) => "at run time".to_owned(),
    };
    let designs = spec.designs();
    // Axes and outputs may have values of their own, and not all of them every gain.
    let each = |parameter: Parameter| {
        let has = |own: &&Spec| !matches!(parameter, Parameter::Gain(i) if i > own.loop_order());
        let values = designs.iter().filter(has);
        let values = values.map(|own| told(own.fixed.get(&parameter), own.bounds.get(&parameter)));
        let mut values: Vec<_> = values.collect();
        if values.windows(2).all(|pair| pair[0] == pair[1]) {
            values.truncate(1);
        }
        values.join(", ")
    };
    let own = spec.parameters().into_iter().map(|parameter| Known {
        name: parameter.spelling(),
        meaning: parameter.meaning(),
        value: each(parameter),
        unit: spec.unit(parameter),
    });
    let symbols = plant.symbols(spec).into_iter().map(|symbol| (symbol, "symbol of the plant"));
    let others = spec.parameters().into_iter().filter(|parameter| plant.gives(*parameter));
    let others = others.map(|parameter| (parameter, "its value in the plant"));
    let symbols = symbols.chain(others).map(|(symbol, meaning)| Known {
        name: symbol.spelling(),
        meaning,
        value: told(plant.fixed.get(&symbol), plant.bounds.get(&symbol)),
        unit: "as in its expression".to_owned(),
    });
    own.chain(symbols).collect()
}

/// The name of the design file beside a report: where the design came from is no part of it.
pub(super) fn file(spec: &Spec) -> String {
    format!("{}.toml", spec.name())
}

/// A command of the design, in a file of its name.
pub(crate) fn command(
    verb: &str,
    spec: &Spec,
    source: &Source,
    flags: &[(&str, Option<String>)],
) -> String {
    let mut words = vec!["ptc-codegen".to_owned(), verb.to_owned()];
    if source.text().is_some() {
        words.push(file(spec));
    }
    let given = source.flags().chain(flags.iter().filter_map(|(flag, value)| {
        let value = value.as_deref()?;
        Some((*flag, value))
    }));
    words.extend(given.map(|(flag, value)| match value {
        "" => flag.to_owned(),
        _ => format!("{flag}={}", shell(value)),
    }));
    words.join(" ")
}

/// The command that gives the same report.
pub(crate) fn reporting(command: &str, spec: &Spec) -> String {
    format!("{command} --report={}.html", spec.name())
}

/// A value as a shell reads it.
fn shell(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "_-.,+/:=".contains(c);
    match text.chars().all(plain) {
        true => text.to_owned(),
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
}

/// A number of a table, to seven digits.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) {
        let text = format!("{value:.7}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        return if text == "-0" { "0".to_owned() } else { text.to_owned() };
    }
    format!("{value:.6e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shell_values_are_quoted() {
        assert_eq!(shell("-1,0.5"), "-1,0.5");
        assert_eq!(shell("exp(a=1)"), "'exp(a=1)'");
        assert_eq!(shell("it's"), "'it'\\''s'");
    }

    #[test]
    fn table_numbers_are_short() {
        assert_eq!([0.0, -0.0, 0.25, -2000.0].map(short), ["0", "0", "0.25", "-2000"]);
        assert_eq!(short(1.0 / 3.0), "0.3333333");
        assert_eq!(short(-1.5e-9), "-1.500000e-9");
    }
}
