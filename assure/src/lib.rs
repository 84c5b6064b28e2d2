//! Evidence about the code that the generator emits. The binary runs the layers and writes the
//! report; the [`harness`] under them serves the tests of the workspace too.

pub mod harness;
