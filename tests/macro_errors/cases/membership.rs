mod too_far {
    ptc::ptc_controller!(n = 2, mu = 2 * tau * (1 - exp(-t)));
}
mod back {
    ptc::ptc_controller!(n = 2, kappa = ln(1 - dt / tau));
}
mod kink {
    ptc::ptc_controller!(n = 2, mu = tau * min(t / 2, t / (1 + t)));
}

fn main() {}
