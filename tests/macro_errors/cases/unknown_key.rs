ptc::ptc_controller!(n = 3, mu = exp, gain = [6, 11, 6], precison = f32, colour = red);

fn main() {}
