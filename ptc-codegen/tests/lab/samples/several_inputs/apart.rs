//! Chains that nothing couples: each has the bits of a controller of its own.

use num_traits::{FromPrimitive, Signed, ToPrimitive};
use ptc_codegen::algebra::BigRational;
use ptc_codegen::code::{Instance, Status};

use super::{axes, code, decoupled};

#[test]
fn chains_apart_have_the_bits_of_a_controller_each() {
    let time = [("tau", "0.5"), ("sample_time", "1/128")];
    for (both, each) in [
        (vec![("poles", "[[-3,-4],[-3.5+i,-3.5-i]]")], ["-3,-4", "-3.5+i,-3.5-i"]),
        (vec![("poles", "-3.25,-4")], ["-3.25,-4"; 2]),
        (vec![("poles", "[[-3,-4],[-6,-9.5]]"), ("eps", "0.1")], ["-3,-4", "-6,-9.5"]),
        (vec![("poles", "-3,-4"), ("deadbeat", "30")], ["-3,-4"; 2]),
        (vec![("poles", "[[-3,-4],[-2.5,-7]]"), ("precision", "f32")], ["-3,-4", "-2.5,-7"]),
        (vec![("poles", "[[-3,-4],[-2.5,-7]]"), ("limits", "2, 5")], ["-3,-4", "-2.5,-7"]),
    ] {
        let keys = [&time[..], &both].concat();
        let (plant, rows) = (decoupled(&keys), axes(&keys));
        let alone = each.iter().enumerate().map(|(index, poles)| {
            let mut keys = [&time[..], &[("n", "2"), ("poles", *poles)]].concat();
            let other = both.iter().filter(|(key, _)| !["poles", "limits"].contains(key));
            keys.extend(other);
            if both.contains(&("limits", "2, 5")) {
                keys.push(("u_max", ["2", "5"][index]));
            }
            code(&keys)
        });
        let alone: Vec<_> = alone.collect();
        let [mut plant, mut rows] =
            [&plant, &rows].map(|code| Instance::new(code, &[]).expect("legal parameters"));
        let mut alone: Vec<_> =
            alone.iter().map(|code| Instance::new(code, &[]).expect("legal parameters")).collect();
        for k in 0..70_u32 {
            let k = f64::from(k);
            let x = [0.3 - k / 100.0, (k * 0.7).sin(), 0.2 * k - 3.0, (k * 1.3).cos()];
            let outcome = plant.call("step", &[("k", &[k]), ("x", &x)]);
            let of_rows = [("k", &[k][..]), ("x", &[x[0], x[2], x[1], x[3]])];
            assert_eq!(rows.call("step", &of_rows), outcome, "{both:?}, {k}");
            for (index, own) in alone.iter_mut().enumerate() {
                let own = own.call("step", &[("k", &[k]), ("x", &[x[index], x[index + 2]])]);
                let [u, wanted] = [outcome.results["u"][index], own.results["u"][0]];
                assert_eq!(u.to_bits(), wanted.to_bits(), "{both:?}, {k}, {index}");
                let status = outcome.results["axes"][index];
                assert_eq!(status, f64::from(own.status.number()), "{both:?}, {k}, {index}");
            }
        }
    }
}

/// A parameter of one value is a number, also in g of each axis.
#[test]
fn a_gain_of_parameters_with_one_value_is_a_number() {
    let time = [("tau", "0.5"), ("sample_time", "1/128"), ("poles", "-3,-4")];
    let with = |gain: &'static str, m: &'static str| {
        code(&[&time[..], &[("n", "2"), ("g", gain), ("params.m", m)]].concat())
    };
    let number = code(&[&time[..], &[("n", "2"), ("g", "1/4")]].concat());
    let [named, _] = [with("1/m", "4"), with("2/m", "8")].map(|own| {
        assert_eq!(own.functions, number.functions);
        own
    });
    assert_eq!(named.init, number.init);
    let own = axes(&[&time[..], &[("g", "[1/m, 3]"), ("params.m", "4")]].concat());
    let other = axes(&[&time[..], &[("g", "[1/4, 3]")]].concat());
    assert_eq!(own.functions, other.functions);
}

/// The law brings the state down to some (n/N)^3 = 3e-5 before its last gains, which leave a rounding of that.
#[test]
fn chains_apart_are_at_rest_at_the_last_sample() {
    let all =
        decoupled(&[("tau", "0.5"), ("sample_time", "1/128"), ("poles", "[[-3,-4],[-5.5,-6]]")]);
    let mut controller = Instance::new(&all, &[]).expect("legal parameters");
    let number = |value: f64| BigRational::from_f64(value).expect("a number");
    let h = number(1.0 / 128.0);
    let mut x = [0.3, -1.25, 2.0, 0.7].map(number);
    for k in 0..64_u32 {
        let given = x.each_ref().map(|x| x.to_f64().expect("a double"));
        let outcome = controller.call("step", &[("k", &[f64::from(k)]), ("x", &given)]);
        assert_eq!(outcome.status, Status::Ok, "sample {k}");
        for index in 0..2 {
            let u = number(outcome.results["u"][index]);
            let moved = &x[index] + &h * &x[index + 2] + &h * &h / number(2.0) * &u;
            x[index] = moved;
            x[index + 2] = &x[index + 2] + &h * u;
        }
    }
    let rest = x.iter().map(Signed::abs).max().expect("a state");
    assert!(rest < number(1e-17), "{:?}", rest.to_f64());
    let hold = controller.call("step", &[("k", &[64.0]), ("x", &[0.0; 4])]);
    assert_eq!(hold.status, Status::Hold);
}

/// The same plant in other coordinates and inputs, spelt oddly.
#[test]
fn spellings_and_coordinates_do_not_matter() {
    let time = [("tau", "0.5"), ("sample_time", "1/128"), ("poles", "[[-3,-4],[-6,-9.5]]")];
    let mixed = [
        ("states", "p, q, dp, dq"),
        ("inputs", "a, b"),
        ("outputs", "p + (q)*1^2, q - 2*p + 0*dp"),
        ("dynamics", "dp/1, -(-dq), sqrt(4)*a + b + 0.0, ((b)) - a^1"),
    ];
    let mixed = code(&[&time[..], &mixed].concat());
    let apart = decoupled(&time);
    let [mut mixed, mut apart] =
        [&mixed, &apart].map(|code| Instance::new(code, &[]).expect("legal parameters"));
    for k in 0..70_u32 {
        let k = f64::from(k);
        let x = [0.3 - k / 100.0, (k * 0.7).sin(), 0.2 * k - 3.0, (k * 1.3).cos()];
        let chain = [x[0] + x[1], x[1] - 2.0 * x[0], x[2] + x[3], x[3] - 2.0 * x[2]];
        let u = mixed.call("step", &[("k", &[k]), ("x", &x)]).results["u"].clone();
        let wanted = apart.call("step", &[("k", &[k]), ("x", &chain)]).results["u"].clone();
        // p'' + q'' = a + 2 b, q'' - 2 p'' = -5 a - b.
        let found = [u[0] + 2.0 * u[1], -5.0 * u[0] - u[1]];
        let size = wanted.iter().fold(0.0, |size: f64, w| size.max(w.abs()));
        for (found, wanted) in found.iter().zip(&wanted) {
            assert!((found - wanted).abs() <= 1e-13 * size, "{k}: {found}, not {wanted}");
        }
    }
}

/// Each axis has its own input gain.
#[test]
fn axes_are_chains_with_gains_of_their_own() {
    let time = [("tau", "0.5"), ("sample_time", "1/128"), ("poles", "[[-3,-4],[-5,-6.5]]")];
    let all = axes(&[&time[..], &[("g", "[2, -0.5]")]].concat());
    let mut all = Instance::new(&all, &[]).expect("legal parameters");
    let alone = [("-3,-4", "2"), ("-5,-6.5", "-0.5")]
        .map(|(poles, g)| code(&[&time[..2], &[("n", "2"), ("poles", poles), ("g", g)]].concat()));
    let mut alone = alone.each_ref().map(|code| Instance::new(code, &[]).expect("legal"));
    for k in 0..66_u32 {
        let k = f64::from(k);
        let x = [0.3 - k / 100.0, (k * 0.7).sin(), 0.2 * k - 3.0, (k * 1.3).cos()];
        let outcome = all.call("step", &[("k", &[k]), ("x", &x)]);
        for (index, own) in alone.iter_mut().enumerate() {
            let own = own.call("step", &[("k", &[k]), ("x", &x[2 * index..2 * index + 2])]);
            let [u, wanted] = [outcome.results["u"][index], own.results["u"][0]];
            assert_eq!(u.to_bits(), wanted.to_bits(), "{k}, {index}");
        }
    }
}
