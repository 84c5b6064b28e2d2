//! Emitted files in the compilers of their hosts: what the code assumes of them, and names that headers define as
//! macros.

use crate::support;

use std::path::Path;
use std::process::Command;

use ptc_codegen::emit::Language;
use ptc_codegen::generate;
use ptc_codegen::parameter::Precision;
use ptc_codegen::request::Spec;
use support::specs::spec;
use support::{STRICT, c_compiler, folder, run, rustc, write};

/// Returns true if the compiler accepts a file, with the compiler's messages.
fn compiled(mut compiler: Command, file: &Path, flags: &[&str]) -> (bool, String) {
    compiler.args(flags).arg("-c").arg(file).arg("-o").arg(file.with_extension("o"));
    let output = compiler.output().expect("a compiler");
    (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// Both clocks in both precisions, and a guard that requires NaN.
fn controllers() -> Vec<Spec> {
    let mut all = Vec::new();
    for precision in ["f64", "f32"] {
        let designs: [&[(&str, &str)]; 3] = [
            &[("n", "3"), ("mu", "exp"), ("name", "plain")],
            &[("n", "2"), ("mu", "power"), ("guard", "result"), ("name", "bare")],
            &[
                ("n", "2"),
                ("mu", "exp(a=1)"),
                ("clock", "samples"),
                ("measured", "x1"),
                ("observer_poles", "-4,-5"),
                ("name", "sampled"),
            ],
        ];
        let named = designs.map(|keys| spec(&[keys, &[("precision", precision)]].concat()));
        all.extend(named);
    }
    all
}

/// Compiles the C of every controller, which is to be refused with `part` or taken.
fn in_every_c(test: &str, flags: &[&str], refused: impl Fn(&Spec) -> Option<&'static str>) {
    for (index, spec) in controllers().iter().enumerate() {
        let folder = folder(test).join(index.to_string());
        std::fs::create_dir_all(&folder).expect("a folder");
        write(&folder, spec, Language::C);
        let file = folder.join(format!("{}.c", spec.name()));
        let (taken, told) = compiled(c_compiler(), &file, flags);
        match refused(spec) {
            Some(part) => {
                assert!(!taken && told.contains(part), "{flags:?}, {}: {told}", spec.name());
            }
            None => assert!(taken, "{flags:?}, {}: {told}", spec.name()),
        }
    }
}

#[test]
fn fast_math_is_refused_unless_it_is_allowed() {
    for flag in ["-ffast-math", "-Ofast", "-ffinite-math-only"] {
        in_every_c("hosts_fast", &["-O2", flag], |_| Some("the guards need NaN and infinity"));
        in_every_c("hosts_allowed", &["-O2", flag, "-DPTC_ALLOW_FAST_MATH"], |_| None);
    }
    in_every_c("hosts_strict", &STRICT, |_| None);
}

/// A double of 24 bits, as on AVR, and numbers that are computed with more digits, as by the x87.
#[test]
fn numbers_of_another_format_are_refused() {
    let is_double = |spec: &Spec| spec.precision == Precision::F64;
    let short = ["-U__DBL_MANT_DIG__", "-D__DBL_MANT_DIG__=24"];
    in_every_c("hosts_short", &short, |spec| {
        is_double(spec).then_some("double is not IEEE 754 binary64 here")
    });
    let names =
        ["__FLT_EVAL_METHOD__", "__FLT_EVAL_METHOD_C99__", "__FLT_EVAL_METHOD_TS_18661_3__"];
    for (method, doubles) in [(2, true), (1, false)] {
        let flags: Vec<_> = names
            .iter()
            .flat_map(|name| [format!("-U{name}"), format!("-D{name}={method}")])
            .collect();
        let flags: Vec<_> =
            ["-std=c99"].into_iter().chain(flags.iter().map(String::as_str)).collect();
        in_every_c("hosts_excess", &flags, |spec| {
            (doubles || !is_double(spec)).then_some("is computed with more digits")
        });
    }
}

/// The header in C++ requires the same.
#[test]
fn cpp_refuses_fast_math() {
    let folder = folder("hosts_cpp");
    let spec = spec(&[("n", "3"), ("mu", "exp"), ("name", "plain")]);
    write(&folder, &spec, Language::Cpp);
    let main = folder.join("main.cpp");
    std::fs::write(&main, "#include \"plain.hpp\"\nint main() { return 0; }\n").expect("a file");
    let cpp = || Command::new(std::env::var_os("CXX").unwrap_or_else(|| "g++".into()));
    for (flag, taken) in [("-ffast-math", false), ("-ffinite-math-only", false), ("-O2", true)] {
        let (done, told) = compiled(cpp(), &main, &["-std=c++17", flag]);
        assert_eq!(done, taken, "{flag}: {told}");
        assert_eq!(told.contains("the guards need NaN"), !taken, "{flag}: {told}");
    }
}

/// Calls with every kind of number, whose statuses and bits are printed.
const CALLS: &str = r#"#include "plain.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(void)
{
    const double odd[] = { 0.0, 1.0, -1e300, NAN, INFINITY, -INFINITY, 1e-310 };
    for (int i = 0; i < 7; i++) {
        for (int j = 0; j < 7; j++) {
            const plain_params p = { .tau = 1.0, .t0 = odd[j] * 0.01, .eps = 0.1, .u_max = 1e9, .a = 1.0, .k = { 60.0, 47.0, 12.0 } };
            const double x[3] = { odd[i], odd[j], 0.5 };
            plain c;
            double u = 7.0;
            unsigned long long bits;
            memset(&c, 0, sizeof c);
            printf("%d ", (int)plain_init(&c, &p));
            printf("%d ", (int)plain_step(&c, odd[j], x, &u));
            memcpy(&bits, &u, sizeof bits);
            printf("%llx\n", bits);
        }
    }
    return 0;
}
"#;

/// Without a macro in `math.h`, or with one that warns, the file uses its own tests for finite numbers.
#[test]
fn own_tests_for_finite_numbers_agree_with_the_library() {
    let folder = folder("hosts_finite");
    let spec = spec(&[("n", "3"), ("mu", "exp"), ("name", "plain")]);
    write(&folder, &spec, Language::C);
    let main = folder.join("main.c");
    std::fs::write(&main, CALLS).expect("a file");
    let outputs = [None, Some("-D__MINGW32__")].map(|flag| {
        let program = folder.join(if flag.is_some() { "own" } else { "library" });
        let mut compiler = c_compiler();
        compiler.args(STRICT).args(flag).arg(&main).arg(folder.join("plain.c"));
        run(compiler.arg("-o").arg(&program).arg("-lm"));
        run(&mut Command::new(&program))
    });
    assert_eq!(outputs[0], outputs[1]);
    let told = String::from_utf8_lossy(&outputs[0]);
    assert!(told.contains("-1 ") && told.contains("0 -2 0"), "{told}");
}

/// Returns true for a design that is refused; the C of any other compiles after the headers `before`.
fn refused(keys: &[(&str, &str)], test: &str, before: &str) -> bool {
    let folder = folder(test);
    let Some(files) =
        support::specs::legal(keys).and_then(|spec| generate(&spec, Language::C).ok())
    else {
        return true;
    };
    for file in &files {
        std::fs::write(folder.join(&file.name), &file.text).expect("a file");
    }
    let main = folder.join("main.c");
    let name = keys.iter().find(|(key, _)| *key == "name").map_or("", |(_, name)| name);
    std::fs::write(&main, format!("{before}\n#include \"{name}.h\"\n")).expect("a file");
    for dialect in ["-std=gnu17", "-std=c99"] {
        for file in [folder.join(format!("{name}.c")), main.clone()] {
            let (taken, told) = compiled(c_compiler(), &file, &[dialect]);
            assert!(taken, "{keys:?} {before} {dialect}: {told}");
        }
    }
    false
}

/// Headers that a program reads before that of a controller.
const HEADERS: [&str; 3] = [
    "#include <complex.h>",
    "#include <tgmath.h>",
    "#include <stdlib.h>\n#include <string.h>\n#include <strings.h>\n#include <unistd.h>\n#include <stdio.h>\n#include <errno.h>\n#include <float.h>\n#include <limits.h>\n#include <time.h>\n#include <signal.h>\n#include <sys/stat.h>",
];

#[test]
fn names_of_hosts_are_refused_or_compile() {
    let names = [
        "M_PI",
        "linux",
        "unix",
        "math_errhandling",
        "I",
        "near",
        "far",
        "IN",
        "OUT",
        "ERROR",
        "CONST",
        "TRUE",
        "ERANGE",
        "errno",
        "B1",
        "SP",
        "EOF",
        "DBL_MAX",
        "FLT_RADIX",
        "J",
        "inertia",
        "index",
        "div",
        "abs_1",
        "read",
    ];
    for name in names {
        let gain = format!("1/{name}");
        let keys =
            [("n", "2"), ("mu", "exp(a=1)"), ("gains", "20,9"), ("g", &gain), ("name", "ctl")];
        let outcomes = HEADERS.map(|header| self::refused(&keys, "hosts_names", header));
        assert!(outcomes.iter().all(|one| *one == outcomes[0]), "{name}");
        assert_eq!(
            outcomes[0],
            !["J", "inertia", "index", "div", "abs_1", "read"].contains(&name),
            "{name}"
        );
    }
    for name in
        ["linux", "unix", "M_PI", "index", "div", "abs", "read", "I", "stage", "time_now", "sync"]
    {
        let keys = [("n", "2"), ("mu", "exp"), ("name", name)];
        let outcomes = HEADERS.map(|header| self::refused(&keys, "hosts_controllers", header));
        assert!(outcomes.iter().all(|one| *one == outcomes[0]), "{name}");
        assert_eq!(outcomes[0], !["stage", "time_now"].contains(&name), "{name}");
    }
}

/// A macro that no table lists stops the compiler, with the name that it replaces.
#[test]
fn a_macro_in_place_of_a_parameter_stops_the_compiler() {
    let folder = folder("hosts_macro");
    let spec =
        spec(&[("n", "2"), ("mu", "exp(a=1)"), ("gains", "20,9"), ("g", "1/J"), ("name", "ctl")]);
    for language in [Language::C, Language::Cpp] {
        write(&folder, &spec, language);
    }
    for (header, compiler, flags) in
        [("ctl.h", "gcc", &["-x", "c"][..]), ("ctl.hpp", "g++", &["-x", "c++", "-std=c++17"])]
    {
        let main = folder.join("main.txt");
        std::fs::write(&main, format!("#define J 3\n#include \"{header}\"\n")).expect("a file");
        let (taken, told) = compiled(Command::new(compiler), &main, flags);
        assert!(!taken && told.contains("a macro J takes the place of the parameter J"), "{told}");
    }
}

/// Two controllers of one name: the second header is not left out in silence, and one header may be read twice.
#[test]
fn header_guards_tell_headers_of_one_name_apart() {
    let folder = folder("hosts_guards");
    for (at, n) in [("a", "2"), ("b", "3")] {
        let home = folder.join(at);
        std::fs::create_dir_all(&home).expect("a folder");
        let spec = spec(&[("n", n), ("mu", "exp"), ("name", "ctl")]);
        for language in [Language::C, Language::Cpp] {
            write(&home, &spec, language);
        }
    }
    for (header, compiler, flags) in
        [("ctl.h", "gcc", &["-x", "c"][..]), ("ctl.hpp", "g++", &["-x", "c++", "-std=c++17"])]
    {
        for (second, taken) in [("a", true), ("b", false)] {
            let main = folder.join("main.txt");
            let text = format!("#include \"a/{header}\"\n#include \"{second}/{header}\"\n");
            std::fs::write(&main, text).expect("a file");
            let (done, told) = compiled(Command::new(compiler), &main, flags);
            assert_eq!(done, taken, "{told}");
        }
    }
}

/// A constant on which a method is called has a type in Rust.
#[test]
fn rust_with_constants_that_are_zero_compiles() {
    let folder = folder("hosts_rust");
    let designs: [&[(&str, &str)]; 4] = [
        &[("n", "2"), ("mu", "exp"), ("gains", "20,9"), ("f", "-c*x2"), ("params.c", "0")],
        &[("n", "2"), ("mu", "exp"), ("gains", "20,0"), ("allow", "growth")],
        &[
            ("n", "2"),
            ("mu", "tanh"),
            ("gains", "20,9"),
            ("f", "abs(c)*x2 - sign(c)"),
            ("params.c", "0"),
        ],
        &[
            ("n", "1"),
            ("mu", "rational"),
            ("gains", "2"),
            ("g", "1 + abs(c*x1)"),
            ("params.c", "0"),
        ],
    ];
    for (index, keys) in designs.iter().enumerate() {
        for precision in ["f64", "f32"] {
            let name = format!("zero{index}_{precision}");
            let spec = spec(&[keys, &[("precision", precision), ("name", &*name)][..]].concat());
            let files = write(&folder, &spec, Language::Rust);
            run(rustc()
                .args(["--crate-type", "lib", "--emit", "metadata", "--out-dir"])
                .arg(&folder)
                .args(files));
        }
    }
}
