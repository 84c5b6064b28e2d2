//! Several axes with one deadline, and plants with several inputs: C, Rust and the interpreter give the
//! same bits, and each axis those of a controller of its own, by `tick` and `axis`.

mod support;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use ptc_codegen::check::examine::examine;
use ptc_codegen::code::{Code, Instance};
use ptc_codegen::controller::{self, Controller};
use ptc_codegen::emit::Language;
use ptc_codegen::law::Law;
use ptc_codegen::lower::lower;
use ptc_codegen::parameter::{Parameter, Precision};
use ptc_codegen::program::passes;
use ptc_codegen::request::Spec;
use support::random::Random;
use support::specs::spec;
use support::{STRICT, c_compiler, folder, run, rustc, write};

const CALLS: usize = 200;

/// Shared and own gains, limits and input gains, references, both precisions, and guards that trust.
fn specs() -> Vec<Spec> {
    let own: [(&str, &str); 8] = [
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("tau", "1"),
        ("t0", "0"),
        ("eps", "1e-2"),
        ("poles", "[[-3,-4],[-5,-6],[-7,-8]]"),
        ("limits", "20,30,0.5"),
        ("g", "[2, b, 1]"),
    ];
    let with = |keys: &[(&str, &str)], further: &[(&str, &str)]| spec(&[keys, further].concat());
    vec![
        with(&[("n", "3"), ("mu", "exp")], &[("axes", "3"), ("name", "shared")]),
        with(
            &[("n", "2"), ("mu", "rational")],
            &[("axes", "1"), ("name", "alone"), ("limits", "5")],
        ),
        with(&own, &[("axes", "3"), ("name", "own")]),
        with(&own, &[("axes", "3"), ("name", "follows"), ("reference", "input")]),
        with(&own, &[("axes", "3"), ("name", "small"), ("precision", "f32")]),
        with(&own, &[("axes", "3"), ("name", "trusting"), ("guard", "none")]),
        with(&own, &[("axes", "3"), ("name", "half_trusting"), ("guard", "result")]),
        with(
            &[("n", "2"), ("mu", "tanh(a=0.5)"), ("gains", "[[20,9],[42,13]]")],
            &[("axes", "2"), ("name", "two"), ("u_max", "inf"), ("g", "1/mass")],
        ),
    ]
}

/// Outputs of different orders, of three at once, and of a mechanical plant, with the same ways to ask. The
/// matrix of the first is singular at 0.
fn coupled() -> Vec<Spec> {
    let mixed: [(&str, &str); 9] = [
        ("mu", "exp(a=1)"),
        ("tau", "1"),
        ("t0", "0"),
        ("eps", "1e-2"),
        ("poles", "[[-3,-4],[-5]]"),
        ("states", "p, v, h"),
        ("inputs", "a, b"),
        ("outputs", "p, h"),
        ("dynamics", "v, -v + p*a + h*b, v*h + h*a + (2 + h^2)*b"),
    ];
    let with = |keys: &[(&str, &str)], further: &[(&str, &str)]| {
        spec(&[keys, &[("allow", "zeros")], further].concat())
    };
    let unruled: Vec<_> = mixed.into_iter().filter(|(key, _)| *key != "poles").collect();
    vec![
        with(&mixed, &[("name", "mixed")]),
        with(&mixed, &[("name", "mixed_small"), ("precision", "f32"), ("limits", "20,0.5")]),
        with(&mixed, &[("name", "mixed_trusting"), ("guard", "none"), ("u_max", "inf")]),
        with(&mixed, &[("name", "mixed_half"), ("guard", "result")]),
        spec(&[
            ("mu", "rational"),
            ("name", "three"),
            ("states", "p, q, r"),
            ("inputs", "a, b, c"),
            ("outputs", "p, q, r"),
            ("dynamics", "m*a + p*b + q*c + q^2, r*a + 4*b + p*c - p*r, q*a + r*b + 5*c"),
        ]),
        spec(&[
            ("mu", "tanh(a=0.5)"),
            ("name", "arm"),
            ("poles", "[[-3,-4],[-5,-6]]"),
            ("states", "p, q, v, w"),
            ("inputs", "a, b"),
            ("inertia", "[[2 + q^2, q], [q, m]]"),
            ("bias", "v*w*q, -v^2 + 9.81*p"),
        ]),
        // Laws of all outputs, one with time and a wall, of outputs of different orders and of an arm.
        with(
            &unruled,
            &[
                ("name", "mixed_laws"),
                (
                    "pi0",
                    "-12*xi1_1 - 7*xi2_1 + xi1_2*sin(t) - h*T, -5*xi1_2*(1 + kappa_rate*xi1_1^2)",
                ),
            ],
        ),
        // Outputs that follow: what each call is given, with rows of different lengths, and expressions.
        with(&mixed, &[("name", "mixed_follows"), ("reference", "input")]),
        with(
            &mixed,
            &[("name", "mixed_follows_half"), ("reference", "input"), ("guard", "result")],
        ),
        with(&mixed, &[("name", "mixed_targets"), ("reference", "amp*sin(2*t), exp(-dt)")]),
        with(
            &unruled,
            &[
                ("name", "mixed_follows_laws"),
                ("reference", "input"),
                ("pi0", "-12*xi1_1 - 7*xi2_1 + sin(xi1_2), -5*xi1_2*(1 + x1_1^2)"),
            ],
        ),
        spec(&[
            ("mu", "tanh(a=0.5)"),
            ("name", "arm_follows"),
            ("poles", "[[-3,-4],[-5,-6]]"),
            ("reference", "input"),
            ("precision", "f32"),
            ("states", "p, q, v, w"),
            ("inputs", "a, b"),
            ("inertia", "[[2 + q^2, q], [q, m]]"),
            ("bias", "v*w*q, -v^2 + 9.81*p"),
        ]),
        // A law of all outputs that each call is given.
        with(&unruled, &[("name", "mixed_extern"), ("pi0", "extern"), ("reference", "input")]),
        with(
            &unruled,
            &[
                ("name", "mixed_extern_small"),
                ("pi0", "extern"),
                ("precision", "f32"),
                ("limits", "20,3"),
            ],
        ),
        spec(&[
            ("mu", "rational(a=2)"),
            ("name", "guarded"),
            (
                "pi0",
                "inverse_inertia_1_1*(-k*xi1_1/(1 - xi1_1^2/9) - xi2_1), inverse_inertia_2_2*bias_2 - x1_2 - 4*x2_2",
            ),
            ("states", "p, q, v, w"),
            ("inputs", "a, b"),
            ("inertia", "[[2 + q^2, q], [q, m]]"),
            ("bias", "v*w*q, -v^2 + 9.81*p"),
        ]),
    ]
}

/// The law of both outputs that is given to those that have none of their own, as C and Rust write it. It
/// knows the chain of the other output, time and kappa', and has no sum whose order is not written.
const LAW: [&str; 2] =
    ["(xi[2] - (2.0F * xi[0])) - (t * xi[1])", "xi[0] * (rate - (3.0F * xi[2]))"];

fn law(xi: &[f64], t: f64, small: bool) -> f64 {
    let settled = |value: f64| match small {
        #[allow(clippy::cast_possible_truncation)]
        true => f64::from(value as f32),
        false => value,
    };
    let [a, b, c, rate, place] = xi[..] else { panic!("the law is given {xi:?}") };
    if place == 0.0 {
        let left = settled(c - settled(2.0 * a));
        return settled(left - settled(t * b));
    }
    settled(a * settled(rate - settled(3.0 * c)))
}

fn is_extern(spec: &Spec) -> bool {
    spec.feedback == ptc_codegen::request::Feedback::Extern
}

/// Times and numbers of a call: the states of all axes, and behind them their references.
struct Call {
    t: f64,
    x: Vec<f64>,
    r: Vec<f64>,
}

fn calls(spec: &Spec, count: usize) -> Vec<Call> {
    let mut random = Random(7);
    let settled = |value: f64| match spec.precision {
        Precision::F64 => value,
        #[allow(clippy::cast_possible_truncation)]
        Precision::F32 => f64::from(value as f32),
    };
    let checked = spec.guard == ptc_codegen::request::Guard::Full;
    let mut call = |index: usize| {
        let mut numbers = |length| -> Vec<f64> {
            (0..length).map(|_| settled(random.between(-2.0, 2.0))).collect()
        };
        let states = if spec.coupled.is_some() { spec.states() } else { count * spec.n };
        let (mut x, mut r) = (numbers(states), numbers(count * spec.references()));
        if checked && index % 11 == 3 {
            x[(index / 11) % states] = f64::NAN;
        }
        if checked && index % 19 == 8 && !r.is_empty() {
            // Of outputs of different orders some are not read.
            let length = r.len();
            r[(index / 19) % length] = f64::NAN;
        }
        if index % 13 == 6 {
            x.fill(0.0);
        }
        let early = if checked && index % 17 == 5 { -1.0 } else { 1.0 };
        Call { t: settled(early * random.between(0.0, 1.2)), x, r }
    };
    (0..CALLS).map(&mut call).collect()
}

fn parameters(spec: &Spec) -> Vec<(Parameter, f64)> {
    let value = |parameter| match parameter {
        Parameter::StartTime => 0.0,
        Parameter::Eps => 0.015625,
        Parameter::UMax => 24.0,
        Parameter::Gain(i) => 10.0 + f64::from(u32::try_from(i).expect("a small number")),
        Parameter::Named(_) => 1.75,
        _ => 1.0,
    };
    spec.run_time_parameters().map(|parameter| (parameter, value(parameter))).collect()
}

/// All u by their bits, the status of each axis, and that of the call.
type Given = (Vec<u64>, Vec<i64>, i64);

fn whole(spec: &Spec, work: impl FnOnce(&Code)) {
    let (report, law) = (examine(spec), Law::of(spec));
    let program = passes::optimise(lower(spec, &law), &mut |_, _| {});
    assert_eq!(program.check(), Ok(()));
    let controller = Controller { report: &report, law: &law, program: &program, measured: &[] };
    work(&controller::whole(&controller));
}

fn interpreted(spec: &Spec, calls: &[Call]) -> Vec<Given> {
    let mut all = Vec::new();
    whole(spec, |code| {
        let mut controller = Instance::with_parameters(code, parameters(spec)).expect("legal");
        for call in calls {
            let small = spec.precision == Precision::F32;
            let own = |xi: &[f64], t: f64| law(xi, t, small);
            let given: [(_, &[f64]); 3] = [("t", &[call.t]), ("x", &call.x), ("r", &call.r)];
            let found = controller.call_with("step", &given, &[("pi0", &own)]);
            let u = found.results["u"].iter().map(|u| u.to_bits()).collect();
            #[allow(clippy::cast_possible_truncation)]
            let axes = found.results["axes"].iter().map(|status| *status as i64).collect();
            all.push((u, axes, i64::from(found.status.number())));
        }
    });
    all
}

/// u and status of one axis by a controller of its own.
fn alone(spec: &Spec, index: usize, calls: &[Call]) -> Vec<(u64, i64)> {
    let one = spec.axis(index);
    let mut all = Vec::new();
    whole(&one, |code| {
        let controller = Instance::with_parameters(code, parameters(&one)).expect("legal");
        for call in calls {
            let mut controller = controller.clone();
            let gains = controller.call("tick", &[("t", &[call.t])]);
            if gains.status.number() < 0 {
                all.push((0, i64::from(gains.status.number())));
                continue;
            }
            let part = |values: &[f64], length: usize| {
                values[length * index..length * (index + 1)].to_vec()
            };
            let (x, r) = (part(&call.x, one.n), part(&call.r, one.references()));
            let found = controller.gains(&gains).call("axis", &[("x", &x), ("r", &r)]);
            let u = found.results.get("u").map_or(0.0, |u| u[0]);
            all.push((u.to_bits(), i64::from(found.status.number())));
        }
    });
    all
}

/// A number as both languages write it, or what stands for no number.
fn written(value: f64, nan: &str, suffix: &str) -> String {
    if value.is_nan() { nan.to_owned() } else { format!("{value:?}{suffix}") }
}

fn list(values: &[f64], nan: &str, suffix: &str, (open, close): (&str, &str)) -> String {
    let values: Vec<_> = values.iter().map(|value| written(*value, nan, suffix)).collect();
    format!("{open}{}{close}", values.join(", "))
}

/// The states: a list of those of each axis, or those of one plant.
fn states(spec: &Spec, x: &[f64], nan: &str, suffix: &str, ends: (&str, &str)) -> String {
    match spec.coupled {
        Some(_) => list(x, nan, suffix, ends),
        None => lists(x, spec.n, nan, suffix, ends),
    }
}

fn lists(values: &[f64], length: usize, nan: &str, suffix: &str, ends: (&str, &str)) -> String {
    let rows: Vec<_> =
        values.chunks(length.max(1)).map(|row| list(row, nan, suffix, ends)).collect();
    format!("{}{}{}", ends.0, rows.join(", "), ends.1)
}

/// The parameters as members of a structure, arrays together.
fn members(spec: &Spec, assign: &str, ends: (&str, &str), suffix: &str) -> String {
    let all = parameters(spec);
    let groups = all.chunk_by(|a, b| a.0.key() == b.0.key());
    let member = |group: &[(Parameter, f64)]| {
        let values: Vec<_> = group.iter().map(|(_, value)| *value).collect();
        let value = match group[0].0.index() {
            Some(_) => list(&values, "", suffix, ends),
            None => written(values[0], "", suffix),
        };
        format!("{}{assign}{value}", group[0].0.key())
    };
    groups.map(member).collect::<Vec<_>>().join(", ")
}

fn in_c(folder: &Path, spec: &Spec, calls: &[Call], count: usize) -> Vec<Given> {
    write(folder, spec, Language::C);
    let name = spec.name();
    let (real, integer, suffix) = match spec.precision {
        Precision::F64 => ("double", "uint64_t", ""),
        Precision::F32 => ("float", "uint32_t", "f"),
    };
    let ends = ("{", "}");
    let members = members(spec, " = ", ends, suffix);
    let named = members.split(", ").map(|m| match m.contains(" = ") {
        true => format!(".{m}"),
        false => m.to_owned(),
    });
    // C has no struct without a field.
    let fields = match members.is_empty() {
        true => ".none = 0".to_owned(),
        false => named.collect::<Vec<_>>().join(", "),
    };
    let mut text = format!(
        "#include \"{name}.h\"\n#include <inttypes.h>\n#include <math.h>\n#include <stdio.h>\n#include <string.h>\n\nint main(void)\n{{\n    static {name} c;\n    const {name}_params p = {{ {} }};\n    ptc_status axes[{count}];\n    {real} u[{count}];\n    if ({name}_init(&c, &p) != PTC_OK) {{ return 1; }}\n",
        fields
    );
    if is_extern(spec) {
        let [first, second] = LAW.map(|law| law.replace('F', suffix));
        let law = format!(
            "static void law(void *context, const {real} xi[3], {real} t, {real} rate, {real} pi0[2])\n{{\n    (void)context;\n    pi0[0] = {first};\n    pi0[1] = {second};\n}}\n\nint main("
        );
        text = text.replacen("int main(", &law, 1);
    }
    let called = if is_extern(spec) { "law, NULL, " } else { "" };
    for call in calls {
        let reference = spec.references();
        let x = states(spec, &call.x, "NAN", suffix, ends);
        let shape = match spec.coupled {
            Some(_) => format!("[{}]", spec.states()),
            None => format!("[{count}][{}]", spec.n),
        };
        let (declared, given) = match reference {
            0 => (String::new(), ""),
            length => {
                let r = lists(&call.r, length, "NAN", suffix, ends);
                (format!("const {real} r[{count}][{length}] = {r};"), "r, ")
            }
        };
        let t = written(call.t, "NAN", suffix);
        let _ = writeln!(
            text,
            "    {{ const {real} x{shape} = {x}; {declared}\n      printf(\"%d\", (int){name}_step(&c, {t}, x, {given}{called}u, axes)); }}\n    for (int i = 0; i < {count}; i++) {{ {integer} bits; memcpy(&bits, &u[i], sizeof bits); printf(\" %\" PRIu64 \" %d\", (uint64_t)bits, (int)axes[i]); }}\n    printf(\"\\n\");"
        );
    }
    text.push_str("    return 0;\n}\n");
    let (main, binary) = (folder.join("main.c"), folder.join("in_c"));
    fs::write(&main, text).expect("a file");
    let source = folder.join(format!("{name}.c"));
    run(c_compiler().args(STRICT).arg(&main).arg(&source).arg("-lm").arg("-o").arg(&binary));
    read(spec, &run(&mut std::process::Command::new(binary)))
}

fn in_rust(folder: &Path, spec: &Spec, calls: &[Call], count: usize) -> Vec<Given> {
    write(folder, spec, Language::Rust);
    let (name, kind) = (spec.name(), spec.type_name());
    let real = match spec.precision {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    };
    let (nan, ends) = (format!("{real}::NAN"), ("[", "]"));
    let mut text = format!(
        "#![allow(dead_code)]\nmod {name};\nuse {name}::*;\nfn number(status: Result<Status, Error>) -> i32 {{ match status {{ Ok(Status::Ok) => 0, Ok(Status::Hold) => 1, Ok(Status::Saturated) => 2, Ok(Status::After) => 3, Err(Error::Param) => -1, Err(Error::Input) => -2, Err(Error::Range) => -3 }} }}\nfn show(all: Axes<{count}, {real}>) {{ print!(\"{{}}\", number(all.status)); for i in 0..{count} {{ print!(\" {{}} {{}}\", all.u[i].to_bits(), number(all.axes[i])); }} println!(); }}\nfn main() {{\n    let c = {kind}::new({kind}Params {{ {} }}).expect(\"legal\");\n",
        members(spec, ": ", ends, "")
    );
    for call in calls {
        let x = states(spec, &call.x, &nan, "", ends);
        let reference = match spec.references() {
            0 => String::new(),
            length => format!(", &{}", lists(&call.r, length, &nan, "", ends)),
        };
        let t = written(call.t, &nan, "");
        let [first, second] = LAW.map(|law| law.replace('F', ""));
        let called = match is_extern(spec) {
            true => format!(", |xi, t, rate| [{first}, {second}]"),
            false => String::new(),
        };
        let _ = writeln!(text, "    show(c.step({t}, &{x}{reference}{called}));");
    }
    text.push_str("}\n");
    let (main, binary) = (folder.join("main.rs"), folder.join("in_rust"));
    fs::write(&main, text).expect("a file");
    run(rustc().arg(&main).arg("-o").arg(&binary));
    read(spec, &run(&mut std::process::Command::new(binary)))
}

/// The lines of a program; floats become doubles, as the interpreter has them.
fn read(spec: &Spec, text: &[u8]) -> Vec<Given> {
    let widened = |bits: u64| match spec.precision {
        Precision::F64 => bits,
        Precision::F32 => {
            f64::from(f32::from_bits(u32::try_from(bits).expect("32 bits"))).to_bits()
        }
    };
    let line = |line: &str| {
        let mut words = line.split(' ');
        let status = words.next().and_then(|word| word.parse().ok()).expect("a status");
        let (mut u, mut axes) = (Vec::new(), Vec::new());
        while let (Some(bits), Some(axis)) = (words.next(), words.next()) {
            u.push(widened(bits.parse().expect("bits")));
            axes.push(axis.parse().expect("a status"));
        }
        (u, axes, status)
    };
    String::from_utf8_lossy(text).lines().map(line).collect()
}

#[test]
fn axes_give_the_same_bits_everywhere() {
    let mut seen = std::collections::BTreeSet::new();
    for spec in specs().into_iter().chain(coupled()) {
        let count = spec.axes.as_ref().expect("axes").count;
        let calls = calls(&spec, count);
        let folder = folder(&format!("axes_{}", spec.name()));
        let wanted = interpreted(&spec, &calls);
        for (language, found) in [
            ("C", in_c(&folder, &spec, &calls, count)),
            ("Rust", in_rust(&folder, &spec, &calls, count)),
        ] {
            assert_eq!(found.len(), wanted.len());
            for (index, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
                assert_eq!(found, wanted, "{language}, call {index} of {}", spec.name());
            }
        }
        let chains = if spec.coupled.is_some() { 0 } else { count };
        for axis in 0..chains {
            let alone = alone(&spec, axis, &calls);
            for (index, ((u, axes, status), (own, own_status))) in
                wanted.iter().zip(&alone).enumerate()
            {
                let name = spec.name();
                assert_eq!(axes[axis], *own_status, "axis {axis}, call {index} of {name}");
                let u_wanted = if *status < 0 { 0 } else { *own };
                assert_eq!(u[axis], u_wanted, "axis {axis}, call {index} of {name}");
            }
        }
        for (u, axes, status) in &wanted {
            let failed = axes.iter().find(|status| **status < 0);
            let clipped = axes.iter().find(|status| **status == 2);
            let known = failed.or(clipped).unwrap_or(&axes[0]);
            assert_eq!(status, known, "{axes:?}");
            assert!(*status >= 0 || u.iter().all(|u| *u == 0), "{u:?}");
            seen.insert(*status);
        }
    }
    assert_eq!(seen, [-3, -2, 0, 1, 2].into());
}

/// An axis that is none is refused whatever is trusted.
#[test]
fn the_number_of_an_axis_is_checked() {
    for spec in specs().iter().filter(|spec| spec.axes.as_ref().is_some_and(|a| a.differ())) {
        whole(spec, |code| {
            let mut controller = Instance::with_parameters(code, parameters(spec)).expect("legal");
            let gains = controller.call("tick", &[("t", &[0.5])]);
            let (x, r) = (vec![1.0; spec.n], vec![0.0; spec.references()]);
            let mut gains = controller.gains(&gains);
            let count = spec.axes.as_ref().expect("axes").count;
            for (axis, legal) in [(0.0, true), (count as f64, false)] {
                let found = gains.call("axis", &[("axis", &[axis]), ("x", &x), ("r", &r)]);
                assert_eq!(found.status.number() >= 0, legal, "{}", spec.name());
            }
        });
    }
}
