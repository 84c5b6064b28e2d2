mod count {
    ptc::ptc_controller!(n = 3, mu = exp, gains = [6, 11]);
}
mod item {
    ptc::ptc_controller!(n = 3, mu = exp, gains = [6, inf, six]);
}

fn main() {}
