// The controller's name is known, so that nothing is said of its use elsewhere.
mod roll {
    ptc::ptc_controller!(n = 1, mu = exp, name = roll_axis, tau = -2.0);
}
use roll::*;

struct Loop {
    controller: RollAxis,
}

fn main() {
    let params = RollAxisParams { t0: 0.0, ..Default::default() };
    let _ = RollAxis::new(params).map(|controller| Loop { controller });
}
