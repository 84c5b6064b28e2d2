//! The command `ptc-codegen`, which is a function of the library.

fn main() -> std::process::ExitCode {
    ptc_codegen::command(std::env::args_os()).into()
}
