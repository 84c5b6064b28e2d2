//! Controllers in samples in C and C++.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use ptc_assure::harness::cpp::{STRICT_CPP, cpp_compiler};
use ptc_codegen::code::{Access, Shape};

use super::super::{STRICT, c_compiler, run};
use super::{Design, answers};

const C_MAIN: &str = include_str!("../../../../../tests/support/bits.h");

const C_LOOP: &str = r#"
int main(void)
{
    char word[4];
    unsigned design = 0;
    uint32_t k;
    while (scanf("%3s", word) == 1) {
        switch (word[0]) {
        case 'D': if (scanf("%u", &design) != 1) return 4; break;
        case 'I': printf("I %d\n", inits[design]()); break;
        default:
            if (scanf("%" SCNu32, &k) != 1) return 4;
            if (word[0] == 'A') arms[design](k); else steps[design](k);
        }
    }
    return 0;
}
"#;

fn tables(count: usize) -> String {
    let list = |name| (0..count).map(|i| format!("{name}{i}")).collect::<Vec<_>>().join(", ");
    format!(
        "static int (*const inits[])(void) = {{{}}};\nstatic void (*const arms[])(uint32_t) = {{{}}};\n\
         static void (*const steps[])(uint32_t) = {{{}}};\n{C_LOOP}",
        list("init"),
        list("arm"),
        list("step")
    )
}

/// Statements of C that read the parameters into `p`.
fn c_parameters(design: &Design) -> String {
    let real = design.real();
    let each = design.parameters().map(|(name, shape)| match shape {
        Shape::Gains | Shape::Lists(..) | Shape::Statuses(_) => unreachable!("no parameter"),
        Shape::Count => format!("p.{name} = (uint32_t)number(); "),
        Shape::Real => format!("p.{name} = ({real})number(); "),
        Shape::Reals(n) => (0..n).map(|i| format!("p.{name}[{i}] = ({real})number(); ")).collect(),
    });
    each.collect()
}

pub(crate) fn in_c(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    let mut text = String::new();
    let mut main = C_MAIN.to_owned();
    for (i, design) in designs.iter().enumerate() {
        let (name, real, m) = (&design.code.name, design.real(), design.measured());
        writeln!(text, "#include \"{}\"", design.folder.join(format!("{name}.h")).display())
            .expect("a string");
        let given: String = design
            .given()
            .map(|(function, length)| match length {
                Some(n) => format!(
                    "{{ {real} e[{n}]; (void){name}_{}(&self{i}, e); for (int j = 0; j < {n}; j++) show((double)e[j]); }} ",
                    function.name
                ),
                None => format!(
                    "{{ {real} e; (void){name}_{}(&self{i}, &e); show((double)e); }} ",
                    function.name
                ),
            })
            .collect();
        let read = design.read_in_c();
        let shape = |count: usize, columns: Option<usize>| match columns {
            Some(columns) => format!("[{}][{columns}]", count / columns),
            None => format!("[{count}]"),
        };
        let (r, of_r) = match design.references() {
            0 => ("", String::new()),
            count => ("r, ", format!("{real} r{}; ", shape(count, design.row()))),
        };
        let shape = shape(m, design.columns());
        let step = match (design.observes(), design.code.axes()) {
            (true, _) => format!(
                "{real} u = ({real})number(); printf(\"S %d\", (int){name}_update(&self{i}, k, x, u));"
            ),
            (false, Some(m)) => format!(
                "{real} u[{m}]; ptc_status axes[{m}]; printf(\"S %d\", (int){name}_step(&self{i}, k, x, {r}u, axes)); \
                 for (int j = 0; j < {m}; j++) show((double)u[j]); for (int j = 0; j < {m}; j++) printf(\" %d\", (int)axes[j]);"
            ),
            (false, None) => format!(
                "{real} u = 77; printf(\"S %d\", (int){name}_step(&self{i}, k, x, {r}&u)); show((double)u);"
            ),
        };
        write!(
            main,
            "static {name} self{i};\n\
             static int init{i}(void) {{ {name}_params p; memset(&p, 0, sizeof p); {}return (int){name}_init(&self{i}, &p); }}\n\
             static void arm{i}(uint32_t k) {{ (void){name}_arm(&self{i}, k); }}\n\
             static void step{i}(uint32_t k) {{ {real} x{shape}; {of_r}{read}{step} {given}printf(\"\\n\"); }}\n",
            c_parameters(design)
        )
        .expect("a string");
    }
    fs::write(folder.join("main.c"), format!("{text}{main}{}", tables(designs.len()))).expect("C");
    let sources: Vec<_> =
        designs.iter().map(|d| d.folder.join(format!("{}.c", d.code.name))).collect();
    for source in &sources {
        run(c_compiler()
            .args(STRICT)
            .arg("-c")
            .arg(source)
            .arg("-o")
            .arg(source.with_extension("o")));
        if Command::new("clang").arg("--version").output().is_ok() {
            run(Command::new("clang").args(STRICT).arg("-fsyntax-only").arg(source));
        }
    }
    let objects = sources.iter().map(|source| source.with_extension("o"));
    let program = folder.join("in_c");
    run(c_compiler().arg(folder.join("main.c")).args(objects).arg("-o").arg(&program).arg("-lm"));
    Some(answers(&mut Command::new(program), folder))
}

pub(crate) fn in_cpp(folder: &Path, designs: &[Design]) -> Option<Vec<String>> {
    let mut text = String::new();
    let mut main = C_MAIN.to_owned();
    for (i, design) in designs.iter().enumerate() {
        let (name, real, m) = (&design.code.name, design.real(), design.measured());
        let kind = design.kind();
        let header = design.folder.join(format!("{name}.hpp"));
        writeln!(text, "#include \"{}\"", header.display()).expect("a string");
        let given: String = design
            .given()
            .map(|(function, length)| match length {
                Some(_) => {
                    format!("for (const auto e : self{i}.{}()) show(double(e)); ", function.name)
                }
                None => format!("show(double(self{i}.{}())); ", function.name),
            })
            .collect();
        let read = design.read_in_c();
        let array = |count: usize, columns: Option<usize>| match columns {
            Some(columns) => {
                format!("std::array<std::array<{real}, {columns}>, {}>", count / columns)
            }
            None => format!("std::array<{real}, {count}>"),
        };
        let (r, of_r) = match design.references() {
            0 => ("", String::new()),
            count => (", r", format!("{} r{{}}; ", array(count, design.row()))),
        };
        let array = array(m, design.columns());
        let step = match (design.observes(), design.code.axes()) {
            (true, _) => format!(
                "const auto u = static_cast<{real}>(number()); printf(\"S %d\", static_cast<int>(self{i}.update(k, x, u)));"
            ),
            (false, Some(_)) => format!(
                "const auto c = self{i}.step(k, x{r}); printf(\"S %d\", static_cast<int>(c.status)); \
                 for (const auto e : c.u) show(double(e)); for (const auto e : c.axes) printf(\" %d\", static_cast<int>(e));"
            ),
            (false, None) => format!(
                "const auto c = self{i}.step(k, x{r}); printf(\"S %d\", static_cast<int>(c.status)); show(double(c.u));"
            ),
        };
        write!(
            main,
            "static ptc::{kind} self{i};\n\
             static int init{i}() {{ ptc::{kind}Params p{{}}; {}return static_cast<int>(self{i}.init(p)); }}\n\
             static void arm{i}(uint32_t k) {{ self{i}.arm(k); }}\n\
             static void step{i}(uint32_t k) {{ {array} x{{}}; {of_r}{read}{step} {given}printf(\"\\n\"); }}\n",
            c_parameters(design)
        )
        .expect("a string");
    }
    let source = folder.join("main.cpp");
    fs::write(&source, format!("{text}{main}{}", tables(designs.len()))).expect("C++");
    let (strict, program) = (folder.join("strict.cpp"), folder.join("in_cpp"));
    fs::write(&strict, &text).expect("C++");
    run(cpp_compiler().args(STRICT_CPP).arg("-fsyntax-only").arg(&strict));
    if Command::new("clang++").arg("--version").output().is_ok() {
        run(Command::new("clang++").args(STRICT_CPP).arg("-fsyntax-only").arg(&strict));
    }
    let flags = ["-std=c++17", "-O1", "-ffp-contract=off"];
    run(cpp_compiler().args(flags).arg(&source).arg("-o").arg(&program));
    Some(answers(&mut Command::new(program), folder))
}
