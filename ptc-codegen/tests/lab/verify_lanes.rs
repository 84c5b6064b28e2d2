//! Scenarios in lanes: against closed solutions, against runs by themselves, and alone or in company.

use crate::support;

use ptc_codegen::verify::{self, Campaign, Outcome, Setting, Trial};

pub(crate) fn campaign(text: &str) -> Campaign {
    let read = verify::read_with_plant(&support::entries(text), &support::spec(text));
    read.unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"))
}

/// All numbers of an outcome.
fn numbers(outcome: &Outcome) -> Vec<f64> {
    let mut numbers = outcome.excess.clone();
    if let Some(direct) = &outcome.direct {
        numbers.extend(&direct.excess);
        numbers.push(direct.difference);
    }
    numbers
}

pub(crate) fn bits(outcome: &Outcome) -> Vec<u64> {
    numbers(outcome).into_iter().map(f64::to_bits).collect()
}

pub(crate) fn settings(campaign: &Campaign, count: u64) -> Vec<Setting> {
    (0..count).map(|index| campaign.setting(&campaign.scenario(index))).collect()
}

/// A chain with a box, a tau that is drawn, a force of all signals, and bounds of the last state and of u.
fn design(n: usize, mu: &str, poles: &str, rest: &str) -> String {
    let states: String = (1..=n).map(|j| format!("x{j} = [-1, 1]\n")).collect();
    format!(
        "n = {n}\nmu = \"{mu}\"\npoles = [{poles}]\n{rest}[plant]\n\
         f = \"gust - damping*x{n} + slip*u\"\ndamping = [0, 0.5]\nslip = [-0.2, 0.2]\n\
         gust = [-0.1, 0.3]\n[disturbance]\ngust = \"any\"\n[verify]\n{states}tau = [0.5, 2]\n\
         scenarios = 100\nseed = 3\n[[objective]]\nbound = \"within\"\nh = \"x{n}\"\nhigh = 1\n\
         [[objective]]\nbound = \"input\"\nupsilon = 10\n[[objective]]\nbound = \"attractive\"\nerror = 1\n"
    )
}

fn until(n: usize, mu: &str, poles: &str, end: &str) -> String {
    design(n, mu, poles, "").replace("seed = 3\n", &format!("seed = 3\nuntil = {end}\n"))
}

/// With poles -2 and -3 all is a polynomial of T: the instants lie within steps, so this is the dense
/// output too.
#[test]
fn the_dense_output_is_the_closed_solution() {
    for h in ["x1 - 3*T^2 + 2*T^3", "x2 + 6*T - 6*T^2", "u - 3 + 6*T"] {
        let text = format!(
            "n = 2\nmu = \"exp(a=1)\"\ng = 2\ngains = [6, 5]\nallow = \"growth\"\n[plant]\nf = 0\n[verify]\n\
             x1 = 1\nx2 = 0\ntau = 1\nscenarios = 1\nuntil = 1e-3\n[[objective]]\nbound = \"within\"\n\
             h = \"{h}\"\nlow = 0\nhigh = 0\n"
        );
        let campaign = campaign(&text);
        let mut trial = Trial::new(&campaign).expect("a loop");
        for outcome in trial.run_all(&settings(&campaign, 1)) {
            let [stretched, direct, difference] = numbers(&outcome)[..] else {
                panic!("{outcome:?}")
            };
            assert!(stretched < 1e-8 && direct < 1e-8 && difference < 1e-8, "{h}: {outcome:?}");
        }
    }
}

#[test]
fn a_scenario_has_the_same_bits_in_any_company() {
    for text in [
        design(3, "exp(a=1)", "-4, -5, -6", ""),
        until(3, "exp_sum(rates=[1, 2])", "-4, -5, -6", "1e-3"),
        until(3, "rational(a=1)", "-4, -5, -6", "1e-3"),
        until(2, "power(a=1, m=1/2)", "-4, -50", "1e-4"),
    ] {
        in_any_company(&campaign(&text));
    }
}

pub(crate) fn in_any_company(campaign: &Campaign) {
    let mut trial = Trial::new(campaign).expect("a loop");
    // Three packs of lanes and a part of one.
    let settings = settings(campaign, 27);
    let together: Vec<_> = trial.run_all(&settings).iter().map(bits).collect();
    for (setting, own) in settings.iter().zip(&together) {
        let alone = trial.run_all(std::slice::from_ref(setting));
        assert_eq!(bits(&alone[0]), *own);
    }
    let backwards: Vec<_> = settings.iter().rev().cloned().collect();
    let backwards = trial.run_all(&backwards);
    assert!(backwards.iter().rev().map(bits).eq(together));
}

/// The worst difference from runs by themselves, as a part of each number, and whether no bit is another.
pub(crate) fn beside(text: &str, count: u64) -> (f64, bool) {
    let campaign = campaign(text);
    let mut trial = Trial::new(&campaign).expect("a loop");
    let settings = settings(&campaign, count);
    let together = trial.run_all(&settings);
    let (mut worst, mut same) = (0.0_f64, true);
    for (setting, own) in settings.iter().zip(&together) {
        let alone = trial.run(setting);
        assert_eq!(alone.status(), own.status(), "{text}");
        let apart = alone.difference().max(own.difference());
        assert!(apart < campaign.tolerance, "{apart:.1e}, {text}");
        same &= bits(&alone) == bits(own);
        let (alone, own) = (numbers(&alone), numbers(own));
        let sizes = alone.iter().zip(&own).map(|(a, b)| (a - b).abs() / (1.0 + a.abs()));
        worst = sizes.fold(worst, f64::max);
    }
    (worst, same)
}

#[test]
fn lanes_agree_with_runs_by_themselves() {
    let families = [
        "exp(a=1)",
        "rational(a=1)",
        "power(a=1, m=1/2)",
        "tan(a=1)",
        "tanh(a=1/2)",
        "algebraic(a=1)",
        "exp_sum(rates=[1, 2])",
    ];
    for (place, mu) in families.into_iter().enumerate() {
        for n in [1 + place, 2 + place % 3] {
            let poles: Vec<_> = (0..n).map(|i| format!("-{}", n + 1 + i)).collect();
            let (worst, same) = beside(&until(n, mu, &poles.join(", "), "0.01"), 4);
            // Where rounding is amplified most, a run is left to itself.
            assert!(worst < 1e-6 && (n > 5 || !same), "{mu}, n = {n}: {worst:.1e}");
        }
    }
}

#[test]
fn what_is_not_smooth_is_run_by_itself() {
    let text = design(2, "exp(a=1)", "-4, -5", "").replacen("gust -", "0.1*abs(x1) + gust -", 1);
    assert_eq!(beside(&text, 3), (0.0, true), "{text}");
}

/// Below its bound u is what it is without one, bit by bit; a run that comes near the bound is one by itself.
#[test]
fn runs_within_their_bound_of_u_are_in_lanes() {
    let (mut within, mut near) = (0, 0);
    for (n, mu, poles, end) in [
        (2, "exp(a=1)", "-4, -5", "1e-3"),
        (3, "exp(a=1)", "-4, -5, -6", "1e-3"),
        (3, "tanh(a=1)", "-4, -5, -6", "1e-3"),
        (2, "rational(a=1)", "-4, -5", "1e-3"),
        (4, "tan(a=1)", "-4, -5, -6, -7", "1e-2"),
    ] {
        let text = until(n, mu, poles, end);
        let free = campaign(&text);
        let settings = settings(&free, 24);
        let all = Trial::new(&free).expect("a loop").run_all(&settings);
        // |u| of the objective at its worst instant: the median as the bound halves the runs.
        let peak = |outcome: &Outcome| 10.0 * (1.0 + outcome.excess[1]);
        let mut peaks: Vec<_> = all.iter().map(peak).collect();
        peaks.sort_by(f64::total_cmp);
        let bound = peaks[12] / 0.95;
        let bounded =
            campaign(&text.replacen("[plant]", &format!("[params]\nu_max = {bound}\n[plant]"), 1));
        let mut trial = Trial::new(&bounded).expect("a loop");
        let settings = self::settings(&bounded, 24);
        for ((setting, own), free) in settings.iter().zip(trial.run_all(&settings)).zip(&all) {
            if peak(free) > 0.95 * bound * (1.0 + 1e-6) {
                assert_eq!(bits(&own), bits(&trial.run(setting)), "{mu}, n = {n}");
                near += 1;
            } else if bits(&own) == bits(free) {
                within += 1;
            }
        }
    }
    assert!(within > 50 && near > 50, "{within} within, {near} near their bound");
}

/// Far apart poles, and much stretched time.
#[test]
fn stiff_loops_agree_too() {
    for mu in ["rational(a=1)", "tan(a=1)"] {
        let (worst, same) = beside(&until(2, mu, "-2, -200", "1e-3"), 2);
        assert!(worst < 1e-6 && !same, "{mu}: {worst:.1e}");
    }
}

/// f is what takes the state along T^6 under the law, u = T^-4 (-6 x1 - 5 T^2 x2 + 2 T^3 x2): far into the
/// part in which the loop is stiff every instant is known, those between the nodes of a step too.
#[test]
fn a_stiff_loop_follows_its_closed_solution() {
    for h in ["x1/T^6 - 1", "x2/T^5 + 6"] {
        let text = format!(
            "n = 2\nmu = \"rational(a=1)\"\ngains = [6, 5]\n[plant]\n\
             f = \"42*(1 - t)^4 - 30*(1 - t)^3 + 6*(1 - t)^2 + bend*sin(x1 - (1 - t)^6)\"\nbend = [0, 1]\n\
             [verify]\nx1 = 1\nx2 = -6\ntau = 1\nscenarios = 3\nuntil = 2e-3\n[[objective]]\n\
             bound = \"within\"\nh = \"{h}\"\nlow = 0\nhigh = 0\n"
        );
        let campaign = campaign(&text);
        let mut trial = Trial::new(&campaign).expect("a loop");
        let settings = settings(&campaign, 3);
        for (setting, outcome) in settings.iter().zip(trial.run_all(&settings)) {
            let [stretched, direct, _] = numbers(&outcome)[..] else { panic!("{outcome:?}") };
            assert!(stretched < 1e-6 && direct < 1e-6, "{h}: {outcome:?}");
            assert_ne!(bits(&outcome), bits(&trial.run(setting)), "not in lanes");
        }
    }
}

/// |x| at the end, by Gauss collocation of order 28 with 50 digits in another language: `(mu, poles, until, |x|)`.
const REFERENCES: [(&str, &str, &str, f64); 6] = [
    ("rational(a=1)", "-2", "1e-3", 5.560_499_262_752_409e-8),
    ("rational(a=1)", "-4, -5", "1e-3", 2.227_232_743_149_770_7e-11),
    ("rational(a=1)", "-2, -200", "1e-3", 1.113_925_173_687_575_7e-12),
    ("rational(a=1)", "-4, -5, -6", "1e-3", 2.792_222_546_176_7e-14),
    ("power(a=1, m=1/2)", "-4, -5, -6", "1e-3", 5.170_436_306_081_515e-10),
    ("power(a=1, m=1/2)", "-4, -5", "1e-9", 1.666_749_680_087_816_6e-20),
];

/// A loop that turns out to be stiff ends where the references do, on both sides: with a t0 that rounds the time
/// the emitted program has too.
#[test]
fn stiff_loops_end_where_long_arithmetic_does() {
    for (mu, poles, until, size) in REFERENCES {
        let n = poles.split(',').count();
        let states: String =
            (1..=n).zip(["0.5", "-0.75", "0.25"]).map(|(j, x)| format!("x{j} = {x}\n")).collect();
        for t0 in if until == "1e-3" { vec![0, 3] } else { vec![0] } {
            let text = format!(
                "n = {n}\nmu = \"{mu}\"\npoles = [{poles}]\nallow = \"growth\"\n[params]\ntau = 1.25\nt0 = {t0}\n[plant]\n\
                 f = \"gust - damping*x{n} + slip*u\"\ngust = 0.1\ndamping = 0.375\nslip = 0.125\n\
                 [verify]\n{states}scenarios = 1\nuntil = {until}\n[[objective]]\nbound = \"attractive\"\n\
                 error = {size:e}\n"
            );
            let campaign = campaign(&text);
            let mut trial = Trial::new(&campaign).expect("a loop");
            let settings = settings(&campaign, 1);
            let outcome = &trial.run_all(&settings)[0];
            let [stretched, direct, _] = numbers(outcome)[..] else { panic!("{outcome:?}") };
            println!("{mu}, {poles}, t0 = {t0}: {stretched:.1e}, {direct:.1e}");
            assert!(stretched.abs() < 1e-7 && direct.abs() < 1e-7, "{text}: {outcome:?}");
            assert_ne!(bits(outcome), bits(&trial.run(&settings[0])), "not in lanes: {text}");
        }
    }
}

/// Transitions in place of an integration, beside runs by themselves: all families but exp_sum, which is
/// integrated.
#[test]
fn linear_loops_need_no_integration() {
    let families = [
        ("exp(a=1)", "1e-6"),
        ("rational(a=1)", "1e-2"),
        ("power(a=1, m=1/2)", "1e-2"),
        ("tan(a=1)", "1e-2"),
        ("tanh(a=1/2)", "1e-4"),
        ("algebraic(a=1)", "1e-2"),
        ("soft(a=1, start=1/2)", "1e-2"),
    ];
    for (place, (mu, end)) in families.into_iter().enumerate() {
        for n in [1 + place % 6, 2 + place % 3] {
            let poles: Vec<_> = (0..n).map(|i| format!("-{}", n + 1 + i)).collect();
            let text = until(n, mu, &poles.join(", "), end)
                .replace("f = \"gust - damping*x", "f = \"gust + bias\"\nbias = 0.1 # ")
                .replace("damping = [0, 0.5]\nslip = [-0.2, 0.2]\n", "")
                .replace("\"any\"", "[\"constant\", \"random\", \"worst\"]");
            let campaign = campaign(&text);
            let mut trial = Trial::new(&campaign).expect("a loop");
            let settings = settings(&campaign, 5);
            for (setting, own) in settings.iter().zip(trial.run_all(&settings)) {
                // The sides have one state, and u of the law and of the program in it.
                assert!(own.difference() < 1e-9, "{mu}, n = {n}: {own:?}");
                let alone = trial.run(setting);
                let apart = alone.difference().max(1e-7);
                for (a, b) in numbers(&alone).iter().zip(numbers(&own)).take(6) {
                    assert!((a - b).abs() <= apart * (10.0 + a.abs()), "{mu}, n = {n}: {a} {b}");
                }
            }
            in_any_company(&campaign);
        }
    }
}

/// Clipping is not part of a linear loop, so that runs that reach their bound run by themselves.
#[test]
fn what_is_clipped_is_run_by_itself() {
    let text = design(2, "exp(a=1)", "-4, -5", "")
        .replace("f = \"gust - damping*x2 + slip*u\"", "f = \"gust\"")
        .replace("damping = [0, 0.5]\nslip = [-0.2, 0.2]\n", "");
    let clipped = text.replace("[plant]", "[params]\nu_max = 0.1\n[plant]");
    assert_eq!(beside(&clipped, 3), (0.0, true), "{clipped}");
}

/// The loop that runs: in lanes it has the bits that it has by itself.
#[test]
fn sampled_loops_have_the_same_bits_in_lanes() {
    let plants = [
        "f = \"gust\"\n",
        "f = \"gust - damping*x2 + slip*u - 0.3*sin(4*t)\"\ndamping = [0, 0.5]\nslip = [-0.2, 0.2]\n",
    ];
    let loops = [
        "",
        "noise = [1e-3, 1e-2]\nsensor_step = [1e-3, 0]\nu_step = 1e-2\njitter = 1e-3\n",
        "noise_rms = [1e-3, 1e-2]\ndelay = 3\ng_error = [0.9, 1.1]\n",
        "delay = 2\n",
        "delay = 1\nafter = \"zero\"\n",
        "noise = [1e-3, 0]\nreference = \"0.2*sin(2*t) + 0.1\"\n",
    ];
    for plant in plants {
        for around in loops {
            for (more, until) in [("", "0"), ("u_max = 20\n", "-0.3"), ("t0 = 1000\n", "0.013")] {
                let text = format!(
                    "n = 2\nmu = \"exp(a=1)\"\npoles = [-3, -4]\neps = 0.08\nsample_time = 0.01\n{around}[params]\n\
                     {more}[plant]\n{plant}gust = [-0.1, 0.3]\n[disturbance]\ngust = \"any\"\n[verify]\nx1 = [-1, 1]\n\
                     x2 = [-1, 1]\ntau = [0.503, 1]\nuntil = {until}\nscenarios = 20\nseed = 3\n[[objective]]\n\
                     bound = \"attractive\"\nerror = 0.1\n[[objective]]\nbound = \"input\"\nupsilon = 10\n\
                     [[objective]]\nbound = \"within\"\nh = \"x2 + T\"\nhigh = 3\n"
                );
                assert_eq!(beside(&text, 20), (0.0, true), "{text}");
                in_any_company(&campaign(&text));
            }
        }
    }
}

/// Every kind of objective, those too that have no value everywhere, of runs that share what the law computes of
/// time, and of some that do not.
#[test]
fn objectives_of_sampled_loops_have_the_same_bits_in_lanes() {
    let objectives = "[[objective]]\nbound = \"state\"\nsigma = 8\nzeta = \"sqrt(abs(T)/tau + 0.1)\"\n\
         [[objective]]\nbound = \"input\"\nupsilon = \"10 + T\"\n[[objective]]\nbound = \"within\"\n\
         h = \"sqrt(x2 + 2)\"\nlow = \"0.9 - T\"\nhigh = 3\n[[objective]]\nbound = \"within\"\nh = \"1/u\"\n\
         low = -1\n[[objective]]\nbound = \"attractive\"\nerror = 0.1\n";
    for (mu, more, drawn) in [
        ("exp(a=1)", "tau = 0.503\n", ""),
        ("tanh(a=1)", "tau = 1\nu_max = 20\n", ""),
        ("exp_sum(rates=[1, 2])", "tau = 1\n", ""),
        ("exp(a=1)", "tau = 1\n", "t0 = [0, 5]\n"),
        ("exp(a=1)", "", "tau = [0.503, 1]\n"),
    ] {
        let text = format!(
            "n = 3\nmu = \"{mu}\"\npoles = [-4, -5, -6]\neps = 0.08\nsample_time = 0.01\n[params]\n{more}[plant]\n\
             f = \"gust - damping*x2\"\ndamping = [0, 0.5]\ngust = [-0.1, 0.3]\n[disturbance]\n\
             gust = [\"constant\", \"worst\"]\n[verify]\nx1 = [0.2, 1]\nx2 = [-3, 1]\nx3 = 0\n{drawn}until = -0.2\n\
             scenarios = 20\nseed = 5\n{objectives}"
        );
        assert_eq!(beside(&text, 27), (0.0, true), "{text}");
        in_any_company(&campaign(&text));
    }
}

/// A sampled plant under a sine by the exponential, and by an integration, which a term close to 0 forces.
#[test]
fn sampled_plants_under_sines_are_exact() {
    let outcomes = |f: &str| {
        let text = format!(
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-3, -4]\neps = 0.1\nsample_time = 0.02\n[params]\ntau = 1\nt0 = 3\n\
             [plant]\nf = \"{f}\"\ngust = [-0.5, 0.5]\n[disturbance]\ngust = \"sine\"\n[verify]\nx1 = [-1, 1]\n\
             x2 = [-1, 1]\nscenarios = 20\nuntil = -0.2\n[[objective]]\nbound = \"within\"\nh = \"x1\"\nhigh = 0\n\
             [[objective]]\nbound = \"within\"\nh = \"x2\"\nhigh = 0\n[[objective]]\nbound = \"attractive\"\nerror = 1\n"
        );
        let campaign = campaign(&text);
        Trial::new(&campaign).expect("a loop").run_all(&settings(&campaign, 20))
    };
    let terms = "3*gust/(1 + tau) - 2*x1 - (x2 + cos(7*t - 1))/2 + sin(dt)";
    let (exact, integrated) = (outcomes(terms), outcomes(&format!("{terms} + 1e-30*x1^2")));
    for (own, other) in exact.iter().zip(&integrated) {
        assert!(numbers(own) != numbers(other), "{own:?}");
        for (a, b) in numbers(own).iter().zip(numbers(other)) {
            assert!((a - b).abs() < 1e-8, "{a} {b}");
        }
    }
}
