mod unknown {
    ptc::ptc_controller!(n = 1, mu = exp(rate = 1));
}
mod of_another {
    ptc::ptc_controller!(n = 1, mu = rational(a = 1, m = 2));
}
mod nameless {
    ptc::ptc_controller!(n = 1, mu = exp(1));
}
mod twice {
    ptc::ptc_controller!(n = 1, mu = exp(a = 1, a = 2));
}
mod rates {
    ptc::ptc_controller!(n = 1, mu = exp_sum(rates = [0.5]));
}

fn main() {}
