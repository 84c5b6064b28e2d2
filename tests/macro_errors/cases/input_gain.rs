mod zero {
    ptc::ptc_controller!(n = 2, mu = exp, g = 0);
}
mod zero_in_disguise {
    ptc::ptc_controller!(n = 2, mu = exp, g = x1 - x1);
}
mod infinite {
    ptc::ptc_controller!(n = 2, mu = exp, g = 1 / 0);
}
mod of_xi {
    ptc::ptc_controller!(n = 2, mu = exp, g = 1 + xi1 ^ 2);
}

fn main() {}
