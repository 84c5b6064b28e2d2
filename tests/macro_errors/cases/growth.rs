mod u_grows {
    ptc::ptc_controller!(n = 2, mu = exp(a = 1), poles = [-1.2, -1.5]);
}
mod x_stays {
    ptc::ptc_controller!(n = 2, mu = exp(a = 1), gains = [3, 4]);
}
mod another_is_allowed {
    ptc::ptc_controller!(n = 2, mu = tanh(a = 1), poles = [-3, -4], allow = sampling);
}

fn main() {}
