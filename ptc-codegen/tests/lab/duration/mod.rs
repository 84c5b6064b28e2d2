//! A duration that changes in flight, with a clock in time: `arm_for` against a fresh controller whose parameters hold the
//! same duration, bit for bit, in the emitted C and Rust, and what runs and refuses it.

mod designs;
#[cfg(unix)]
mod in_c;
#[cfg(unix)]
mod in_rust;
mod requests;
mod runs;
