//! The codes of mistakes, in the order of the alphabet.

use super::Explanation;

/// An explanation whose example needs no design file.
const fn flags(
    code: &'static str,
    means: &'static str,
    example: &'static str,
    fix: &'static str,
) -> Explanation {
    Explanation { code, means, design: "", example, fix }
}

/// An explanation whose example is a design file.
const fn file(
    code: &'static str,
    means: &'static str,
    (design, example): (&'static str, &'static str),
    fix: &'static str,
) -> Explanation {
    Explanation { code, means, design, example, fix }
}

/// The command of most examples with a design file.
const CHECK: &str = "ptc-codegen check design.toml";

pub(super) static ERRORS: [Explanation; 29] = [
    flags(
        "axes",
        "The command handles one chain of integrators, not several axes.",
        "ptc-codegen emit --lang c --acsl --n 2 --mu \"exp(a=1)\" --poles=-4,-5 --axes 2",
        "leave `axes` out and run each axis as a chain, with its own gains, limit and g",
    ),
    flags(
        "bad-expression",
        "An expression uses a name or a function that is unknown there, or is not valid for its key.",
        "ptc-codegen check --n 1 --mu exp --pi0=\"-2*x1\"",
        "the message lists the names known there: pi0 has xi1..xin, g and f have x1..xn; docs/expressions.md has the table",
    ),
    flags(
        "bad-model",
        "No law follows from the model: a rate is not affine in the input, the input does not reach the output, or a function to be differentiated is not smooth.",
        "ptc-codegen check --mu exp --states \"q, w\" --input M --output q --dynamics \"w, M^2\"",
        "write the rate as f + g u, choose an output that the input moves, and replace abs, sign, min and max by smooth functions",
    ),
    flags(
        "bad-value",
        "A value is of the wrong type or outside the domain of its key.",
        "ptc-codegen check --n 0 --mu exp",
        "the help below the message says what is legal; `ptc-codegen new --all -` explains every key",
    ),
    file(
        "clock",
        "The command supports only a clock in time.",
        (
            "n = 1\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.1\npoles = [-3]\n",
            "ptc-codegen show bell design.toml",
        ),
        "leave `clock` out for this command",
    ),
    flags(
        "conflict",
        "Two keys exclude each other.",
        "ptc-codegen check --n 2 --mu exp --gains 6,5 --poles=-2,-3",
        "give one of them; a flag that overrides a key of the file is not a conflict",
    ),
    flags(
        "drift",
        "A file differs from what would be written. `--check` compares and writes nothing.",
        "ptc-codegen emit --lang c --n 1 --mu exp --check -o out",
        "run the same command without `--check`; in a test this error means that emitted code was edited, or that design or generator changed",
    ),
    flags(
        "internal",
        "A fault of the generator, not of the input. Nothing was written.",
        "none is known",
        "report the text with the command line and the design",
    ),
    file(
        "missing-key",
        "A required key is missing.",
        ("n = 2\n", CHECK),
        "the message says which, and gives an example",
    ),
    file(
        "missing-value",
        "A name that a campaign needs has no value: it is neither fixed nor drawn.",
        (
            "n = 1\nmu = \"exp(a=1)\"\npoles = [-3]\n\n[plant]\nf = \"d\"\ng = \"b\"\nd = [0, 1]\n\n[verify]\nx1 = 1\ntau = 1\n\n[[objective]]\nbound = \"attractive\"\nerror = 0.1\n",
            "ptc-codegen verify design.toml",
        ),
        "give it under [params] or [plant]: a number, or [lower, upper] if it is uncertain",
    ),
    flags(
        "more",
        "There are more errors than are shown.",
        "a file of another kind, given as a design",
        "fix the first ones, and run the command again",
    ),
    flags(
        "no-digits",
        "The fixed parameters and gains together are too far from 1 for the precision.",
        "gains whose product with a power of the rate leaves no digit of u in f32",
        "take other units, of time for example, or leave some of them to run time",
    ),
    flags(
        "not-alone",
        "The output needs a complete controller, without parts that your program supplies.",
        "ptc-codegen emit --lang fmu3 --n 1 --mu exp --what associated",
        "leave `what` out, or emit it in a language and call it from your own program",
    ),
    flags(
        "overflow",
        "A coefficient of the law is outside the range of the precision with the values that are fixed.",
        "ptc-codegen emit --lang c --n 2 --mu \"exp(a=1e-5)\" --gains 1e37,1e3 --precision f32 --allow growth -o -",
        "give a rate nearer to 1, smaller gains, a lower order, other units, or f64",
    ),
    file(
        "reference",
        "The command has no values of a reference to pass to each call.",
        (
            "n = 1\nmu = \"exp(a=1)\"\npoles = [-3]\nreference = \"input\"\n\n[verify]\nx1 = 1\ntau = 1\n\n[[objective]]\nbound = \"attractive\"\nerror = 0.1\n",
            "ptc-codegen verify design.toml",
        ),
        "give the reference as an expression in t, or leave it out: the states are then those of the tracking error",
    ),
    file(
        "repeated-key",
        "A key is given twice.",
        ("n = 2\nmu = \"exp\"\ntau = 1\n\n[params]\ntau = 2\n", CHECK),
        "remove one of the two; tau, t0, eps, u_max and u_min may be at the top or under [params]",
    ),
    flags(
        "reserved-name",
        "A name is reserved in the emitted language.",
        "ptc-codegen emit --lang matlab --n 1 --mu exp --name end",
        "choose another name for the controller or the parameter",
    ),
    flags(
        "selftest",
        "No self-test can be made of this controller: it has no call whose value is known for certain, or the search for one takes too long.",
        "a mapping with parameters at run time that is of its class for some values alone",
        "fix the parameters of the mapping, or test it by hand",
    ),
    flags(
        "syntax",
        "A value cannot be read.",
        "ptc-codegen check --n 2 --mu \"exp(a=1\"",
        "write a number, a name, a name with arguments, numbers separated by commas, or an expression; quote it for the shell, and write --poles=-2,-3 where a value begins with a minus",
    ),
    file(
        "toml",
        "A line of the design file is not TOML.",
        ("n = \n", CHECK),
        "quote text, and write one key on a line: mu = \"exp(a=1)\"",
    ),
    flags(
        "too-large",
        "An input is larger than its bound, or causes more work than is allowed.",
        "ptc-codegen check --n 1 --mu exp --pi0=-$(printf '%0150d' 0 | tr 0 '(')xi1$(printf '%0150d' 0 | tr 0 ')')",
        "the message names the bound and what to do; `ptc-codegen/src/limits.rs` lists all",
    ),
    flags(
        "unknown-family",
        "No mapping has this name.",
        "ptc-codegen check --n 2 --mu expo",
        "`ptc-codegen list` shows the families; an expression in t is a mapping too",
    ),
    file(
        "unknown-key",
        "There is no key of this name.",
        ("n = 2\nmu = \"exp\"\ngain = [6, 5]\n", CHECK),
        "correct its spelling; `ptc-codegen new --all -` lists every key, and `ptc-codegen schema` lets an editor complete them",
    ),
    flags(
        "unknown-parameter",
        "The family of the mapping has no parameter of this name.",
        "ptc-codegen check --n 2 --mu \"exp(m=2)\"",
        "`ptc-codegen list` shows the parameters of each family",
    ),
    file(
        "unknown-symbol",
        "f or g of the plant uses a name without a value, while a similar name is defined but unused.",
        (
            "n = 1\nmu = \"exp\"\ngains = [2]\n\n[plant]\nf = \"-dampng*x1\"\ndamping = 1\n",
            "ptc-codegen simulate design.toml --x0 1 --tau 1",
        ),
        "use the same name in both places",
    ),
    file(
        "unknown-table",
        "A design has no table of this name.",
        ("n = 2\nmu = \"exp\"\n\n[parameters]\ntau = 1\n", CHECK),
        "the message lists the tables: params, envelope, model, robot, plant, disturbance, verify, objective",
    ),
    file(
        "unreadable-design",
        "The design file is too large, or cannot be read.",
        (
            "",
            "a file with more than 2000 keys and tables, or a folder where the macro looks for its file",
        ),
        "give the design itself, a page of TOML",
    ),
    flags(
        "unsupported",
        "The language lacks a feature that the controller needs.",
        "ptc-codegen emit --lang st --n 1 --mu exp --what associated",
        "emit it in another language, or write the mapping or the law with functions that the language has",
    ),
    flags(
        "unused-parameter",
        "A given parameter, or an intermediate value of a model, is not used.",
        "ptc-codegen check --n 1 --mu exp --pi0=\"-2*xi1\" --param k=2",
        "correct its spelling, use it in an expression, or leave it out",
    ),
];
