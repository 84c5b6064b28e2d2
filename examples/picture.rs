//! The picture of the README: `cargo run -q --example picture > docs/picture.svg`.
//!
//! A triple integrator x''' = u starts at x = 1 and is brought to rest by the emitted controller
//! (family `exp`, n = 3) 1, 2 and 5 s later. The control is sampled at 1 kHz with a zero-order
//! hold, for which the motion in between is a polynomial: no solver, and no function of a platform's
//! library, is between the controller and the curves.

use std::fmt::Write;

use ptc::Error;

// (s + 4)(s + 5)(s + 6): the slowest pole is left of -n a = -3, so u vanishes at the deadline.
ptc::ptc_controller!(n = 3, mu = exp(a = 1), gains = [120, 74, 15], t0 = 0, u_max = inf);

const PERIOD: f64 = 1e-3;
const EPS: f64 = 1e-2;
const END: f64 = 5.5;

/// One run of the picture: its settling time, the class of its curves, and t, x1, x2, x3, u.
struct Run {
    tau: f64,
    class: &'static str,
    samples: Vec<[f64; 5]>,
}

/// One of the four diagrams: its title, the quantity it shows, the ticks, and the map to 0..1.
struct Panel {
    title: &'static str,
    column: usize,
    ticks: &'static [f64],
    height: fn(f64) -> f64,
}

// u spans three decades, so its axis is stretched around 0.
const PANELS: [Panel; 4] = [
    Panel { title: "x1 [m]", column: 1, ticks: &[0.0, 0.5, 1.0], height: |x| (x + 0.2) / 1.4 },
    Panel { title: "x2 [m/s]", column: 2, ticks: &[-2.0, -1.0, 0.0], height: |x| (x + 2.5) / 3.0 },
    Panel {
        title: "x3 [m/s²]",
        column: 3,
        ticks: &[-8.0, 0.0, 8.0],
        height: |x| (x + 11.0) / 22.0,
    },
    Panel {
        title: "u [m/s³], axis stretched near 0",
        column: 4,
        ticks: &[-100.0, -10.0, 0.0, 10.0, 100.0],
        height: |u| 0.5 + 0.5 * symmetric(u) / symmetric(200.0),
    },
];

/// A map that is linear near 0 and a fourth root far from it: square roots are rounded alike on
/// every platform, logarithms are not.
fn symmetric(u: f64) -> f64 {
    let root = (1.0 + u.abs()).sqrt().sqrt();
    u.signum() * (root - 1.0)
}

fn main() -> Result<(), Error> {
    print!("{}", draw(&[run(1.0, "a")?, run(2.0, "b")?, run(5.0, "c")?]));
    Ok(())
}

/// The closed loop from x = (1, 0, 0).
fn run(tau: f64, class: &'static str) -> Result<Run, Error> {
    let controller = PtcExp3::new(PtcExp3Params { tau, eps: EPS })?;
    let mut x = [1.0, 0.0, 0.0];
    let mut samples = Vec::new();
    for tick in 0..=(END / PERIOD) as u32 {
        let t = f64::from(tick) * PERIOD;
        let u = controller.step(t, &x)?.u;
        samples.push([t, x[0], x[1], x[2], u]);
        let h = PERIOD;
        x = [
            x[0] + h * (x[1] + h / 2.0 * (x[2] + h / 3.0 * u)),
            x[1] + h * (x[2] + h / 2.0 * u),
            x[2] + h * u,
        ];
    }
    Ok(Run { tau, class, samples })
}

const WIDTH: f64 = 340.0;
const HEIGHT: f64 = 180.0;

const HEAD: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 820 520" font-family="sans-serif" font-size="13">
<title>A triple integrator is brought to rest 1, 2 and 5 s after the start</title>
<style>
.page { fill: #ffffff } text { fill: #222222 } .frame { fill: none; stroke: #777777 } .grid { stroke: #dddddd }
.line { fill: none; stroke-width: 2 } .a { stroke: #1b5fa8 } .b { stroke: #c2500a; stroke-dasharray: 9 4 } .c { stroke: #1d7a3a; stroke-dasharray: 2 3 }
.deadline { stroke-width: 1; stroke-dasharray: none; opacity: .6 }
@media (prefers-color-scheme: dark) {
.page { fill: #161b22 } text { fill: #e6edf3 } .frame { stroke: #8b949e } .grid { stroke: #30363d }
.a { stroke: #6cb6ff } .b { stroke: #f0883e } .c { stroke: #57c97a }
}
</style>
<rect class="page" width="820" height="520" rx="8"/>
"##;

fn draw(runs: &[Run]) -> String {
    let mut out = HEAD.to_owned();
    for (index, run) in runs.iter().enumerate() {
        let (x, class) = (60.0 + 250.0 * index as f64, run.class);
        let _ = writeln!(
            out,
            "<path class=\"line {class}\" d=\"M{x} 26h46\"/><text x=\"{}\" y=\"30\">at rest at t = {} s</text>",
            x + 54.0,
            run.tau
        );
    }
    for (index, panel) in PANELS.iter().enumerate() {
        let left = 60.0 + 400.0 * (index % 2) as f64;
        let top = 66.0 + 240.0 * (index / 2) as f64;
        draw_panel(&mut out, panel, runs, left, top);
    }
    out.push_str("</svg>\n");
    out
}

fn draw_panel(out: &mut String, panel: &Panel, runs: &[Run], left: f64, top: f64) {
    let across = |t: f64| left + WIDTH * t / END;
    let down = |value: f64| top + HEIGHT * (1.0 - (panel.height)(value));
    let (right, bottom) = (left + WIDTH, top + HEIGHT);
    let _ = writeln!(out, "<text x=\"{left}\" y=\"{}\">{}</text>", top - 8.0, panel.title);
    for tick in panel.ticks {
        let y = down(*tick);
        let _ = writeln!(
            out,
            "<path class=\"grid\" d=\"M{left} {y:.1}H{right}\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            left - 6.0,
            y + 4.5,
            tick.to_string().replace('-', "−")
        );
    }
    for t in 0..=5 {
        let x = across(f64::from(t));
        let _ = writeln!(
            out,
            "<text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{t}{}</text>",
            bottom + 17.0,
            if t == 5 { " s" } else { "" }
        );
    }
    for run in runs {
        let class = run.class;
        let x = across(run.tau);
        let _ = writeln!(out, "<path class=\"{class} deadline\" d=\"M{x:.1} {top}V{bottom}\"/>");
        let _ = write!(out, "<path class=\"line {class}\" d=\"");
        for (index, sample) in run.samples.iter().step_by(20).enumerate() {
            let sign = if index == 0 { 'M' } else { 'L' };
            let _ = write!(out, "{sign}{:.1} {:.1}", across(sample[0]), down(sample[panel.column]));
        }
        out.push_str("\"/>\n");
    }
    let _ = writeln!(
        out,
        "<rect class=\"frame\" x=\"{left}\" y=\"{top}\" width=\"{WIDTH}\" height=\"{HEIGHT}\"/>"
    );
}

/// The picture in the repository is the one that the controller draws.
#[cfg(test)]
#[test]
fn the_picture_is_up_to_date() -> Result<(), Error> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/picture.svg");
    let there = std::fs::read_to_string(path).unwrap_or_default();
    let drawn = draw(&[run(1.0, "a")?, run(2.0, "b")?, run(5.0, "c")?]);
    let command = "cargo run -q --example picture > docs/picture.svg";
    assert!(there == drawn, "{path} is not what is drawn; write it by `{command}`");
    Ok(())
}
