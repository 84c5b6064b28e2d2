//! The links of the pages.

use std::fs;
use std::path::Path;

/// Every link of a page leads to a file, and to a heading in it.
pub(super) fn lead_somewhere(path: &Path, page: &str) {
    let folder = path.parent().expect("a folder");
    let links = page.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    for link in links.filter(|link| !link.starts_with("http")) {
        let (file, heading) = link.split_once('#').unwrap_or((link, ""));
        let target = if file.is_empty() { path.to_owned() } else { folder.join(file) };
        assert!(target.is_file(), "{link} is not there");
        if heading.is_empty() {
            continue;
        }
        let text = fs::read_to_string(&target).expect("a page");
        let mut headings = text.lines().filter(|line| line.starts_with('#')).map(anchor);
        assert!(headings.any(|known| known == heading), "{link} is not there");
    }
}

/// The name by which a link finds a heading.
fn anchor(heading: &str) -> String {
    let text = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = text.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}
