//! Self-tests of plants with several inputs: the controller passes, and altered ones fail.

use super::coupled::{MIX, following, plants};
use super::in_c::{selftest, selftest_of};
use super::{example, spec};

#[test]
fn they_find_nothing_wrong() {
    for (name, spec) in plants().into_iter().chain(following()) {
        assert_eq!(selftest(&format!("coupled_{name}"), &spec), 0.0, "{name}");
    }
    let limited = example("two_link.toml");
    for (name, text) in [
        ("limited", limited.clone()),
        ("f32", limited.replace("name =", "precision = \"f32\"\nname =")),
        ("result", limited.replace("name =", "guard = \"result\"\nname =")),
        ("none", MIX.replace("name =", "guard = \"none\"\nname =")),
        ("bound", MIX.replace("eps = 1e-2\nu_max = inf", "")),
        ("barrier", example("barrier_arm.toml")),
        // A product of constants and parameters is too long a test for one line.
        (
            "constants",
            "name = \"constants\"\nmu = \"tanh(a=1/2)\"\npoles = [-6, -7, -8]\n[params]\ntau = 2\neps = 1e-2\n\
             [model]\nstates = [\"z1\", \"z2\", \"z3\"]\ninput = \"u\"\noutput = \"z1\"\n\
             dynamics = { z1 = \"z2\", z2 = \"z3 + c^2\", z3 = \"u - cos(0.5)*p + z2\" }\n"
                .to_owned(),
        ),
        ("axis", "name = \"axis\"\nn = 2\naxes = 1\nmu = \"exp\"\npi0 = \"extern\"\n".to_owned()),
        (
            "axes",
            "name = \"gantry\"\nn = 2\naxes = 3\nmu = \"tanh(a=1)\"\npi0 = \"extern\"\nreference = \"input\"\n\
             g = [\"2\", \"1/mass\", \"1\"]\nlimits = [9, 20, 30]\n"
                .to_owned(),
        ),
        ("alike", "n = 2\naxes = 3\nmu = \"exp\"\n".to_owned()),
        (
            "own",
            "name = \"own\"\nn = 3\naxes = 2\nmu = \"tan\"\ng = [\"b\", \"-c\"]\nlimits = [3, 40]\nprecision = \"f32\"\n\
             poles = [[-4, -5, -6], [-7, -5, -6]]\n"
                .to_owned(),
        ),
        (
            "following",
            "name = \"following\"\nn = 2\naxes = 2\nmu = \"rational(a=1)\"\ng = \"b\"\nguard = \"result\"\n\
             reference = \"input\"\n"
                .to_owned(),
        ),
        (
            "all",
            MIX.replace("poles = [[-4, -5], [-3]]", "pi0 = \"extern\"\nreference = \"input\"")
                .replace("eps = 1e-2", "eps = 0.25"),
        ),
    ] {
        assert_eq!(selftest(&format!("coupled_{name}"), &spec(&text)), 0.0, "{name}");
    }
}

/// Gains of one output, the drift of one, an entry of the decoupling, a bound and the reference of one.
#[test]
fn they_find_what_is_wrong() {
    let arm = example("two_link.toml");
    let axes = "name = \"axes\"\nn = 2\naxes = 2\nmu = \"exp\"\npoles = [[-4, -5], [-3, -6]]\ng = [\"2\", \"1\"]\nlimits = [3, 8]\n";
    let follows = MIX.replace("mu =", "reference = [\"sin(t)\", \"cos(t)\"]\nmu =");
    for (index, (text, from, to)) in [
        (MIX, "[-3]", "[-3.000001]"),
        (MIX, "v = \"-v", "v = \"-1.000001*v"),
        (MIX, "h*b\", h", "1.000001*h*b\", h"),
        (&arm, "[120, 60]", "[120, 60.001]"),
        (&arm, "(m1 + m2)*grav", "(m1 + 1.000001*m2)*grav"),
        (&follows, "cos(t)", "1.000001*cos(t)"),
        (axes, "[-3, -6]", "[-3, -6.000001]"),
        (axes, "limits = [3", "limits = [3.000001"),
        (axes, "\"2\"", "\"2.000001\""),
    ]
    .into_iter()
    .enumerate()
    {
        assert!(text.contains(from), "{from}");
        let other = text.replace(from, to);
        let found = selftest_of(&format!("coupled_wrong{index}"), &spec(text), &spec(&other));
        assert!(found > 0.0, "{to}");
    }
}
