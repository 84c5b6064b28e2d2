//! Numbers that a page repeats from the tables of docs/benchmarks.

const CONCLUSIONS: &str = include_str!("../../../docs/BENCHMARKS.md");

const STEPS: &str = include_str!("../../../docs/benchmarks/steps.md");

const MOVES: &str = include_str!("../../../docs/benchmarks/moves.md");

const GENERATORS: &str = include_str!("../../../docs/benchmarks/generators.md");

const COMPARE: &str = include_str!("../../../docs/compare.md");

/// Returns the rows of the tables of a text, each as its cells.
fn rows(text: &str) -> Vec<Vec<&str>> {
    let rows = text.lines().filter(|line| line.starts_with("| "));
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

/// Returns the text from one heading to the next.
fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let (_, rest) = page.split_once(&format!("\n{heading}\n")).expect("a heading");
    rest.split("\n#").next().unwrap_or(rest)
}

/// The figures of docs/compare.md beside other tools are those of the page that a command writes.
#[test]
fn comparison_of_tools_matches_the_benchmarks() {
    let rows = rows(GENERATORS);
    let measured = |family: &str, n: &str, generator: &str, column: usize| {
        let row = |row: &&Vec<&str>| row.len() == 8 && row[..3] == [family, n, generator];
        rows.iter().find(row).unwrap_or_else(|| panic!("no {family} {n} {generator}"))[column]
    };
    for (start, family, n, column) in [
        ("| instructions of a step, `exp`, n = 3 |", "exp", "3", 3),
        ("| instructions of a step, `tan`, n = 6 |", "tan", "6", 3),
        ("| error of u for T/tau down to 1e-12, `tan`, n = 6 |", "tan", "6", 7),
    ] {
        let line = COMPARE.lines().find(|line| line.starts_with(start)).expect("a row");
        let shown: Vec<_> = line[start.len()..].split('|').map(str::trim).collect();
        let hand = if n == "3" { "hand" } else { "hand_loop" };
        let casadi = if n == "3" { "casadi_diff" } else { "casadi_mu" };
        for (place, generator) in ["ptc-codegen", hand, "sympy_tuned", casadi].iter().enumerate() {
            assert_eq!(shown[place], measured(family, n, generator, column), "{start} {generator}");
        }
    }
}

/// The conclusions repeat the counts of a step for some orders.
#[test]
fn conclusions_on_a_step_match_the_counts() {
    let shown = rows(section(CONCLUSIONS, "## A step"));
    let [head, _, shown @ ..] = &shown[..] else { panic!("a table") };
    assert!(shown.len() > 2);
    for row in shown {
        let (family, guard) = row[0].split_once(", guard ").expect("a family and a guard");
        let counts = rows(section(STEPS, &format!("### C, f64: `step`, guard {guard}")));
        let own = counts.iter().find(|count| count[0] == family.trim_matches('`')).expect("a row");
        for (order, count) in head.iter().zip(row).skip(1) {
            let column = counts[0].iter().position(|name| name == order).expect("a column");
            assert_eq!(own[column], *count, "{} {order}", row[0]);
        }
    }
}

/// The conclusions repeat some rows of the motions to rest.
#[test]
fn conclusions_on_motions_match_the_table() {
    let measured = rows(MOVES);
    let shown = rows(section(CONCLUSIONS, "## Motions to rest"));
    let [_, _, shown @ ..] = &shown[..] else { panic!("a table") };
    assert!(shown.len() > 2);
    for row in shown {
        let own = measured.iter().find(|own| own[0].starts_with(row[0])).expect("a controller");
        assert_eq!(own[1..5], row[1..], "{}", row[0]);
    }
}
