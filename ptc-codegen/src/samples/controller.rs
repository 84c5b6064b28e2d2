//! The controller in samples as one program.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::ToPrimitive;

use super::observer::Injection;
use super::pair::Pair;
use super::rows::{deadbeat, deadbeat_from, rows};
use crate::algebra::{BigInt, BigRational, integer};
use crate::code::{
    Access, Code, Expr, Function, Given, Outcomes, Place, Shape, Statement, Status, Test, Variable,
};
use crate::parameter::{Fixed, Parameter};
use crate::request::{After, Guard, Sampled, Spec};

/// A part of N_o at which the gains of the observer stay once it is through.
const HELD_PART: i64 = 8;

/// The parts of the program while it is being put together.
struct Builder<'a> {
    spec: &'a Spec,
    sampled: &'a Sampled,
    fields: Vec<Variable>,
    /// The value that `init` gives each field.
    values: Vec<(String, Shape, Expr)>,
}

/// The controller of a spec whose clock is in samples.
pub fn controller(spec: &Spec, sampled: &Sampled, head: Vec<String>) -> Code {
    let mut builder = Builder { spec, sampled, fields: Vec::new(), values: Vec::new() };
    let functions = builder.functions();
    Code {
        name: spec.name(),
        precision: spec.precision,
        head,
        parameters: builder.parameters(),
        init: builder.init(),
        fields: builder.fields,
        functions,
    }
}

impl Builder<'_> {
    fn guarded(&self) -> bool {
        self.spec.guard == Guard::Full
    }

    /// A parameter: its number where it is fixed.
    fn parameter(&self, parameter: Parameter) -> Expr {
        match self.spec.fixed.get(&parameter).and_then(Fixed::number) {
            Some(number) => Expr::Number(number.clone()),
            None => match parameter.index() {
                Some(index) => Expr::ParameterElement(parameter.key().to_owned(), index),
                None => Expr::Parameter(parameter.key().to_owned()),
            },
        }
    }

    fn fixed(&self, parameter: Parameter) -> Option<&BigRational> {
        self.spec.fixed.get(&parameter).and_then(Fixed::number)
    }

    /// N, as a count that `init` knows.
    fn samples(&self) -> Expr {
        match self.fixed(Parameter::Samples).and_then(|samples| samples.to_integer().to_u32()) {
            Some(samples) => Expr::Count(samples),
            None => Expr::Parameter(Parameter::Samples.key().to_owned()),
        }
    }

    /// What a later function reads: the number itself, or a field that `init` derives.
    fn keep(&mut self, name: &str, about: &str, value: Expr) -> Expr {
        if matches!(value, Expr::Number(_) | Expr::Count(_)) {
            return value;
        }
        if let Some((name, ..)) = self.values.iter().find(|(_, _, known)| *known == value) {
            return Expr::field(name.clone());
        }
        self.fields.push(Variable::new(name, Shape::Real, about));
        self.values.push((name.to_owned(), Shape::Real, value));
        Expr::field(name)
    }

    fn keep_count(&mut self, name: &str, about: &str, value: Expr) -> Expr {
        self.fields.push(Variable::new(name, Shape::Count, about));
        self.values.push((name.to_owned(), Shape::Count, value));
        Expr::field(name)
    }

    /// A field that a call changes, 0 from `init`.
    fn remember(&mut self, name: &str, about: &str) {
        self.fields.push(Variable::new(name, Shape::Real, about));
        self.values.push((name.to_owned(), Shape::Real, Expr::integer(0)));
    }

    /// h^power, for a power of either sign.
    fn period(&self, power: i64) -> Expr {
        let h = self.parameter(Parameter::SampleTime);
        let product = (0..power.unsigned_abs()).fold(Expr::integer(1), |p, _| p.mul(h.clone()));
        if power < 0 { Expr::integer(1).div(product) } else { product }
    }

    fn functions(&mut self) -> Vec<Function> {
        let start = self.keep_count("start", "tick at which it was armed", Expr::Count(0));
        let samples = self.samples();
        let samples = match samples {
            Expr::Count(_) => samples,
            given => self.keep_count("samples", "samples from the start to rest", given),
        };
        let mut functions = vec![self.arm()];
        functions.push(self.step(&start, &samples));
        if self.sampled.observes() {
            functions.extend(self.estimates());
        }
        functions
    }

    fn arm(&self) -> Function {
        let kept = match self.sampled.observes() || self.sampled.delay > 0 {
            true => " Estimates and inputs under way are kept.",
            false => "",
        };
        Function {
            name: "arm",
            about: format!("Starts again: the deadline is N samples after tick `k`.{kept}"),
            access: Access::Change,
            arguments: vec![Variable::new("k", Shape::Count, "tick")],
            results: Vec::new(),
            failures: Vec::new(),
            body: vec![Statement::Set(Place::Field("start".to_owned()), Expr::local("k"))],
            status: Outcomes::One(Status::Ok),
            guarded: self.guarded(),
        }
    }

    /// Inputs that are remembered, the latest first.
    fn remembered(&self) -> usize {
        self.sampled.delay + usize::from(self.sampled.observes())
    }

    fn step(&mut self, start: &Expr, samples: &Expr) -> Function {
        let measured = self.sampled.measured;
        let given = if self.sampled.observes() { "y" } else { "x" };
        let mut body = Vec::new();
        if self.guarded() {
            let finite = (0..measured).map(|j| Test::Finite(Expr::Element(given.to_owned(), j)));
            body.push(Statement::Require(Test::All(finite.collect()), Status::Input));
        }
        let (real, count) = (Shape::Real, Shape::Count);
        let elapsed = Expr::local("k").count_sub(start.clone());
        body.push(Statement::Let("elapsed".to_owned(), count, elapsed));
        let left = samples.clone().count_left(Expr::local("elapsed"));
        body.push(Statement::Let("left".to_owned(), count, left));
        for i in 1..=self.remembered() {
            let about = match i {
                1 => "input of the last sample".to_owned(),
                i => format!("input of {i} samples ago"),
            };
            self.remember(&format!("u{i}"), &about);
        }
        if self.sampled.observes() {
            body.extend(self.observe(samples));
        } else {
            for j in 0..measured {
                let value = Expr::Element(given.to_owned(), j);
                body.push(Statement::Let(format!("x{}", j + 1), real, value));
            }
        }
        body.extend(self.law());
        body.push(Statement::Require(Test::Finite(Expr::local("v")), Status::Range));
        let mut ways = Vec::new();
        let u = self.clipped(&mut body, &mut ways);
        let mut at_rest = Test::CountEqual(Expr::local("left"), Expr::Count(0));
        if let Some(hold) = self.hold() {
            let hold = self.keep("hold", "samples to go at which the gains are held", hold);
            at_rest = Test::AtMost(Expr::local("left").real(), hold);
        }
        ways.push((at_rest, Status::Hold));
        if self.spec.after == After::Zero {
            let over = Test::CountEqual(Expr::local("left"), Expr::Count(0));
            ways.insert(0, (over, Status::After));
        }
        for i in (1..=self.remembered()).rev() {
            let earlier = if i == 1 { u.clone() } else { Expr::field(format!("u{}", i - 1)) };
            body.push(Statement::Set(Place::Field(format!("u{i}")), earlier));
        }
        if self.sampled.observes() {
            for name in self.estimated() {
                let value = Expr::local(name.clone());
                body.push(Statement::Set(Place::Field(format!("{name}_hat")), value));
            }
            body.push(Statement::Set(Place::Field("seen".to_owned()), Expr::Count(1)));
        }
        let changes = self.remembered() > 0;
        let about = match changes {
            true => "Call it once for each tick.",
            false => "",
        };
        let what = match self.sampled.observes() {
            true => "what is measured, y = (x1, ...)",
            false => "the state x = (x1, x1', ...)",
        };
        Function {
            name: "step",
            about: format!("u from tick `k`, which may wrap, and {what}. {about}"),
            access: if changes { Access::Change } else { Access::Read },
            arguments: vec![
                Variable::new("k", count, "tick"),
                Variable::new(given, Shape::Reals(measured), what),
            ],
            results: vec![Given {
                variable: Variable::new("u", real, "input of the plant"),
                values: vec![u],
            }],
            failures: match self.guarded() {
                true => vec![Status::Input, Status::Range],
                false => vec![Status::Range],
            },
            body,
            status: Outcomes::First(ways, Status::Ok),
            guarded: self.guarded(),
        }
    }

    /// u within its bound, from v.
    fn clipped(&mut self, body: &mut Vec<Statement>, ways: &mut Vec<(Test, Status)>) -> Expr {
        let v = Expr::local("v");
        let infinite = matches!(self.spec.fixed.get(&Parameter::UMax), Some(Fixed::Infinite));
        let zero = self.spec.after == After::Zero;
        if infinite && !zero {
            return v;
        }
        let u = || Place::Local("u_now".to_owned());
        body.push(Statement::Variable("u_now".to_owned(), Shape::Real));
        let mut set = vec![Statement::Set(u(), v.clone())];
        if !infinite {
            let limit = self.parameter(Parameter::UMax);
            let limit = self.keep("u_max", "bound of |u|", limit);
            let below = Test::Less(v.clone(), limit.clone().neg());
            let above = Test::Less(limit.clone(), v);
            ways.push((above.clone(), Status::Saturated));
            ways.push((below.clone(), Status::Saturated));
            let lower = vec![Statement::Set(u(), limit.clone().neg())];
            set = vec![Statement::If(below, lower, set)];
            set = vec![Statement::If(above, vec![Statement::Set(u(), limit)], set)];
        }
        if zero {
            let over = Test::CountEqual(Expr::local("left"), Expr::Count(0));
            set = vec![Statement::If(over, vec![Statement::Set(u(), Expr::integer(0))], set)];
        }
        body.extend(set);
        Expr::local("u_now")
    }

    /// eps in samples; none for 0.
    fn hold(&self) -> Option<Expr> {
        let eps = self.parameter(Parameter::Eps);
        (!eps.is_zero()).then(|| eps.div(self.parameter(Parameter::SampleTime)))
    }

    /// The plant as the controller knows it, undelayed.
    fn plant(&self) -> Pair {
        Pair::chain(self.spec.n, &self.sampled.gain)
    }

    /// v, the input before it is clipped, from the states x1.. and the inputs under way.
    fn law(&mut self) -> Vec<Statement> {
        let order = self.spec.n + self.sampled.delay;
        let pair = self.plant().delayed(self.sampled.delay);
        let Some((s, drift)) = pair.flat() else {
            crate::internal::fault("a chain is not controllable")
        };
        let gains: Vec<_> = (1..=order).map(|i| self.parameter(Parameter::Gain(i))).collect();
        let law = rows(&gains, &self.parameter(Parameter::A));
        let offset = self.offset();
        let mut statements = Vec::new();
        // The inputs under way as they act, with what is added to them.
        let inputs: Vec<Expr> = (0..order)
            .map(|j| match j.checked_sub(self.spec.n) {
                None => Expr::local(format!("x{}", j + 1)),
                Some(i) => Expr::field(format!("u{}", i + 1)).add(offset.clone()),
            })
            .collect();
        let weight = |this: &mut Self, name: String, number: Expr, j: usize| {
            let power = i64::try_from(pair.powers[j]).unwrap_or(0);
            let value = number.mul(this.period(-power));
            this.keep(&name, "weight of a state in the law", value)
        };
        let exact = |value: &BigRational| Expr::Number(value.clone());
        let combine = |this: &mut Self, name: &str, numbers: Vec<Expr>| {
            let terms: Vec<_> = numbers
                .into_iter()
                .enumerate()
                .filter(|(_, number)| !number.is_zero())
                .map(|(j, number)| {
                    weight(this, format!("{name}_{}", j + 1), number, j).mul(inputs[j].clone())
                })
                .collect();
            Expr::sum(terms)
        };
        let mut known = vec![Statement::Note("The exact law in samples.".to_owned())];
        for (i, row) in law.iter().enumerate() {
            let numbers = (0..order).map(|j| row.clone().mul(exact(s.at(i, j)))).collect();
            let name = format!("w{}", i + 1);
            let value = combine(self, &name, numbers);
            known.push(Statement::Let(format!("z{}", i + 1), Shape::Real, value));
        }
        // Deadbeat: the drift is in its gains.
        let column = |factors: &[BigRational], j: usize| {
            let products = factors.iter().enumerate().map(|(i, factor)| factor * s.at(i, j));
            products.fold(BigRational::default(), |sum, product| sum + product)
        };
        let dead: Vec<_> = deadbeat(order).iter().zip(&drift).map(|(b, a)| b - a).collect();
        let dead = (0..order).map(|j| Expr::Number(column(&dead, j))).collect();
        let dead = combine(self, "b", dead);
        let drifts: Vec<_> = drift.iter().map(|a| -a).collect();
        let drifts = (0..order).map(|j| Expr::Number(column(&drifts, j))).collect();
        let drifts = combine(self, "c", drifts);
        let horner = (0..order).fold(Expr::integer(0), |sum, i| {
            let z = Expr::local(format!("z{}", i + 1));
            let now = Expr::local("m0");
            let below = now.sub(Expr::integer(i64::try_from(i).unwrap_or(0)));
            sum.add(z).div(below)
        });
        let v =
            |value: Expr| Statement::Set(Place::Local("v".to_owned()), value.sub(offset.clone()));
        known.push(v(horner.add(drifts)));
        let mut now = Expr::local("left").real();
        let hold = self.hold();
        if let Some(hold) = &hold {
            let hold = self.keep("hold", "samples to go at which the gains are held", hold.clone());
            now = now.max(hold);
        }
        statements.push(Statement::Let("m0".to_owned(), Shape::Real, now));
        statements.push(Statement::Variable("v".to_owned(), Shape::Real));
        let from = self.deadbeat_from(order, hold.is_some());
        let from = self.keep("deadbeat", "samples to go at which deadbeat takes over", from);
        let test = Test::Less(from, Expr::local("m0"));
        let end = vec![Statement::Note("Deadbeat.".to_owned()), v(dead)];
        statements.push(Statement::If(test, known, end));
        statements
    }

    /// Samples to go at which deadbeat takes over.
    fn deadbeat_from(&self, order: usize, held: bool) -> Expr {
        let whole = |i: usize| integer(i64::try_from(i).unwrap_or(0));
        if held {
            // Held gains need no end, but below this the law does not exist.
            return Expr::Number(whole(order) - BigRational::new(1.into(), 2.into()));
        }
        if let Some(given) = self.fixed(Parameter::Deadbeat) {
            return Expr::Number(given.clone());
        }
        match &self.sampled.greatest {
            Some(greatest) => {
                Expr::Number(BigRational::from_integer(deadbeat_from(order, greatest)))
            }
            None => {
                // The exponents sum to k_m/a, and all but one of them are at least m - 1.
                let square = integer(i64::try_from((order - 1) * (order - 1)).unwrap_or(0));
                let sum = self.parameter(Parameter::Gain(order)).div(self.parameter(Parameter::A));
                let last = integer(i64::try_from(order).unwrap_or(0));
                let safe = sum.sub(Expr::Number(square)).add(Expr::Number(last.clone()));
                let safe = safe.max(Expr::Number(last * integer(2)));
                let given = Expr::Parameter(Parameter::Deadbeat.key().to_owned());
                Expr::choose(Test::Less(Expr::integer(0), given.clone()), given, safe)
            }
        }
    }

    /// What is added to u in the plant, known or estimated.
    fn offset(&self) -> Expr {
        let known = Expr::Number(&self.sampled.force / &self.sampled.gain);
        match self.sampled.disturbance {
            true => Expr::local("d").add(known),
            false => known,
        }
    }

    /// What the observer estimates: x_m, ..., x_n, and the disturbance.
    fn estimated(&self) -> Vec<String> {
        let states = self.sampled.measured..=self.spec.n;
        let disturbance = self.sampled.disturbance.then(|| "d".to_owned());
        states.map(|j| format!("x{j}")).chain(disturbance).collect()
    }

    /// The estimates from what is measured: predicted, then corrected.
    fn observe(&mut self, samples: &Expr) -> Vec<Statement> {
        let (measured, real) = (self.sampled.measured, Shape::Real);
        let chain = Pair::chain(self.spec.n + 1 - measured, &self.sampled.gain);
        let pair = if self.sampled.disturbance { chain.with_disturbance() } else { chain };
        let (order, names) = (pair.order(), self.estimated());
        let mut body = vec![Statement::Note("Predict.".to_owned())];
        self.fields.push(Variable::new("seen", Shape::Count, "1 once y has been measured"));
        self.values.push(("seen".to_owned(), Shape::Count, Expr::Count(0)));
        for name in &names {
            self.remember(&format!("{name}_hat"), &format!("estimate of {name}"));
        }
        let power = |j: usize| i64::try_from(pair.powers[j]).unwrap_or(0);
        let acting = Expr::field(format!("u{}", self.remembered()));
        let force = Expr::Number(&self.sampled.force / &self.sampled.gain);
        for i in 0..order {
            let terms: Vec<_> = (0..order)
                .filter(|j| *pair.phi.at(i, *j) != BigRational::default())
                .map(|j| {
                    let value = Expr::Number(pair.phi.at(i, j).clone())
                        .mul(self.period(power(i) - power(j)));
                    let name = format!("phi{}_{}", i + 1, j + 1);
                    let state = Expr::field(format!("{}_hat", names[j]));
                    self.keep(&name, "prediction from a state", value).mul(state)
                })
                .collect();
            let value = Expr::Number(pair.gamma[i].clone()).mul(self.period(power(i)));
            let gamma = self.keep(&format!("gamma{}", i + 1), "prediction from u", value);
            let input = gamma.mul(acting.clone().add(force.clone()));
            body.push(Statement::Let(format!("p{}", i + 1), real, Expr::sum(terms).add(input)));
        }
        body.push(Statement::Note("Correct by what is measured.".to_owned()));
        let y = Expr::Element("y".to_owned(), measured - 1);
        let unseen = Test::CountEqual(Expr::field("seen"), Expr::Count(0));
        let set = |name: &str, value| Statement::Set(Place::Local(name.to_owned()), value);
        body.push(Statement::Variable("base".to_owned(), real));
        body.push(Statement::Variable("miss".to_owned(), real));
        body.push(Statement::If(
            unseen,
            vec![set("base", y.clone()), set("miss", Expr::integer(0))],
            vec![set("base", Expr::local("p1")), set("miss", y.sub(Expr::local("p1")))],
        ));
        body.extend(self.injection(&pair, samples));
        for j in 1..measured {
            let value = Expr::Element("y".to_owned(), j - 1);
            body.push(Statement::Let(format!("x{j}"), real, value));
        }
        for (i, name) in names.iter().enumerate() {
            let base = if i == 0 { "base".to_owned() } else { format!("p{}", i + 1) };
            let correction = Expr::local(format!("l{}", i + 1)).mul(Expr::local("miss"));
            body.push(Statement::Let(name.clone(), real, Expr::local(base).add(correction)));
        }
        body
    }

    /// Whether what is measured is known to be inexact.
    fn is_noisy(&self) -> bool {
        let promises = &self.spec.promises;
        let any = |bounds: &[Fixed]| {
            bounds.iter().any(|b| b.number().is_some_and(|b| *b != BigRational::default()))
        };
        any(&promises.noise) || any(&promises.sensor_step)
    }

    /// The gains l1.. of the observer at this sample.
    fn injection(&mut self, pair: &Pair, samples: &Expr) -> Vec<Statement> {
        let order = pair.order();
        let one = Expr::integer(1);
        let Some(observer) = self.sampled.observer.as_ref() else {
            crate::internal::fault("no poles of the observer")
        };
        let gains: Vec<_> = observer.gains.iter().cloned().map(Expr::Number).collect();
        let law: Vec<_> = rows(&gains, &self.parameter(Parameter::A));
        let law: Vec<_> = law.iter().filter_map(Expr::number).cloned().collect();
        let switch = deadbeat_from(order, &observer.greatest);
        let c: Vec<_> = (0..order).map(|j| integer(i64::from(j == 0))).collect();
        let Some(injection) = Injection::new(pair, &c, &law, &switch) else {
            crate::internal::fault("a chain is not observable")
        };
        let scale = |this: &Self, i: usize| {
            let power = |j: usize| i64::try_from(pair.powers[j]).unwrap_or(0);
            this.period(power(i) - power(0))
        };
        let real = Shape::Real;
        let set = |i: usize, value| Statement::Set(Place::Local(format!("l{}", i + 1)), value);
        let observer_eps = observer.eps.as_ref().and_then(Fixed::number);
        let observer_samples = match self.sampled.observer_samples() {
            Some(samples) => Expr::Count(samples),
            // Half of the time for either: the controller has time to bring down what rounding
            // leaves of the estimates.
            None => samples.clone().count_half(),
        };
        // Where `init` sets N, it is a field by now.
        let mut body = Vec::new();
        let left = observer_samples.clone().count_left(Expr::local("elapsed"));
        body.push(Statement::Let("left_o".to_owned(), Shape::Count, left));
        let from = BigRational::from_integer(switch.clone());
        let going = Expr::local("left_o").real();
        let now = match (observer_eps, self.is_noisy()) {
            (Some(eps), _) => {
                let hold = Expr::Number(eps.clone()).div(self.parameter(Parameter::SampleTime));
                let hold = self.keep("hold_o", "samples to go at which the observer is held", hold);
                going.max(hold)
            }
            // Deadbeat for good would pass every quantum of a sensor on.
            (None, true) => {
                let part = observer_samples.real().div(Expr::integer(HELD_PART));
                let held = part.max(Expr::Number(&from + integer(1)));
                let over = Test::CountEqual(Expr::local("left_o"), Expr::Count(0));
                Expr::choose(over, held, going)
            }
            (None, false) => going,
        };
        body.push(Statement::Let("o0".to_owned(), real, now));
        for i in 0..order {
            body.push(Statement::Variable(format!("l{}", i + 1), real));
        }
        let mut known = Vec::new();
        for j in 0..order {
            let below = Expr::local("o0").sub(Expr::integer(i64::try_from(j).unwrap_or(0)));
            known.push(Statement::Let(format!("r{j}"), real, one.clone().div(below)));
        }
        for (i, (numbers, constant)) in injection.law.iter().enumerate() {
            let unit = scale(self, i);
            let mut sum = Expr::integer(0);
            for (j, number) in numbers.iter().enumerate() {
                let value = Expr::Number(number.clone()).mul(unit.clone());
                let name = format!("q{}_{}", i + 1, j + 1);
                let weight = self.keep(&name, "weight in the observer's gains", value);
                sum = sum.add(weight).mul(Expr::local(format!("r{j}")));
            }
            known.push(set(i, sum.add(Expr::Number(constant.clone()).mul(unit))));
        }
        if observer_eps.is_some() {
            body.extend(known);
            return body;
        }
        let mut end = |below: usize| -> Vec<Statement> {
            let value = |i: usize, this: &mut Self| {
                let number = Expr::Number(injection.end[i][below].clone()).mul(scale(this, i));
                this.keep(&format!("e{below}_{}", i + 1), "gain of the observer at its end", number)
            };
            (0..order).map(|i| set(i, value(i, self))).collect()
        };
        let mut ended = end(order - 1);
        for below in (0..order - 1).rev() {
            let at = switch.clone() - BigInt::from(below);
            let at = Expr::Count(at.to_u32().unwrap_or(u32::MAX));
            let here = end(below);
            ended = vec![Statement::If(Test::CountEqual(Expr::local("left_o"), at), here, ended)];
        }
        body.push(Statement::If(Test::Less(Expr::Number(from), Expr::local("o0")), known, ended));
        body
    }

    /// The functions that give the estimates.
    fn estimates(&self) -> Vec<Function> {
        let give = |name: &'static str, about: &str, result: Given| Function {
            name,
            about: about.to_owned(),
            access: Access::Read,
            arguments: Vec::new(),
            results: vec![result],
            failures: Vec::new(),
            body: Vec::new(),
            status: Outcomes::One(Status::Ok),
            guarded: self.guarded(),
        };
        let mut functions = Vec::new();
        let known = self.sampled.measured;
        let state = |j: usize| Expr::field(format!("x{j}_hat"));
        let values: Vec<_> = (known..=self.spec.n).map(state).collect();
        let xhat = Variable::new("xhat", Shape::Reals(values.len()), "estimates");
        let about = match known {
            1 => "The estimate of the state at the last sample.".to_owned(),
            _ => format!("The estimates of x{known}, ... at the last sample."),
        };
        functions.push(give("estimate", &about, Given { variable: xhat, values }));
        if self.sampled.disturbance {
            let d = Variable::new("d", Shape::Real, "estimate");
            let given = Given { variable: d, values: vec![Expr::field("d_hat")] };
            let about = "The estimate of the constant that is added to u.";
            functions.push(give("disturbance", about, given));
        }
        functions
    }

    /// The parameters left to run time.
    fn parameters(&self) -> Vec<Variable> {
        let mut variables: Vec<Variable> = Vec::new();
        for parameter in self.spec.run_time_parameters() {
            let domain = match parameter {
                Parameter::Samples => {
                    format!("at least {}", self.sampled.least_samples(self.spec.n))
                }
                parameter => parameter.domain().text().to_owned(),
            };
            let unit = parameter.unit_for(self.spec.n + self.sampled.delay);
            let about = format!("{} [{unit}], {domain}", parameter.meaning());
            let shape = match parameter {
                Parameter::Samples => Shape::Count,
                Parameter::Gain(_) => Shape::Reals(self.spec.n + self.sampled.delay),
                _ => Shape::Real,
            };
            if variables.last().is_none_or(|last| last.name != parameter.key()) {
                variables.push(Variable::new(parameter.key(), shape, about));
            }
        }
        variables
    }

    /// `init`: tests of the parameters, the fields, tests of these.
    fn init(&self) -> Vec<Statement> {
        let mut tests: Vec<Test> = Vec::new();
        let zero = Expr::integer(0);
        for parameter in self.spec.run_time_parameters() {
            let value = self.parameter(parameter);
            match parameter {
                Parameter::Samples => {
                    let least = self.sampled.least_samples(self.spec.n);
                    tests.push(Test::CountLess(Expr::Count(least - 1), value));
                }
                Parameter::SampleTime | Parameter::A => {
                    tests.push(Test::Finite(value.clone()));
                    tests.push(Test::Less(zero.clone(), value));
                }
                Parameter::UMax => tests.push(Test::Less(zero.clone(), value)),
                Parameter::Deadbeat => {
                    tests.push(Test::Finite(value.clone()));
                    tests.push(Test::AtMost(zero.clone(), value));
                }
                _ => tests.push(Test::Finite(value)),
            }
        }
        let mut body = Vec::new();
        if !tests.is_empty() {
            body.push(Statement::Require(Test::All(tests), Status::Param));
        }
        let mut finite = Vec::new();
        for (name, shape, value) in &self.values {
            if value.number().is_none() && !matches!(value, Expr::Count(_)) {
                body.push(Statement::Let(name.clone(), *shape, value.local_fields()));
                let given = matches!(value, Expr::Parameter(_));
                if *shape == Shape::Real && !given {
                    finite.push(Test::Finite(Expr::local(name.clone())));
                }
            }
        }
        // Below this the gains of the observer do not exist.
        if self.fields.iter().any(|field| field.name == "hold_o") {
            let order = self.sampled.observer.as_ref().map_or(0, |observer| observer.poles.len());
            let least = integer(i64::try_from(order).unwrap_or(0));
            finite.push(Test::AtMost(Expr::Number(least), Expr::local("hold_o")));
        }
        if !finite.is_empty() {
            body.push(Statement::Require(Test::All(finite), Status::Param));
        }
        for (name, _, value) in &self.values {
            let value = match value {
                Expr::Number(_) | Expr::Count(_) => value.clone(),
                _ => Expr::local(name.clone()),
            };
            body.push(Statement::Set(Place::Field(name.clone()), value));
        }
        body
    }
}
