//! `ptc-codegen show`: closed forms as text, LaTeX and JSON.

use crate::support;

use support::words::{json, stderr, stdout};

#[test]
fn the_json_of_r_has_its_documented_shape() {
    let expected = serde_json::json!({"r": [
        {"k": 1, "terms": [{"coefficient": "1", "exponents": {"1": -1}}]},
        {"k": 2, "terms": [{"coefficient": "-1", "exponents": {"1": -3, "2": 1}}]},
        {"k": 3, "terms": [
            {"coefficient": "3", "exponents": {"1": -5, "2": 2}},
            {"coefficient": "-1", "exponents": {"1": -4, "3": 1}},
        ]},
    ]});
    assert_eq!(json(&["show", "r", "--n", "3", "--format", "json"]), expected);
    let eight = json(&["show", "r", "--n", "8", "--format", "json"]);
    assert_eq!(eight["r"].as_array().map(Vec::len), Some(8));
    // One term for each partition of 7.
    assert_eq!(eight["r"][7]["terms"].as_array().map(Vec::len), Some(15));
    let thirty = json(&["show", "r", "--n", "30", "--format", "json"]);
    assert_eq!(thirty["r"][29]["terms"].as_array().map(Vec::len), Some(4565));
}

#[test]
fn the_json_of_the_other_subjects_is_alike() {
    let big = json(&["show", "R", "--n=3", "--format=json"]);
    let square =
        serde_json::json!({"k": 2, "m": 2, "terms": [{"coefficient": "3", "exponents": {"2": 2}}]});
    assert_eq!(big["R"][5], square);
    let tables = json(&["show", "tables", "--n=3", "--format=json"]);
    assert_eq!((&tables["A1"][5], tables["A2"].as_array().map(Vec::len)), (&square, Some(3)));

    let bell = json(&["show", "bell", "--n=3", "--format=json"]);
    let entry = serde_json::json!({"i": 3, "j": 2, "terms": [{"coefficient": "3", "exponents": {"1": 1, "2": 1}}]});
    assert_eq!(bell["B"][8], entry);

    let matrix = json(&["show", "matrix", "--n=2", "--mu=exp", "--format=json"]);
    let r1 = serde_json::json!([{"coefficient": "1", "exponents": {"a": 1, "T": 1}}]);
    assert_eq!(matrix["BB"][3], serde_json::json!({"i": 2, "j": 2, "terms": r1}));
    assert_eq!(matrix["b"][0], serde_json::json!({"j": 1, "terms": []}));
    assert_eq!(matrix["BB"].as_array().map(Vec::len), Some(4));

    let law = json(&["show", "law", "--n=2", "--mu=exp", "--format=json"]);
    assert_eq!(
        law["row"][0]["terms"],
        serde_json::json!([{"coefficient": "-1", "exponents": {"K1": 1}}])
    );
    assert_eq!(
        law["K"][0]["terms"],
        serde_json::json!([{"coefficient": "1", "exponents": {"a": -2, "k1": 1}}])
    );
    let sum = json(&["show", "law", "--n=2", "--mu=exp_sum", "--format=json"]);
    assert!(sum["law"].is_string() && sum["r"].is_array(), "{sum}");
}

#[test]
fn text_is_readable_and_holds_the_corrected_entries() {
    let r = stdout(&["show", "r", "--n", "3"]);
    assert!(r.ends_with("r3 = 3*s'^-5*s''^2 - s'^-4*s^(3)\n"), "{r}");
    assert!(stdout(&["show", "R", "--n", "3"]).contains("R_{2,2} = 3*s''^2\n"));
    let tables = stdout(&["show", "tables", "--n", "5"]);
    assert!(tables.contains("k = 2  0      s^(3)  3*s''^2\n"), "{tables}");
    assert!(tables.contains("r3 = 3*s'^-5*s''^2 - s'^-4*s^(3)\n"), "{tables}");
    let matrix = stdout(&["show", "matrix", "--n", "3", "--mu", "exp(a=1)"]);
    assert!(matrix.contains("  [ 1  0   0   ]\n  [ 0  T   0   ]\n  [ 0  -T  T^2 ]\n"), "{matrix}");
    assert!(matrix.contains("with a = 1"), "{matrix}");
    assert!(stdout(&["show", "bell", "--n=3"]).contains("B_{3,2} = 3*r1*r2\n"));
    let law = stdout(&["show", "law", "--n=2", "--mu=exp"]);
    assert!(law.contains("gain_j = inv_T^(3-j) * row_j") && law.contains("row2 = 1 - K2"), "{law}");
    // A fixed parameter is folded in, exactly.
    let half = stdout(&["show", "law", "--n=2", "--mu=exp(a=0.5)"]);
    assert!(half.contains("K1 = 4*k1\n"), "{half}");
    let power = stdout(&["show", "r", "--n=2", "--mu=power(m=2)"]);
    assert!(power.contains("r2 = -3*a^2*T*P^2\n"), "{power}");
}

#[test]
fn latex_is_balanced() {
    let families = ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum(3)", "soft"];
    let flags = families.iter().map(|f| format!("--mu={f}")).collect::<Vec<_>>();
    for n in ["--n=1", "--n=4", "--n=11"] {
        for subject in ["r", "R", "bell", "matrix", "law", "tables"] {
            balanced(&stdout(&["show", subject, n, "--format=latex"]));
            for flag in flags.iter().filter(|_| !matches!(subject, "R" | "tables")) {
                balanced(&stdout(&["show", subject, n, flag, "--format=latex"]));
            }
        }
    }
    let tables = stdout(&["show", "tables", "--n=4", "--format=latex"]);
    assert!(tables.contains(r"3 \left(s''\right)^{2}"), "{tables}");
}

/// Braces, environments and `\left` match, and no superscript follows another.
/// The power of a fraction and its factor is that of both.
#[test]
fn latex_powers_apply_to_whole_quantities() {
    let latex = stdout(&["show", "law", "--n=3", "--mu=tan", "--format=latex"]);
    assert!(latex.contains(r"\left(\tfrac{\pi}{2\tau}y\right)^{2}"), "{latex}");
    assert!(!latex.contains(r"\tfrac{\pi}{2\tau}y^"), "{latex}");
}

fn balanced(latex: &str) {
    let count = |what: &str| latex.matches(what).count();
    assert_eq!(count("{"), count("}"), "{latex}");
    assert_eq!(count(r"\left"), count(r"\right"), "{latex}");
    assert_eq!(count(r"\begin{"), count(r"\end{"), "{latex}");
    assert_eq!(count("$") % 2, 0, "{latex}");
    assert!(!latex.contains("'^"), "{latex}");
    for (start, _) in latex.match_indices("^{") {
        let mut depth = 0;
        let closes = |c: char| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            c == '}' && depth == 0
        };
        let end = start + latex[start..].find(closes).expect("braces match") + 1;
        assert!(!latex[end..].starts_with(['^', '\'']), "{}", &latex[start..]);
    }
}

#[test]
fn show_says_where_it_stops() {
    for (arguments, part) in [
        (&["r", "--n=31"][..], "1..=30"),
        (&["law", "--n=17"], "1..=16"),
        (&["r", "--n=17", "--mu=exp"], "1..=16"),
        (&["r", "--n=0"], "--n \"0\""),
        (&["r"], "1..=30"),
        (&["R", "--n=3", "--mu=exp"], "abstract"),
        (&["tables", "--n=3", "--mu=exp"], "abstract"),
        (&["r", "--n=3", "--mu=expp"], "did you mean `exp`"),
        (&["q", "--n=3"], "tables"),
        (&["r", "--n=3", "--format=xml"], "latex"),
    ] {
        let told = stderr(&[&["show"], arguments].concat(), 2);
        assert!(told.contains(part), "{arguments:?}: {told}");
    }
    for subject in ["r", "R", "bell", "tables"] {
        assert!(!stdout(&["show", subject, "--n=30"]).is_empty());
    }
}

#[test]
fn a_mapping_that_is_an_expression_is_shown_in_r_k() {
    let matrix = stdout(&["show", "matrix", "--n", "3", "--mu", "tau*a*t/(1 + a*t)"]);
    for line in [
        "# mu(t) = tau*a*t/(1 + a*t)",
        "  [ 0  r2  r1^2 ]",
        "  [ 0  r3  3*r1*r2 ]",
        "r1 = a*T^2/tau",
        "r2 = -2*a^2*T^3/tau^2",
    ] {
        assert!(matrix.lines().any(|found| found == line), "{line}:\n{matrix}");
    }
    // Nothing is known of kappa in closed form: r_k are those of mu.
    let r = stdout(&[
        "show",
        "r",
        "--n",
        "2",
        "--mu",
        "tau*(1 - (exp(-t) + exp(-a*t))/2)",
        "--format",
        "json",
    ]);
    let r: serde_json::Value = serde_json::from_str(&r).expect("JSON");
    assert_eq!(r["r"].as_array().map(Vec::len), Some(2), "{r}");
    let law = json(&["show", "law", "--n=2", "--mu=tau*(1 - exp(-a*t))", "--format=json"]);
    assert_eq!(law["row"].as_array().map(Vec::len), Some(2));
    assert_eq!(law["r"][1]["expression"], "-a^2*T");
    let latex = stdout(&["show", "r", "--n=2", "--mu=tau*a*t/(1 + a*t)", "--format=latex"]);
    assert!(latex.contains("r_{1} &= \\frac{"), "{latex}");
}

/// With poles -2 and -3 the solutions are the falling powers M (M-1) and M (M-1) (M-2).
#[test]
fn law_in_samples_has_its_exact_solutions() {
    let design =
        "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.1\ngains = [6, 5]\n";
    let path = support::folder_with("show_samples", "design.toml", design).join("design.toml");
    let path = path.to_str().expect("a path");
    let found = json(&["show", "law", path, "--format=json"]);
    let s = |i: usize, j: usize| found["S"][i][j].as_f64().expect("a number");
    let row = |j: usize| {
        let text = found["row"][j]["terms"][0]["coefficient"].as_str().expect("a number");
        text.parse::<f64>().expect("an integer")
    };
    let (h, mut x, mut seen) = (0.1, [1.0, -0.5], Vec::new());
    for left in (3..=20).rev() {
        let m = f64::from(left);
        let z = [0, 1].map(|i| s(i, 0) * x[0] + s(i, 1) * x[1]);
        seen.push((m, z[0]));
        let u = (row(0) * z[0] / (m * (m - 1.0)) + row(1) * z[1] * h / (m - 1.0)) / (h * h);
        x = [x[0] + h * x[1] + h * h / 2.0 * u, x[1] + h * u];
    }
    // z_1/(M (M-1)) is c + d M.
    let slope = |(m, z): (f64, f64)| z / (m * (m - 1.0));
    let d = slope(seen[0]) - slope(seen[1]);
    for &(m, z) in &seen {
        let wanted = slope(seen[0]) - d * (20.0 - m);
        assert!((slope((m, z)) - wanted).abs() < 1e-12, "{m}: {z}");
    }
    let latex = stdout(&["show", "law", path, "--format=latex"]);
    balanced(&latex);
    assert!(latex.contains(r"\cdots (M-1)"), "{latex}");
    assert!(
        stderr(&["show", "bell", path], 2).contains("show bell does not know a clock in samples")
    );
}
