//! The engines that expand closed forms, behind one seam: an order and a mapping in, closed forms out.
//!
//! The library's own engine expands where a form is needed. Another one is asked once, before the
//! checks, and what it gives goes with the report of the checks to every later stage.

mod part;
mod symbolica;

use crate::expansion::{self, ClosedForms, Expanded};
use crate::mapping::Mapping;
use crate::request::Spec;
use clap::ValueEnum;

pub(crate) use part::Part;

use super::report::Failure;

/// What expands closed forms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Engine {
    /// this program's own: polynomials in the atoms of a family
    Ptc,
    /// the computer algebra system Symbolica, which has a licence of its own
    Symbolica,
}

impl Engine {
    /// The closed forms of `ring` to order `n`; without B_{i,j} unless `part` needs them.
    ///
    /// # Errors
    /// The engine is not installed, may not run, or gives no answer.
    pub(crate) fn expand(
        self,
        n: usize,
        ring: &Mapping,
        part: Part,
    ) -> Result<ClosedForms, Failure> {
        match self {
            Self::Ptc => Ok(ClosedForms {
                r: expansion::r(ring, n),
                bell: if part == Part::R { Vec::new() } else { expansion::table(ring, n) },
            }),
            Self::Symbolica => symbolica::of_ring(n, ring, part),
        }
    }

    /// The closed forms of the design of `spec`, where they come from another engine than the
    /// library's own; the spec names it where its bytes depend on it.
    ///
    /// # Errors
    /// As [`Engine::expand`].
    pub(crate) fn prepare(self, spec: &mut Spec) -> Result<Option<Expanded>, Failure> {
        if self == Self::Ptc {
            return Ok(None);
        }
        let n = spec.n;
        Ok(match (spec.ring(), spec.custom()) {
            (Some(ring), _) if spec.is_iterated() => {
                let free = self.expand(n, &Mapping::free(n), Part::All)?;
                let r = self.expand(n, &ring, Part::R)?.r;
                Some(Expanded::Family(ClosedForms { r, ..free }))
            }
            (Some(ring), _) => Some(Expanded::Family(self.expand(n, &ring, Part::All)?)),
            (None, Some(custom)) => {
                let r = symbolica::of_custom(n, custom)?;
                spec.engine = Some("symbolica");
                Some(Expanded::Custom(r))
            }
            (None, None) => None,
        })
    }
}
