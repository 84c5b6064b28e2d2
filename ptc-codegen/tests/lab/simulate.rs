//! Simulated trajectories against exact solutions, reference values and each other.

use crate::support;

use ptc_codegen::parameter::Parameter;
use ptc_codegen::simulate::{Accuracy, Cause, Continuous, Direct, Values};
use support::design;

/// T/tau, x_1..x_n and u.
type Seen = Vec<(f64, Vec<f64>, f64)>;

fn continuous(text: &str, set: &[(Parameter, f64)], x0: &[f64], shares: &[f64]) -> Seen {
    let (spec, plant) = design(text);
    let mut values = Values::of(&spec, &plant);
    set.iter().for_each(|(parameter, value)| values.set(*parameter, *value));
    let tau = values.get(Parameter::Tau);
    let mut seen = Vec::new();
    let run = Continuous::of(&spec, &plant).expect("a loop").run(
        &values,
        x0,
        shares,
        Accuracy::default(),
        &mut |sample| seen.push((sample.time_to_go / tau, sample.x.to_vec(), sample.u[0])),
    );
    run.unwrap_or_else(|failure| panic!("{text}: {failure}"));
    assert_eq!(seen.len(), shares.len());
    seen
}

/// T/tau from 1 to 1e-9.
fn shares_to_the_end() -> Vec<f64> {
    (0..=90).map(|i| 10f64.powf(-f64::from(i) / 10.0)).collect()
}

fn close(found: f64, wanted: f64, what: &str) {
    let off = (found - wanted).abs();
    assert!(off <= 1e-10 * wanted.abs().max(1.0), "{what}: {found} is {off:e} off {wanted}");
}

#[test]
fn exact_solutions_of_order_1_and_2() {
    let first = "n = 1\nmu = \"exp(a=0.1)\"\ngains = 1\ntau = 1\n";
    for (share, x, _) in
        continuous(&first.replace("gains = 1", "gains = [1]"), &[], &[2.0], &shares_to_the_end())
    {
        close(x[0], 2.0 * share.powi(10), "order 1");
        let part = x[0] / (2.0 * share.powi(10));
        assert!((part - 1.0).abs() < 1e-10, "x keeps its digits at {share:e}: {part}");
    }
    let second = "n = 2\nmu = \"exp(a=1)\"\ng = 2\ngains = [6, 5]\ntau = 1\n";
    for (t, x, u) in continuous(second, &[], &[1.0, 0.0], &shares_to_the_end()) {
        close(x[0], 3.0 * t * t - 2.0 * t * t * t, "x1");
        close(x[1], -6.0 * t + 6.0 * t * t, "x2");
        close(u, 3.0 - 6.0 * t, "u");
        assert!((x[1] / t - (-6.0 + 6.0 * t)).abs() < 1e-10, "x2/T keeps its digits at T = {t:e}");
    }
}

#[test]
fn the_exact_solution_of_the_rational_family() {
    let text = "n = 2\nmu = \"rational(a=1)\"\ngains = [1, 2]\ntau = 10\n";
    for (share, x, _) in continuous(text, &[], &[-1.0, -1.0], &shares_to_the_end()) {
        let s = (1.0 - share) / share;
        let slope = 10.0 / (share * 10.0).powi(2);
        close(x[0], -(1.0 + 11.0 * s) * (-s).exp(), "x1");
        close(x[1], slope * (11.0 * s - 10.0) * (-s).exp(), "x2");
    }
}

const EXAMPLE: &str = include_str!("../../../tests/designs/example4.toml");

const PLANT: &str = "\n[plant]\nf = \"0.1 - t^3*exp(-t)*sin(x1/(u + 0.001)) - 0.5*u\"\n";

/// tau, t/tau, x and u from x(0) = 1, by tools/example4.py.
const FIGURE_1: [(f64, f64, f64, f64); 15] = [
    (1.0, 0.01, 0.5198589312448563, -31.204202622268294),
    (1.0, 0.1, 0.13339577672445824, -3.172723239591071),
    (1.0, 0.5, 0.007532663939375625, -0.2524594676761148),
    (1.0, 0.9, 0.0013992587630849323, -0.2318719720532364),
    (1.0, 0.99, 0.0001379590072062699, -0.22808862579191128),
    (2.0, 0.01, 0.5204151804186649, -15.648789831043572),
    (2.0, 0.1, 0.13779072947295648, -1.6536302801005023),
    (2.0, 0.5, 0.016121105604107296, -0.2744500405277648),
    (2.0, 0.9, 0.003091025725642942, -0.25689842417130937),
    (2.0, 0.99, 0.0002792721971043827, -0.2309207078576544),
    (5.0, 0.01, 0.5220805312296891, -6.315789470861373),
    (5.0, 0.1, 0.15213174520140382, -0.7525604180713475),
    (5.0, 0.5, 0.07661233692713434, -0.585205423575285),
    (5.0, 0.9, 0.009130466349755954, -0.30690737600098206),
    (5.0, 0.99, 0.0007079424476619864, -0.23433208893668342),
];

#[test]
fn example_4_of_the_letter() {
    let text = format!("{EXAMPLE}{PLANT}");
    for values in FIGURE_1.chunks(5) {
        let tau = values[0].0;
        let shares: Vec<_> = values.iter().map(|(_, part, ..)| 1.0 - part).collect();
        let seen = continuous(&text, &[(Parameter::Tau, tau)], &[1.0], &shares);
        for ((_, part, wanted, wanted_u), (_, x, u)) in values.iter().zip(seen) {
            assert!((x[0] - wanted).abs() <= 1e-13, "tau = {tau} at {part}: {} {wanted}", x[0]);
            assert!((u / wanted_u - 1.0).abs() <= 1e-11, "tau = {tau} at {part}: {u} {wanted_u}");
        }
        for (share, x, u) in
            continuous(&text, &[(Parameter::Tau, tau)], &[1.0], &shares_to_the_end())
        {
            assert!(x[0].abs() <= 1.1, "|x| stays below phi |x(0)|: {}", x[0]);
            if share <= 1e-7 {
                let slope = x[0] / (share * tau);
                assert!((slope - 12.1 / 879.0).abs() <= 1e-8, "tau = {tau}, {share:e}: {slope}");
                assert!((u + 200.0 / 879.0).abs() <= 1e-6, "tau = {tau}, {share:e}: {u}");
            }
        }
    }
}

/// Every family, with a disturbance and a gain error: x by the associated system and x by the
/// emitted program in the loop.
#[test]
fn both_sides_of_the_equivalence_agree() {
    let mappings = [
        "exp(a=1)",
        "rational(a=1)",
        "power(a=0.5,m=2)",
        "power(a=1,m=0.5)",
        "tan(a=1)",
        "tanh(a=1)",
        "algebraic(a=1)",
        "exp_sum(rates=[0.8,1.6])",
        "tau*(1 - exp(-t))",
        "tau*t/(1 + t)",
    ];
    for mu in mappings {
        let text = format!(
            "n = 3\nmu = \"{mu}\"\ng = \"2 + cos(x1)\"\npoles = [-7, -8, -9]\ntau = 2\nt0 = 0.3\neps = 1e-12\n\
             u_max = inf\n[plant]\nf = \"0.3*sin(5*t) - 0.1*x2*abs(x2) + 0.02*u\"\ng = \"1.9 + cos(x1)\"\n"
        );
        agree(&text, &[1.0, -0.4, 0.3]);
    }
}

/// A limit in force with the controller's own gain of order 5; elapsed time in the law
/// and in the plant.
#[test]
fn both_sides_agree_where_u_is_clipped_and_where_time_enters() {
    let clipped = agree(
        "n = 5\nmu = \"exp(a=1)\"\ng = 2\npoles = [-11, -12, -13, -14, -15]\ntau = 2\neps = 1e-12\n\
         u_max = 30\n[plant]\nf = \"0.1*dt\"\n",
        &[0.1, -0.2, 0.1, 0.3, -0.5],
    );
    assert_eq!(clipped[0].2.abs(), 30.0);
    agree(
        "n = 2\nmu = \"tanh(a=1)\"\npi0 = \"-20*xi1 - 9*xi2 + dt*xi1 + sin(t_kappa)*xi2\"\ntau = 2\nt0 = 0.3\n\
         eps = 1e-12\nu_max = inf\n[plant]\nf = \"0.1*dt - 0.2*t*x2\"\n",
        &[1.0, -0.4],
    );
}

/// x and u by the associated system, which are returned, and by the emitted program in the loop. They
/// may differ by what an error of 1e-10 in each step of the integrator adds up to.
fn agree(text: &str, x0: &[f64]) -> Seen {
    let (spec, plant) = design(text);
    let shares = [1.0, 0.9, 0.5, 0.2, 0.1];
    let values = Values::of(&spec, &plant);
    let mapped = continuous(text, &[], x0, &shares);
    let mut direct = Vec::new();
    let accuracy = Accuracy { relative: 1e-10, absolute: 1e-18, ..Accuracy::default() };
    Direct::of(&spec, &plant)
        .expect("a loop")
        .run(&values, x0, &shares, accuracy, &mut |s| direct.push((s.x.to_vec(), s.u[0])))
        .unwrap_or_else(|failure| panic!("{text}: {failure}"));
    for ((share, x, u), (own, own_u)) in mapped.iter().zip(&direct) {
        for (a, b) in x.iter().zip(own).chain([(u, own_u)]) {
            let scale = own.iter().fold(own_u.abs(), |s, x| s.max(x.abs()));
            assert!((a - b).abs() <= 1e-7 * scale, "{text} at {share}: {x:?} {u}, {own:?} {own_u}");
        }
    }
    mapped
}

/// Stretched time goes to 1e9 s here, where the loop has a time constant of 1 s: x follows
/// T^2/(k tau) (1 + 2 T/(k tau) + ...), the balance of f = 1 and u = -k tau x/T^2.
#[test]
fn a_disturbance_of_the_rational_family_is_followed_to_the_end() {
    let text = "n = 1\nmu = \"rational(a=1)\"\ngains = [3]\ntau = 2\n[plant]\nf = 1\n";
    for (share, x, u) in continuous(text, &[], &[1.0], &shares_to_the_end()) {
        let time_to_go = 2.0 * share;
        let balance = time_to_go.powi(2) / 6.0 * (1.0 + time_to_go / 3.0);
        if share < 1e-3 {
            assert!((x[0] / balance - 1.0).abs() < 1e-4, "{share:e}: {} {balance}", x[0]);
            assert!((u + 1.0).abs() < 1e-2, "{share:e}: {u}");
        }
        if share < 1e-7 {
            assert!((x[0] / balance - 1.0).abs() < 1e-9, "{share:e}: {} {balance}", x[0]);
        }
    }
}

/// At order 3 the later states are far below the rounding error of the first one's part in their rate.
#[test]
fn a_disturbance_of_a_higher_order_does_not_stop_the_integration() {
    let text = "n = 3\nmu = \"rational(a=1)\"\npoles = [-4, -5, -6]\ntau = 2\nu_max = 50\n\
                [plant]\nf = \"0.3*sin(5*t) - d*x2*abs(x2)\"\ng = 0.9\nd = 0.1\n";
    let seen = continuous(text, &[], &[1.0, -0.4, 0.3], &shares_to_the_end());
    let (share, x, u) = seen.last().expect("an end");
    // The balance of f + 0.9 u = 0, and of xi_3' = r_1^3 f_mu - 120 xi_1 with f_mu = f + (0.9 - 1) u.
    let f = 0.3 * 10f64.sin();
    let r1 = (2.0 * share).powi(2) / 2.0;
    assert!((u + f / 0.9).abs() < 1e-6, "{u}");
    let balance = r1.powi(3) * (f / 0.9) / 120.0;
    assert!((x[0] / balance - 1.0).abs() < 1e-4, "{} {balance}", x[0]);
}

/// Clipped from t0 to the deadline, u is -u_max and x a polynomial in t, whatever the mapping.
#[test]
fn u_clipped_up_to_the_deadline_moves_the_plant_exactly() {
    let mappings = [
        "exp(a=1)",
        "rational(a=1)",
        "power(a=1,m=2)",
        "tan(a=1)",
        "tanh(a=1)",
        "algebraic(a=1)",
        "exp_sum(rates=[0.8,1.6])",
    ];
    for mu in mappings {
        for n in 1..=6_u32 {
            let poles: Vec<_> = (1..=n).map(|i| format!("-{}", 2 * n + i)).collect();
            let text = format!(
                "n = {n}\nmu = \"{mu}\"\npoles = [{}]\ntau = 2\nu_max = 0.5\n[plant]\nf = 0\n",
                poles.join(", ")
            );
            let mut x0 = vec![0.0; n as usize];
            x0[0] = 100.0;
            for (share, x, u) in continuous(&text, &[], &x0, &shares_to_the_end()) {
                assert_eq!(u, -0.5, "{text}");
                let t = 2.0 - 2.0 * share;
                for (i, (found, start)) in (1..=n).zip(x.iter().zip(&x0)) {
                    let power = n - i + 1;
                    let factorial: u32 = (1..=power).product();
                    let moved = 0.5 * t.powi(i32::try_from(power).expect("small"));
                    let wanted = start - moved / f64::from(factorial);
                    let off = (found - wanted).abs();
                    assert!(
                        off <= 1e-9 * wanted.abs(),
                        "{text}T/tau = {share:e}: x{i} = {found}, {wanted}"
                    );
                }
            }
        }
    }
}

/// u = -3 x/T is clipped until T = 1/4: before that x falls evenly, afterwards like T^3.
#[test]
fn the_end_of_clipping_is_located() {
    let text = "n = 1\nmu = \"exp(a=1)\"\ngains = [3]\ntau = 1\nu_max = 1.2\n[plant]\nf = 0\n";
    for (share, x, u) in continuous(text, &[], &[1.0], &shares_to_the_end()) {
        let (wanted, wanted_u) = match share > 0.25 {
            true => (1.0 - 1.2 * (1.0 - share), -1.2),
            false => (0.1 * (4.0 * share).powi(3), -19.2 * share * share),
        };
        assert!((x[0] / wanted - 1.0).abs() <= 1e-10, "{share:e}: {} {wanted}", x[0]);
        assert!((u / wanted_u - 1.0).abs() <= 1e-10, "{share:e}: {u} {wanted_u}");
    }
}

/// x' = u - sign(x)/2 + t from 0 with u = -3 x/T: it sticks until t = 1/2, and is then T (T - 1/2)^2.
#[test]
fn dry_friction_sticks_and_lets_go() {
    let text = "n = 1\nmu = \"exp(a=1)\"\ngains = [3]\ntau = 1\nu_max = U\n\
                [plant]\nf = \"-0.5*sign(x1) + t\"\n";
    for u_max in ["inf", "7"] {
        let text = text.replace('U', u_max);
        for (share, x, _) in continuous(&text, &[], &[0.0], &shares_to_the_end()) {
            let wanted = if share > 0.5 { 0.0 } else { share * (share - 0.5).powi(2) };
            assert!((x[0] - wanted).abs() <= 1e-11 * wanted, "{share:e}: {} {wanted}", x[0]);
        }
    }
    // From 0.2 with -sign(x)/2 + 0.1: 0.4 T^3 - 0.2 T, until T^2 = 1/2; then it sticks for good.
    let text =
        "n = 1\nmu = \"exp(a=1)\"\ngains = [3]\ntau = 1\n[plant]\nf = \"0.1 - 0.5*x1/abs(x1)\"\n";
    let signed = text.replace("x1/abs(x1)", "sign(x1)");
    for (share, x, u) in continuous(&signed, &[], &[0.2], &shares_to_the_end()) {
        let moves = share * share > 0.5;
        let wanted = if moves { 0.4 * share.powi(3) - 0.2 * share } else { 0.0 };
        assert!((x[0] - wanted).abs() <= 1e-13, "{share:e}: {} {wanted}", x[0]);
        assert!(moves || u.abs() <= 1e-12, "{share:e}: {u}");
    }
}

/// Stick and slip, a dead zone, an end stop and a square wave, with u clipped and not.
#[test]
fn both_sides_agree_where_f_has_kinks_and_jumps() {
    for (f, x0) in [
        ("-0.2*x2 - 0.5*sign(x2) + 0.1", [0.1, 0.0]),
        ("-0.9*x2/sqrt(x2^2 + 0.01) - 0.4*x2*abs(x2)", [0.3, -0.4]),
        ("0.3*sign(sin(9*t)) - 0.8*sign(2*x2)", [-0.2, 0.0]),
        ("-3*max(abs(x1) - 0.05, 0)*sign(x1) - 0.1*sign(x2 - 0.2)", [0.2, 0.3]),
    ] {
        for u_max in ["inf", "1.5"] {
            agree(
                &format!(
                    "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\ntau = 1\neps = 1e-12\nu_max = {u_max}\n\
                     [plant]\nf = \"{f}\"\n"
                ),
                &x0,
            );
        }
    }
}

/// Fewest steps that a run takes.
fn steps(text: &str, x0: &[f64]) -> usize {
    let (spec, plant) = design(text);
    let values = Values::of(&spec, &plant);
    let mut run = Continuous::of(&spec, &plant).expect("a loop");
    let mut done = |steps| {
        let accuracy = Accuracy { steps, ..Accuracy::default() };
        run.run(&values, x0, &[1e-6], accuracy, &mut |_| {}).is_ok()
    };
    let (mut few, mut many) = (0, 1 << 20);
    assert!(done(many), "{text}");
    while many - few > 1 {
        let middle = few.midpoint(many);
        if done(middle) { many = middle } else { few = middle }
    }
    many
}

#[test]
fn a_run_that_sticks_takes_few_more_steps_than_a_smooth_one() {
    let text = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\ntau = 1\nu_max = 2\n[plant]\n";
    let smooth = steps(&format!("{text}f = \"-0.2*x2 + 0.1\"\n"), &[0.1, 0.0]);
    for friction in ["0.5", "1", "3"] {
        let sticks = format!("{text}f = \"-0.2*x2 - {friction}*sign(x2) + 0.6*sin(20*t)\"\n");
        let sticks = steps(&sticks, &[0.1, 0.0]);
        assert!(sticks <= 10 * smooth, "{sticks} steps, {smooth} where it is smooth");
    }
}

#[test]
fn what_is_not_followed_is_undecided() {
    for (f, part) in [
        ("-5*sign(x1) - sign(x2)", "switches without end"),
        ("ln(x1 + 0.05)", "has no finite value"),
        ("sign(x2)", "two motions begin"),
    ] {
        let text = format!(
            "n = 2\nmu = \"exp(a=1)\"\ngains = [12, 7]\ntau = 1\nu_max = 0.5\n[plant]\nf = \"{f}\"\n"
        );
        let (spec, plant) = design(&text);
        let values = Values::of(&spec, &plant);
        let end = Continuous::of(&spec, &plant).expect("a loop").run(
            &values,
            &[0.0, 0.0],
            &[1e-6],
            Accuracy::default(),
            &mut |_| {},
        );
        let failure = end.expect_err(&text);
        assert_eq!(failure.cause, Cause::Unfinished, "{text}: {failure}");
        assert!(failure.at.is_some_and(|t| (0.0..1.0).contains(&t)), "{text}: {failure:?}");
        assert!(failure.message.contains(part), "{text}: {failure}");
    }
}

/// Between its limits u passes within 4e-6 tau here, which no step may overlook.
#[test]
fn the_passage_of_u_from_one_limit_to_the_other_is_not_stepped_over() {
    let text = "n = 4\nmu = \"tan(a=0.97)\"\npoles = [-5.28, -7.21, -7.71, -8.92]\ntau = 1.78\nu_max = 3.98\n\
                [plant]\nf = \"-0.09*x4 - 1.4*sign(x4) - 0.72\"\n";
    let x0 = [0.465, 0.0, 0.0, 0.0];
    let looked_at: Vec<_> = (0..=2000).map(|i| 0.2915 - 1e-6 * f64::from(i)).collect();
    let passage = continuous(text, &[], &x0, &looked_at);
    assert!(passage.iter().filter(|(_, _, u)| u.abs() < 3.98).count() >= 3);
    let (_, wanted, _) = passage.last().expect("an end");
    let (_, found, _) = &continuous(text, &[], &x0, &looked_at[2000..])[0];
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() <= 1e-10, "{found} {wanted}");
    }
}
