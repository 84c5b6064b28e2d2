//! The catalogue: published controllers as design files, the folder `catalogue/` of this crate. What is
//! known of each paper is in the head of its file.

use serde_json::{Map, Value, json};

/// A published controller.
#[derive(Debug)]
pub(crate) struct Entry {
    /// Its name: that of the file before `.toml`.
    pub(crate) name: &'static str,
    /// The design file.
    pub(crate) design: &'static str,
}

macro_rules! entries {
    ($($name:literal)*) => {
        [$(Entry {
            name: $name,
            design: include_str!(concat!("../../catalogue/", $name, ".toml")),
        }),*]
    };
}

/// The controllers, in the order of their names.
pub(crate) static ENTRIES: [Entry; 22] = entries![
    "arbitrary_time"
    "bounded_gain"
    "consensus"
    "delay_free"
    "disturbance"
    "double_integrator"
    "dynamic_high_gain"
    "euler_lagrange"
    "example1"
    "example4"
    "example4_boxes"
    "least_settling_bound"
    "linear_decay"
    "minimum_energy"
    "nonlinear_feedback"
    "output_feedback"
    "parametric_lyapunov"
    "power_scaling"
    "predefined_arctan"
    "predefined_exponential"
    "prescribed_observer"
    "time_base_generator"
];

/// Fields of a paper in the head of a file, in this order. Each file has the authors, the year, and one of `exact`,
/// what is an instance of what, and `adapted`, what differs from the paper.
const FIELDS: [&str; 9] =
    ["authors", "year", "title", "published", "doi", "arxiv", "where", "exact", "adapted"];

impl Entry {
    /// The controller called `name`.
    pub(crate) fn find(name: &str) -> Option<&'static Self> {
        ENTRIES.iter().find(|entry| entry.name == name)
    }

    /// The lines of the head, without their `# `.
    fn head(&self) -> impl Iterator<Item = &'static str> {
        self.design.lines().map_while(|line| line.strip_prefix('#')).map(str::trim_start)
    }

    /// Returns the description of the controller, in a sentence.
    fn summary(&self) -> &'static str {
        self.head().next().unwrap_or_default()
    }

    /// The command that shows what it does.
    fn command(&self) -> &'static str {
        self.head().find(|line| line.starts_with("ptc-codegen ")).unwrap_or_default()
    }

    /// Returns the known data of the paper: fields with their text.
    fn paper(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.head().filter_map(|line| line.split_once(": ")).filter(|(key, _)| FIELDS.contains(key))
    }

    /// The design file for a controller and a file called `stem`; its name is that of the controller
    /// where `named`.
    pub(crate) fn design(&self, stem: &str, named: bool) -> String {
        let own = format!("{}.toml", self.name);
        let mut text = String::with_capacity(self.design.len());
        for line in self.design.lines() {
            match line.strip_prefix("name = ") {
                Some(_) if named => text.push_str(&format!("name = \"{stem}\"")),
                _ if line.starts_with('#') => {
                    text.push_str(&line.replace(&own, &format!("{stem}.toml")));
                }
                _ => text.push_str(line),
            }
            text.push('\n');
        }
        text
    }
}

/// The catalogue as text.
pub(crate) fn text() -> String {
    let mut out = String::from(
        "Published controllers; `ptc-codegen new --from NAME` writes a design file.\n",
    );
    for entry in &ENTRIES {
        out.push_str(&format!("\n{}\n  {}\n", entry.name, entry.summary()));
        for (key, text) in entry.paper() {
            out.push_str(&format!("  {key:<11}{text}\n"));
        }
    }
    out
}

/// The catalogue as JSON.
pub(crate) fn json() -> Value {
    let entry = |entry: &Entry| {
        let mut fields = Map::new();
        fields.insert("name".to_owned(), json!(entry.name));
        fields.insert("summary".to_owned(), json!(entry.summary()));
        fields.extend(entry.paper().map(|(key, text)| (key.to_owned(), json!(text))));
        fields.insert("command".to_owned(), json!(entry.command()));
        Value::Object(fields)
    };
    json!({"catalogue": ENTRIES.iter().map(entry).collect::<Vec<_>>()})
}
