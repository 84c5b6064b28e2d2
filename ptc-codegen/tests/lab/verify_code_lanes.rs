//! Sampled loops whose controllers run in lanes by their code: each with the bits that it has by itself.

use crate::verify_lanes::{beside, campaign, in_any_company};

/// Each scenario by itself, in lanes and in other company.
fn same_in_lanes(text: &str) {
    assert_eq!(beside(text, 20), (0.0, true), "{text}");
    in_any_company(&campaign(text));
}

/// A box, and objectives of every instant, of u and of the end.
pub(crate) fn objectives(states: &[&str], more: &str) -> String {
    let within: String = states.iter().map(|x| format!("{x} = [-0.4, 0.5]\n")).collect();
    let (first, last) = (states[0], states[states.len() - 1]);
    format!(
        "[verify]\n{within}{more}scenarios = 20\nseed = 3\n[[objective]]\nbound = \"attractive\"\nerror = 0.1\n\
         [[objective]]\nbound = \"input\"\nupsilon = 5\n[[objective]]\nbound = \"within\"\n\
         h = \"{first} + 0.1*{last} + T\"\nhigh = 3\n"
    )
}

/// A chain in samples with an observer of an unknown force, beside what the keys say.
pub(crate) fn chain(keys: &str, params: &str, plant: &str, more: &str) -> String {
    format!(
        "n = 2\ng = \"1/1.5\"\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\npoles = [-4, -5]\n{keys}\
         [params]\ntau = 0.5\n{params}[plant]\n{plant}gust = [-0.1, 0.3]\n[disturbance]\ngust = \"any\"\n{}",
        objectives(&["x1", "x2"], more)
    )
}

pub(crate) const OBSERVER: &str = "measured = [\"x1\"]\ndisturbance = \"constant\"\nobserver_poles = [-4, -5, -6]\n\
    observer_samples = 25\nobserver_eps = 0.05\n";

#[test]
fn chains_in_samples_have_the_same_bits_in_lanes() {
    let loops = [
        "sensor_step = [1e-4, 0]\ndelay = 1\n",
        "noise = [1e-3, 1e-2]\nu_step = 1e-2\njitter = 1e-3\ng_error = [0.9, 1.1]\n",
        "delay = \"1/2\"\nnoise_rms = [1e-4, 1e-3]\n",
        "delay = \"1/2\"\njitter = 1e-3\n",
        "delay = \"5/2\"\nafter = \"zero\"\nprecision = \"f32\"\n",
        "innovation_max = 0.02\ncoast = 3\nnoise = [3e-2, 0]\n",
    ];
    let plants = [
        "f = \"gust\"\n",
        "f = \"gust - damping*x2 - 0.3*sin(4*t)\"\ndamping = [0, 0.5]\n",
        "f = \"gust - 0.2*sign(x2)\"\n",
    ];
    for keys in loops {
        for plant in plants {
            for (params, more) in
                [("eps = 0.05\nu_max = 4\n", ""), ("eps = 0.08\n", "until = -0.3\n")]
            {
                same_in_lanes(&chain(&format!("{OBSERVER}{keys}"), params, plant, more));
            }
        }
    }
}

/// Lanes in which different things happen at different samples, and whose deadlines differ.
#[test]
fn events_have_the_same_bits_in_lanes() {
    let events = [
        "[[event]]\nat = [0.1, 0.4]\nmove = [-0.2, 0.2]\narm = true\n",
        "[[event]]\nat = 0.2\nkick = [-3, 3]\nfor = [0.01, 0.1]\n",
        "[[event]]\nat = [0.6, 0.7]\narm = true\n[[event]]\nat = 0.65\nkick = 2\nfor = 0.03\n",
    ];
    for events in events {
        for keys in ["", "delay = 2\n", "delay = \"1/2\"\nnoise = [1e-3, 0]\n"] {
            let text = chain(
                &format!("{OBSERVER}{keys}"),
                "eps = 0.05\nu_max = 9\n",
                "f = \"gust\"\n",
                "",
            );
            same_in_lanes(&format!("{text}{events}"));
        }
    }
    let moved = "[[event]]\nat = [0.2, 0.3]\nmove = [-0.1, 0.1]\ntau = [0.3, 0.6]\n";
    let late = chain("late = \"extend\"\n", "u_max = 4\n", "f = \"gust\"\n", "");
    same_in_lanes(&format!("{late}{moved}"));
    let in_time =
        chain("", "eps = 0.06\n", "f = \"gust - x2\"\n", "").replace("clock = \"samples\"\n", "");
    same_in_lanes(&format!(
        "{in_time}[[event]]\nat = [0.1, 0.4]\nmove = [-0.2, 0.2]\narm = true\n"
    ));
}

#[test]
fn plants_by_matrices_have_the_same_bits_in_lanes() {
    for delay in ["", "delay = 2\n", "delay = \"1/2\"\n"] {
        for period in ["jitter = 1e-3\n", "sensor_step = 1e-4\n"] {
            let text = format!(
                "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.01\npoles = [-4, -5]\n\
                 observer_poles = [-4, -5]\n{delay}{period}[params]\ntau = 0.5\neps = 0.05\nu_max = 20\n[plant]\n\
                 A = [[0, 1], [-2, -0.5]]\nB = [0, 2]\nC = [[1, 0]]\n{}",
                objectives(&["x1", "x2"], "")
            );
            same_in_lanes(&text);
        }
    }
}

#[test]
fn several_axes_and_references_have_the_same_bits_in_lanes() {
    let states = ["x1_1", "x2_1", "x1_2", "x2_2"];
    for keys in [
        "clock = \"samples\"\nreference = [\"0.1*sin(2*t)\", \"0.2*t\"]\n",
        "clock = \"samples\"\nlimits = [3, 2]\nnoise = 1e-3\n",
        "limits = [3, 2]\nsensor_step = 1e-3\n",
        "precision = \"f32\"\n",
    ] {
        let text = format!(
            "n = 2\naxes = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 0.01\n{keys}[params]\ntau = 0.5\n\
             eps = 0.06\n{}",
            objectives(&states, "")
        );
        same_in_lanes(&text);
    }
    let text =
        chain("reference = \"0.1*sin(3*t)\"\ndelay = 1\n", "eps = 0.05\n", "f = \"gust\"\n", "");
    same_in_lanes(&text);
}

/// Models, with either clock, whose plants are integrated between samples.
#[test]
fn models_have_the_same_bits_in_lanes() {
    for clock in ["", "clock = \"samples\"\n"] {
        for friction in ["0.02*w", "0.02*w - 0.1*sign(w)", "load*w"] {
            let text = format!(
                "mu = \"exp(a=1)\"\npoles = [-3, -4]\nsample_time = 0.01\nnoise = [1e-4, 1e-3]\n{clock}[params]\n\
                 tau = 0.5\neps = 0.06\nu_max = 25\n[model]\nstates = [\"q\", \"w\"]\ninput = \"M\"\noutput = \"q\"\n\
                 dynamics = {{ q = \"w\", w = \"(M - 0.02*w)/0.25 - 20*sin(q)\" }}\n[plant]\nload = [-0.2, 0.2]\n\
                 dynamics = {{ w = \"(M + load - {friction})/0.25 - 20*sin(q)\" }}\n[disturbance]\nload = \"any\"\n{}",
                objectives(&["q", "w"], "")
            );
            same_in_lanes(&text);
        }
    }
}

/// A mechanical plant, of which the equations of motion are solved, with friction and without.
#[test]
fn inertias_have_the_same_bits_in_lanes() {
    for bias in ["0.02*w", "0.02*w + 0.1*sign(w)"] {
        let text = format!(
            "mu = \"exp(a=1)\"\npoles = [-3, -4]\nsample_time = 0.01\nnoise = [1e-4, 1e-3]\n[params]\ntau = 0.5\n\
             eps = 0.06\nu_max = 25\n[model]\nstates = [\"q\", \"w\"]\ninputs = [\"M\"]\n\
             inertia = [[\"0.3 + 0.1*cos(q)\"]]\nbias = [\"5*sin(q)\"]\n[plant]\nload = [-0.2, 0.2]\n\
             inertia = [[\"0.32 + 0.1*cos(q)\"]]\nbias = [\"5*sin(q) - load + {bias}\"]\n[disturbance]\n\
             load = \"any\"\n{}",
            objectives(&["q", "w"], "")
        );
        same_in_lanes(&text);
    }
}
