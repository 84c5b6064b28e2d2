// The path that was looked for is shown, once, and no key is said to be missing.
ptc::ptc_controller!(file = "/no/such/folder/roll.toml", tau = 2);

fn main() {}
