ptc::ptc_controller!(n = 2, mu = tau * (1 - exp(-abs(x1_0) * t)));

fn main() {}
