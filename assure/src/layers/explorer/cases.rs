//! The designs that are typed into the page.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Result;

use crate::context::workspace;

/// A design, and where its file is.
pub(super) struct Case {
    pub(super) name: String,
    pub(super) path: PathBuf,
    pub(super) text: String,
}

/// A sampled chain, whose sliders and poles are moved, and the name of its case.
const CHAIN: &str =
    "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nsample_time = 1e-3\n\n[params]\ntau = 1\n";
const FIRST: &str = "chain";

/// The cases with which a defect is seen.
pub(super) const FEW: [&str; 2] = [FIRST, "unknown family"];

/// Designs with mistakes of each kind: in the text, in its meaning, in what the checks say, and in
/// what a language can express.
const BAD: [(&str, &str); 15] = [
    ("empty", ""),
    ("no toml", "n = 2\nmu = \"exp\ntau = = 3\n[params\n"),
    ("unknown family", "n = 2\nmu = \"expo(a=1)\"\n"),
    ("unknown key", "n = 2\nmu = \"exp\"\nsampel_time = 1e-3\n"),
    ("unknown table", "n = 2\nmu = \"exp\"\n[parms]\ntau = 1\n"),
    ("missing keys", "poles = [-4, -5]\n"),
    ("wrong counts", "n = 3\nmu = \"exp(a=1)\"\ngains = [1, 2]\nnoise = [1, 2, 3, 4]\n"),
    ("poles without partner", "n = 2\nmu = \"exp(a=1)\"\npoles = \"-4+2i,-5\"\n"),
    ("after tabs and letters", "# größe 𝑥 \u{e9}\n\tn = 0\nmu = \"exp\"\n"),
    ("growth", "n = 2\nmu = \"exp(a=3)\"\npoles = [-4, -5]\n"),
    ("membership", "n = 2\nmu = \"tau*(1 - exp(-t))/2\"\n"),
    (
        "period",
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\ntau = 1\neps = 1e-4\nsample_time = 0.01\n",
    ),
    ("conflict", "n = 2\nmu = \"exp(a=1)\"\nkappa = \"dt\"\ngains = [1, 2]\npoles = [-1, -2]\n"),
    ("overflow", "n = 8\nmu = \"exp(a=1e-300)\"\ngains = [1, 2, 3, 4, 5, 6, 7, 8]\n"),
    ("word of a language", "n = 2\nmu = \"exp(a=1)\"\nname = \"function\"\n"),
];

/// The examples of the repository and the designs with mistakes, as files in `folder`; a few of them
/// where `few` is set.
pub(super) fn cases(folder: &Path, few: bool) -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for entry in fs::read_dir(workspace().join("examples"))? {
        let path = entry?.path();
        if path.extension().is_some_and(|end| end == "toml") {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            cases.push(Case { name, text: fs::read_to_string(&path)?, path });
        }
    }
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    let path = folder.join("chain.toml");
    fs::write(&path, CHAIN)?;
    cases.insert(0, Case { name: FIRST.to_owned(), text: CHAIN.to_owned(), path });
    for (index, (name, text)) in BAD.iter().enumerate() {
        let path = folder.join(format!("bad{index}.toml"));
        fs::write(&path, text)?;
        cases.push(Case { name: (*name).to_owned(), path, text: (*text).to_owned() });
    }
    if few {
        cases.retain(|case| FEW.contains(&&*case.name));
    }
    Ok(cases)
}
