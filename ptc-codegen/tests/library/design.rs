//! The reader of design files: every kind of value, the places, and the messages for mistakes.

use std::ops::Range;

use ptc_codegen::design::{self, Quote};
use ptc_codegen::diagnostic::{Diagnostic, Place};
use ptc_codegen::keys::KEYS;
use ptc_codegen::request::{self, Entry};
use ptc_codegen::syntax::Value;

/// The entries, the mistakes, and the text at each place.
fn read(text: &str) -> (Vec<Entry>, Vec<Diagnostic>, Vec<&str>) {
    let mut places: Vec<Range<usize>> = Vec::new();
    let (entries, found) = design::read(text, &mut |range| {
        places.push(range);
        Place(places.len() - 1)
    });
    let quoted = places.into_iter().map(|range| text.get(range).expect("edges of characters"));
    (entries, found, quoted.collect())
}

/// The one mistake of a text: what is underlined, the message and the help.
fn mistake(text: &str) -> (String, String, String) {
    let (_, found, places) = read(text);
    let [wrong] = &found[..] else { panic!("{text}: {found:?}") };
    let at = wrong.place.map_or("", |place| places[place.0]);
    (at.to_owned(), wrong.message.clone(), wrong.help.clone())
}

fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Word(word) => word.clone(),
        Value::List(items) => {
            format!("{:?}", items.iter().map(|item| shown(&item.value)).collect::<Vec<_>>())
        }
        Value::Call(name, arguments) => format!("{name}/{}", arguments.len()),
        other => format!("{other:?}"),
    }
}

#[test]
fn values_of_every_kind_keep_their_spelling_and_their_place() {
    let text = "# a comment\r\nname = 'roll'\r\nn = 0_2\n".replace("0_2", "1_6")
        + "mu = \"power(m=2)\"\ngains = [\n  2_0, # k_1\n  -9.50e+1, '7', \"inf\",\n]\n"
        + "params.a = +1\n[params]\n tau = 1.0\n \"eps\" = 1e-3\nu_max = +inf\npsi = 20\n"
        + "[envelope]\nx_max = [10, 1_0.5]\n";
    let (entries, found, places) = read(&text);
    let [twice] = &found[..] else { panic!("{found:?}") };
    assert_eq!(twice.message, "table `params` is opened twice");
    let entries: Vec<_> = entries
        .iter()
        .map(|entry| {
            let value = &entry.value;
            (entry.key.as_str(), shown(&value.value), places[entry.place.0], places[value.place.0])
        })
        .collect();
    let list = "[\n  2_0, # k_1\n  -9.50e+1, '7', \"inf\",\n]";
    for (index, (key, value, key_text, text)) in [
        ("name", "roll", "name", "roll"),
        ("n", "16", "n", "1_6"),
        ("mu", "power/1", "mu", "power(m=2)"),
        ("gains", r#"["20", "-9.50e+1", "7", "inf"]"#, "gains", list),
        ("params.a", "1", "params.a", "+1"),
        ("tau", "1.0", "tau", "1.0"),
        ("eps", "1e-3", "\"eps\"", "1e-3"),
        ("u_max", "inf", "u_max", "+inf"),
        ("params.psi", "20", "psi", "20"),
        ("x_max", r#"["10", "10.5"]"#, "x_max", "[10, 1_0.5]"),
    ]
    .into_iter()
    .enumerate()
    {
        assert_eq!(entries[index], (key, value.to_owned(), key_text, text));
    }
    assert_eq!(entries.len(), 10);
}

#[test]
fn places_within_text_are_exact_unless_escapes_moved_them() {
    for (text, at) in [
        ("mu = \"exp(a=1\"", ""),
        ("mu = 'exp(a = 1 2)'", "2"),
        ("mu = \"exp(a = \\u0031 2)\"", "\"exp(a = \\u0031 2)\""),
        ("mu = \"\"\"exp(a = 1 2)\"\"\"", "\"\"\"exp(a = 1 2)\"\"\""),
        ("gains = [1, 'a b']", "b"),
    ] {
        let (found, message, _) = mistake(text);
        assert_eq!(found, at, "{text}: {message}");
        assert!(
            message.starts_with("found `") || message.starts_with("found the end"),
            "{message}"
        );
    }
}

#[test]
fn a_value_that_is_none_of_a_spec_is_told_with_what_is() {
    for (text, at, message, help) in [
        ("n = 0x10", "0x10", "n = `0x10` is a hexadecimal integer", "write it in decimal: 16"),
        ("n = 0o17", "0o17", "n = `0o17` is an octal integer", "decimal: 15"),
        ("n = 0b1_1", "0b1_1", "n = `0b1_1` is a binary integer", "decimal: 3"),
        ("guard = true", "true", "guard = `true` is a boolean", "guard is full, result or none"),
        (
            "tau = 1979-05-27",
            "1979-05-27",
            "tau = `1979-05-27` is a date or a time",
            "tau is a number > 0",
        ),
        (
            "mu = { a = 1 }",
            "{ a = 1 }",
            "mu = `{ a = 1 }` is a table in braces",
            "example \"exp(a=1)\"",
        ),
        (
            "params = { tau = [1] }",
            "{ tau = [1] }",
            "`params` is a table in braces, not a table",
            "`[params]`",
        ),
        ("envelope = 3", "3", "`envelope` is a number, not a table", "`[envelope]`"),
        ("tau = nan", "nan", "tau = `nan` is not a number that can be used", "a number > 0"),
        ("tau = -inf", "-inf", "tau = `-inf` is not a number that can be used", "a number > 0"),
        ("tau = 1e999", "1e999", "tau = `1e999` is not a number that can be used", "at most 400"),
        ("gains = [true]", "true", "gains[0] = `true` is a boolean", "n finite numbers"),
        ("[params]\npsi = true", "true", "params.psi = `true` is a boolean", "text in quotes"),
    ] {
        let (found, told, fix) = mistake(text);
        assert_eq!((found.as_str(), told.as_str()), (at, message), "{text}");
        assert!(fix.contains(help), "{text}: {fix}");
    }
}

#[test]
fn tables_and_keys_that_mean_nothing_are_told() {
    for (text, at, message, help) in [
        (
            "[param]\ntau = 1",
            "param",
            "`[param]` is not a table of a design",
            "did you mean `params`?",
        ),
        (
            "[limits]\nx = 1",
            "limits",
            "`[limits]` is not a table of a design",
            "params, envelope, model, robot, plant",
        ),
        (
            "[params.a]\nx = 1",
            "params.a",
            "`[params.a]` is not a table of a design",
            "holds no tables",
        ),
        ("[[params]]\ntau = 1", "params", "`[[params]]` begins a list of tables", "`[params]`"),
        (
            "[[axes]]\ntau = 1",
            "axes",
            "`[[axes]]` is not a table of a design",
            "params, envelope, model, robot, plant",
        ),
        ("parms.tau = 1", "parms.tau", "`parms` is not a table of a design", "`params`?"),
        (
            "params.a.b = 1",
            "params.a.b",
            "`params.a` is not a table of a design",
            "holds no tables",
        ),
        (
            "[params]\na.b = 1",
            "a.b",
            "`a` is not a table of a design",
            "params, envelope, model, robot, plant",
        ),
        (
            "\"params.a\" = 1",
            "\"params.a\"",
            "the key `params.a` has a point inside quotes",
            "params.a = ...",
        ),
    ] {
        let (found, told, fix) = mistake(text);
        assert_eq!((found.as_str(), told.as_str()), (at, message), "{text}");
        assert!(fix.contains(help), "{text}: {fix}");
    }
}

#[test]
fn what_is_no_toml_is_told_line_by_line() {
    let text = "mu = exp(a=1) # no quotes\nn 3\nguard = none\ntau = .5\n= 1\nname = \"a\nprecision = 'f32'\neps = 1 2\ngains = [1, 2\n[params]\na = 1";
    let (entries, found, places) = read(text);
    let told: Vec<_> = found
        .iter()
        .map(|wrong| (wrong.place.map_or("", |place| places[place.0]), wrong.message.as_str()))
        .collect();
    assert_eq!(
        told,
        [
            ("exp(a=1)", "`exp(a=1)` is not in quotes"),
            ("", "invalid TOML: key with no value"),
            ("none", "`none` is not in quotes"),
            (".5", "`.5` is not a TOML number: invalid mantissa"),
            ("", "invalid TOML: unquoted keys cannot be empty"),
            ("", "invalid TOML: invalid basic string"),
            ("1 2", "`1 2` is not a TOML number: string values must be quoted"),
            ("", "invalid TOML: missing comma between array elements"),
        ],
    );
    assert!(found.iter().all(|wrong| wrong.code == "toml" && !wrong.help.is_empty()));
    let keys: Vec<_> = entries.iter().map(|entry| entry.key.as_str()).collect();
    assert_eq!(keys, ["precision"]);
    let missing =
        design::mistakes(&found, &entries, request::read(&entries).err().unwrap_or_default());
    assert!(missing.iter().all(|wrong| wrong.code != "missing-key"), "{missing:?}");
}

#[test]
fn odd_files_are_told_without_a_panic() {
    let deep = |open: &str, depth: usize| format!("n = {}", open.repeat(depth));
    for text in [
        deep("[", 100_000),
        deep("{a=", 100_000),
        format!("a{} = 1", ".a".repeat(100_000)),
        format!("[a{}]", ".a".repeat(100_000)),
        "\u{0}\u{1b}[31m = \u{7f}".to_owned(),
        "x".repeat(10 << 20),
        "= [\n".repeat(200_000),
        "\"\"\"".to_owned(),
        "n = \"\"\"é".to_owned(),
    ] {
        let (entries, found, _) = read(&text);
        assert!(entries.is_empty() && !found.is_empty() && found.len() <= 10);
        for wrong in found {
            assert!(wrong.message.len() + wrong.help.len() < 400_000);
        }
    }
    let (entries, found, _) = read("\u{feff}n = 3\r\n\r\n");
    assert!(entries.len() == 1 && found.is_empty(), "{found:?}");
    assert!(read("").0.is_empty() && read("").1.is_empty());
}

/// The parser reports one mistake per line: what follows may be a value alone.
#[test]
fn a_value_may_lack_its_key() {
    let text = "mu = \"we#\nes=[0.5, 1 2{es=esm[0.5, 1 2].\nes=[0.5, 0 2]ln5\n= [1, 3]\n";
    let (entries, found, _) = read(text);
    assert!(entries.is_empty() && found.iter().all(|wrong| wrong.code == design::SYNTAX));
}

#[test]
fn a_quote_is_one_line_with_its_numbers() {
    let source = "a = 1\r\nbé = \tx\r\n";
    let at = source.find('x').expect("an x");
    let quote = Quote::new(source, at..at + 1);
    assert_eq!((quote.line, quote.column, quote.text.as_str()), (2, 7, "bé =  x"));
    assert_eq!(&quote.text[quote.range], "x");
    let end = Quote::new(source, source.len()..source.len());
    assert_eq!((end.line, end.column, end.text.as_str(), end.range), (3, 1, "", 0..0));
    let long = format!("{}!{}", "é".repeat(1000), "é".repeat(1000));
    let quote = Quote::new(&long, 2000..4001);
    assert!(quote.text.len() < 200 && quote.text[quote.range].starts_with('!'));
    assert_eq!(quote.column, 1001);
}

#[test]
fn the_template_tells_every_key_and_is_a_design() {
    for (text, name) in
        [(design::template(None), None), (design::template(Some("roll")), Some("roll"))]
    {
        let (entries, found, _) = read(&text);
        assert!(found.is_empty(), "{text}\n{found:?}");
        assert_eq!(request::read(&entries).expect("a spec").name.as_deref(), name);
    }
    let text = design::template(None);
    for info in &KEYS {
        assert!(text.contains(info.meaning) && text.contains(info.legal), "{}", info.key);
    }
    // Each example in a comment is an entry of its key.
    let is_key = |line: &str| {
        let names = KEYS.iter().filter_map(|info| info.key.rsplit('.').next());
        names.into_iter().any(|name| line.starts_with(&format!("{name} = ")))
    };
    let lines = text.lines().map(|line| line.strip_prefix("# ").unwrap_or(line));
    let lines: Vec<_> = lines.filter(|line| line.starts_with('[') || is_key(line)).collect();
    let (entries, found, _) = read(&lines.join("\n"));
    assert!(found.is_empty(), "{found:?}");
    // Without its table.
    let keys: Vec<_> = entries.iter().filter_map(|e| e.key.rsplit('.').next()).collect();
    for info in &KEYS {
        let told = keys.iter().any(|key| key.rsplit('.').next() == Some(info.key));
        assert!(told, "{} is not in {text}", info.key);
    }
}

#[cfg(feature = "lab")]
#[test]
fn the_template_tells_what_verify_reads() {
    use ptc_codegen::keys::EVENT_KEYS;
    use ptc_codegen::verify::{self, DISTURBANCE, INITIAL_STATE, OBJECTIVE_KEYS, PARAMETER};

    let text = design::template(None);
    let all = verify::KEYS.iter().chain(&OBJECTIVE_KEYS).chain([
        &DISTURBANCE,
        &INITIAL_STATE,
        &PARAMETER,
    ]);
    for info in all {
        assert!(text.contains(info.meaning) && text.contains(info.legal), "{}", info.key);
    }
    // The examples of the tables, without their `#`, are a campaign of the plant that has the symbol.
    let (_, tables) = text.split_once("[disturbance]").expect("the table");
    let told = |line: &&str| line.contains(" = ") || line.starts_with("# [[");
    let mut kept: Vec<_> =
        tables.lines().filter(|line| line.starts_with('[') || told(line)).collect();
    // An objective has the keys of its bound.
    let of_others = ["upsilon", "error", "h", "low", "high"].map(|key| format!("# {key} = "));
    let tables = kept.iter().position(|line| line.contains("[[event]]")).expect("events");
    assert!(kept.len() > tables + EVENT_KEYS.len(), "{text}");
    let events = kept.split_off(tables);
    kept.retain(|line| !of_others.iter().any(|key| line.starts_with(key)));
    let without_mark = |lines: &[&str]| {
        lines.iter().map(|line| line.trim_start_matches("# ").to_owned()).collect::<Vec<_>>()
    };
    let (lines, events) = (without_mark(&kept), without_mark(&events));
    let top = "n = 1\nmu = \"exp(a=1)\"\n[plant]\nf = \"gust\"\ngust = [-1, 1]\n[disturbance]\n";
    let (entries, found, _) = read(&format!("{top}{}", lines.join("\n")));
    assert!(found.is_empty(), "{found:?}");
    let spec = request::read(&entries).expect("a spec");
    let plant = ptc_codegen::plant::read(&entries, &spec).expect("a plant").expect("a plant");
    let campaign = verify::read(&entries, &spec, &plant).expect("a campaign");
    assert_eq!(
        (campaign.x0, campaign.objectives.len(), campaign.disturbances.len()),
        (vec![(-1.0, 1.0)], 1, 1)
    );
    // Those of an event are one of a controller whose deadline may change.
    let top = "n = 2\nmu = \"exp(a=1)\"\nclock = \"samples\"\nsample_time = 0.1\npoles = [-4, -5]\n\
               in_flight = true\n[params]\ntau = 1\neps = 0\n";
    let (entries, found, _) = read(&format!("{top}{}", events.join("\n")));
    assert!(found.is_empty(), "{found:?}");
    let spec = request::read(&entries).expect("a spec");
    let all = ptc_codegen::simulate::event::read_numbers(&entries, &spec).expect("events");
    assert_eq!(all.len(), 4, "{all:?}");
}
