//! Closed loops: emitted controllers of every kind of plant against exact solutions, and what runs loops behind the
//! feature `lab`: simulations, campaigns, proofs, the search for a design; FMUs, and the time that large designs take.
//! `cargo assure loops` runs it, optimised.
#![cfg(feature = "lab")]

mod bounds;
mod check;
mod check_picture;
#[path = "../../../tests/support/command.rs"]
mod command;
mod compare;
mod contradictions;
#[cfg(unix)]
mod controller_in_c;
mod design;
mod digits;
mod duration;
mod events;
mod examined;
mod expanded;
#[cfg(unix)]
mod fmu;
mod larger_plants;
mod limits_apart;
mod loop_edges;
mod loop_of_exact;
mod loop_of_linear;
mod loop_of_model;
mod loop_of_plant;
mod loop_of_reference;
mod loop_of_several;
mod looped;
mod margins;
mod models;
mod one_design;
mod references;
mod report;
mod reproductions;
mod resonances;
mod rest_points;
mod robots;
#[cfg(unix)]
mod sampled;
mod samples;
mod samples_linear;
#[cfg(unix)]
mod samples_observer;
mod several_inputs;
mod simulate;
mod simulate_command;
mod stability_margins;
mod started;
#[path = "../support/mod.rs"]
mod support;
mod transcripts;
#[path = "../support/verdicts.rs"]
mod verdicts;
mod verify_code_lanes;
mod verify_command;
mod verify_draws;
mod verify_edges;
mod verify_events;
mod verify_integrals;
mod verify_lanes;
mod verify_parameters;
mod verify_proofs;
mod verify_references;
#[cfg(unix)]
mod verify_runner;
mod verify_running;
mod verify_scenarios;
mod verify_stiff;
mod verify_sums;
mod zero_dynamics;
