// Each entry is read for itself: one mistake does not hide the next.
ptc::ptc_controller!(
    n: 3,
    mu = exp(a = ),
    "tau" = 1,
    eps = 1e-3 u_max = 5,
    t0 = 1 % 2,
    gains = 6, 11,
    u_max,
    ,
    guard = {none},
    precision = "f32",
    name = r#type,
    tau = 0x10,
);

fn main() {}
