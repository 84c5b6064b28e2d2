//! The files of the functions.

use super::super::block::{Block, Ends};
use super::super::called::paired;
use super::super::gives::{Gives, required};
use super::super::legal::copies;
use super::super::text::{Text, capital};
use super::Matlab;
use crate::code::{Access, Expr, Finish, Function, Owner, Shape, Status, Subroutine};

impl Matlab<'_> {
    pub(super) fn init(mut self) -> String {
        let (code, noun) = (self.code, self.code.noun());
        let (name, upper) = (&code.name, code.name.to_uppercase());
        let mut list = vec![if code.parameters.is_empty() { "~" } else { "params" }];
        let state = code.start.as_ref().and_then(|start| start.state.as_ref());
        list.extend(state.map(|state| state.name.as_str()));
        let (list, given) = (list.join(", "), list.join(", ").replace('~', "params"));
        self.out.line(format!("function self = {name}_init({list}) %#codegen"));
        self.out.words("%", &format!("{upper}_INIT  {}", code.starts()));
        self.out.line("%");
        self.out.words("%   ", &format!("self = {name}_init({given}) is the {noun}, for the functions that stand beside this one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an error {name}:param, which names what is wrong and what is legal."));
        if !code.parameters.is_empty() {
            self.out.line("%\n%   params is a struct:");
        }
        for parameter in &code.parameters {
            let list = parameter.shape.length().map(|n| format!("(1:{n})")).unwrap_or_default();
            self.out.line(format!("%     {}{list}: {}", parameter.name, parameter.about));
        }
        self.out.line("");
        for line in &code.head {
            self.out.line(format!("% {line}").trim_end());
        }
        self.out.line("");
        for parameter in &code.parameters {
            self.given(&parameter.name, parameter.shape);
        }
        self.raises = Some("the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1".to_owned());
        self.copies = copies(&code.init);
        self.block(&code.init);
        self.copies.clear();
        if let Some(start) = &code.start {
            let mut list = vec!["self".to_owned()];
            list.extend(start.numbers().map(|number| self.alone(number)));
            list.extend(start.state.iter().map(|state| state.name.clone()));
            let called = start.function();
            self.out.line(format!("self = {name}_{called}({});", list.join(", ")));
        }
        self.out.line("end");
        self.out.text()
    }

    /// A parameter in its own type, if it has one.
    fn given(&mut self, name: &str, shape: Shape) {
        let (own, real) = (&self.code.name, self.real_type());
        let kind = if shape == Shape::Count { "uint32" } else { real };
        self.out.line(format!("given.{name} = {kind}(params.{name});"));
        let (test, legal) = match shape {
            Shape::Real | Shape::Gains | Shape::Lists(..) | Shape::Statuses(_) => return,
            Shape::Count => {
                let exact = format!("given.{name} ~= params.{name}");
                (exact, format!("'params.{name} is %g; legal: 0..2^32 - 1', params.{name}"))
            }
            Shape::Reals(n) => {
                let count = format!("numel(params.{name})");
                let legal = format!("'params.{name} has %d numbers; legal: {n}', {count}");
                (format!("{count} ~= {n}"), legal)
            }
        };
        let error = format!("error('{own}:param', {legal});");
        self.out.open(format!("if {test}"));
        self.out.line(error);
        self.out.close("end");
    }

    /// The tables that a function reads.
    fn tables(&mut self, function: &Function) {
        for table in &self.code.tables {
            let mut read = false;
            function.visit(&mut |value| {
                read |= matches!(value, Expr::Tabulated(name, ..) if *name == table.name);
            });
            if !read {
                continue;
            }
            self.out.line(format!("% {}.", capital(&table.about)));
            self.out.open(format!("{} = [", self.table(&table.name)));
            for row in self.rows(table) {
                self.out.line(format!("{};", row.join(", ")));
            }
            self.out.close("];");
        }
    }

    pub(super) fn function(mut self, function: &Function) -> String {
        self.gives = Gives::of(function);
        let result = function.results.first();
        self.result = result.map(|result| result.name.clone()).unwrap_or_default();
        self.signature(function);
        self.tables(function);
        if let (Finish::Stands, Some(count)) = (&function.finish, self.code.axes()) {
            self.inputs(function, count);
            return self.with_helpers(function);
        }
        let (real, zero) = (self.real_type(), self.literal("0.0"));
        match result.map(|result| result.shape) {
            Some(Shape::Real) if self.has_status() => {
                self.out.line(format!("{} = {zero};", self.result));
            }
            Some(Shape::Reals(n)) if self.has_status() => {
                self.out.line(format!("{} = zeros({n}, 1, '{real}');", self.result));
            }
            Some(Shape::Count) if self.has_status() => {
                self.out.line(format!("{} = uint32(0);", self.result));
            }
            Some(Shape::Gains) => self.no_gains(),
            _ => {}
        }
        if function.owner == Owner::Gains {
            self.out.line("status = gains.status;\nif status < 0\n    return;\nend");
        }
        self.arguments(function);
        if self.gives == Gives::Status {
            self.raises = Some(required(function));
        }
        self.block(&function.body);
        if self.gives == Gives::Gains {
            self.gains(function);
        }
        self.finish(&function.finish);
        if self.gives == Gives::Gains {
            self.out.line("gains.status = status;");
        }
        self.with_helpers(function)
    }

    /// Several inputs, which statements give.
    fn inputs(&mut self, function: &Function, count: usize) {
        let (real, refused) = (self.real_type(), Status::Input.number());
        self.out.line(format!("u = zeros({count}, 1, '{real}');"));
        self.out.line(format!("axes = repmat(int32({refused}), {count}, 1);"));
        self.arguments(function);
        self.block(&function.body);
    }

    /// Arguments in their own types.
    fn arguments(&mut self, function: &Function) {
        for argument in &function.arguments {
            let (name, real) = (&argument.name, self.real_type());
            match argument.shape {
                Shape::Count => self.tick(name, self.has_status()),
                _ => self.out.line(format!("{name} = {real}({name});")),
            }
        }
    }

    /// The text of a function, and of those that it calls.
    fn with_helpers(mut self, function: &Function) -> String {
        self.out.line("end");
        let code = self.code;
        let called =
            function.subroutines().map(|of| Matlab::new(code, function.owner).subroutine(of));
        self.out.text() + &called.collect::<String>()
    }

    /// The function of a subroutine.
    fn subroutine(mut self, of: Subroutine) -> String {
        let own = of.given().map(|own| own.name);
        self.out.line("");
        self.out.words("% ", of.about());
        self.out.open(format!("function {} = {}({})", own[0], of.name(), own.join(", ")));
        self.block(&of.body(0));
        self.out.close("end");
        self.out.text()
    }

    fn signature(&mut self, function: &Function) {
        let (name, upper) = (&self.code.name, self.code.name.to_uppercase());
        let called = function.name;
        let changes = function.access == Access::Change;
        let mut gives: Vec<_> =
            function.results.iter().map(|result| result.name.as_str()).collect();
        gives.extend(self.has_status().then_some("status"));
        gives.extend(changes.then_some("self"));
        let gives = match gives.as_slice() {
            [one] => (*one).to_owned(),
            several => format!("[{}]", several.join(", ")),
        };
        let owner = self.owner.trim_end_matches('.');
        let list = function.arguments.iter().map(|argument| argument.name.as_str());
        let list = list.chain(function.callbacks.iter().map(|callback| callback.name));
        let list = std::iter::once(owner).chain(list).collect::<Vec<_>>().join(", ");
        let signature = format!("{gives} = {name}_{called}({list})");
        self.out.line(format!("function {signature} %#codegen"));
        let about = format!("{upper}_{}  {}", called.to_uppercase(), function.about);
        self.out.words("%", &about.replace("  ", " "));
        let kept = if changes { " Keep self: it is what the next call needs." } else { "" };
        let from = if owner == "self" { "init" } else { "tick" };
        self.out.line("%");
        self.out.words("%   ", &format!("{signature}, with {owner} from {name}_{from}.{kept}"));
        for callback in &function.callbacks {
            self.out.words(
                "%   ",
                &format!("{}, a function handle: {}", callback.name, callback.about),
            );
        }
        if function.failures.contains(&Status::Range) {
            self.out.line(if self.gives == Gives::Progress { PROGRESS } else { STATUSES });
            if self.code.is_filter() || self.code.function("deadline").is_some() {
                self.out.line(INFEASIBLE);
            }
        }
        if self.gives == Gives::Count && self.has_status() {
            self.out.line("%     -4  there is none");
        }
        self.out.line("");
    }

    /// Gains as they are where there are none.
    fn no_gains(&mut self) {
        let real = self.real_type();
        for field in &self.code.gains {
            let name = &field.name;
            self.out.line(match field.shape.length() {
                Some(n) => format!("gains.{name} = zeros(1, {n}, '{real}');"),
                None => format!("gains.{name} = {};", self.literal("0.0")),
            });
        }
        self.out
            .line(format!("status = int32({});\ngains.status = status;", Status::Input.number()));
    }

    fn gains(&mut self, function: &Function) {
        let values = function.finish.every();
        let places = self.code.gains.iter().flat_map(|field| match field.shape.length() {
            Some(n) => (1..=n).map(|i| format!("{}({i})", field.name)).collect(),
            None => vec![field.name.clone()],
        });
        for (place, value) in paired(places, values) {
            let value = self.alone(value);
            self.out.line(format!("gains.{place} = {value};"));
        }
    }

    /// A tick of any numeric type, modulo 2^32.
    pub(super) fn tick(&mut self, name: &str, has_status: bool) {
        self.out.line(format!("{name} = double({name});"));
        self.out.open(format!("if ~(isfinite({name}) && ({name} == floor({name})))"));
        match has_status {
            true => self.out.line(format!("status = int32({});\nreturn;", Status::Input.number())),
            false => {
                let own = &self.code.name;
                let error = format!("error('{own}:param', '{name} is %g; legal: whole', {name});");
                self.out.line(error);
            }
        }
        self.out.close("end");
        self.out.line(format!("{name} = uint32(mod({name}, 4294967296));"));
    }
}

const PROGRESS: &str = "\
%
%   status (int32); on a negative one self is as it was:
%      0  tracking
%      1  hold: the round of the observer is over
%      4  gated: a reading was not believed, the estimates are predicted; wins over 1
%     -2  an argument is not finite, or a tick is not whole
%     -3  an estimate is not finite";

/// The further status of a filter.
const INFEASIBLE: &str =
    "%      6  infeasible: nothing is known from here that keeps all limits or bounds, u is valid";

const STATUSES: &str = "\
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite";
