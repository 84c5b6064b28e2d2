//! Statistics of draws: against draws with made-up measures, and against single runs.

use crate::support;

use ptc_codegen::verify::record::Row;
use ptc_codegen::verify::{self, Campaign, Drawn, Envelope, Other, Outcome, Signal, Trial};

const DESIGN: &str = "n = 2\nmu = \"exp(a=1)\"\npoles = [-3, -4]\n[plant]\n\
                      f = \"gust - damping*x2 + slip*u\"\ndamping = [0, 0.5]\nslip = [-0.2, 0.2]\n\
                      gust = [-0.1, 0.3]\n[disturbance]\ngust = \"any\"\n[verify]\nx1 = [-1, 1]\n\
                      x2 = [0.25, 1]\ntau = [0.5, 2]\nscenarios = 4000\nseed = 5\n[[objective]]\n\
                      bound = \"attractive\"\nerror = 1\n";

fn campaign() -> Campaign {
    let (spec, plant) = support::design(DESIGN);
    let read = verify::read(&support::entries(DESIGN), &spec, &plant);
    read.unwrap_or_else(|wrong| panic!("{wrong:?}"))
}

/// Rows whose size, a part of the bound, is a function of tau, x1, x2, damping and slip and the signal.
fn rows(campaign: &Campaign, size: &dyn Fn(&[f64], Signal) -> f64) -> Vec<Row> {
    let row = |index| {
        let drawn = campaign.scenario(index);
        let excess = size(&drawn.point, drawn.courses[0].signal()) - 1.0;
        let direct = Some(Other { excess: vec![excess], difference: 0.0 });
        let outcome = Outcome { excess: vec![excess], direct, ended: None };
        Row { index, numbers: campaign.numbers(&drawn, outcome) }
    };
    (0..campaign.scenarios).map(row).collect()
}

fn drawn(campaign: &Campaign, rows: &[Row]) -> Drawn {
    let mut drawn = Drawn::new(campaign);
    rows.iter().for_each(|row| drawn.add(campaign, row));
    drawn
}

#[test]
fn percentiles_are_those_of_the_sorted_draws() {
    let campaign = campaign();
    let rows = rows(&campaign, &|point, _| (3.0 * point[1]).exp() * point[0]);
    let all = drawn(&campaign, &rows);
    let place = campaign.columns().iter().position(|name| name == "excess1").expect("a column");
    let mut sizes: Vec<_> = rows.iter().map(|row| row.numbers[place] + 1.0).collect();
    sizes.sort_by(f64::total_cmp);
    for share in [0.001, 0.5, 0.9, 0.99, 1.0] {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let place = (share * sizes.len() as f64).ceil() as usize - 1;
        let told = all.spreads[0].percentile(share);
        assert!(told >= sizes[place] && told <= 1.01 * sizes[place], "{share}: {told}");
    }
    let counted: u64 = all.spreads[0].measures().iter().map(|(_, count)| count).sum();
    assert_eq!(counted, campaign.scenarios);
    let worst = &all.spreads[0].worst;
    assert_eq!(worst.len(), 10);
    for (kept, size) in worst.iter().zip(sizes.iter().rev()) {
        assert_eq!(kept.value + 1.0, *size);
    }
}

#[test]
fn what_drives_an_objective_is_found() {
    let campaign = campaign();
    let driven =
        |size: &dyn Fn(&[f64], Signal) -> f64| drawn(&campaign, &rows(&campaign, size)).drivers(0);
    // Of even numbers a U + b V, a^2 : b^2 of the variance.
    let both = driven(&|point, _| 2.0 * point[3] / 0.5 + (point[4] + 0.2) / 0.4);
    let names: Vec<_> = both.iter().map(|driver| driver.name.as_str()).collect();
    assert_eq!(names, ["damping", "slip"]);
    // 4000 draws scatter by about 0.01, and the rank of a sum is not quite the sum.
    assert!((both[0].share - 0.8).abs() < 0.04 && (both[1].share - 0.2).abs() < 0.04, "{both:?}");
    // No line fits it, as the middle of the interval is worst.
    let hump = driven(&|point, _| 1.0 - point[1] * point[1]);
    assert!(hump.len() == 1 && hump[0].name == "x1" && hump[0].share > 0.9, "{hump:?}");
    let kinds = driven(&|_, signal| if signal == Signal::Worst { 2.0 } else { 1.0 });
    assert_eq!(kinds.len(), 1);
    assert!(kinds[0].name == "signal of gust" && kinds[0].share > 0.999, "{kinds:?}");
    assert!(driven(&|_, _| 0.5).is_empty());
    // A product of signs is driven by neither factor alone.
    let crossed = driven(&|point, _| 1.0 + (point[1] * (point[0] - 1.25)).signum());
    assert!(crossed.iter().all(|driver| driver.share < 0.03), "{crossed:?}");
}

#[test]
fn parts_in_any_order_are_the_whole() {
    let campaign = campaign();
    let rows = rows(&campaign, &|point, _| point.iter().sum::<f64>().abs());
    let whole = drawn(&campaign, &rows);
    let parts: Vec<_> = rows.chunks(700).map(|part| drawn(&campaign, part)).collect();
    let merged = parts.iter().rev().fold(Drawn::new(&campaign), |all, part| all.merge(part));
    assert_eq!(merged.tally, whole.tally);
    assert_eq!(merged.spreads[0].worst, whole.spreads[0].worst);
    assert_eq!(merged.spreads[0].measures(), whole.spreads[0].measures());
    assert_eq!(merged.drivers(0), whole.drivers(0));
}

#[test]
fn the_envelope_holds_its_runs_and_no_more() {
    let campaign = campaign();
    let mut trial = Trial::new(&campaign).expect("a trial");
    let envelope = Envelope::of(&campaign, &trial, 20);
    assert_eq!((envelope.draws, envelope.within.len()), (20, 3));
    // x0 is met at the start, within what a draw moves in a 64th of tau.
    let starts: Vec<_> = (0..20).map(|index| campaign.scenario(index).point).collect();
    for (place, within) in envelope.within.iter().take(2).enumerate() {
        let x0 = starts.iter().map(|point| point[1 + place]);
        let (least, greatest) = x0.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
        assert!(within[0].0 <= least && within[0].1 >= greatest, "x{}", place + 1);
    }
    let mut met = vec![0; envelope.at.len()];
    for index in 0..20 {
        let scenario = campaign.scenario(index);
        let tau = scenario.point[0];
        let visit = &mut |instant: verify::Instant| {
            let share = instant.t / tau;
            let half = 0.5 * (1.0 - campaign.until) / 64.0;
            let Some(part) = envelope.at.iter().position(|at| (share - at).abs() < half) else {
                return;
            };
            for (value, within) in instant.x.iter().chain(&instant.u).zip(&envelope.within) {
                // Other instants are other steps of the integration.
                let (low, high, slack) =
                    (within[part].0, within[part].1, 1e-6 * (1.0 + value.abs()));
                assert!((low - slack..=high + slack).contains(value), "{index}, {share}: {value}");
                met[part] += usize::from((value - low).min(high - value) < slack);
            }
        };
        trial.instants(&campaign.setting(&scenario), visit).expect("a whole run");
    }
    // Bounds are values of runs; between the instants that are looked at here too.
    assert!(met.iter().filter(|count| **count > 0).count() > envelope.at.len() / 4, "{met:?}");
}
