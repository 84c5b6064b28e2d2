//! Mistakes that people typed, and the one message that helps.

use super::support::{command, folder_with};

/// Input of a user: a design, and the arguments of the command.
struct Typed {
    name: &'static str,
    design: &'static str,
    arguments: &'static [&'static str],
    code: i32,
    /// Parts of its output, on both streams.
    wanted: &'static [&'static str],
    /// Number of errors.
    errors: usize,
}

const fn checked(
    name: &'static str,
    design: &'static str,
    wanted: &'static [&'static str],
) -> Typed {
    Typed { name, design, arguments: &["check", "design.toml"], code: 2, wanted, errors: 1 }
}

/// A time that is no number is given all the same.
const EVENT: &str = "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\npoles = [-4, -5]\n[params]\ntau = 0.8\n\
    eps = 0\nu_max = 9\n[plant]\nf = 0\n[verify]\nx1 = 1\nx2 = 0\n[[objective]]\nbound = \"state\"\nsigma = 4\n[[event]]\nat = nan\n\
    move = 0.1\n";

/// The same of the box of initial states.
const BOX: &str = "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 0.8\neps = 0.01\nu_max = 9\n[plant]\nf = 0\n\
    [verify]\nx1 = nan\nx2 = 0\n[[objective]]\nbound = \"state\"\nsigma = 4\n";

const FILTER: &str = "what = \"filter\"\nn = 2\nsample_time = 1e-3\nkeep_below = 0.5\nkeep_poles = [-10, -40]\n[params]\n\
    tau = 0.4\nu_max = 9\n";

const ROWS: [Typed; 29] = [
    Typed {
        arguments: &["verify", "design.toml"],
        ..checked("instant", EVENT, &["`nan` is not a number"])
    },
    Typed {
        arguments: &["verify", "design.toml"],
        ..checked("box", BOX, &["`nan` is not a number"])
    },
    Typed {
        arguments: &["check", "design.toml", "--plot", "set.svg"],
        ..checked("filter_plot", FILTER, &["a filter has no law", "leave --plot out"])
    },
    Typed {
        arguments: &["show", "tables"],
        ..checked("tables", "", &["n is an integer 1..=30 here, for example --n 3\n"])
    },
    checked(
        "name",
        "name = \"belt stage\"\nn = 2\nmu = \"exp(a=1)\"\n",
        &["name must be one identifier", "write belt_stage"],
    ),
    checked(
        "comma",
        "n = 2\nmu = \"exp\"\ng = \"1,3\"\n",
        &["`1,3` is a list", "did you mean 1.3?"],
    ),
    checked(
        "unit",
        "n = 2\nmu = \"exp\"\nclock = \"samples\"\nsample_time = \"0.5ms\"\n[params]\ntau = 0.5\n",
        &["`0.5ms` has a unit", "seconds, without a unit: 5e-4"],
    ),
    checked(
        "rate",
        "n = 2\nmu = \"exp\"\nclock = \"samples\"\nsample_time = 2000\n[params]\ntau = 0.5\n",
        &["is 2000 a rate in Hz? write 5e-4"],
    ),
    Typed {
        code: 0,
        errors: 0,
        ..checked(
            "milliseconds",
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5, -6]\nclock = \"samples\"\nsample_time = 5e-4\ndelay = 5e-4\n[params]\ntau = 500\n",
            &[
                "1e6 samples of 5e-4 s: is tau in s?",
                "5e-4, 2.5e-7 s: delay is in samples, not in s",
            ],
        )
    },
    checked(
        "torque_max",
        "n = 2\nmu = \"exp(a=1)\"\ng = \"a_g\"\n[params]\na_g = 2\ntorque_max = 100\n",
        &["`torque_max`", "did you mean `u_max`?"],
    ),
    checked(
        "both_bounds",
        "n = 2\nmu = \"exp(a=1)\"\n[params]\ntau = 1\nu_max = [-100, 100]\n",
        &["u_max is one number", "u_min = -100 and u_max = 100"],
    ),
    checked(
        "position",
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nclock = \"samples\"\nsample_time = 1e-3\nmeasured = [\"position\"]\nobserver_poles = [-4, -5]\n[params]\ntau = 0.5\n",
        &["unknown state `position`", "expected x1, x2"],
    ),
    checked(
        "observer_poles",
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nclock = \"samples\"\nsample_time = 1e-3\nmeasured = \"x1\"\n[params]\ntau = 0.5\n",
        &["give 2 poles", "observer_poles = [-4, -5]\n"],
    ),
    Typed {
        code: 0,
        errors: 0,
        ..checked(
            "unknown_symbol",
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 0.5\neps = 1e-3\n[plant]\nf = \"-0.4*v\"\n",
            &["unknown name `v` in plant.f", "the states are x1, x2"],
        )
    },
    Typed {
        code: 1,
        errors: 0,
        ..checked(
            "right_of_the_line",
            "n = 3\nmu = \"exp(a=1)\"\npoles = [5, 6, 7]\n[params]\ntau = 0.5\n",
            &["\n            fix: place every pole left of -3\n"],
        )
    },
    Typed {
        code: 1,
        errors: 0,
        ..checked(
            "noise",
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nclock = \"samples\"\nsample_time = 1e-3\nnoise = 0.1\nerror = 1e-4\nx0_max = [0.5, 1]\n[params]\ntau = 0.5\neps = 0.4\nu_max = 100\n",
            &["noise alone is ", "times `error`"],
        )
    },
    Typed {
        arguments: &["emit", "design.toml", "--lang", "c++", "-o", "-"],
        code: 0,
        errors: 0,
        ..checked("language", "n = 2\nmu = \"exp(a=1)\"\n", &["namespace"])
    },
    Typed {
        arguments: &["simulate", "design.toml", "--x0", "1,0", "--at-fraction", "0"],
        code: 0,
        errors: 0,
        ..checked(
            "outside",
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nx0_max = [0.5, 1]\n[params]\ntau = 0.5\neps = 1e-2\n",
            &["note: --x0 is outside x0_max of the design: |x1| = 1 > 0.5"],
        )
    },
    Typed {
        arguments: &["explain", "poles"],
        code: 0,
        errors: 0,
        ..checked("concept", "", &["poles\n\n", "stretched time", "docs/checks/growth.md"])
    },
    checked(
        "measured",
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nclock = \"samples\"\nsample_time = 1e-3\nmeasured = \"x\"\ndisturbance = \"constant\"\nobserver_poles = [-4, -5, -6]\n[params]\ntau = 0.5\n",
        &["unknown state `x`", "expected x1, x2"],
    ),
    checked(
        "unquoted",
        "n = 2\nmu = exp(a=1)\npoles = [-4, -5]\nclock = \"samples\"\nsample_time = 1e-3\nmeasured = \"x1\"\nobserver_poles = [-4, -5]\n[params]\ntau = 0.5\n",
        &["`exp(a=1)` is not in quotes"],
    ),
    checked(
        "sampletime",
        "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\nclock = \"samples\"\nsampletime = 1e-3\n[params]\ntau = 0.5\n",
        &["unknown key `sampletime`", "help: did you mean `sample_time`?\n"],
    ),
    Typed {
        code: 0,
        errors: 0,
        ..checked(
            "constant",
            "n = 2\nmu = \"exp(a=1)\"\nf = \"qm*x1\"\n[params]\nqm = \"3*pi/180\"\n",
            &["--param \"qm=3*pi/180\""],
        )
    },
    Typed {
        arguments: &["check", "design.toml", "--A", "[[0, 1], [-9, -0.2]]"],
        code: 0,
        errors: 0,
        ..checked(
            "flag_over_table",
            "mu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 1e-3\npoles = [-4, -5]\n[params]\ntau = 0.5\n[plant]\nA = [[0, 1], [-4, -0.2]]\nB = [0, 1]\n",
            &["--A=\"[[0,1],[-9,-0.2]]\""],
        )
    },
    Typed {
        arguments: &["simulate", "design.toml", "--x0", "1,0", "--at-time", "0,1,2"],
        code: 0,
        errors: 0,
        ..checked(
            "seconds",
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 20\neps = 1e-3\n",
            &["\n20.0,0.0,", "\n20.0,1.0,", "\n20.0,2.0,"],
        )
    },
    Typed {
        code: 0,
        errors: 0,
        ..checked(
            "friction",
            "mu = \"exp(a=1)\"\npoles = [-4, -5]\n[model]\nstates = [\"p\", \"v\"]\ninput = \"F\"\noutput = \"p\"\ndynamics = { p = \"v\", v = \"F - B*v\" }\n[params]\nB = 0.3\n",
            &["--param B=0.3"],
        )
    },
    checked(
        "laws_of_axes",
        "n = 2\nmu = \"exp(a=1)\"\naxes = 2\npi0 = [\"-20*xi1 - 9*xi2\", \"-12*xi1 - 7*xi2\"]\n",
        &["axes share one `pi0`", "under [model]"],
    ),
    checked(
        "key_of_parameter",
        "n = 1\nmu = \"exp(a=1)\"\ng = \"1/J1\"\nJ1 = 3.2\n",
        &["`J1` is a parameter", "params.J1 = 3.2"],
    ),
    Typed {
        arguments: &["simulate", "design.toml", "--x0", "1,0", "--at", "0,1,2"],
        ..checked(
            "fraction",
            "n = 2\nmu = \"exp(a=1)\"\npoles = [-4, -5]\n[params]\ntau = 20\neps = 1e-3\n",
            &["a fraction of tau outside [0, 1)", "write --at-time 0,1,2"],
        )
    },
];

#[test]
fn every_typing_error_gets_a_helpful_message() {
    for Typed { name, design, arguments, code, wanted, errors } in ROWS {
        let folder = folder_with(name, "design.toml", design);
        let output = command(arguments).current_dir(&folder).output().expect("the command runs");
        let printed = [&output.stderr, &output.stdout].map(|text| String::from_utf8_lossy(text));
        let printed = printed.concat();
        assert_eq!(output.status.code(), Some(code), "{name}: {printed}");
        let found = printed.lines().filter(|line| line.starts_with("error")).count();
        assert_eq!(found, errors, "{name}: {printed}");
        for part in wanted {
            assert!(printed.contains(part), "{name} lacks {part:?}:\n{printed}");
        }
    }
}
