// What a generated controller calls where its mapping needs a function, and no feature gives it.
fn main() {
    let _ = ptc::math::f64::sqrt(1.0_f64);
    let _ = ptc::math::f32::pow(1.0_f32, 2.0_f32);
}
