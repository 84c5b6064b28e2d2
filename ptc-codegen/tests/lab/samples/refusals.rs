//! Designs that are refused.

use super::read;

#[test]
fn weights_that_overflow_are_refused() {
    let keys = [
        ("n", "4"),
        ("mu", "exp(a=1)"),
        ("clock", "samples"),
        ("tau", "1e-9"),
        ("sample_time", "1e-11"),
        ("poles", "-5,-6,-7,-8"),
    ];
    for (precision, refused) in [("f64", false), ("f32", true)] {
        let mut keys = keys.to_vec();
        keys.push(("precision", precision));
        let spec = read(&keys).expect("a legal design");
        let found = ptc_codegen::generate(&spec, ptc_codegen::emit::Language::C);
        assert_eq!(found.is_err(), refused, "{precision}");
        if let Err(found) = found {
            assert_eq!(found[0].code, "overflow");
            assert!(found[0].message.contains("too large for f32"), "{}", found[0].message);
        }
    }
}

#[test]
fn mistakes_are_named() {
    let stage = [
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("clock", "samples"),
        ("tau", "1"),
        ("sample_time", "0.01"),
        ("poles", "-3,-4"),
    ];
    let cases: [(&str, &str, &str); 21] = [
        ("sample_time", "0.3", "the nearest are 0.9 and 1.2"),
        ("tau", "0.01", "too few to come to rest"),
        ("mu", "tanh(a=1)", "exact law for the mapping exp alone"),
        ("measured", "x2", "name the measured states from x1 on"),
        ("measured", "x1", "`observer_poles` is missing"),
        ("observer_poles", "-3,-4", "`observer_poles` without an observer"),
        ("disturbance", "wave", "is not one that is estimated"),
        ("disturbance", "constnt", "did you mean `constant`?"),
        ("delay", "-0.5", "delay is a number from 0 to 16"),
        ("deadbeat", "1", "give an integer of at least 2"),
        ("g", "x1", "takes a constant input gain"),
        ("f", "x1", "f is the known constant"),
        ("f", "x1 + load", "a number or the name of a parameter"),
        ("f", "t", "f is the known constant"),
        ("f", "u_max", "a number or the name of a parameter"),
        ("t0", "1", "arm the controller at the tick"),
        ("after", "extern", "no user-defined law after the deadline"),
        ("guard", "result", "has the guards full and none"),
        ("eps", "2", "not below tau"),
        ("delay_law", "smith", "is not one of extend, predict"),
        ("clock", "ticks", "is not one of time, samples"),
    ];
    for (key, value, wanted) in cases {
        let mut keys: Vec<_> = stage.iter().copied().filter(|(own, _)| *own != key).collect();
        keys.push((key, value));
        let found = read(&keys).expect_err(&format!("{key} = {value}"));
        assert!(found.contains(wanted), "{key} = {value}: {found}");
    }
    // A law that extends its loop has a pole for each input under way, and knows four of them.
    for (delay, law, wanted) in [
        ("1", "extend", "2 poles for n + delay = 3, or order n = 2 with delay_law = predict"),
        ("4.5", "extend", "at most 4 samples of delay here, or any with `delay_law` = predict"),
        ("17", "predict", "delay is a number from 0 to 16"),
    ] {
        let found = read(&[&stage[..], &[("delay", delay), ("delay_law", law)]].concat());
        let found = found.expect_err(wanted);
        assert!(found.contains(wanted), "{delay}: {found}");
    }
    let mut keys: Vec<_> = stage.iter().copied().filter(|(own, _)| *own != "clock").collect();
    keys.push(("measured", "x1"));
    let found = read(&keys).expect_err("no clock in samples");
    assert!(found.contains("needs a clock in samples"), "{found}");
}

/// Refused combinations of a reference in samples with other keys, by a part of the message.
#[test]
fn references_that_are_refused_are_named() {
    let common = [("mu", "exp(a=1)"), ("clock", "samples"), ("sample_time", "0.01")];
    let chain = [&common[..], &[("n", "2")]].concat();
    let plant = [&common[..], &[("A", "[[0,1],[-1,0]]"), ("B", "[0,1]")]].concat();
    let [speed, unreached, wrong] =
        ["0,1", "0,0", "1"].map(|output| [&plant[..], &[("output", output)]].concat());
    let observer = [
        ("what", "observer"),
        ("measured", "x1"),
        ("observer_poles", "-3,-4"),
        ("observer_samples", "9"),
    ];
    let alone = [&chain[..], &observer].concat();
    for (keys, reference, wanted) in [
        (&plant, "t", "no output of the plant that could follow it"),
        (&plant, "input", "no output of the plant that could follow it"),
        (&speed, "t", "the relative degree of the output is 1, and the plant has 2 states"),
        (&unreached, "t", "no input reaches the output"),
        (&wrong, "t", "a row of output has 1 number"),
        (&chain, "sin(t - t0)", "`t0` in a reference in samples"),
        (&chain, "sin(t/tau)", "it is left to run time as a number of samples"),
        (&chain, "1/t", "derivatives at all t >= 0: t has to be not 0"),
        (&chain, "abs(t)", "has a kink"),
        (&alone, "t", "`reference` is of a law, and an observer alone has none"),
    ] {
        let found = read(&[&keys[..], &[("reference", reference)]].concat());
        let found = found.expect_err(reference);
        assert!(found.contains(wanted), "{reference}: {found}");
    }
    // What is of a law has no part in the observer of its design.
    let own = read(&[&alone[..], &[("reference", "t"), ("poles", "-3,-4")]].concat());
    let without = read(&[&alone[..], &[("poles", "-3,-4")]].concat());
    assert_eq!(own.expect("a legal design"), without.expect("a legal design"));
}
