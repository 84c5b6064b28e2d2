//! From a parsed value to an expression: what each name means, and what is wrong with it.

use super::existence::needs;
use super::function::OF_TWO;
use super::names::{self, Found};
use super::{Expression, Function, Node, Subject, Variable, power_bits};
use crate::algebra::integer;
use crate::collect::listed;
use crate::diagnostic::{Diagnostics, LARGE, Place, counted, near_miss, shorten};
use crate::family::{FAMILIES, FamilyInfo};
use crate::limits::{ARGUMENTS, BITS, Limit, SIZE};
use crate::parameter::{Fixed, Name, Parameter};
use crate::syntax::{self, Argument, Operator, Value, parse};

/// Constants of C and Arduino, each of which would otherwise be a parameter, and how they are written.
const CONSTANTS: [(&str, &str); 14] = [
    ("M_PI", "pi"),
    ("M_PI_2", "pi/2"),
    ("M_PI_4", "pi/4"),
    ("M_1_PI", "1/pi"),
    ("M_2_PI", "2/pi"),
    ("M_E", "exp(1)"),
    ("M_LN2", "ln(2)"),
    ("M_LN10", "ln(10)"),
    ("M_SQRT2", "sqrt(2)"),
    ("M_SQRT1_2", "sqrt(1/2)"),
    ("PI", "pi"),
    ("HALF_PI", "pi/2"),
    ("TWO_PI", "2*pi"),
    ("DEG_TO_RAD", "pi/180"),
];

/// The name of the integral over a run.
pub const INTEGRAL: &str = "integral";

/// Scope of an expression: the meaning of names.
#[derive(Clone, Copy)]
pub struct Scope<'a> {
    /// Purpose of the expression.
    pub subject: Subject,
    /// Order n of the chain.
    pub n: usize,
    /// The parameters that have a name of their own, beside those that the user names.
    pub known: &'a [Parameter],
    /// The names of a model, which come before all others.
    pub own: &'a [(Name, Variable)],
}

/// The expression that `node` stands for; on failure, records a diagnostic in
/// `found`.
pub fn resolve(
    node: &syntax::Node,
    scope: Scope<'_>,
    found: &mut Diagnostics,
) -> Option<Expression> {
    let mut resolver = Resolver { scope, before: found.len(), found };
    let expression = resolver.node(node)?;
    // With its constants and families written out it still has to be one that can be read: this
    // bounds its height, and its spelling gives it back.
    match parse(scope.subject.key(), &expression.to_string(), &mut |_| Place(0)) {
        Ok(_) => Some(expression),
        Err(wrong) => {
            let message = format!("{}, its constants and families written out", wrong.message);
            resolver.too_large(node.place, message, &wrong.help)
        }
    }
}

struct Resolver<'a, 'b> {
    scope: Scope<'a>,
    /// Mistakes found before this expression.
    before: usize,
    found: &'b mut Diagnostics,
}

impl Resolver<'_, '_> {
    fn node(&mut self, node: &syntax::Node) -> Option<Expression> {
        let expression = self.operation(node)?;
        let (limit, size) = match expression.node() {
            Node::Number(n) => (BITS, n.numer().bits().max(n.denom().bits()) as usize),
            _ if matches!(node.value, Value::Call(..)) => (SIZE, expression.size()),
            _ => return Some(expression),
        };
        if limit.admits(size) { Some(expression) } else { self.exceeded(&limit, size, node.place) }
    }

    /// The expression at `place` exceeds a limit.
    fn exceeded(&mut self, limit: &Limit, size: usize, place: Place) -> Option<Expression> {
        let message = limit.exceeded(self.scope.subject.key(), size);
        self.too_large(place, message, limit.fix)
    }

    fn too_large(&mut self, place: Place, message: String, fix: &str) -> Option<Expression> {
        self.found.push(LARGE, self.scope.subject.key(), Some(place), message, fix);
        None
    }

    fn operation(&mut self, node: &syntax::Node) -> Option<Expression> {
        match &node.value {
            Value::Number(Fixed::Number { value, .. }) => Some(Expression::from(value.clone())),
            Value::Number(Fixed::Infinite | Fixed::MinusInfinite) => self.wrong(
                node.place,
                "`inf` is not a number that can be computed with".to_owned(),
                "leave the term out, or give a finite number",
            ),
            Value::Imaginary(unit) if *unit == 1.into() && self.own("i").is_some() => self.own("i"),
            Value::Imaginary(_) => self.wrong(
                node.place,
                "a complex number in a real expression".to_owned(),
                "complex numbers are for `poles`; call a parameter something else than `i`",
            ),
            Value::List(_) => self.wrong(
                node.place,
                "a list in an expression".to_owned(),
                "use one of its elements: brackets [] hold lists, () group operations",
            ),
            Value::Table(_) => self.wrong(
                node.place,
                "a table in an expression".to_owned(),
                "braces are for `dynamics` and `let`; () group operations",
            ),
            Value::Word(name) | Value::File(name, _) => self.name(name, node.place),
            Value::Call(name, arguments) => self.call(name, arguments, node.place),
            Value::Negative(a) => Some(self.node(a)?.neg()),
            Value::Binary(operator, a, b) => {
                let operands = (self.node(a), self.node(b));
                let (Some(left), Some(right)) = operands else { return None };
                if *operator == Operator::Div && right == Expression::integer(0) {
                    return self.wrong(
                        b.place,
                        "a division by zero".to_owned(),
                        "the divisor is the number 0, whatever the parameters are",
                    );
                }
                if let (Operator::Power, Some(base), Some(k @ -64..=64)) =
                    (operator, left.number(), right.small_integer())
                {
                    let bits = power_bits(base, k);
                    if !BITS.admits(bits / 2) {
                        return self.exceeded(&BITS, bits, node.place);
                    }
                }
                let zero = Expression::integer(0);
                Some(match operator {
                    Operator::Mul
                        if left == zero && self.stays(&right)
                            || right == zero && self.stays(&left) =>
                    {
                        Node::Mul(left, right).into()
                    }
                    Operator::Power if right == zero && self.stays(&left) => {
                        Node::Power(left, right).into()
                    }
                    Operator::Add => left.add(right),
                    Operator::Sub => left.sub(right),
                    Operator::Mul => left.mul(right),
                    Operator::Div => left.div(right),
                    Operator::Power => left.power(right),
                })
            }
        }
    }

    /// Returns the variable that a name of the model denotes.
    fn own(&self, name: &str) -> Option<Expression> {
        let (_, variable) = self.scope.own.iter().find(|(own, _)| own.text() == name)?;
        Some((*variable).into())
    }

    /// Returns true if 0*e and e^0 stay as they are written: where it matters whether e has a value, unless it always
    /// has one. A mapping, a law and the emitted code use the simplified form.
    fn stays(&self, e: &Expression) -> bool {
        use Subject::{Bound, Drift, Objective, PlantGain, PlantRate};
        matches!(self.scope.subject, Drift | PlantGain | PlantRate | Bound | Objective)
            && !needs(e).is_empty()
    }

    /// A mistake, which is reported at the first place in the expression that makes it.
    fn wrong(&mut self, place: Place, message: String, help: &str) -> Option<Expression> {
        if !self.found.says(&message, self.before) {
            self.found.push("bad-expression", self.scope.subject.key(), Some(place), message, help);
        }
        None
    }

    fn name(&mut self, name: &str, place: Place) -> Option<Expression> {
        if let Some(own) = self.own(name) {
            return Some(own);
        }
        let subject = self.scope.subject;
        match names::find(name, subject, self.scope.n) {
            Found::Is(expression) => return Some(expression),
            Found::Wrong { message, help } => return self.wrong(place, message, &help),
            Found::Free => {}
        }
        if let Some(parameter) = self.scope.known.iter().find(|p| p.spelling() == name) {
            return Some(Expression::from(*parameter));
        }
        if matches!(subject, Subject::Mu | Subject::Kappa)
            && FAMILIES.iter().any(|info| info.name == name)
        {
            return self.family(name, &[], place);
        }
        if functions(subject).any(|function| function == name) {
            return self.wrong(
                place,
                format!("the function `{name}` has no argument"),
                &format!("write {name}(...)"),
            );
        }
        if let Some((_, meant)) = CONSTANTS.iter().find(|(constant, _)| *constant == name) {
            let message = format!("`{name}` is a constant of other languages, not a parameter");
            return self.wrong(place, message, &format!("write {meant}"));
        }
        match Name::new(name) {
            Some(name) => Some(Expression::from(Parameter::Named(name))),
            None => self.wrong(
                place,
                format!("`{}` cannot name a parameter", shorten(name)),
                "it means something in C or Rust, or is longer than 48 letters: choose another name",
            ),
        }
    }

    fn call(&mut self, name: &str, arguments: &[Argument], place: Place) -> Option<Expression> {
        let is_family = matches!(self.scope.subject, Subject::Mu | Subject::Kappa)
            && FAMILIES.iter().any(|info| info.name == name);
        let named = arguments.iter().find_map(|a| a.name.as_ref());
        let function = Function::ALL.iter().find(|(function, _)| *function == name);
        if is_family && (named.is_some() || function.is_none()) {
            return self.family(name, arguments, place);
        }
        if !is_family
            && function.is_none()
            && let Found::Wrong { message, help } = names::find(name, self.scope.subject, 0)
            && FAMILIES.iter().any(|info| info.name == name)
        {
            return self.wrong(place, message, &help);
        }
        if let Some((argument, place)) = named {
            let message = format!("the function `{}` takes no named argument", shorten(name));
            return self.wrong(*place, message, &format!("leave `{argument} =` out"));
        }
        let mut values = Vec::with_capacity(arguments.len());
        for argument in arguments {
            values.push(self.node(&argument.value));
        }
        let values: Vec<_> = values.into_iter().collect::<Option<_>>()?;
        let count = values.len();
        let of_two = OF_TWO.iter().find(|(two, _)| *two == name);
        match (name, function, count) {
            ("min" | "max" | "mean", ..) if !ARGUMENTS.admits(count) => {
                self.exceeded(&ARGUMENTS, count, place)
            }
            (_, Some((_, function)), 1) => {
                Some(Expression::call(*function, values.into_iter().next()?))
            }
            (_, None, 2) if of_two.is_some() => {
                let mut values = values.into_iter();
                of_two.map(|(_, of)| Some(of(values.next()?, values.next()?)))?
            }
            (_, None, _) if of_two.is_some() => {
                let message = format!("`{name}` takes two arguments and is given {count}");
                self.wrong(place, message, &format!("write {name}(a, b)"))
            }
            ("min", ..) if count >= 2 => values.into_iter().reduce(Expression::min),
            ("max", ..) if count >= 2 => values.into_iter().reduce(Expression::max),
            ("mean", ..) if count >= 1 => {
                let share = Expression::from(integer(1) / integer(i64::try_from(count).ok()?));
                Some(values.into_iter().reduce(Expression::add)?.mul(share))
            }
            (_, Some(_), _) => {
                let message = format!("`{name}` takes one argument and is given {count}");
                self.wrong(place, message, &format!("write {name}(x)"))
            }
            ("min" | "max" | "mean", ..) => {
                let message = format!("`{name}` is given {}", counted(&count, "argument"));
                self.wrong(place, message, "min and max take two or more, mean one or more")
            }
            (INTEGRAL, ..) => self.wrong(
                place,
                "an integral outside of an objective's h".to_owned(),
                "integrals over a run are for `h` of the bound `within`, where they are bounded by `low` and `high`",
            ),
            _ => {
                let meant = match name {
                    "log" => Some("ln"),
                    "sgn" => Some("sign"),
                    "arctan" => Some("atan"),
                    _ => near_miss(name, functions(self.scope.subject)),
                };
                let all = functions(self.scope.subject).collect::<Vec<_>>().join(", ");
                let meant = meant.map(|m| format!("did you mean `{m}`? ")).unwrap_or_default();
                let message = format!("unknown function `{}`", shorten(name));
                self.wrong(place, message, &format!("{meant}the functions are {all}"))
            }
        }
    }

    /// A family's mapping with its parameters in place, as part of a greater mapping.
    fn family(&mut self, name: &str, arguments: &[Argument], place: Place) -> Option<Expression> {
        let info = FAMILIES.iter().find(|info| info.name == name)?;
        let Some(form) = family_form(info, self.scope.subject) else {
            let message = format!("`{name}` cannot be part of an expression");
            return self.wrong(place, message, "write its terms out: mean(exp(a=1), exp(a=2))");
        };
        let mut given = Vec::new();
        for argument in arguments {
            let value = self.node(&argument.value)?;
            match &argument.name {
                Some((key, _)) if info.parameters.contains(&key.as_str()) => {
                    given.push((Expression::from(named(key)?), value));
                }
                _ => {
                    let message = format!("an argument that `{name}` does not have");
                    let help = format!("its parameters are {}", info.parameters.join(", "));
                    return self.wrong(argument.value.place, message, &help);
                }
            }
        }
        let given = |e: &Expression| given.iter().find(|(key, _)| key == e).map(|(_, v)| v.clone());
        let form = form.substitute(&given);
        let zero = Expression::integer(0);
        if form.any(&|e| matches!(e.node(), Node::Div(_, divisor) if *divisor == zero)) {
            let message = format!("`{name}` with a parameter that is 0 divides by zero");
            return self.wrong(place, message, "its parameters are > 0");
        }
        Some(form)
    }
}

/// The names of all functions. An objective has integrals over the run too, which are names before it is read.
fn functions(subject: Subject) -> impl Iterator<Item = &'static str> + Clone {
    let own = (subject == Subject::Objective).then_some(INTEGRAL);
    let of_two = OF_TWO.iter().map(|(name, _)| *name);
    let all = Function::ALL.iter().map(|(name, _)| *name).chain(of_two);
    listed(all.chain(["min", "max", "mean"]).chain(own))
}

fn named(key: &str) -> Option<Parameter> {
    Name::new(key).map(Parameter::Named)
}

/// The mu of a family in `t` or its kappa, with its own parameters by name; none for `exp_sum`.
pub fn family_form(family: &FamilyInfo, subject: Subject) -> Option<Expression> {
    let (text, within) = match subject {
        Subject::Mu => (family.mu, Subject::Mu),
        _ => (family.kappa_in_time_to_go, Subject::Family),
    };
    let node = parse(subject.key(), text, &mut |_| Place(0)).ok()?;
    let scope = Scope { subject: within, n: 0, known: &[Parameter::Tau], own: &[] };
    let form = resolve(&node, scope, &mut Diagnostics::default())?;
    let elapsed = Expression::from(Parameter::Tau).sub(Variable::Elapsed.into());
    let time_to_go = Expression::from(Variable::TimeToGo);
    let in_elapsed = subject == Subject::Kappa;
    Some(form.substitute(&|e| (in_elapsed && *e == time_to_go).then(|| elapsed.clone())))
}
