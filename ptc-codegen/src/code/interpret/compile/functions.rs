//! Steps of functions and their ends.

use std::collections::BTreeMap;

use super::Writer;
use crate::code::interpret::tape::{Ended, Routine, Slots, Step};
use crate::code::{Ending, Finish, Function, Owner, Shape, Status};
use crate::internal::fault;

impl<'c> Writer<'c> {
    pub(super) fn function(
        &mut self,
        function: &'c Function,
        [fields, gains]: &[BTreeMap<String, Slots>; 2],
    ) -> Routine {
        self.fields = match function.owner {
            Owner::Controller => fields.clone(),
            Owner::Gains => gains.clone(),
        };
        let arguments = self.variables(&function.arguments);
        self.locals = function
            .arguments
            .iter()
            .map(|a| a.name.as_str())
            .zip(arguments.iter().map(|a| a.slots))
            .collect();
        let gives_gains = function.results.iter().any(|result| result.shape == Shape::Gains);
        let gives = if gives_gains { &self.code.gains } else { &function.results };
        self.results = self.variables(gives);
        self.settled = self.fresh(1).first;
        self.block(&function.body);
        self.finish(&function.finish);
        let steps = self.finished();
        Routine {
            name: function.name,
            arguments,
            results: std::mem::take(&mut self.results),
            stands: function.finish == Finish::Stands,
            steps,
        }
    }

    /// The steps of a function, with the ends of those that fail.
    pub(super) fn finished(&mut self) -> Vec<Step> {
        for (step, status) in std::mem::take(&mut self.failing) {
            self.land(&[step]);
            self.fail(status);
        }
        std::mem::take(&mut self.steps)
    }

    /// A call that fails gives 0, and its status for each input.
    fn fail(&mut self, status: Status) {
        let [zero, number] = [0.0, f64::from(status.number())].map(|value| self.constant(value));
        for result in self.results.clone() {
            let of_status = matches!(result.shape, Shape::Statuses(_));
            for to in result.slots.range() {
                self.copy(if of_status { number } else { zero }, to);
            }
        }
        self.steps.push(Step::Give(Ended::Known(status)));
    }

    fn finish(&mut self, finish: &'c Finish) {
        match finish {
            Finish::If(test, yes, no) => {
                let otherwise = self.unless(test);
                self.finish(yes);
                self.land(&otherwise);
                self.finish(no);
            }
            Finish::Give(values, ending) => {
                let places = self.results.iter().flat_map(|result| result.slots.range());
                for (to, value) in places.collect::<Vec<_>>().into_iter().zip(values) {
                    self.expression(value, to);
                }
                self.steps.push(Step::Give(match ending {
                    Ending::Known(status) => Ended::Known(*status),
                    Ending::OfGains => Ended::OfGains,
                }));
            }
            Finish::Fail(status) => self.fail(*status),
            Finish::Stands => self.steps.push(Step::Stands(self.settled)),
        }
    }

    /// The slots of a result.
    pub(super) fn results(&self, place: usize) -> Slots {
        let result = self.results.get(place);
        result.unwrap_or_else(|| fault("statements give no result of the function")).slots
    }
}
