//! `emit --acsl`: the files of a proof, and what refuses it.

use crate::support;

use std::fs;
use std::process::Output;

use support::folder;

fn run(arguments: &[&str]) -> Output {
    support::command(arguments).output().expect("it runs")
}

/// The files that `flags` write into a folder of `test`, by name.
fn emitted(test: &str, flags: &[&str]) -> Vec<(String, String)> {
    let folder = folder(test);
    let place = folder.to_str().expect("UTF-8");
    let output = run(&[&["emit", "--lang=c", "-o", place], flags].concat());
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{flags:?}: {told}");
    let mut files: Vec<_> = fs::read_dir(&folder)
        .expect("a folder")
        .map(|entry| {
            let entry = entry.expect("an entry");
            let text = fs::read_to_string(entry.path()).expect("a text");
            (entry.file_name().to_string_lossy().into_owned(), text)
        })
        .collect();
    files.sort();
    files
}

/// The lines of a text without comments of ACSL, empty lines, and the guard, which is a hash of the whole text.
fn bare(text: &str) -> Vec<String> {
    let mut parts = text.split("/*@");
    let mut kept = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        kept.push_str(part.split_once("*/").expect("a comment that ends").1);
    }
    let guard = |line: &str| line.starts_with('#') && line.ends_with("_H");
    let lines = kept.lines().map(str::trim_end).filter(|line| !line.is_empty() && !guard(line));
    lines.map(str::to_owned).collect()
}

const DESIGNS: [&[&str]; 12] = [
    &["--n=3", "--mu=exp"],
    &["--n=2", "--mu=exp_sum", "--precision=f32"],
    &["--n=2", "--mu=exp_sum(rates=[0.5,1.5])"],
    &["--n=3", "--mu=tan", "--guard=result"],
    &["--n=1", "--mu=tanh", "--guard=none", "--u-max=inf"],
    &["--n=2", "--mu=exp", "--what=associated", "--pi0=extern"],
    &["--n=2", "--mu=exp", "--pi0=extern", "--after=extern"],
    &["--n=1", "--mu=exp", "--pi0=-20*xi1/(1.1*abs(xi1_0)+1)^2"],
    &["--n=1", "--mu=exp(a=1)", "--gains=2", "--tau=1", "--t0=0", "--eps=0.01", "--u-max=5"],
    &["--n=3", "--mu=exp", "--clock=samples", "--delay=1", "--guard=none"],
    &[
        "--n=2",
        "--mu=exp(a=1)",
        "--clock=samples",
        "--measured=x1",
        "--disturbance=constant",
        "--observer-poles=-4,-5,-6",
    ],
    &[
        "--what=observer",
        "--n=2",
        "--mu=exp(a=1)",
        "--clock=samples",
        "--measured=x1",
        "--observer-poles=-4,-5",
        "--observer-samples=9",
    ],
];

#[test]
fn what_is_proved_is_what_is_compiled() {
    for (index, design) in DESIGNS.iter().enumerate() {
        let plain = emitted(&format!("plain{index}"), design);
        let proof = emitted(&format!("proof{index}"), &[&["--acsl"], *design].concat());
        assert_eq!((plain.len(), proof.len()), (2, 3), "{design:?}");
        for (name, text) in &plain {
            let (_, annotated) = proof.iter().find(|(other, _)| other == name).expect("the file");
            assert_eq!(bare(annotated), bare(text), "{design:?}: {name}");
            assert!(!text.contains("/*@"), "{design:?}: {name}");
        }
        let header = &proof.iter().find(|(name, _)| name.ends_with(".h")).expect("a header").1;
        let contracts = header.matches("    assigns ").count();
        let functions = bare(header).iter().filter(|l| l.starts_with("ptc_status ptc_")).count();
        assert!(contracts == functions && functions > 2, "{design:?}:\n{header}");
    }
}

#[test]
fn the_harness_tells_its_commands_and_draws_from_the_design() {
    let design =
        ["--n=2", "--mu=exp", "--param=a=[0.5, 2]", "--tau=3", "--x-max=4,5", "--eps=0.25"];
    let files = emitted("harness", &[&["--acsl"], &design[..]].concat());
    let (name, text) = &files[2];
    assert_eq!(name, "ptc_exp2_eva.c");
    for part in [
        "frama-c -eva ",
        " -warn-special-float none ptc_exp2_eva.c ptc_exp2.c\n",
        "frama-c -cpp-extra-args=-DFINITE -eva ",
        " -warn-special-float non-finite ptc_exp2_eva.c ptc_exp2.c\n",
        "#ifndef PTC_EXP2_EVA_A_MIN\n#define PTC_EXP2_EVA_A_MIN 0.5\n#endif\n",
        "#define PTC_EXP2_EVA_A_MAX 2.0\n",
        "\n#define PTC_EXP2_EVA_TAU_MIN 3.0\n#define PTC_EXP2_EVA_TAU_MAX 3.0\n",
        "#define PTC_EXP2_EVA_X2_MAX 5.0\n",
        "#define PTC_EXP2_EVA_K1_MIN -100.0\n",
    ] {
        assert!(text.contains(part), "no {part:?} in\n{text}");
    }
    assert!(!text.contains("#ifndef PTC_EXP2_EVA_TAU_MIN"), "tau is fixed:\n{text}");
    assert!(files[1].1.contains("0.5 <= p->a"), "{}", files[1].1);
}

#[test]
fn the_harness_in_samples_draws_what_calls_may_leave() {
    let design = ["--n=2", "--mu=exp(a=1)", "--clock=samples", "--measured=x1", "--name=cart"];
    let observer = ["--observer-poles=-4,-5", "--x-max=3,4", "--u-max=7"];
    let files = emitted("harness_samples", &[&["--acsl"], &design[..], &observer].concat());
    let (name, text) = &files[2];
    assert_eq!(name, "cart_eva.c");
    for part in [
        " -warn-special-float none cart_eva.c cart.c\n",
        "#ifndef CART_EVA_Y1_MAX\n#define CART_EVA_Y1_MAX 3.0\n#endif\n",
        "#define CART_EVA_U1_MAX 7.0\n",
        "    self->x2_hat = cart_eva_draw(-CART_EVA_X2_HAT_MAX, CART_EVA_X2_HAT_MAX);\n",
        "    self->seen = cart_eva_count(0U, 1U);\n",
        "    status = cart_step(self, k, y, &u);\n",
        "    status = cart_estimate(self, xhat);\n",
        "    cart_eva_live(7.0, 2);\n",
    ] {
        assert!(text.contains(part), "no {part:?} in\n{text}");
    }
    assert!(files[1].1.contains("assigns *self, *u;"), "{}", files[1].1);
}

#[test]
fn files_of_a_proof_can_be_checked_for_drift() {
    let folder = folder("drift");
    let place = folder.to_str().expect("UTF-8");
    let emit = ["emit", "--lang=c", "--n=1", "--mu=exp", "--acsl", "-o", place];
    assert!(run(&emit).status.success());
    let check = [&emit[..], &["--check"]].concat();
    assert!(run(&check).status.success());
    fs::write(folder.join("ptc_exp1_eva.c"), "").expect("writable");
    assert_eq!(run(&check).status.code(), Some(1));
}

#[test]
fn a_proof_is_of_c_alone() {
    for (flags, named) in [
        (&["--lang=rust"][..], "`--lang rust`"),
        (&["--lang=c", "--dump=lower"], "`--dump`"),
        (&["--lang=rust", "--dump=lower"], "`--dump`"),
    ] {
        let folder = folder("refused");
        let place = folder.to_str().expect("UTF-8");
        let design = ["emit", "--n=2", "--mu=exp", "--acsl", "-o", place];
        let output = run(&[&design, flags].concat());
        let told = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{told}");
        assert!(told.contains("--acsl") && told.contains(named), "{told}");
        assert!(told.contains("help") && told.contains("--lang c"), "{told}");
        assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0);
    }
}
