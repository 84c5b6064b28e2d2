ptc::ptc_controller!(mu = exp);
ptc::ptc_controller!(n = 2);
ptc::ptc_controller!();

fn main() {}
