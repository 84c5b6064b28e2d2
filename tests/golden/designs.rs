//! generated/designs/ holds a folder for each kind of design: samples, observers, references, models, several inputs and
//! axes, and the examples. Each has its files in every language, its self-test, its contracts and its FMU; where a
//! language or a tool refuses a design, the refusal is kept in place of the files.

use std::path::{Path, PathBuf};

use ptc_assure::harness::net::designs;
use ptc_codegen::Accepted;
use ptc_codegen::check::examine::examine;
use ptc_codegen::diagnostic::Diagnostic;
use ptc_codegen::emit::{File, Language};
use ptc_codegen::request::Spec;

use crate::store::{Files, compare};

const FOLDER: &str = "designs";

type Made = Result<Vec<File>, Vec<Diagnostic>>;

#[test]
fn designs_give_the_files_of_generated() {
    let mut wanted = Files::new();
    for (name, spec) in designs() {
        for (path, text) in files(&name, &spec) {
            let before = wanted.insert(path, text);
            assert_eq!(before, None, "two designs of one name: {name}");
        }
    }
    compare(&[FOLDER], &wanted);
}

/// Every file of one design, by its path in generated/.
fn files(name: &str, spec: &Spec) -> Files {
    let mut kept = Kept { folder: Path::new(FOLDER).join(name), files: Files::new() };
    let accepted = match Accepted::of(examine(spec)) {
        Ok(accepted) => accepted,
        Err(found) => {
            kept.add("checks", Err(found));
            return kept.files;
        }
    };
    let sources = Language::ALL.into_iter().filter(|language| language.fmi().is_none());
    for language in sources {
        kept.add(language.name(), accepted.files(language, &[]));
    }
    kept.add("selftest", accepted.selftest());
    // Only comments set the C with contracts apart from the C, which is kept already; the rest is the harness of a proof.
    kept.add("acsl", accepted.files_with_proof());
    // The model description and the interface: the sources in the archive are the C again.
    for language in [Language::Fmu2, Language::Fmu3] {
        let described = accepted.files(language, &[]).map(|files| {
            let own = |file: &File| !file.name.ends_with(".h") && !is_controller(spec, file);
            files.into_iter().filter(own).collect()
        });
        kept.add(language.name(), described);
    }
    kept.files
}

fn is_controller(spec: &Spec, file: &File) -> bool {
    file.name == format!("sources/{}.c", spec.name())
}

/// The goldens of one design.
struct Kept {
    folder: PathBuf,
    files: Files,
}

impl Kept {
    /// Keeps what was made under a name, or why it was refused.
    fn add(&mut self, name: &str, made: Made) {
        match made {
            Ok(files) => {
                for file in files {
                    self.files.insert(self.folder.join(name).join(file.name), file.text);
                }
            }
            Err(found) => {
                let lines = found.iter().map(|refusal| format!("{refusal}\n"));
                self.files.insert(self.folder.join(format!("{name}.refused.txt")), lines.collect());
            }
        }
    }
}
