//! The words of Structured Text.

/// Words that no name is.
const KEYWORDS: [&str; 37] = [
    "CONSTANT",
    "TYPE",
    "END_TYPE",
    "STRUCT",
    "END_STRUCT",
    "ARRAY",
    "OF",
    "FUNCTION",
    "END_FUNCTION",
    "FUNCTION_BLOCK",
    "END_FUNCTION_BLOCK",
    "VAR",
    "VAR_INPUT",
    "VAR_OUTPUT",
    "VAR_IN_OUT",
    "VAR_TEMP",
    "END_VAR",
    "IF",
    "THEN",
    "ELSIF",
    "ELSE",
    "END_IF",
    "FOR",
    "TO",
    "BY",
    "DO",
    "END_FOR",
    "RETURN",
    "EXIT",
    "NOT",
    "AND",
    "OR",
    "XOR",
    "MOD",
    "TRUE",
    "FALSE",
    "BOOL",
];

/// A word with its line.
#[derive(Clone, Debug)]
pub(super) struct Word {
    pub(super) text: String,
    pub(super) line: usize,
}

impl Word {
    /// Returns true for a name: a letter or an underscore first, no two underscores in a row and none at the end.
    pub(super) fn is_name(&self) -> bool {
        let starts = self.text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
        starts
            && !self.text.contains(['#', '.'])
            && !self.text.contains("__")
            && !self.text.ends_with('_')
            && !KEYWORDS.contains(&self.text.to_uppercase().as_str())
    }

    /// Returns true for a literal, with its type or without.
    pub(super) fn is_literal(&self) -> bool {
        self.text == "TRUE"
            || self.text == "FALSE"
            || self.value().is_some_and(|value| {
                let digits = value.trim_start_matches('-');
                digits.starts_with(|c: char| c.is_ascii_digit()) && digits.parse::<f64>().is_ok()
            })
    }

    /// Returns true if a literal with a point is 0, or of a size in a range.
    pub(super) fn is_within(&self, [least, most]: [f64; 2]) -> bool {
        let value = self.value().filter(|value| value.contains('.'));
        let size = value.and_then(|value| value.parse::<f64>().ok()).map(f64::abs);
        size.is_none_or(|size| size == 0.0 || (least..=most).contains(&size))
    }

    /// The number of a literal.
    fn value(&self) -> Option<&str> {
        match self.text.split_once('#') {
            Some((of, value)) => {
                ["REAL", "LREAL", "INT", "DINT", "UDINT"].contains(&of).then_some(value)
            }
            None => Some(&self.text),
        }
    }
}

/// Cuts a text into words, without comments.
///
/// # Errors
/// A character that no word begins with, or a comment without an end.
pub(super) fn words(text: &str) -> Result<Vec<Word>, String> {
    let (mut rest, mut line, mut all) = (text, 1, Vec::new());
    while let Some(first) = rest.chars().next() {
        let length = match rest {
            _ if first.is_whitespace() => first.len_utf8(),
            _ if rest.starts_with("(*") => {
                let end =
                    rest.find("*)").ok_or(format!("line {line}: a comment without an end"))?;
                // Comments of the second edition do not nest.
                if rest[2..end].contains("(*") {
                    return Err(format!("line {line}: a comment in a comment"));
                }
                end + 2
            }
            _ => {
                let length =
                    length(rest).ok_or(format!("line {line}: `{first}` begins no word"))?;
                all.push(Word { text: rest[..length].to_owned(), line });
                length
            }
        };
        line += rest[..length].matches('\n').count();
        rest = &rest[length..];
    }
    Ok(all)
}

/// The length of the word at the beginning of a text.
fn length(text: &str) -> Option<usize> {
    let first = text.chars().next()?;
    if [":=", "..", "<=", ">=", "<>"].iter().any(|sign| text.starts_with(sign)) {
        return Some(2);
    }
    if "();:,.[]+-*/=<>&".contains(first) {
        return Some(1);
    }
    if first.is_ascii_digit() {
        return Some(number(text));
    }
    if !first.is_ascii_alphabetic() && first != '_' {
        return None;
    }
    let name = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(text.len());
    let Some(value) = text[name..].strip_prefix('#') else { return Some(name) };
    let sign = usize::from(value.starts_with('-'));
    Some(name + 1 + sign + number(&value[sign..]))
}

/// The length of a number: digits, a point with digits, an exponent.
fn number(text: &str) -> usize {
    let digits = |from: usize| from + text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let mut end = digits(0);
    // 1..2 is a range.
    if text[end..].starts_with('.') && digits(end + 1) > end + 1 {
        end = digits(end + 1);
        if text[end..].starts_with(['E', 'e']) {
            let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
            end = digits(end + 1 + sign);
        }
    }
    end
}
