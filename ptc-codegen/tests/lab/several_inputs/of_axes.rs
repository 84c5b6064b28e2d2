//! Several axes run as one plant: each as the chain that it is, and together where one ends all.

use super::support::run_in;
use super::{folder_with, near, run};

/// Axes with gains, limits and input gains of their own.
const GANTRY: &str = "name = \"gantry\"\nn = 2\naxes = 3\nmu = \"exp(a=1)\"\n\
    poles = [[-4, -5], [-3, -6], [-6, -7]]\ng = [\"1/m1\", \"0.5\", \"1 + m1\"]\nlimits = [9, 8, 7]\n\
    [params]\ntau = 1.5\nt0 = 0.25\neps = 0.02\nm1 = 1.5\n";

/// Axes that share all.
const SHARED: &str = "n = 2\naxes = 2\nmu = \"rational(a=1)\"\npoles = [-4, -5]\n[params]\n\
    tau = 1\nt0 = 0\neps = 0.01\nu_max = inf\n";

const PLANT: &str = "[plant]\nf = \"0.3*sin(3*t) - 0.4*x2*abs(x1)\"\n";

/// The design of one axis of the gantry.
fn alone(axis: usize) -> String {
    let poles = ["[-4, -5]", "[-3, -6]", "[-6, -7]"][axis];
    let g = ["1/m1", "0.5", "1 + m1"][axis];
    let limit = [9, 8, 7][axis];
    let mass = if g.contains("m1") { "m1 = 1.5\n" } else { "" };
    format!(
        "n = 2\nmu = \"exp(a=1)\"\npoles = {poles}\ng = \"{g}\"\n[params]\ntau = 1.5\nt0 = 0.25\neps = 0.02\n\
         {mass}u_max = {limit}\n{PLANT}"
    )
}

const STARTS: [&str; 3] = ["0.4,0", "-0.3,1", "2,-0.5"];

/// The rows of all axes beside those of each alone, to `within`.
fn beside(test: &str, further: &[&str], within: f64) {
    let design = format!("{GANTRY}{PLANT}");
    let start = format!("--x0={}", STARTS.join(","));
    let (head, rows, _) = run(test, &design, &[&[start.as_str()], further].concat());
    assert!(head.starts_with("tau,t,x1_1,x2_1,x1_2,x2_2,x1_3,x2_3,u1,u2,u3"), "{head}");
    for (axis, start) in STARTS.iter().enumerate() {
        let start = format!("--x0={start}");
        let (_, own, _) = run(test, &alone(axis), &[&[start.as_str()], further].concat());
        assert_eq!(own.len(), rows.len());
        for (all, own) in rows.iter().zip(&own) {
            near(
                &[all[1], all[2 + 2 * axis], all[3 + 2 * axis], all[8 + axis]],
                &own[1..5],
                within,
            );
        }
    }
}

#[test]
fn each_axis_runs_as_if_it_were_alone() {
    // Integrated together the steps are others, each to a relative 1e-9.
    beside("axes_at_every_instant", &["--at", "0,0.3,0.7,0.9,0.97"], 1e-8);
    // u of `tick` and `axis` differs from that of `step` in the last bits, which hundreds of samples carry on.
    beside("axes_sampled", &["--sample-time=1e-3", "--until=1.6"], 1e-9);
}

/// Rates in the names of all axes: a spring between them pulls both.
#[test]
fn axes_that_pull_each_other() {
    let coupled = format!(
        "{SHARED}[plant]\ndynamics = {{ x2_1 = \"u1 - k*(x1_1 - x1_2)\", x2_2 = \"u2 + k*(x1_1 - x1_2)\" }}\nk = 2\n"
    );
    let further = ["--x0=1,0,-1,0", "--at", "0,0.5"];
    let (_, rows, _) = run("axes_with_a_spring", &coupled, &further);
    // By symmetry each is a chain on a spring of its own, at x1_2 = -x1_1: u - 2 k x1.
    let one = "n = 2\nmu = \"rational(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 1\nt0 = 0\neps = 0.01\nu_max = inf\n\
        [plant]\nf = \"-4*x1\"\n";
    let (_, own, _) = run("axes_with_a_spring", one, &["--x0=1,0", "--at", "0,0.5"]);
    near(&rows[1][2..4], &own[1][2..4], 1e-8);
    near(&rows[1][4..6], &own[1][2..4].iter().map(|x| -x).collect::<Vec<_>>(), 1e-8);
}

#[test]
fn what_is_wrong_names_the_axes() {
    for (design, further, wanted) in [
        (
            SHARED.to_owned(),
            &["--x0", "1,0"][..],
            "give one number for each of x1_1, x2_1, x1_2, x2_2",
        ),
        (format!("{SHARED}[plant]\ndynamics = {{ x3_1 = \"0\" }}\n"), &["--x0", "1,0,1,0"], "x3_1"),
        (
            format!("{SHARED}[plant]\ndynamics = {{ x2_1 = \"u1\" }}\nf = \"0\"\n"),
            &["--x0", "1,0,1,0"],
            "nothing of the plant is called `f`",
        ),
        (
            SHARED.replace("u_max", "reference = \"input\"\nu_max").replace("[params]\n", ""),
            &["--x0", "1,0,1,0"],
            "reference",
        ),
    ] {
        let folder = folder_with("several_axes_wrong", "plant.toml", &design);
        let (code, _, told) = run_in(&folder, &[&["simulate", "plant.toml"], further].concat());
        assert!(code == Some(2) && told.contains(wanted), "{told}");
    }
}

/// A campaign runs them, and proves nothing that is a theorem of one chain.
#[test]
fn a_campaign_of_axes_is_decided_by_sampling() {
    let design = format!(
        "{SHARED}[verify]\nscenarios = 40\nx1_1 = [-1, 1]\nx2_1 = [0, 0]\nx1_2 = [-1, 1]\nx2_2 = [0, 0]\n\
         [[objective]]\nbound = \"within\"\nh = \"abs(x2_2)\"\nhigh = 5\n"
    );
    let folder = folder_with("several_axes_campaign", "plant.toml", &design);
    let (code, told, stderr) = run_in(&folder, &["verify", "plant.toml"]);
    assert_eq!(code, Some(0), "{told}{stderr}");
    assert!(told.contains("holds, by sampling"), "{told}");
    let high = folder_with(
        "several_axes_campaign",
        "plant.toml",
        design.replace("high = 5", "high = 0.5"),
    );
    let (code, told, stderr) = run_in(&high, &["verify", "plant.toml"]);
    assert_eq!(code, Some(1), "{told}{stderr}");
}
