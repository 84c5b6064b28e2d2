mod unused {
    ptc::ptc_controller!(n = 2, mu = exp(a = 1), params.b = 2);
}
mod misspelt {
    ptc::ptc_controller!(n = 1, mu = exp, pi0 = -psi * xi1, params.psy = 20);
}
mod outside {
    ptc::ptc_controller!(n = 1, mu = tau * (1 - exp(-b * t)), params.b = -1);
}
mod inverted {
    ptc::ptc_controller!(n = 1, mu = exp, params.a = [2, 0.5]);
}

fn main() {}
