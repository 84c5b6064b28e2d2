//! Every input has a bound in time and memory: what is too large is refused with its size and the limit, what
//! is accepted ends.

use crate::support;

use std::fs;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use support::{command, folder};

/// Many times what a release takes: tests are built with little optimisation, and run beside others.
const PATIENCE: Duration = Duration::from_secs(60);

/// The command under a limit of 500 MB, where the system has one.
fn limited(arguments: &[&str]) -> Command {
    if !cfg!(target_os = "linux") {
        return command(arguments);
    }
    let mut shell = Command::new("sh");
    shell.args(["-c", "ulimit -v 500000; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_ptc-codegen")]);
    shell.args(arguments).stdin(Stdio::null());
    shell
}

/// Returns the output of the command, which ends in time, without a panic and with a documented exit code.
fn run(arguments: &[&str]) -> Output {
    let began = Instant::now();
    let output = limited(arguments).output().expect("the command runs");
    assert!(began.elapsed() < PATIENCE, "{:?} for {arguments:?}", began.elapsed());
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(matches!(output.status.code(), Some(0..=3)), "{arguments:?}: {stderr}");
    assert!(stderr.len() < 20_000, "{} bytes for {arguments:?}", stderr.len());
    output
}

fn refused(arguments: &[&str], parts: &[&str]) {
    let output = run(arguments);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
    assert!(output.stdout.is_empty());
    for part in parts {
        assert!(stderr.contains(part), "{part} in {stderr}");
    }
}

/// `E` and `K` of `form`, replaced by the form itself and a number, `depth` times around `inner`.
fn nested(form: &str, depth: usize, inner: &str) -> String {
    (1..=depth).fold(inner.to_owned(), |e, k| form.replace('K', &k.to_string()).replace('E', &e))
}

#[test]
fn expressions_that_grow_when_they_are_simplified_end() {
    let places: [(&str, &str, &[&str]); 4] = [
        ("--mu", "t", &[]),
        ("--kappa", "dt", &[]),
        ("--pi0", "xi1", &["--mu=exp"]),
        ("--g", "x1", &["--mu=exp"]),
    ];
    for (flag, name, others) in places {
        for form in [
            nested("(E+K)^3", 20, name),
            nested("(E+a)^3", 20, name),
            nested("1/(K+E)", 60, name),
            nested("tanh(E)", 80, name),
            nested("atanh(E/2)", 40, name),
            nested("cosh(E)", 30, name),
            format!("tau*atan({name})*exp({})", nested("cosh(E)", 66, name)),
            nested("ln(1+E)", 50, name),
            nested("(E)^(E)", 8, name),
            format!("{name}^1e8 - b"),
            format!("({name}+1)^100000000"),
            format!("({name}+1)^(100000001/3)"),
            format!("({name}+1)^(1/100000007)"),
            format!("{name}*exp(exp(exp(9)))"),
            (1..30)
                .map(|k| format!("sinh({k}*{name})/cosh({}*{name})", k + 1))
                .collect::<Vec<_>>()
                .join("*"),
            (1..60).map(|k| format!("1/({name}+p{k})")).collect::<Vec<_>>().join("+"),
        ] {
            let own = format!("{flag}={form}");
            run(&[&["check", "--n=2", &own], others].concat());
        }
    }
}

/// A derivative repeats what is beside each of its parts, and a logarithm for each atanh its argument.
#[test]
fn what_repeats_parts_of_a_law_takes_bounded_memory() {
    let tower = nested("atanh(E/2)", 25, "xi1");
    let factors: Vec<_> = (1..=8).map(|k| format!("({tower}+{k})")).collect();
    let product = factors.join("*");
    for law in [
        nested("((E+1)/(E+2)/(E+3))", 2, &product),
        nested("((E+1)/(E+2)/(E+3))", 2, &factors[..3].join("*")),
        nested("((E+1)/(E+2)/(E+3))", 3, &tower),
        nested("(tanh(E)*E)", 3, &factors[..2].join("*")),
    ] {
        let output = run(&["check", "--n=11", "--mu=exp_sum(3)", &format!("--pi0={law}")]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

/// A step with a line for each coefficient grows with the mapping and the square of the order.
#[test]
fn mappings_of_any_size_are_expanded_in_time_or_refused() {
    let mut terms: Vec<_> = (1..256).map(|k| format!("sin(dt*{k})*atan(dt/{k})")).collect();
    while terms.len() > 1 {
        terms = terms.chunks(2).map(|pair| format!("({})", pair.join("+"))).collect();
    }
    let kappa = format!("--kappa=-ln(1-dt/tau)+{}", terms[0]);
    let own = ["emit", "--lang", "c", "-o", "-", "--allow", "membership,growth"];
    refused(
        &[&own[..], &["--n=13", &kappa]].concat(),
        &["coefficients in its expansion", "100000"],
    );
    assert!(run(&[&own[..], &["--n=4", &kappa]].concat()).status.success());
    // The sums of a series are long where its orders are many.
    let row: Vec<_> = (1..104).map(|k| format!("(dt+{k})")).collect();
    let kappa =
        format!("--kappa=exp({}^0.3)", nested("sin(E)", 10, &format!("({})", row.join("/"))));
    assert!(run(&[&own[..], &["--n=16", &kappa]].concat()).status.success());
}

/// The work of a self-test is bounded, whatever its design holds.
#[test]
fn self_tests_end() {
    let steep = (3..=12).fold("t".to_owned(), |e, k| format!("({e}+sin({e})/{k})"));
    let steep = (13..=60).fold(steep, |e, k| format!("({e}+sin(t)/{k})"));
    let mu = format!("--mu=tau*(1-exp(-({steep})))");
    let own = ["emit", "--lang", "c", "--selftest", "-o", "-", "--allow", "membership,growth"];
    for n in ["--n=2", "--n=4"] {
        refused(&[&own[..], &[n, &mu]].concat(), &["steps of work", "fewer functions"]);
    }
    let output = run(&[&own[..], &["--n=16", "--mu=tan"]].concat());
    assert!(output.status.success());
    // A parameter that is chosen is looked up in the mapping.
    let term = |k: usize| format!("p{k}*dt/(q{k}+dt^2)");
    let kappa = format!("--kappa=dt/(tau-dt)+{}", (0..60).map(term).collect::<Vec<_>>().join("+"));
    refused(&[&own[..], &["--n=16", &kappa]].concat(), &["steps of work"]);
    // Each trial looks up each of its parameters.
    let term = |k: usize| format!("(p{}*xi{}+p{}*dt)", k % 60, 1 + k % 8, (7 * k) % 60);
    let law = format!("--pi0={}", (0..190).map(term).collect::<Vec<_>>().join("+"));
    run(&[&own[..], &["--n=8", "--mu=exp_sum(2)", &law]].concat());
}

#[test]
fn what_is_too_large_is_refused_with_its_size_and_the_limit() {
    let nest = nested("(E)", 150, "t");
    let row = vec!["t"; 300].join("+");
    let least = format!("min({})", vec!["t"; 150].join(","));
    for (mu, parts) in [
        ("t+".repeat(30_000) + "1", &["[too-large]: mu has 60001 characters", "20000"][..]),
        (nest, &["[too-large]: mu has more than 100 levels of nesting", "fewer brackets"]),
        (row, &["[too-large]: mu has more than 200 operations in a row", "(a + b) + (c + d)"]),
        (least, &["[too-large]: mu has 150 arguments", "99"]),
        ("t*2^64^9".to_owned(), &[]),
        ("t*((((7^7)^7)^7)^7)^7".to_owned(), &["bits in a constant", "4096"]),
        (nested("cosh(E+sinh(E))", 10, "t"), &["steps to simplify", "fewer functions"]),
        ("t*1e400000".to_owned(), &["exponent 400"]),
        (format!("t*{}", "7".repeat(1001)), &["1000 digits"]),
    ] {
        let mu = format!("--mu={mu}");
        match parts {
            [] => drop(run(&["check", "--n=2", &mu])),
            parts => refused(&["check", "--n=2", &mu], parts),
        }
    }
}

#[test]
fn designs_of_any_size_are_read_in_time_or_refused() {
    let folder = folder("bounds_designs");
    let begin = "n = 2\nmu = \"exp\"\n";
    let keys = |count| (0..count).map(|k| format!("k{k} = 1\n")).collect::<String>();
    for (name, text, parts) in [
        ("keys", keys(70_000), &["70002 keys and tables; the limit is 2000"][..]),
        ("few", keys(1500), &["[unknown-key]", "1480 more", "mend these first"]),
        ("long", format!("{} = 1\n", "k".repeat(900_000)), &["unknown key `kkkk"]),
        ("dots", format!("[{}a]\n", "a.".repeat(400_000)), &["not a table of a design"]),
        ("list", format!("gains = [{}]\n", "true,".repeat(200_000)), &["200000 values in lists"]),
        ("deep", format!("gains = {}", "[".repeat(500_000)), &["[toml]"]),
        ("large", format!("# {}", "x".repeat(2_000_000)), &["more than 1048576 bytes"]),
    ] {
        let path = folder.join(format!("{name}.toml"));
        fs::write(&path, format!("{begin}{text}")).expect("a file");
        refused(&["check", &path.display().to_string()], parts);
    }
    #[cfg(unix)]
    refused(&["check", "/dev/zero"], &["more than 1048576 bytes"]);
}

#[test]
fn hidden_characters_are_written_out() {
    let file = folder("bounds_hidden").join("a\u{202e}b\u{9b}\n.toml");
    refused(&["check", &file.display().to_string()], &["a\\u{202e}b\\u{9b}\\n.toml"]);
    fs::write(&file, "n = 2\nmu = \"t\u{9b}2J\"\n").expect("a file");
    for mu in ["--mu=t\u{1b}[31m", "--mu=t*\u{202e}", "--mu=\u{2066}t"] {
        refused(&["check", "--n=2", mu], &["\\u{"]);
    }
    for arguments in [
        &["check", &*file.display().to_string()][..],
        &["check", "--n=2", "--mu=t\u{1b}[31m\u{202e}"],
        &["check\u{1b}[31m\u{202e}"],
    ] {
        let stderr = String::from_utf8_lossy(&run(arguments).stderr).into_owned();
        let hidden =
            |c: char| c.is_control() && c != '\n' || ('\u{202a}'..='\u{202e}').contains(&c);
        assert!(!stderr.contains(hidden), "{stderr:?}");
    }
}

#[test]
fn paths_on_the_standard_output_are_written_out() {
    let odd = "a\u{202e}b\u{9b}\n\u{1b}[31m";
    let folder = folder("bounds_shown").join(odd);
    let out = format!("--out={}", folder.display());
    let project = format!("--out={}", folder.join("project").display());
    let controller = ["emit", "--n=2", "--mu=exp", "--lang=c", "--name=roll"];
    let alone = ["--tau=1", "--gains=20,9", "--eps=1e-3", "--sample-time=1e-4"];
    for (arguments, word) in [
        ([&controller[..], &[&out]].concat(), "wrote"),
        ([&controller[..], &[&out]].concat(), "unchanged"),
        ([&controller[..], &[&out, "--check"]].concat(), "up to date:"),
        (
            [&["emit", "--n=2", "--mu=exp(a=1)", "--project=cmake", &project], &alone[..]].concat(),
            "wrote",
        ),
    ] {
        let output = run(&arguments);
        let stdout = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        assert!(stdout.contains("a\\u{202e}b\\u{9b}\\n\\u{1b}[31m"), "{stdout:?}");
        assert!(stdout.lines().all(|line| line.starts_with(word)), "{stdout:?}");
        let hidden = |c: char| c.is_control() && c != '\n' || c == '\u{202e}';
        assert!(!stdout.contains(hidden), "{stdout:?}");
    }
}
