//! The `step` of several axes.

use super::super::block::Block;
use super::super::text::{Text, bare};
use super::C;
use crate::code::{AXIS, Axes, Expr, Finish, Function, Shape, Statement, Test};
use crate::internal::fault;

/// The first axis whose u is not given as it is.
const WITHIN: &str = "within";

impl C<'_> {
    /// What `tick` does, and then what `axis` does for all axes.
    pub(super) fn axes(&mut self, function: &Function, axes: &Axes) {
        let fails = self.ticks();
        let lists = function.arguments.iter().filter(|a| matches!(a.shape, Shape::Lists(..)));
        self.rows = lists.map(|argument| argument.name.clone()).chain(["v".to_owned()]).collect();
        self.owner = "gains.";
        if fails {
            self.out.open("if (status >= PTC_OK) {");
        }
        self.out.line("const ptc_status now = status;");
        if let Some(bound) = &axes.bound {
            let (real, bound) = (self.type_of(Shape::Real), self.alone(bound));
            self.out.line(format!("const {real} bound = {bound};"));
        }
        self.values(axes);
        self.tests(axes);
        if fails {
            let zero = self.literal("0.0");
            self.out.turn("} else {");
            self.each(axes, "0U", |this| {
                this.out.line(format!("u[axis] = {zero};\naxes[axis] = status;"));
            });
            self.out.close("}");
        }
        self.rows.clear();
    }

    /// What `tick` does, and whether it can fail. A call of `tick` would test the pointers once more and pass
    /// the gains through memory. Its names end with a block, as those of an axis may be the same.
    fn ticks(&mut self) -> bool {
        let Some(tick) = self.code.function("tick") else { fault("axes without a tick") };
        let fails = !tick.failures.is_empty();
        let gains = self.type_of(Shape::Gains);
        self.out.line(format!("{gains} gains;\n"));
        self.gains = "gains.";
        if fails {
            // Analysers do not see that the status tells whether it is set; compilers leave it out.
            for field in self.code.gains.iter().filter(|field| field.shape == Shape::Real) {
                let line = format!("gains.{} = {};", field.name, self.literal("0.0"));
                self.out.line(line);
            }
        } else {
            self.out.open("{");
        }
        self.nested(&tick.body, &mut |this| this.finish(tick, &tick.finish, false));
        if !fails {
            self.out.close("}");
        }
        fails
    }

    /// u of all axes before the tests, in an array of its own, as u may lie where x does. Sums that lie in
    /// arrays are formed for all axes before those made of them, which compilers turn into vector
    /// instructions. Without such sums lines for each axis take fewer instructions than a loop with -O2; the tests
    /// of a quotient are written once.
    fn values(&mut self, axes: &Axes) {
        let (real, count) = (self.type_of(Shape::Real), axes.count);
        let mut body = axes.body.as_slice();
        let is_array = |statement: &Statement| matches!(statement, Statement::Array(..));
        while let Some(at) = body.iter().position(is_array)
            && let Some((Statement::Array(name, sums), before)) = body[..=at].split_last()
        {
            self.out.line(format!("{real} {name}[{count}][{}];\n", sums.len()));
            self.each(axes, "0U", |this| {
                this.block(before);
                for (place, sum) in sums.iter().enumerate() {
                    let sum = this.alone(sum);
                    this.out.line(format!("{name}[axis][{place}] = {sum};"));
                }
            });
            self.rows.push(name.clone());
            body = &body[at + 1..];
        }
        self.out.line(format!("{real} v[{count}];\n"));
        if body.len() < axes.body.len() || divides(axes) {
            self.each(axes, "0U", |this| this.value(axes, body));
        } else {
            for axis in 0..count {
                self.axis = axis.to_string();
                if body.is_empty() {
                    self.value(axes, body);
                } else {
                    self.out.open("{");
                    self.value(axes, body);
                    self.out.close("}");
                }
            }
            self.axis = AXIS.to_owned();
        }
        for axis in 0..count {
            self.out.line(format!("u[{axis}] = v[{axis}];"));
        }
    }

    /// v of an axis.
    fn value(&mut self, axes: &Axes, body: &[Statement]) {
        self.block(body);
        let (axis, value) = (self.axis.clone(), self.alone(&axes.value));
        self.out.line(format!("v[{axis}] = {value};"));
    }

    /// The statuses, and what is given from the first axis on whose v is not legal.
    fn tests(&mut self, axes: &Axes) {
        let (zero, count) = (self.literal("0.0"), axes.count);
        self.each(axes, "0U", |this| this.out.line("axes[axis] = now;"));
        self.out.line(format!("\nuint32_t {WITHIN} = 0U;"));
        let count_of = Expr::Count(u32::try_from(count).unwrap_or(u32::MAX));
        let is_one = Test::CountLess(Expr::local(WITHIN), count_of);
        self.axis = WITHIN.to_owned();
        let parts = self.all(&[is_one, axes.legal.clone()]);
        self.axis = AXIS.to_owned();
        let line = self.out.joined("while (", &parts, ("&&", "\n    && "), ") {");
        self.out.open(line);
        self.out.line(format!("{WITHIN}++;"));
        self.out.close("}");
        self.out.open(format!("if ({WITHIN} < {count}U) {{"));
        let legal = bare(self.test(&axes.legal));
        self.each(axes, WITHIN, |this| {
            this.out.open(format!("if (!({legal})) {{"));
            this.refused(axes);
            this.out.line("if (status >= PTC_OK) {\n    status = axes[axis];\n}");
            this.out.close("}");
        });
        let mut clips = false;
        axes.otherwise.each(&mut |end| clips |= matches!(end, Finish::Give(..)));
        // Without a bound what is not legal fails.
        if clips {
            self.out.open("if (status < PTC_OK) {");
        }
        self.each(axes, "0U", |this| this.out.line(format!("u[axis] = {zero};")));
        if clips {
            self.out.close("}");
        }
        self.out.close("}");
    }

    /// What an axis gives whose v is not legal.
    fn refused(&mut self, axes: &Axes) {
        let Some(axis) = self.code.function("axis") else { fault("axes without an axis") };
        self.stored = None;
        self.zeroed = false;
        self.ends(axis, &axes.otherwise, false);
    }

    /// A loop over the axes from the `first` on.
    fn each(&mut self, axes: &Axes, first: &str, inside: impl FnOnce(&mut Self)) {
        self.out.open(format!("for (uint32_t axis = {first}; axis < {}U; axis++) {{", axes.count));
        inside(self);
        self.out.close("}");
    }
}

/// Whether v is a quotient, which tests its divisor.
fn divides(axes: &Axes) -> bool {
    let mut found = false;
    let mut look = |value: &Expr| found |= matches!(value, Expr::Quotient(..));
    axes.value.visit(&mut look);
    axes.body.iter().for_each(|statement| statement.visit(&mut look));
    found
}
