//! Controllers in samples: every language gives the bits of the interpreter, for odd parameters,
//! measurements and ticks too. Python needs NumPy and Structured Text blark (`PYTHON` names an
//! interpreter that has them), MATLAB is run by GNU Octave; where one is not there, it is left out.

use crate::support;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use ptc_codegen::check::examine::examine;
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;
use ptc_codegen::samples;
use support::random::Random;
use support::sampled::{
    Call, Design, LANGUAGES, in_c, in_cpp, in_octave, in_python, in_rust, in_structured_text,
    script,
};
use support::specs::spec;
use support::{folder, in_pairs, in_samples};

/// Calls of `init` for each design, and steps for each of them.
const INITS: usize = 12;
const STEPS: usize = 14;

fn all() -> Vec<Spec> {
    [in_samples::controllers(), in_samples::of_inputs()].concat()
}

fn designs(folder: &Path, indices: &[usize]) -> Vec<Design> {
    let mut designs = Vec::new();
    let all = all();
    for index in indices {
        let report = examine(&all[*index]);
        report.accepted().expect("a legal design");
        let sampled = report.spec.sampled().expect("a clock in samples");
        // Without the passes that only shorten lines.
        let code = samples::controller(&report.spec, sampled, Vec::new());
        let home = folder.join(index.to_string());
        fs::create_dir_all(&home).expect("a folder");
        for language in LANGUAGES {
            support::write(&home, &report.spec, language);
        }
        designs.push(Design { code, folder: home });
    }
    designs
}

/// Mostly of the size of 1, sometimes anything.
fn value(random: &mut Random, odd: u64) -> f64 {
    const ODD: [f64; 12] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e300,
        -1e300,
        1e-300,
        0.0,
        -0.0,
        3e38,
        1e40,
        -1e19,
        5e-324,
    ];
    match random.below(odd) {
        0 => ODD[random.below(ODD.len() as u64) as usize],
        _ => random.between(-2.0, 2.0),
    }
}

fn calls(design: &Design, random: &mut Random) -> Vec<Call> {
    let mut calls = Vec::new();
    let length = design.numbers();
    let legal = |random: &mut Random| -> Vec<f64> {
        let mut values = Vec::new();
        for parameter in &design.code.parameters {
            use ptc_codegen::code::Shape;
            match (parameter.shape, parameter.name.as_str()) {
                (Shape::Count, _) => values.push(40.0),
                (Shape::Reals(n), _) => values.extend((0..n).map(|i| 6.0 + i as f64)),
                (_, "h") => values.push(random.between(0.004, 0.014)),
                (_, "deadbeat") => values.push(0.0),
                (_, "u_min") => values.push(random.between(-1.5, 0.4)),
                _ => values.push(random.between(0.5, 3.5)),
            }
        }
        values
    };
    for round in 0..INITS {
        let mut values = legal(random);
        if round > 0 && length > 0 && round % 2 == 0 {
            let at = random.below(length as u64) as usize;
            let mut names = Vec::new();
            for parameter in &design.code.parameters {
                let n = support::sampled::length(parameter.shape);
                names.extend(vec![parameter.shape == ptc_codegen::code::Shape::Count; n]);
            }
            // A count has no fraction and no sign.
            values[at] = match names[at] {
                true => [0.0, 1.0, 7.0, 4294967295.0][random.below(4) as usize],
                false => value(random, 2),
            };
        }
        calls.push(Call::Init(values));
        let start = [0, 5, u32::MAX - 7, 1 << 31][random.below(4) as usize];
        if random.below(3) > 0 {
            calls.push(Call::Arm(start));
        }
        let mut k = start;
        for _ in 0..STEPS {
            let measured = design.measured();
            let numbers = measured + design.references() + usize::from(design.observes());
            let x = (0..numbers).map(|_| value(random, 9)).collect();
            calls.push(Call::Step(k, x));
            k = match random.below(8) {
                0 => k.wrapping_add(random.below(1 << 32) as u32),
                1 => k.wrapping_sub(1),
                _ => k.wrapping_add(1 + random.below(4) as u32),
            };
        }
    }
    calls
}

type Run = fn(&Path, &[Design]) -> Option<Vec<String>>;

/// Runs designs in languages; how often each answer was given.
fn agree(test: &str, indices: &[usize], runs: &[(Language, Run)]) -> BTreeMap<String, usize> {
    let folder = folder(test);
    let designs = designs(&folder, indices);
    let mut random = Random(7);
    let calls: Vec<_> = designs.iter().map(|design| calls(design, &mut random)).collect();
    fs::write(folder.join("script"), script(&calls)).expect("a script");
    let wanted: Vec<Vec<String>> =
        designs.iter().zip(&calls).map(|(design, calls)| design.interpreted(calls)).collect();
    for (language, found) in in_pairs(runs, |run| (run.0, run.1(&folder, &designs))) {
        let name = language.name();
        let Some(found) = found else {
            eprintln!("{name}: not there, left out");
            continue;
        };
        let mut found = found.iter();
        for ((wanted, calls), index) in wanted.iter().zip(&calls).zip(indices) {
            let answered = calls.iter().filter(|call| !matches!(call, Call::Arm(_)));
            for (wanted, call) in wanted.iter().zip(answered) {
                let found = found.next().map(String::as_str);
                assert_eq!(found, Some(wanted.as_str()), "{name}, design {index}: {call:?}");
            }
        }
        assert_eq!(found.next(), None, "{name} answers more than it is asked");
    }
    let mut statuses = BTreeMap::new();
    for line in wanted.iter().flatten() {
        let status = line.split(' ').take(2).collect::<Vec<_>>().join(" ");
        *statuses.entry(status).or_insert(0) += 1;
    }
    statuses
}

#[test]
fn every_language_matches_the_interpreter_bit_for_bit() {
    let runs: [(Language, Run); 5] = [
        (Language::C, in_c),
        (Language::Cpp, in_cpp),
        (Language::Rust, in_rust),
        (Language::Python, in_python),
        (Language::Matlab, in_octave),
    ];
    let all: Vec<_> = (0..all().len()).collect();
    let statuses = agree("samples_languages", &all, &runs);
    println!("{statuses:?}");
    for status in ["I 0", "I -1", "S 0", "S 1", "S 2", "S 3", "S 4", "S -2", "S -3"] {
        assert!(statuses.get(status).is_some_and(|count| *count > 10), "{status}: {statuses:?}");
    }
}

/// Some controllers of one input and observers, and all of several inputs or axes: its parser takes seconds for each
/// file.
#[test]
fn structured_text_matches_the_interpreter_bit_for_bit() {
    let one = in_samples::controllers().len();
    let indices: Vec<_> = [1, 9, 15, 20, 21].into_iter().chain(one..all().len()).collect();
    agree("samples_structured_text", &indices, &[(Language::StructuredText, in_structured_text)]);
}

/// Refused designs, with the key and a part of the message.
#[test]
fn unsupported_features_of_a_language_are_refused() {
    let of = |name: &str| {
        let keys = [("n", "2"), ("mu", "exp"), ("clock", "samples"), ("name", name)];
        spec(&keys)
    };
    let observer = |length: usize| {
        let name = "a".repeat(length);
        spec(&[
            ("what", "observer"),
            ("n", "2"),
            ("mu", "exp(a=1)"),
            ("clock", "samples"),
            ("name", name.as_str()),
            ("disturbance", "constant"),
            ("observer_poles", "-4,-5"),
            ("observer_samples", "9"),
        ])
    };
    assert!(ptc_codegen::generate(&observer(42), Language::Matlab).is_ok());
    let cases = [
        (Language::Matlab, observer(43), "name", "longer than the 63 characters"),
        (Language::Fmu3, of("time_to_go"), "name", "meaning of its own in fmu3"),
        (Language::Fmu2, of("time_to_go"), "name", "meaning of its own in fmu2"),
        (Language::Python, of("lambda"), "name", "meaning of its own in python"),
        (Language::Cpp, of("concept"), "name", "meaning of its own in cpp"),
        (Language::Matlab, of("end"), "name", "meaning of its own in matlab"),
        (Language::StructuredText, of("limit"), "name", "meaning of its own in st"),
        (Language::StructuredText, of("a__b"), "name", "not an identifier in st"),
    ];
    for (language, spec, key, message) in cases {
        let found = ptc_codegen::generate(&spec, language).expect_err(message);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].key == key && found[0].message.contains(message), "{found:?}");
        assert!(!found[0].help.is_empty());
        assert!(ptc_codegen::generate(&spec, Language::C).is_ok(), "{message}");
    }
}
