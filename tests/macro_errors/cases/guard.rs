ptc::ptc_controller!(
    n = 2,
    mu = exp(a = 1),
    gains = [20, 9],
    tau = 1,
    sample_time = 1e-3,
    eps = 1e-3
);

fn main() {}
