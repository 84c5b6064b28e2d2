//! MATLAB: one function file for each function, for MATLAB, its Coder, Simulink, and GNU Octave.

use super::super::{Language, Print, Target, refuse_fma};
use crate::diagnostic::Diagnostics;
use crate::program::Program;
use crate::request::{Spec, What};

pub(in crate::emit) const TARGET: Target = Target {
    language: Language::Matlab,
    name: "matlab",
    about: "a function file for each function, MATLAB and GNU Octave",
    comment: ("% ", ""),
    is_word: |word| WORDS.split_whitespace().any(|one| one == word),
    refuse,
    print: Print::Program(super::files),
};

/// Keywords of MATLAB and Octave.
const WORDS: &str = "
    break case catch classdef continue do else elseif end end_try_catch end_unwind_protect
    endclassdef endenumeration endevents endfor endfunction endif endmethods endparfor
    endproperties endswitch endwhile enumeration events for function global if methods otherwise
    parfor persistent properties return spmd switch try until unwind_protect
    unwind_protect_cleanup while
";

/// Longest name that MATLAB distinguishes from others.
const LONGEST: usize = 63;

fn refuse(spec: &Spec, _: Option<&Program>, found: &mut Diagnostics) {
    refuse_fma(spec, "MATLAB", found);
    let name = spec.name();
    let function = match spec.sampled() {
        Some(sampled) if sampled.disturbance.is_some() => "_disturbance",
        Some(sampled) if sampled.observes() => "_estimate",
        _ if spec.what == What::Associated => "_control",
        _ => "_init",
    };
    // What is generated beside a controller has a suffix of its own.
    let suffix = spec.name.as_ref().map_or(0, |own| name.len() - own.len());
    let longest = LONGEST - function.len() - suffix;
    if name.len() + function.len() > LONGEST {
        found.push(
            "bad-value",
            "name",
            None,
            format!("{name}{function} is longer than the {LONGEST} characters that MATLAB reads"),
            format!("give a name of at most {longest} characters"),
        );
    }
}
