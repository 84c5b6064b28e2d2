//! The longest sample period for which the loop is stable with held gains.
//!
//! `cargo run --example sampling -- --mu "exp(a=1)" --gains 12,7 --tau 0.8 --eps 0.01`
//!
//! From time-to-go `eps` on the gains stand still, and with a zero-order hold of period h the loop
//! is x(t + h) = M(h) x(t), M = exp(A h) + B(h) gain^T with A and B of the chain of integrators.
//! The example finds the h up to which the spectral radius of M stays below one
//! (`ptc_codegen::check::sampling`).

use ptc_codegen::check::sampling::longest_period;
use ptc_codegen::law::Law;
use ptc_codegen::program::interpret::Interpreter;
use ptc_codegen::program::{Input, Program, passes};
use ptc_codegen::request::{Entry, Spec, read};
use ptc_codegen::syntax::{Value, parse};
use ptc_codegen::{diagnostic::Place, lower};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match spec(&arguments) {
        Ok(spec) => {
            let law = Law::of(&spec);
            let program = passes::optimise(lower::lower(&spec, &law), &mut |_, _| {});
            let (gains, eps) = (held_gains(&program, &spec), fixed(&spec, "eps"));
            println!("order {}, held gains {gains:.4?}", spec.n);
            match longest_period(&gains, eps) {
                Some(h) => println!("stable up to h = {h:.4} s, which is {:.3} eps", h / eps),
                None => println!("unstable however short the sample period"),
            }
        }
        Err(told) => {
            eprintln!("{told}\ngive --mu, --gains, --tau and --eps, with every parameter fixed");
            std::process::exit(2);
        }
    }
}

/// The spec of the flags; its order is the number of gains.
fn spec(arguments: &[String]) -> Result<Spec, String> {
    let mut entries = Vec::new();
    let mut add = |key: &str, text: &str| {
        let value = parse(key, text, &mut |_| Place(0)).map_err(|wrong| wrong.to_string())?;
        if key == "gains" {
            let count = if let Value::List(items) = &value.value { items.len() } else { 1 };
            let text = count.to_string();
            let n = parse("n", &text, &mut |_| Place(0)).map_err(|wrong| wrong.to_string())?;
            entries.push(Entry { key: "n".to_owned(), place: Place(0), value: n });
        }
        entries.push(Entry { key: key.to_owned(), place: Place(0), value });
        Ok::<_, String>(())
    };
    add("t0", "0")?;
    add("u_max", "inf")?;
    for pair in arguments.chunks(2) {
        match pair {
            [flag, text] => add(flag.trim_start_matches("--"), text)?,
            _ => return Err("a flag without a value".to_owned()),
        }
    }
    let spec = read(&entries).map_err(|found| format!("{}", found[0]))?;
    let left = spec.run_time_parameters().next();
    left.map_or(Ok(spec), |parameter| Err(format!("`{}` is not fixed", parameter.key())))
}

fn fixed(spec: &Spec, key: &str) -> f64 {
    let value = spec.fixed.iter().find(|(parameter, _)| parameter.key() == key);
    value.and_then(|(_, value)| value.to_string().parse().ok()).unwrap_or(f64::NAN)
}

/// The gains at and after the deadline.
fn held_gains(program: &Program, spec: &Spec) -> Vec<f64> {
    let tau = fixed(spec, "tau");
    let input = |input| if input == Input::Time { tau } else { 0.0 };
    let mut interpreter = Interpreter::new(program, &input);
    program.gains.iter().map(|gain| interpreter.value(*gain)).collect()
}
