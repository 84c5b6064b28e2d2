//! The only code that calls Symbolica: a program of its own, which `ptc-codegen` starts.
//!
//! It reads one request and writes one answer, in the words of [`words`]. D is the
//! stretched-time derivative, the same in every ring: D p = sum over symbols s of dp/ds D s.

use std::io;
use std::process::ExitCode;
use std::thread;

use serde_json::{Value, json};
use symbolica::prelude::*;

use words::{MARK, REFUSED, Target};

// What both sides of the pipe agree on.
#[path = "../../../ptc-codegen/src/cli/engine/symbolica/words.rs"]
mod words;

/// Answers the request on the standard input.
fn main() -> ExitCode {
    // Before anything is waited for: where it may not run, it says so at once.
    let symbols = Atoms;
    let _ = symbols.symbol(0);
    let mut request = String::new();
    let read = io::stdin().read_line(&mut request).is_ok();
    // Whoever asked keeps the pipe open: with its end, also by a signal that nothing can catch, there
    // is nobody left to answer.
    thread::spawn(|| {
        let _ = io::copy(&mut io::stdin(), &mut io::sink());
        std::process::exit(i32::from(REFUSED));
    });
    let request: Value = serde_json::from_str(&request).unwrap_or_default();
    match answer(&request).filter(|_| read) {
        Some(answer) => {
            println!("\n{MARK}{answer}");
            ExitCode::SUCCESS
        }
        None => ExitCode::from(REFUSED),
    }
}

fn answer(request: &Value) -> Option<Value> {
    let n = usize::try_from(request["n"].as_u64()?).ok()?;
    let read = |key: &str| words::read(request[key].as_str()?, &Atoms);
    let variable = symbol(0);
    let ring = if let Some(kappa) = read("kappa") {
        // The time-to-go falls as time goes on: kappa' = -d kappa/dT, and D T = -r_1.
        let r1 = tidy(&(Atom::num(-1) / kappa.derivative(variable)));
        Ring { derivations: vec![(variable, -r1.clone())], r1, tidy }
    } else if let Some(complement) = read("complement") {
        let r1 = tidy(&-complement.derivative(variable));
        Ring { derivations: vec![(variable, Atom::num(1))], r1, tidy }
    } else {
        let derivation = |pair: &Value| {
            let place = usize::try_from(pair[0].as_u64()?).ok()?;
            Some((symbol(place), words::read(pair[1].as_str()?, &Atoms)?))
        };
        let derivations: Option<_> =
            request["derivations"].as_array()?.iter().map(derivation).collect();
        Ring { r1: read("r1")?.expand(), derivations: derivations?, tidy: |a| a.expand() }
    };
    let bell = request["bell"].as_bool() == Some(true);
    let text = |atoms: Vec<Atom>| atoms.iter().map(|a| written(a.as_view())).collect::<Option<_>>();
    let rows: Vec<_> = if bell { ring.bell(n) } else { Vec::new() };
    let rows: Option<Vec<Vec<String>>> = rows.into_iter().map(text).collect();
    let r: Option<Vec<String>> = text(ring.r(n));
    Some(json!({ "r": r?, "bell": rows? }))
}

/// A ring that is closed under D.
struct Ring {
    r1: Atom,
    derivations: Vec<(symbolica::atom::Symbol, Atom)>,
    /// The form in which its elements are kept.
    tidy: fn(&Atom) -> Atom,
}

impl Ring {
    fn derive(&self, element: &Atom) -> Atom {
        let part = |(symbol, derived): &(_, Atom)| element.derivative(*symbol) * derived;
        let sum = self.derivations.iter().map(part).fold(Atom::num(0), |sum, part| sum + part);
        (self.tidy)(&sum)
    }

    /// r_1, ..., r_n: r_{k+1} = D r_k.
    fn r(&self, n: usize) -> Vec<Atom> {
        let first = Some(self.r1.clone());
        std::iter::successors(first, |r| Some(self.derive(r))).take(n).collect()
    }

    /// B_{i,j} for 0 <= j <= i <= n: B_{i+1,j} = D B_{i,j} + r_1 B_{i,j-1}.
    fn bell(&self, n: usize) -> Vec<Vec<Atom>> {
        let mut rows = vec![vec![Atom::num(1)]];
        for i in 0..n {
            let last = &rows[i];
            let entry = |j: usize| {
                let derived = last.get(j).map(|b| self.derive(b)).unwrap_or_default();
                let shifted = j.checked_sub(1).map(|j| &last[j] * &self.r1).unwrap_or_default();
                (self.tidy)(&(derived + shifted))
            };
            let row = (0..=i + 1).map(entry).collect();
            rows.push(row);
        }
        rows
    }
}

/// The shortest of three forms: as it is, as one fraction without common factors, and as a sum.
fn tidy(element: &Atom) -> Atom {
    let forms = [element.clone(), element.together().cancel(), element.expand()];
    let length = |form: &Atom| written(form.as_view()).map_or(usize::MAX, |text| text.len());
    forms.into_iter().min_by_key(length).unwrap_or_default()
}

fn symbol(place: usize) -> symbolica::atom::Symbol {
    symbol!(format!("v{place}"))
}

/// Symbolica's expressions.
struct Atoms;

impl Target for Atoms {
    type Value = Atom;

    fn number(&self, text: &str) -> Option<Atom> {
        try_parse!(text).ok()
    }

    fn symbol(&self, place: usize) -> Option<Atom> {
        Some(Atom::var(symbol(place)))
    }

    fn sum(&self, terms: Vec<Atom>) -> Option<Atom> {
        Some(terms.into_iter().fold(Atom::num(0), |sum, term| sum + term))
    }

    fn product(&self, factors: Vec<Atom>) -> Option<Atom> {
        Some(factors.into_iter().fold(Atom::num(1), |product, factor| product * factor))
    }

    fn power(&self, base: Atom, exponent: Atom) -> Option<Atom> {
        Some(base.pow(exponent))
    }

    fn call(&self, name: &str, operand: Atom) -> Option<Atom> {
        Some(match name {
            "exp" => operand.exp(),
            "ln" => operand.log(),
            "sin" => operand.sin(),
            "cos" => operand.cos(),
            "tan" => operand.sin() / operand.cos(),
            "atan" | "sinh" | "cosh" | "tanh" | "atanh" => function!(symbol!(name), operand),
            _ => return None,
        })
    }
}

/// An expression of Symbolica in words; `None` for what has none.
fn written(atom: AtomView<'_>) -> Option<String> {
    let all = |operands: Vec<Option<String>>, sign| {
        let count = operands.len();
        let operands: Option<Vec<_>> = operands.into_iter().collect();
        Some(format!("{} {sign}{count}", operands?.join(" ")))
    };
    match atom {
        AtomView::Num(_) => Rational::try_from(atom).ok().map(|number| number.to_string()),
        AtomView::Var(name) if name.get_symbol() == Symbol::E => Some("1 exp".to_owned()),
        AtomView::Var(name) => Some(name.get_symbol().get_stripped_name().to_owned()),
        AtomView::Add(sum) => all(sum.iter().map(written).collect(), '+'),
        AtomView::Mul(product) => all(product.iter().map(written).collect(), '*'),
        AtomView::Pow(power) => {
            let (base, exponent) = power.get_base_exp();
            let exponent = written(exponent)?;
            match base {
                AtomView::Var(name) if name.get_symbol() == Symbol::E => {
                    Some(format!("{exponent} exp"))
                }
                base => Some(format!("{} {exponent} ^", written(base)?)),
            }
        }
        AtomView::Fun(call) => {
            let mut operands = call.iter();
            let operand = written(operands.next()?)?;
            let symbol = call.get_symbol();
            let name = symbol.get_stripped_name();
            let name = if name == "log" { "ln" } else { name };
            operands.next().is_none().then(|| format!("{operand} {name}"))
        }
    }
}
