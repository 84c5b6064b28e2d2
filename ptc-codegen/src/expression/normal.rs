//! Normal forms, in which constants have cancelled exactly: what vanishes at the deadline keeps
//! its digits there.

use super::effort::bounded;
use super::field::{Field, Kernel, Terms, sum};
use super::leading::{Limit, limit};
use super::ratio::{Ratio, exact_quotient};
use super::sign::{Sign, positive_parameters, sign};
use super::{Expression, Function, Node, Variable};
use crate::algebra::{BigRational, Monomial, Poly, Symbol, integer};
use crate::limits::{ALWAYS, GROWTH, PARTS, SIZE};
use crate::parameter::Parameter;

/// The complement tau - mu(t). Parameters are taken as positive, and t >= 0.
pub(crate) fn complement(mu: &Expression) -> Expression {
    bounded(|| complement_of(mu))
}

fn complement_of(mu: &Expression) -> Expression {
    let plain = Expression::from(Parameter::Tau).sub(mu.clone());
    let limited = Expression::from(Parameter::Tau).sub(at_limit(mu));
    let mut field = Field::of(&limited);
    let form = field
        .terms(&limited)
        .and_then(|terms| split(&mut field, terms))
        .and_then(|terms| field.shortest(&terms));
    within(form, &plain)
}

/// The shorter one of an expression and its normal form, which is not sought of what is very long.
pub(crate) fn shorter(expression: Expression) -> Expression {
    if !SIZE.admits(expression.size()) {
        return expression;
    }
    let form = normal(&expression);
    if form.size() <= expression.size() { form } else { expression }
}

/// The normal form: equal to the expression wherever that exists.
pub(crate) fn normal(expression: &Expression) -> Expression {
    let form = bounded(|| {
        let rewritten = logarithmic(expression);
        let mut field = Field::of(&rewritten);
        field.terms(&rewritten).and_then(|terms| field.shortest(&terms))
    });
    within(form, expression)
}

pub(super) fn within(form: Option<Expression>, plain: &Expression) -> Expression {
    let most = plain.size().saturating_mul(GROWTH.size()).saturating_add(ALWAYS.size());
    form.filter(|form| form.size() <= most).unwrap_or_else(|| plain.clone())
}

/// atanh(s) as a logarithm, in which 1 - s is formed before it is rounded.
fn logarithmic(expression: &Expression) -> Expression {
    expression.substitute(&|e| match e.node() {
        Node::Call(Function::Atanh, s) => {
            let (one, s) = (Expression::integer(1), logarithmic(s));
            if !s.twice() {
                return Some(Expression::call(Function::Atanh, s));
            }
            let ratio = one.clone().add(s.clone()).div(one.sub(s));
            Some(Expression::call(Function::Ln, ratio).div(Expression::integer(2)))
        }
        _ => None,
    })
}

/// The signs for positive parameters and t >= 0.
fn from_the_start(name: &Expression) -> Option<Sign> {
    positive_parameters(name)
        .or_else(|| (*name == Variable::SinceStart.into()).then_some(Sign::NotNegative))
}

/// Functions that tend to a constant as t grows: that constant, less what vanishes.
fn at_limit(expression: &Expression) -> Expression {
    let t = Variable::SinceStart;
    let has_cosh = expression.any(&|e| matches!(e.node(), Node::Call(Function::Cosh, _)));
    expression.substitute(&|e| {
        let Node::Call(function, u) = e.node() else { return None };
        match function {
            Function::Tanh | Function::Atan => {}
            // sinh(u) = cosh(u) tanh(u): their quotient then has its limit.
            Function::Sinh if has_cosh => {
                let tanh = at_limit(&Expression::call(Function::Tanh, u.clone()));
                return Some(Expression::call(Function::Cosh, u.clone()).mul(tanh));
            }
            _ => return None,
        }
        let (falls, u) = match limit(u, t)? {
            Limit::Infinite => (false, at_limit(u)),
            Limit::MinusInfinite => (true, at_limit(u).neg()),
            Limit::Finite(_) => return None,
        };
        if !u.twice() {
            return Some(Expression::call(*function, if falls { u.neg() } else { u }));
        }
        let (one, two) = (Expression::integer(1), Expression::integer(2));
        let value = if *function == Function::Tanh {
            let grown = Expression::call(Function::Exp, two.clone().mul(u));
            one.clone().sub(two.div(one.add(grown)))
        } else {
            // pi/2 - atan(u) = atan(1/u) for u > 0, and 2 atan(1/(u + sqrt(1 + u^2))) for all u.
            let vanishing = |of: Expression| Expression::call(Function::Atan, one.clone().div(of));
            let root = one.clone().add(u.clone().power(two.clone()));
            let root = Expression::call(Function::Sqrt, root);
            let rest = match sign(&u, &from_the_start) {
                Some(Sign::Positive | Sign::NotNegative) => vanishing(u),
                _ => two.clone().mul(vanishing(u.add(root))),
            };
            Expression::pi().div(two).sub(rest)
        };
        Some(if falls { value.neg() } else { value })
    })
}

/// Fractions split into their limits and what vanishes, so that the limits cancel.
fn split(field: &mut Field, terms: Terms) -> Option<Terms> {
    let mut result = Vec::new();
    for term in terms {
        for part in without_roots(field, term)? {
            result = sum(result, proper(field, &part)?)?;
        }
    }
    Some(result)
}

/// Whether a symbol depends on time.
pub(super) fn moves(field: &Field, symbol: Symbol) -> bool {
    let inner = |poly: &Poly| poly.symbols().into_iter().any(|s| moves(field, s));
    let ratio = |r: &Ratio| inner(&r.num) || r.den.iter().any(|(f, _)| inner(f));
    match field.kernel(symbol) {
        Some(Kernel::Atom(atom)) => atom.contains(Variable::SinceStart),
        Some(Kernel::Exp(unit)) => ratio(unit),
        Some(Kernel::Root(base, index)) => ratio(base) || index.contains(Variable::SinceStart),
        None => false,
    }
}

/// The symbol of a polynomial that decides how fast it grows: an exponential, else time.
fn fastest(field: &Field, poly: &Poly) -> Option<Symbol> {
    let symbols = poly.symbols();
    let exponential =
        |s: &&Symbol| matches!(field.kernel(**s), Some(Kernel::Exp(_))) && moves(field, **s);
    let time = |s: &&Symbol| {
        let t = Expression::from(Variable::SinceStart);
        matches!(field.kernel(**s), Some(Kernel::Atom(atom)) if *atom == t)
    };
    symbols.iter().find(exponential).or_else(|| symbols.iter().find(time)).copied()
}

/// A fraction as a polynomial and a proper fraction in the symbol that grows fastest.
fn proper(field: &Field, term: &Ratio) -> Option<Terms> {
    let whole = vec![term.clone()];
    let denominator = term.denominator()?;
    let Some(x) = fastest(field, &denominator) else { return Some(whole) };
    let collected = denominator.collect(x);
    let (top, lead) = collected.iter().next_back()?;
    let (mut rest, mut polynomial) = (term.num.clone(), Poly::zero());
    for _ in 0..PARTS.most {
        let by_exponent = rest.collect(x);
        let Some((exponent, coefficient)) = by_exponent.iter().next_back() else { break };
        if exponent < top {
            break;
        }
        let quotient = exact_quotient(coefficient, lead)
            .map(|q| q.shifted(&Monomial::power(x, exponent - top)))
            // What is divided by time would have a pole at the start that the whole has not.
            .filter(|q| {
                q.terms().all(|(m, _)| m.factors().iter().all(|(s, e)| *e > 0 || !moves(field, *s)))
            });
        let Some(quotient) = quotient else { break };
        rest = rest.plus(&super::ratio::times(&quotient, &denominator)?.scaled(&integer(-1)));
        polynomial = polynomial.plus(&quotient);
    }
    if polynomial.is_zero() {
        return Some(whole);
    }
    let mut left = Ratio::of(rest);
    for (factor, count) in &term.den {
        left = left.over(factor, *count)?;
    }
    sum(vec![Ratio::of(polynomial)], vec![left])
}

/// u/S with S = sqrt(c + u^2) is 1 - c/(S (S + u)): in each term with u/S for a growing u.
fn without_roots(field: &mut Field, term: Ratio) -> Option<Terms> {
    let half = Expression::from(BigRational::new(1.into(), 2.into()));
    let mut result = Vec::new();
    for (monomial, c) in term.num.terms() {
        let own = Ratio { num: Poly::term(c.clone(), monomial.clone()), den: term.den.clone() };
        let found = monomial.factors().iter().find_map(|(symbol, exponent)| {
            let Some(Kernel::Root(base, index)) = field.kernel(*symbol) else { return None };
            let fits = *exponent == -1 && *index == half && base.den.is_empty();
            let x = fits.then(|| fastest(field, &base.num)).flatten()?;
            let by_exponent = base.num.collect(x);
            let (top, lead) = by_exponent.iter().next_back()?;
            let (lead, number) = lead.single_term()?;
            let degree = top / 2;
            let even = top % 2 == 0 && degree > 0 && lead.factors().iter().all(|(_, e)| e % 2 == 0);
            let there = monomial.exponent(x) >= degree;
            (even && there)
                .then(|| (*symbol, base.clone(), x, degree, lead.clone(), number.clone()))
        });
        let Some((symbol, base, x, degree, lead, number)) = found else {
            result = sum(result, vec![own])?;
            continue;
        };
        let halved = lead.factors().iter().map(|(s, e)| (*s, e / 2)).collect();
        let scale = Ratio::of(Poly::term(integer(1), Monomial::from_sorted(halved)));
        let scale = scale.times(&field.root(Ratio::number(number.clone()), 1, 2)?)?;
        let u = scale.times(&Ratio::of(Poly::term(integer(1), Monomial::power(x, degree))))?;
        let square = Poly::term(number, lead.times(&Monomial::power(x, 2 * degree)));
        let c = base.num.plus(&square.scaled(&integer(-1)));
        let root = Ratio::of(Poly::symbol(symbol));
        // own = outer * u/S.
        let outer = own.times(&root)?.times(&u.pow(-1)?)?;
        let under = root.times(&root.plus(&u)?)?;
        let vanishing = outer.times(&Ratio::of(c))?.times(&under.pow(-1)?)?;
        result = sum(sum(result, vec![outer])?, vec![vanishing.neg()])?;
    }
    Some(result)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::testing::{evaluate, kappa, mu, random};
    use crate::expression::{Subject, family_form};
    use crate::family::FAMILIES;
    use crate::mapping::{Custom, Form};

    #[test]
    fn complements_are_short() {
        for (text, form) in [
            ("exp", "tau*exp(-a*t)"),
            ("rational", "tau/(1 + a*t)"),
            ("power", "tau*(1 + a*m*t)^(-1/m)"),
            ("tan", "2*tau*atan(1/(a*t))/pi"),
            ("tanh", "2*tau/(1 + exp(2*a*t))"),
            ("algebraic", "tau/(sqrt(1 + a^2*t^2)*(a*t + sqrt(1 + a^2*t^2)))"),
            ("mean(exp(a=a), exp(a=b))", "tau*(exp(-a*t) + exp(-b*t))/2"),
            ("mean(rational(a=1), tanh(a=2))", "tau/(2*(1 + t)) + tau/(1 + exp(4*t))"),
            ("tau*(1 - 1.5*exp(-t) + 0.5*exp(-2*t))", "tau*(3 - exp(-t))*exp(-t)/2"),
            ("tau*(1 - 1/cosh(t))", "tau/cosh(t)"),
            ("tau*sinh(a*t)/cosh(a*t)", "2*tau/(1 + exp(2*a*t))"),
            ("tau*(1 - 2^(-t/a))", "tau*2^(-t/a)"),
            ("tau*(1 - 2^(0/a))", "tau"),
            ("tau*(t + min(t, 1))", "tau*(1 - t - min(t, 1))"),
        ] {
            let got = complement(&mu(text)).to_string();
            assert_eq!(got, form, "{text}");
        }
    }

    #[test]
    fn kappas_are_short_in_time_to_go() {
        for (text, form) in [
            ("-ln(1 - dt/tau)/a", "-ln(T/tau)/a"),
            ("dt/(a*(tau - dt))", "(tau - T)/(a*T)"),
            ("((1 - dt/tau)^(-m) - 1)/(a*m)", "((T/tau)^(-m) - 1)/(a*m)"),
            ("tan(pi*dt/(2*tau))/a", "cos(pi*T/(2*tau))/(a*sin(pi*T/(2*tau)))"),
            ("atanh(dt/tau)/a", "ln((2*tau - T)/T)/(2*a)"),
            ("dt/tau/sqrt(1 - (dt/tau)^2)", "(tau - T)/sqrt(T*(2*tau - T))"),
            ("ln((tau + 9*dt)/(tau - dt))", "ln((10*tau - 9*T)/T)"),
            ("sin(pi*dt/(2*tau))/cos(pi*dt/(2*tau))", "cos(pi*T/(2*tau))/sin(pi*T/(2*tau))"),
        ] {
            let got = Custom::new(Subject::Kappa, kappa(text)).expect(text);
            let got = kappa_of(&got);
            assert_eq!(got.to_string(), form, "{text}");
        }
    }

    fn kappa_of(custom: &Custom) -> Expression {
        match &custom.form {
            Form::Kappa(kappa) => kappa.form.clone(),
            Form::Complement(form) => panic!("{form} has no closed inverse"),
        }
    }

    fn near(got: f64, truth: f64, what: &str) {
        let error = (got - truth).abs();
        assert!(error <= 1e-14 * truth.abs(), "{what}: {got:e} for {truth:e}");
    }

    /// At tau = 2, a = 3/4, m = 1/2.
    fn truth(name: &str, a: f64, t: f64) -> f64 {
        let y = a * t;
        match name {
            "exp" => 2.0 * (-y).exp(),
            "rational" => 2.0 / (1.0 + y),
            "power" => 2.0 * (1.0 + y / 2.0).powi(-2),
            "tanh" => 4.0 / (1.0 + (2.0 * y).exp()),
            _ => 2.0 / ((1.0 + y * y).sqrt() * (y + (1.0 + y * y).sqrt())),
        }
    }

    #[test]
    fn complements_keep_their_digits() {
        for name in ["exp", "rational", "power", "tanh", "algebraic"] {
            let one = complement(&mu(name));
            let two = complement(&mu(&format!("mean({name}(a=1/2), {name}(a=2))")));
            let scaled = complement(&mu(&format!("{name}(a=a/3)*(1 + 2/4)*2/3")));
            for t in [0.0, 1e-3, 0.4, 1.0, 20.0, 37.0, 300.0, 1e3, 4e9] {
                near(evaluate(&one, t), truth(name, 0.75, t), name);
                near(evaluate(&two, t), (truth(name, 0.5, t) + truth(name, 2.0, t)) / 2.0, name);
                near(evaluate(&scaled, t), truth(name, 0.25, t), name);
            }
        }
        let tan = complement(&mu("tan"));
        for (y, truth) in [(0.0, 2.0), (1.0, 1.0), (3f64.sqrt(), 2.0 / 3.0)] {
            near(evaluate(&tan, y / 0.75), truth, "tan");
        }
        near(evaluate(&tan, 1e12), 4.0 / (std::f64::consts::PI * 0.75e12), "tan");
    }

    #[test]
    fn kappas_keep_their_digits() {
        for info in FAMILIES.iter().filter(|info| !info.kappa_in_time_to_go.is_empty()) {
            let given = family_form(info, Subject::Kappa).expect("a form");
            let form = kappa_of(&Custom::new(Subject::Kappa, given.clone()).expect(info.name));
            let twice = given.clone().add(given.clone());
            let twice = kappa_of(&Custom::new(Subject::Kappa, twice).expect(info.name));
            let (a, tau, pi) = (0.75, 2.0, std::f64::consts::PI);
            for to_go in [2e-12f64, 1e-6, 0.1, 1.0] {
                let v = to_go * (2.0 * tau - to_go);
                let truth = match info.name {
                    "exp" => -(to_go / tau).ln() / a,
                    "rational" => (tau - to_go) / to_go / a,
                    "power" => ((tau / to_go).sqrt() - 1.0) / (a * 0.5),
                    "tan" => 1.0 / (a * (pi * to_go / (2.0 * tau)).tan()),
                    "tanh" => ((2.0 * tau - to_go) / to_go).ln() / (2.0 * a),
                    // start = 3/4.
                    "soft" => -(to_go / tau * (1.0 + 0.25 * (1.0 - to_go / tau))).ln() / a,
                    _ => (tau - to_go) / (a * v.sqrt()),
                };
                near(evaluate(&form, to_go), truth, info.name);
                near(evaluate(&twice, to_go), 2.0 * truth, info.name);
            }
        }
    }

    #[test]
    fn what_stands_once_is_inverted() {
        for (name, inverse) in [
            ("exp", "-ln(T/tau)/a"),
            ("rational", "(tau - T)/(a*T)"),
            ("power", "((T/tau)^(-m) - 1)/(a*m)"),
            ("tan", "cos(pi*T/(2*tau))/(a*sin(pi*T/(2*tau)))"),
            ("tanh", "ln((2*tau - T)/T)/(2*a)"),
        ] {
            let custom = Custom::new(Subject::Mu, mu(name)).expect(name);
            assert_eq!(kappa_of(&custom).to_string(), inverse);
        }
    }

    #[test]
    fn what_grows_too_large_stays_as_it_is() {
        let product = (1..9).map(|k| format!("(sqrt({k} + t) + {k})")).collect::<Vec<_>>();
        let given = mu(&format!("tau*(1 - exp(-t)*{})", product.join("*")));
        assert_eq!(complement(&given), Expression::from(Parameter::Tau).sub(given));
    }

    #[test]
    fn the_normal_form_is_the_same_function() {
        let mut seed = 1;
        let (mut compared, mut lost) = (0, 0);
        for _ in 0..5000 {
            let e = random(&mut seed, 4);
            let rest = complement(&e);
            let forms = [normal(&e), Expression::from(Parameter::Tau).sub(rest)];
            for t in [0.37, 1.9] {
                let truth = evaluate(&e, t);
                // Where a small change of t changes much, rounding does too.
                let near = evaluate(&e, t * (1.0 + 1e-12));
                if !(truth.abs() < 1e9 && (near - truth).abs() <= 1e-9 * truth.abs()) {
                    continue;
                }
                for form in &forms {
                    let got = evaluate(form, t);
                    let error = (got - truth).abs() / (1e-2 + truth.abs());
                    assert!(error < 1e-6 || got.is_nan(), "{e} at {t}: {truth}, {got} by {form}");
                    compared += 1;
                    // Of what divides by ln(0) no form has to be finite.
                    lost += usize::from(got.is_nan());
                }
            }
        }
        assert!(compared > 1000 && lost * 100 < compared, "{lost} of {compared}");
    }

    #[test]
    fn what_passes_zero_is_complemented_too() {
        let form = complement(&mu("tau*(atan(t - 3) + atan(3))/(pi/2 + atan(3))"));
        let scale = 2.0 / (std::f64::consts::FRAC_PI_2 + 3f64.atan());
        for t in [0.0, 1.0, 3.0, 5.0] {
            let truth = scale * (std::f64::consts::FRAC_PI_2 - (t - 3.0f64).atan());
            assert!((evaluate(&form, t) - truth).abs() < 1e-14, "at {t}");
        }
        near(evaluate(&form, 3.0 + 1e12), scale * 1e-12, "far out");
    }
}
