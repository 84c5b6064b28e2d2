//! The reader of design files takes any text without a panic, and its places lie in the text.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use ptc_codegen::design::{self, Quote};
use ptc_codegen::diagnostic::Place;
use ptc_codegen::request;

const DESIGN: &str = "name = \"roll\" # \u{e9}\r\nn = 2\nmu = 'power(m=2)'\ngains = [2_0, \"9\",\n +9.5e-1]\n\
    precision = \"\\u0066\u{36}4\"\n[params]\ntau = 1.0\n\"eps\" = 0.1\nu_max = inf\n\
    [envelope]\nx_max = [10, 1e1]\nw = { a = \"\"\"b\"\"\" }\nd = 1979-05-27T07:32:00Z\nh = 0x1f\n";

/// A text of what TOML is made of.
fn nearly_toml() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        4 => prop::sample::select(vec![
            "n", "mu", "params", "envelope", "tau", " = ", "=", "\n", "\r\n", "[", "]", "[[", "]]",
            "{", "}", ",", ".", "\"", "'", "\"\"\"", "'''", "\\", "\\u00e9", "#", "true", "nan",
            "-inf", "0x1_f", "1e999", "1979-05-27", "07:32:00", "exp(a=1)", "\"exp(a=1)\"", "\u{feff}",
            "[params]", "_", "+", "-", "\0", "\u{e9}",
        ]).prop_map(str::to_owned),
        1 => "-?[0-9]{0,4}\\.?[0-9]{0,3}(e-?[0-9]{1,4})?",
        1 => "\\PC",
    ];
    prop::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
}

/// A design with some characters put in, taken out or moved.
fn mutated() -> impl Strategy<Value = String> {
    let edit = (0_usize..DESIGN.len(), 0_usize..6, prop_oneof![Just(String::new()), nearly_toml()]);
    prop::collection::vec(edit, 1..4).prop_map(|edits| {
        let mut text: Vec<char> = DESIGN.chars().collect();
        for (at, length, put) in edits {
            let at = at.min(text.len());
            let end = (at + length).min(text.len());
            text.splice(at..end, put.chars());
        }
        text.into_iter().collect()
    })
}

fn seed() -> RngSeed {
    match ProptestConfig::default().rng_seed {
        RngSeed::Random => RngSeed::Fixed(20),
        given @ RngSeed::Fixed(_) => given,
    }
}

proptest! {
    // One seed, so that every run tries the same; PROPTEST_RNG_SEED gives another.
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: seed(),
        cases: 1000,
        ..ProptestConfig::default()
    })]

    #[test]
    fn any_text_is_read_or_refused(text in prop_oneof!["\\PC*", "(?s).*", nearly_toml(), mutated()]) {
        let mut places = Vec::new();
        let (entries, found) = design::read(&text, &mut |range| {
            places.push(range);
            Place(places.len() - 1)
        });
        for range in places {
            prop_assert!(text.get(range.clone()).is_some(), "{range:?} in {text:?}");
            let quote = Quote::new(&text, range);
            prop_assert!(quote.text.get(quote.range).is_some());
            prop_assert!(quote.line > 0 && quote.column > 0 && !quote.text.contains('\n'));
        }
        for wrong in found {
            prop_assert!(!wrong.message.is_empty() && !wrong.help.is_empty());
            prop_assert!(wrong.place.is_some());
        }
        let _ = request::read(&entries);
    }
}
