//! One mistake gives one message: nothing that depends on a key that was given and not understood is reported.

use ptc_codegen::Design;

/// Designs without a mistake that together have every kind of dependence between keys.
const DESIGNS: [&str; 6] = [
    "name = \"stage\"\nn = 2\nmu = \"exp(a=1)\"\nprecision = \"f64\"\nclock = \"samples\"\npoles = [-4, -5]\nsample_time = 1e-3\nmeasured = \"x1\"\ndisturbance = \"constant\"\nobserver_poles = [-4, -5, -6]\nobserver_samples = 100\nnoise = 1e-5\n[params]\ntau = 0.5\nu_max = inf\n",
    "n = 2\nmu = \"exp(a=1)\"\ngains = [20, 9]\ng = \"1/inertia_1\"\nf = \"-drag*x2\"\nreference = \"0.1*sin(t)\"\nafter = \"zero\"\nguard = \"full\"\nsample_time = 1e-3\njitter = 1e-5\nerror = 1e-2\nx0_max = [0.5, 0]\n[params]\ntau = 0.5\nt0 = 0\nu_max = inf\ninertia_1 = 2\ndrag = 0.1\n[envelope]\nx_max = [10, 10]\n",
    "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\npoles = [-4, -5]\nmeasured = \"x1\"\nobserver_poles = [-4, -5]\n[params]\ntau = 0.5\n[plant]\nA = [[0, 1], [-4, -0.2]]\nB = [0, 1]\n",
    "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\npoles = [-4, -5]\nobserver_poles = [-4, -5]\n[params]\ntau = 0.5\n[plant]\nA = [[0, 1], [-4, -0.2]]\nB = [0, 1]\nC = [1, 0]\n",
    "mu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 0.5\neps = 1e-2\nmass = 2\n[model]\nstates = [\"p\", \"v\"]\ninput = \"force\"\noutput = \"p\"\ndynamics = { p = \"v\", v = \"force/mass\" }\n",
    "n = 2\naxes = 2\nmu = \"exp(a=1)\"\npoles = [[-4, -5], [-3, -6]]\nlimits = [20, 10]\ng = [1, 2]\n[params]\ntau = 0.5\n",
];

/// The codes and keys of the mistakes.
fn mistakes(text: &str) -> Vec<(&'static str, String)> {
    let found = Design::read(text).err();
    let all = found.iter().flat_map(|found| found.list());
    all.map(|own| (own.code, own.key.clone())).collect()
}

/// The design with one of its lines replaced.
fn with(design: &str, line: usize, text: &str) -> String {
    let lines = design.lines().enumerate();
    let lines = lines.map(|(at, own)| format!("{}\n", if at == line { text } else { own }));
    lines.collect()
}

#[test]
fn a_key_that_is_not_understood_is_one_mistake() {
    let mut tried = 0;
    for design in DESIGNS {
        assert_eq!(mistakes(design), [], "{design}");
        for (at, line) in design.lines().enumerate() {
            let Some((key, value)) = line.split_once(" = ") else { continue };
            let unreadable = format!("{key} = \"%\"");
            let unquoted = format!("{key} = %");
            let misspelt = format!("{key}_ = {value}");
            // Any other name under [plant] is a symbol of the plant.
            let is_symbol = ["A", "B", "C"].contains(&key);
            let all = [Some(unreadable), Some(unquoted), (!is_symbol).then_some(misspelt)];
            for text in all.into_iter().flatten() {
                // A parameter under another name is another parameter.
                let own = ["inertia_1", "drag", "mass"].contains(&key);
                let found = mistakes(&with(design, at, &text));
                assert_eq!(found.len(), 1, "{text}: {found:?}");
                assert!(
                    own || found[0].1.contains(key) || found[0].0 == "toml",
                    "{text}: {found:?}"
                );
                tried += 1;
            }
        }
    }
    assert!(tried > 150, "{tried}");
}

/// Values that can be read and are not legal.
#[test]
fn a_value_that_is_not_legal_is_one_mistake() {
    for design in DESIGNS {
        for (at, line) in design.lines().enumerate() {
            let Some((key, _)) = line.split_once(" = ") else { continue };
            let text = format!("{key} = \"zebra(1)\"");
            let found = mistakes(&with(design, at, &text));
            assert_eq!(found.len(), 1, "{text} in\n{design}: {found:?}");
        }
    }
}
