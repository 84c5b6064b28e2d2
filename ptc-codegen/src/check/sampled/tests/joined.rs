//! Samples that are joined, and samples that repeat the one before.

use super::super::chain::Chain;
use super::super::emitted;
use super::super::force::Force;
use super::super::joined::Joined;
use super::{Sampled, closed, design, range};
use crate::parameter::Parameter;

/// Compares the bounds of a loop whose samples are joined with those of each sample, of which they are at most `within`
/// times.
fn compare(sampled: &Sampled, samples: usize, within: f64, case: &str) {
    let reach = sampled.reach(samples).expect("few samples");
    let exact = sampled.way(samples, Some(&reach)).expect("bounds");
    let joined = sampled.joined(samples).expect("bounds of steps");
    for (at, start) in joined.starts.iter().enumerate() {
        let both = joined.reach.states[at].iter().zip(&reach.states[*start]);
        both.for_each(|(joined, exact)| assert!(joined >= exact, "{case}: {joined} {exact}"));
    }
    let coarse = joined.way(sampled).expect("bounds");
    let near = |coarse: f64, exact: f64| {
        let part = if exact > 0.0 { coarse / exact } else { 1.0 + coarse };
        assert!((1.0..within).contains(&part), "{case}: {coarse} {exact}");
    };
    near(coarse.u, exact.u);
    coarse.x.iter().zip(&exact.x).for_each(|(coarse, exact)| near(*coarse, *exact));
    near(exact.u_attained, coarse.u_attained);
    assert!((coarse.u_rms - exact.u_rms).abs() <= 1e-9 * exact.u_rms, "{case}");
    assert!(coarse.acts.low <= exact.acts.low && exact.acts.high <= coarse.acts.high);
    for (coarse, exact) in coarse.within.iter().zip(&exact.within) {
        assert!(coarse.low <= exact.low && exact.high <= coarse.high, "{case}");
    }
    let after = [sampled.afterwards(samples, &reach), {
        let Joined { sampled, starts, reach } = &joined;
        sampled.afterwards(starts.len() - 1, reach)
    }];
    if let [Some(exact), Some(joined)] = after {
        // Each looks at as many samples as are a part of those before.
        let both = joined.x.iter().zip(&exact.x).map(|(joined, exact)| joined / exact);
        both.for_each(|part| assert!((0.6..1.6).contains(&part), "{case}: {part}"));
    }
}

#[test]
fn block_bounds_exceed_the_worst_case_by_a_small_part() {
    for (n, poles, delay) in [(1, "3", 0), (2, "20,9", 0), (3, "120,74,15", 0), (2, "20,9", 2)] {
        let samples = 400;
        let mut sampled = closed(n, poles, delay, samples);
        (sampled.x0, sampled.noise) = (vec![1.0; n], vec![1e-4; n]);
        (sampled.middle, sampled.actuator) = (vec![0.5; n], 1e-3);
        sampled.noise_rms = vec![1e-3; n];
        compare(&sampled, samples, 1.1, &format!("n = {n}, delay {delay}"));
    }
}

#[test]
fn block_bounds_cover_random_loops() {
    let mut random = 1_u64;
    let mut draw = |low: f64, high: f64| {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (random >> 11) as f64 / (1_u64 << 53) as f64 * (high - low)
    };
    for case in 0..48 {
        let n = 1 + case % 4;
        // The coefficients of a polynomial with real roots, some of which leave the loop hardly damped.
        let mut poles = vec![1.0];
        for i in 0..n {
            let root = i as f64 + draw(0.3, 6.0);
            let shifted = [&[0.0], poles.as_slice()].concat();
            poles.push(0.0);
            poles.iter_mut().zip(shifted).for_each(|(own, next)| *own = root * *own + next);
        }
        let gains: Vec<_> = poles[..n].iter().map(|gain| format!("{gain:.6}")).collect();
        let samples = 30 + draw(0.0, 120.0) as usize;
        let delay = draw(0.0, 2.9) as usize * usize::from(case % 3 == 0);
        let mut sampled = closed(n, &gains.join(","), delay, samples);
        sampled.x0 = (0..n).map(|_| draw(0.0, 2.0)).collect();
        sampled.middle = (0..n).map(|_| draw(-1.0, 1.0)).collect();
        sampled.noise = (0..n).map(|_| draw(0.0, 1e-2)).collect();
        sampled.noise_rms = (0..n).map(|_| draw(0.0, 1e-2)).collect();
        sampled.actuator = draw(0.0, 0.1);
        if case % 2 == 0 {
            let column = sampled.chain.input.clone();
            let (middle, constant) = (draw(-1.0, 1.0), draw(0.0, 1.0));
            let varying = draw(0.0, 1.0);
            sampled.force = Some(Force { middle, constant, varying, column });
        }
        // With few samples a delay takes a large part of a step.
        let within = if delay > 0 { 1.5 } else { 1.1 };
        let case = format!("case {case}: {gains:?}, {delay}, {samples}");
        compare(&sampled, samples, within, &case);
    }
}

/// Large errors of the matrices are covered too.
#[test]
fn block_bounds_grow_with_matrix_errors() {
    let samples = 60;
    let mut sampled = closed(2, "20,9", 0, samples);
    sampled.x0 = vec![1.0; 2];
    let coarse = |sampled: &Sampled| {
        sampled.joined(samples).and_then(|joined| joined.way(sampled)).expect("bounds")
    };
    let before = coarse(&sampled);
    sampled.loosen(1e-3);
    let reach = sampled.reach(samples).expect("few samples");
    let exact = sampled.way(samples, Some(&reach)).expect("bounds");
    let after = coarse(&sampled);
    assert!(after.x[1] > 1.001 * before.x[1] && after.x[1] >= exact.x[1], "{after:?} {before:?}");
}

/// Designs in samples whose programs decide by counts in other ways.
const REPEATED: [&[(&str, &str)]; 5] = [
    &[],
    &[
        ("measured", "x1"),
        ("observer_poles", "-4,-5"),
        ("observer_samples", "30"),
        ("observer_eps", "1/10"),
    ],
    &[("precision", "f32")],
    &[("guard", "none")],
    &[("delay", "1"), ("poles", "-4,-5,-6")],
];

#[test]
fn repeated_samples_equal_computed_samples() {
    for keys in REPEATED {
        let own = [
            ("n", "2"),
            ("mu", "exp(a=1)"),
            ("clock", "samples"),
            ("tau", "1"),
            ("sample_time", "1/100"),
            ("poles", "-4,-5"),
            ("eps", "1/4"),
            ("u_max", "100"),
        ];
        let others = own.iter().filter(|(key, _)| keys.iter().all(|(other, _)| other != key));
        let spec = design(&others.chain(keys).copied().collect::<Vec<_>>());
        let sampled = spec.sampled().expect("a clock in samples");
        let delay = usize::from(keys.iter().any(|(key, _)| *key == "delay"));
        let chain = Chain::new(2, range(&spec.fixed[&Parameter::SampleTime]), delay);
        let of = |samples| {
            emitted::samples(&spec, sampled, &chain, None, samples).expect("a program in rows").rows
        };
        let all = of(0..=100);
        for (k, rows) in all.iter().enumerate() {
            assert_eq!(*rows, of(k..=k)[0], "{keys:?}: sample {k}");
        }
        let changes = all.windows(2).filter(|pair| pair[0] != pair[1]).count();
        // In f32 eps may be one sample shorter.
        assert!(
            (75..=76).contains(&changes),
            "{keys:?}: the gains change until 25 samples are left"
        );
    }
}
