//! The engines that expand closed forms, behind one seam: an order and a mapping in, closed forms out.
//!
//! The library's own engine expands where a form is needed. Another one is asked once, before the
//! checks, and what it gives stands in the spec; every later stage takes it from there.

#[cfg(feature = "symbolica")]
pub(crate) mod symbolica;
#[cfg(not(feature = "symbolica"))]
#[path = "absent.rs"]
mod symbolica;

mod part;

use clap::ValueEnum;
use ptc_codegen::expansion::{self, ClosedForms, Expanded};
use ptc_codegen::mapping::Mapping;
use ptc_codegen::spec::Spec;

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
    /// The closed forms of `ring` to order `n`; without B_{i,j} where `part` does not ask for them.
    ///
    /// # Errors
    /// The engine is not built in, may not run, or gives no answer.
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

    /// The spec with the closed forms of its design, where they come from another engine than the
    /// library's own.
    ///
    /// # Errors
    /// As [`Engine::expand`].
    pub(crate) fn prepare(self, mut spec: Spec) -> Result<Spec, Failure> {
        if self == Self::Ptc {
            return Ok(spec);
        }
        let n = spec.n;
        spec.expanded = Some(match (spec.ring(), spec.custom()) {
            (Some(ring), _) if spec.is_iterated() => {
                let free = self.expand(n, &Mapping::free(n), Part::All)?;
                let r = self.expand(n, &ring, Part::R)?.r;
                Expanded::Family(ClosedForms { r, ..free })
            }
            (Some(ring), _) => Expanded::Family(self.expand(n, &ring, Part::All)?),
            (None, Some(custom)) => {
                Expanded::Custom { engine: "symbolica", r: symbolica::of_custom(n, custom)? }
            }
            (None, None) => return Ok(spec),
        });
        Ok(spec)
    }
}
