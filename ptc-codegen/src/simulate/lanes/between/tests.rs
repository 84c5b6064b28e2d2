//! A step in lanes against the run by itself.

use super::*;
use crate::diagnostic::Place;
use crate::program::lanes::LANES;
use crate::simulate::Process;
use crate::simulate::between::{Held, Moved};
use crate::simulate::method::State;
use crate::simulate::switching::Walk;

/// A model with states q and w and the input M, by what is said of it.
fn process(model: &str, plant: &str) -> (Process, Values) {
    let text = format!(
        "mu = \"exp(a=1)\"\npoles = [-3, -4]\nsample_time = 1e-3\n[params]\ntau = 0.5\neps = 0.06\n[model]\n\
         states = [\"q\", \"w\"]\n{model}[plant]\n{plant}"
    );
    let (entries, found) = crate::design::read(&text, &mut |_| Place(0));
    assert_eq!(found, [], "{text}");
    let (spec, plant) = crate::plant::read_design(&entries).expect("a design");
    let plant = plant.unwrap_or_default();
    (Process::new(&spec, &plant), Values::of(&spec, &plant))
}

fn pendulum(rate: &str) -> (Process, Values) {
    let model =
        "input = \"M\"\noutput = \"q\"\ndynamics = { q = \"w\", w = \"4*M - 20*sin(q)\" }\n";
    process(model, &format!("dynamics = {{ w = \"4*M - 20*sin(q) - {rate}\" }}\n"))
}

fn arm(bias: &str) -> (Process, Values) {
    let model = "inputs = [\"M\"]\ninertia = [[\"0.3 + 0.1*cos(q)\"]]\nbias = [\"5*sin(q)\"]\n";
    let inertia = "inertia = [[\"0.32 + 0.1*cos(q)\"]]\n";
    process(model, &format!("{inertia}bias = [\"5*sin(q) + {bias}\"]\n"))
}

/// The lanes that a step moves from states, each as the process by itself does.
fn moved(run: &mut (Process, Values), x: &[[f64; LANES]; 2]) -> Which {
    let (process, values) = run;
    let Moved::Rates(motion) = &process.moved else { panic!("no rates") };
    let mut motions = Motions::of(motion).expect("lanes");
    let x = x.map(Pack);
    let u = [Pack::of(|lane| [0.5, -2.0][lane % 2])];
    let from = Pack::of(|lane| [0.1, 0.25][lane % 2]);
    let to = from.map(|from| from + 1e-3);
    let own = |lane: usize| [x[0].0[lane], x[1].0[lane]];
    for lane in 0..LANES {
        motions.start(lane, values, &own(lane)).expect("values");
    }
    let times = Times { part: 0, from, to, moves: Pack::all(1.0) };
    let mut ends = x;
    let moved = motions.after(&x, &u, &times, &[true; LANES], &mut ends);
    for lane in (0..LANES).filter(|lane| moved[*lane]) {
        process.start(values, &own(lane)).expect("values");
        let mut state = State::zeros();
        state.as_mut_slice()[..2].copy_from_slice(&own(lane));
        let acts = [u[0].0[lane]];
        let held = Held { u: &acts, acts: &acts };
        let times = ((from.0[lane], to.0[lane]), f64::NAN);
        let end = process.between(&mut Walk::default(), state, held, times).expect("an end");
        let bits = |numbers: [f64; 2]| numbers.map(f64::to_bits);
        assert_eq!(bits([end[0], end[1]]), bits(ends.each_ref().map(|end| end.0[lane])));
    }
    moved
}

const Q: [f64; LANES] = [0.1, -0.4, 3.0, -3.1, 0.0, 1e-5, 2.0, -1.0];
const W: [f64; LANES] = [0.3, -0.2, 5.0, -6.0, 2.0, -1.0, 1.5, -4.0];

#[test]
fn one_step_is_all_of_a_sample_away_from_kinks() {
    for rate in ["0.5*w", "0.5*w*abs(w)", "0.4*sign(w)", "max(w, 0.3*q) + sin(3*t)"] {
        assert_eq!(moved(&mut pendulum(rate), &[Q, W]), [true; LANES], "{rate}");
        assert_eq!(moved(&mut arm(rate), &[Q, W]), [true; LANES], "{rate}");
    }
}

#[test]
fn kinks_on_the_way_are_left_to_the_run_by_itself() {
    // Under u the speed changes its sign within the sample, and one begins on the kink.
    let mut w = W;
    (w[0], w[1], w[2]) = (0.0, 1e-4, 1e-3);
    let expected = std::array::from_fn(|lane| lane > 2);
    let mut q = Q;
    q[2] = 0.9;
    assert_eq!(moved(&mut pendulum("0.4*sign(w)"), &[q, w]), expected);
    // A fast mode takes more than one step.
    assert_eq!(moved(&mut pendulum("3e3*w"), &[Q, W]), [false; LANES]);
}

#[test]
fn plants_by_the_exponential_are_not_integrated() {
    let (process, _) = process(
        "input = \"M\"\noutput = \"q\"\ndynamics = { q = \"w\", w = \"4*M - q\" }\n",
        "dynamics = { w = \"4*M - 0.9*q\" }\n",
    );
    let Moved::Rates(motion) = &process.moved else { panic!("no rates") };
    assert!(Motions::of(motion).is_none());
}
