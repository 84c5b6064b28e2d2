//! Python modules on NumPy: types checked, run in batches, compared with C.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::Result;
use ptc_codegen::emit::Language;

use super::comparison::{Side, compare, controllers};
use super::seeded::with_defect;
use crate::context::{Context, workspace};
use crate::harness::program::driver;
use crate::harness::runtime::{self, homes};
use crate::harness::specs::spec;
use crate::harness::write;
use crate::layer::{Finding, Layer};
use crate::tool::{GCC, PYTHON};

pub(super) const LAYER: Layer = Layer {
    name: "python",
    claim: "Emitted Python modules pass mypy --strict and ruff, warn of nothing, and give the bits of \
            C where no library is called, a batch at a time.",
    tools: &[GCC, PYTHON],
    run,
};

fn run(context: &Context) -> Result<Finding> {
    let python =
        runtime::python(&context.shared("python"), &["numpy>=1.26", "mypy", "ruff", "control"])?;
    let side = Side {
        language: Language::Python,
        run: &|folder, homes, records| {
            let mut command = Command::new(&python);
            command.arg(driver("numpy_batches.py"));
            runtime::outcomes(&mut command, folder, homes, records)
        },
        has_axis: true,
        defect: (
            "- self._correction",
            "",
            "what the rounding of the deadline left out is forgotten",
        ),
    };
    let mut finding = compare(context, &side)?;
    types(context, &python, &mut finding)?;
    example(context, &python, &mut finding)?;
    Ok(finding)
}

/// `examples/python_control.py` with the controller that its head names.
fn example(context: &Context, python: &Path, finding: &mut Finding) -> Result<()> {
    let folder = context.scratch("python_example");
    let keys = [
        ("n", "2"),
        ("mu", "exp(a=1)"),
        ("gains", "12,7"),
        ("tau", "0.8"),
        ("eps", "0.01"),
        ("u_max", "40"),
        ("name", "stage"),
    ];
    write(&folder, &spec(&keys), Language::Python);
    let script = workspace().join("examples/python_control.py");
    let mut command = Command::new(python);
    let output = command.args(["-W", "error::RuntimeWarning"]).arg(script).arg(&folder).output()?;
    let told = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    if !output.status.success() {
        finding.failures.push(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    finding
        .notes
        .push(format!("As a NonlinearIOSystem of python-control, in closed loop: {told}."));
    Ok(())
}

/// Returns the messages of a checker on the modules in `folder`, if it fails.
fn told(python: &Path, arguments: &[&str], folder: &Path) -> Result<Option<String>> {
    let mut command = Command::new(python);
    let output = command.arg("-m").args(arguments).arg(folder).current_dir(folder).output()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    Ok((!output.status.success()).then_some(text))
}

/// Types and style of all modules; a module with a wrong type, and one with an unused name, are reported.
fn types(context: &Context, python: &Path, finding: &mut Finding) -> Result<()> {
    let folder = context.scratch("python_types");
    let all = folder.join("all");
    fs::create_dir_all(&all)?;
    let specs = controllers(context);
    for (home, spec) in homes(&folder.join("files"), &specs, Language::Python)? {
        let file = format!("{}.py", spec.name());
        fs::copy(home.join(&file), all.join(&file))?;
    }
    let mypy = ["mypy", "--strict", "--no-error-summary"];
    let ruff = ["ruff", "check", "--isolated", "--no-cache"];
    for arguments in [&mypy[..], &ruff] {
        finding.failures.extend(told(python, arguments, &all)?);
    }
    let wrong_type = ("-> Control:", "-> Status:", "a step that is typed to give a status");
    let unused = ("import numpy as np\n", "import numpy as np\nimport os\n", "an unused import");
    for (defect, arguments) in [(wrong_type, &mypy[..]), (unused, &ruff)] {
        let bad = folder.join("bad");
        with_defect(&bad, &context.example(), Language::Python, defect)?;
        let said = told(python, arguments, &bad)?;
        finding.seed(defect.2, said.map(|_| arguments[0].to_owned()));
    }
    Ok(())
}
