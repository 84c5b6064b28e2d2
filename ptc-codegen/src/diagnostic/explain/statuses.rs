//! The statuses of the emitted controllers.

use super::Explanation;

pub(super) static STATUSES: [Explanation; 11] = [
    Explanation {
        code: "PTC_OK",
        means: "The law is active. u is that of the law, within its limits.",
        design: "",
        example: "a step between t0 and t0 + tau - eps",
        fix: "nothing is wrong",
    },
    Explanation {
        code: "PTC_HOLD",
        means: "The time-to-go is held at eps. The deadline is near or over, and u is that of the law with the last gains.",
        design: "",
        example: "a step from t0 + tau - eps on, and every step after the deadline with `after = hold`",
        fix: "nothing is wrong; `arm` starts a new run",
    },
    Explanation {
        code: "PTC_SATURATED",
        means: "The law requires more than u_max, or less than u_min, which is -u_max where it is not given. u is clipped to the limit; this wins over PTC_HOLD and PTC_AFTER.",
        design: "",
        example: "a large initial state, or one that a disturbance moved away shortly before the deadline",
        fix: "prolonged saturation voids the deadline: take a longer tau, slower poles, a larger eps or a stronger actuator; `simulate` shows how long it lasts",
    },
    Explanation {
        code: "PTC_AFTER",
        means: "The deadline is over. u is 0 with `after = zero`, and that of your function with `after = extern`.",
        design: "",
        example: "a step at t0 + tau or later of a controller with `after = zero`",
        fix: "nothing is wrong; `arm` starts a new run",
    },
    Explanation {
        code: "PTC_GATED",
        means: "A reading was lost, or further from its prediction than `innovation_max`. The observer predicted alone, and u is that of the law with the prediction, within its limits; this wins over every other status of a valid u.",
        design: "",
        example: "one wild count of an encoder with `innovation_max = 1e-3` and `coast = 5`",
        fix: "one is nothing to worry about: `check` bounds its cost; after `coast` of them in a row PTC_E_INPUT follows, and the sensor, the plant or `innovation_max` is wrong",
    },
    Explanation {
        code: "PTC_LATE",
        means: "A limit would have been exceeded before the deadline, so this step put the deadline off to the soonest one that keeps the limits. u is that of the law for it; `deadline` gives its tick.",
        design: "",
        example: "a step with `late = extend` of a stage that something held, or a deadline that was too soon from the start",
        fix: "nothing is wrong, unless the time matters: then give more time, or a larger u_max",
    },
    Explanation {
        code: "PTC_INFEASIBLE",
        means: "The state is outside the set from which a filter keeps every bound, or a limit of u or a bound that goes first takes precedence over one of them. u is the nearest to the bounds that is left: those of x1 go before those of x2 and so on, the limits of u before all. Of a law with `late = extend`: no deadline was found that keeps u and the states within their limits; the deadline stays, and u is valid.",
        design: "",
        example: "a start of `what = filter` that moves to its stop too fast, or a u_max too small to brake before it",
        fix: "one that passes is a start outside, from which the filter returns; where it lasts, give bounds of the speed or slower `keep_poles`, for which `check` proves the limits of u enough. Of a law: give larger limits, or a shorter move",
    },
    Explanation {
        code: "PTC_E_PARAM",
        means: "A parameter is outside its domain. Or a coefficient that follows from the parameters overflows. `init`, `arm` or `arm_for` changed nothing.",
        design: "",
        example: "eps >= tau, a tau that is not > 0, or a field of the C params that was not set and is 0",
        fix: "the comments of the params in the header give the domains; set every field",
    },
    Explanation {
        code: "PTC_E_INPUT",
        means: "An argument is not finite, t is before t0, or a pointer is NULL. u is 0 and nothing has changed.",
        design: "",
        example: "a sensor that returns NaN, or a clock that went back",
        fix: "switch the actuator to its safe state, and find what the sensor or the clock returned; `arm` sets a new t0",
    },
    Explanation {
        code: "PTC_E_RANGE",
        means: "u, or a number on the way to it, is not finite, whatever the limits of u. u is 0 and nothing has changed.",
        design: "",
        example: "a state of 1e300 at large gains, or g(x, t) = 0",
        fix: "keep the state within what the sensors can measure, and where g is not 0; `check` with `x_max` finds an overflow before the first run",
    },
    Explanation {
        code: "PTC_E_SOON",
        means: "With `arm_for` and `late = refuse`: within so few samples a limit could be exceeded, so nothing has changed. With `soonest`: no number of samples was found with which the limits are kept.",
        design: "",
        example: "`arm_for` with 10 samples where `soonest` gives 400, or a state beyond its `state_max`",
        fix: "take the samples that `soonest` gives; where it gives none, the force to be overcome or a state is beyond its limit",
    },
];
