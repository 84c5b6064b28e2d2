//! A design of each kind, for what all of them must keep: the clock in samples with its observers, delays, disturbances and
//! references, models, several inputs, axes, filters, deadlines in flight, disturbances that move, and the examples.

use std::fs;
use std::path::Path;

use ptc_codegen::diagnostic::Place;
use ptc_codegen::request::Spec;
use ptc_codegen::{design, plant};

use super::{goldens, in_samples};

/// All of them, each by a name that no other has: a controller's, or that of an example's file.
pub fn designs() -> Vec<(String, Spec)> {
    let mut all = [in_samples::controllers(), in_samples::of_inputs()].concat();
    all.extend(goldens::of_two_inputs());
    all.push(goldens::of_inputs());
    let named = all.into_iter().map(|spec| (spec.name(), spec));
    named
        .chain(of_folder("filter", "tests/designs/filter"))
        .chain(of_folder("flight", "tests/designs/flight"))
        .chain(of_folder("observer", "tests/designs/observer"))
        .chain(of_folder("example", "examples"))
        .collect()
}

/// The examples of one loop with a clock in samples.
pub fn examples_in_samples() -> Vec<Spec> {
    let examples = of_folder("example", "examples").map(|(_, spec)| spec);
    examples.filter(|spec| spec.sampled().is_some() && spec.axes.is_none()).collect()
}

/// The designs in a folder, in the order of their names, which begin with the word for its kind.
fn of_folder(kind: &str, folder: &str) -> impl Iterator<Item = (String, Spec)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder);
    let entries = fs::read_dir(folder).expect("a folder of designs");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.retain(|path| path.extension().is_some_and(|own| own == "toml"));
    files.sort();
    files.into_iter().map(move |path| {
        let stem = path.file_stem().expect("a name").to_string_lossy();
        (format!("{kind}_{stem}"), of_file(&path))
    })
}

/// The controller of a design file.
fn of_file(path: &Path) -> Spec {
    let text = fs::read_to_string(path).expect("a design");
    let (entries, found) = design::read(&text, &mut |_| Place(0));
    assert_eq!(found, [], "{}", path.display());
    let read = plant::read_design(&entries);
    read.unwrap_or_else(|found| panic!("{}: {found:?}", path.display())).0
}
