// What names no file, and what names two.
ptc::ptc_controller!(n = 2, mu = exp, file = roll);
ptc::ptc_controller!(file = "/no/such/folder/roll.toml", file = "roll.toml");

fn main() {}
