//! Compares the cost of one lost or wild reading in the check `loop` with runs of the emitted C. In each random design
//! every sample in turn has such a reading, as far from its prediction as the gate lets pass.

use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use ptc_codegen::check::examine::examine;
use ptc_codegen::check::sampled::{Cost, Gating};
use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

use super::{ABOVE, Random, support};

/// Runs the loop once without a reading that is wrong, and then with one in each sample, lost and wild to both sides of
/// each measurement. It prints x at the deadline and the largest difference of u, behind a letter and the sample.
const MAIN: &str = r#"
#include "moved.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double phi[N][N] = PHI, gamma_[N] = GAMMA, c[M][N] = C, x0[N] = X0, force = FORCE;
static const double noise[END][M] = NOISE;
static double base[END];

static int believed(const moved *self, uint32_t k, const double *y)
{
    moved copy = *self;
    double u;
    return moved_step(&copy, k, y, &u) != PTC_GATED;
}

/* The reading farthest from y to one side that is believed. */
static double farthest(const moved *self, uint32_t k, const double *y, int l, double side)
{
    double near = 0.0, far = 1.0, trial[M];
    memcpy(trial, y, sizeof trial);
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (near + far);
        trial[l] = y[l] + side * middle;
        if (believed(self, k, trial)) near = middle; else far = middle;
    }
    return y[l] + side * near;
}

static int run(char letter, int wrong, int sides)
{
    const moved_params params = { 0 };
    double x[N], late[DELAY + 1] = { 0 }, apart = 0.0;
    moved self;
    memcpy(x, x0, sizeof x);
    if (moved_init(&self, &params) != PTC_OK) return 2;
    for (int k = 0; k < END; k++) {
        double y[M], wild[M], u, next[N];
        for (int l = 0; l < M; l++) {
            y[l] = noise[k][l];
            for (int i = 0; i < N; i++) y[l] += c[l][i] * x[i];
        }
        memcpy(wild, y, sizeof wild);
        for (int l = 0; l < M && k == wrong; l++) {
            const double side = ((sides >> l) & 1) ? 1.0 : -1.0;
            wild[l] = letter == 'L' ? (double)NAN : farthest(&self, (uint32_t)k, y, l, side);
        }
        const ptc_status status = moved_step(&self, (uint32_t)k, wild, &u);
        if ((status == PTC_GATED) != (k == wrong && letter == 'L')) {
            printf("G%c %d %d %d\n", letter, wrong, k, (int)status);
            return 0;
        }
        if (status < 0 || status == PTC_SATURATED) return 3;
        if (letter == 'B') base[k] = u;
        apart = fmax(apart, fabs(u - base[k]));
        late[DELAY] = u;
        for (int i = 0; i < N; i++) {
            next[i] = gamma_[i] * (GAIN * late[0] + force);
            for (int j = 0; j < N; j++) next[i] += phi[i][j] * x[j];
        }
        memcpy(x, next, sizeof x);
        memmove(late, late + 1, DELAY * sizeof *late);
    }
    printf("%c %d %.17g", letter, wrong, apart);
    for (int i = 0; i < N; i++) printf(" %.17g", x[i]);
    printf("\n");
    return 0;
}

int main(void)
{
    if (run('B', -1, 0) != 0) return 1;
    for (int k = 1; k < END; k++) {
        if (run('L', k, 0) != 0) return 1;
        for (int sides = 0; sides < (1 << M); sides++) if (run('W', k, sides) != 0) return 1;
    }
    return 0;
}
"#;

/// A plant as it is sampled, and what moves it.
struct Plant {
    phi: Vec<Vec<f64>>,
    gamma: Vec<f64>,
    c: Vec<Vec<f64>>,
}

/// A random design: its keys, its plant and its end.
struct Design {
    text: String,
    plant: Plant,
    delay: usize,
    end: usize,
    x0: Vec<f64>,
    noise: f64,
    force: f64,
    /// Half of the interval of the input gain, in parts of it.
    gain: f64,
}

const PERIOD: f64 = 0.01;

/// The chain of integrators and a linear plant with two outputs.
fn plant(n: usize, is_linear: bool) -> (Plant, String) {
    let mut a = vec![vec![0.0; n]; n];
    (1..n).for_each(|i| a[i - 1][i] = 1.0);
    let mut b = vec![0.0; n];
    b[n - 1] = 1.0;
    let mut c = vec![vec![0.0; n]; 1];
    c[0][0] = 1.0;
    let mut text = format!("n = {n}\n");
    if is_linear {
        a[n - 1] = (0..n).map(|j| -1.5 - j as f64).collect();
        b[n - 1] = 2.0;
        if n == 3 {
            c.push(vec![0.0, 0.0, 1.0]);
        }
        text = format!("[plant]\nA = {a:?}\nB = {b:?}\nC = {c:?}\n");
    }
    // exp of ((A, B), (0, 0)) h by its series.
    let size = n + 1;
    let entry = |i: usize, j: usize| match (i < n, j < n) {
        (true, true) => a[i][j] * PERIOD,
        (true, false) => b[i] * PERIOD,
        _ => 0.0,
    };
    let unit = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
    let of = |f: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
        (0..size).map(|i| (0..size).map(|j| f(i, j)).collect()).collect()
    };
    let (mut sum, mut term) = (of(&unit), of(&unit));
    for count in 1..30 {
        let next = |i: usize, j: usize| {
            (0..size).map(|m| term[i][m] * entry(m, j)).sum::<f64>() / f64::from(count)
        };
        term = of(&next);
        sum = of(&|i, j| sum[i][j] + term[i][j]);
    }
    let phi = (0..n).map(|i| sum[i][..n].to_vec()).collect();
    let gamma = (0..n).map(|i| sum[i][n]).collect();
    (Plant { phi, gamma, c }, text)
}

impl Design {
    fn new(random: &mut Random, index: usize) -> Self {
        let pick =
            |random: &mut Random, least: f64, most: f64| least + (most - least) * random.next();
        let is_linear = index % 3 == 2;
        let (n, delay) = (1 + index % 3, usize::from(random.next() < 0.5));
        let (plant, of_plant) = plant(n, is_linear);
        let disturbed = random.next() < 0.5 || n == 1;
        let end = 45 + (random.next() * 20.0) as usize;
        let poles = |random: &mut Random, count: usize| {
            let all: Vec<_> = (0..count)
                .map(|j| format!("{:.1}", -3.2 - j as f64 - pick(random, 0.0, 0.7)))
                .collect();
            format!("[{}]", all.join(", "))
        };
        let noise = if random.next() < 0.5 { 1e-4 } else { 0.0 };
        let gain = if random.next() < 0.3 { 0.02 } else { 0.0 };
        let x0: Vec<_> =
            (0..n).map(|j| pick(random, 0.1, 1.0) * if j == 0 { 0.1 } else { 0.02 }).collect();
        let mut text = format!(
            "name = \"moved\"\nsample_time = {PERIOD}\nu_max = inf\ndelay = {delay}\nx0_max = {x0:?}\npoles = {}\nobserver_poles = {}\n\
             observer_samples = {}\nobserver_eps = {:.2}\neps = {:.2}\nerror = 10\nmeasured = \"x1\"\n",
            poles(random, n + delay),
            poles(random, n + usize::from(disturbed)),
            18 + (random.next() * 6.0) as usize,
            pick(random, 0.07, 0.15),
            pick(random, 0.05, 0.1),
        );
        if is_linear {
            text = text.replace("measured = \"x1\"\n", "");
        }
        if noise > 0.0 {
            writeln!(text, "noise = {noise}").expect("a string");
        }
        if gain > 0.0 {
            writeln!(text, "g_error = [{}, {}]", 1.0 - gain, 1.0 + gain).expect("a string");
        }
        if disturbed {
            text.push_str("disturbance = \"constant\"\n");
        }
        let mut force = 0.0;
        let mut behind = format!("[params]\ntau = {:.2}\n", PERIOD * end as f64);
        match is_linear {
            true => behind.push_str(&of_plant),
            false => {
                text.push_str(&of_plant);
                if disturbed {
                    behind.push_str("[plant]\nf = \"load\"\nload = [-0.1, 0.1]\n");
                    force = pick(random, -0.1, 0.1);
                }
            }
        }
        let side = |random: &mut Random| if random.next() < 0.5 { -1.0 } else { 1.0 };
        let x0 = x0.iter().map(|most| side(random) * most).collect();
        let gain = 1.0 + gain * pick(random, -1.0, 1.0);
        let text = format!("{text}GATE{behind}");
        Self { text, plant, delay, end, x0, noise, force, gain }
    }

    fn spec(&self, gate: &[f64]) -> Spec {
        let gate: Vec<_> = gate.iter().map(|most| format!("{most:e}")).collect();
        let gate = format!("innovation_max = [{}]\ncoast = 2\n", gate.join(", "));
        let text = self.text.replace("GATE", &gate);
        let entries = support::entries(&format!("{ABOVE}{text}"));
        ptc_codegen::plant::read_design(&entries)
            .unwrap_or_else(|found| panic!("{text}: {found:?}"))
            .0
    }

    /// Returns the output of the emitted C.
    fn run(&self, spec: &Spec, random: &mut Random, folder: &std::path::Path) -> String {
        for file in ptc_codegen::generate(spec, Language::C).expect("C") {
            fs::write(folder.join(file.name), file.text).expect("a file");
        }
        let braces = |text: String| text.replace('[', "{").replace(']', "}");
        let (n, m) = (self.plant.gamma.len(), self.plant.c.len());
        let side = |random: &mut Random| if random.next() < 0.5 { -self.noise } else { self.noise };
        let noise: Vec<Vec<f64>> =
            (0..self.end).map(|_| (0..m).map(|_| side(random)).collect()).collect();
        let mut defines = String::new();
        for (name, value) in [
            ("PHI", format!("{:?}", self.plant.phi)),
            ("GAMMA", format!("{:?}", self.plant.gamma)),
            ("X0", format!("{:?}", self.x0)),
            ("FORCE", format!("({:?})", self.force)),
            ("GAIN", format!("({:?})", self.gain)),
            ("NOISE", format!("{noise:?}")),
            ("DELAY", self.delay.to_string()),
            ("END", self.end.to_string()),
            ("N", n.to_string()),
            ("M", m.to_string()),
        ] {
            writeln!(defines, "#define {name} {}", braces(value)).expect("a string");
        }
        let main = MAIN.replace(
            "c[M][N] = C,",
            &format!("c[M][N] = {},", braces(format!("{:?}", self.plant.c))),
        );
        fs::write(folder.join("main.c"), defines + &main).expect("a file");
        let built = Command::new("cc")
            .args(["-std=c99", "-O1", "-ffp-contract=off", "main.c", "moved.c", "-lm", "-o", "run"])
            .current_dir(folder)
            .output()
            .expect("a C compiler");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        let ran = Command::new(folder.join("run")).output().expect("it runs");
        assert!(ran.status.success(), "{:?}: {}", ran.status, self.text);
        String::from_utf8(ran.stdout).expect("text")
    }
}

/// Compares the lines of a run with the costs of one kind; the largest part of a bound of x that was reached.
fn reached(printed: &str, letter: &str, cost: &Cost, totals: &[f64], design: &str) -> f64 {
    let numbers = |line: &str| -> Vec<f64> {
        line.split(' ').skip(2).map(|word| word.parse().expect("a number")).collect()
    };
    let base = numbers(printed.lines().next().expect("a line"));
    let mut most = 0.0_f64;
    for line in printed.lines().filter(|line| line.starts_with(letter)) {
        let found = numbers(line);
        assert!(found[0] <= cost.u * (1.0 + 1e-9), "u: {line}, {cost:?}: {design}");
        for (i, bound) in cost.x.iter().enumerate() {
            let apart = (found[i + 1] - base[i + 1]).abs();
            assert!(
                apart <= bound * (1.0 + 1e-6),
                "x{}: {apart}, {line}, {cost:?}: {design}",
                i + 1
            );
            assert!(found[i + 1].abs() <= totals[i] + bound, "x{}: {line}: {design}", i + 1);
            most = most.max(apart / bound);
        }
    }
    most
}

#[test]
fn gate_cost_bounds_are_tight() {
    let mut random = Random(11);
    let (mut lost, mut wild) = (Vec::new(), Vec::new());
    for index in 0..12 {
        let design = Design::new(&mut random, index);
        let open = vec![1e3; design.plant.c.len()];
        let found = |gate: &[f64]| -> (Spec, Gating, Vec<f64>) {
            let report = examine(&design.spec(gate));
            let worst =
                report.worst.unwrap_or_else(|| panic!("{:?}: {}", report.outcomes, design.text));
            let totals = worst.states.iter().map(|bound| bound.total()).collect();
            (report.spec, worst.gating.expect("a gate"), totals)
        };
        let good = found(&open).1.innovations;
        let factor = 4.0 + 4.0 * random.next();
        let gate: Vec<_> = good.iter().map(|most| factor * most).collect();
        let (spec, gating, totals) = found(&gate);
        let folder = support::folder(&format!("gate_costs_{index}"));
        let printed = design.run(&spec, &mut random, &folder);
        let (of_lost, of_wild) = (gating.lost.expect("coast"), gating.wild.expect("a gate"));
        let is_open =
            |cost: &Cost| cost.innovations.iter().zip(&gate).all(|(most, gate)| most <= gate);
        assert!(!printed.contains("GL"), "{}: {printed}", design.text);
        assert!(is_open(&of_lost), "{of_lost:?}, {gate:?}: {}", design.text);
        lost.push(reached(&printed, "L", &of_lost, &totals, &design.text));
        // Of two measurements a wild one may show in the other more than its gate lets pass.
        if is_open(&of_wild) {
            assert!(!printed.contains('G'), "{}: {printed}", design.text);
            wild.push(reached(&printed, "W", &of_wild, &totals, &design.text));
        }
    }
    println!("lost {lost:.2?}\nwild {wild:.2?}");
    assert!(wild.len() >= 8 && wild.iter().all(|part| *part > 0.6), "{wild:?}");
    assert!(lost.iter().any(|part| *part > 0.3), "{lost:?}");
}
