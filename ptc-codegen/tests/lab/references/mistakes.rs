//! References that are refused: each at its line, with what to change.

use super::support::{folder, folder_with, refused_at, run_in};

const DESIGN: &str = "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\nreference = \"0.1*sin(2*t)\"\n\
    poles = [-4, -5]\n[params]\ntau = 1\nt0 = 0\n";

#[test]
fn invalid_references_are_refused_at_their_line() {
    for (from, to, line, message, help) in [
        ("0.1*sin(2*t)", "abs(sin(t))", 4, "abs(sin(t)) has a kink", "tanh(w/small)"),
        ("0.1*sin(2*t)", "max(t, 1)", 4, "max(t, 1) has a kink", "`reference` = input"),
        ("0.1*sin(2*t)", "t*sign(t - 1)", 4, "sign(t - 1) has a kink", "`reference` = input"),
        ("0.1*sin(2*t)", "sqrt(t)", 4, "t has to be > 0", "give t0"),
        ("0.1*sin(2*t)", "tan(t)", 4, "cos(t) has to be not 0", "`reference` = input"),
        ("0.1*sin(2*t)", "1/(t - 2)", 4, "t - 2 has to be not 0", "`reference` = input"),
        ("0.1*sin(2*t)", "t^1.5", 4, "t has to be > 0", "`reference` = input"),
        ("0.1*sin(2*t)", "ln(t)", 4, "not shown to have derivatives", "give t0"),
        ("0.1*sin(2*t)", "x1 + t", 4, "`x1` is not known where reference is", "t (time)"),
        ("0.1*sin(2*t)", "T", 4, "`T` is not known where reference is", "write `tau - dt`"),
        (
            "n = 2\nmu = \"exp(a=1)\"\nreference = \"0.1*sin(2*t)\"\npoles = [-4, -5]\n[params]\ntau = 1\nt0 = 0\n",
            "mu = \"exp(a=1)\"\nclock = \"samples\"\nreference = \"t\"\nsample_time = 1e-3\n[plant]\nA = [[0, 1], [-1, 0]]\nB = [0, 1]\n",
            4,
            "no output of the plant that could follow it",
            "give `output`, 2 numbers as in a row of C",
        ),
        ("poles = ", "what = \"associated\"\npoles = ", 5, "belongs to a controller", "leave"),
        ("poles = [-4, -5]", "pi0 = \"-20*xi1 - 8*xi2*x1_0\"", 5, "pi0 is an expression", "start"),
        (
            "[params]",
            "[params]\ntau1 = 2",
            7,
            "nothing uses the parameter `tau1`",
            "the parameters of the design are a",
        ),
    ] {
        assert!(DESIGN.contains(from), "{from}");
        refused_at("references_mistakes", &DESIGN.replacen(from, to, 1), line, [message, help]);
    }
}

/// References that are proved to exist, with the start and the parameters of the design.
#[test]
fn differentiable_references_are_accepted() {
    for reference in [
        "1/(1 + t^2)",
        "1/(2 + sin(t))",
        "ln(1/(1 + t*t))",
        "ln(2 + sin(t))",
        "(1.5 + 2*sin(t/2)*cos(t/2))^0.3",
        "sqrt(1.2 - cos(t)^2 + sin(3*t)*cos(t)/8)",
        "1/(1 + exp(t))",
        "sqrt(t + 1)",
        "ln(1 + t)*exp(-t)",
        "(1 + t)^1.5",
        "max(a, 2)*t",
        "sin(t/period)",
        "atan(t - 3) + tanh(t)",
        "sin(2*pi*dt/tau)^4",
        "target",
    ] {
        let text = DESIGN.replace("0.1*sin(2*t)", reference);
        let folder = folder_with("references_exist", "stage.toml", &text);
        let (code, _, stderr) = run_in(&folder, &["emit", "--lang", "c", "stage.toml"]);
        assert_eq!(code, Some(0), "{reference}: {stderr}");
    }
}

/// An expression whose derivatives grow is refused within a bounded time.
#[test]
fn oversized_derivatives_are_refused() {
    let factors: Vec<_> = (1..40).map(|k| format!("sin({k}*t + cos({k}*t^2))")).collect();
    let text = DESIGN
        .replace("0.1*sin(2*t)", &factors.join("*"))
        .replace("n = 2", "n = 12")
        .replace("poles = [-4, -5]", "pi0 = \"-xi1\"");
    let folder = folder_with("references_large", "stage.toml", &text);
    let (code, _, stderr) = run_in(&folder, &["emit", "--lang", "c", "stage.toml"]);
    assert_eq!(code, Some(2), "{stderr}");
    assert!(stderr.contains("of the reference is larger than an expression may be"), "{stderr}");
}

#[test]
fn targets_without_reference_support_say_so() {
    let folder = folder("references_unknown");
    let design = ["--n", "2", "--mu", "exp(a=1)", "--poles=-4,-5", "--tau", "1", "--eps", "1e-2"];
    let run = |command: &[&str], further: &[&str]| {
        let (code, _, stderr) = run_in(&folder, &[command, &design, further].concat());
        assert_eq!(code, Some(2), "{stderr}");
        stderr
    };
    let told = run(&["simulate"], &["--reference", "input", "--x0", "1,0"]);
    assert!(told.contains("simulate has no reference to give to each call"), "{told}");
    let project = ["--project", "cmake", "--reference", "sin(t)", "--out", "out"];
    let told = run(&["emit"], &project);
    assert!(told.contains("the run of a project brings the plant to rest"), "{told}");
    let fmu = ["--lang", "fmu2", "--reference", "input", "--g", "2 + r0", "--out", "out.fmu"];
    let told = run(&["emit"], &fmu);
    assert!(told.contains("the FMU has an input r0, the reference"), "{told}");
    let campaign = format!(
        "{DESIGN}eps = 1e-2\n[plant]\nf = 0\n[verify]\nx1 = [-1, 1]\nx2 = [-1, 1]\n\
        scenarios = 10\n[[objective]]\nbound = \"within\"\nh = \"e1*e3\"\nhigh = 1\n"
    );
    let given = campaign.replace("\"0.1*sin(2*t)\"", "\"input\"");
    assert_ne!(given, campaign);
    std::fs::write(folder.join("given.toml"), given).expect("a file");
    std::fs::write(folder.join("campaign.toml"), campaign).expect("a file");
    for command in ["verify", "design"] {
        let refused = |file: &str, wanted: &str| {
            let (code, _, stderr) = run_in(&folder, &[command, file]);
            assert_eq!(code, Some(2), "{stderr}");
            assert!(stderr.contains(wanted), "{stderr}");
        };
        refused("given.toml", "a campaign has no reference to give to each call");
        refused("campaign.toml", "e3 without a value in the design");
    }
}
