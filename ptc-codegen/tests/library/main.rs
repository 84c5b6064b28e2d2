//! The library: what it reads, and what the programs compute that it makes of it.

#[path = "../../../tests/support/command.rs"]
mod command;
mod design;
mod examine;
mod follow_ups;
mod heads;
mod identities;
mod limits_apart;
mod overflow;
mod plcopen;
mod robot;
mod spelling;
#[path = "../support/mod.rs"]
mod support;
mod templates;
#[path = "../support/verdicts.rs"]
mod verdicts;
