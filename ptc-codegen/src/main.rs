//! wip
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let f = ptc_codegen::mapping::FAMILIES.iter().find(|f| f.name == a[2]).unwrap().family;
    let mut s = ptc_codegen::spec::Spec::new(a[1].parse().unwrap(), f);
    if a[3] == "none" { s.guard = ptc_codegen::spec::Guard::None; s.fixed.insert(ptc_codegen::spec::Parameter::UMax, ptc_codegen::spec::Fixed::Infinite); }
    if a[3] == "f32" { s.precision = ptc_codegen::spec::Precision::F32; }
    for f in ptc_codegen::generate(&s, ptc_codegen::emit::Language::C).unwrap() { std::fs::write(format!("{}/{}", a[4], f.name), f.text).unwrap(); }
}
