//! The tools of the layers: whether they are there, which version they are, how they are installed.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Stdio};

/// A tool that a layer cannot do without.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tool {
    /// Its name in reports.
    pub name: &'static str,
    /// Evidence that it is installed.
    pub shown_by: ShownBy,
    /// Source of the tool.
    pub source: Source,
}

/// Evidence that a tool is installed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShownBy {
    /// A program that exits with 0 for these arguments; it prints its version.
    Command(&'static [&'static str]),
    /// A file that a package holds.
    File(&'static str),
}

/// Source of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Debian's packages.
    Apt(&'static [&'static str]),
    /// `rustup` with these arguments.
    Rustup(&'static [&'static str]),
    /// `cargo install` with these arguments.
    Cargo(&'static [&'static str]),
    /// Whoever builds this project has it.
    Given,
}

impl Tool {
    /// Returns true if it can be used.
    pub fn is_there(&self) -> bool {
        match self.shown_by {
            ShownBy::Command(words) => output(words).is_some(),
            ShownBy::File(path) => Path::new(path).exists(),
        }
    }

    /// The first line that it prints of its version; empty for a file.
    pub fn version(&self) -> String {
        match self.shown_by {
            ShownBy::Command(words) => output(words)
                .and_then(|text| {
                    text.lines().find(|line| !line.trim().is_empty()).map(str::to_owned)
                })
                .unwrap_or_default(),
            ShownBy::File(_) => String::new(),
        }
    }

    /// Describes the missing tool, and how to install it.
    pub fn missing(&self) -> String {
        let bring = match self.source {
            Source::Apt(packages) => format!("apt-get install {}", packages.join(" ")),
            Source::Rustup(arguments) => format!("rustup {}", arguments.join(" ")),
            Source::Cargo(arguments) => format!("cargo install {}", arguments.join(" ")),
            Source::Given => "it comes with what builds this project".to_owned(),
        };
        format!("{} is not installed ({bring})", self.name)
    }
}

/// Returns the output of a command, where it succeeds.
fn output(words: &[&str]) -> Option<String> {
    let (program, arguments) = words.split_first()?;
    let output = Command::new(program).args(arguments).stdin(Stdio::null()).output().ok()?;
    output.status.success().then(|| {
        let [out, error] = [output.stdout, output.stderr]
            .map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
        if out.trim().is_empty() { error } else { out }
    })
}

/// Installs those of `tools` that are missing, where this is root on a machine with apt, or
/// rustup or cargo brings them; says what it does, and goes on where something cannot be had.
pub fn install(tools: &[Tool]) {
    let missing: Vec<_> = tools.iter().filter(|tool| !tool.is_there()).collect();
    let mut packages = BTreeSet::new();
    let mut commands = BTreeSet::new();
    for tool in missing {
        match tool.source {
            Source::Apt(names) => packages.extend(names),
            Source::Rustup(arguments) => {
                commands.insert([&["rustup"], arguments].concat());
            }
            Source::Cargo(arguments) => {
                commands.insert([&["cargo", "install", "--locked"], arguments].concat());
            }
            Source::Given => {}
        }
    }
    if !packages.is_empty() {
        let packages: Vec<_> = packages.into_iter().copied().collect();
        if !is_root() {
            eprintln!("not root: run `apt-get install {}` first", packages.join(" "));
        } else {
            execute(&["apt-get", "update", "-qq"]);
            // Another run of the layers may be installing.
            let wait = "-oDPkg::Lock::Timeout=600";
            let install = ["apt-get", wait, "install", "-y", "-qq", "--no-install-recommends"];
            execute(&[&install[..], &packages].concat());
        }
    }
    for command in commands {
        execute(&command);
    }
}

fn is_root() -> bool {
    output(&["id", "-u"]).is_some_and(|id| id.trim() == "0")
}

/// Runs a command that installs something; its output goes to the standard error.
fn execute(words: &[&str]) {
    eprintln!("installing: {}", words.join(" "));
    let Some((program, arguments)) = words.split_first() else { return };
    let ended = Command::new(program)
        .args(arguments)
        .env("DEBIAN_FRONTEND", "noninteractive")
        // Tools that cargo builds here run for seconds: what counts is how soon they are there.
        .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "0")
        .env("CARGO_PROFILE_RELEASE_LTO", "off")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .status();
    if !ended.is_ok_and(|status| status.success()) {
        eprintln!("could not be installed: {}", words.join(" "));
    }
}

/// The C compiler of this machine.
pub const GCC: Tool = Tool {
    name: "gcc",
    shown_by: ShownBy::Command(&["gcc", "--version"]),
    source: Source::Apt(&["gcc", "libc6-dev"]),
};

/// The C++ compiler of this machine.
pub const GXX: Tool = Tool {
    name: "g++",
    shown_by: ShownBy::Command(&["g++", "--version"]),
    source: Source::Apt(&["g++"]),
};

/// The interpreter of MATLAB functions.
pub const OCTAVE: Tool = Tool {
    name: "GNU Octave",
    shown_by: ShownBy::Command(&["octave-cli", "--version"]),
    source: Source::Apt(&["octave"]),
};

/// Python, with what makes an environment for packages.
pub const PYTHON: Tool = Tool {
    name: "python3",
    shown_by: ShownBy::Command(&["python3", "-c", "import ensurepip, sys; print(sys.version)"]),
    source: Source::Apt(&["python3", "python3-venv"]),
};

/// The browser, with letters for formulas.
pub const CHROMIUM: Tool = Tool {
    name: "Chromium",
    shown_by: ShownBy::Command(&["chromium", "--version"]),
    source: Source::Apt(&["chromium", "fonts-dejavu-extra"]),
};

/// The C++ compiler for Arm. The package of the C compiler has it too, without a library.
pub const ARM_GXX: Tool = Tool {
    name: "arm-none-eabi-g++",
    shown_by: ShownBy::Command(&[
        "sh",
        "-c",
        "echo '#include <array>' | arm-none-eabi-g++ -x c++ -fsyntax-only - && arm-none-eabi-g++ --version",
    ]),
    source: Source::Apt(&["gcc-arm-none-eabi", "libstdc++-arm-none-eabi-newlib"]),
};

/// The other C compiler of this machine.
pub const CLANG: Tool = Tool {
    name: "clang",
    shown_by: ShownBy::Command(&["clang", "--version"]),
    source: Source::Apt(&["clang"]),
};

/// The Rust compiler.
pub const RUSTC: Tool = Tool {
    name: "rustc",
    shown_by: ShownBy::Command(&["rustc", "--version"]),
    source: Source::Given,
};

/// The C compiler for Arm.
pub const ARM_GCC: Tool = Tool {
    name: "arm-none-eabi-gcc",
    shown_by: ShownBy::Command(&["arm-none-eabi-gcc", "--version"]),
    source: Source::Apt(&["gcc-arm-none-eabi", "libnewlib-arm-none-eabi"]),
};

/// The C library for Arm.
pub const NEWLIB: Tool = Tool {
    name: "newlib",
    shown_by: ShownBy::File("/usr/lib/arm-none-eabi/include/math.h"),
    source: Source::Apt(&["libnewlib-arm-none-eabi"]),
};

/// The emulator of Arm machines.
pub const QEMU_ARM: Tool = Tool {
    name: "qemu-system-arm",
    shown_by: ShownBy::Command(&["qemu-system-arm", "--version"]),
    source: Source::Apt(&["qemu-system-arm"]),
};

/// The C compiler for RISC-V.
pub const RISCV_GCC: Tool = Tool {
    name: "riscv64-unknown-elf-gcc",
    shown_by: ShownBy::Command(&["riscv64-unknown-elf-gcc", "--version"]),
    source: Source::Apt(&["gcc-riscv64-unknown-elf", "picolibc-riscv64-unknown-elf"]),
};

/// The C library for RISC-V.
pub const PICOLIBC: Tool = Tool {
    name: "picolibc",
    shown_by: ShownBy::File("/usr/lib/picolibc/riscv64-unknown-elf/picolibc.specs"),
    source: Source::Apt(&["picolibc-riscv64-unknown-elf"]),
};

/// The emulator of RISC-V machines.
pub const QEMU_RISCV: Tool = Tool {
    name: "qemu-system-riscv32",
    shown_by: ShownBy::Command(&["qemu-system-riscv32", "--version"]),
    source: Source::Apt(&["qemu-system-misc"]),
};
