//! Prescribed time in samples: the controller that is at rest exactly at sample N of its loop.
//!
//! Between samples a held input moves the plant by x_{k+1} = Phi x_k + Gamma u_k ([`crate::linear`]). In the
//! coordinates z = S x that is an Euler chain, and the rows that Theorem 1 gives for the mapping
//! `exp` (`rows`) are exact in it with falling powers of time-to-go in place of powers:
//! u = sum_j row_j z_j/((T - (j-1) h) ... (T - (m-1) h)). By duality the same rows give an observer
//! (`observer`). [`controller()`] stages both into one imperative program: `start` is its `init`,
//! `feedback` and `estimates` are parts of its `step`. `alone` makes a program of the observer without
//! a law, of the same parts, and `filter` one that keeps bounds under any law. `gate` decides which readings correct the estimates. A plant with several inputs has a law for each output (`chains`), and the
//! `step` of `inputs`.

mod alone;
mod chains;
mod controller;
mod coordinates;
mod ends;
mod estimates;
mod falling;
mod feedback;
mod filter;
mod flight;
mod formula;
mod gains;
mod gate;
mod inputs;
mod model;
#[cfg(feature = "files")]
mod numbers;
mod observer;
mod offset;
mod predicted;
mod reference;
mod rows;
mod scheduled;
mod staged;
mod start;
mod terminal;

pub use controller::controller;
pub(crate) use ends::{Ending, Terminal, end_of_law, held_samples, is_noisy, observer_held};
#[cfg(feature = "files")]
pub use numbers::Numbers;
pub(crate) use rows::rows_of_numbers;
