//! The emitted C in the loop: a program that reads a measurement a line and prints u.

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use ptc_codegen::reference::Status;
use ptc_codegen::simulate::{Control, Failure, Values};

use crate::c;
use crate::case::Case;
use crate::failure::Result;

/// Samples that are counted.
const SAMPLES: u32 = 800;

/// Links the program of a controller that was compiled in `folder`; its own files are in `home`.
pub(super) fn link(case: &Case, folder: &Path, home: &Path) -> Result<PathBuf> {
    let name = case.name();
    for file in ["h", "o"].map(|kind| format!("{name}.{kind}")) {
        std::fs::copy(folder.join(&file), home.join(&file))?;
    }
    let text = format!(
        "#include \"{name}.h\"
#include <stdio.h>
int main(int count, char **words) {{
    {name} self; double y[1] = {{ 1e-3 }}, u; unsigned k; int status = 0;
    const {name}_params params = {{ 0 }};
    (void)words;
    if ({name}_init(&self, &params) < 0) return 1;
    if (count > 1) {{
        for (k = 0; k < {SAMPLES}u; k++) status |= {name}_step(&self, k, y, &u) < 0;
        return status;
    }}
    while (scanf(\"%u %lf\", &k, y) == 2) {{
        status = {name}_step(&self, k, y, &u);
        printf(\"%.17g %d\\n\", u, status);
        fflush(stdout);
    }}
    return 0;
}}
"
    );
    c::link(&text, std::slice::from_ref(case), &[], home)
}

/// A running program.
struct Running {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
}

/// A program that is started for each run.
pub(super) struct Emitted {
    program: PathBuf,
    running: Option<Running>,
    u: [f64; 1],
}

impl Emitted {
    pub(super) fn new(program: PathBuf) -> Self {
        Self { program, running: None, u: [0.0] }
    }

    fn start(&mut self) -> Option<()> {
        self.end();
        let mut command = Command::new(&self.program);
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().ok()?;
        let (to, from) = (child.stdin.take()?, BufReader::new(child.stdout.take()?));
        self.running = Some(Running { child, to, from });
        Some(())
    }

    fn call(&mut self, k: f64, y: f64) -> Option<(f64, i32)> {
        let running = self.running.as_mut()?;
        writeln!(running.to, "{k} {y:e}").ok()?;
        let mut line = String::new();
        running.from.read_line(&mut line).ok()?;
        let (u, status) = line.trim().split_once(' ')?;
        Some((u.parse().ok()?, status.parse().ok()?))
    }

    fn end(&mut self) {
        if let Some(Running { mut child, to, .. }) = self.running.take() {
            // The program ends with its input.
            drop(to);
            let _ = child.wait();
        }
    }
}

impl Control for Emitted {
    fn init(&mut self, _: &Values, _: &[f64]) -> std::result::Result<(), Failure> {
        self.start().ok_or_else(|| Failure {
            cause: ptc_codegen::simulate::Cause::Input,
            at: None,
            message: format!("{} does not start", self.program.display()),
            help: "it was just linked: look at its folder".to_owned(),
        })
    }

    fn arm(&mut self, _: f64, _: &[f64]) -> bool {
        self.start().is_some()
    }

    fn step(&mut self, t: f64, measured: &[f64]) -> (&[f64], Status) {
        // A program that ends early shows as a u that is not a number.
        let (u, status) = self.call(t, measured[0]).unwrap_or((f64::NAN, -1));
        self.u[0] = u;
        (&self.u, if status < 0 { Status::Range } else { Status::Ok })
    }
}

impl Drop for Emitted {
    fn drop(&mut self) {
        self.end();
    }
}
