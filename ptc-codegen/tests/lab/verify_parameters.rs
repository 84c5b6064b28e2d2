//! Start time and parameters of mapping and law as uncertain quantities.

use crate::support;

use ptc_codegen::parameter::Parameter;
use ptc_codegen::verify::{self, Campaign, Instant, Trial, bound};
use support::entries;

fn read(text: &str) -> Result<Campaign, String> {
    let (spec, plant) = support::design(text);
    verify::read(&entries(text), &spec, &plant).map_err(|wrong| format!("{wrong:?}"))
}

fn campaign(text: &str) -> Campaign {
    read(text).unwrap_or_else(|wrong| panic!("{wrong}\n{text}"))
}

const OWN: &str = "n = 1\nmu = \"exp\"\npi0 = \"-k*xi1\"\n[params]\ntau = 1\nk = [2, 6]\n[plant]\nf = 0\n[verify]\n\
                   x1 = [0.5, 1]\na = [1, 2]\nt0 = [10, 20]\nscenarios = 20\n[[objective]]\n\
                   bound = \"within\"\nh = \"x1 + 0*t\"\nlow = 0\n";

/// x = x0 (T/tau)^(k/a), whatever t0 is.
#[test]
fn each_draw_runs_with_its_own_parameters() {
    let campaign = campaign(OWN);
    let columns = ["tau", "x1_0", "t0", "a", "k"];
    let found = campaign.columns();
    let mut sorted: Vec<_> = found[..5].iter().map(String::as_str).collect();
    assert_eq!(sorted.remove(0), columns[0]);
    assert!(columns[1..].iter().all(|name| sorted.contains(name)), "{found:?}");
    assert!(
        [Parameter::StartTime, Parameter::A].iter().all(|p| !campaign.spec.fixed.contains_key(p))
    );
    let place = |name: &str| found.iter().position(|own| own == name).expect("a column");
    let mut trial = Trial::new(&campaign).expect("a trial");
    let draws = (0..campaign.scenarios).map(|index| campaign.scenario(index));
    for scenario in draws.chain(campaign.corners()) {
        let of = |name: &str| scenario.point[place(name)];
        let within = |name: &str, low: f64, high: f64| (low..=high).contains(&of(name));
        assert!(within("a", 1.0, 2.0) && within("k", 2.0, 6.0) && within("t0", 10.0, 20.0));
        let setting = campaign.setting(&scenario);
        let told = campaign.text_of(&scenario);
        assert_eq!(campaign.replayed(&told), Ok(scenario.clone()), "{told}");
        let (mut count, rate) = (0, of("k") / of("a"));
        let end = trial.instants(&setting, &mut |Instant { t, time_to_go, x, .. }| {
            let wanted = of("x1_0") * time_to_go.powf(rate);
            assert!((x[0] - wanted).abs() < 1e-7 * wanted, "{told}: {} not {wanted}", x[0]);
            assert!((t - (of("t0") + 1.0 - time_to_go)).abs() < 1e-12);
            count += 1;
        });
        assert!(end.is_ok() && count > 70, "{end:?}");
        // The emitted program, and all in lanes, are the same loop.
        let outcome = trial.run_one(&setting);
        assert!(outcome.difference() < 1e-6 && outcome.worst(0) < 0.0, "{told}: {outcome:?}");
    }
    // Of x1, a, k and t0 all corners, with tau fixed.
    assert_eq!(campaign.corners().len(), 16);
}

/// Gains that the design leaves to run time: one is drawn, the other is known.
#[test]
fn run_time_gains_are_drawn() {
    let text = "n = 2\nmu = \"exp(a=1)\"\n[params]\ntau = 1\n[plant]\nf = 0\n[verify]\nx1 = 1\n\
                x2 = 0\nk2 = 9\nk1 = [12, 18]\nscenarios = 3\n[[objective]]\nbound = \"attractive\"\nerror = 1\n";
    let campaign = campaign(text);
    // u at t0 is kappa'^2 (-k1 x1 - k2 tau x2) + kappa'' tau x2 with kappa' = 1.
    let mut trial = Trial::new(&campaign).expect("a trial");
    for index in 0..3 {
        let scenario = campaign.scenario(index);
        let mut first = None;
        let end = trial.instants(&campaign.setting(&scenario), &mut |instant| {
            first.get_or_insert(instant.u[0]);
        });
        let (k1, u) = (scenario.point[3], first.expect("an instant"));
        assert!(end.is_ok() && (12.0..18.0).contains(&k1) && (u + k1).abs() < 1e-12 * k1, "{u}");
    }
    // What is proved is of one controller; of one number it is as before.
    let why = format!("{:?}", bound::proved(&campaign));
    assert!(why.contains("k1 is an interval, and the proof is of one controller"), "{why}");
    let why =
        format!("{:?}", bound::proved(&self::campaign(&text.replace("k1 =", "k1 = 20\nt0 ="))));
    assert!(why.contains("t0 is an interval"), "{why}");
    let known = self::campaign(&text.replace("k1 = [12, 18]", "k1 = 20\nt0 = 12"));
    assert!(bound::proved(&known).iter().all(bound::Proof::is_proved));
}

#[test]
fn intervals_that_are_illegal_are_refused() {
    let with = |from: &str, to: &str| read(&OWN.replace(from, to)).err().unwrap_or_default();
    for (from, to, part) in [
        ("a = [1, 2]", "a = [0, 2]", "a (rate of stretched time) leaves its domain"),
        ("a = [1, 2]", "a = [2, 1]", "the interval of a is empty"),
        (
            "a = [1, 2]",
            "a = [1, 2]\nk = [2, 7]",
            "k (parameter of an expression of the design) leaves its domain",
        ),
        ("a = [1, 2]", "a = [1, 2]\neps = [0.1, 0.2]", "unknown key `verify.eps`"),
        ("a = [1, 2]", "a = [1, 2]\nu_max = 1", "unknown key `verify.u_max`"),
        ("a = [1, 2]", "a = [1, 2]\nk1 = 1", "unknown key `verify.k1`"),
        ("a = [1, 2]\n", "", "a without a value in the design"),
        ("t0 = [10, 20]", "t0 = \"x\"", "verify.t0 is not an interval"),
    ] {
        let wrong = with(from, to);
        assert!(wrong.contains(part), "{to}: no {part:?} in {wrong}");
    }
    let model = "mu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 1\nJ = 2\n[model]\nstates = [\"q\", \"w\"]\n\
                 input = \"u\"\noutput = \"q\"\ndynamics = { q = \"w\", w = \"u - J*q\" }\n[plant]\nJ = 3\n[verify]\n\
                 q = 1\nw = 0\nJ = [1, 3]\n[[objective]]\nbound = \"attractive\"\nerror = 1\n";
    let wrong = read(model).err().unwrap_or_default();
    assert!(wrong.contains("`J` = [1, 3] under [plant] is of the plant alone"), "{wrong}");
    assert!(read(&model.replace("[plant]\nJ = 3\n", "").replace("J = 2\n", "")).is_ok());
    let help = with("a = [1, 2]", "a = [1, 2]\ntn = 1");
    assert!(help.contains("did you mean") && help.contains("x1, a, k, tau, t0, "), "{help}");
    assert!(read(&OWN.replace("a = [1, 2]", "a = [1, 2]\nk = [3, 4]")).is_ok());
}

#[test]
fn integrals_that_are_illegal_are_refused() {
    let with = |h: &str| {
        let text = OWN.replace("x1 + 0*t", h);
        read(&text).err().unwrap_or_default()
    };
    for (h, part) in [
        ("integral()", "`integral` takes one argument"),
        ("integral(u, x1)", "`integral` takes one argument"),
        ("integral(of = u)", "`integral` takes one argument"),
        ("integral", "the function `integral` has no argument"),
        ("integral(x2)", "x2"),
        ("integral(y)", "y without a value"),
        ("intgral(u)", "did you mean `integral`?"),
    ] {
        let wrong = with(h);
        assert!(wrong.contains(part), "{h}: no {part:?} in {wrong}");
    }
    let wrong = read(&OWN.replace("low = 0", "low = \"integral(1)\"")).err().unwrap_or_default();
    assert!(wrong.contains("an integral outside of an objective's h"), "{wrong}");
    // 15 beside one state are legal, and no more.
    let sum = |count: u32| {
        (1..=count).map(|k| format!("integral(x1^{k})")).collect::<Vec<_>>().join(" + ")
    };
    assert_eq!(with(&sum(15)), "");
    let wrong = with(&sum(16));
    assert!(wrong.contains("more than 15 integrals of a plant with 1 state"), "{wrong}");
    let deep = format!("{}u{}", "integral(".repeat(15), ")".repeat(15));
    let read = campaign(&OWN.replace("x1 + 0*t", &deep));
    assert!(read.objectives[0].to_string().contains(&deep) && read.integrals.len() == 15);
}

/// A value that is compiled into the controller has no interval: the program that runs would not be the emitted one.
#[test]
fn intervals_over_compiled_in_values_are_refused() {
    const OPEN: [&str; 5] = ["tau = 1\n", "t0 = 5\n", "a = 1\n", "b = 3\n", "k1 = 2\n"];
    let read = |fixed: &str, given: &str| {
        let verified = OPEN.concat().replace(fixed, given);
        let (head, params) =
            if fixed.starts_with("k1") { ("gains = 2\n", "") } else { ("", fixed) };
        read(&format!(
            "{head}n = 1\nmu = \"exp\"\nf = \"-b*x1\"\n[params]\n{params}[plant]\nf = \"-(b + c)*x1\"\nc = 1\n\
             [verify]\nx1 = 1\n{verified}[[objective]]\nbound = \"attractive\"\nerror = 1\n"
        ))
    };
    for fixed in OPEN {
        let (name, value) = fixed.trim().split_once(" = ").expect("a value");
        for other in [format!("{name} = [{value}, 6]\n"), format!("{name} = 6\n")] {
            let wrong = read(fixed, &other).expect_err(&other);
            let told = format!("`{name}` = {value} is compiled into the controller");
            assert!(wrong.contains(&told) && wrong.contains("at run time"), "{wrong}");
            assert_eq!(wrong.contains("write true_b in its f"), name == "b", "{wrong}");
        }
        for same in [fixed, ""] {
            let campaign = read(fixed, same).unwrap_or_else(|wrong| panic!("{fixed}: {wrong}"));
            assert_eq!(campaign.design.spec.fixed.len(), 1, "{fixed}");
        }
    }
}

/// `init` refuses a rate above that of the check `growth`, so no loop with it runs.
#[test]
fn rates_that_init_refuses_are_no_interval() {
    let text = "n = 2\nmu = \"tanh\"\ngains = [6, 5]\n[params]\nt0 = 0\neps = 0.01\nu_max = inf\n[plant]\nf = 0\n\
                [verify]\nx1 = 1\nx2 = 0\ntau = 1\na = [0.2, 0.6]\n[[objective]]\nbound = \"attractive\"\nerror = 0.1\n";
    let wrong = read(text).expect_err("a rate above 0.499");
    assert!(wrong.contains("a (rate of stretched time) leaves its domain"), "{wrong}");
    assert!(wrong.contains("at most 4.99e-1 by the check `growth`"), "{wrong}");
    let allowed = text.replace("n = 2", "n = 2\nallow = [\"growth\"]");
    assert!(read(&allowed).is_ok() && read(&text.replace("0.6", "0.4")).is_ok());
}
