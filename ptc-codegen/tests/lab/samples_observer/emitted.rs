//! An observer in C, compiled, and called over a pipe.

use std::fmt::Write as _;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use ptc_codegen::emit::Language;
use ptc_codegen::request::Spec;

const BITS: &str = include_str!("../../../../tests/support/bits.h");

const MAIN: &str = r#"
#include "NAME.h"
int main(void)
{
    NAME self;
    const NAME_params params = { 0 };
    char word[4];
    uint32_t k;
    if (NAME_init(&self, &params) != PTC_OK) return 2;
    while (scanf("%3s %" SCNu32, word, &k) == 2) {
        if (word[0] == 'A') {
            if (NAME_arm(&self, k) != PTC_OK) return 2;
            continue;
        }
        double y[MEASURED];
        for (int j = 0; j < MEASURED; j++) y[j] = number();
        const double u = number();
        printf("%d", (int)NAME_update(&self, k, y, u));
        GIVEN
        printf("\n");
        fflush(stdout);
    }
    return 0;
}
"#;

pub(crate) struct Emitted {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
}

impl Emitted {
    /// The observer of `spec`, whose parameters are fixed; `xhat` values and d are what it gives.
    pub(crate) fn new(folder: &Path, spec: &Spec, xhat: usize) -> Self {
        let name = spec.name();
        let sampled = spec.sampled().expect("a clock in samples");
        for file in ptc_codegen::generate(spec, Language::C).expect("C") {
            fs::write(folder.join(file.name), file.text).expect("a file");
        }
        let mut given = format!(
            "{{ double e[{xhat}]; if (NAME_estimate(&self, e) != PTC_OK) return 2; for (int j = 0; j < {xhat}; j++) show(e[j]); }}"
        );
        if sampled.disturbance.is_some() {
            given.push_str(
                "{ double d; if (NAME_disturbance(&self, &d) != PTC_OK) return 2; show(d); }",
            );
        }
        let main = MAIN.replace("GIVEN", &given).replace("NAME", &name);
        let main = BITS.to_owned() + &main.replace("MEASURED", &sampled.measured.to_string());
        fs::write(folder.join("main.c"), main).expect("a file");
        let program = folder.join("observe");
        let output = Command::new("cc")
            .args(["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic"])
            .args(["-Wconversion", "-Werror", "main.c"])
            .arg(format!("{name}.c"))
            .args(["-lm", "-o"])
            .arg(&program)
            .current_dir(folder)
            .output()
            .expect("a C compiler");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let piped = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut child = piped.expect("the program runs");
        let to = child.stdin.take().expect("a pipe");
        let from = BufReader::new(child.stdout.take().expect("a pipe"));
        Self { child, to, from }
    }

    pub(crate) fn arm(&mut self, k: u32) {
        writeln!(self.to, "A {k}").expect("it listens");
    }

    /// The status, the estimates, and that of d behind them.
    pub(crate) fn update(&mut self, k: u32, y: &[f64], u: f64) -> (i32, Vec<f64>) {
        let mut line = format!("U {k}");
        for value in y.iter().chain([&u]) {
            write!(line, " {:016x}", value.to_bits()).expect("a string");
        }
        writeln!(self.to, "{line}").expect("it listens");
        self.to.flush().expect("it listens");
        let mut answer = String::new();
        self.from.read_line(&mut answer).expect("it answers");
        let mut words = answer.split_whitespace();
        let status = words.next().and_then(|word| word.parse().ok()).expect("a status");
        let bits = |word| match word {
            "nan" => f64::NAN,
            bits => f64::from_bits(u64::from_str_radix(bits, 16).expect("bits")),
        };
        (status, words.map(bits).collect())
    }
}

impl Drop for Emitted {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
