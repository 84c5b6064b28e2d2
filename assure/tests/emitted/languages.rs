//! The languages beside C and Rust: C++ against C bit for bit, and what each language refuses. The
//! layers of `cargo assure` compare them all, for which they need more tools.

use crate::support;

use std::fs;
use std::process::Command;

use ptc_assure::harness::cpp::{STRICT_CPP, cpp_compiler, in_cpp_from};
use ptc_assure::harness::records::records;
use ptc_codegen::emit::Language;
use ptc_codegen::parameter::Parameter;
use ptc_codegen::request::Spec;
use support::program::in_c;
use support::random::Random;
use support::specs::{calls_a_library, families, spec};
use support::{folder, in_pairs, run, write};

fn controllers() -> Vec<Spec> {
    let of_families = families().map(|family| Spec::new(2, family));
    let features: [&[(&str, &str)]; 14] = [
        &[("n", "2"), ("mu", "exp"), ("name", "apart"), ("u_min", "runtime")],
        &[
            ("n", "2"),
            ("mu", "rational"),
            ("name", "duty"),
            ("u_max", "1"),
            ("u_min", "0"),
            ("guard", "result"),
        ],
        &[
            ("n", "3"),
            ("mu", "exp"),
            ("name", "one_sided"),
            ("u_max", "inf"),
            ("u_min", "-1/3"),
            ("precision", "f32"),
        ],
        &[
            ("n", "3"),
            ("mu", "tanh"),
            ("precision", "f32"),
            ("guard", "none"),
            ("name", "trusting"),
        ],
        &[("n", "3"), ("mu", "exp"), ("guard", "result"), ("name", "result_of_mine")],
        &[
            ("n", "1"),
            ("mu", "exp(a=1)"),
            ("pi0", "-psi*xi1/(abs(xi1) - phi*abs(xi1_0))^2"),
            ("name", "latching"),
        ],
        &[("n", "2"), ("mu", "tanh"), ("pi0", "extern"), ("after", "extern"), ("name", "mine")],
        &[("n", "3"), ("kappa", "dt/(a*(tau - dt))"), ("g", "x1"), ("name", "dividing")],
        &[
            ("n", "3"),
            ("mu", "rational"),
            ("gains", "1,3,3"),
            ("what", "associated"),
            ("name", "infinite"),
        ],
        &[("n", "9"), ("kappa", "tau*dt/(tau - dt) + dt"), ("name", "in_loops")],
        &[("n", "3"), ("mu", "tanh"), ("reference", "input"), ("name", "given")],
        &[("n", "3"), ("mu", "tan"), ("in_flight", "true"), ("name", "lasting")],
        &[
            ("n", "2"),
            ("mu", "power"),
            ("pi0", "-xi1 - xi2 + xi1_0"),
            ("in_flight", "true"),
            ("precision", "f32"),
            ("name", "lasting_latched"),
        ],
        &[
            ("n", "2"),
            ("mu", "rational"),
            ("reference", "w*t/(1 + dt^2)"),
            ("f", "x2*t"),
            ("name", "following"),
        ],
    ];
    of_families.chain(features.map(spec)).collect()
}

#[test]
fn cpp_gives_the_bits_of_c() {
    let folder = folder("languages_cpp");
    let specs = controllers();
    let c = in_c(&folder.join("c"), &specs);
    let numbered: Vec<_> = specs.iter().zip(&c).enumerate().collect();
    in_pairs(&numbered, |(index, (spec, c))| {
        let home = folder.join(index.to_string());
        fs::create_dir_all(&home).expect("a folder");
        write(&home, spec, Language::Cpp);
        let records = records(spec, &mut Random(*index as u64), 500);
        let outcomes = c.run(&records).into_iter().zip(in_cpp_from(&home, spec).run(&records));
        for ((c, cpp), record) in outcomes.zip(&records) {
            // Both call the library of this machine.
            assert_eq!(c.bits(), cpp.bits(), "C {c:?}, C++ {cpp:?}\n{spec:?}\n{record:?}");
        }
    });
}

/// `step` is `constexpr` exactly if it calls no library, so that the controller can run at compile time.
#[test]
fn cpp_is_constexpr_where_no_library_is_called() {
    let folder = folder("languages_constexpr");
    for spec in families().map(|family| Spec::new(2, family)) {
        let header = write(&folder, &spec, Language::Cpp).remove(0);
        let text = fs::read_to_string(header).expect("a header");
        let sqrt = text.contains("std::sqrt(");
        let constant = text.contains("constexpr Control<double> step(");
        assert_eq!(constant, !calls_a_library(&spec) && !sqrt, "{}", spec.name());
        if !constant {
            continue;
        }
        let type_name = spec.type_name();
        let program = folder.join(format!("{}.cpp", spec.name()));
        let soft = spec.run_time_parameters().any(|p| p == Parameter::Start);
        let own = if soft { "1.0, 0.25" } else { "1.0" };
        let text = format!(
            "#include \"{}.hpp\"\nconstexpr ptc::{type_name} self() {{ ptc::{type_name} s{{}}; return \
             s.init({{2.0, 0.0, 0.0078125, 50.0, {own}, {{{{6.0, 5.0}}}}}}) == ptc::Status::Ok ? s : \
             ptc::{type_name}{{}}; }}\n\
             static_assert(self().step(1.0, {{{{0.25, -0.5}}}}).status == ptc::Status::Ok, \"ok\");\n\
             static_assert(self().tick(2.0).status == ptc::Status::Hold, \"hold\");\n\
             static_assert(self().step(-1.0, {{{{0.25, -0.5}}}}).status == ptc::Status::Input, \"\");\n",
            spec.name()
        );
        fs::write(&program, text).expect("a program");
        run(cpp_compiler().args(STRICT_CPP).arg("-fsyntax-only").arg(&program));
        if Command::new("clang++").arg("--version").output().is_ok() {
            run(Command::new("clang++").args(STRICT_CPP).arg("-fsyntax-only").arg(&program));
        }
    }
}

/// Refusals of each language, with the key and a part of the message.
#[test]
fn what_a_language_cannot_say_is_refused() {
    let named = |parameter: &str| {
        let law = format!("-{parameter}*xi1");
        spec(&[("n", "1"), ("mu", "exp"), ("pi0", &law)])
    };
    let long = "a".repeat(48);
    let associated = [("n", "2"), ("mu", "exp(a=1)"), ("pi0", "-12*xi1 - 7*xi2")];
    let with = |keys: &[(&str, &str)], more: &[(&str, &str)]| spec(&[keys, more].concat());
    let cases = [
        (Language::Python, named("lambda"), "params.lambda", "meaning of its own in python"),
        (Language::Cpp, named("concept"), "params.concept", "meaning of its own in cpp"),
        (Language::Matlab, named("end"), "params.end", "meaning of its own in matlab"),
        (Language::StructuredText, named("VAR"), "params.VAR", "meaning of its own in st"),
        (Language::StructuredText, named("a__b"), "params.a__b", "not an identifier in st"),
        (
            Language::StructuredText,
            spec(&[("n", "1"), ("mu", "exp"), ("pi0", "-Psi*xi1 - psi*xi1")]),
            "params.psi",
            "capitals alone",
        ),
        (
            Language::StructuredText,
            spec(&[("n", "1"), ("mu", "exp"), ("pi0", "-sinh(xi1)")]),
            "pi0",
            "calls sinh, which st does not have",
        ),
        (
            Language::StructuredText,
            with(&associated, &[("what", "associated")]),
            "what",
            "not emitted in st",
        ),
        (
            Language::StructuredText,
            spec(&[("n", "2"), ("mu", "exp"), ("axes", "2"), ("pi0", "extern")]),
            "pi0",
            "returns an array, which no function in st can",
        ),
        (
            Language::Matlab,
            with(&associated, &[("what", "associated"), ("name", &long)]),
            "name",
            "longer than the 63 characters",
        ),
    ];
    for (language, spec, key, message) in cases {
        let found = ptc_codegen::generate(&spec, language).expect_err(message);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].key == key && found[0].message.contains(message), "{found:?}");
        assert!(!found[0].help.is_empty());
        // The others take it, C among them.
        assert!(ptc_codegen::generate(&spec, Language::C).is_ok(), "{message}");
    }
}
