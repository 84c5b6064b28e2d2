//! C++17: one header.

use super::super::c::refuse_macros;
use super::super::{Language, Print, Target, refuse_class};

pub(in crate::emit) const TARGET: Target = Target {
    language: Language::Cpp,
    name: "cpp",
    about: "one header, C++17 and constexpr",
    comment: ("/* ", " */"),
    is_word: |word| WORDS.split_whitespace().any(|one| one == word),
    refuse: |spec, _, found| {
        refuse_class(spec, &CLASSES, found);
        refuse_macros(spec, found);
    },
    print: Print::Program(|program| vec![super::file(program)]),
};

/// The words of C++17 and C++20 that are none of C or Rust.
const WORDS: &str = "
    and_eq bitand bitor char8_t char16_t char32_t concept consteval constinit const_cast co_await
    co_return co_yield decltype dynamic_cast mutable noexcept not_eq or_eq reinterpret_cast requires
    static_assert static_cast std thread_local wchar_t xor_eq
";

/// The header's own types: those beside the class, and those in it.
const CLASSES: [&str; 7] = ["Control", "Gains", "Params", "Rate", "State", "Status", "Value"];
