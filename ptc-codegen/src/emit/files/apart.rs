//! Names in emitted C: nothing but the controller is called as the controller is.

use crate::emit::File;

/// A C file in which a variable or parameter with the name of the controller has an underscore
/// behind it. Members stay as they are: C keeps their names apart.
pub(in crate::emit) fn apart(file: File, name: &str) -> File {
    File { text: renamed(&file.text, name), ..file }
}

fn renamed(text: &str, name: &str) -> String {
    let words = words(text, name);
    // What contracts call so is renamed with what they speak of.
    if !words.iter().any(|word| word.is_code) {
        return text.to_owned();
    }
    let mut other = format!("{name}_");
    while !self::words(text, &other).is_empty() {
        other.push('_');
    }
    let (mut apart, mut end) = (String::with_capacity(text.len()), 0);
    for word in words {
        apart.push_str(&text[end..word.at]);
        apart.push_str(&other);
        end = word.at + name.len();
    }
    apart + &text[end..]
}

/// A place where something else than the controller's type or a member has its name.
struct Word {
    at: usize,
    /// True in code, false in a contract.
    is_code: bool,
}

/// All of them, in order.
fn words(text: &str, name: &str) -> Vec<Word> {
    let mut found = Vec::new();
    let (mut at, mut in_contract) = (0, false);
    // How many braces are open, and with how many of them open a struct is declared.
    let (mut depth, mut record) = (0, None);
    let mut before = ["", ""];
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = match c {
            '/' if rest.starts_with("/*@") || rest.starts_with("//@") => {
                in_contract = true;
                3
            }
            '*' if rest.starts_with("*/") => {
                in_contract = false;
                2
            }
            '/' if rest.starts_with("/*") => rest.find("*/").map_or(rest.len(), |end| end + 2),
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            '#' if rest.starts_with("#include") => rest.find('\n').unwrap_or(rest.len()),
            // The word of a directive.
            '#' => 1 + span(&rest[1..], is_letter),
            '"' | '\'' => quoted(rest, c),
            '0'..='9' => span(rest, |c| c.is_ascii_alphanumeric() || c == '.'),
            _ if is_letter(c) => {
                let length = span(rest, is_letter);
                let word = &rest[..length];
                let is_member = text[..at].ends_with(['.', '>']) || record == Some(depth);
                if word == name && !is_type(&text[..at], &rest[length..], before[1]) && !is_member {
                    found.push(Word { at, is_code: !in_contract });
                }
                before = [before[1], word];
                length
            }
            '{' => {
                depth += 1;
                if before[0] == "struct" {
                    record = Some(depth);
                }
                1
            }
            '}' => {
                record = record.filter(|of| *of != depth);
                depth -= 1;
                1
            }
            '\n' => {
                // A contract of one line.
                in_contract &= text[..at].lines().next_back().is_none_or(|l| !l.contains("//@"));
                1
            }
            _ => c.len_utf8(),
        };
        if !(is_letter(c) || c == ' ' || c == '{') {
            before = ["", ""];
        }
        at += length;
    }
    found
}

/// Returns true if the name between the texts is that of a type: a declaration follows, or ends with it.
fn is_type(before: &str, after: &str, last: &str) -> bool {
    let declared = after.strip_prefix(' ').map(|after| after.strip_prefix('*').unwrap_or(after));
    let begins = |text: &str| text.starts_with(|c| is_letter(c) && !c.is_ascii_digit());
    last == "struct" || before.ends_with("} ") || declared.is_some_and(begins)
}

fn is_letter(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

fn span(text: &str, belongs: impl Fn(char) -> bool) -> usize {
    text.find(|c| !belongs(c)).unwrap_or(text.len())
}

/// The length of a text or character in its quotes.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    let end = text.char_indices().skip(1).find(|(_, c)| {
        let ends = *c == quote && !escaped;
        escaped = *c == '\\' && !escaped;
        ends
    });
    end.map_or(text.len(), |(at, _)| at + quote.len_utf8())
}

#[cfg(test)]
mod tests {
    use super::renamed;

    #[test]
    fn only_variables_are_renamed() {
        for (name, given, wanted) in [
            (
                "x",
                "int f(const x *self, double x) { return x; }",
                "int f(const x *self, double x_) { return x_; }",
            ),
            (
                "x",
                "typedef struct x {\n    double x; /* x */\n} x;",
                "typedef struct x {\n    double x; /* x */\n} x;",
            ),
            ("x", "self->x = x * x1 * y.x;", "self->x = x_ * x1 * y.x;"),
            (
                "x",
                "struct x built; built.x = x; x built; f(\"x\", 'x');",
                "struct x built; built.x = x_; x built; f(\"x\", 'x');",
            ),
            ("x", "double x_ = x;", "double x_ = x__;"),
            ("define", "#define define 1\nint define;", "#define define_ 1\nint define_;"),
            ("h", "#include <math.h>\nint h;", "#include <math.h>\nint h_;"),
            ("U", "a = 0U; b = 1.5U; U = 3;", "a = 0U; b = 1.5U; U_ = 3;"),
            (
                "x",
                "/*@ requires \\valid(x);\n */\nint f(double x); // x",
                "/*@ requires \\valid(x_);\n */\nint f(double x_); // x",
            ),
            (
                "requires",
                "/*@ requires \\valid(x); */ int y;",
                "/*@ requires \\valid(x); */ int y;",
            ),
            ("x", "//@ split x;\nint x; /* x */", "//@ split x_;\nint x_; /* x */"),
            (
                "x",
                "const x_call call = { .x = x }; x_init(&x);",
                "const x_call call = { .x = x_ }; x_init(&x_);",
            ),
        ] {
            assert_eq!(renamed(given, name), wanted);
        }
    }
}
