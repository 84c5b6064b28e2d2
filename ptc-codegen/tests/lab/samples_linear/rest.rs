//! Loops with the exact plant, which come to rest.

use ptc_codegen::algebra::BigRational;
use ptc_codegen::code::{Code, Instance, Status};

use super::code;
use super::plant::{Plant, double, number};

/// Accepted residue at rest, relative to the largest state on the way: with as few samples as twice the order the last
/// inputs are full-size ones, and the condition of the plant counts a hundred times their rounding.
pub(super) const REST: f64 = 1e-13;

/// A, B, C and h.
pub(super) const PLANTS: [(&str, [&str; 4]); 7] = [
    ("motor", ["0,1,0;0,-0.5,1500;0,-15,-600", "0,0,500", "1,0,0", "0.001"]),
    (
        "joint",
        ["0,1,0,0;-900,-0.6,900,0.6;0,0,0,1;400,0.3,-400,-0.3", "0,0,0,1", "1,0,0,0", "0.005"],
    ),
    (
        "two encoders",
        [
            "0,1,0,0;-900,-0.6,900,0.6;0,0,0,1;400,0.3,-400,-0.3",
            "0,0,0,1",
            "1,0,0,0;0,0,1,0",
            "0.001",
        ],
    ),
    ("unstable", ["0,1;49,0", "0,-1.3", "1,0.1", "0.01"]),
    ("mixed", ["3.1,-2,0.4;1.2,-7,1;0.3,0.9,-1.5", "1,-0.4,0.7", "1,0,2;0,1,-1", "0.1"]),
    ("stiff", ["-9000,3;2,-0.5", "1,0.25", "0.3,1", "0.001"]),
    ("first", ["-0.25", "2", "4", "0.5"]),
];

pub(super) fn listed(rows: &str) -> String {
    format!("[[{}]]", rows.replace(';', "],["))
}

pub(super) fn poles(count: usize) -> String {
    let each: Vec<_> = (0..count).map(|i| format!("-{}", count + i)).collect();
    each.join(",")
}

/// The rows of a matrix.
pub(super) fn rows(text: &str) -> Vec<Vec<BigRational>> {
    text.split(';').map(|row| row.split(',').map(number).collect()).collect()
}

fn run(code: &Code, plant: &mut Plant, samples: u32) {
    let mut controller = Instance::new(code, &[]).expect("legal parameters");
    for k in 0..samples {
        let y = plant.measured();
        let x: Vec<_> = plant.x.iter().map(double).collect();
        let outcome = controller.call("step", &[("k", &[f64::from(k)][..]), ("x", &x), ("y", &y)]);
        assert_eq!(outcome.status, Status::Ok, "sample {k}");
        plant.step(outcome.results["u"][0]);
    }
}

#[test]
fn comes_to_rest_with_all_states() {
    for (name, [a, b, _, h]) in PLANTS {
        let n = b.split(',').count();
        for (delay, inputs) in [("0", 0), ("0.3", 1), ("1", 1), ("1.75", 2), ("2", 2)] {
            let order = n + inputs;
            for samples in [2 * order as u32, 60] {
                let mut chosen = poles(order);
                if order > 1 && samples == 60 {
                    chosen = format!("-{order}+2i,-{order}-2i,{}", poles(order));
                    chosen = chosen.split(',').take(order).collect::<Vec<_>>().join("\",\"");
                    chosen = format!("\"{chosen}\"");
                }
                let code = code(&format!(
                    "sample_time = {h}\ntau = \"{samples}*{h}\"\ndelay = {delay}\npoles = [{chosen}]\n\
                     [plant]\nA = {}\nB = [{b}]\n",
                    listed(a)
                ));
                let ones: Vec<_> = (0..n)
                    .map(|i| {
                        (0..n).map(|j| if i == j { "1" } else { "0" }).collect::<Vec<_>>().join(",")
                    })
                    .collect();
                let [a, b, c] = [a, b, ones.join(";").as_str()].map(rows);
                let mut plant = Plant::new(&a, &b[0], &c, &number(h), delay, &number("0"));
                run(&code, &mut plant, samples);
                assert!(
                    plant.left() <= REST,
                    "{name}, d = {delay}, N = {samples}: {}",
                    plant.left()
                );
            }
        }
    }
}

#[test]
fn comes_to_rest_with_an_observer() {
    for (name, [a, b, c, h]) in PLANTS {
        let n = b.split(',').count();
        for (delay, inputs, disturbance) in
            [("0", 0, "0"), ("1", 1, "0"), ("1", 1, "0.3"), ("1.4", 2, "0.3"), ("2", 2, "0.3")]
        {
            let estimates = n + usize::from(disturbance != "0");
            let known = c.split(';').count() == n && disturbance == "0";
            let own = match known {
                true => String::new(),
                false => format!("observer_poles = [{}]\n", poles(estimates)),
            };
            let constant = if disturbance == "0" { "none" } else { "constant" };
            let samples = 100;
            let rounds = 2 * (estimates + n + inputs);
            let code = code(&format!(
                "sample_time = {h}\ntau = \"{samples}*{h}\"\ndelay = {delay}\npoles = [{}]\n{own}deadbeat = {rounds}\n\
                 disturbance = \"{constant}\"\n[plant]\nA = {}\nB = [{b}]\nC = {}\n",
                poles(n + inputs),
                listed(a),
                listed(c),
            ));
            let [a, b, c] = [a, b, c].map(rows);
            let added = number(disturbance);
            let mut plant = Plant::new(&a, &b[0], &c, &number(h), delay, &added);
            run(&code, &mut plant, samples);
            // What is left of a constant is the rounding of its estimate.
            let allowed = if disturbance == "0" { 1e-20 } else { 1e-12 };
            assert!(
                plant.left() <= allowed,
                "{name}, d = {delay}, {disturbance}: {}",
                plant.left()
            );
        }
    }
}
