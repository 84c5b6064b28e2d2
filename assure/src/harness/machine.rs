//! The machines that emitted code runs on: this one, and others under QEMU.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::{c_compiler, run};

/// A machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Machine {
    /// This one.
    Host,
    /// Arm Cortex-M0: no floating point in hardware.
    CortexM0,
    /// Arm Cortex-M4F: single precision in hardware.
    CortexM4f,
    /// Arm Cortex-M7: both precisions in hardware.
    CortexM7,
    /// 32-bit RISC-V, rv32imac: no floating point in hardware.
    Rv32,
}

/// The machines under QEMU.
pub const EMULATED: [Machine; 4] =
    [Machine::CortexM0, Machine::CortexM4f, Machine::CortexM7, Machine::Rv32];

/// Code and data of the machine's own that a program for it needs.
fn device(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("device").join(file)
}

impl Machine {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Host => "this machine",
            Self::CortexM0 => "Cortex-M0",
            Self::CortexM4f => "Cortex-M4F",
            Self::CortexM7 => "Cortex-M7",
            Self::Rv32 => "rv32imac",
        }
    }

    /// Its name in file names.
    pub fn stem(self) -> &'static str {
        match self {
            Self::Host => "host",
            Self::CortexM0 => "m0",
            Self::CortexM4f => "m4f",
            Self::CortexM7 => "m7",
            Self::Rv32 => "rv32",
        }
    }

    /// The C compiler with the flags that choose the machine.
    pub fn c_compiler(self) -> Command {
        let arm = |flags: &[&str]| {
            let mut command = Command::new("arm-none-eabi-gcc");
            command.arg("-mthumb").args(flags);
            command
        };
        match self {
            Self::Host => c_compiler(),
            Self::CortexM0 => arm(&["-mcpu=cortex-m0", "-mfloat-abi=soft"]),
            Self::CortexM4f => arm(&["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]),
            Self::CortexM7 => arm(&["-mcpu=cortex-m7", "-mfloat-abi=hard", "-mfpu=fpv5-d16"]),
            Self::Rv32 => {
                let mut command = Command::new("riscv64-unknown-elf-gcc");
                command.args(["-march=rv32imac", "-mabi=ilp32", "--specs=picolibc.specs"]);
                command
            }
        }
    }

    /// The program that lists the symbols of its files.
    pub fn nm(self) -> &'static str {
        match self {
            Self::Host => "nm",
            Self::CortexM0 | Self::CortexM4f | Self::CortexM7 => "arm-none-eabi-nm",
            Self::Rv32 => "riscv64-unknown-elf-nm",
        }
    }

    /// Returns the arguments that link a program for the machine, besides the objects.
    pub fn link_arguments(self) -> Vec<String> {
        let own = |file: &str| device(file).to_string_lossy().into_owned();
        let words = |words: &[&str]| words.iter().map(|w| (*w).to_owned()).collect::<Vec<_>>();
        let arm = |memory: &str| {
            let mut arguments =
                words(&["-nostartfiles", "--specs=nano.specs", "--specs=rdimon.specs"]);
            arguments.push(format!("-Wl,--gc-sections,--no-warn-rwx-segments,-L{}", own("")));
            arguments.extend([format!("-T{}", own(memory)), own("startup.c")]);
            arguments
        };
        match self {
            Self::Host => Vec::new(),
            Self::CortexM0 => arm("microbit.ld"),
            Self::CortexM4f | Self::CortexM7 => arm("mps2.ld"),
            Self::Rv32 => {
                let memory = "-Wl,--defsym=__flash=0x80000000,--defsym=__flash_size=4M,\
                    --defsym=__ram=0x80400000,--defsym=__ram_size=4M";
                words(&["--crt0=hosted", "--oslib=semihost", "-Wl,--gc-sections", memory])
            }
        }
    }

    /// The target of the Rust compiler, and the flags that go with it.
    pub fn rust_target(self) -> Option<(&'static str, &'static str)> {
        match self {
            Self::Host => None,
            Self::CortexM0 => Some(("thumbv6m-none-eabi", "")),
            Self::CortexM4f => Some(("thumbv7em-none-eabihf", "")),
            Self::CortexM7 => Some(("thumbv7em-none-eabihf", "-Ctarget-cpu=cortex-m7")),
            Self::Rv32 => Some(("riscv32imac-unknown-none-elf", "")),
        }
    }

    /// Runs `program` to its end in `folder`.
    pub fn run(self, program: &Path, folder: &Path) -> Vec<u8> {
        run(self.command(program, &[]).current_dir(folder))
    }

    /// The command that runs `program`, with `arguments` of the emulator's.
    pub fn command(self, program: &Path, arguments: &[&str]) -> Command {
        let (emulator, board) = match self {
            Self::Host => return Command::new(program),
            Self::CortexM0 => ("qemu-system-arm", "microbit"),
            Self::CortexM4f => ("qemu-system-arm", "mps2-an386"),
            Self::CortexM7 => ("qemu-system-arm", "mps2-an500"),
            Self::Rv32 => ("qemu-system-riscv32", "virt"),
        };
        // A controller that hangs is stopped.
        let mut command = Command::new("timeout");
        command.args(["120", emulator, "-M", board, "-display", "none", "-monitor", "none"]);
        command.args(["-serial", "none", "-semihosting-config", "enable=on,target=native"]);
        if self == Self::Rv32 {
            command.args(["-bios", "none"]);
        }
        command.args(arguments).arg("-kernel").arg(program);
        command
    }
}
