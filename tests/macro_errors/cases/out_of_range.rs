ptc::ptc_controller!(n = 1, mu = exp(a = 1e-60), precision = f32, tau = 1e40);
ptc::ptc_controller!(n = 1, mu = exp, u_max = 1e999, name = other);

fn main() {}
