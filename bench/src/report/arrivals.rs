//! The section of deadlines in flight: times to rest, then costs.

use std::fmt::Write as _;

use super::tables::section;
use crate::moves::{Arrival, Cost, Measured};

const ABOUT: &str = "\
Time to rest from random states in parts of the least time that any input within the limits takes: bang-bang for n = 2,
limited u for n = 3, by Ruckig. Each cell with two numbers has the median and the worst. A chain is known exactly and all
its states are measured, 60 of them up to 1, |u| <= 10, 1 kHz. The stage is that of the section above, in 140 motions:
from rest at 20 random positions up to 0.2 m away, with the masses, the friction and the steps of the force above, the
steps at 0.5, 0.875 and 0.95 of the least time; this time is that of 1.5 kg without a force. The emitted program is in the
loop. It begins with a deadline of 30 samples, which is put off at once to the soonest one. `reserve` is the part of the
limits that plans leave. The follower is a profile of the shortest length within the same limits and the same reserve, by
Ruckig, with the observer and the feedback of `ptc-codegen compare`. Error is |x1| at the deadline that a controller keeps;
runs are clipped where the limit cuts u in a sample, and for the follower where u reaches it. \"Fixed to these times\" is
the same law with a deadline that stays, in each run the time of the row above it: the disturbances are in that time, which
nobody knows when the motion begins.

Without disturbances planning at every sample takes a few per cent more than the least time with a weight of 1, is never
clipped, and is exactly at rest. A follower of the least time has nothing left to correct with, and misses. On the stage the
time grows by the reserve and by what the disturbances take. The error at rest is then that of the force that the observer
has not found yet. It is largest where the force changes shortly before the deadline: one that is put off only as far as it
must be leaves fewer samples after the change than one that was fixed to the later time from the start.";

const COSTS: &str = "\
Instructions are means by callgrind, `gcc -O2`: of all steps from 60 random states to rest, and of `soonest` from 1,000.
Bytes are code and constants of all functions on a Cortex-M7 with `-Os`. A search takes some 20 tries, and each one tests the
sums of every limit: with a weight of 1 u has one power more, so that a try takes a third more at n = 3.";

pub(super) fn arrivals(text: &mut String, measured: &Measured) {
    section(text, "Deadlines in flight", "moves", ABOUT);
    let _ = writeln!(
        text,
        "\n| plant | controller | time over the least | error at rest, um | peak, parts of the limit | runs clipped |\n\
         | --- | --- | ---: | ---: | ---: | ---: |"
    );
    for own in &measured.arrivals {
        let Arrival { plant, name, runs, time, error, peak, clipped } = own;
        let [median, worst] = time;
        let errors = error.map(shown_error).join(", ");
        let _ = writeln!(
            text,
            "| {plant} | {name} | {median:.3}, {worst:.3} | {errors} | {peak:.3} | {clipped} of {runs} |"
        );
    }
    let _ = writeln!(
        text,
        "\n{COSTS}\n\n| n | weight | step, fixed deadline | step, `extend` | step, `pace = \"soonest\"` | `soonest` | `soonest`, us | bytes, fixed | bytes, `extend` |\n\
         | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
    );
    for Cost { n, weight, steps, soonest, time, code } in &measured.costs {
        let steps = steps.map(|own| format!("{own:.0}")).join(" | ");
        let code = code.map_or("- | -".to_owned(), |[fixed, extend]| format!("{fixed} | {extend}"));
        let us = 1e6 * time;
        let _ = writeln!(text, "| {n} | {weight} | {steps} | {soonest:.0} | {us:.2} | {code} |");
    }
    let _ = writeln!(
        text,
        "\nRuckig plans a profile of order 3 in {:.2} us on the same machine, by [rsruckig](https://docs.rs/rsruckig).",
        1e6 * measured.plan
    );
}

/// An error in um; below a nanometre it is that of rounding.
fn shown_error(error: f64) -> String {
    match 1e6 * error {
        um if um < 1e-3 => format!("{um:.0e}"),
        um => format!("{um:.1}"),
    }
}
