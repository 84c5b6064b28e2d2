// Mistakes in a design file, and beside it, with the line of the file.
ptc::ptc_controller!(file = "wrong.toml", eps = 0, params.tau = 1);

fn main() {}
