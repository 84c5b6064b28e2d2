mod mappings {
    ptc::ptc_controller!(n = 2, mu = exp, kappa = -ln(1 - dt / tau));
}
mod laws {
    ptc::ptc_controller!(n = 2, mu = exp, gains = [6, 5], poles = [-2, -3]);
}

fn main() {}
