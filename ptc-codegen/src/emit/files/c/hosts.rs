//! Names that headers of C's hosts define as macros, which would take the place of a parameter.

use super::super::names;
use crate::diagnostic::Diagnostics;
use crate::request::Spec;

/// Macros, and the headers that define them.
const MACROS: [(&str, &str); 6] = [
    ("complex.h", "I complex imaginary"),
    ("errno.h", "EDOM EILSEQ EINVAL EIO ERANGE errno"),
    ("stdio.h", "BUFSIZ EOF stderr stdin stdout"),
    (
        "windows.h",
        "CALLBACK CONST ERROR FALSE IN OPTIONAL OUT TRUE VOID cdecl far huge near pascal small",
    ),
    (
        "Arduino.h",
        "BIN DEC DEFAULT EULER EXTERNAL F HEX HIGH INPUT INTERNAL LOW LSBFIRST MSBFIRST OCT OUTPUT RAD_TO_DEG SERIAL SP SPH SPL",
    ),
    ("float.h", "DECIMAL_DIG"),
];

/// Prefixes of the macros of `math.h` and `float.h`.
const PREFIXES: [&str; 5] = ["DBL_", "FLT_", "FP_", "LDBL_", "MATH_"];

/// The header that defines a macro of this name.
fn header(word: &str) -> Option<&'static str> {
    let listed = MACROS.iter().find(|(_, words)| words.split(' ').any(|one| one == word));
    let binary = word.strip_prefix('B').is_some_and(|digits| {
        (1..=8).contains(&digits.len()) && digits.bytes().all(|digit| matches!(digit, b'0' | b'1'))
    });
    let begins = PREFIXES.iter().any(|prefix| word.starts_with(prefix));
    match (listed, binary, begins) {
        (Some((header, _)), ..) => Some(header),
        (None, true, _) => Some("Arduino.h"),
        (None, false, true) => Some("math.h or float.h"),
        (None, false, false) => None,
    }
}

/// Notes names that a header would replace in C and C++.
pub(in crate::emit) fn refuse_macros(spec: &Spec, found: &mut Diagnostics) {
    for (key, word) in names(spec) {
        if let Some(header) = header(&word) {
            found.push(
                "reserved-name",
                key,
                None,
                format!("{word} is a macro of {header}, which would replace it"),
                format!("give it another name, for example {word}_1"),
            );
        }
    }
}
