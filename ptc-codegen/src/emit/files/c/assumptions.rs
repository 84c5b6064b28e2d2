//! Requirements of an emitted file on its compiler, as directives that reject any other.

use crate::parameter::Precision;

/// Directives that refuse a compiler whose numbers are others, or that may remove the guards.
/// `double` and `float` may have more digits than the standard asks for, or fewer; SDCC reads
/// `double` as `float`.
pub(in crate::emit) fn assumptions(precision: Precision) -> String {
    let (kind, prefix, digits, excess) = match precision {
        Precision::F64 => ("double", "DBL", 53, "(FLT_EVAL_METHOD == 2)"),
        Precision::F32 => ("float", "FLT", 24, "(FLT_EVAL_METHOD > 0) && (FLT_EVAL_METHOD < 3)"),
    };
    let (format, single, other) = match precision {
        Precision::F64 => (
            "binary64",
            "defined(__SDCC) || ",
            ": emit with --precision f32, or make double 64 bits wide",
        ),
        Precision::F32 => ("binary32", "", ""),
    };
    let finite = "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH";
    format!(
        "\
/* What this file requires of its compiler. */
#if {single}(defined({prefix}_MANT_DIG) && ({prefix}_MANT_DIG != {digits}))
#error \"{kind} is not IEEE 754 {format} here{other}\"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if {excess}
#error \"{kind} is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION\"
#endif
#endif
#if !defined(PTC_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error \"{finite}\"
#elif defined(__FINITE_MATH_ONLY__)
#if __FINITE_MATH_ONLY__ > 0
#error \"{finite}\"
#endif
#endif
#endif"
    )
}

/// Macros for the tests on numbers. They are those of `math.h`, except that MinGW's convert to a
/// shorter integer, which warns, and that some compilers have none.
pub(super) fn classification(precision: Precision, body: &str) -> String {
    let (abs, most, zero) = match precision {
        Precision::F64 => ("fabs", "DBL_MAX", "0.0"),
        Precision::F32 => ("fabsf", "FLT_MAX", "0.0f"),
    };
    let finite = (precision.finite_in_c("x"), "isfinite", format!("({abs}(x) <= {most})"));
    let not_number = (precision.nan_in_c("x"), "isnan", format!("(!({abs}(x) >= {zero}))"));
    let mut text = String::new();
    for (call, standard, own) in [finite, not_number] {
        let name = call.trim_end_matches("(x)");
        if body.contains(&format!("{name}(")) {
            text.push_str(&format!(
                "
#if !defined({name})
#if defined({standard}) && !defined(__MINGW32__)
#define {call} ({standard}(x) != 0)
#else
#define {call} {own}
#endif
#endif
"
            ));
        }
    }
    text
}
