//! Keys that are refused for plants with several inputs.

use super::read;

#[test]
fn what_needs_one_input_is_refused() {
    let plant = [
        ("mu", "exp(a=1)"),
        ("clock", "samples"),
        ("sample_time", "0.01"),
        ("tau", "1"),
        ("poles", "-3,-4"),
        ("states", "p, q, dp, dq"),
        ("inputs", "a, b"),
        ("outputs", "p, q"),
        ("dynamics", "dp, dq, a - q^3, b"),
    ];
    read(&plant).expect("a legal design");
    read(
        &[&plant[..], &[("measured", "p, q, dp, dq"), ("disturbance", "none"), ("delay", "0")]]
            .concat(),
    )
    .expect("a legal design");
    for (key, value, wanted) in [
        (
            "delay",
            "1",
            "the prediction over a delay needs a linear plant of one input; leave `delay` out",
        ),
        (
            "measured",
            "p, q",
            "an observer needs a linear plant of one input; leave `measured` out: `step` takes all states, p, q, dp, dq",
        ),
        ("disturbance", "constant", "an observer needs a linear plant of one input"),
        ("observer_poles", "-3,-4", "`observer_poles` without an observer"),
        (
            "reference",
            "sin(t)",
            "1 reference for 2 outputs; give an expression in t for each output",
        ),
        ("reference", "[t, abs(t)]", "abs(t) has a kink"),
        ("reference", "[t, p]", "`p` is a state or an input of the plant"),
        ("reference", "[t, sin(t0)]", "`t0` in a reference in samples"),
        ("pi0", "extern", "a clock in samples needs a linear law"),
        ("mu", "tanh(a=1)", "an exact law for the mapping exp alone"),
        ("t0", "1", "arm the controller at the tick"),
        ("after", "zero", "the outputs hold their gains after the deadline"),
        ("guard", "result", "has the guards full and none"),
        ("what", "observer", "such a plant is of a controller"),
        ("tau", "0.01", "too few to come to rest"),
        ("deadbeat", "1", "an integer of at least 2"),
        ("poles", "[[-3,-4],[-3]]", "1 pole for order n = 2"),
        ("limits", "1,2,3", "3 values of `limits` for 2 axes"),
        ("axes", "2", "`axes` beside `inputs` and `outputs`"),
    ] {
        let mut keys: Vec<_> = plant.iter().copied().filter(|(own, _)| *own != key).collect();
        if key == "pi0" {
            keys.retain(|(own, _)| *own != "poles");
        }
        keys.push((key, value));
        let found = read(&keys).expect_err(&format!("{key} = {value}"));
        assert!(found.contains(wanted), "{key} = {value}: {found}");
    }
}

#[test]
fn what_axes_lack_is_refused() {
    let keys = [("n", "2"), ("axes", "2"), ("mu", "exp(a=1)"), ("clock", "samples")];
    read(&[&keys[..], &[("measured", "x1, x2"), ("disturbance", "none")]].concat())
        .expect("a legal design");
    for (key, value, wanted) in [
        ("delay", "1", "axes in samples keep no inputs under way"),
        ("measured", "x1", "axes in samples have no observers"),
        ("disturbance", "constant", "axes in samples have no observers"),
        ("A", "[[0,1],[0,0]]", "the axes are chains"),
        ("g", "[2, m]", "g is not a number"),
        ("f", "3", "f depends on the state of one axis"),
        ("pi0", "extern", "a clock in samples needs a linear law"),
        ("after", "zero", "axes hold their gains after the deadline"),
        ("what", "observer", "axes are of a controller"),
        ("reference", "sin(t)", "1 reference for 2 axes; give an expression in t for each axis"),
        ("reference", "[1, t, t]", "3 references for 2 axes"),
        ("reference", "[sin(tau), t]", "`tau` in a reference, and it is left to run time"),
        ("reference", "[t, 1/(1 - t)]", "1 - t has to be not 0"),
    ] {
        let found = read(&[&keys[..], &[(key, value)]].concat()).expect_err(key);
        assert!(found.contains(wanted), "{key} = {value}: {found}");
    }
}
