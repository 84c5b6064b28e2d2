//! Measured cost of a step on a target, for the head of the emitted files.

/// The cost of one call of `step` on one target.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Measured {
    /// The target.
    pub target: String,
    /// Most instructions of a call, library functions included.
    pub instructions: u64,
    /// Bytes of stack that `step` itself takes.
    pub stack: u64,
    /// Bytes of code of `step` itself.
    pub code: u64,
    /// The command line of the controller, [`Spec::command`](crate::request::Spec::command).
    pub command: String,
}

/// Heads of the columns of a table of costs, whose columns tabs separate.
pub const HEAD: &str = "target\tinstructions\tstack\tcode\tcommand";

impl Measured {
    /// A line of a table of costs.
    pub fn line(&self) -> String {
        let Self { target, instructions, stack, code, command } = self;
        format!("{target}\t{instructions}\t{stack}\t{code}\t{command}")
    }

    /// The costs in a table.
    ///
    /// # Errors
    /// The first line that is not of the table, from 1, and what it lacks.
    pub fn table(text: &str) -> Result<Vec<Self>, String> {
        let mut lines = text.lines().enumerate();
        match lines.next() {
            Some((_, HEAD)) => {}
            _ => return Err(format!("line 1 is not `{}`", HEAD.replace('\t', " "))),
        }
        lines
            .map(|(index, line)| {
                Self::read(line).map_err(|lacks| format!("line {}: {lacks}", index + 1))
            })
            .collect()
    }

    fn read(line: &str) -> Result<Self, String> {
        let mut cells = line.splitn(5, '\t');
        let mut cell = |what: &str| cells.next().ok_or(format!("no {what}"));
        let target = cell("target")?.to_owned();
        // It is printed in comments of every language.
        let plain = |c: char| c.is_ascii_alphanumeric() || " ._+-".contains(c);
        if target.is_empty() || target.len() > 64 || !target.chars().all(plain) {
            return Err(format!(
                "target `{target}` is not 1..=64 letters, digits, spaces, `.`, `_`, `+` and `-`"
            ));
        }
        let mut number = |what: &str| {
            let text = cell(what)?;
            text.parse().map_err(|_| format!("{what} `{text}` is not a whole number"))
        };
        let (instructions, stack, code) =
            (number("instructions")?, number("stack")?, number("code")?);
        Ok(Self { target, instructions, stack, code, command: cell("command")?.to_owned() })
    }

    /// As a line of the head.
    #[cfg(feature = "files")]
    pub(crate) fn told(&self) -> String {
        let Self { target, instructions, stack, code, .. } = self;
        format!(
            "  {target}: {instructions} instructions, {stack} bytes of stack, {code} bytes of code"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cost_table_round_trips() {
        let one = Measured {
            target: "Cortex-M0".to_owned(),
            instructions: 3704,
            stack: 96,
            code: 512,
            command: "--n 3 --mu exp".to_owned(),
        };
        let table = Measured::table(&format!("{HEAD}\n{}\n", one.line()));
        assert_eq!(table, Ok(vec![one]));
    }

    #[test]
    fn invalid_cost_line_is_reported() {
        assert_eq!(
            Measured::table(&format!("{HEAD}\nCortex-M0\tmany\t1\t2\t--n 3\n")),
            Err("line 2: instructions `many` is not a whole number".to_owned())
        );
        assert_eq!(Measured::table(&format!("{HEAD}\nx\t1")), Err("line 2: no stack".to_owned()));
        for target in ["", "M0 */ system(0); /*", "M0 *)", "M0\"\"\"", "a\r", &"x".repeat(65)] {
            let wrong = Measured::table(&format!("{HEAD}\n{target}\t1\t1\t1\t--n 3\n"));
            assert!(wrong.is_err_and(|wrong| wrong.contains("is not 1..=64 letters")), "{target}");
        }
        assert!(Measured::table("").is_err());
    }
}
