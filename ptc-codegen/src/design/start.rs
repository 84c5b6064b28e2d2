//! Design files to begin with, one for each kind of plant: short, with units, and accepted as they are.

use super::template::literal;
use crate::keys::EVENT_KEYS;
use crate::keys::verify::{self, OBJECTIVE_KEYS};
use crate::keys::{KeyInfo, PLANT_KEYS};

/// Column of the comments, and the longest line that gets one.
const COLUMN: usize = 31;
const WIDTH: usize = 110;

/// A kind of plant, with its design.
///
/// A comment that ends with a colon is completed with the meaning of the line's key. A line without a comment gets
/// the meaning alone, where both fit into one line.
#[derive(Debug)]
pub struct Start {
    /// Name: the value of `--plant`.
    pub name: &'static str,
    text: &'static str,
    /// True for a chain of integrators: each measured state beyond x1 takes a pole of the observer.
    chain: bool,
}

/// All kinds of plants. The first is the default.
pub static STARTS: [Start; 4] = [
    Start { name: "stage", text: include_str!("../../templates/new/stage.toml"), chain: true },
    Start { name: "motor", text: include_str!("../../templates/new/motor.toml"), chain: false },
    Start {
        name: "flexible",
        text: include_str!("../../templates/new/flexible.toml"),
        chain: true,
    },
    Start { name: "model", text: include_str!("../../templates/new/model.toml"), chain: false },
];

impl Start {
    /// Returns the start called `name`.
    pub fn find(name: &str) -> Option<&'static Self> {
        STARTS.iter().find(|start| start.name == name)
    }

    /// Returns the description of the plant: the first line of its file.
    pub fn about(&self) -> &'static str {
        self.text.lines().next().unwrap_or_default().trim_start_matches(['#', ' '])
    }

    /// Returns the design file, called `stem`.toml, with `values` in place of those of these keys.
    pub fn design(&self, stem: &str, values: &[(&str, &str)]) -> String {
        let mut out = String::with_capacity(2 * self.text.len());
        let mut table = "";
        for line in self.text.lines() {
            if let Some(name) = line.strip_prefix('[') {
                table = name.trim_matches(['[', ']']);
            }
            match line.split_once(" = ") {
                Some(("observer_samples", count)) if !self.settles(count, values) => continue,
                Some((key, rest)) if !line.starts_with('#') => {
                    out.push_str(&self.pair(table, key, rest, values));
                }
                _ => out.push_str(&line.replace(&format!("{}.", self.name), &format!("{stem}."))),
            }
            out.push('\n');
        }
        out
    }

    /// Returns true if `count` samples of the observer are at most half of those to the deadline. More are left out,
    /// as half of them is the default.
    fn settles(&self, count: &str, values: &[(&str, &str)]) -> bool {
        let Some(tau) = given(values, "tau") else { return true };
        let period = self.text.lines().find_map(|line| line.strip_prefix("sample_time = "));
        let number = |text: &str| text.trim().parse::<f64>().ok();
        match (number(tau), period.and_then(number), number(count)) {
            (Some(tau), Some(period), Some(count)) => 2.0 * count * period <= tau,
            _ => false,
        }
    }

    /// Returns the line of a key.
    fn pair(&self, table: &str, key: &str, rest: &str, values: &[(&str, &str)]) -> String {
        let (old, comment) = rest.split_once("  # ").unwrap_or((rest, ""));
        let of_controller = !["verify", "objective"].contains(&table);
        let value = match (key, given(values, key).filter(|_| of_controller)) {
            (_, Some(text)) => written(key, old, text),
            ("observer_poles", None) if self.chain => {
                fewer(old, given(values, "measured").map_or(0, |text| text.matches(',').count()))
            }
            _ => old.to_owned(),
        };
        let line = format!("{key} = {value}");
        let told = match comment.strip_suffix(':') {
            Some(unit) => format!("{unit}: {}", brief(table, key)),
            None if comment.is_empty() => brief(table, key).to_owned(),
            None => comment.to_owned(),
        };
        let start = COLUMN.max(line.len() + 2);
        match told.is_empty() || (comment.is_empty() && start + told.len() > WIDTH) {
            true => line,
            false => format!("{line:start$}# {told}"),
        }
    }
}

/// Returns the value of a key that is given.
fn given<'a>(values: &[(&str, &'a str)], key: &str) -> Option<&'a str> {
    values.iter().find(|(name, _)| *name == key).map(|(_, text)| *text)
}

/// Returns the value of a key as text of TOML: a list where it was one.
fn written(key: &str, old: &str, text: &str) -> String {
    let info = KeyInfo::find(key);
    if !old.starts_with('[') {
        return literal(info, text);
    }
    let items = text.trim().trim_matches(['[', ']']).split(',');
    let items: Vec<_> = items.map(|item| literal(info, item.trim())).collect();
    format!("[{}]", items.join(", "))
}

/// Returns the list without its last `count` values.
fn fewer(list: &str, count: usize) -> String {
    let items: Vec<_> = list.trim_matches(['[', ']']).split(", ").collect();
    let kept = items.len().saturating_sub(count).max(1);
    format!("[{}]", items[..kept].join(", "))
}

/// Returns the meaning of a key in a few words, as far as the tables of keys know it.
fn brief(table: &str, key: &str) -> &'static str {
    let find = |keys: &'static [KeyInfo]| keys.iter().find(|info| info.key == key);
    let info = match table {
        "verify" => find(&verify::KEYS),
        "objective" => find(&OBJECTIVE_KEYS),
        "event" => find(&EVENT_KEYS),
        "plant" => find(&PLANT_KEYS).or_else(|| KeyInfo::find(key)),
        _ => KeyInfo::find(key),
    };
    info.map_or("", KeyInfo::brief)
}
