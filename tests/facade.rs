//! The types that all controllers share.

use core::error::Error as _;

use ptc::{Control, Controller, Error, Status};

/// u = -x_1/(t0 + 1 - t), written by hand.
#[derive(Clone, Debug)]
struct ByHand {
    t0: f32,
}

impl Controller<1> for ByHand {
    type Real = f32;

    fn arm(&mut self, t0: f32) -> Result<(), Error> {
        if !t0.is_finite() {
            return Err(Error::Param);
        }
        self.t0 = t0;
        Ok(())
    }

    fn step(&self, t: f32, x: &[f32; 1]) -> Result<Control<f32>, Error> {
        if t < self.t0 {
            return Err(Error::Input);
        }
        Ok(Control { u: -x[0] / (self.t0 + 1.0 - t), status: Status::Ok })
    }
}

/// The control after a restart at `t0`, for any controller.
fn restarted<C: Controller<N>, const N: usize>(
    mut controller: C,
    t0: C::Real,
    x: &[C::Real; N],
) -> Result<Control<C::Real>, Error>
where
    C::Real: Copy,
{
    controller.arm(t0)?;
    controller.step(t0, x)
}

#[test]
fn a_controller_is_used_through_the_trait() {
    let controller = ByHand { t0: 0.0 };
    let control = restarted(controller.clone(), 3.0, &[2.0]);
    assert_eq!(control, Ok(Control { u: -2.0, status: Status::Ok }));
    assert_eq!(restarted(controller.clone(), f32::NAN, &[2.0]), Err(Error::Param));
    assert_eq!(controller.step(-1.0, &[2.0]), Err(Error::Input));
}

#[test]
fn a_controller_is_used_without_its_type() {
    let mut erased: Box<dyn Controller<1, Real = f32>> = Box::new(ByHand { t0: 0.0 });
    assert_eq!(erased.arm(1.0), Ok(()));
    assert_eq!(erased.step(1.5, &[1.0]).map(|c| c.u), Ok(-2.0));
}

#[test]
fn errors_say_what_is_wrong() {
    for (error, text) in [
        (Error::Param, "a parameter is outside its domain"),
        (Error::Input, "x or t is not finite, or t is before t0"),
        (Error::Range, "u is not finite"),
        (Error::Soon, "no deadline so soon keeps the limits"),
    ] {
        assert_eq!(error.to_string(), text);
        assert!(error.source().is_none());
    }
}

#[test]
fn types_are_small_and_cross_threads() {
    fn crosses<T: Send + Sync + Unpin + 'static>() {}
    crosses::<Error>();
    crosses::<Control>();
    assert_eq!(size_of::<Result<Control<f32>, Error>>(), 8);
    assert_eq!(size_of::<Result<Control, Error>>(), 16);
}

#[cfg(any(feature = "std", feature = "libm"))]
#[test]
fn functions_are_those_of_the_field() {
    use ptc::math;

    // Exact in any implementation.
    assert_eq!(math::f64::sqrt(2.25), 1.5);
    assert_eq!(math::f64::exp(0.0), 1.0);
    assert_eq!(math::f64::ln(1.0), 0.0);
    assert_eq!(math::f64::pow(2.0, -3.0), 0.125);
    assert_eq!(math::f64::mul_add(3.0, 5.0, -7.0), 8.0);
    assert_eq!(math::f32::mul_add(3.0, 5.0, -7.0), 8.0);
    // One rounding: 1 - (1 + u)(1 - u) is u^2.
    let u = f64::EPSILON;
    assert_eq!(math::f64::mul_add(1.0 + u, u - 1.0, 1.0), u * u);
    assert_eq!(math::f32::sqrt(2.25), 1.5);
    assert_eq!(math::f32::exp(0.0), 1.0);
    assert_eq!(math::f32::ln(1.0), 0.0);
    assert_eq!(math::f32::pow(2.0, -3.0), 0.125);
    // Which is which: none of them is another's inverse or base.
    assert!((math::f64::exp(1.0) - core::f64::consts::E).abs() < 1e-15);
    assert!((math::f64::ln(10.0) - core::f64::consts::LN_10).abs() < 1e-15);
    assert!((math::f32::exp(1.0) - core::f32::consts::E).abs() < 1e-6);
    assert!((math::f32::ln(10.0) - core::f32::consts::LN_10).abs() < 1e-6);
}

/// The docs of the macro list every key and every family.
#[test]
fn the_docs_of_the_macro_are_whole() {
    let docs = include_str!("../src/lib.rs");
    let rows = docs.lines().filter_map(|line| line.strip_prefix("/// | `"));
    let told: Vec<_> = rows.filter_map(|row| row.split('`').next()).collect();
    assert_eq!(told, ptc_codegen::keys::KEYS.map(|info| info.key));
    let families = ptc_codegen::family::FAMILIES.each_ref().map(|f| format!("`{}`", f.name));
    assert!(docs.contains(&families.join(", ")), "{families:?}");
}
