mod alone {
    ptc::ptc_controller!(n = 2, mu = exp, poles = [-2 + 1i, -3]);
}
mod too_few {
    ptc::ptc_controller!(n = 2, mu = exp, poles = [-3]);
}

fn main() {}
