//! Tests of the parser: values, their depth, and the messages for wrong text.

use super::*;

fn parsed(text: &str) -> Result<Value, String> {
    parse("key", text, &mut |_| Place(0)).map(|n| n.value).map_err(|d| d.message)
}

/// The value in prefix notation.
fn shape(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Imaginary(units) => format!("{units}i"),
        Value::Word(word) | Value::File(word, _) => word.clone(),
        Value::List(items) => items.iter().map(|n| shape(&n.value)).collect::<Vec<_>>().join(","),
        Value::Call(name, arguments) => {
            let inner: Vec<_> = arguments.iter().map(|a| shape(&a.value.value)).collect();
            format!("{name}({})", inner.join(","))
        }
        Value::Table(_) => "{}".to_owned(),
        Value::Negative(a) => format!("(neg {})", shape(&a.value)),
        Value::Binary(operator, a, b) => {
            format!("({operator:?} {} {})", shape(&a.value), shape(&b.value))
        }
    }
}

#[test]
fn expressions_bind_as_in_mathematics() {
    for (text, tree) in [
        ("1 - 2 - 3", "(Sub (Sub 1 2) 3)"),
        ("a -1", "(Sub a 1)"),
        ("2*x + y/3", "(Add (Mul 2 x) (Div y 3))"),
        ("-x^2", "(neg (Power x 2))"),
        ("x^-2", "(Power x -2)"),
        ("2^3^2", "(Power 2 (Power 3 2))"),
        ("-(a + b)*c", "(Mul (neg (Add a b)) c)"),
        ("-1+2i", "(Add -1 2i)"),
        ("-1 - i", "(Sub -1 1i)"),
        ("1e-3-1", "(Sub 1e-3 1)"),
        (
            "-psi*xi1/(abs(xi1) - phi*abs(xi1_0))^2",
            "(Div (Mul (neg psi) xi1) (Power (Sub abs(xi1) (Mul phi abs(xi1_0))) 2))",
        ),
        ("6, -11", "6,-11"),
    ] {
        assert_eq!(parsed(text).map(|v| shape(&v)).as_deref(), Ok(tree), "{text}");
    }
}

#[test]
fn depth_and_length_are_bounded() {
    let deep = format!("{}1{}", "(".repeat(50_00), ")".repeat(50_00));
    let signs = format!("{}1", "-".repeat(5000));
    let powers = "2^".repeat(5000) + "2";
    for text in [deep, signs, powers] {
        let found = parsed(&text).err();
        assert!(found.as_deref().is_some_and(|m| m.contains("100 levels")), "{found:?}");
    }
    let sum = vec!["x1"; 300].join("+");
    assert!(parsed(&sum).err().is_some_and(|m| m.contains("200 operations")));
    assert!(parsed(&vec!["x1"; 200].join("+")).is_ok());
    assert!(parsed(&"1".repeat(30_000)).err().is_some_and(|m| m.contains("the limit is 20000")));
}

#[test]
fn every_shape_of_value_parses() {
    assert!(matches!(parsed(" exp "), Ok(Value::Word(w)) if w == "exp"));
    assert!(matches!(parsed("6, 11,6"), Ok(Value::List(l)) if l.len() == 3));
    assert!(matches!(parsed("inf"), Ok(Value::Number(Fixed::Infinite))));
    match parsed("exp_sum(rates = [0.5, 1.5])") {
        Ok(Value::Call(name, arguments)) => {
            assert_eq!(name, "exp_sum");
            assert!(matches!(&arguments[0].name, Some((n, _)) if n == "rates"));
            assert!(matches!(&arguments[0].value.value, Value::List(l) if l.len() == 2));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn syntax_errors_state_the_expected_token() {
    for (text, message) in [
        ("", "found the end where a value should be"),
        ("exp(", "found the end where a value should be"),
        ("exp(a=1", "found the end where `,` or `)` should be"),
        ("exp)", "found `)` where the end of the value should be"),
        (
            "1e999",
            "found `1e999` where a decimal number (1000 digits and exponent 400 at most) should be",
        ),
        ("2^^3", "found `^` where a value should be"),
        ("x1 x2", "found `x2` where the end of the value should be"),
    ] {
        let found = parsed(text).err();
        assert!(
            found
                .as_deref()
                .is_some_and(|m| m.ends_with(&message[message.find("where").unwrap_or(0)..])),
            "{text}: {found:?}"
        );
    }
}
