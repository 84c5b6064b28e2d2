//! Contents of the file of a function block: its data types, its functions, and the block.

use super::super::text::Lines;

/// A function block with all that it needs.
pub(in crate::emit) struct Library {
    pub(in crate::emit) vectors: Vec<Vector>,
    pub(in crate::emit) structures: Vec<Structure>,
    pub(in crate::emit) functions: Vec<Unit>,
    pub(in crate::emit) block: Unit,
}

/// A structured data type.
pub(in crate::emit) struct Structure {
    pub(in crate::emit) name: String,
    pub(in crate::emit) members: Vec<Member>,
}

/// An array type with indices from 1 to its lengths. Arrays have named types, for IEC 61131-3 makes
/// each anonymous type a type of its own, to which no variable can be assigned.
pub(in crate::emit) struct Vector {
    pub(in crate::emit) name: String,
    /// One length, or the numbers of rows and columns.
    pub(in crate::emit) lengths: Vec<usize>,
    pub(in crate::emit) of: &'static str,
}

/// A variable, or a member of a structure.
pub(in crate::emit) struct Member {
    pub(in crate::emit) name: String,
    pub(in crate::emit) kind: Kind,
    /// Description; empty where the name suffices.
    pub(in crate::emit) about: String,
}

/// The type of a variable.
pub(in crate::emit) enum Kind {
    Elementary(&'static str),
    Derived(String),
    /// A number of this type, and its value.
    Number(&'static str, String),
    /// An array from 0 on of these numbers.
    Table(&'static str, Vec<String>),
}

/// A function, which returns a value, or a function block.
pub(in crate::emit) struct Unit {
    pub(in crate::emit) name: String,
    pub(in crate::emit) about: String,
    pub(in crate::emit) returns: Option<&'static str>,
    pub(in crate::emit) sections: Vec<Section>,
    /// Its statements, without a newline at the end.
    pub(in crate::emit) body: String,
}

/// Variables that are declared together.
pub(in crate::emit) struct Section {
    pub(in crate::emit) scope: Scope,
    pub(in crate::emit) members: Vec<Member>,
}

/// Who sees a variable, and how long it is kept.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::emit) enum Scope {
    Input,
    Output,
    Constant,
    Local,
    Temporary,
}

impl Member {
    pub(super) fn new(name: impl Into<String>, kind: Kind, about: impl Into<String>) -> Self {
        Self { name: name.into(), kind, about: about.into() }
    }

    /// A variable of an elementary type, whose name says what it is.
    pub(super) fn plain(name: &str, kind: &'static str) -> Self {
        Self::new(name, Kind::Elementary(kind), "")
    }

    fn line(&self) -> String {
        let declared = match &self.kind {
            Kind::Elementary(kind) => format!("{} : {kind};", self.name),
            Kind::Derived(kind) => format!("{} : {kind};", self.name),
            Kind::Number(kind, value) => format!("{} : {kind} := {value};", self.name),
            Kind::Table(of, numbers) => {
                let (name, last) = (&self.name, numbers.len() - 1);
                format!("{name} : ARRAY[0..{last}] OF {of} := [\n    {}];", numbers.join(",\n    "))
            }
        };
        match self.about.is_empty() {
            true => declared,
            false => format!("{declared} (* {} *)", self.about),
        }
    }
}

impl Scope {
    fn word(self) -> &'static str {
        match self {
            Self::Input => "VAR_INPUT",
            Self::Output => "VAR_OUTPUT",
            Self::Constant => "VAR CONSTANT",
            Self::Local => "VAR",
            Self::Temporary => "VAR_TEMP",
        }
    }
}

impl Unit {
    fn print(&self, out: &mut Lines) {
        let (word, returns) = match self.returns {
            Some(kind) => ("FUNCTION", format!(" : {kind}")),
            None => ("FUNCTION_BLOCK", String::new()),
        };
        out.line(format!("{word} {}{returns}", self.name));
        for Section { scope, members } in &self.sections {
            out.open(scope.word());
            members.iter().for_each(|member| out.line(member.line()));
            out.close("END_VAR");
        }
        if self.returns.is_none() {
            out.line("");
        }
        out.line(&self.body);
        out.line(format!("END_{word}"));
    }
}

impl Library {
    /// The file in Structured Text, what the block is at its head.
    pub(super) fn text(&self) -> String {
        let mut out = Lines::default();
        out.line("(*");
        self.block.about.lines().for_each(|line| out.line(format!("  {line}")));
        out.line("*)\n");
        for Vector { name, lengths, of } in &self.vectors {
            let ranges: Vec<_> = lengths.iter().map(|length| format!("1..{length}")).collect();
            let ranges = ranges.join(", ");
            out.line(format!("TYPE {name} : ARRAY[{ranges}] OF {of}; END_TYPE\n"));
        }
        for Structure { name, members } in &self.structures {
            out.line(format!("TYPE {name} :"));
            out.open("STRUCT");
            members.iter().for_each(|member| out.line(member.line()));
            out.close("END_STRUCT;\nEND_TYPE\n");
        }
        for function in &self.functions {
            out.line(format!("(* {} *)", function.about));
            function.print(&mut out);
            out.line("");
        }
        self.block.print(&mut out);
        out.text()
    }
}
