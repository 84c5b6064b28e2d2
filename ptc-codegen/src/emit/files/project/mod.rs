//! Small projects that build as they are: a controller in closed loop with its plant.
//!
//! Each holds the files of the emitted C or Rust as they are, and one file of values.

mod axes;
mod config;
mod samples;
mod start;
mod templates;

use askama::Template;

use super::apart::apart;
use super::{File, Language, stands_alone, text_of, tidy};
use crate::algebra::BigRational;
use crate::check::examine::Report;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expression::Expression;
use crate::parameter::Precision;
use crate::request::Spec;
use config::{Clock, Config};
use templates::{
    Arduino, ArduinoSamples, Build, Cargo, Cmake, CmakeConfig, ConfigC, ConfigRust, ConfigSamplesC,
    ConfigSamplesRust, Linker, MainC, MainRust, MainSamplesC, MainSamplesRust, Makefile, Memory,
    Properties, Readme, Runner, Startup,
};

/// A kind of project.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Project {
    /// Bare-metal firmware in C for a Cortex-M4F.
    CortexM,
    /// The same in Rust.
    RustEmbedded,
    /// A library with an example and a test, by CMake.
    Cmake,
    /// A library for Arduino with an example.
    Arduino,
}

impl Project {
    /// Every kind.
    pub const ALL: [Self; 4] = [Self::CortexM, Self::RustEmbedded, Self::Cmake, Self::Arduino];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::CortexM => "cortex-m",
            Self::RustEmbedded => "rust-embedded",
            Self::Cmake => "cmake",
            Self::Arduino => "arduino",
        }
    }

    /// The kind of this name on the command line.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|project| project.name() == name)
    }

    /// Describes the project in a few words.
    pub fn about(self) -> &'static str {
        match self {
            Self::CortexM => "firmware in C for a bare Cortex-M4F",
            Self::RustEmbedded => "the same in Rust",
            Self::Cmake => "a library that CMake installs, with an example",
            Self::Arduino => "a library with an example sketch",
        }
    }

    /// Checks that the controller of `spec` can be made a project.
    ///
    /// # Errors
    /// What it cannot do alone, and an input gain that its plant cannot have.
    #[doc(hidden)]
    pub fn accepts(self, spec: &Spec) -> Result<(), Vec<Diagnostic>> {
        let mut found = Diagnostics::default();
        stands_alone(spec, "a project", &mut found);
        let moves = spec.sampled().is_none() && spec.drift.is_some();
        for (key, known) in
            [("f", moves), ("dynamics", spec.model.is_some() || spec.coupled.is_some())]
        {
            if known {
                let message = "the plant of a project is x_n' = g u";
                let help = "leave f and [model] out, or emit the controller alone";
                found.push("not-alone", key, None, message, help);
            }
        }
        if spec.reference.is_some() || spec.known_references().next().is_some() {
            let message = "the run of a project brings the plant to rest";
            let help = "leave `reference` out, or emit the controller alone";
            found.push("not-alone", "reference", None, message, help);
        }
        let own = spec.axes.iter().flat_map(|axes| &axes.input_gains);
        if spec.input_gain.iter().chain(own).any(|gain| constant(gain).is_none()) {
            let message = "the plant of a project is x_n' = g u with a number for g".to_owned();
            let help = "leave g out and divide u by it in the project, or give its value";
            found.push("not-alone", "g", None, message, help);
        }
        let name = spec.name();
        // Some file systems, and the types of the code, know no case.
        let plain = name.to_ascii_lowercase();
        if NAMES.split_whitespace().any(|own| own == plain) {
            let message = format!("`{name}` is a name in the files of a project");
            found.push("reserved-name", "name", None, message, "choose another name");
        }
        found.finish(Some(()))
    }

    /// The language of its controller.
    pub(crate) fn language(self) -> Language {
        match self {
            Self::CortexM | Self::Cmake | Self::Arduino => Language::C,
            Self::RustEmbedded => Language::Rust,
        }
    }

    /// The files of the project around the `emitted` ones of a controller, by their paths in it.
    pub(crate) fn files(self, report: &Report, emitted: Vec<File>) -> Vec<File> {
        let config = Config::of(report, self.language());
        let files = match self {
            Self::CortexM => cortex_m(&config, emitted),
            Self::RustEmbedded => rust_embedded(&config, emitted),
            Self::Cmake => cmake(&config, emitted),
            Self::Arduino => arduino(&config, &report.spec, emitted),
        };
        let is_c = |file: &File| [".c", ".h", ".ino"].iter().any(|end| file.name.ends_with(end));
        let settled = |file| if is_c(&file) { apart(file, &config.name) } else { file };
        files.into_iter().map(settled).collect()
    }
}

/// Reserved names of the parts of the projects: in the sources, among the files, and among the crates; and the targets
/// that CMake keeps for itself, with the library it links.
const NAMES: &str = "
    arrived build config control core debug due fail failed largest loop measure norm plant real row
    norm_of_axes rows run sample sent setup start_timer steps step_count stop table ticks turn turns vector word
    main startup
    alloc cortex_m cortex_m_rt cortex_m_semihosting std
    all all_build clean continuous depend edit_cache experimental help install m nightly package
    package_source preinstall rebuild_cache run_tests test zero_check
";

/// A number that an input gain is.
fn constant(gain: &Expression) -> Option<&BigRational> {
    gain.number()
}

fn file(name: &str, template: &impl Template) -> File {
    File { name: name.to_owned(), text: tidy(&text_of(template.render())) }
}

/// The emitted files in a folder of the project each.
fn placed<'a>(
    emitted: Vec<File>,
    header: &'a str,
    source: &'a str,
) -> impl Iterator<Item = File> + 'a {
    emitted.into_iter().map(move |file| {
        let folder = if file.name.ends_with(".h") { header } else { source };
        File { name: format!("{folder}/{}", file.name), ..file }
    })
}

/// The program around the controller in C; if `timer` is true, a timer calls it at each sample.
fn main_c(name: &str, config: &Config, timer: bool) -> File {
    match &config.clock {
        Clock::Time(time) => file(name, &MainC { config, time }),
        Clock::Samples(samples) => file(name, &MainSamplesC { config, samples, timer }),
    }
}

fn config_c(name: &str, config: &Config) -> File {
    match &config.clock {
        Clock::Time(time) => file(name, &ConfigC { config, time }),
        Clock::Samples(samples) => file(name, &ConfigSamplesC { config, samples }),
    }
}

fn cortex_m(config: &Config, emitted: Vec<File>) -> Vec<File> {
    let name = config.name.as_str();
    let mut files: Vec<_> = placed(emitted, "src", "src").collect();
    files.extend([
        file("Makefile", &Makefile { name }),
        file("linker.ld", &Linker {}),
        file("src/startup.c", &Startup {}),
        main_c("src/main.c", config, true),
        config_c("src/config.h", config),
        file(
            "README.md",
            &Readme {
                title: format!("{name} on a Cortex-M4F"),
                about: "Firmware in C without an operating system: start-up code with the FPU, a linker \
                    script, the controller and its plant in simulation.",
                project: Project::CortexM,
                commands: vec!["make".to_owned(), "make run".to_owned()],
                needs: "It needs arm-none-eabi-gcc with newlib, and QEMU (machine mps2-an386) to run.",
                config_file: "src/config.h",
                source: "src",
                config,
            },
        ),
    ]);
    files
}

fn rust_embedded(config: &Config, emitted: Vec<File>) -> Vec<File> {
    let name = config.name.as_str();
    let libm = emitted.iter().any(|module| module.text.contains("feature = \"libm\""));
    let (main, values) = match &config.clock {
        Clock::Time(time) => (
            file("src/main.rs", &MainRust { config, time }),
            file("src/config.rs", &ConfigRust { config, time }),
        ),
        Clock::Samples(samples) => (
            file("src/main.rs", &MainSamplesRust { config, samples }),
            file("src/config.rs", &ConfigSamplesRust { config, samples }),
        ),
    };
    let mut files = vec![
        file("Cargo.toml", &Cargo { name, libm }),
        file(".cargo/config.toml", &Runner {}),
        file("build.rs", &Build {}),
        file("memory.x", &Memory {}),
        main,
        values,
    ];
    files.extend(placed(emitted, "src", "src"));
    files.push(file(
        "README.md",
        &Readme {
            title: format!("{name} on a Cortex-M4F, in Rust"),
            about: "Firmware in Rust without an operating system: cortex-m-rt, the controller and its \
                plant in simulation.",
            project: Project::RustEmbedded,
            commands: vec![
                "rustup target add thumbv7em-none-eabihf".to_owned(),
                "cargo run --release".to_owned(),
            ],
            needs: "It needs QEMU (machine mps2-an386) to run.",
            config_file: "src/config.rs",
            source: "src",
            config,
        },
    ));
    files
}

fn cmake(config: &Config, emitted: Vec<File>) -> Vec<File> {
    let name = config.name.as_str();
    let mut files: Vec<_> = placed(emitted, "include", "src").collect();
    files.extend([
        file("CMakeLists.txt", &Cmake { name }),
        file(&format!("cmake/{name}Config.cmake.in"), &CmakeConfig { name }),
        main_c("example/main.c", config, false),
        config_c("example/config.h", config),
        file(
            "README.md",
            &Readme {
                title: format!("The library {name}"),
                about: "A library in C with an example, which is its test. Installed, it is found by \
                    `find_package`.",
                project: Project::Cmake,
                commands: vec![
                    "cmake -B build -DCMAKE_BUILD_TYPE=Release".to_owned(),
                    "cmake --build build".to_owned(),
                    "ctest --test-dir build --output-on-failure".to_owned(),
                    "cmake --install build --prefix installed".to_owned(),
                ],
                needs: "It needs CMake 3.15 and a C compiler. In another project: \
                    `find_package(NAME)` and `target_link_libraries(... NAME::NAME)`.",
                config_file: "example/config.h",
                source: "DIR, and sort them into include/ and src/",
                config,
            },
        ),
    ]);
    files
}

fn arduino(config: &Config, spec: &Spec, emitted: Vec<File>) -> Vec<File> {
    let name = config.name.as_str();
    let sketch = "examples/run/run.ino";
    let mut files: Vec<_> = placed(emitted, "src", "src").collect();
    files.extend([
        file(
            "library.properties",
            &Properties { name, n: spec.n, mapping: spec.mapping_name() },
        ),
        match &config.clock {
            Clock::Time(time) => file(sketch, &Arduino { config, time }),
            Clock::Samples(samples) => file(sketch, &ArduinoSamples { config, samples }),
        },
        config_c("examples/run/config.h", config),
        file(
            "README.md",
            &Readme {
                title: format!("The Arduino library {name}"),
                about: match spec.precision {
                    Precision::F32 => "A library with an example sketch.",
                    Precision::F64 => {
                        "A library with an example sketch. Where `double` has 4 bytes, as on AVR, the \
                         controller has the digits of `float`: take `--precision f32`, which is that on \
                         every board."
                    }
                },
                project: Project::Arduino,
                commands: vec![
                    "arduino-cli lib install --zip-path LIBRARY.zip".to_owned(),
                    "arduino-cli compile -b arduino:samd:mkrzero examples/run".to_owned(),
                ],
                needs: "Or copy the folder into that of your libraries, and open the example `run`.",
                config_file: "examples/run/config.h",
                source: "src",
                config,
            },
        ),
    ]);
    files
}
