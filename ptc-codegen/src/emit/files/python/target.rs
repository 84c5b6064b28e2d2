//! Python: one typed module on NumPy.

use super::super::{Language, Print, Target, refuse_class, refuse_fma};
use crate::parameter::type_name;

pub(in crate::emit) const TARGET: Target = Target {
    language: Language::Python,
    name: "python",
    about: "one typed module on NumPy, for batches of times and states",
    comment: ("# ", ""),
    is_word: |word| {
        WORDS.split_whitespace().any(|one| one == word)
            || CLASSES.split_whitespace().any(|one| one == type_name(word))
    },
    refuse: |spec, _, found| {
        refuse_class(spec, &[], found);
        refuse_fma(spec, "NumPy", found);
    },
    print: Print::Program(|program| vec![super::file(program)]),
};

/// Keywords, modules that one of this name would hide, and names whose class the module has already.
const WORDS: &str = "
    False None True and as assert async await break class continue def del elif else except finally
    for from global if import in is lambda nonlocal not or pass raise return try while with yield
    any array array_like callable int_enum named_tuple sequence cmath collections dataclasses enum math np numpy typing
";

/// The module's own classes and those that it imports: one of a controller would hide them.
const CLASSES: &str = "
    Array ArrayLike Callable Control Gains IntEnum NDArray NamedTuple None Params Rate Sequence Status Value
";
