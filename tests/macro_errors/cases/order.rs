mod none {
    ptc::ptc_controller!(n = 0, mu = exp);
}
mod beyond {
    ptc::ptc_controller!(n = 17, mu = exp);
}
mod fraction {
    ptc::ptc_controller!(n = 2.5, mu = exp);
}
mod negative {
    ptc::ptc_controller!(n = -1, mu = exp);
}
mod word {
    ptc::ptc_controller!(n = three, mu = exp);
}

fn main() {}
