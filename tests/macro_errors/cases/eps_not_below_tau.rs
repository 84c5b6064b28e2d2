ptc::ptc_controller!(n = 1, mu = exp, tau = 1e-3, eps = 2e-3);

fn main() {}
