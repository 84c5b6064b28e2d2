//! Expressions and their spellings, what is not proved and why, and the precision of the program.

use ptc_codegen::verify::bound::Proof;
use ptc_codegen::verify::{self, Trial};

use super::{campaign, proved};

/// Why the first objective is not proved.
fn why(text: &str) -> String {
    match &verify::bound::proved(&campaign(text))[0] {
        Proof::NotProved { why } | Proof::NoRoom { why, .. } => why.clone(),
        proved => panic!("{proved:?}: {text}"),
    }
}

/// u is 3 - 6T and 1 - 3T from (1, 0) and (0, 1): at most 5 - dt in size together.
#[test]
fn bounds_in_t_begin_at_t0() {
    let of = |upsilon: &str| {
        let text = format!(
            "n = 2\nmu = \"exp(a=1)\"\ng = 2\npoles = [-2, -3]\n[params]\ntau = 1\nt0 = 10\n\
             [plant]\nf = 0\n[verify]\nx1 = [-1, 1]\nx2 = [-1, 1]\n\
             [[objective]]\nbound = \"input\"\nupsilon = \"{upsilon}\"\n"
        );
        proved(&text)
    };
    assert_eq!(of("15.001 - t"), [true]);
    assert_eq!(of("5.001 - (t - t0)"), [true]);
    assert_eq!(of("5.001 - t"), [false]);
    assert_eq!(of("14.99 - t"), [false]);
}

/// The loop of which x1 = x1_0 (5 T^4 - 4 T^5) and x2 = x1_0 (-20 T^3 + 20 T^4), so that x2 = -2.109375
/// at T = 3/4, its least.
fn of_two(objectives: &str) -> String {
    format!(
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 1\n[plant]\nf = 0\n[verify]\n\
         x1 = [-1, 1]\nx2 = 0\n{objectives}"
    )
}

fn within(h: &str, bounds: &str) -> String {
    of_two(&format!("[[objective]]\nbound = \"within\"\nh = \"{h}\"\n{bounds}"))
}

#[test]
fn what_jumps_or_has_no_value_is_not_proved() {
    for h in [
        "sign(-2.1093745 - x2)",
        "sqrt(x2 + 2.1093745)",
        "sqrt(x2 + 2.1093745)^2",
        "ln(x2 + 2.1093745)",
        "exp(ln(x2 + 2.1093745))",
        "(x2 + 2.1093745)^0.5",
        "(x2 + 2.1093745)^1.5",
        "(x2 + 2.1093745)^pi",
        "0.1*atan(1/(x2 + 2.109375))",
        "(x2 + 2)/(x2 + 2)",
        "(x2 + 2)^2*(x2 + 2)^(-2)",
        "x2*ln(x2 + 2.1093745)/ln(x2 + 2.1093745)",
        "0*x1 + x2 - x2 + atanh(x2/2.1093745)/1e9",
        "tan(x2)/1e9",
        "1/x2",
        "max(0, sqrt(x2 + 2.1093745))",
        "min(0, ln(x2 + 2.1093745))",
        "atan(1/x1)",
        "exp(-1/x1^2)",
        "x1^(-2) - x1^(-2)",
        "abs(x2 + 2.1093745)/(x2 + 2.1093745)",
        "max(x2, -2.1093745)/(x2 + 2.1093745) - 1",
        "tanh(1/(x1 - 0.5))",
        "0*ln(0.9 - x1)",
        "ln(0.9 - x1)*0",
        "ln(0.9 - x1)^0",
        "-(0*x2)*sqrt(0.9 - x1)",
        "(0*sqrt(0.9 - x1))^0",
        "min(0, 0*sqrt(0.9 - x1))",
        "mean(1, 0*ln(0.9 - x1))",
        "atanh(x1/0.9)*0",
        "0*(1/x1)",
        "(x1/x1)^(1 - 1)",
        "0*tan(2*x1)",
        "0/(x1 - 0.5)",
        "0*x1^(-1)",
        "0*(0.9 - x1)^x2",
        "exp(0*ln(0.9 - x1)) - 1",
    ] {
        let text = within(h, "high = 2.5");
        if h.starts_with("sign") {
            assert_eq!(proved(&within(h, "high = 0.5")), [false], "{h}");
        } else {
            assert_eq!(proved(&text), [false], "{h}");
        }
    }
    // The same functions where they exist.
    for (h, high) in [
        ("sign(-2.2 - x2)", 0.5),
        ("sqrt(x2 + 2.2)", 2.2),
        ("sqrt(x2 + 2.2)^2", 4.6),
        ("ln(x2 + 2.2)", 1.5),
        ("(x2 + 2.2)^1.5", 9.5),
        ("1/(x2 + 2.2)", 12.0),
        ("(x2 + 2.2)/(x2 + 2.2)", 1.001),
        ("tan(x2/2)", 2.0),
        ("atanh(x2/2.2)", 2.0),
        ("abs(x1 + x2)", 1.7),
        ("max(x1, x2)", 2.2),
        ("exp(-x2)", 8.5),
        ("x1^2", 1.01),
        ("x2^2/x1_0^2*x1_0^2 - 1", 3.6),
        ("0*ln(1.1 - x1)", 0.001),
        ("sqrt(1.1 - x1)^0", 1.001),
        ("0*abs(x2) + (x1 - x2)^0", 1.001),
    ] {
        let expected = !h.contains("x1_0");
        assert_eq!(proved(&within(h, &format!("high = {high}"))), [expected], "{h}");
    }
    for bound in ["sqrt(T/tau - 0.5)", "ln(dt)", "1/(T - 0.5*tau)", "(t - 0.5)^0.5", "tan(3*dt)"] {
        for (kind, rest) in [("input", "upsilon"), ("state", "sigma = 1e9\nzeta")] {
            let text = format!("[[objective]]\nbound = \"{kind}\"\n{rest} = \"1e9 + {bound}\"\n");
            assert_eq!(proved(&of_two(&text)), [false], "{kind} {bound}");
        }
        assert_eq!(proved(&within("x1", &format!("high = \"1e9 + {bound}\""))), [false], "{bound}");
        assert_eq!(proved(&within("x1", &format!("low = \"{bound} - 1e9\""))), [false], "{bound}");
    }
    // What is multiplied by 0 has to exist too.
    for bound in ["0*ln(dt)", "ln(T - 0.5)^0", "0*sqrt(T/tau - 0.5)"] {
        for (kind, rest) in [("input", "upsilon"), ("state", "sigma = 1e9\nzeta")] {
            let text = format!("[[objective]]\nbound = \"{kind}\"\n{rest} = \"1e9 + {bound}\"\n");
            assert_eq!(proved(&of_two(&text)), [false], "{kind} {bound}");
        }
    }
    let least = within("x2", "low = \"-3 + sqrt(dt) + 0*ln(t + 1)\"");
    assert_eq!(proved(&least), [true], "{}", why(&least));
    let text = within("sqrt(x2 + 2.1093745)", "high = 2.5");
    assert!(why(&text).contains(") may have no value at T/tau = 0.7"), "{}", why(&text));
}

/// A sample at which a value or a bound is no number fails, whatever is around it.
#[test]
fn what_has_no_value_fails_a_sample() {
    for (h, bounds) in [
        ("max(0, sqrt(x2 + 2))", "high = 9"),
        ("min(1, ln(x2 + 2))", "high = 9"),
        ("atan(1/(x1 - x1))", "high = 9"),
        ("sqrt(x2 + 2)^2", "high = 9"),
        ("0*sqrt(x2 + 2)", "high = 9"),
        ("ln(x2 + 2)^0", "high = 9"),
        ("x1", "low = \"ln(-1 - dt)\"\nhigh = 9"),
        ("x1", "low = -9\nhigh = \"max(9, sqrt(T - 0.5))\""),
    ] {
        let campaign = campaign(&within(h, bounds));
        let mut trial = Trial::new(&campaign).expect("a trial");
        // Scenario 0 is a corner of the box.
        let outcome = trial.run(&campaign.setting(&campaign.scenario(0)));
        let failed = outcome.excess[0] == f64::INFINITY;
        let from_one = campaign.setting(&campaign.scenario(0)).x0[0] == 1.0;
        assert!(failed || !from_one && h.contains("x2"), "{h} {bounds}: {outcome:?}");
    }
}

#[test]
fn the_same_bound_has_the_same_verdict_in_every_spelling() {
    for (zeta, expected) in [("T/tau", false), ("sqrt(T/tau)", true)] {
        for share in
            ["T/tau", "(1 - dt/tau)", "(tau - dt)/tau", "(1 - (t - t0)/tau)", "(t0 + tau - t)/tau"]
        {
            let zeta = zeta.replace("T/tau", share);
            let text = of_two(&format!(
                "[[objective]]\nbound = \"state\"\nsigma = 3\nzeta = \"{zeta}\"\n"
            ));
            let several = text
                .replace("[params]\ntau = 1\n", "[params]\n")
                .replace("x2 = 0\n", "x2 = 0\ntau = [0.9, 1.1]\n");
            assert_eq!(proved(&text), [expected], "{zeta}");
            assert_eq!(proved(&several), [expected], "{zeta}, several tau");
        }
    }
    for h in [
        "x1 + x2",
        "x2 - (-x1)",
        "2*(x1/2 + x2/2)",
        "(x1 + x2)^2 - (x1 + x2)^2 + x1 + x2",
        "(x1 + x2)*T/tau + dt/tau*(x2 + x1)",
    ] {
        assert_eq!(proved(&within(h, "high = 1.65")), [true], "{h}");
        assert_eq!(proved(&within(h, "high = 1.5")), [false], "{h}");
    }
    assert_eq!(proved(&within("(x1^2 - x2^2)/(x1 - x2)", "high = 9")), [false], "it divides by 0");
}

#[test]
fn what_is_not_proved_says_why() {
    let with = |from: &str, to: &str| {
        why(&of_two("[[objective]]\nbound = \"input\"\nupsilon = 100\n").replace(from, to))
    };
    let u_max = "[params]\nu_max = 1\n";
    for (from, to, expected) in [
        ("poles = [-4, -5]", "pi0 = \"-20*xi1 - 9*xi2 - xi1^3\"", "pi0 is not a sum of gains"),
        ("f = 0", "f = \"x2\"", "f = x2 is not a sum of bounded symbols"),
        ("f = 0", "f = \"0*sqrt(x1)\"", "f = 0*sqrt(x1) is not a sum of bounded symbols"),
        ("f = 0", "f = 0\ng = \"1 + 0*ln(x1)\"", "the plant's g = 1 + 0*ln(x1) is not the number"),
        ("f = 0", "f = 0\ng = 2", "the plant's g = 2 is not the number"),
        ("upsilon = 100", "upsilon = 19", "no room is left at T/tau = "),
        ("upsilon = 100", "upsilon = \"100 + ln(T - 0.5)\"", "may have no value at T/tau = "),
        ("[params]\n", u_max, "u may be clipped by u_max: no room is left"),
    ] {
        let why = with(from, to);
        assert!(why.contains(expected), "{to}: {why}");
    }
}

#[test]
fn a_proof_is_about_the_emitted_program() {
    let of = |precision: &str, upsilon: &str| {
        let text = of_two(&format!("[[objective]]\nbound = \"input\"\nupsilon = {upsilon}\n"));
        format!("precision = \"{precision}\"\n{text}")
    };
    // |u| is 20 at t0, which f32 rounds by some 1e-6.
    assert_eq!(proved(&of("f64", "20.000002")), [true]);
    assert_eq!(proved(&of("f32", "20.000002")), [false]);
    assert_eq!(proved(&of("f32", "20.1")), [true]);
    for (precision, least, most) in [("f32", 1e-7, 1e-3), ("f64", 1e-16, 1e-12)] {
        let found = &verify::bound::proved(&campaign(&of(precision, "21")))[0];
        let Proof::Proved { scope } = found else { panic!("{found:?}") };
        let words: Vec<_> = scope.split(' ').collect();
        let number = words.iter().position(|word| *word == "within").expect("a bound") + 1;
        let error: f64 = words[number].parse().expect("a number");
        assert!(
            scope
                .contains(&format!("the emitted {precision} program stays in range there, within"))
        );
        assert!((least..most).contains(&error), "{scope}");
    }
    // K/T^4 is beyond f32 throughout.
    let fast = |precision: &str| {
        format!(
            "n = 4\nprecision = \"{precision}\"\nmu = \"exp(a=1)\"\npoles = [-5, -6, -7, -8]\n[params]\n\
             tau = 1e-9\n[plant]\nf = 0\n[verify]\nx1 = [-1, 1]\nx2 = 0\nx3 = 0\nx4 = 0\n\
             [[objective]]\nbound = \"within\"\nh = \"x1\"\nhigh = 2\n"
        )
    };
    assert_eq!(proved(&fast("f64")), [true]);
    assert!(why(&fast("f32")).contains("may leave the range of f32"), "{}", why(&fast("f32")));
    let iterated = of("f64", "1e3").replace("exp(a=1)", "exp_sum(rates=[1, 2])");
    let found = &verify::bound::proved(&campaign(&iterated))[0];
    let Proof::Proved { scope } = found else { panic!("{found:?}") };
    assert!(scope.contains("the rounding of its iteration is not included"), "{scope}");
}

#[test]
fn a_mapping_that_is_written_out_is_proved_as_its_family_is() {
    for (mapping, family, a) in [
        ("kappa = \"tan(pi/2*dt/tau)/0.44\"", "tan", "0.44"),
        ("mu = \"2*tau/pi*atan(2.12*t)\"", "tan", "2.12"),
        ("mu = \"tau*0.81*t/sqrt(1 + (0.81*t)^2)\"", "algebraic", "0.81"),
    ] {
        for (tau, t0, precision) in
            [("tau = 1.52", 0.0, "f64"), ("tau = 2.3", 7.7, "f32"), ("tau = 2.3", -0.6, "f64")]
        {
            let of = |mapping: &str| {
                format!(
                    "n = 3\n{mapping}\nprecision = \"{precision}\"\npoles = [-2, -3, -4]\n[params]\n\
                     {tau}\nt0 = {t0}\n[plant]\nf = 0\n[verify]\nuntil = 0.05\nx1 = [-0.8, 0.8]\nx2 = 0\n\
                     x3 = [-1.2, 1.2]\n[[objective]]\nbound = \"state\"\nsigma = 100\n"
                )
            };
            for text in [of(&format!("mu = \"{family}(a={a})\"")), of(mapping)] {
                let found = verify::bound::proved(&campaign(&text));
                assert!(found[0].is_proved(), "{found:?}\n{text}");
            }
        }
    }
}

#[test]
fn a_stretched_time_that_is_iterated_is_bounded_from_t0_on() {
    for (mapping, precision) in [
        ("mu = \"tau*(1 - (exp(-1.95*t) + exp(-0.76*t))/2)\"", "f32"),
        ("mu = \"tau*(1 - exp(-t)/(1 + t))\"", "f64"),
        ("mu = \"tau*(1 - (1 + 1.73*3*t)^(-1/3))\"", "f64"),
    ] {
        let text = format!(
            "n = 1\n{mapping}\nprecision = \"{precision}\"\npoles = [-2]\n[params]\ntau = 6.2\n\
             [plant]\nf = 0\n[verify]\nuntil = 0.1\nx1 = [-0.8, 0.8]\n\
             [[objective]]\nbound = \"state\"\nsigma = 1.05\n"
        );
        let found = verify::bound::proved(&campaign(&text));
        assert!(found[0].is_proved(), "{found:?}\n{text}");
    }
}

/// A kink is replaced by one branch where the sign that selects it is known, so that its parts can cancel.
#[test]
fn kinks_whose_sign_is_known_are_no_obstacle() {
    let holds = |h: &str, bounds: &str| {
        let design = format!(
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[plant]\nf = 0\n\
             [verify]\nx1 = [-1, 1]\nx2 = [-1, 1]\ntau = [0.9, 1]\n\
             [[objective]]\nbound = \"within\"\nh = \"{h}\"\n{bounds}\n"
        );
        proved(&design)[0]
    };
    // |x1| < 1.2 along every run.
    assert!(holds("abs(x1 - 1.3) + x1 - 1.3", "high = 1e-9"));
    assert!(holds("abs(1.3 - x1)/(1.3 - x1)", "low = 0.5"));
    assert!(holds("sign(x1 - 1.3)*abs(x1 - 1.3)", "high = 0"));
    assert!(holds("(x1 - 1.3)^3", "high = 0"));
    assert!(holds("max(x1, 1.3) - 1.3", "high = 1e-9"));
    assert!(holds("min(x1, 1.3) - x1 + abs(max(x1, -1.3) - 1.3) + x1 - 1.3", "high = 1e-9"));
    // x1 = 1 is in the box.
    assert!(!holds("abs(x1 - 0.99) + x1 - 0.99", "high = 1e-9"));
    assert!(!holds("(x1 - 0.99)^3", "high = 0"));
    assert!(!holds("min(x1, 0.99) - x1", "low = -1e-3"));
}
