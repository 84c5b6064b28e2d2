//! FMI 2.0 and 3.0: a co-simulation FMU around the C of a controller.
//!
//! What is text is made here, by the paths in the archive; the command line compiles and packs it.

mod template;
mod variables;

use askama::Template;

use super::apart::apart;
use super::c::{Notes, domain, files as c, refuse_macros};
use super::example::Example;
use super::outline::Outline;
use super::{File, Language, Print, Target, literal, stands_alone, text_of, tidy};
use crate::check::examine::Report;
use crate::code::Code;
use crate::diagnostic::Diagnostics;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::program::{Program, number};
use crate::request::{Spec, hash};
use template::{Build, Constant, Core, Fmi2, Fmi3, Judged, Kept, Model2, Model3, Samples, Start};
use variables::{Inputs, Unit, Variable};

/// A version of the interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Version {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

impl Version {
    pub(super) fn target(self) -> &'static Target {
        match self {
            Self::Two => &TARGET_2,
            Self::Three => &TARGET_3,
        }
    }

    /// The headers of the interface, which an importer has; no FMU holds them.
    pub fn headers(self) -> Vec<File> {
        let headers: [(&str, &str); 3] = match self {
            Self::Two => [
                (
                    "fmi2TypesPlatform.h",
                    include_str!("../../../../templates/fmu/fmi2TypesPlatform.h"),
                ),
                (
                    "fmi2FunctionTypes.h",
                    include_str!("../../../../templates/fmu/fmi2FunctionTypes.h"),
                ),
                ("fmi2Functions.h", include_str!("../../../../templates/fmu/fmi2Functions.h")),
            ],
            Self::Three => [
                (
                    "fmi3PlatformTypes.h",
                    include_str!("../../../../templates/fmu/fmi3PlatformTypes.h"),
                ),
                (
                    "fmi3FunctionTypes.h",
                    include_str!("../../../../templates/fmu/fmi3FunctionTypes.h"),
                ),
                ("fmi3Functions.h", include_str!("../../../../templates/fmu/fmi3Functions.h")),
            ],
        };
        let file = |(name, text): (&str, &str)| File { name: name.into(), text: text.into() };
        headers.into_iter().map(file).collect()
    }
}

/// FMI 2.0.
pub(super) const TARGET_2: Target = Target {
    language: Language::Fmu2,
    name: "fmu2",
    about: "an FMU for co-simulation after FMI 2.0",
    ..TARGET_3
};

/// FMI 3.0.
pub(super) const TARGET_3: Target = Target {
    language: Language::Fmu3,
    name: "fmu3",
    about: "one after FMI 3.0",
    comment: ("/* ", " */"),
    is_word,
    refuse,
    print: Print::Fmu,
};

fn refuse(spec: &Spec, _: Option<&Program>, found: &mut Diagnostics) {
    refuse_macros(spec, found);
    stands_alone(spec, "an FMU", found);
    let inputs: Vec<_> = (0..spec.references()).map(|order| format!("r{order}")).collect();
    for parameter in spec.parameters().into_iter().filter(|p| inputs.contains(&p.spelling())) {
        let message = format!("the FMU has an input {}, the reference", parameter.spelling());
        let help = "give the parameter another name";
        found.push("not-alone", format!("params.{}", parameter.spelling()), None, message, help);
    }
}

/// The names of outputs, and those of the types in the source of the interface.
fn is_word(word: &str) -> bool {
    matches!(word, "time" | "u" | "time_to_go" | "status" | "State" | "Instance")
}

/// The files of the FMU of a controller, by their paths in it, without a binary.
pub(super) fn files(report: &Report, code: &Code, version: Version) -> Vec<File> {
    let name = report.spec.name();
    // The token is a hash of all that the FMU says, itself left out.
    let example = Example::of(report);
    let unsigned = with_token(&report.spec, code, version, &example, "");
    let token = token(unsigned.iter().map(|file| file.text.as_str()));
    let mut files = with_token(&report.spec, code, version, &example, &token);
    let at_source = |file: File| File { name: format!("sources/{}", file.name), ..file };
    files.extend(c(code, &Notes::default()).into_iter().map(at_source));
    if version == Version::Three {
        let build = Build { name: &name };
        files.push(file("sources/buildDescription.xml", build.render()));
    }
    files
}

/// modelDescription.xml and the source of the interface.
fn with_token(
    spec: &Spec,
    program: &Code,
    version: Version,
    example: &Example,
    token: &str,
) -> Vec<File> {
    let name = spec.name();
    let frame = Outline::new(spec, program);
    let Inputs { count: inputs, letter } = Inputs::of(spec);
    let variables = variables::variables(spec, example);
    let number = |value: f64| literal::c(value, spec.precision);
    let real = |p: Parameter| number(example.value(p));
    let start = |p: Parameter| match p {
        Parameter::Samples => format!("{}u", example.value(p)),
        p => real(p),
    };
    let at = |parameter: Parameter| match parameter.index() {
        Some(index) => format!("{}[{index}]", parameter.key()),
        None => parameter.key().to_owned(),
    };
    let is_count = |v: &&Variable| v.parameter == Some(Parameter::Samples);
    let count = variables.iter().find(is_count);
    let place = |v: &Variable| v.place.clone().map(|place| Kept { reference: v.reference, place });
    let constants = variables.iter().filter(|v| !is_count(v)).filter_map(|v| {
        let number = spec.fixed.get(&v.parameter?).and_then(Fixed::number)?;
        let literal = literal::c(number::round(number, spec.precision), spec.precision);
        Some(Constant { reference: v.reference, literal })
    });
    let of_start = |v: &&Variable| v.parameter == Some(Parameter::StartTime) && v.place.is_some();
    let start_reference = variables.iter().find(of_start).map(|v| v.reference);
    // What is fixed is a number, and what is not a parameter.
    let known = |p: Parameter| match spec.fixed.contains_key(&p) {
        true => start(p),
        false => format!("state->params.{}", p.key()),
    };
    let samples = spec.sampled().map(|_| Samples {
        count: known(Parameter::Samples),
        period: known(Parameter::SampleTime),
        estimates: variables::estimates(spec).len(),
    });
    let core = Core {
        name: &name,
        inputs,
        letter,
        version: if version == Version::Two { 2 } else { 3 },
        state_letter: if version == Version::Two { 's' } else { 'S' },
        logger: if version == Version::Two { "CallbackLogger" } else { "LogMessageCallback" },
        token,
        start: match start_reference {
            Some(_) => "state->params.t0".to_owned(),
            None => real(Parameter::StartTime),
        },
        time_to_go: "-((t - state->controller.deadline) - state->controller.correction)",
        starts: spec
            .run_time_parameters()
            .map(|p| Start { place: at(p), value: start(p) })
            .collect(),
        conditions: domain(program)
            .iter()
            .filter_map(|condition| Judged::of(condition, &variables, spec))
            .collect(),
        kept: variables.iter().filter(|v| !is_count(v)).filter_map(place).collect(),
        constants: constants.collect(),
        start_reference,
        samples_reference: count.filter(|v| v.place.is_some()).map(|v| v.reference),
        samples_fixed: count
            .filter(|v| v.place.is_none())
            .map(|v| (v.reference, example.value(Parameter::Samples).to_string())),
        samples,
        disturbance: spec.sampled().is_some_and(|sampled| sampled.disturbance),
        frame: &frame,
    };
    let core = text_of(core.render());
    let single = spec.precision == Precision::F32;
    let lang = if version == Version::Two { Language::Fmu2 } else { Language::Fmu3 };
    let description = format!(
        "Prescribed-time controller of order {}, mapping {}. Design {}. Made by: ptc-codegen emit --lang {} {}",
        spec.n,
        spec.mapping_name(),
        spec.fingerprint(),
        lang.name(),
        spec.command()
    );
    let (units, outputs) = (Unit::all(&variables), variables::outputs(&variables));
    let period = example.period;
    let (start_time, length) = match spec.sampled() {
        Some(_) => (0.0, example.value(Parameter::Samples) * period),
        None => (example.value(Parameter::StartTime), example.value(Parameter::Tau)),
    };
    let stop_time = start_time + length;
    let variable_step = spec.sampled().is_none();
    let fixed_step =
        (!variable_step && spec.fixed.contains_key(&Parameter::SampleTime)).then_some(period);
    let tool = env!("CARGO_PKG_VERSION");
    let (source, xml) = match version {
        Version::Two => (
            Fmi2 { name: &name, core: &core, single, inputs, letter, frame: &frame }.render(),
            Model2 {
                name: &name,
                token,
                description: &description,
                version: tool,
                units: &units,
                start_time,
                stop_time,
                period,
                variable_step,
                variables: &variables,
                outputs: &outputs,
            }
            .render(),
        ),
        Version::Three => (
            Fmi3 { name: &name, core: &core, single, inputs, letter, frame: &frame }.render(),
            Model3 {
                name: &name,
                token,
                description: &description,
                version: tool,
                units: &units,
                start_time,
                stop_time,
                period,
                variable_step,
                fixed_step,
                variables: &variables,
                outputs: &outputs,
            }
            .render(),
        ),
    };
    vec![
        file("modelDescription.xml", xml),
        apart(file(&format!("sources/{name}_fmu.c"), source), &name),
    ]
}

fn file(name: &str, text: askama::Result<String>) -> File {
    File { name: name.to_owned(), text: tidy(&text_of(text)) }
}

/// A token in the form of a UUID: the hash of the texts.
fn token<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    let digits = format!("{:032x}", hash(texts));
    let [a, b, c, d] = [8, 12, 16, 20];
    format!(
        "{{{}-{}-{}-{}-{}}}",
        &digits[..a],
        &digits[a..b],
        &digits[b..c],
        &digits[c..d],
        &digits[d..]
    )
}
