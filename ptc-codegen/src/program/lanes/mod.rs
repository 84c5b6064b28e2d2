//! A program for several sets of inputs at once: each value is a pack of numbers, one for each lane,
//! and each operation is a loop over the lanes.
//!
//! Lanes do not see each other, so that a lane has the bits of a [`Machine`](super::machine::Machine)
//! with its inputs, whatever is in the others.

mod pack;
mod perform;
mod tape;

use std::sync::Arc;

pub use pack::{LANES, Pack};
pub(crate) use pack::{vectorized, with_vectors};

use super::{Input, Op, Program, Stage, Value};
use crate::parameter::Precision;
pub(crate) use perform::apply;
use perform::perform;
use tape::{Tape, with_products};

/// A program in lanes. Only programs in f64 without a user's law run in them.
#[derive(Clone, Debug)]
pub struct Lanes {
    tape: Arc<Tape>,
    registers: Vec<Pack>,
    arrays: Vec<Vec<Pack>>,
}

/// Register in which a program in lanes holds an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Register(usize);

impl Lanes {
    /// `program`, of which `outputs` are looked at; `None` where it does not run in lanes.
    pub fn new(program: &Program, outputs: &[Value]) -> Option<Self> {
        if program.precision != Precision::F64 {
            return None;
        }
        let needed = program.needed(outputs);
        let mut places = vec![usize::MAX; program.values.len()];
        for (place, value) in needed.iter().enumerate() {
            places[value.0] = place;
        }
        let mut stages: Vec<_> =
            needed.iter().map(|value| (program.get(*value).stage, None)).collect();
        let mut uses = vec![0; needed.len()];
        outputs.iter().for_each(|output| uses[places[output.0]] += 1);
        for value in &needed {
            let definition = program.get(*value);
            // What a loop repeats may run later than its operands are known.
            let reader = if definition.looped { Stage::Step } else { definition.stage };
            definition.op.each_operand(|operand| {
                let (_, last) = &mut stages[places[operand.0]];
                *last = (*last).max(Some(reader));
                uses[places[operand.0]] += 1;
            });
        }
        let mut tape = Tape { due: Default::default(), inputs: Vec::new(), places, stages, uses };
        for value in &needed {
            let definition = program.get(*value);
            match &definition.op {
                _ if definition.looped => {}
                Op::Input(input) => {
                    tape.inputs.push((*input, Register(tape.places[value.0])));
                }
                _ => {
                    let instruction = tape.instruction(program, *value)?;
                    tape.due[definition.stage as usize].push(instruction);
                }
            }
        }
        tape.due = tape.due.map(|due| with_products(due, &tape.uses));
        let count = needed.len();
        let mut lanes = Self {
            tape: Arc::new(tape),
            registers: vec![Pack::all(f64::NAN); count],
            arrays: vec![Vec::new(); count],
        };
        lanes.run(Stage::Generation);
        Some(lanes)
    }

    /// Returns the register that holds `input`, if the outputs need it.
    pub fn register(&self, input: Input) -> Option<Register> {
        self.inputs().find(|(own, _)| *own == input).map(|(_, register)| register)
    }

    /// The inputs that the outputs need.
    pub fn inputs(&self) -> impl Iterator<Item = (Input, Register)> {
        self.tape.inputs.iter().copied()
    }

    /// Sets an input of one lane.
    pub fn set(&mut self, register: Register, lane: usize, value: f64) {
        self.registers[register.0].0[lane] = value;
    }

    /// Sets an input of all lanes. An unused input has no register.
    #[inline]
    pub fn fill(&mut self, register: Option<Register>, values: &Pack) {
        if let Some(Register(place)) = register {
            self.registers[place] = *values;
        }
    }

    /// Sets some registers.
    #[inline(always)]
    pub fn recall(&mut self, registers: &[Register], values: &[Pack]) {
        for (Register(place), own) in registers.iter().zip(values) {
            self.registers[*place] = *own;
        }
    }

    /// Computes what the inputs of `stage` decide, those of earlier stages being computed.
    #[inline]
    pub fn run(&mut self, stage: Stage) {
        let Self { tape, registers, arrays } = self;
        perform(&tape.due[stage as usize], registers, arrays);
    }

    /// The registers that are known before `stage`.
    pub fn before(&self, stage: Stage) -> impl Iterator<Item = Register> {
        let stages = &self.tape.stages;
        (0..stages.len()).filter(move |place| stages[*place].0 < stage).map(Register)
    }

    /// The registers of `stage` that later ones or `outputs` read; `None` where arrays or loops are among its work.
    pub fn read_after(&self, stage: Stage, outputs: &[Value]) -> Option<Vec<Register>> {
        let Tape { due, stages, places, .. } = &*self.tape;
        if !due[stage as usize].iter().all(|own| own.work.is_simple()) {
            return None;
        }
        let own = |place: &usize| {
            let (own, last) = stages[*place];
            let is_output = || outputs.iter().any(|value| places[value.0] == *place);
            own == stage && (last > Some(stage) || is_output())
        };
        Some((0..stages.len()).filter(own).map(Register).collect())
    }

    /// The numbers of a register.
    pub fn at(&self, Register(place): Register) -> &Pack {
        &self.registers[place]
    }

    /// The numbers that `value` has.
    #[inline]
    pub fn get(&self, value: Value) -> &Pack {
        &self.registers[self.tape.places[value.0]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Place;
    use crate::law::Law;
    use crate::lower::lower;
    use crate::parameter::Parameter;
    use crate::program::interpret::Interpreter;
    use crate::program::passes;
    use crate::request::{Entry, read};
    use crate::syntax::parse;

    const MAPPINGS: [&str; 10] = [
        "exp",
        "rational",
        "power",
        "tan",
        "tanh",
        "algebraic",
        "soft",
        "exp_sum",
        "tau*(1 - exp(-a*t)*(1 + a*t/3))",
        "tau*tanh(2*t)",
    ];

    fn number(input: Input, lane: usize) -> f64 {
        #[allow(clippy::cast_precision_loss)]
        let lane = lane as f64;
        match input {
            Input::Parameter(Parameter::Tau) => 2.0 + 0.1 * lane,
            Input::Parameter(Parameter::Start) => 0.25,
            Input::Parameter(Parameter::Gain(i)) => [24.0, 26.0, 9.0, 3.0][i - 1] + lane,
            Input::Parameter(_) => 0.75 + 0.01 * lane,
            Input::StartTime => 0.2,
            Input::Time => 0.3 + 0.2 * lane,
            Input::State(1) => lane.sin(),
            _ => lane.cos(),
        }
    }

    /// u of each lane has the bits of the interpreter, whatever products are in sums.
    #[test]
    fn lanes_match_the_interpreter_bit_for_bit() {
        for mapping in MAPPINGS {
            for n in ["2", "4", "12"] {
                let gains = ["1"; 12][..n.parse().expect("a number")].join(",");
                let keys = [("n", n), ("eps", "1e-9"), ("mu", mapping), ("gains", &gains)];
                // At order 4 the gains are parameters.
                let keys = if n == "4" { &keys[..3] } else { &keys[..] };
                let entry = |(key, text): &(&str, &str)| Entry {
                    key: (*key).to_owned(),
                    place: Place(0),
                    value: parse(key, text, &mut |_| Place(0)).expect("a value"),
                };
                let spec = read(&keys.iter().map(entry).collect::<Vec<_>>()).expect("a spec");
                let program = passes::optimise(lower(&spec, &Law::of(&spec)), &mut |_, _| {});
                let mut lanes = Lanes::new(&program, &[program.step]).expect("lanes");
                for (input, register) in lanes.inputs().collect::<Vec<_>>() {
                    (0..LANES).for_each(|lane| lanes.set(register, lane, number(input, lane)));
                }
                [Stage::Init, Stage::Arm, Stage::Tick, Stage::Step]
                    .into_iter()
                    .for_each(|stage| lanes.run(stage));
                for lane in 0..LANES {
                    let input = |input| number(input, lane);
                    let wanted = Interpreter::new(&program, &input).value(program.step);
                    let own = lanes.get(program.step).0[lane];
                    assert_eq!(
                        own.to_bits(),
                        wanted.to_bits(),
                        "{mapping}, {n}, {lane}: {own} {wanted}"
                    );
                }
            }
        }
    }
}
