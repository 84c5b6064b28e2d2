//! What runs closed loops, behind the feature `lab`: simulations, campaigns, proofs, the search for a design.
#![cfg(feature = "lab")]

mod design;
mod loop_of_linear;
mod loop_of_model;
mod loop_of_plant;
mod report;
mod reproductions;
#[cfg(unix)]
mod sampled;
mod several_inputs;
mod simulate;
mod simulate_command;
#[path = "../support/mod.rs"]
mod support;
mod verify_command;
mod verify_draws;
mod verify_integrals;
mod verify_lanes;
mod verify_parameters;
mod verify_proofs;
mod verify_references;
mod verify_running;
mod verify_scenarios;
