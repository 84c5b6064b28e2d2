mod function {
    ptc::ptc_controller!(n = 2, kappa = -log(1 - dt / tau));
}
mod state {
    ptc::ptc_controller!(n = 2, mu = exp, pi0 = -6 * x1 - 5 * xi3);
}
mod division {
    ptc::ptc_controller!(n = 1, mu = exp, pi0 = -xi1 / (2 - 2));
}
mod operator {
    ptc::ptc_controller!(n = 1, mu = exp, pi0 = -xi1 % 2);
}
mod reserved {
    ptc::ptc_controller!(n = 1, mu = exp, pi0 = -int * xi1);
}

fn main() {}
