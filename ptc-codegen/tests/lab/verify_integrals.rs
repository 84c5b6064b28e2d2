//! Integrals over a run in objectives, against solutions in closed form and sums over samples by hand.

use crate::support;

use ptc_codegen::verify::{self, Campaign, Instant, Scenario, Status, Trial};
use support::{UNICYCLE, entries};

fn campaign(text: &str) -> Campaign {
    let (spec, plant) = support::design(text);
    let read = verify::read(&entries(text), &spec, &plant);
    read.unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"))
}

/// Objectives whose excess is each of these.
fn objectives(all: &[&str]) -> String {
    let one = |h: &&str| format!("[[objective]]\nbound = \"within\"\nh = \"{h}\"\nhigh = 0\n");
    all.iter().map(one).collect()
}

fn instants(campaign: &Campaign, scenario: &Scenario) -> Vec<Instant> {
    let mut instants = Vec::new();
    let mut trial = Trial::new(campaign).expect("a trial");
    let end = trial.instants(&campaign.setting(scenario), &mut |instant| instants.push(instant));
    end.unwrap_or_else(|failure| panic!("{failure:?}"));
    instants
}

fn near(found: f64, wanted: f64, within: f64) {
    assert!((found - wanted).abs() <= within * wanted.abs(), "{found:e}, not {wanted:e}");
}

/// With `exp` and poles -p_i, x1 is a sum of c_i s^p_i, s = T/tau, and u its n-th derivative, a sum of
/// v_i s^(p_i - n)/tau^n with v_i = (-1)^n p_i (p_i - 1).. c_i.
struct Exact {
    tau: f64,
    /// Powers of s in u, with their factors.
    u: Vec<(f64, f64)>,
}

impl Exact {
    fn of_one(tau: f64, p: f64, x1: f64) -> Self {
        Self { tau, u: vec![(p - 1.0, -p * x1 / tau)] }
    }

    fn of_two(tau: f64, [p, q]: [f64; 2], [x1, x2]: [f64; 2]) -> Self {
        // c + d = x1, and p c + q d = -tau x2.
        let d = (-tau * x2 - p * x1) / (q - p);
        let c = x1 - d;
        let term = |p: f64, c: f64| (p - 2.0, p * (p - 1.0) * c / (tau * tau));
        Self { tau, u: vec![term(p, c), term(q, d)] }
    }

    /// The integrals of u^2, once and twice, over time from t0 to T = s tau.
    fn squares(&self, s: f64) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for (a, v) in &self.u {
            for (b, w) in &self.u {
                let m = a + b + 1.0;
                let once = |s: f64| (1.0 - s.powf(m)) / m;
                sums[0] += self.tau * v * w * once(s);
                let twice = (1.0 - s) - (1.0 - s.powf(m + 1.0)) / (m + 1.0);
                sums[1] += self.tau * self.tau * v * w * twice / m;
            }
        }
        sums
    }
}

#[test]
fn the_square_of_u_is_integrated_once_and_twice() {
    // With a pole at -0.8 u grows without bound and its square over time too.
    for poles in [&[3.0][..], &[0.8], &[4.0, 5.0], &[1.2, 6.0]] {
        let n = poles.len();
        let written: Vec<_> = poles.iter().map(|p| format!("-{p}")).collect();
        let x2 = if n == 2 { "x2 = [-1, 1]\n" } else { "" };
        let text = format!(
            "n = {n}\nmu = \"exp(a=1)\"\npoles = [{}]\n[plant]\nf = 0\n[verify]\nx1 = [0.5, 1]\n{x2}\
             tau = [0.5, 2]\nt0 = [-3, 40]\nuntil = 1e-5\nscenarios = 9\n{}",
            written.join(", "),
            objectives(&["integral(u^2)", "integral(integral(u^2)) - x1", "3*integral(u^2)^2"])
        );
        let campaign = campaign(&text);
        assert_eq!(campaign.integrals.len(), 2, "the same one is integrated once");
        let mut trial = Trial::new(&campaign).expect("a trial");
        for index in 0..campaign.scenarios {
            let scenario = campaign.scenario(index);
            let (tau, x1) = (scenario.point[0], scenario.point[1]);
            let exact = match poles {
                [p] => Exact::of_one(tau, *p, x1),
                _ => Exact::of_two(tau, [poles[0], poles[1]], [x1, scenario.point[2]]),
            };
            let all = instants(&campaign, &scenario);
            assert!(all[0].integrals == [0.0, 0.0] && all.len() > 70);
            for Instant { time_to_go, x, integrals, excess, .. } in &all[1..] {
                let [once, twice] = exact.squares(time_to_go / tau);
                // A step is accurate to 1e-9 of each component, and an error of u counts twice.
                near(integrals[0], once, 1e-7);
                near(integrals[1], twice, 1e-7);
                assert!(excess[0] == integrals[0] && excess[1] == integrals[1] - x[0]);
                near(excess[2], 3.0 * once * once, 2e-7);
            }
            // The emitted program integrates the same, and its integrals are compared too.
            let outcome = trial.run(&campaign.setting(&scenario));
            assert_eq!(outcome.status(), Status::Finished);
            assert!(outcome.difference() < 1e-6, "{poles:?}: {}", outcome.difference());
        }
    }
}

/// Integrals are states behind those of the loop, which a proof does not know: with several of them, of x and of u,
/// each proof says so, and other objectives are proved beside them.
#[test]
fn several_integrals_are_left_to_sampling() {
    for n in 1..=3 {
        let poles: Vec<_> = (0..n).map(|i| format!("-{}", n + 1 + i)).collect();
        let text = format!(
            "n = {n}\nmu = \"exp(a=1)\"\npoles = [{}]\n[plant]\nf = 0\n[verify]\nx = [-1, 1]\ntau = [0.5, 2]\n\
             scenarios = 3\nsearch = 20\n{}[[objective]]\nbound = \"within\"\nh = \"x1\"\nhigh = 100\n",
            poles.join(", "),
            objectives(&["integral(u^2)", "integral(x1)", "integral(u) + x1", "integral(abs(x1))"])
        )
        .replace("x = [-1, 1]\n", &(1..=n).map(|j| format!("x{j} = [-1, 1]\n")).collect::<String>());
        let campaign = campaign(&text);
        let proofs = verify::bound::proved(&campaign);
        assert!(
            proofs[..4].iter().all(|proof| !proof.is_proved() && !proof.is_refuted()),
            "{proofs:?}"
        );
        assert!(proofs[4].is_proved(), "{proofs:?}");
    }
}

/// The integral continues where u is clipped: x is integrated there, and xi afterwards.
#[test]
fn an_integral_goes_on_where_u_leaves_its_bound() {
    let text = format!(
        "n = 1\nmu = \"exp(a=1)\"\ngains = [3]\n[params]\ntau = 2\nu_max = 1\n[plant]\nf = 0\n\
         [verify]\nx1 = 1\nscenarios = 1\n{}",
        objectives(&["integral(u^2)", "integral(abs(u))", "integral(max(t - 1, 0))"])
    );
    let campaign = campaign(&text);
    let mut trial = Trial::new(&campaign).expect("a trial");
    let scenario = campaign.scenario(0);
    assert!(trial.run(&campaign.setting(&scenario)).difference() < 1e-7);
    // x = 1 - t until 3x = T at t = 0.5; from there on x = x_s (T/T_s)^3.
    let (since, left) = (0.5, 1.5);
    for Instant { t, time_to_go, integrals, .. } in &instants(&campaign, &scenario)[1..] {
        let later = Exact::of_one(left, 3.0, 0.5);
        let (square, size) = match *t <= since {
            true => (*t, *t),
            false => {
                let s = time_to_go / left;
                (since + later.squares(s)[0], since + 0.5 * (1.0 - s.powi(3)))
            }
        };
        near(integrals[0], square, 1e-7);
        near(integrals[1], size, 1e-7);
        // It begins at 0 where the integrand has its kink.
        let after = (t - 1.0).max(0.0);
        assert!(
            (integrals[2] - 0.5 * after * after).abs() <= 1e-12 + 1e-7 * after * after,
            "{t}: {integrals:?}"
        );
    }
}

/// x' = -3 sign(x)/T from 1 is 1 + 3 ln T until it is 0, and stays there: u is either of -3/T and 3/T, whose mean
/// is 0, while the mean of its square is 9/T^2.
#[test]
fn a_state_that_slides_integrates_the_mean_of_both_sides() {
    let text = format!(
        "n = 1\nmu = \"exp(a=1)\"\npi0 = \"-3*sign(xi1)\"\n[params]\ntau = 1\n[plant]\nf = 0\n\
         [verify]\nx1 = 1\nt0 = 3\nuntil = 1e-2\nscenarios = 1\n{}",
        objectives(&["integral(u)", "integral(u^2)", "integral(abs(u))"])
    );
    let campaign = campaign(&text);
    let scenario = campaign.scenario(0);
    let all = instants(&campaign, &scenario);
    for Instant { time_to_go, x, integrals, .. } in &all[1..] {
        let there = (1.0 + 3.0 * time_to_go.ln()).max(0.0);
        assert!(
            (x[0] - there).abs() < 1e-9 && (integrals[0] - (there - 1.0)).abs() < 1e-8,
            "{x:?}"
        );
        near(integrals[1], 9.0 * (1.0 / time_to_go - 1.0), 1e-7);
        near(integrals[2], -3.0 * time_to_go.ln(), 1e-7);
    }
    let slides = all.iter().filter(|instant| instant.time_to_go < 0.7).count();
    assert!(slides > 30, "{slides}");
}

#[test]
fn held_inputs_are_summed() {
    let text = format!(
        "n = 1\nmu = \"exp(a=1)\"\ngains = [3]\nsample_time = 0.02\neps = 0.1\ndelay = 1\n[params]\ntau = 1\n\
         [plant]\nf = 0\n[verify]\nx1 = [0.5, 1]\nt0 = [0, 9]\nuntil = -0.3\nscenarios = 4\n{}",
        objectives(&["integral(u^2)", "integral(integral(u^2))", "integral(x1^2)", "integral(T)"])
    );
    let campaign = campaign(&text);
    let h = 0.02;
    for index in 0..campaign.scenarios {
        let all = instants(&campaign, &campaign.scenario(index));
        assert_eq!(all.len(), 66);
        let mut sums = [0.0; 4];
        for step in all.windows(2) {
            let (u, x, next) = (step[0].u[0], step[0].x[0], step[1].x[0]);
            sums[1] += h * sums[0] + 0.5 * h * h * u * u;
            sums[0] += h * u * u;
            sums[2] += h * (x * x + x * next + next * next) / 3.0;
            sums[3] += h * 0.5 * (step[0].time_to_go + step[1].time_to_go);
            // Of a held input and of polynomials in time each step is exact.
            for (found, wanted) in step[1].integrals.iter().zip(sums) {
                near(*found, wanted, 1e-10);
            }
        }
        assert!(all[0].u[0] == 0.0 && sums[0] > 0.1, "the first input is late");
    }
}

/// The matrix exponential gives no state between the samples, but the integral includes the motion there.
#[test]
fn integrals_see_a_linear_plant_between_its_samples() {
    let text = format!(
        "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.05\npoles = [-4, -5]\n[params]\ntau = 1\n\
         [plant]\nA = [[0, 1], [0, 0]]\nB = [0, 2]\n[verify]\nx1 = [0.5, 1]\nx2 = [-1, 1]\nscenarios = 4\n{}",
        objectives(&["integral(x1^2)", "integral(u^2 + dt)"])
    );
    let campaign = campaign(&text);
    let h = 0.05;
    for index in 0..campaign.scenarios {
        let all = instants(&campaign, &campaign.scenario(index));
        let mut sums = [0.0; 2];
        for step in all.windows(2) {
            let Instant { x, u, .. } = &step[0];
            let place = |t: f64| x[0] + x[1] * t + u[0] * t * t;
            near(place(h) + 9.0, step[1].x[0] + 9.0, 1e-12);
            // Gauss' three nodes are exact for its square.
            for (node, weight) in [(-0.6_f64.sqrt(), 5.0), (0.0, 8.0), (0.6_f64.sqrt(), 5.0)] {
                sums[0] += h * weight / 18.0 * place(0.5 * h * (1.0 + node)).powi(2);
            }
            let middle = 1.0 - 0.5 * (step[0].time_to_go + step[1].time_to_go);
            sums[1] += h * (u[0] * u[0] + middle);
            near(step[1].integrals[0], sums[0], 1e-8);
            near(step[1].integrals[1], sums[1], 1e-8);
        }
    }
}

/// Both outputs of the unicycle are chains of their own, whose inputs follow from them.
#[test]
fn several_inputs_are_integrated_by_their_names() {
    let text = format!(
        "{UNICYCLE}[verify]\nx = [0.9, 1]\ny = 1\ns = 1\nc = 0.3\nuntil = 0.1\nscenarios = 3\n{}",
        objectives(&["integral(a^2 + w^2)", "integral(x2_1^2) + x", "integral(s)"])
    );
    let campaign = campaign(&text);
    for index in 0..campaign.scenarios {
        let setting = campaign.closely(&campaign.scenario(index));
        let mut all = Vec::new();
        let mut trial = Trial::new(&campaign).expect("a trial");
        let end = trial.instants(&setting, &mut |instant| all.push(instant));
        end.expect("a run");
        let mut sums = [0.0; 3];
        for step in all.windows(2) {
            let at = |i: &Instant| {
                let [_, _, s, c] = i.x[..] else { panic!("{i:?}") };
                [i.u[0].powi(2) + i.u[1].powi(2), (s * c.cos()).powi(2), s]
            };
            let h = step[1].t - step[0].t;
            for (sum, (a, b)) in sums.iter_mut().zip(at(&step[0]).into_iter().zip(at(&step[1]))) {
                *sum += 0.5 * h * (a + b);
            }
        }
        // 1280 trapezoids of a smooth run.
        let last = all.last().expect("an instant");
        for (found, wanted) in last.integrals.iter().zip(sums) {
            near(*found, wanted, 1e-4);
        }
        assert!(last.excess[1] == last.integrals[1] + last.x[0]);
    }
}

/// An integrand without a value ends the run, which says nothing of the loop.
#[test]
fn an_integrand_without_a_value_is_undecided() {
    let text = format!(
        "n = 1\nmu = \"exp(a=1)\"\ngains = [3]\n[params]\ntau = 1\n[plant]\nf = 0\n[verify]\nx1 = 1\n\
         scenarios = 1\n{}",
        objectives(&["integral(sqrt(x1 - 0.5))"])
    );
    let campaign = campaign(&text);
    let outcome =
        Trial::new(&campaign).expect("a trial").run(&campaign.setting(&campaign.scenario(0)));
    assert_eq!(outcome.status(), Status::Unfinished);
    let told = format!("{:?}", outcome.ended);
    assert!(told.contains("what an objective integrates has no finite value close by"), "{told}");
}
