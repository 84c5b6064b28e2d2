//! Named intermediate values of a model: the same law as without them, and what is wrong with them.

use std::fmt::Write;
use std::time::{Duration, Instant};

use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::{example, folder_with, run_in, spec};

/// A pendulum with a motor, whose expressions `{..}` a test fills in.
const PENDULUM: &str = "name = \"pendulum\"
mu = \"exp(a=1)\"
poles = [-3, -4]
[params]
tau = 2
t0 = 0
eps = 0.02
u_max = inf
m = 1.5
[model]
states = [\"q\", \"w\"]
input = \"u\"
output = \"q\"
";

const RATES: &str = "dynamics = { q = \"w\", w = \"u/D - 9.81*s + w^2*s*c\" }\n";

fn pendulum(values: &str, rates: &str) -> String {
    format!("{PENDULUM}{values}\n{rates}")
}

/// The C of a design behind its head, which has the command.
fn code(spec: &Spec) -> String {
    let files = ptc_codegen::generate(spec, Language::C).expect("accepted");
    let source = files.iter().find(|file| file.name.ends_with(".c")).expect("a source");
    source.text.split_once("#include").expect("code behind a head").1.to_owned()
}

#[test]
fn named_values_give_the_code_of_shared_parts() {
    let values = "let = { s = \"sin(q)\", c = \"cos(q)\", D = \"m*(2 + c^2)\" }";
    let named = spec(&pendulum(values, RATES));
    let written = RATES
        .replace('D', "(m*(2 + c^2))")
        .replace("*s", "*sin(q)")
        .replace("*c", "*cos(q)")
        .replace("c^2", "cos(q)^2");
    assert!(!written.contains('D') && written.contains("(2 + cos(q)^2)"), "{written}");
    assert_eq!(code(&named), code(&spec(&pendulum("", &written))));
    for text in ["s = sin(q)", "D = m*(2 + c^2)", "w' = u/D - 981/100*s + w^2*s*c"] {
        let lines = named.model.as_ref().expect("a model").lines();
        assert!(lines.iter().any(|line| line == text), "{text}: {lines:?}");
    }
}

#[test]
fn command_gives_the_design_back() {
    let arm = arm(3);
    let values = "let = { s = \"sin(q)\", c = \"cos(q)\", D = \"m*(2 + c^2)\" }";
    let law =
        pendulum(values, RATES).replace("poles = [-3, -4]", "pi0 = \"-12*xi1 - 7*xi2 - s*xi1^2\"");
    for text in [pendulum(values, RATES), law, arm] {
        let own = spec(&text);
        let command = own.command();
        assert!(command.contains("--let=\"{"), "{command}");
        let again = crate::command::spec_of(&command).expect("a legal command");
        assert_eq!(again, own);
        assert_eq!(again.fingerprint(), own.fingerprint());
    }
}

/// A planar arm of links of 1 m with 1 kg at their ends, from absolute angles and forces that add up.
fn arm(n: usize) -> String {
    let mut values = String::new();
    let mut add = |name: String, value: String| {
        write!(values, "{}{name} = \"{value}\"", if values.is_empty() { "" } else { ", " })
            .expect("text");
    };
    let more = |name: &str, i: usize, there: bool| match there {
        true => format!(" + {name}{i}"),
        false => String::new(),
    };
    for i in 1..=n {
        let before = |name: &str| more(name, i.max(1) - 1, i > 1);
        add(format!("a{i}"), format!("q{i}{}", before("a")));
        add(format!("v{i}"), format!("w{i}{}", before("v")));
        add(format!("s{i}"), format!("sin(a{i})"));
        add(format!("c{i}"), format!("cos(a{i})"));
        add(format!("ax{i}"), format!("-c{i}*v{i}^2{}", before("ax")));
        let fall = if i > 1 { before("ay") } else { " + 9.81".to_owned() };
        add(format!("ay{i}"), format!("-s{i}*v{i}^2{fall}"));
    }
    for i in (1..=n).rev() {
        add(format!("fx{i}"), format!("ax{i}{}", more("fx", i + 1, i < n)));
        add(format!("fy{i}"), format!("ay{i}{}", more("fy", i + 1, i < n)));
        add(format!("b{i}"), format!("c{i}*fy{i} - s{i}*fx{i}{}", more("b", i + 1, i < n)));
    }
    let entry = |i: usize, j: usize| {
        let term = |k: usize, l: usize| format!("{}*(c{k}*c{l} + s{k}*s{l})", n + 1 - k.max(l));
        let terms = (i..=n).flat_map(|k| (j..=n).map(move |l| term(k, l)));
        format!("\"{}\"", terms.collect::<Vec<_>>().join(" + "))
    };
    let rows = (1..=n)
        .map(|i| format!("[{}]", (1..=n).map(|j| entry(i, j)).collect::<Vec<_>>().join(", ")));
    let list = |text: &dyn Fn(usize) -> String| {
        (1..=n).map(|i| format!("\"{}\"", text(i))).collect::<Vec<_>>().join(", ")
    };
    format!(
        "name = \"arm\"\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n[params]\ntau = 2\nt0 = 0\neps = 0.02\nu_max = inf\n\
         [model]\nstates = [{}, {}]\ninputs = [{}]\nlet = {{ {values} }}\ninertia = [{}]\nbias = [{}]\n",
        list(&|i| format!("q{i}")),
        list(&|i| format!("w{i}")),
        list(&|i| format!("M{i}")),
        rows.collect::<Vec<_>>().join(", "),
        list(&|i| format!("b{i}")),
    )
}

/// The torques that give an arm the accelerations that the law wants, by the recursion of Newton and Euler.
fn torques(x: &[f64], to_go: f64) -> Vec<f64> {
    let n = x.len() / 2;
    let (mut angle, mut rate, mut turn) = (0.0, 0.0, 0.0);
    let (mut ax, mut ay) = (0.0, 9.81);
    let mut links = Vec::new();
    for i in 0..n {
        // Poles at -3 and -4 of exp: T^2 q'' = -12 q - 6 T q'.
        let wanted = -12.0 * x[i] / (to_go * to_go) - 6.0 * x[n + i] / to_go;
        (angle, rate, turn) = (angle + x[i], rate + x[n + i], turn + wanted);
        let (s, c) = (f64::sin(angle), f64::cos(angle));
        ax -= turn * s + rate * rate * c;
        ay += turn * c - rate * rate * s;
        links.push((s, c, ax, ay));
    }
    let (mut fx, mut fy, mut torque) = (0.0, 0.0, 0.0);
    let mut all: Vec<_> = links
        .into_iter()
        .rev()
        .map(|(s, c, ax, ay)| {
            (fx, fy) = (fx + ax, fy + ay);
            torque += c * fy - s * fx;
            torque
        })
        .collect();
    all.reverse();
    all
}

/// The last row of a run that ends where it starts: tau, t, the states and the inputs.
fn start(test: &str, design: &str, further: &[&str]) -> Vec<f64> {
    let folder = folder_with(&format!("intermediates_{test}"), "plant.toml", design);
    let (code, csv, stderr) = run_in(&folder, &[&["simulate", "plant.toml"], further].concat());
    assert_eq!(code, Some(0), "{stderr}");
    let row = csv.lines().last().expect("a row");
    row.split(',').map(|cell| cell.parse().expect("a number")).collect()
}

#[test]
fn torques_of_an_arm_follow_from_newton_and_euler() {
    for n in [2, 3, 6, 8] {
        let x: Vec<f64> = (0..2 * n).map(|i| 0.4 * f64::cos(1.7 * i as f64)).collect();
        let at: Vec<_> = x.iter().map(ToString::to_string).collect();
        let row = start(&format!("arm{n}"), &arm(n), &["--x0", &at.join(","), "--at", "0"]);
        let wanted = torques(&x, 2.0);
        let largest = wanted.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        for (found, wanted) in row[2 + 2 * n..].iter().zip(&wanted) {
            // Some hundred roundings.
            assert!((found - wanted).abs() < 1e-13 * largest, "{n}: {found}, not {wanted}");
        }
    }
}

#[test]
fn plants_use_named_values_with_their_own_parameters() {
    let values = "let = { s = \"sin(q)\", D = \"m*l^2\" }";
    let rates = "dynamics = { q = \"w\", w = \"u/D - 9.81*s\" }\n";
    let base = pendulum(values, rates).replace("m = 1.5", "m = 1.5\nl = 0.7");
    let at = ["--x0", "1,0", "--at-fraction", "0.5"];
    let differs =
        format!("{base}[plant]\nm = 1.6\ndynamics = {{ w = \"(u - 0.1*w)/D - 9.81*s\" }}\n");
    let written = format!(
        "{base}[plant]\nm = 1.6\ndynamics = {{ w = \"(u - 0.1*w)/(m*l^2) - 9.81*sin(q)\" }}\n"
    );
    let own = start("own", &base, &at);
    let [differs, written] =
        [("differs", differs), ("written", written)].map(|(test, text)| start(test, &text, &at));
    assert_eq!(differs, written);
    assert!((own[2] - differs[2]).abs() > 1e-3, "{own:?} {differs:?}");
}

#[test]
fn mistakes_have_one_message_each() {
    let good = "s = \"sin(q)\", c = \"cos(q)\", D = \"m*(2 + c^2)\"";
    for (values, wanted) in [
        (
            "D = \"m*s\", s = \"sin(q)\", c = \"q\"",
            "`D` uses the intermediate value `s`, which is defined after it",
        ),
        (
            "s = \"c*D\", D = \"m*s\", c = \"q\"",
            "the intermediate values `s`, `D` are defined by each other",
        ),
        (
            "s = \"sin(q) + s\", c = \"q\", D = \"m\"",
            "the intermediate value `s` is defined by itself",
        ),
        ("{good}, e = \"q^2\"", "nothing uses the intermediate value `e`"),
        ("{good}, q = \"w\"", "`q` is a state of the model, and an intermediate value"),
        ("{good}, u = \"w\"", "`u` is an input of the model, and an intermediate value"),
        ("{good}, m = \"w\"", "`m` is a parameter under [params], and an intermediate value"),
        ("{good}, tan = \"w\"", "`tan` cannot name an intermediate value"),
        ("{good}, tau = \"w\"", "`tau` cannot name an intermediate value"),
        // A law would read these in place of its own.
        ("{good}, xi1 = \"w\"", "`xi1` cannot name an intermediate value"),
        ("{good}, r_1 = \"w\"", "`r_1` cannot name an intermediate value"),
        ("{good}, kappa_rate = \"w\"", "`kappa_rate` cannot name an intermediate value"),
        ("{good}, e = \"foo(q)\"", "unknown function `foo`"),
        ("{good}, e = \"2*\"", "found the end where a value should be"),
    ] {
        let values = format!("let = {{ {} }}", values.replace("{good}", good));
        // What is wrong otherwise is found before what is unused.
        let used = RATES.replace("w^2*s*c", "w^2*s*c + e");
        let rates =
            if wanted.contains("nothing") || !values.contains("e = ") { RATES } else { &used };
        let found = mistakes(&pendulum(&values, rates));
        assert_eq!(found.matches("error[").count(), 1, "{values}: {found}");
        assert!(found.contains(wanted), "{wanted}: {found}");
    }
    for (values, wanted) in [
        ("let = \"s\"", "`s` is no table"),
        ("let = [\"s\", \"c\"]", "`[s, c]` is no table"),
        (
            "let = \"{s = sin(q), c = cos(q), s = q, D = m}\"",
            "the intermediate value `s` is defined twice",
        ),
        ("let = \"{s = sin(q), c = cos(q)\"", "where `,` or `}` should be"),
    ] {
        let found = mistakes(&pendulum(values, RATES));
        assert_eq!(found.matches("error[").count(), 1, "{values}: {found}");
        assert!(found.contains(wanted), "{wanted}: {found}");
    }
}

fn mistakes(design: &str) -> String {
    let folder = folder_with("intermediates_mistakes", "plant.toml", design);
    let (code, _, stderr) = run_in(&folder, &["check", "plant.toml"]);
    assert_eq!(code, Some(2), "{design}\n{stderr}");
    stderr
}

/// Where an input or the plant is not known, a named value that needs them is not either.
#[test]
fn inputs_and_references_know_no_values_of_the_plant() {
    let values = "let = { s = \"sin(q)\", c = \"cos(q)\", D = \"m*(2 + c^2)\" }";
    let driven = "let = { s = \"u + q\", c = \"cos(q)\", D = \"m\" }";
    let base = pendulum(values, RATES);
    for (text, wanted) in [
        (
            base.replace("poles", "reference = \"s*t\"\npoles"),
            "`s` is an intermediate value of the model",
        ),
        (
            pendulum(driven, RATES).replace("output = \"q\"", "output = \"s\""),
            "the output depends on the input",
        ),
        (
            pendulum(driven, RATES).replace("poles = [-3, -4]", "pi0 = \"-12*xi1 - 7*xi2 - s\""),
            "`u` is an input of the plant, which follows from pi0",
        ),
        (
            example("two_link.toml")
                .replace("[model]", "[model]\nlet = { c2 = \"w1*cos(q2)\" }")
                .replace("cos(q2)\",", "c2\","),
            "the inertia depends on the rate `w1`",
        ),
        (
            format!("n = 2\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n[model]\n{values}\n"),
            "the model has no `states`",
        ),
    ] {
        let found = mistakes(&text);
        assert!(found.contains(wanted), "{wanted}: {found}");
    }
}

/// Each value uses the one before twice: written out, the last has 2^60 parts.
#[test]
fn work_on_nested_values_is_bounded() {
    for (which, form) in [
        "{p}*{p} + 0.5",
        "sin({p}) + cos({p})*{p}",
        "{p}/(1 + {p}^2)",
        "min({p}, 2*{p})",
        "{p} - ({p} + q)*{p}",
    ]
    .into_iter()
    .enumerate()
    {
        let mut values = "a0 = \"0.1*q + w\"".to_owned();
        for i in 1..60 {
            let before = format!("a{}", i - 1);
            write!(values, ", a{i} = \"{}\"", form.replace("{p}", &before)).expect("text");
        }
        for rate in [
            "q = \"w\", w = \"a59 + u\"",
            "q = \"w\", w = \"q + (2 + tanh(a59))*u\"",
            "q = \"w + 0.1*a59\", w = \"u\"",
        ] {
            let text =
                pendulum(&format!("let = {{ {values} }}"), &format!("dynamics = {{ {rate} }}\n"));
            let text = text.replace("m = 1.5\n", "");
            let folder = folder_with(&format!("intermediates_nested_{which}"), "plant.toml", &text);
            let since = Instant::now();
            for words in [&["check", "plant.toml"][..], &["emit", "plant.toml", "--lang", "c"]] {
                let (code, _, stderr) = run_in(&folder, words);
                assert!(matches!(code, Some(0..=3)), "{form}: {code:?} {stderr}");
            }
            assert!(since.elapsed() < Duration::from_secs(60), "{form} in {rate}");
        }
    }
}
