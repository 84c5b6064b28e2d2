//! The functions that generated code calls, from `libm` if that feature is on, else from `std`.

/// Writes one module for one type: each name with what it is called in `std` and in `libm`.
macro_rules! functions {
    ($real:ident: $($name:ident($($x:ident),+) = $std:ident | $libm:ident;)+) => {
        pub mod $real {
            #![allow(missing_docs)]
            $(
                #[cfg(feature = "libm")]
                #[inline]
                pub fn $name($($x: $real),+) -> $real {
                    libm::$libm($($x),+)
                }

                #[cfg(all(feature = "std", not(feature = "libm")))]
                #[inline]
                pub fn $name($($x: $real),+) -> $real {
                    $real::$std($($x),+)
                }

                // Absent, it would leave a caller with "cannot find function"; the bound that
                // nothing meets lets the compiler name the feature instead.
                #[cfg(not(any(feature = "std", feature = "libm")))]
                pub fn $name<R: super::Functions>($($x: R),+) -> R {
                    R::missing([$($x),+])
                }
            )+
        }
    };
}

functions! { f64:
    sqrt(x) = sqrt | sqrt;
    exp(x) = exp | exp;
    ln(x) = ln | log;
    sin(x) = sin | sin;
    cos(x) = cos | cos;
    tan(x) = tan | tan;
    atan(x) = atan | atan;
    sinh(x) = sinh | sinh;
    cosh(x) = cosh | cosh;
    tanh(x) = tanh | tanh;
    atanh(x) = atanh | atanh;
    asin(x) = asin | asin;
    acos(x) = acos | acos;
    cbrt(x) = cbrt | cbrt;
    pow(x, y) = powf | pow;
    mul_add(x, y, z) = mul_add | fma;
}

functions! { f32:
    sqrt(x) = sqrt | sqrtf;
    exp(x) = exp | expf;
    ln(x) = ln | logf;
    sin(x) = sin | sinf;
    cos(x) = cos | cosf;
    tan(x) = tan | tanf;
    atan(x) = atan | atanf;
    sinh(x) = sinh | sinhf;
    cosh(x) = cosh | coshf;
    tanh(x) = tanh | tanhf;
    atanh(x) = atanh | atanhf;
    asin(x) = asin | asinf;
    acos(x) = acos | acosf;
    cbrt(x) = cbrt | cbrtf;
    pow(x, y) = powf | powf;
    mul_add(x, y, z) = mul_add | fmaf;
}

/// Implemented for nothing: there are no functions without a feature.
#[cfg(not(any(feature = "std", feature = "libm")))]
#[diagnostic::on_unimplemented(
    message = "this controller calls a function such as sqrt, exp, ln or pow: enable the feature `std` or `libm` of the crate `ptc`",
    label = "its mapping needs a mathematical function"
)]
pub trait Functions: Sized {
    #[doc(hidden)]
    fn missing<const N: usize>(x: [Self; N]) -> Self;
}
