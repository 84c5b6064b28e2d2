//! An independent grammar of Structured Text: IEC 61131-3, second edition, annex B, as far as emitted code goes,
//! without the extensions that vendors add.
//!
//! It demands what iec2c of Beremiz and OpenPLC does beyond it: literals of LREAL in the range of 32-bit floats, no
//! anonymous arrays among inputs, no structures among temporaries, and declarations before their use.

use std::collections::BTreeSet;

use super::words::{Word, words};

/// Types without a declaration.
const ELEMENTARY: [&str; 7] = ["BOOL", "INT", "DINT", "UDINT", "REAL", "LREAL", "USINT"];

/// Functions without a declaration; conversions are any of `A_TO_B`.
const STANDARD: [&str; 19] = [
    "ABS", "SQRT", "LN", "LOG", "EXP", "EXPT", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "SEL",
    "MIN", "MAX", "LIMIT", "MUX", "MOD", "TRUNC",
];

/// Sizes of the literals of iec2c, which reads those of LREAL as 32-bit floats too.
const RANGE: [f64; 2] = [f32::MIN_POSITIVE as f64, f32::MAX as f64];

/// Binary operators, in no order of precedence: it decides no more than the tree.
const OPERATORS: [&str; 14] =
    ["OR", "XOR", "AND", "&", "=", "<>", "<", ">", "<=", ">=", "+", "-", "*", "/"];

/// Fault of a file, with its line.
type Wrong = String;

/// Parses a file that may call functions of others.
///
/// # Errors
/// The first line that the grammar does not take.
pub(super) fn parse(text: &str, others: &[String]) -> Result<(), Wrong> {
    let functions = others.iter().map(|name| name.to_uppercase()).collect();
    let mut parser = Parser { words: words(text)?, functions, ..Parser::default() };
    while parser.peek(0).is_some() {
        parser.declaration()?;
    }
    Ok(())
}

#[derive(Default)]
struct Parser {
    words: Vec<Word>,
    at: usize,
    /// Names of types, structures apart, and of functions, in capitals as names have no case.
    types: BTreeSet<String>,
    structures: BTreeSet<String>,
    functions: BTreeSet<String>,
}

impl Parser {
    fn peek(&self, ahead: usize) -> Option<&str> {
        self.words.get(self.at + ahead).map(|word| word.text.as_str())
    }

    fn is(&self, text: &str) -> bool {
        self.peek(0) == Some(text)
    }

    fn wrong<T>(&self, wanted: &str) -> Result<T, Wrong> {
        let Some(word) = self.words.get(self.at) else {
            return Err(format!("the file ends where {wanted} should be"));
        };
        Err(format!("line {}: `{}` where {wanted} should be", word.line, word.text))
    }

    fn eat(&mut self, text: &str) -> Result<(), Wrong> {
        if !self.is(text) {
            return self.wrong(&format!("`{text}`"));
        }
        self.at += 1;
        Ok(())
    }

    fn takes(&mut self, text: &str) -> bool {
        let is = self.is(text);
        self.at += usize::from(is);
        is
    }

    fn name(&mut self) -> Result<String, Wrong> {
        match self.words.get(self.at) {
            Some(word) if word.is_name() => {
                self.at += 1;
                Ok(self.words[self.at - 1].text.to_uppercase())
            }
            _ => self.wrong("a name"),
        }
    }

    fn declaration(&mut self) -> Result<(), Wrong> {
        if self.takes("TYPE") {
            while !self.takes("END_TYPE") {
                self.type_of_its_own()?;
            }
            return Ok(());
        }
        let is_function = self.takes("FUNCTION");
        if !is_function && !self.takes("FUNCTION_BLOCK") {
            return self.wrong("TYPE, FUNCTION or FUNCTION_BLOCK");
        }
        let name = self.name()?;
        if is_function {
            self.eat(":")?;
            self.known_type()?;
            self.functions.insert(name);
        }
        while self.peek(0).is_some_and(|word| word.starts_with("VAR")) {
            self.variables()?;
        }
        let end = if is_function { "END_FUNCTION" } else { "END_FUNCTION_BLOCK" };
        self.statements(&[end])?;
        self.eat(end)
    }

    /// One declaration between TYPE and END_TYPE, which ends with a semicolon.
    fn type_of_its_own(&mut self) -> Result<(), Wrong> {
        let name = self.name()?;
        self.eat(":")?;
        if self.takes("STRUCT") {
            while !self.takes("END_STRUCT") {
                self.name()?;
                self.eat(":")?;
                self.specification(true)?;
                self.eat(";")?;
            }
            self.structures.insert(name.clone());
        } else {
            self.specification(true)?;
        }
        self.types.insert(name);
        self.eat(";")
    }

    /// A type, or an array of one.
    fn specification(&mut self, arrays: bool) -> Result<String, Wrong> {
        if !self.is("ARRAY") {
            return self.known_type();
        }
        if !arrays {
            return self.wrong("the name of a type");
        }
        self.at += 1;
        self.eat("[")?;
        loop {
            self.integer()?;
            self.eat("..")?;
            self.integer()?;
            if !self.takes(",") {
                break;
            }
        }
        self.eat("]")?;
        self.eat("OF")?;
        self.known_type()
    }

    fn integer(&mut self) -> Result<(), Wrong> {
        let is_integer =
            self.peek(0).is_some_and(|word| word.bytes().all(|byte| byte.is_ascii_digit()));
        if !is_integer {
            return self.wrong("an integer");
        }
        self.at += 1;
        Ok(())
    }

    fn known_type(&mut self) -> Result<String, Wrong> {
        let word = self.peek(0).unwrap_or_default().to_uppercase();
        if !ELEMENTARY.contains(&word.as_str()) && !self.types.contains(&word) {
            return self.wrong("a type that is declared");
        }
        self.at += 1;
        Ok(word)
    }

    fn variables(&mut self) -> Result<(), Wrong> {
        let kind = self.peek(0).unwrap_or_default().to_owned();
        if !["VAR", "VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT", "VAR_TEMP"].contains(&kind.as_str()) {
            return self.wrong("a section of variables");
        }
        self.at += 1;
        if kind == "VAR" {
            self.takes("CONSTANT");
        }
        while !self.takes("END_VAR") {
            self.name()?;
            while self.takes(",") {
                self.name()?;
            }
            self.eat(":")?;
            let own = self.specification(kind == "VAR")?;
            if kind == "VAR_TEMP" && self.structures.contains(&own) {
                self.at -= 1;
                return self.wrong("a type that a temporary may have");
            }
            if self.takes(":=") {
                self.initial()?;
            }
            self.eat(";")?;
        }
        Ok(())
    }

    /// An initial value: a number, or those of an array.
    fn initial(&mut self) -> Result<(), Wrong> {
        if !self.takes("[") {
            return self.expression();
        }
        self.constant()?;
        while self.takes(",") {
            self.constant()?;
        }
        self.eat("]")
    }

    /// A literal, whose sign stands behind its type.
    fn constant(&mut self) -> Result<(), Wrong> {
        let Some(word) = self.words.get(self.at) else { return self.wrong("a constant") };
        if !word.is_literal() || !word.is_within(RANGE) {
            return self.wrong("a literal in the range of REAL");
        }
        self.at += 1;
        Ok(())
    }

    fn statements(&mut self, ends: &[&str]) -> Result<(), Wrong> {
        while !self.peek(0).is_none_or(|word| ends.contains(&word)) {
            self.statement()?;
        }
        Ok(())
    }

    fn statement(&mut self) -> Result<(), Wrong> {
        if self.takes("IF") {
            self.condition()?;
        } else if self.takes("FOR") {
            self.name()?;
            self.eat(":=")?;
            self.expression()?;
            self.eat("TO")?;
            self.expression()?;
            if self.takes("BY") {
                self.expression()?;
            }
            self.eat("DO")?;
            self.statements(&["END_FOR"])?;
            self.eat("END_FOR")?;
        } else if self.takes("WHILE") {
            self.expression()?;
            self.eat("DO")?;
            self.statements(&["END_WHILE"])?;
            self.eat("END_WHILE")?;
        } else if !self.takes("RETURN") && !self.takes("EXIT") {
            self.variable()?;
            self.eat(":=")?;
            self.expression()?;
        }
        self.eat(";")
    }

    fn condition(&mut self) -> Result<(), Wrong> {
        loop {
            self.expression()?;
            self.eat("THEN")?;
            self.statements(&["ELSIF", "ELSE", "END_IF"])?;
            if !self.takes("ELSIF") {
                break;
            }
        }
        if self.takes("ELSE") {
            self.statements(&["END_IF"])?;
        }
        self.eat("END_IF")
    }

    /// A name with fields and subscripts.
    fn variable(&mut self) -> Result<(), Wrong> {
        self.name()?;
        loop {
            if self.takes(".") {
                self.name()?;
            } else if self.takes("[") {
                self.expression()?;
                while self.takes(",") {
                    self.expression()?;
                }
                self.eat("]")?;
            } else {
                return Ok(());
            }
        }
    }

    fn expression(&mut self) -> Result<(), Wrong> {
        self.operand()?;
        while self.peek(0).is_some_and(|word| OPERATORS.contains(&word) || word == "MOD") {
            self.at += 1;
            self.operand()?;
        }
        Ok(())
    }

    fn operand(&mut self) -> Result<(), Wrong> {
        // One sign or NOT: the grammar does not allow two in a row.
        if !self.takes("NOT") {
            self.takes("-");
        }
        if self.takes("(") {
            self.expression()?;
            return self.eat(")");
        }
        let Some(word) = self.words.get(self.at) else { return self.wrong("an operand") };
        if word.is_literal() {
            if !word.is_within(RANGE) {
                return self.wrong("a literal in the range of REAL");
            }
            self.at += 1;
            return Ok(());
        }
        if self.peek(1) == Some("(") {
            return self.call();
        }
        self.variable()
    }

    fn call(&mut self) -> Result<(), Wrong> {
        let name = self.peek(0).unwrap_or_default().to_uppercase();
        let is_conversion = name
            .split_once("_TO_")
            .is_some_and(|(from, to)| ELEMENTARY.contains(&from) && ELEMENTARY.contains(&to));
        let is_known = STANDARD.contains(&name.as_str()) || self.functions.contains(&name);
        if !is_known && !is_conversion {
            return self.wrong("a function that is declared");
        }
        self.at += 1;
        self.eat("(")?;
        loop {
            self.expression()?;
            if !self.takes(",") {
                break;
            }
        }
        self.eat(")")
    }
}

#[cfg(test)]
mod tests;
