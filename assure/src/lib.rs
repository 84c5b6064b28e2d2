//! Evidence about the code that the generator emits. The binary runs the layers and writes the
//! report; the [`harness`] under them serves the tests of the workspace too.

pub mod context;
pub mod harness;
pub mod kept;
pub mod layer;
pub mod layers;
pub mod report;
pub mod tool;
