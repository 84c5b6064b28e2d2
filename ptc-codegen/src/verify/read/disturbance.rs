//! The table `[disturbance]`.

use super::{Given, Reader, to_f64};
use crate::diagnostic::{near_miss, shorten};
use crate::parameter::Parameter;
use crate::syntax::Value;
use crate::verify::{Interval, Signal};

impl Reader<'_> {
    pub(super) fn disturbances(
        &mut self,
        given: &Given<'_>,
    ) -> Vec<(Parameter, Interval, Vec<Signal>)> {
        let mut disturbances = Vec::new();
        for (name, (place, node)) in given {
            let key = format!("disturbance.{name}");
            let bounded = self.plant.bounds.iter().find(|(symbol, _)| symbol.spelling() == *name);
            let Some((symbol, (low, high))) = bounded else {
                let message =
                    format!("`{}` has no bounds within which it could vary", shorten(name));
                let help =
                    format!("write `{name} = [-0.1, 0.1]` under [plant], where f or g uses it");
                self.found.push("unknown-key", key, Some(*place), message, help);
                continue;
            };
            let items = match &node.value {
                Value::List(items) => items.as_slice(),
                _ => std::slice::from_ref(*node),
            };
            let mut signals = Vec::new();
            for item in items {
                let word = if let Value::Word(word) = &item.value { word.as_str() } else { "" };
                match (word, Signal::ALL.into_iter().find(|signal| signal.name() == word)) {
                    ("any", _) => signals.extend(Signal::ALL),
                    (_, Some(signal)) => signals.push(signal),
                    _ => {
                        let names = Signal::ALL.map(Signal::name);
                        let meant = near_miss(word, names);
                        let meant =
                            meant.map(|m| format!("did you mean `{m}`? ")).unwrap_or_default();
                        let help = format!("{meant}the signals are {}, or any", names.join(", "));
                        self.wrong(&key, Some(item.place), format!("{key} is not a signal"), &help);
                    }
                }
            }
            if let (Some(low), Some(high)) = (to_f64(low), to_f64(high))
                && !signals.is_empty()
            {
                disturbances.push((*symbol, (low, high), signals));
            }
        }
        disturbances
    }
}
