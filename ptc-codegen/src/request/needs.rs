//! Requirements on a request, for features that do not support every kind of it.

use super::{Reference, Spec, What};
use crate::diagnostic::{Diagnostic, Diagnostics};

impl Spec {
    /// Refuses a clock in samples for what knows time alone.
    ///
    /// # Errors
    /// That `what` does not know it.
    pub fn needs_time(&self, what: &str) -> Result<(), Vec<Diagnostic>> {
        let message = format!("{what} does not know a clock in samples yet");
        let help = "leave `clock` out, or emit and simulate it alone";
        unless(self.sampled().is_some(), ("clock", "clock"), message, help)
    }

    /// Refuses a reference that each call is given for what makes the calls itself.
    ///
    /// # Errors
    /// That `what` has none to give.
    pub fn needs_known_reference(&self, what: &str) -> Result<(), Vec<Diagnostic>> {
        let message = format!("{what} has no reference to give to each call");
        let help = "give `reference` as an expression in t: the same law follows it";
        let given = self.reference == Some(Reference::Input);
        unless(given, ("reference", "reference"), message, help)
    }

    /// Refuses several axes for what knows one chain alone.
    ///
    /// # Errors
    /// That `what` knows one.
    pub fn needs_one_axis(&self, what: &str) -> Result<(), Vec<Diagnostic>> {
        if self.coupled.is_some() {
            let message = format!("{what} does not know a plant of several inputs yet");
            let help = "`simulate` and `verify` do, and `emit` writes its code";
            return unless(true, ("axes", "inputs"), message, help);
        }
        let message = format!("{what} knows one chain, not several axes");
        let help = match self.axes.as_ref().is_some_and(super::Axes::differ) {
            true => {
                "leave `axes` out, and give the gains, limit and g of one axis: each is a chain of its own"
            }
            false => "leave `axes` out: each axis is the same chain",
        };
        unless(self.axes.is_some(), ("axes", "axes"), message, help)
    }

    /// Refuses fused operations for what knows an operation with one rounding of its own alone.
    ///
    /// # Errors
    /// That `what` does not know them.
    pub fn needs_no_fma(&self, what: &str) -> Result<(), Vec<Diagnostic>> {
        let message = format!("{what} does not know fused multiply-adds");
        let help = "leave `fma` out: the plain controller differs in roundings alone";
        unless(self.fma, ("unsupported", "fma"), message, help)
    }

    /// Refuses a filter for what calls a controller by the measurement alone.
    ///
    /// # Errors
    /// That `what` has no u for it.
    pub fn needs_no_filter(&self, what: &str) -> Result<(), Vec<Diagnostic>> {
        let message = format!("{what} has no controller whose u a filter could take");
        let help = "emit the filter in a language, and call it between your controller and the plant in your own program";
        unless(self.what == What::Filter, ("not-alone", "what"), message, help)
    }

    /// Refuses an observer or a filter alone for what runs a law.
    ///
    /// # Errors
    /// That `what` needs a law.
    pub fn needs_law(&self, what: &str) -> Result<(), Vec<Diagnostic>> {
        self.needs_no_filter(what)?;
        let message = format!("{what} needs a law, and an observer alone has none");
        let help = "leave `what` out for the controller of the design, or emit the observer and call it from your own program";
        unless(self.what == What::Observer, ("not-alone", "what"), message, help)
    }
}

/// A mistake of this code at this key, if it is one.
fn unless(
    wrong: bool,
    (code, key): (&'static str, &'static str),
    message: String,
    help: &str,
) -> Result<(), Vec<Diagnostic>> {
    let mut found = Diagnostics::default();
    if wrong {
        found.push(code, key, None, message, help);
    }
    found.finish(Some(()))
}
