//! FMI 2.0 and 3.0: a co-simulation FMU around the C of a controller.
//!
//! What is text is made here, by the paths in the archive; the command line compiles and packs it.

mod variables;

use askama::Template;

use super::apart::apart;
use super::code::{Condition, domain};
use super::example::Example;
use super::outline::Outline;
use super::{
    Controller, File, Language, Print, Target, c_files, literal, program, stands_alone, text_of,
    tidy,
};
use crate::diagnostic::Diagnostics;
use crate::parameter::{Fixed, Parameter, Precision};
use crate::program::{Program, number};
use crate::request::Spec;
use variables::{Unit, Variable};

/// A version of the interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Version {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

impl Version {
    /// The headers of the interface, which an importer has; they stand in no FMU.
    pub fn headers(self) -> Vec<File> {
        let headers: [(&str, &str); 3] = match self {
            Self::Two => [
                ("fmi2TypesPlatform.h", include_str!("../../../templates/fmu/fmi2TypesPlatform.h")),
                ("fmi2FunctionTypes.h", include_str!("../../../templates/fmu/fmi2FunctionTypes.h")),
                ("fmi2Functions.h", include_str!("../../../templates/fmu/fmi2Functions.h")),
            ],
            Self::Three => [
                ("fmi3PlatformTypes.h", include_str!("../../../templates/fmu/fmi3PlatformTypes.h")),
                ("fmi3FunctionTypes.h", include_str!("../../../templates/fmu/fmi3FunctionTypes.h")),
                ("fmi3Functions.h", include_str!("../../../templates/fmu/fmi3Functions.h")),
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
    print: Print::Around(|controller| files(controller, Version::Two)),
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
    print: Print::Around(|controller| files(controller, Version::Three)),
};

fn refuse(spec: &Spec, _: Option<&Program>, found: &mut Diagnostics) {
    if spec.sampled().is_some() {
        let message = "an FMU is given its time, and has no clock in samples";
        let help = "leave `clock` out, or emit another language and count the ticks in the model";
        found.push("unsupported", "clock", None, message, help);
    }
    stands_alone(spec, "an FMU", found);
}

/// The names of outputs, and those of the types in the source of the interface.
fn is_word(word: &str) -> bool {
    matches!(word, "time" | "u" | "time_to_go" | "status" | "State" | "Instance")
}

/// The files of the FMU of a controller, by their paths in it, without a binary.
fn files(controller: &Controller<'_>, version: Version) -> Vec<File> {
    let name = controller.spec().name();
    // The token is a hash of all that the FMU says, itself left out.
    let example = Example::of(controller.report);
    let unsigned = with_token(controller, version, &example, "");
    let token = token(unsigned.iter().map(|file| file.text.as_str()));
    let mut files = with_token(controller, version, &example, &token);
    let at_source = |file: File| File { name: format!("sources/{}", file.name), ..file };
    files.extend(c_files(controller).into_iter().map(at_source));
    if version == Version::Three {
        let build = Build { name: &name };
        files.push(file("sources/buildDescription.xml", build.render()));
    }
    files
}

/// modelDescription.xml and the source of the interface.
fn with_token(
    controller: &Controller<'_>,
    version: Version,
    example: &Example,
    token: &str,
) -> Vec<File> {
    let spec = controller.spec();
    let name = spec.name();
    let program = program(controller, Language::C);
    let frame = Outline::new(controller, &program);
    let variables = variables::variables(spec, example);
    let number = |value: f64| literal::c(value, spec.precision);
    let real = |p: Parameter| number(example.value(p));
    let place = |v: &Variable| v.place.clone().map(|place| Kept { reference: v.reference, place });
    let starts = frame.locals.iter().zip(spec.run_time_parameters());
    let constants = variables.iter().filter_map(|v| {
        let number = spec.fixed.get(&v.parameter?).and_then(Fixed::number)?;
        let literal = literal::c(number::round(number, spec.precision), spec.precision);
        Some(Constant { reference: v.reference, literal })
    });
    let of_start = |v: &&Variable| v.parameter == Some(Parameter::StartTime) && v.place.is_some();
    let start_reference = variables.iter().find(of_start).map(|v| v.reference);
    let core = Core {
        name: &name,
        n: spec.n,
        version: if version == Version::Two { 2 } else { 3 },
        state_letter: if version == Version::Two { 's' } else { 'S' },
        logger: if version == Version::Two { "CallbackLogger" } else { "LogMessageCallback" },
        token,
        start: match start_reference {
            Some(_) => "state->params.t0".to_owned(),
            None => real(Parameter::StartTime),
        },
        time_to_go: "-((t - state->controller.deadline) - state->controller.correction)",
        starts: starts
            .map(|(local, p)| Start { place: local.value.clone(), value: real(p) })
            .collect(),
        conditions: domain(&program)
            .iter()
            .filter_map(|condition| Judged::of(condition, &variables, spec.n))
            .collect(),
        kept: variables.iter().filter_map(place).collect(),
        constants: constants.collect(),
        start_reference,
        frame: &frame,
    };
    let core = text_of(core.render());
    let single = spec.precision == Precision::F32;
    let lang = if version == Version::Two { Language::Fmu2 } else { Language::Fmu3 };
    let description = format!(
        "Prescribed-time controller of order {}, mapping {}. Made by: ptc-codegen emit --lang {} {}",
        spec.n,
        spec.mapping_name(),
        lang.name(),
        spec.command()
    );
    let (units, outputs) = (Unit::all(&variables), variables::outputs(&variables));
    let start_time = example.value(Parameter::StartTime);
    let stop_time = start_time + example.value(Parameter::Tau);
    let period = example.period;
    let tool = env!("CARGO_PKG_VERSION");
    let (source, xml) = match version {
        Version::Two => (
            Fmi2 { name: &name, core: &core, single, frame: &frame }.render(),
            Model2 {
                name: &name,
                token,
                description: &description,
                version: tool,
                units: &units,
                start_time,
                stop_time,
                period,
                variables: &variables,
                outputs: &outputs,
            }
            .render(),
        ),
        Version::Three => (
            Fmi3 { name: &name, core: &core, single, frame: &frame }.render(),
            Model3 {
                name: &name,
                token,
                description: &description,
                version: tool,
                units: &units,
                start_time,
                stop_time,
                period,
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

/// A token in the form of a UUID: the 128-bit FNV-1a hash of the texts.
fn token<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    let step = |hash: u128, byte: &u8| {
        (hash ^ u128::from(*byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b)
    };
    let offset = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    let hash = texts.fold(offset, |hash, text| text.as_bytes().iter().fold(hash, step));
    let digits = format!("{hash:032x}");
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

/// The start value of a run-time parameter.
struct Start {
    place: String,
    value: String,
}

/// An input or a parameter by its value reference.
struct Kept {
    reference: usize,
    place: String,
}

/// A fixed parameter by its value reference.
struct Constant {
    reference: usize,
    literal: String,
}

/// A condition on a parameter, and what is told where it is not met.
struct Judged {
    name: String,
    place: String,
    test: String,
    legal: String,
}

impl Judged {
    fn of(condition: &Condition, variables: &[Variable], n: usize) -> Option<Self> {
        let Condition { test, parameter, legal } = condition;
        let place = format!("params.{parameter}");
        let variable = variables.iter().find(|v| v.place.as_ref() == Some(&place))?;
        let about = variable.parameter?;
        Some(Self {
            name: variable.name.clone(),
            place,
            test: test.clone(),
            legal: format!("{} [{}], {legal}", about.meaning(), about.unit_for(n)),
        })
    }
}

#[derive(Template)]
#[template(path = "fmu/core.c.txt", escape = "none")]
struct Core<'a> {
    name: &'a str,
    n: usize,
    version: u8,
    /// `s` or `S`, as the interface spells `GetFMUstate`.
    state_letter: char,
    logger: &'static str,
    token: &'a str,
    /// The start time, as an expression.
    start: String,
    time_to_go: &'static str,
    starts: Vec<Start>,
    conditions: Vec<Judged>,
    kept: Vec<Kept>,
    constants: Vec<Constant>,
    start_reference: Option<usize>,
    frame: &'a Outline,
}

#[derive(Template)]
#[template(path = "fmu/fmi2.c.txt", escape = "none")]
struct Fmi2<'a> {
    name: &'a str,
    core: &'a str,
    single: bool,
    frame: &'a Outline,
}

#[derive(Template)]
#[template(path = "fmu/fmi3.c.txt", escape = "none")]
struct Fmi3<'a> {
    name: &'a str,
    core: &'a str,
    single: bool,
    frame: &'a Outline,
}

#[derive(Template)]
#[template(path = "fmu/modelDescription2.xml", escape = "html")]
struct Model2<'a> {
    name: &'a str,
    token: &'a str,
    description: &'a str,
    version: &'a str,
    units: &'a [Unit],
    start_time: f64,
    stop_time: f64,
    period: f64,
    variables: &'a [Variable],
    outputs: &'a [&'a Variable],
}

#[derive(Template)]
#[template(path = "fmu/modelDescription3.xml", escape = "html")]
struct Model3<'a> {
    name: &'a str,
    token: &'a str,
    description: &'a str,
    version: &'a str,
    units: &'a [Unit],
    start_time: f64,
    stop_time: f64,
    period: f64,
    variables: &'a [Variable],
    outputs: &'a [&'a Variable],
}

#[derive(Template)]
#[template(path = "fmu/buildDescription.xml", escape = "html")]
struct Build<'a> {
    name: &'a str,
}
