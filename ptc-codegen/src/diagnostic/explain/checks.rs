//! The checks of a design.

use super::Explanation;

pub(super) static CHECKS: [Explanation; 7] = [
    Explanation {
        code: "membership",
        means: "The mapping is not of its class. mu has to be 0 at 0, increasing, smooth, and tend to tau; kappa is its inverse. Otherwise there is no law.",
        design: "",
        example: "ptc-codegen check --n 2 --mu \"tau*(1 - 2*exp(-t) + exp(-2*t))\"",
        fix: "take a family, or change the expression at the point that the message names; a time-base generator needs kappa'(0) > 0",
    },
    Explanation {
        code: "growth",
        means: "The poles are too slow for the mapping. The gains grow faster towards the deadline than the state falls: x does not go to 0, or u is unbounded.",
        design: "",
        example: "ptc-codegen check --n 3 --mu \"exp(a=2)\" --poles=-4,-5,-6",
        fix: "move every pole left of -n rho, with rho the decay rate of mu', or take a slower mapping; with rho = 0 (rational, power, tan, algebraic) any stable poles suffice",
    },
    Explanation {
        code: "sampling",
        means: "The sample period is too long for the held gains. The sampled loop is unstable once the gains are held at eps.",
        design: "",
        example: "ptc-codegen check --n 2 --mu \"exp(a=1)\" --gains 12,7 --tau 0.8 --eps 1e-3 --sample-time 1e-3",
        fix: "leave eps out, so that it follows from the sample period, or take a shorter period; with `clock = samples` there is no limit",
    },
    Explanation {
        code: "deadline",
        means: "The state at the deadline is above `error`. The gains are held from eps on, and the remaining state is too large.",
        design: "",
        example: "ptc-codegen check --n 2 --mu \"exp(a=1)\" --gains 12,7 --tau 0.8 --x0-max 0.3,1 --error 1e-3 --eps 0.1",
        fix: "leave eps out, so that it follows from `error`, take a smaller one, or faster poles",
    },
    Explanation {
        code: "loop",
        means: "The worst case of the loop that runs is above `error`. It includes sampling, noise, resolution of sensors and actuator, delay, jitter and rounding, each at its worst.",
        design: "",
        example: "ptc-codegen check --n 3 --mu \"exp(a=1)\" --gains 120,74,15 --tau 1 --x0-max 1,1,1 --error 0.15 --sample-time 1e-3 --noise 1e-4 --eps 6.43e-3",
        fix: "leave eps out, so that the best one is found; otherwise take better sensors, a shorter period, or a larger `error`; the lines of the check say what contributes most",
    },
    Explanation {
        code: "envelope",
        means: "A number of the controller may overflow. There are states within `x_max` and times at which an intermediate result is outside the range of the precision.",
        design: "",
        example: "ptc-codegen check --n 2 --mu \"exp(a=1)\" --gains 1200,70 --tau 0.8 --eps 1e-18 --x-max 1,5 --precision f32",
        fix: "take a larger eps, f64, other units, or give u_max",
    },
    Explanation {
        code: "zeros",
        means: "The zero dynamics are unstable. With the output of the model at rest, the other states leave the origin.",
        design: "name = \"cart\"\nmu = \"exp(a=1)\"\npoles = [-3]\n\n[model]\nstates = [\"v\", \"z\"]\ninput = \"F\"\noutput = \"v\"\ndynamics = { v = \"F\", z = \"z + v\" }\n",
        example: "ptc-codegen check design.toml",
        fix: "take an output with stable zero dynamics, or one that contains more of the states; `allow = \"zeros\"` where another loop stabilises them",
    },
];
