//! Lines of text, with their indent and where they break.

/// Lines that are indented as blocks open and close.
#[derive(Default)]
pub(in crate::emit) struct Lines {
    lines: Vec<String>,
    depth: usize,
    /// True if the last line opens a block.
    opened: bool,
}

/// Columns of a line.
const WIDTH: usize = 100;

impl Lines {
    /// A line at the present depth, or several, each with what it is indented further.
    pub(in crate::emit) fn line(&mut self, text: impl AsRef<str>) {
        for line in text.as_ref().split('\n') {
            let pad = if line.is_empty() { String::new() } else { "    ".repeat(self.depth) };
            self.lines.push(format!("{pad}{line}"));
        }
        self.opened = false;
    }

    /// An empty line, but behind the line that opens a block.
    pub(in crate::emit) fn gap(&mut self) {
        if !self.opened {
            self.line("");
        }
    }

    /// Returns true if `text` fits on a line at the present depth.
    pub(in crate::emit) fn has_room(&self, text: &str) -> bool {
        4 * self.depth + text.len() <= WIDTH
    }

    /// Words in as many lines as they need, each behind `prefix`.
    pub(in crate::emit) fn words(&mut self, prefix: &str, text: &str) {
        let mut line = String::new();
        for word in text.split_whitespace() {
            if !line.is_empty() && !self.has_room(&format!("{prefix}{line} {word}")) {
                self.line(format!("{prefix}{line}"));
                line.clear();
            }
            line.push_str(if line.is_empty() { "" } else { " " });
            line.push_str(word);
        }
        self.line(format!("{prefix}{line}"));
    }

    /// `parts` between `before` and `behind`: in one line, or a line for each part, with `joint`
    /// between them.
    pub(in crate::emit) fn joined(
        &self,
        before: &str,
        parts: &[String],
        (and, joint): (&str, &str),
        behind: &str,
    ) -> String {
        let line = format!("{before}{}{behind}", parts.join(&format!(" {and} ")));
        match self.has_room(&line) || parts.len() < 2 {
            true => line,
            false => format!("{before}{}{behind}", parts.join(joint)),
        }
    }

    /// `items` between `before` and `behind`, in as many lines as they need.
    #[cfg(feature = "files")]
    pub(in crate::emit) fn list(&self, before: &str, items: &[String], behind: &str) -> String {
        let line = format!("{before}{}{behind}", items.join(", "));
        if self.has_room(&line) {
            return line;
        }
        format!("{before}\n    {},\n{behind}", items.join(",\n    "))
    }

    /// A line behind which a block opens.
    pub(in crate::emit) fn open(&mut self, text: impl AsRef<str>) {
        self.line(text);
        self.depth += 1;
        self.opened = true;
    }

    /// Ends a block with a line.
    pub(in crate::emit) fn close(&mut self, text: impl AsRef<str>) {
        self.depth = self.depth.saturating_sub(1);
        self.line(text);
    }

    /// Ends a block without a line.
    pub(in crate::emit) fn leave(&mut self) {
        self.depth = self.depth.saturating_sub(1);
    }

    /// Ends a block and opens the next one, with a line between them.
    pub(in crate::emit) fn turn(&mut self, text: impl AsRef<str>) {
        self.close(text);
        self.depth += 1;
        self.opened = true;
    }

    /// The place of the next line.
    pub(in crate::emit) fn here(&self) -> usize {
        self.lines.len()
    }

    /// Puts `before` and `behind` around the lines since `here`, in one line where they are no longer
    /// than `width` together.
    pub(in crate::emit) fn wrap(&mut self, here: usize, before: &str, behind: &str, width: usize) {
        let parts: Vec<_> = self.lines[here..].iter().map(|line| line.trim()).collect();
        let one = parts.join(" ");
        if one.len() <= width && !one.contains(';') {
            self.lines.truncate(here);
            return self.line(format!("{before}{one}{behind}"));
        }
        if let Some(first) = self.lines.get_mut(here) {
            let pad = " ".repeat(first.len() - first.trim_start().len());
            *first = format!("{pad}{before}{}", first.trim_start());
        }
        if let Some(last) = self.lines.last_mut() {
            last.push_str(behind);
        }
    }

    /// The text.
    pub(in crate::emit) fn text(&self) -> String {
        super::super::super::tidy(&self.lines.join("\n"))
    }
}
