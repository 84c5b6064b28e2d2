//! The command line of the generator: `emit`, `show` and `list`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run(std::env::args_os()).into()
}
