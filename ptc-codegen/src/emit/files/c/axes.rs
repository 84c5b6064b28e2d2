//! The `step` of several axes.

use super::super::text::{Text, bare};
use super::C;
use crate::code::{Axes, Finish, Function, Shape};
use crate::internal::fault;

impl C<'_> {
    /// `tick`, and then what `axis` does, for all axes in one loop after the other.
    pub(super) fn axes(&mut self, function: &Function, axes: &Axes) {
        let name = &self.code.name;
        let (zero, gains) = (self.literal("0.0"), self.type_of(Shape::Gains));
        let real = self.type_of(Shape::Real);
        let Axes { count, .. } = axes;
        self.out.line(format!(
            "{gains} gains;\nconst ptc_status now = {name}_tick(self, t, &gains);\n\nstatus = now;"
        ));
        let lists = function.arguments.iter().filter(|a| matches!(a.shape, Shape::Lists(..)));
        self.rows = lists.map(|argument| argument.name.clone()).chain(["v".to_owned()]).collect();
        self.owner = "gains.";
        let tick = self.code.function("tick");
        let fails = tick.is_some_and(|tick| !tick.failures.is_empty());
        if fails {
            self.out.open("if (now >= PTC_OK) {");
        }
        if let Some(bound) = &axes.bound {
            let bound = self.alone(bound);
            self.out.line(format!("const {real} bound = {bound};"));
        }
        // An array of its own: the compiler does not know that u is apart from x.
        self.out.line(format!("{real} v[{count}];\nuint32_t beyond = 0U;\n"));
        self.each(axes, |this| {
            this.block(&axes.body, &mut |_| {});
            let value = this.alone(&axes.value);
            this.out.line(format!("v[axis] = {value};"));
        });
        let legal = bare(self.test(&axes.legal));
        self.each(axes, |this| this.out.line(format!("beyond |= ({legal}) ? 0U : 1U;")));
        self.each(axes, |this| this.out.line("u[axis] = v[axis];"));
        self.each(axes, |this| this.out.line("axes[axis] = now;"));
        self.out.open("if (beyond != 0U) {");
        self.each(axes, |this| {
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
        self.each(axes, |this| this.out.line(format!("u[axis] = {zero};")));
        if clips {
            self.out.close("}");
        }
        self.out.close("}");
        if fails {
            self.out.turn("} else {");
            self.each(axes, |this| {
                this.out.line(format!("u[axis] = {zero};\naxes[axis] = now;"));
            });
            self.out.close("}");
        }
        self.rows.clear();
    }

    /// What an axis gives whose v is not legal.
    fn refused(&mut self, axes: &Axes) {
        let Some(axis) = self.code.function("axis") else { fault("axes without an axis") };
        self.stored = None;
        self.zeroed = false;
        self.ends(axis, &axes.otherwise, false);
    }

    /// A loop over the axes.
    fn each(&mut self, axes: &Axes, inside: impl FnOnce(&mut Self)) {
        self.out.open(format!("for (uint32_t axis = 0U; axis < {}U; axis++) {{", axes.count));
        inside(self);
        self.out.close("}");
    }
}
