//! The transitions against 60 digits of mpmath, by the definition: x = BB_n\[mu\] xi, xi the exponential of the
//! companion matrix and the integral of what f adds.

use super::*;
use crate::diagnostic::Place;
use crate::simulate::Continuous;

/// T/tau with x_1..x_n and u of the law there, from x0 = (0.75, -1, 0.25, 0.5) with f = 0, and from rest under
/// f = 0.25; tau = 2.
type Case = (&'static str, &'static str, f64, [&'static [f64]; 2]);

#[rustfmt::skip]
const CASES: [Case; 11] = [
    ("exp(a=1)", "-4, -5, -6", 1e-3, [&[1.749e-12, -3.4975e-9, 5.245e-6, -0.0052425], &[3.32334333e-10, -4.98002499e-7, 0.0004970049975, -0.497007495]]),
    ("exp(a=1)", "-4, -5, -6", 1e-6, [&[1.749999e-24, -3.4999975e-18, 5.249995e-12, -5.2499925e-6], &[3.3333233333433334e-19, -4.999980000025e-13, 4.99997000005e-7, -0.49999700000749997]]),
    ("exp(a=1)", "-4, -5, -6", 1e-12, [&[1.749999999999e-48, -3.4999999999975e-36, 5.249999999995e-24, -5.2499999999925e-12], &[]]),
    ("tanh(a=1/2)", "-4, -5, -6", 1e-3, [&[3.6766438486321274e-13, -7.355673733883978e-10, 1.1039477305166186e-6, -0.0011051415552949715], &[3.1978432083568384e-10, -4.743628695429658e-7, 0.0004644505685446278, -0.46877312810527916]]),
    ("tanh(a=1/2)", "-4, -5, -6", 1e-12, [&[3.6718750000047654e-49, -7.343750000011914e-37, 1.1015625000023829e-24, -1.1015625000035741e-12], &[]]),
    ("rational(a=1)", "-2, -3", 1e-2, [&[2.5564222677932584e-87, -2.5564222677932587e-83, 2.5308580451153258e-79], &[1.7240440464585118e-9, -3.47772022002287e-7, -0.24994708362091983]]),
    ("power(a=1, m=1/2)", "-2, -3", 1e-3, [&[1.587553661643357e-54, -5.020285478533298e-50, 1.5499015205543575e-45], &[1.8083864426359262e-10, -2.750694963741468e-7, -0.24971811543322625]]),
    ("tan(a=1)", "-2, -3", 1e-2, [&[4.991662601563539e-56, -3.1780524848840313e-52, 1.9915995491875944e-48], &[4.338225711907894e-9, -8.794965114446607e-7, -0.24986505398466138]]),
    ("algebraic(a=1)", "-1", 1e-2, [&[0.0006717622988033717, -0.11964815775248842], &[0.003581087870887947, -0.637830624411001]]),
    ("algebraic(a=1)", "-1", 1e-3, [&[1.483290732450878e-10, -8.298070044913818e-7], &[5.208039802667868e-5, -0.2913567659647487]]),
    ("algebraic(a=1)", "-2, -2, -3, -7", 1e-2, [&[-2.7129700124556455e-5, 0.008850424209471974, -2.2025119998241194, 358.24373441044975, -19515.53855017157], &[2.5286837430251755e-6, -0.0008180050415666042, 0.20089287668745168, -31.811796336162853, 1500.382089780027]]),
];

const X0: [f64; 4] = [0.75, -1.0, 0.25, 0.5];

fn campaign(mu: &str, poles: &str, rest: &str) -> Campaign {
    let n = poles.split(',').count();
    let states: String = (1..=n).map(|j| format!("x{j} = [-1, 1]\n")).collect();
    let text = format!(
        "n = {n}\nmu = \"{mu}\"\npoles = [{poles}]\nallow = \"growth\"\n{rest}[plant]\nf = \"d\"\nd = [-1, 1]\n\
         [verify]\n{states}tau = [2, 5]\nuntil = 1e-3\n[[objective]]\nbound = \"attractive\"\nerror = 1\n"
    );
    let (entries, found) = crate::design::read(&text, &mut |_| Place(0));
    assert_eq!(found, [], "{text}");
    let (spec, plant) = crate::plant::read_design(&entries).expect("a design");
    crate::verify::read(&entries, &spec, &plant.expect("a plant")).expect("a campaign")
}

/// The run to some T/tau by steps, each a third of the rest.
fn run(mu: &str, poles: &str, end: f64, start: &[f64], f: f64) -> Vec<f64> {
    let campaign = campaign(mu, poles, "");
    let exact = Exact::of(&campaign).expect("a linear loop");
    let plant = campaign.disturbed();
    let side = Continuous::of(&campaign.spec, &plant).expect("a loop");
    let mut side = side.in_lanes().expect("lanes");
    let mut nodes: Vec<_> =
        (0..).map(|k| 0.8f64.powi(k)).take_while(|share| *share > end).collect();
    nodes.push(end);
    let values = campaign.setting(&campaign.scenario(0)).values;
    let table = Table::new(&mut side, (&exact.gains, exact.rate), (2.0, &values), &nodes, true)
        .expect("a table");
    let mut x = start.to_vec();
    let dot = |row: &[f64], x: &[f64]| row.iter().zip(x).map(|(a, b)| a * b).sum::<f64>();
    for step in &table.steps[1..] {
        let rows = step.transition.chunks(table.n).zip(&step.force);
        x = rows.map(|(row, force)| dot(row, &x) + force * f).collect();
    }
    x.push(table.steps.last().map_or(f64::NAN, |step| dot(&step.control, &x)));
    x
}

#[test]
fn states_and_u_have_their_digits() {
    for (mu, poles, end, [free, forced]) in CASES {
        let n = poles.split(',').count();
        for (wanted, start, f) in [(free, &X0[..n], 0.0), (forced, &[0.0; 4][..n], 0.25)] {
            let found = run(mu, poles, end, start, f);
            for (found, wanted) in found.iter().zip(wanted) {
                let off = ((found - wanted) / wanted).abs();
                println!("{mu} {poles} {end}: {found:e} {wanted:e}, {off:.1e}");
                assert!(off < 1e-11, "{mu} {poles} {end}: {found:e} {wanted:e}, {off:.1e}");
            }
        }
    }
}

#[test]
fn only_linear_loops_are_run_here() {
    let with = |from: &str, to: &str| {
        let mut campaign = campaign("exp(a=1)", "-3, -4", "");
        let text = "n = 2\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n[plant]\nf = \"d\"\nd = [-1, 1]\n";
        let (entries, _) = crate::design::read(&text.replace(from, to), &mut |_| Place(0));
        let (spec, plant) = crate::plant::read_design(&entries).expect("a design");
        (campaign.spec, campaign.plant) = (spec, plant.expect("a plant"));
        Exact::of(&campaign).is_some()
    };
    assert!(with("", ""));
    for f in ["d*x1", "d + 1e-9*x2^2", "d + u", "d*sin(dt)", "d + abs(x1)", "d + t"] {
        assert!(!with("f = \"d\"", &format!("f = \"{f}\"")), "{f}");
    }
    for (from, to) in [
        ("poles = [-3, -4]", "pi0 = \"-12*xi1 - 7*xi2 - xi1^3\""),
        ("poles = [-3, -4]\n", ""),
        ("(a=1)", ""),
        ("[plant]", "g = 2\n[plant]\ng = 2.01"),
        ("[plant]", "g = \"2 + x1\"\n[plant]"),
        ("[plant]", "f = \"x1\"\n[plant]"),
        ("[plant]", "reference = \"sin(t)\"\n[plant]"),
    ] {
        assert!(!with(from, to), "{to}");
    }
    assert!(with("[plant]", "g = 2\n[plant]\ng = \"4/2\""));
}
