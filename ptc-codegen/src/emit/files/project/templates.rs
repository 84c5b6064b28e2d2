//! The templates of the projects, and what each is given.

use askama::Template;

use super::Project;
use super::config::{Clock, Config, Time};
use super::samples::{Plant, Samples};

/// Description and build instructions of a project.
#[derive(Template)]
#[template(path = "project/readme.md.txt", escape = "none")]
pub(super) struct Readme<'a> {
    pub(super) title: String,
    pub(super) about: &'static str,
    pub(super) project: Project,
    pub(super) commands: Vec<String>,
    pub(super) needs: &'static str,
    pub(super) config_file: &'static str,
    /// Folder into which the controller is regenerated.
    pub(super) source: &'static str,
    pub(super) config: &'a Config,
}

#[derive(Template)]
#[template(path = "project/config.h.txt", escape = "none")]
pub(super) struct ConfigC<'a> {
    pub(super) config: &'a Config,
    pub(super) time: &'a Time,
}

#[derive(Template)]
#[template(path = "project/main.c.txt", escape = "none")]
pub(super) struct MainC<'a> {
    pub(super) config: &'a Config,
    pub(super) time: &'a Time,
}

#[derive(Template)]
#[template(path = "project/run.ino.txt", escape = "none")]
pub(super) struct Arduino<'a> {
    pub(super) config: &'a Config,
    pub(super) time: &'a Time,
}

#[derive(Template)]
#[template(path = "project/config.rs.txt", escape = "none")]
pub(super) struct ConfigRust<'a> {
    pub(super) config: &'a Config,
    pub(super) time: &'a Time,
}

#[derive(Template)]
#[template(path = "project/main.rs.txt", escape = "none")]
pub(super) struct MainRust<'a> {
    pub(super) config: &'a Config,
    pub(super) time: &'a Time,
}

#[derive(Template)]
#[template(path = "project/config_samples.h.txt", escape = "none")]
pub(super) struct ConfigSamplesC<'a> {
    pub(super) config: &'a Config,
    pub(super) samples: &'a Samples,
}

#[derive(Template)]
#[template(path = "project/main_samples.c.txt", escape = "none")]
pub(super) struct MainSamplesC<'a> {
    pub(super) config: &'a Config,
    pub(super) samples: &'a Samples,
    /// True if the timer of the core calls it.
    pub(super) timer: bool,
}

#[derive(Template)]
#[template(path = "project/run_samples.ino.txt", escape = "none")]
pub(super) struct ArduinoSamples<'a> {
    pub(super) config: &'a Config,
    pub(super) samples: &'a Samples,
}

#[derive(Template)]
#[template(path = "project/config_samples.rs.txt", escape = "none")]
pub(super) struct ConfigSamplesRust<'a> {
    pub(super) config: &'a Config,
    pub(super) samples: &'a Samples,
}

#[derive(Template)]
#[template(path = "project/main_samples.rs.txt", escape = "none")]
pub(super) struct MainSamplesRust<'a> {
    pub(super) config: &'a Config,
    pub(super) samples: &'a Samples,
}

#[derive(Template)]
#[template(path = "project/Makefile.txt", escape = "none")]
pub(super) struct Makefile<'a> {
    pub(super) name: &'a str,
}

#[derive(Template)]
#[template(path = "project/linker.ld.txt", escape = "none")]
pub(super) struct Linker {}

#[derive(Template)]
#[template(path = "project/startup.c.txt", escape = "none")]
pub(super) struct Startup {}

#[derive(Template)]
#[template(path = "project/CMakeLists.txt.txt", escape = "none")]
pub(super) struct Cmake<'a> {
    pub(super) name: &'a str,
}

#[derive(Template)]
#[template(path = "project/Config.cmake.in.txt", escape = "none")]
pub(super) struct CmakeConfig<'a> {
    pub(super) name: &'a str,
}

#[derive(Template)]
#[template(path = "project/library.properties.txt", escape = "none")]
pub(super) struct Properties<'a> {
    pub(super) name: &'a str,
    pub(super) n: usize,
    pub(super) mapping: &'static str,
}

#[derive(Template)]
#[template(path = "project/Cargo.toml.txt", escape = "none")]
pub(super) struct Cargo<'a> {
    pub(super) name: &'a str,
    /// True if the controller calls library functions.
    pub(super) libm: bool,
}

#[derive(Template)]
#[template(path = "project/cargo_config.toml.txt", escape = "none")]
pub(super) struct Runner {}

#[derive(Template)]
#[template(path = "project/build.rs.txt", escape = "none")]
pub(super) struct Build {}

#[derive(Template)]
#[template(path = "project/memory.x.txt", escape = "none")]
pub(super) struct Memory {}
