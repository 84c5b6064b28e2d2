//! Every family, and the same mappings written down as expressions, through emitted C against the
//! reference vectors in tests/data of the repository.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use ptc_codegen::family::{FAMILIES, Family};
use ptc_codegen::parameter::Precision;
use ptc_codegen::reference::tolerance::{control, custom};
use serde_json::Value;

/// Orders that are tested.
const ORDERS: std::ops::RangeInclusive<usize> = 1..=6;

/// eps as a part of tau: below every T/tau of the data, so that nothing is held.
const EPS: f64 = 1e-13;

/// The vectors by family, number of rates and order.
fn vectors() -> BTreeMap<(Family, usize, usize), Vec<Value>> {
    let mut groups: BTreeMap<_, Vec<Value>> = BTreeMap::new();
    for file in ["vectors.jsonl", "deadline.jsonl"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data").join(file);
        for line in fs::read_to_string(&path).expect("a file of vectors").lines() {
            let line: Value = serde_json::from_str(line).expect("JSON");
            let family = FAMILIES.iter().find(|info| line["mu"] == info.name).expect("a family");
            let rates = line["params"]["rates"].as_array().map_or(0, Vec::len);
            let order = line["x"].as_array().expect("a state").len();
            if ORDERS.contains(&order) {
                groups.entry((family.family, rates, order)).or_default().push(line);
            }
        }
    }
    // Eight families, one of them with two and with three rates.
    assert_eq!(groups.len(), 9 * ORDERS.count());
    groups
}

/// A controller and the vectors that it is run on.
struct Case<'a> {
    name: String,
    /// The mapping, and the law where it is not a sum of gains.
    flags: Vec<String>,
    n: usize,
    /// Accepted |u - u_ref|/scale.
    allowed: f64,
    /// Fields of the parameters beside tau, t0, eps and u_max.
    fields: &'a dyn Fn(&Value) -> String,
    vectors: &'a [Value],
}

fn list(value: &Value) -> String {
    let items = value.as_array().expect("a list").iter().map(ToString::to_string);
    items.collect::<Vec<_>>().join(", ")
}

/// The parameters of a family and the gains.
fn own(vector: &Value) -> String {
    let params = &vector["params"];
    let mut fields = String::new();
    for key in ["a", "m", "start"] {
        if let Some(value) = params[key].as_f64() {
            let _ = write!(fields, ".{key} = {value:?}, ");
        }
    }
    if params["rates"].is_array() {
        let _ = write!(fields, ".rates = {{{}}}, ", list(&params["rates"]));
    }
    fields + &format!(".k = {{{}}}, ", list(&vector["k"]))
}

/// The same where the gains are names in a law.
fn named(vector: &Value) -> String {
    let gains = vector["k"].as_array().expect("gains").iter().enumerate();
    let gains = gains.map(|(i, k)| format!(".k{} = {k}, ", i + 1)).collect::<String>();
    let own = own(vector);
    own[..own.find(".k = ").expect("the gains")].to_owned() + &gains
}

/// Two rates that are names in a mapping, and the gains.
fn rates(vector: &Value) -> String {
    let rate = |i: usize| vector["params"]["rates"][i].as_f64().expect("a rate");
    format!(".a1 = {:?}, .a2 = {:?}, .k = {{{}}}, ", rate(0), rate(1), list(&vector["k"]))
}

impl Case<'_> {
    /// Emits the controller with the engine, and returns a C function that prints what it gives.
    fn emit(&self, folder: &Path) -> String {
        let n = self.n.to_string();
        let out = folder.to_str().expect("UTF-8");
        let mut flags = vec!["emit", "--lang", "c", "--n", &n, "--name", &self.name, "-o", out];
        flags.extend(self.flags.iter().map(String::as_str));
        super::stdout(&flags);
        let name = &self.name;
        let mut text =
            format!("static void run_{name}(void)\n{{\n    {name} c;\n    double u;\n    int s;\n");
        for vector in self.vectors {
            let number = |key: &str| format!("{:?}", vector[key].as_f64().expect("a number"));
            let tau = vector["tau"].as_f64().expect("a number");
            let _ = writeln!(
                text,
                "    {{\n        const {name}_params p = {{ {}.tau = {tau:?}, .t0 = {}, .eps = {:?}, \
                 .u_max = INFINITY }};\n        const double x[{n}] = {{{}}};\n        \
                 u = 0;\n        s = (int){name}_init(&c, &p);\n        \
                 s = s ? s : (int){name}_step(&c, {}, x, &u);\n        \
                 printf(\"%d %.17g\\n\", s, u);\n    }}",
                (self.fields)(vector),
                number("t0"),
                EPS * tau,
                list(&vector["x"]),
                number("t"),
            );
        }
        text.push_str("}\n");
        text
    }

    /// The worst error of what was printed, each line that of one vector.
    fn worst<'b>(&self, lines: &mut impl Iterator<Item = &'b str>) -> f64 {
        let real = |value: &Value| value.as_str().and_then(|s| s.parse::<f64>().ok());
        let errors = self.vectors.iter().map(|vector| {
            let line = lines.next().expect("a line for each vector");
            let (status, u) = line.split_once(' ').expect("a status and u");
            assert_eq!(status, "0", "{} on {vector}", self.name);
            let wanted = real(&vector["u"]).expect("u");
            let u: f64 = u.parse().expect("a number");
            let error = (u - wanted).abs() / real(&vector["scale"]).expect("a scale");
            if error.is_nan() { f64::INFINITY } else { error }
        });
        errors.fold(0.0, f64::max)
    }
}

/// Emits, compiles and runs the cases as one program, and judges each.
fn judge(test: &str, cases: &[Case<'_>]) {
    let folder = super::folder(test);
    let bodies: Vec<_> = cases.iter().map(|case| case.emit(&folder)).collect();
    let mut main = "#include <math.h>\n#include <stdio.h>\n".to_owned();
    let mut calls = String::new();
    for (case, body) in cases.iter().zip(&bodies) {
        let _ = write!(main, "#include \"{0}.h\"\n{body}", case.name);
        let _ = writeln!(calls, "    run_{}();", case.name);
    }
    let _ = write!(main, "int main(void)\n{{\n{calls}    return 0;\n}}\n");
    fs::write(folder.join("main.c"), main).expect("a file");
    let sources = cases.iter().map(|case| format!("{}.c", case.name));
    let compiled = Command::new("cc")
        .current_dir(&folder)
        .args([
            "-std=c99",
            "-O1",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-ffp-contract=off",
            "-o",
            "run",
            "main.c",
        ])
        .args(sources)
        .arg("-lm")
        .output()
        .expect("a C compiler");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let output = Command::new(folder.join("run")).output().expect("the program runs");
    let output = String::from_utf8(output.stdout).expect("UTF-8");
    let mut lines = output.lines();
    let mut wrong = Vec::new();
    for case in cases {
        let (worst, allowed) = (case.worst(&mut lines), case.allowed);
        println!("{:24} {worst:.1e} of {allowed:.0e}", case.name);
        if worst > allowed {
            wrong.push(format!("{} is wrong by {worst:e}", case.name));
        }
    }
    assert_eq!(lines.next(), None);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Prints the worst |u - u_ref|/scale of each.
#[test]
#[ignore = "needs the engine"]
fn every_family_at_orders_1_to_6() {
    let vectors = vectors();
    let case = |((family, rates, n), vectors): (&(Family, usize, usize), &'_ Vec<Value>)| {
        let given = match rates {
            0 => family.name().to_owned(),
            rates => format!("{}({rates})", family.name()),
        };
        (format!("{}_{rates}_{n}", family.name()), given, *family, *n, vectors.clone())
    };
    let all: Vec<_> = vectors.iter().map(case).collect();
    let cases: Vec<_> = all
        .iter()
        .map(|(name, given, family, n, vectors)| Case {
            name: name.clone(),
            flags: vec!["--mu".to_owned(), given.clone()],
            n: *n,
            allowed: control(*family, Precision::F64),
            fields: &own,
            vectors,
        })
        .collect();
    judge("families", &cases);
}

/// The same mappings as expressions in mu(t) and in kappa(dt), whose r_k no family gives; and with a
/// law that is not a sum of gains, so that BB_n x itself is computed.
#[test]
#[ignore = "needs the engine"]
fn mappings_of_the_users_own() {
    let vectors = vectors();
    let mut cases = Vec::new();
    for ((family, count, n), vectors) in &vectors {
        let mut add = |form: &str, flags: &[&str], fields| {
            cases.push(Case {
                name: format!("{}_{form}_{n}", family.name()),
                flags: flags.iter().map(|flag| (*flag).to_owned()).collect(),
                n: *n,
                allowed: custom(Precision::F64),
                fields,
                vectors,
            });
        };
        let info = family.info();
        match (family, count) {
            (Family::ExpSum, 2) => add("mu", &["--mu", "mean(exp(a=a1), exp(a=a2))"], &rates),
            (Family::ExpSum, _) => {}
            // Written down, its kappa and mu cancel near the deadline: it is a family for its form that does not.
            (Family::Soft, _) => {}
            _ => {
                // A family's own form with nothing before it would be read as the family.
                let mu = format!("1*({})", info.mu);
                let kappa = info.kappa_in_time_to_go.replace('T', "(tau - dt)");
                let law = (1..=*n).map(|i| format!("-k{i}*xi{i}")).collect::<Vec<_>>().join(" ");
                let law = format!("--pi0={law}");
                add("mu", &["--mu", &mu], &own as &dyn Fn(&Value) -> String);
                add("kappa", &["--kappa", &kappa], &own);
                add("law", &["--kappa", &kappa, &law], &named);
            }
        }
    }
    // Three of each family but `soft`, and `exp_sum`, which has one.
    assert_eq!(cases.len(), (3 * (FAMILIES.len() - 2) + 1) * ORDERS.count());
    judge("custom", &cases);
}

/// The checks run on what would be emitted.
#[test]
#[ignore = "needs the engine"]
fn checks_ask_what_the_emitted_code_would_do() {
    let design =
        ["check", "--n=2", "--tau=1", "--gains=20,9", "--sample-time=1e-3", "--format=json"];
    for mapping in ["--mu=exp(a=1)", "--kappa=-ln(1 - dt/tau)"] {
        let told = super::stdout(&[&design[..], &[mapping]].concat());
        let told: Value = serde_json::from_str(&told).expect("JSON");
        assert_eq!(told["accepted"], true, "{told}");
        let checks = told["checks"].as_array().expect("checks");
        let sampling = checks.iter().find(|check| check["name"] == "sampling").expect("the check");
        // The largest period for held gains k = (20, 9) at a = 1 is known.
        assert_eq!(sampling["details"][0], "the threshold of h/T is 0.25");
    }
}

#[test]
#[ignore = "needs the engine"]
fn the_same_bytes_each_time() {
    let flags = ["emit", "--lang", "c", "--n", "4", "--mu", "tau*a*t/sqrt(1 + (a*t)^2)", "-o", "-"];
    let first = super::stdout(&flags);
    assert!(first.contains("--engine symbolica"), "{first}");
    assert!(first.contains("r_2 = "), "{first}");
    assert_eq!(super::stdout(&flags), first);
}
