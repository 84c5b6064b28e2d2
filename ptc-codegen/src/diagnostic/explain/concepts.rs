//! The concepts of prescribed-time control, in five lines each: `explain` prints them, and docs/glossary.md
//! is made of them.

/// A concept.
#[derive(Clone, Copy, Debug)]
pub struct Concept {
    /// Its name.
    pub name: &'static str,
    /// Other words under which it is looked for.
    pub also: &'static [&'static str],
    /// Definition, relevance, and use.
    pub lines: [&'static str; 5],
    /// The page that says more, under docs/.
    pub page: &'static str,
}

/// All concepts, in the order of the alphabet.
pub static CONCEPTS: [Concept; 13] = [
    Concept {
        name: "class M",
        also: &["M", "class_m", "class", "mapping", "mu", "kappa"],
        lines: [
            "The functions mu(t) that a time mapping may be: mu(0) = 0, mu' > 0, and mu -> tau as t -> infinity.",
            "They are as often differentiable as the order n of the plant.",
            "mu maps the infinite time of an ordinary control law to the interval from t0 to t0 + tau.",
            "Its inverse kappa gives the stretched time of an instant, which is infinite at the deadline.",
            "All families (exp, rational, power, ...) are of class M; the check `membership` proves it for others.",
        ],
        page: "checks/membership.md",
    },
    Concept {
        name: "deadbeat",
        also: &[],
        lines: [
            "A law that brings a sampled plant of order n to rest in n samples, whatever its state.",
            "With clock = samples the law is deadbeat in its last n samples, so that the error at the deadline is 0.",
            "`deadbeat` has it take over earlier; by default the law ends by its own formula, or by one of least energy.",
            "It has the largest gains of the run: noise and unmodelled dynamics are amplified most there.",
            "With an `eps` above 0 the gains are held before that point, and the loop ends without deadbeat.",
        ],
        page: "samples.md",
    },
    Concept {
        name: "eps",
        also: &["observer_eps"],
        lines: [
            "The time-to-go, in s, at which the gains of the law are held.",
            "The exact law has gains that grow without bound towards the deadline; eps is where they stop.",
            "A small eps leaves a small error at the deadline, and amplifies noise, delay and quantisation more.",
            "A large eps is gentle on sensors and actuator, and leaves a larger error.",
            "Left open, it is computed from `error` or `sample_time`; the checks print the value and its limits.",
        ],
        page: "checks/deadline.md",
    },
    Concept {
        name: "hold",
        also: &["after", "held"],
        lines: [
            "From eps before the deadline on, the law keeps its gains, and `step` returns PTC_HOLD.",
            "A linear law then has constant gains, and with `after = hold` it goes on after the deadline.",
            "With `after = zero`, u is 0 from the deadline on; with `after = extern`, your own function gives u.",
            "Held gains still reject disturbances; a constant one leaves an offset, unless an observer cancels it.",
            "`arm` starts a new run, with the full law.",
        ],
        page: "time.md",
    },
    Concept {
        name: "margin",
        also: &["margins", "robustness"],
        lines: [
            "How far the plant may be from the design, one deviation at a time: input gain, delay, resonance.",
            "`check` prints for which of them the loop is stable with its final gains; `--margins` adds the bounds.",
            "A gain margin from 0.5 to 2 means that the true g may be half or twice the known one.",
            "A larger eps and slower poles give larger margins and a larger error at the deadline.",
            "Several deviations at once belong under [verify], which draws all of them together.",
        ],
        page: "guide/robust.md",
    },
    Concept {
        name: "observer",
        also: &["observer_poles", "observer_samples", "measured"],
        lines: [
            "It estimates the states that are not measured, and a constant force if `disturbance = constant`.",
            "Its error is 0 from sample `observer_samples` on: it has a deadline of its own, before that of the law.",
            "`observer_poles` are poles in stretched time, one for each state that is estimated.",
            "Faster poles settle earlier and amplify noise more.",
            "It needs clock = samples and the mapping exp with a fixed rate.",
        ],
        page: "samples.md",
    },
    Concept {
        name: "poles",
        also: &["pole", "gains"],
        lines: [
            "The poles of the closed loop in stretched time; they set the gains k_1..k_n of the law.",
            "A pole of -4 means the same at every tau: with exp(a=1) its mode is (T/tau)^4, a shape in t/tau alone.",
            "x and u go to 0 at the deadline if every pole is left of -n rho, with rho the decay rate of the mapping.",
            "Faster poles settle earlier within tau, and need more u at the start.",
            "For exp(a=1) and order n start with -(n+2), -(n+3), ...: `check` and `simulate` show the peak of u.",
        ],
        page: "checks/growth.md",
    },
    Concept {
        name: "rho",
        also: &["rate", "decay"],
        lines: [
            "The decay rate of mu' in stretched time: mu' falls like e^(-rho t).",
            "It is a for exp and tanh(a), and 0 for rational, power, tan and algebraic.",
            "The states of the plant are those of the stretched loop times powers of e^(rho t).",
            "So poles have to lie left of -n rho for u to go to 0, and left of -(n-1) rho for x.",
            "The check `growth` computes rho of any mapping and decides this exactly.",
        ],
        page: "checks/growth.md",
    },
    Concept {
        name: "stretched time",
        also: &["stretched", "t_kappa", "infinite time", "kappa_rate"],
        lines: [
            "A clock that runs from 0 to infinity while real time runs from t0 to the deadline t0 + tau.",
            "The mapping mu takes stretched time to real time, and kappa takes it back.",
            "In stretched time the loop is an ordinary linear system, with constant gains and poles.",
            "What settles at infinity there settles at the deadline here, from any initial state.",
            "In expressions it is `t_kappa`, and the `t` of mu and pi0.",
        ],
        page: "time.md",
    },
    Concept {
        name: "tau",
        also: &["deadline", "settling time"],
        lines: [
            "The prescribed settling time in s: the state is at its target at t0 + tau.",
            "It holds for every initial state, as long as u is not clipped for long.",
            "Half of tau takes about 2^n times the u of the same poles, at order n.",
            "With clock = samples it is a whole number of sample periods.",
            "Left out, it is a run-time parameter of the emitted code.",
        ],
        page: "time.md",
    },
    Concept {
        name: "time-to-go",
        also: &["T", "time to go", "time_to_go", "time"],
        lines: [
            "The time that is left until the deadline: T = tau - (t - t0).",
            "The gains of the law are powers of 1/T times polynomials, so they grow as T falls.",
            "Emitted code computes T with a compensated sum, so that it keeps its digits for any t0.",
            "T is held at eps, by one minimum.",
            "In bounds of objectives and in pi0 it is `T`.",
        ],
        page: "time.md",
    },
    Concept {
        name: "u_max",
        also: &["u_min", "saturation", "clipping", "limits"],
        lines: [
            "The bound of the input: the emitted code clips u to it and returns PTC_SATURATED.",
            "The deadline is guaranteed only if u is inside the bound; short saturation is recovered from.",
            "`loop` bounds u over the whole run, from all states within `x0_max`.",
            "Where u is too large: a longer tau, poles further right, or a smaller initial box.",
            "`inf` leaves the clipping out.",
        ],
        page: "guide/torque.md",
    },
    Concept {
        name: "xi",
        also: &["xi1", "infinite-time system", "associated", "pi0"],
        lines: [
            "The state xi_1..xi_n of the infinite-time system: the plant seen in stretched time.",
            "xi_1 is x_1, and xi_(i+1) is the derivative of xi_i by stretched time.",
            "The law pi0 is written in xi, for example -20*xi1 - 9*xi2, which are gains 20 and 9.",
            "The generator turns it into u(x, t) exactly: that is Theorem 1.",
            "`show law` prints the result, and `--what associated` emits the infinite-time system itself.",
        ],
        page: "expressions.md",
    },
];

/// Returns the concept of a name, in any case and with `_`, `-` or blanks.
pub fn concept(name: &str) -> Option<&'static Concept> {
    let plain = |text: &str| text.replace(['_', '-'], " ");
    let exact = |own: &&Concept| plain(own.name) == plain(name);
    let listed = |own: &&Concept| own.also.iter().any(|also| plain(also) == plain(name));
    let lower = |own: &&Concept| {
        let name = plain(name).to_lowercase();
        plain(own.name).to_lowercase() == name
            || own.also.iter().any(|also| plain(also).to_lowercase() == name)
    };
    let all = || CONCEPTS.iter();
    all().find(exact).or_else(|| all().find(listed)).or_else(|| all().find(lower))
}
