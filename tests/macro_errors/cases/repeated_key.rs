ptc::ptc_controller!(n = 1, mu = exp, tau = 1, tau = 2);

fn main() {}
