//! Controllers with a clock in samples, and observers alone, of every kind: chains, linear plants and models that
//! are not linear, delays, observers, disturbances, references, what is fixed and what is not, both precisions, both guards.

mod apart;
mod inputs;

use ptc_codegen::request::{Spec, What};

use super::specs::spec;
use apart::APART;
use inputs::OF_INPUTS;

type Keys = &'static [(&'static str, &'static str)];

/// A motor: its observer alone, and behind the first two keys a controller with it.
const MOTOR: [(&str, &str); 11] = [
    ("what", "observer"),
    ("observer_samples", "20"),
    ("A", "[[0,1,0],[0,-0.5,1500],[0,-15,-600]]"),
    ("B", "[0,0,500]"),
    ("C", "[[1,0,0],[0,0,1]]"),
    ("mu", "exp(a=1)"),
    ("sample_time", "1e-3"),
    ("delay", "1"),
    ("disturbance", "constant"),
    ("observer_poles", "-4,-5,-6,-7"),
    ("after_observer", "-90+20i,-90-20i,-100,-120"),
];

const DESIGNS: [Keys; 25] = [
    &[("n", "1"), ("mu", "exp")],
    &[("n", "2"), ("mu", "exp"), ("precision", "f32"), ("after", "zero")],
    &[
        ("n", "3"),
        ("mu", "exp(a=1)"),
        ("poles", "-4,-5,-6"),
        ("sample_time", "1e-3"),
        ("tau", "0.02"),
        ("u_max", "inf"),
        ("guard", "none"),
    ],
    &[
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("poles", "-4,-5,-6"),
        ("sample_time", "1e-3"),
        ("tau", "0.04"),
        ("delay", "1"),
        ("measured", "x1"),
        ("disturbance", "constant"),
        ("observer_poles", "-4,-5,-6"),
        ("observer_samples", "20"),
    ],
    &[
        ("n", "2"),
        ("mu", "exp(a=2)"),
        ("precision", "f32"),
        ("measured", "x1"),
        ("disturbance", "constant"),
        ("observer_poles", "-4,-5,-6"),
        ("after", "zero"),
    ],
    &[("n", "4"), ("mu", "exp"), ("delay", "2"), ("eps", "0.01"), ("guard", "none")],
    &[
        ("n", "3"),
        ("mu", "exp(a=0.7)"),
        ("measured", "x1,x2"),
        ("observer_poles", "-4,-5.3"),
        ("sample_time", "2e-3"),
        ("g", "2"),
        ("f", "0.5"),
    ],
    &[
        ("n", "1"),
        ("mu", "exp(a=1)"),
        ("precision", "f32"),
        ("gains", "3"),
        ("disturbance", "constant"),
        ("observer_poles", "-4,-5"),
        ("guard", "none"),
    ],
    &[
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("poles", "-4,-5"),
        ("sample_time", "1e-3"),
        ("tau", "0.03"),
        ("eps", "0.005"),
        ("after", "zero"),
        ("u_max", "3"),
    ],
    &[
        ("n", "3"),
        ("mu", "exp(a=1)"),
        ("delay", "1"),
        ("measured", "x1"),
        ("observer_poles", "-4,-5,-6"),
        ("observer_eps", "0.05"),
        ("eps", "0.02"),
        ("u_max", "1e3"),
    ],
    &[("n", "2"), ("mu", "exp(a=1.3)"), ("deadbeat", "20"), ("precision", "f32")],
    &[
        ("n", "4"),
        ("mu", "exp(a=1)"),
        ("precision", "f32"),
        ("measured", "x1"),
        ("disturbance", "constant"),
        ("observer_poles", "-4,-5,-6,-7,-8"),
        ("sample_time", "0.01"),
    ],
    MOTOR.split_at(2).1,
    &[
        ("A", "[[0,1],[49,-0.1]]"),
        ("B", "[0.1,-1.3]"),
        ("C", "[[1,0.5],[0.2,-1]]"),
        ("mu", "exp(a=1)"),
        ("sample_time", "0.01"),
        ("precision", "f32"),
        ("after", "zero"),
    ],
    &[
        ("what", "observer"),
        ("n", "3"),
        ("mu", "exp(a=1)"),
        ("measured", "x1"),
        ("observer_poles", "-4,-5+i,-5-i"),
        ("observer_samples", "12"),
    ],
    &[
        ("what", "observer"),
        ("n", "2"),
        ("mu", "exp(a=1.5)"),
        ("precision", "f32"),
        ("measured", "x1"),
        ("disturbance", "constant"),
        ("observer_poles", "-4,-5,-6"),
        ("observer_samples", "9"),
        ("observer_eps", "0.05"),
        ("delay", "1.5"),
        ("f", "-9.81"),
        ("g", "0.5"),
    ],
    &MOTOR,
    &[
        ("what", "observer"),
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("guard", "none"),
        ("measured", "x1,x2"),
        ("disturbance", "constant"),
        ("observer_poles", "-4,-5"),
        ("observer_samples", "8"),
    ],
    // Models that are not linear: a stiff spring, and a motor whose torque falls with its angle.
    &[
        ("mu", "exp(a=1)"),
        ("poles", "-3,-4"),
        ("sample_time", "0.01"),
        ("tau", "0.3"),
        ("model.states", "q, w"),
        ("model.input", "F"),
        ("model.output", "q + q^3/6"),
        ("model.dynamics", "w, F/(2 + q^2) - k*q^3 - 3*w"),
    ],
    &[
        ("mu", "exp(a=1)"),
        ("precision", "f32"),
        ("guard", "none"),
        ("u_max", "inf"),
        ("after", "zero"),
        ("model.states", "q, w, i"),
        ("model.input", "V"),
        ("model.output", "q"),
        ("model.dynamics", "w, i/(1 + q^2) - w/4, 50*(V - 2*i - w)"),
    ],
    // References: given with each call, beside inputs under way and an observer; known; of a model, and of linear plants.
    &[
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("reference", "input"),
        ("delay", "1.25"),
        ("measured", "x1"),
        ("disturbance", "constant"),
        ("observer_poles", "-4,-5,-6"),
        ("g", "0.5"),
        ("f", "0.25"),
    ],
    &[
        ("n", "3"),
        ("mu", "exp(a=1)"),
        // t^8 stays within the range of doubles as long as ticks are counted.
        ("reference", "size*dt^2/(1 + t^2)"),
        ("delay", "0.25"),
        ("g", "2"),
    ],
    &[
        ("mu", "exp(a=1)"),
        ("poles", "-3,-4"),
        ("sample_time", "0.01"),
        ("tau", "0.3"),
        ("reference", "input"),
        ("model.states", "q, w"),
        ("model.input", "F"),
        ("model.output", "q + q^3/6"),
        ("model.dynamics", "w, F/(2 + q^2) - k*q^3 - 3*w"),
    ],
    // Of linear plants: given with each call beside an input under way and an observer; known.
    &[
        ("mu", "exp(a=1)"),
        ("poles", "-4,-5,-6,-7"),
        ("sample_time", "0.01"),
        ("tau", "0.5"),
        ("delay", "1"),
        ("reference", "input"),
        ("observer_poles", "-4,-5,-6"),
        ("A", "[[0,1,0],[0,-1,10],[0,-2,-50]]"),
        ("B", "[0,0,100]"),
        ("C", "[[1,0,0]]"),
    ],
    &[
        ("mu", "exp(a=1)"),
        ("precision", "f32"),
        ("poles", "-4,-5"),
        ("sample_time", "0.01"),
        ("tau", "0.3"),
        ("reference", "size*dt^2/(1 + t^2)"),
        ("A", "[[-1,1],[3,-2]]"),
        ("B", "[1,2]"),
        ("model.output", "[-2,1]"),
    ],
];

/// A stage whose position alone is measured, with a delay and a force that is not known.
pub const STAGE: [(&str, &str); 9] = [
    ("n", "2"),
    ("mu", "exp(a=1)"),
    ("clock", "samples"),
    ("poles", "-4,-5,-6"),
    ("delay", "1"),
    ("measured", "x1"),
    ("disturbance", "constant"),
    ("observer_poles", "-4,-5,-6"),
    ("name", "stage"),
];

/// The values with which nothing of the stage is left to run time.
pub const FIXED: [(&str, &str); 3] = [("sample_time", "1e-3"), ("tau", "0.1"), ("u_max", "6")];

/// The controller by which a layer shows that it sees defects.
pub fn example() -> Spec {
    spec(&[&STAGE[..], &FIXED].concat())
}

/// Returns the subject of a row of a table: the mapping, or the kind of controller in samples.
pub fn kind(spec: &Spec) -> &'static str {
    match (spec.sampled(), spec.what) {
        (Some(_), What::Observer) => "observer in samples",
        (Some(_), _) => "exp in samples",
        (None, _) => spec.mapping_name(),
    }
}

/// All of them.
pub fn controllers() -> Vec<Spec> {
    let behind = DESIGNS.len() + OF_INPUTS.len();
    let all = (0..).zip(DESIGNS).chain((behind..).zip(APART));
    all.map(|(index, keys)| named(index, keys)).collect()
}

/// Returns specs of plants with several inputs and of axes, which not every language and tool takes.
pub fn of_inputs() -> Vec<Spec> {
    let first = DESIGNS.len();
    (first..).zip(OF_INPUTS).map(|(index, keys)| named(index, keys)).collect()
}

/// A name of its own, long for one of them, so that its signatures are.
fn named(index: usize, keys: Keys) -> Spec {
    let name = match index {
        4 => format!("a_name_that_fills_half_of_a_line_alone_{index}"),
        _ => format!("stage{index}"),
    };
    spec(&[keys, &[("clock", "samples"), ("name", name.as_str())]].concat())
}
