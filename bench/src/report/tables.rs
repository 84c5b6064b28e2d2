//! The tables of the page, each under the command that measures it.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::accuracy::Accuracy;
use crate::builds::Builds;
use crate::campaigns::Campaign;
use crate::case::{ORDERS, VARIANTS};
use crate::counts::Count;
use crate::fused::Fused;
use crate::generator::Speed;
use crate::latency::{self, Latency, Step};

/// A heading with the command that measures what follows.
pub(super) fn section(text: &mut String, title: &str, command: &str, about: &str) {
    let command = format!("cargo run --release -p ptc-bench -- {command}");
    let _ = write!(text, "\n## {title}\n\n    {command}\n\n{about}\n");
}

/// A table with one row for each name and one column for each order.
fn by_order(
    text: &mut String,
    rows: &[&str],
    orders: &[usize],
    cell: impl Fn(&str, usize) -> Option<String>,
) {
    let heads: Vec<_> = orders.iter().map(|n| format!("n = {n}")).collect();
    let _ = writeln!(text, "| | {} |", heads.join(" | "));
    let _ = writeln!(text, "| --- |{}", " ---: |".repeat(orders.len()));
    for row in rows {
        let cells: Vec<_> = orders.iter().map(|n| cell(row, *n).unwrap_or_default()).collect();
        let _ = writeln!(text, "| {row} | {} |", cells.join(" | "));
    }
}

const COUNTS: &str = "\
Instructions per call by callgrind, the mathematical library included: the mean over 64 calls with
time-to-go spread evenly from tau to 0.03 tau. Every parameter is set at run time, except
`power_m2`, which is power with m = 2 fixed; `exp_sum` has two rates. C is compiled by
`gcc -std=c99 -O2`, Rust by `rustc -C opt-level=3`; in Rust each function is inlined into a wrapper
that is not, so what a call costs is in the count, as it is in C. Guard `none` leaves out u_max;
`result` and `full` take it at run time. `tick` and `axis` are `step` in two: time once, then each
axis; `axis` costs the same for every family.

For exp without a guard C takes 4n + 11 instructions up to n = 4 and 4n + 12 from there on: two for
each state (a multiplication and an addition, both with an operand in memory), two for each power of
1/T (a multiplication, an addition of the next row), and the rest for time-to-go, the minimum, the
division and the status. From n = 5 on gcc 12 builds the status in another register than the one that
returns it, which is the one move more; no spelling of the C that was tried takes it away.

Rust takes a few instructions more than C without a guard: its result goes through memory, with the
address given back, and rustc pairs multiplications in vectors, which takes moves. Where that
matters, `-C no-vectorize-slp` leaves the pairing out.

Guard `full`, the default, costs some 20 instructions at any order: four tests, of the start, of u
and of the hold, and three of pointers in C. The calls that are counted track within u_max.

From n = 9 on the gains of exp_sum, which come from the Taylor series of mu, are computed by loops over
the powers of the series, in which sums of up to 8 products are written out, so that the code grows with
n and not with n^3.";

pub(super) fn counts(text: &mut String, counts: &[Count]) {
    section(text, "Instructions, code and stack", "counts", COUNTS);
    let find = |language: &str, guard: &str, precision: &str, variant: &str, n: usize| {
        counts.iter().find(|count| {
            let key = &count.key;
            (key.language.as_str(), key.guard.as_str(), key.precision.as_str())
                == (language, guard, precision)
                && key.variant == variant
                && key.n == n
        })
    };
    let variants: Vec<_> = VARIANTS.iter().map(|variant| variant.name).collect();
    let rounded = |value: f64| format!("{value:.0}");
    for (language, title) in [("c", "C"), ("rust", "Rust")] {
        for precision in ["f64", "f32"] {
            for guard in ["none", "result", "full"] {
                let _ = writeln!(text, "\n### {title}, {precision}: `step`, guard `{guard}`\n");
                by_order(text, &variants, &ORDERS, |variant, n| {
                    find(language, guard, precision, variant, n).map(|count| rounded(count.step))
                });
            }
            let _ = writeln!(text, "\n### {title}, {precision}: `tick`, guard `none`\n");
            by_order(text, &variants, &ORDERS, |variant, n| {
                find(language, "none", precision, variant, n).map(|count| rounded(count.tick))
            });
            let _ = writeln!(text, "\n### {title}, {precision}: `axis`, by guard\n");
            by_order(text, &["none", "result", "full"], &ORDERS, |guard, n| {
                find(language, guard, precision, "exp", n).map(|count| rounded(count.axis))
            });
            let bytes = if language == "c" { "code and stack" } else { "code" };
            let _ = writeln!(
                text,
                "\n### {title}, {precision}: bytes of {bytes} of `step`, guard `none`\n"
            );
            by_order(text, &variants, &ORDERS, |variant, n| {
                let count = find(language, "none", precision, variant, n)?;
                Some(match count.stack {
                    Some(stack) => format!("{} + {stack}", count.text),
                    None => count.text.to_string(),
                })
            });
        }
    }
    text.push_str("\nStable Rust has no report of stack sizes.\n");
}

const FUSED: &str = "\
`fma = true`, in C and f64, guard `none`, counted as above. In each cell: the plain controller, the
fused one, both compiled by `gcc -std=c99 -O2 -mfma`, and what the second is of the first.

What is fused are the polynomials of the gains and the sum over the states, so it pays with the
order: a fifth and more from n = 6 on, a third and more at n = 12, except for three families. exp has
no polynomials, power calls `pow`, and exp_sum iterates. At
n = 1 there is next to nothing to fuse, apart from the series of tan.";

const CALLED: &str = "\
Compiled without `-mfma` each `fma` of the fused one is a call of the library, two to three times the
instructions in all. It is that of glibc, which takes the instruction where the processor has it; a
library that computes `fma` in software takes far longer. There `fma` is a loss:";

pub(super) fn fused(text: &mut String, found: &[Fused]) {
    section(text, "Fused multiply-adds", "fma", FUSED);
    let of = |variant: &str, n: usize| {
        found.iter().find(|one| one.key.variant == variant && one.key.n == n)
    };
    let variants: Vec<_> = VARIANTS.iter().map(|variant| variant.name).collect();
    text.push('\n');
    by_order(text, &variants, &ORDERS, |variant, n| {
        let Fused { plain, fused, .. } = of(variant, n)?;
        Some(format!("{plain:.0}, {fused:.0}: {:.0} %", 100.0 * fused / plain))
    });
    let _ = writeln!(text, "\n{CALLED}\n");
    by_order(text, &variants, &ORDERS, |variant, n| {
        of(variant, n).map(|one| format!("{:.0}", one.called))
    });
}

const LATENCY: &str = "\
`latency = true`, in C and f64, guard `none`. In each cell: instructions, and after them nanoseconds
from t to u, where each call is given a time that waits for the u before it; the quickest of 21
rounds, in which the contestants take turns. `hand` is order 3 written by hand as in the table of
other generators, with every parameter at each call, no status and no eps: with u by a pointer as
ours, and returned, which waits for no memory.

Not ahead: u of exp at n = 3 takes a little longer than by hand where that returns u.";

pub(super) fn latency(text: &mut String, found: &[Latency]) {
    section(text, "Latency", "latency", LATENCY);
    let shown = |step: Step| format!("{:.0}, {:.1}", step.instructions, step.time);
    let of = |row: &str, n: usize| {
        let (family, form) = row.split_once(' ').unwrap_or((row, "plain"));
        let one = found.iter().find(|one| one.family == family && one.n == n)?;
        match form {
            "trees" => Some(shown(one.trees)),
            "hand" => one.hand.map(|[given, _]| shown(given)),
            "hand, returned" => one.hand.map(|[_, returned]| shown(returned)),
            _ => Some(shown(one.plain)),
        }
    };
    let families: BTreeSet<_> = found.iter().map(|one| one.family.as_str()).collect();
    let forms = ["", " trees", " hand", " hand, returned"];
    let forms = |family: &&str| forms.map(|form| format!("{family}{form}"));
    let rows: Vec<_> = families.iter().flat_map(forms).collect();
    let rows: Vec<_> = rows.iter().map(String::as_str).collect();
    text.push('\n');
    by_order(text, &rows, &latency::ORDERS, of);
}

const ACCURACY: &str = "\
The worst scaled error |u - reference| / scale of generated C against the vectors of
[tests/data](../../tests/data/README.md), which were computed with 160 digits and more: time-to-go from
T = tau down to T/tau = 1e-12 in double precision and 1e-6 in single, start times up to 1e4. In
brackets T/tau at the worst point.";

pub(super) fn accuracy(text: &mut String, accuracy: &[Accuracy]) {
    section(text, "Accuracy", "accuracy", ACCURACY);
    for precision in ["f64", "f32"] {
        let of_it: Vec<_> = accuracy.iter().filter(|one| one.precision == precision).collect();
        let points: usize = of_it.iter().map(|one| one.points).sum();
        let _ = writeln!(text, "\n### {precision}: {points} points\n");
        let mut families: Vec<_> = of_it.iter().map(|one| one.family.as_str()).collect();
        families.dedup();
        let orders: BTreeSet<_> = of_it.iter().map(|one| one.n).collect();
        by_order(text, &families, &Vec::from_iter(orders), |family, n| {
            let one = of_it.iter().find(|one| one.family == family && one.n == n)?;
            Some(match one.worst {
                Some(worst) => format!("{worst:.1e} ({:.0e})", one.at),
                None => format!("not finite ({:.0e})", one.at),
            })
        });
    }
}

const GENERATOR: &str = "\
Whole processes from the command line to the written files, and the expansion of all partial Bell
polynomials in free symbols. Times are the best of 20.";

pub(super) fn generator(text: &mut String, speeds: &[Speed]) {
    section(text, "Generating", "generator", GENERATOR);
    text.push_str("\n| | million instructions | ms |\n| --- | ---: | ---: |\n");
    for Speed { what, instructions, milliseconds } in speeds {
        let millions = *instructions as f64 / 1e6;
        let _ = writeln!(text, "| `{what}` | {millions:.1} | {milliseconds:.1} |");
    }
}

const CAMPAIGNS: &str = "\
`ptc-codegen verify DESIGN --scenarios 524288` less the same with 64 scenarios, whose rest (corners, search, proofs) it is; half as many,
and again, down to 512, where they take more than 4 s.
A scenario is run on both sides of Theorem 1 and looked at at 80 instants and more, to a relative error of 1e-9: two
trajectories. The designs are [examples/campaign.toml](../../examples/campaign.toml) and the same with what is named.
Instructions by callgrind, 64 to 256 scenarios on one thread, with the vectors of AVX2; processor time the least of 3
rounds; pace by the clock. What is not smooth in the state, or comes near its bound u_max, is run one scenario at a time.
The last three designs are without damping and slip: the loop is linear in stretched time, then it is sampled (one
trajectory, tau = 1, h = 0.01), then its gust is any signal, a sine too.
`campaigns --only TEXT` prints the rows whose name holds TEXT.";

pub(super) fn campaigns(text: &mut String, campaigns: &[Campaign]) {
    section(text, "Campaigns", "campaigns", CAMPAIGNS);
    text.push_str(
        "\n| design | thousand instructions a scenario | processor ms a scenario | scenarios a second, 1 thread | 2 threads | MB |\n\
         | --- | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for Campaign { what, instructions, milliseconds, pace: [one, two], memory } in campaigns {
        let thousands = instructions / 1e3;
        let _ = writeln!(
            text,
            "| {what} | {thousands:.0} | {milliseconds:.3} | {one:.0} | {two:.0} | {memory:.0} |"
        );
    }
}

const BUILDS: &str = "\
Processor seconds, user and system, with all dependencies: from nothing, or after a change of a crate
with controllers of order 2 to 5 (the least of 5). From nothing they vary by a fifth from run to run.";

pub(super) fn builds(text: &mut String, builds: Builds) {
    section(text, "Builds", "generator --builds", BUILDS);
    text.push_str("\n| build | processor s |\n| --- | ---: |\n");
    let Builds { command, lab, tests, user, by_path, none, one, twenty } = builds;
    for (what, seconds) in [
        ("`cargo build -p ptc-codegen`, from nothing", command),
        ("`cargo build --release -p ptc-codegen --features lab`, from nothing", lab),
        ("`cargo test --workspace`, from nothing, tests run", tests),
        ("a crate with one controller, `ptc` from git, `cargo build`, from nothing", user),
        ("the same with `ptc` by the path of a checkout", by_path),
        ("after a change, no controller", none),
        ("after a change, one controller", one),
        ("after a change, twenty controllers", twenty),
    ] {
        let _ = writeln!(text, "| {what} | {seconds:.1} |");
    }
}

/// Adds the output of `bench/new-user.sh`.
pub(super) fn new_user(text: &mut String, table: &str) {
    let _ = write!(text, "\n## A new user\n\n    bench/new-user.sh\n\n{NEW_USER}\n\n{table}");
}

const NEW_USER: &str = "\
A fresh Debian 12 with Python and what the README says one needs, a clone, then the first `emit`, `simulate` and `verify`
of the README, a plant of their own, a crate with the macro, and Python. Crates are downloaded; Debian's packages and the
Rust toolchain are there at the start and not counted.
Minutes are wall time, here beside other builds on the same two cores: processor seconds are what to compare.";
