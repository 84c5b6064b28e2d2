//! Objectives that are impossible, and bad input.

use std::fs;

use super::{DRIVEN, STAGE, folder, objective, run};

#[test]
fn an_objective_that_is_impossible_is_refused_with_its_point() {
    let state = objective("bound = \"state\"\nsigma = 50");
    let boxes = |x1: &str| DRIVEN.replace("x1 = 0", x1);
    for (design, code) in [
        (boxes("x1 = [-1, 1]"), 2),
        (boxes("x1 = [0, 1]"), 2),
        (boxes("x1 = [0.1, 1]"), 0),
        // It vanishes at rest.
        (boxes("x1 = [-1, 1]").replace("f = \"d\"", "f = \"d*x1\""), 0),
    ] {
        let folder = folder("impossible", &format!("{design}{state}"));
        let (found, told, wrong) = run(&folder, &["stage.toml"]);
        assert_eq!(found, Some(code), "{design}: {told}{wrong}");
        let point =
            "objective 1, |x| <= 50 |x0| (1), is impossible at tau = 1, x1 = 0, d = worst(-1)";
        assert_eq!(wrong.contains(point), code == 2, "{wrong}");
    }
    // At t0 the corner fails that no draw meets.
    let narrow = objective("bound = \"within\"\nh = \"x1 + x2\"\nhigh = 1.999");
    let design = STAGE.replace("x1 = 1\nx2 = 0", "x1 = [-1, 1]\nx2 = [-1, 1]");
    let folder = folder("corner", &format!("{design}{narrow}"));
    let (code, _, wrong) = run(&folder, &["stage.toml"]);
    assert_eq!(code, Some(2));
    assert!(wrong.contains("fails at t0 already, at tau = 1, x1 = 1, x2 = 1"), "{wrong}");
}

#[test]
fn all_mistakes_of_the_tables_are_told_at_once() {
    let design = "n = 2\nmu = \"exp(a=1)\"\ngains = [6, 5]\n[params]\ntau = 1\n\
                  [plant]\nf = \"gust - dampng*x2\"\ndamping = 0.4\ngust = [1, -1]\n\
                  [disturbance]\ngust = \"sin\"\n[verify]\nx1 = [1, -1]\nx2 = 0\nseed = -1\n\
                  [[objective]]\nbound = \"state\"\nsigma = -1\nzeta = \"T/tua + x1\"\n\
                  [[objective]]\n[[objective]]\nbound = \"input\"\nsigma = 4\n";
    let folder = folder("all", design);
    let (code, out, told) = run(&folder, &["stage.toml"]);
    assert_eq!((code, out.as_str()), (Some(2), ""));
    for part in [
        "f uses `dampng`, which has no value, and nothing uses `damping`",
        "7 | f = \"gust - dampng*x2\"",
        "plant.gust is not a pair of bounds",
        "the interval of x1 is empty",
        "verify.seed is not legal",
        "sigma of objective 1 is not a number > 0",
        "`x1` is not known where objective",
        "objective 2 is empty",
        "unknown key `sigma` of objective 3",
        "objective 3, of the bound input, without `upsilon`",
    ] {
        assert!(told.contains(part), "no {part:?} in\n{told}");
    }
    assert!(!told.contains("without a value") && !told.contains("objective 0"), "{told}");
    assert!(!told.contains("objective[0]"), "{told}");
}

#[test]
fn bad_input_gets_one_clear_message_and_no_file() {
    let bound = objective("bound = \"input\"\nupsilon = 9");
    let with = |from: &str, to: &str| format!("{STAGE}{bound}").replace(from, to);
    for (design, arguments, parts) in [
        (STAGE.to_owned(), &[][..], &["no objective", "[[objective]]"][..]),
        (with("[plant]\nf = 0\n", ""), &[], &["no plant", "[plant]"]),
        (with("x2 = 0\n", ""), &[], &["no interval of x2", "each of x1..x2"]),
        (with("x2 = 0", "x2 = 0\nx3 = 0"), &[], &["unknown key `verify.x3`", "x3 = 0"]),
        (with("x2 = 0", "x2 = [1, -1]"), &[], &["x2 is empty: 1 > -1", "x2 = [1, -1]", "^"]),
        (with("x2 = 0", "x2 = \"wide\""), &[], &["verify.x2 is not an interval"]),
        (
            with("f = 0", "f = \"d\"\nd = [1, -1]"),
            &[],
            &["plant.d is not a pair", "least < greatest"],
        ),
        (
            with("f = 0", "f = \"d\"\nd = [-1, 1]\n[disturbance]\ne = \"sine\""),
            &[],
            &["`e` has no bounds"],
        ),
        (
            with("f = 0", "f = \"d\"\nd = [-1, 1]\n[disturbance]\nd = \"sin\""),
            &[],
            &["disturbance.d is not a signal", "did you mean `sine`?"],
        ),
        (
            with("f = 0", "f = \"b*u\"\nb = [-3, 0]"),
            &["--scenarios=40"],
            &["the gain of the plant is 0 or has another sign than g", "b = -", "|b| < |g|"],
        ),
        (with("f = 0", "f = \"d\""), &[], &["d without a value", "9 | f = \"d\""]),
        (
            with("upsilon = 9", "upsilon = \"9*tua\""),
            &[],
            &["tua without a value", "| upsilon = \"9*tua\""],
        ),
        (with("gains = [6, 5]\n", ""), &[], &["k1, k2 without a value"]),
        (with("tau = 1\n", ""), &[], &["tau has no value"]),
        (with("x1 = 1", "x1 = 1\ntau = [0, 1]"), &[], &["tau is not > 0"]),
        (with("x1 = 1", "x1 = 1\nuntil = 2"), &[], &["verify.until is not legal", "< 1"]),
        (
            with("tau = 1\n", "tau = 1\neps = 0.1\n").replace("x1 = 1", "x1 = 1\nuntil = 0.01"),
            &[],
            &["after the gains are held", "eps/tau = 0.1"],
        ),
        (
            with("upsilon = 9", "upsilon = \"x1\""),
            &[],
            &["`x1` is not known where objective", "dt"],
        ),
        (with("upsilon = 9", "sigma = 9"), &[], &["unknown key", "without `upsilon`"]),
        (with("bound = \"input\"", "bound = \"inputs\""), &[], &["does not say what it bounds"]),
        (with("[[objective]]", "[objective]"), &[], &["one table of a list", "[[objective]]"]),
        (
            with("bound = \"input\"\nupsilon = 9", "bound = \"state\"\nsigma = 0.5"),
            &[],
            &["fails at t0 already", "at tau = 1, x1 = 1, x2 = 0"],
        ),
        (with("", ""), &["--scenarios=0"], &["scenarios is not legal", "--scenarios \"0\""]),
        (with("", ""), &["--seed=-1"], &["seed is not legal", "| --seed \"-1\""]),
        (with("", ""), &["--shard=3/2", "--out=a"], &["--shard 3/2 is not a part", "I/N"]),
        (with("", ""), &["--shard=1/2"], &["--out"]),
        (with("", ""), &["--merge", "stage.toml"], &["cannot use stage.toml"]),
        (with("", ""), &["--merge", "none.parquet"], &["cannot use none.parquet", "No such file"]),
        (with("", ""), &["--out=."], &["--out . is a folder"]),
        (with("", ""), &["--out=stage.toml/a"], &["cannot write --out stage.toml/a"]),
        (with("", ""), &["--pi0=extern"], &["`pi0 = extern` is a function of your program"]),
    ] {
        let folder = folder("wrong", &design);
        let (code, out, told) = run(&folder, &[&["stage.toml"][..], arguments].concat());
        assert_eq!((code, out.as_str()), (Some(2), ""), "{design}{arguments:?}: {told}");
        for part in parts {
            assert!(told.contains(part), "{arguments:?}: no {part:?} in\n{told}");
        }
        assert!(!told.contains("panicked"), "{told}");
        let files = fs::read_dir(&folder).expect("a folder").count();
        assert_eq!(files, 1, "{design}{arguments:?}");
    }
}
