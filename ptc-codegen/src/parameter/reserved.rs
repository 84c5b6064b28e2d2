//! Words that cannot name a controller.

/// Keywords of C, C++ and Rust, and the names that all controllers share.
const RESERVED: &str = "
    abstract alignas alignof and as asm async auto await become bool box break case catch char
    class compl const constexpr continue crate default delete do double dyn else enum explicit
    export extern false final float fn for friend gen goto if impl in inline int let long loop
    macro main match mod move mut mutable namespace new not nullptr operator or override priv
    private protected ptc ptc_status pub public ref register restrict return self Self short
    signed sizeof static struct super switch template this throw trait true try type typedef
    typeid typename typeof union unsafe unsigned unsized use using virtual void volatile where
    while xor yield
";

/// What C's `stddef.h` and `math.h` define as macros.
const DECLARED: &str = "NULL NAN INFINITY HUGE_VAL";

/// Functions of C's `math.h`, each of which also exists with the suffixes `f` and `l`.
const FUNCTIONS: &str = "
    acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh drem erf erfc exp exp10 exp2
    expm1 fabs fdim finite floor fma fmax fmin fmod frexp gamma hypot ilogb isfinite isinf isnan j0 j1 jn
    ldexp lgamma llrint llround log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter
    nexttoward pow pow10 remainder remquo rint round scalb scalbln scalbn signbit significand sin
    sincos sinh sqrt tan tanh tgamma trunc y0 y1 yn
";

/// Headers of C and modules of Python, for which a controller's own files would be taken.
const FILES: &str = "
    assert complex ctype dataclasses errno fenv inttypes iso646 limits locale math numpy ptc setjmp
    signal stdarg stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time
    typing uchar wchar wctype
";

/// What the names of all statuses begin with.
const STATUS: &str = "PTC_";

/// Types beside the controller's own in an emitted Rust file, and a trait it uses.
const TYPES: [&str; 6] = ["Control", "Controller", "Error", "FnOnce", "Result", "Status"];

/// Whether `word` is a keyword, or a name that C's headers declare as a macro.
pub(super) fn is_word(word: &str) -> bool {
    RESERVED.split_whitespace().any(|one| one == word)
        || word.starts_with(STATUS)
        || DECLARED.split_whitespace().any(|one| one == word)
}

/// Whether `word` cannot name a controller.
pub(crate) fn is_reserved(word: &str) -> bool {
    reason(word).is_some()
}

/// Why `word`, an identifier, cannot name a controller; `None` if it can.
pub(crate) fn reason(word: &str) -> Option<&'static str> {
    let among = |words: &str, word: &str| words.split_whitespace().any(|one| one == word);
    let stem = word.strip_suffix(['f', 'l']).unwrap_or(word);
    let reasons = [
        (word.starts_with('_'), "C reserves names that begin with an underscore"),
        (word.ends_with("_t"), "POSIX reserves names that end in _t"),
        (is_word(word), "it is a word of C, C++ or Rust, or what all controllers share"),
        (among(FUNCTIONS, word) || among(FUNCTIONS, stem), "it is a function of C's math.h"),
        (among(FILES, word), "its files would take the place of a header or module of that name"),
        (
            TYPES.contains(&super::type_name(word).as_str()),
            "its type would have the name of another one in Rust",
        ),
    ];
    reasons.into_iter().find(|(applies, _)| *applies).map(|(_, reason)| reason)
}

#[cfg(test)]
mod tests {
    use super::is_reserved;

    #[test]
    fn names_that_would_not_compile_are_reserved() {
        for word in [
            "int",
            "fn",
            "_x",
            "__",
            "exp",
            "expf",
            "sqrtl",
            "size_t",
            "status",
            "Error",
            "fn_once",
            "self",
            "stdint",
            "math",
            "PTC_STATUS_DEFINED",
            "PTC_OK",
        ] {
            assert!(is_reserved(word), "{word}");
        }
        for word in [
            "roll", "ptc_exp3", "stage", "x_f", "Roll2", "state", "shelf", "level", "x1", "t",
            "inv_T", "gains",
        ] {
            assert!(!is_reserved(word), "{word}");
        }
    }
}
