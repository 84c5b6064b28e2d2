//! Commands of the block: functions of a clock in samples that are neither `arm` nor the call of each tick. Each has a
//! Boolean input, and its arguments are inputs with its name before theirs.

use super::super::block::{Block, Ends};
use super::StructuredText;
use super::library::{Kind, Member};
use crate::code::{Function, Shape, Variable};

impl StructuredText<'_> {
    /// The commands, by the names of their functions.
    pub(super) fn commands(&self) -> Vec<Function> {
        self.code.commands().cloned().collect()
    }

    /// The inputs of the commands.
    pub(super) fn inputs_of_commands(&self) -> Vec<Member> {
        let mut inputs = Vec::new();
        for command in self.commands() {
            let about = command.about.split(". ").next().unwrap_or_default().trim_end_matches('.');
            inputs.push(Member::new(flag(&command), Kind::Elementary("BOOL"), about));
            for argument in self.of_its_own(&command) {
                let name = given(&command, &argument.name);
                inputs.push(Member::new(name, self.kind(argument.shape), &argument.about));
            }
        }
        inputs
    }

    /// The outputs of the commands.
    pub(super) fn outputs_of_commands(&self) -> Vec<Member> {
        let commands = self.commands().into_iter();
        let of = |command: Function| {
            let result = command.results.first()?;
            Some(Member::new(found(&command, result), self.kind(result.shape), &result.about))
        };
        commands.filter_map(of).collect()
    }

    /// The arguments that the call of each tick does not have.
    fn of_its_own<'f>(&self, command: &'f Function) -> impl Iterator<Item = &'f Variable> {
        let known: Vec<(String, Shape)> =
            self.call().arguments.iter().map(|own| (own.name.clone(), own.shape)).collect();
        let is_known = move |own: &Variable| {
            known.iter().any(|(name, shape)| *name == own.name && *shape == own.shape)
        };
        command.arguments.iter().filter(move |own| !is_known(own))
    }

    /// Prints the branch of each command.
    pub(super) fn run_commands(&mut self) {
        for command in self.commands() {
            self.out.turn(format!("ELSIF {} THEN", flag(&command)));
            let names = self.of_its_own(&command);
            self.given = names.map(|own| (own.name.clone(), given(&command, &own.name))).collect();
            self.found = command.results.first().map(|result| found(&command, result));
            self.block(&command.body);
            self.finish(&command.finish);
            self.given.clear();
            self.found = None;
            self.give_outputs();
        }
    }

    /// A test that the call is none of a command.
    pub(super) fn no_command(&self) -> Option<String> {
        let flags: Vec<_> = self.commands().iter().map(flag).collect();
        (!flags.is_empty()).then(|| format!("NOT ({})", flags.join(" OR ")))
    }

    /// Describes the commands.
    pub(super) fn about_commands(&self) -> Option<String> {
        let flags: Vec<_> = self.commands().iter().map(flag).collect();
        let all = flags.join(", ");
        (!flags.is_empty()).then(|| {
            format!("Before the call of a tick it may be called with one of {all}, and what\nthese are given; u stays as it is. On a negative status nothing has changed.")
        })
    }
}

/// The input that asks for a command. `move` alone is a word of the language.
fn flag(command: &Function) -> String {
    match command.name {
        "move" => "move_target".to_owned(),
        name => name.to_owned(),
    }
}

/// The input that holds an argument.
fn given(command: &Function, argument: &str) -> String {
    format!("{}_{argument}", command.name)
}

/// The output that holds a result.
fn found(command: &Function, result: &Variable) -> String {
    format!("{}_{}", command.name, result.name)
}
