//! Designs whose duration changes in flight.

use ptc_codegen::request::Spec;

use crate::support;

/// Each family, in both precisions and at several orders.
pub(super) fn families() -> Vec<(String, Spec)> {
    let families = ["exp", "rational", "power", "tan", "tanh", "algebraic", "exp_sum(2)", "soft"];
    let mut all = Vec::new();
    for mu in families {
        for (n, precision) in [(1, "f64"), (2, "f64"), (3, "f32"), (4, "f64"), (7, "f64")] {
            let name = mu.split('(').next().expect("a name");
            let text = format!("n = {n}\nmu = \"{mu}\"\nprecision = \"{precision}\"\n");
            all.push(design(&format!("{name}{n}_{precision}"), &text));
        }
    }
    all
}

/// Other kinds: user-defined mappings, laws, plants and guards.
pub(super) fn kinds() -> Vec<(String, Spec)> {
    let double = "n = 2\nmu = \"exp\"\n";
    let kinds = [
        ("own_mu", "n = 3\nmu = \"tau*(1 - exp(-c*t))\"\n[params]\nc = [0.2, 5]\n".to_owned()),
        ("own_kappa", "n = 2\nkappa = \"atanh(dt/tau)\"\n".to_owned()),
        ("iterated", "n = 2\nmu = \"tau*(1 - exp(-t) + t*exp(-2*t)/8)\"\n".to_owned()),
        ("of_tau", "n = 2\nkappa = \"dt/(c*tau*(tau - dt)) + dt\"\n[params]\nc = [0.5, 2]\n".to_owned()),
        ("fixed", format!("{double}poles = [-4, -5]\n[params]\nt0 = 0.5\neps = 0.02\nu_max = 3\n")),
        ("latched", format!("{double}pi0 = \"-3*xi1 - 4*xi2 + xi1_0/8 - xi2_0\"\n")),
        ("soft_latched", "n = 3\nmu = \"soft\"\npi0 = \"-3*xi1 - 4*xi2 - xi3 + xi3_0\"\n".to_owned()),
        ("law", "n = 2\nmu = \"tan\"\npi0 = \"-xi1 - atan(xi2) + t/9\"\n".to_owned()),
        ("given", "n = 2\nmu = \"algebraic\"\npi0 = \"extern\"\nafter = \"extern\"\n".to_owned()),
        ("zero", format!("{double}after = \"zero\"\nguard = \"result\"\n")),
        ("trusting", "n = 3\nmu = \"tanh\"\nguard = \"none\"\n".to_owned()),
        ("least", format!("{double}[params]\nu_min = \"runtime\"\n")),
        ("follows", format!("{double}reference = \"input\"\n")),
        ("knows", format!("{double}reference = \"sin(t)\"\n")),
        ("gained", "n = 2\nmu = \"power\"\ng = \"2 + x1\"\nf = \"-x2\"\n".to_owned()),
        ("axes", "n = 2\nmu = \"exp\"\naxes = 3\n".to_owned()),
        (
            "own_axes",
            "n = 2\nmu = \"tan\"\naxes = 2\npoles = [[-4, -5], [-2, -3]]\nlimits = [4, 2]\ng = [2, 0.5]\n"
                .to_owned(),
        ),
        ("fused", format!("{double}fma = true\nlatency = true\n")),
        (
            "model",
            "mu = \"exp\"\n[model]\nstates = [\"q\", \"v\"]\ninput = \"F\"\noutput = \"q\"\n\
             dynamics = { q = \"v\", v = \"-9.81*sin(q) + F/m\" }\n[params]\nm = [0.5, 2]\n"
                .to_owned(),
        ),
        (
            "inputs",
            "mu = \"rational\"\n[model]\nstates = [\"p\", \"q\", \"v\", \"w\"]\n\
             inputs = [\"F\", \"G\"]\noutputs = [\"p + q/4\", \"q\"]\n\
             dynamics = { p = \"v\", q = \"w\", v = \"(F - 80*p + 50*q)/2\", w = \"G + 50*(p - q)\" }\n"
                .to_owned(),
        ),
    ];
    kinds.iter().map(|(name, text)| design(name, text)).collect()
}

/// A design called `own`, whose duration changes in flight, and the name of its test.
fn design(name: &str, text: &str) -> (String, Spec) {
    let keys =
        "name = \"own\"\nin_flight = true\nallow = [\"growth\", \"membership\", \"sampling\"]\n";
    (name.to_owned(), support::spec(&format!("{keys}{text}")))
}
