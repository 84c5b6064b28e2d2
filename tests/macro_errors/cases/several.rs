// All mistakes at once, each at its token, in the order in which they stand.
ptc::ptc_controller!(
    n = 2,
    mu = power(m = 0, b = 1),
    precision = f16,
    eps = 0,
    t0 = [1, 2],
    tau = -1,
    u_max = inf,
    name = struct,
);

fn main() {}
