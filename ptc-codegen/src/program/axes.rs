//! u of several axes in one program, for what runs all of them.

use super::passes::append;
use super::{Input, Op, Program, Stage, Value};

impl Program {
    /// Extends a program whose `axis` is that of one of `count` axes of order `n` to the inputs of all: the same
    /// operations on the values that `tick` hands over to each, and on the states of all axes, one after the other.
    #[must_use]
    pub(crate) fn of_all_axes(mut self, n: usize, count: usize) -> Self {
        let Some(axis) = self.axis.take() else { return self };
        let mut of_one = self.needed(&[axis]);
        of_one.retain(|value| self.get(*value).stage == Stage::Step);
        // What the axes share stands there once.
        let own = |all: &[Value], place: usize| all[place % all.len()];
        let mut controls = Vec::with_capacity(count);
        for index in 0..count {
            let mut map: Vec<_> = (0..self.values.len()).map(Value).collect();
            for value in &of_one {
                let input = |input| Op::Input(input);
                let op = match self.get(*value).op.map(|operand| map[operand.0]) {
                    Op::Input(Input::State(j)) => input(Input::State(index * n + j)),
                    Op::Input(Input::Reference(order)) => {
                        input(Input::ReferenceOf(index + 1, order))
                    }
                    op => op,
                };
                map[value.0] = match op {
                    Op::Input(Input::Gain(j)) => own(&self.gains, index * n + j - 1),
                    Op::Input(Input::Divisor) => own(&self.divisors, index),
                    op => append(&mut self, op, None),
                };
            }
            controls.push(map[axis.0]);
        }
        self.step = controls.remove(0);
        self.others = controls;
        for handed in [&mut self.gains, &mut self.divisors, &mut self.bounds, &mut self.lower] {
            handed.clear();
        }
        self.parts.clear();
        self
    }
}
