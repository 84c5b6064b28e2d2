//! The keys of a design: tables that feed the reader, the help, the docs and the diagnostics.

mod event;
mod group;
mod plant;
pub mod table;
pub mod verify;

pub use event::EVENT_KEYS;
pub use group::{GROUPS, Group};
pub use plant::PLANT_KEYS;
pub use table::{TABLES, TableInfo};

/// A key of a spec.
#[derive(Clone, Copy, Debug)]
pub struct KeyInfo {
    /// Name, in the macro; the flag on the command line is `--` with `-` for `_`.
    pub key: &'static str,
    /// Meaning.
    pub meaning: &'static str,
    /// What is legal.
    pub legal: &'static str,
    /// An example of the value as it is written on the command line.
    pub example: &'static str,
}

/// What is legal of a key that is on or off.
const SWITCH: &str = "true or false";

/// All keys, in the order of the documentation.
pub static KEYS: [KeyInfo; 85] = [
    KeyInfo {
        key: "n",
        meaning: "order of the chain of integrators",
        legal: "an integer 1..=16",
        example: "3",
    },
    KeyInfo {
        key: "axes",
        meaning: "number of chains that share one deadline; each call gives u for all",
        legal: "an integer 1..=16",
        example: "3",
    },
    KeyInfo {
        key: "limits",
        meaning: "limits of u of each axis, in place of u_max and u_min",
        legal: "for each axis a number > 0, the bound of |u|, or a pair [lower, upper]",
        example: "20,20,5",
    },
    KeyInfo {
        key: "mu",
        meaning: "time mapping, with its parameters where they are fixed",
        legal: "a family (exp, rational, power, tan, tanh, algebraic, exp_sum, soft) or an expression in t",
        example: "exp(a=1)",
    },
    KeyInfo {
        key: "kappa",
        meaning: "time mapping by its inverse, in place of mu",
        legal: "an expression in dt, the elapsed time",
        example: "-ln(1 - dt/tau)/a",
    },
    KeyInfo {
        key: "name",
        meaning: "name of the controller: prefix of every emitted symbol, stem of the files",
        legal: "an identifier of at most 48 letters, digits and _, no word of C or Rust",
        example: "roll",
    },
    KeyInfo {
        key: "units",
        meaning: "unit of x1, from which the units of x2..xn and u follow, in comments and pictures",
        legal: "a word of at most 16 letters",
        example: "rad",
    },
    KeyInfo {
        key: "what",
        meaning: "what to generate: the controller, the infinite-time system on which pi0 is designed, the observer alone, a filter that keeps bounds under any controller, or functions of a robot",
        legal: "controller, associated, observer or filter; with urdf one or several of inverse-dynamics, mass-matrix, jacobian",
        example: "associated",
    },
    KeyInfo {
        key: "clock",
        meaning: "argument of each call: the time t, or the sample number k",
        legal: "time or samples",
        example: "samples",
    },
    KeyInfo {
        key: "precision",
        meaning: "floating-point type",
        legal: "f64 or f32",
        example: "f32",
    },
    KeyInfo {
        key: "fma",
        meaning: "fused multiply-add: products and sums with one rounding; in C, C++ and Rust, with clock = time",
        legal: SWITCH,
        example: "true",
    },
    KeyInfo {
        key: "latency",
        meaning: "polynomials as trees: shorter chains, a few more operations; with clock = time",
        legal: SWITCH,
        example: "true",
    },
    KeyInfo {
        key: "guard",
        meaning: "run-time checks of the inputs",
        legal: "full, result or none",
        example: "none",
    },
    KeyInfo {
        key: "gains",
        meaning: "gains k_1..k_n of the law pi0 = -sum k_i xi_i",
        legal: "n finite numbers; with axes also a list of them for each axis",
        example: "120,74,15",
    },
    KeyInfo {
        key: "poles",
        meaning: "poles of the loop in stretched time, in place of gains",
        legal: "least-energy or least-energy(weight=W), or n numbers, complex ones in pairs; with axes also a list of them for each axis",
        example: "-4,-3+2i,-3-2i",
    },
    KeyInfo {
        key: "pi0",
        meaning: "law of the infinite-time system, in place of gains",
        legal: "an expression in xi1..xin and t, or extern; with several outputs an expression for each, or extern for all",
        example: "-20*xi1 - 9*xi2",
    },
    KeyInfo {
        key: "g",
        meaning: "input gain of the plant xn' = f + g*u",
        legal: "an expression in x1..xn and t, not 0; with axes an expression in parameters, or one for each axis",
        example: "2 + cos(x1)",
    },
    KeyInfo {
        key: "f",
        meaning: "known part of the plant xn' = f + g*u, cancelled",
        legal: "an expression in x1..xn and t; a finite number with clock = samples",
        example: "-9.81*sin(x1)",
    },
    KeyInfo {
        key: "reference",
        meaning: "reference that x1, or the output of a model, follows in place of 0",
        legal: "an expression in t, or input: each call is given r and its n derivatives; with several outputs, or axes in samples, an expression for each",
        example: "0.1*sin(2*t)",
    },
    KeyInfo {
        key: "states",
        meaning: "names of the states of a model of the plant, from which x1..xn, f and g follow, or beside A and B for the checks",
        legal: "names; one is enough",
        example: "angle,speed",
    },
    KeyInfo {
        key: "input",
        meaning: "name of the input of the model",
        legal: "a name",
        example: "torque",
    },
    KeyInfo {
        key: "output",
        meaning: "output of the model, x1, which is brought to 0",
        legal: "an expression in the states; beside A and B a row, one number for each of them",
        example: "angle",
    },
    KeyInfo {
        key: "dynamics",
        meaning: "rate of each state of the model",
        legal: "an expression for each state, affine in the input: a list in their order, or in a design file { state = \"rate\" }",
        example: "speed, (torque - drag*speed)/inertia",
    },
    KeyInfo {
        key: "let",
        meaning: "intermediate values of the model, each computed once, by their names",
        legal: "a table of expressions in the states, the inputs and earlier values, which all expressions of the model use by name",
        example: "{s = sin(angle), D = m*l*s}",
    },
    KeyInfo {
        key: "inputs",
        meaning: "names of the inputs of a model with several inputs",
        legal: "a list of names",
        example: "left,right",
    },
    KeyInfo {
        key: "outputs",
        meaning: "outputs of a model with several inputs, which are brought to 0",
        legal: "an expression in the states for each input, at most 3",
        example: "angle, height",
    },
    KeyInfo {
        key: "inertia",
        meaning: "matrix M(q) of a mechanical model M q'' + bias = u, whose states are q and then q'",
        legal: "a row for each input, of an expression in q for each input",
        example: "[[3, 1], [1, 1]]",
    },
    KeyInfo {
        key: "bias",
        meaning: "forces of a mechanical model at q'' = 0: gravity, friction, Coriolis forces",
        legal: "an expression in q and q' for each input",
        example: "9.81*cos(q1), 0.1*w2",
    },
    KeyInfo {
        key: "A",
        meaning: "matrix of a linear plant x' = A x + B u, y = C x in place of a chain; with clock = samples",
        legal: "n rows of n finite numbers, n <= 8",
        example: "[[0, 1], [-4, -0.2]]",
    },
    KeyInfo {
        key: "B",
        meaning: "input matrix B of the linear plant",
        legal: "n finite numbers",
        example: "[0, 1]",
    },
    KeyInfo {
        key: "C",
        meaning: "output matrix C of the linear plant: its measurements, in place of `measured`",
        legal: "n finite numbers, or rows of them",
        example: "[1, 0]",
    },
    KeyInfo {
        key: "tau",
        meaning: "prescribed settling time in s",
        legal: "a number > 0",
        example: "2",
    },
    KeyInfo { key: "t0", meaning: "start time in s", legal: "a finite number", example: "0" },
    KeyInfo {
        key: "eps",
        meaning: "time-to-go in s at which the gains are held",
        legal: "a number > 0 and < tau",
        example: "1e-3",
    },
    KeyInfo {
        key: "u_max",
        meaning: "bound of |u|, or beside u_min the upper limit of u; inf omits the clipping",
        legal: "a number > 0, or inf; beside u_min any number above it",
        example: "5",
    },
    KeyInfo {
        key: "u_min",
        meaning: "lower limit of u; without it -u_max",
        legal: "a number < u_max, -inf, or runtime: a run-time parameter",
        example: "0",
    },
    KeyInfo {
        key: "after",
        meaning: "u after the deadline: held gains, 0, or a user-defined law",
        legal: "hold, zero or extern",
        example: "zero",
    },
    KeyInfo {
        key: "sample_time",
        meaning: "sample period of the loop in s; sets the default of eps",
        legal: "a number > 0",
        example: "1e-3",
    },
    KeyInfo {
        key: "error",
        meaning: "required bound of |x_i| at the deadline, in units of x_i; sets eps",
        legal: "a number > 0, or one for each state, with x0_max; with several outputs in samples also a list for each",
        example: "1e-3",
    },
    KeyInfo {
        key: "noise",
        meaning: "bounds of the noise of each measured state, in units of x_i",
        legal: "a number >= 0, or one for each state",
        example: "1e-4,1e-3",
    },
    KeyInfo {
        key: "noise_rms",
        meaning: "standard deviations of random noise of each measured state, in units of x_i",
        legal: "a number >= 0, or one for each state",
        example: "1e-4,1e-3",
    },
    KeyInfo {
        key: "g_error",
        meaning: "lower and upper bound of the true input gain, relative to g",
        legal: "two numbers > 0, the smaller one first",
        example: "0.9,1.1",
    },
    KeyInfo {
        key: "jitter",
        meaning: "bound on how early or late a sample is, in s",
        legal: "a number >= 0 and < sample_time/2",
        example: "1e-5",
    },
    KeyInfo {
        key: "margin_gain",
        meaning: "gain margin of a chosen eps: stable from 1/margin_gain to margin_gain times the input gain, as far as error allows",
        legal: "a number >= 1; 2, or 6 dB each way, if not given",
        example: "1.5",
    },
    KeyInfo {
        key: "margin_delay",
        meaning: "delay margin of a chosen eps, in samples beyond delay, as far as error allows",
        legal: "an integer 0..=16; 1 if not given",
        example: "2",
    },
    KeyInfo {
        key: "sensor_step",
        meaning: "resolution of each sensor, in units of x_i",
        legal: "a number >= 0, or one for each state",
        example: "1e-6,1e-3",
    },
    KeyInfo {
        key: "u_step",
        meaning: "resolution of the actuator: u is rounded to a multiple of it",
        legal: "a number >= 0",
        example: "0.01",
    },
    KeyInfo {
        key: "delay",
        meaning: "samples between a measurement and the input computed from it",
        legal: "a number from 0 to 16; with clock = time an integer",
        example: "1",
    },
    KeyInfo {
        key: "delay_law",
        meaning: "law of a delay: the order raised by its samples, or the plant predicted over it; with clock = samples",
        legal: "extend or predict",
        example: "predict",
    },
    KeyInfo {
        key: "deadbeat",
        meaning: "samples to go at which deadbeat takes over; with clock = samples",
        legal: "an integer of at least the order of the loop",
        example: "12",
    },
    KeyInfo {
        key: "poles_end",
        meaning: "poles of the law that takes over towards the end; with clock = samples",
        legal: "least-energy, least-energy(weight=W) or its poles: consecutive multiples of -a, from the order of the loop on",
        example: "least-energy(weight=1)",
    },
    KeyInfo {
        key: "end_samples",
        meaning: "samples to go from which on poles_end are the poles; with clock = samples",
        legal: "an integer of at least the order of the loop",
        example: "250",
    },
    KeyInfo {
        key: "gain_bytes",
        meaning: "most bytes of the table of gains of least energy beside A and B; with clock = samples",
        legal: "an integer from 1 to 16777216",
        example: "4096",
    },
    KeyInfo {
        key: "late",
        meaning: "what becomes of a deadline that is too soon for the limits; with clock = samples",
        legal: "clip, extend or refuse",
        example: "extend",
    },
    KeyInfo {
        key: "pace",
        meaning: "deadline: kept as it was asked for, or planned as soon as the limits allow at every sample; with clock = samples",
        legal: "deadline or soonest",
        example: "soonest",
    },
    KeyInfo {
        key: "state_max",
        meaning: "bounds of the states that a planned deadline keeps: speed, acceleration; with clock = samples",
        legal: "a number > 0 or inf, or one for each state; a list of them for each axis",
        example: "inf,0.5",
    },
    KeyInfo {
        key: "reserve",
        meaning: "part of each limit that a planned deadline leaves free; with clock = samples",
        legal: "a number from 0 up to, not including, 1",
        example: "0.1",
    },
    KeyInfo {
        key: "in_flight",
        meaning: "whether the deadline may change while it runs: with clock = samples target and estimates too, with clock = time tau, which the design leaves out",
        legal: SWITCH,
        example: "true",
    },
    KeyInfo {
        key: "measured",
        meaning: "measured states; an observer estimates the others; with clock = samples",
        legal: "x1, or x1 to x_m without a gap; any states of a linear plant",
        example: "x1",
    },
    KeyInfo {
        key: "disturbance",
        meaning: "unknown disturbance added to u, which is estimated and cancelled; with clock = samples",
        legal: "none, constant, ramp, or sine(omega=W) with W in rad/s",
        example: "constant",
    },
    KeyInfo {
        key: "observer",
        meaning: "law of the observer's gains: a round, or those of a Kalman filter from the first sample on; with clock = samples",
        legal: "prescribed or stationary",
        example: "stationary",
    },
    KeyInfo {
        key: "disturbance_walk",
        meaning: "how far the unknown disturbance drifts in a second, as a standard deviation; for a stationary observer",
        legal: "a finite number > 0, in the unit of u; of a ramp or a sine in that per second",
        example: "1",
    },
    KeyInfo {
        key: "observer_poles",
        meaning: "poles of the observer in stretched time; with clock = samples",
        legal: "one for each state that is estimated; complex ones in pairs",
        example: "-4,-5,-6",
    },
    KeyInfo {
        key: "observer_samples",
        meaning: "samples after which the estimates are exact; with clock = samples",
        legal: "an integer; by default half of the samples, without a default for what = observer",
        example: "200",
    },
    KeyInfo {
        key: "observer_eps",
        meaning: "time-to-go in s at which the gains of the observer are held; with clock = samples",
        legal: "a number > 0",
        example: "0.03",
    },
    KeyInfo {
        key: "after_observer",
        meaning: "poles of the observer in 1/s, in place of its last gains, once the estimates are exact, or stationary; with clock = samples",
        legal: "one for each state that is estimated, with real parts < 0, complex ones in pairs; or stationary",
        example: "-100,-120,-150",
    },
    KeyInfo {
        key: "innovation_max",
        meaning: "gate of the observer: a reading further than this from its prediction is not believed, and the observer predicts alone; with clock = samples and coast",
        legal: "a number > 0, or one for each measured value",
        example: "1e-3",
    },
    KeyInfo {
        key: "measurement_max",
        meaning: "range of the sensor: a larger reading counts as lost; with clock = samples and an observer",
        legal: "a number > 0, or one for each measured value",
        example: "0.5",
    },
    KeyInfo {
        key: "coast",
        meaning: "consecutive samples that the observer predicts alone where readings are lost or not believed; with clock = samples",
        legal: "an integer 0..=65535; 0 if not given",
        example: "5",
    },
    KeyInfo {
        key: "keep_below",
        meaning: "upper bounds of x1, x2, ... that a filter keeps, whatever the controller wants; with what = filter",
        legal: "a number or inf for each of x1..xn, where the last ones may be left out",
        example: "0.5,0.8",
    },
    KeyInfo {
        key: "keep_above",
        meaning: "lower bounds of x1, x2, ... that a filter keeps; with what = filter",
        legal: "a number or -inf for each of x1..xn, where the last ones may be left out",
        example: "-0.5,-0.8",
    },
    KeyInfo {
        key: "keep_poles",
        meaning: "poles in 1/s with which the states approach their bounds: faster ones interfere later and need more u; with what = filter",
        legal: "n numbers < 0",
        example: "-5,-20",
    },
    KeyInfo {
        key: "keep_tolerance",
        meaning: "distance beyond its bounds at which x1, x2, ... count as within them, above the noise of the sensors; with what = filter",
        legal: "a number > 0 for each of x1..xn, where the last ones may be left out",
        example: "1e-4,1e-3",
    },
    KeyInfo {
        key: "urdf",
        meaning: "URDF file of a robot, which is the plant; its path is relative to the design file",
        legal: "a path; with what = inverse-dynamics, mass-matrix or jacobian emit generates functions of the robot",
        example: "arm.urdf",
    },
    KeyInfo {
        key: "base",
        meaning: "link of a robot that does not move; with urdf",
        legal: "the name of a link; by default the root of the file",
        example: "base_link",
    },
    KeyInfo {
        key: "tip",
        meaning: "links at the ends of a robot; joints that move none of them are held at position 0; with urdf",
        legal: "the name of a link, or several; by default the robot is all that the base carries",
        example: "hand",
    },
    KeyInfo {
        key: "gravity",
        meaning: "acceleration of gravity in the axes of a robot's base, m/s^2; with urdf",
        legal: "three numbers; 0, 0, -9.81 if not given",
        example: "0,0,-9.81",
    },
    KeyInfo {
        key: "payload",
        meaning: "what the tip of a robot carries: mass, kg, and centre in the frame of the tip, m; with urdf",
        legal: "4 numbers, or 10 with its inertia about the centre, ixx, iyy, izz, ixy, ixz, iyz, kg m^2; none if not given",
        example: "0.5,0,0,0.1",
    },
    KeyInfo {
        key: "rotor",
        meaning: "inertia of the rotors of a robot behind their gears, kg m^2, or kg of joints that slide; with urdf",
        legal: "a number >= 0 for all joints, or one for each; 0 if not given",
        example: "0.12",
    },
    KeyInfo {
        key: "damping",
        meaning: "viscous friction of the joints of a robot, N m s/rad or N s/m; with urdf",
        legal: "a number >= 0 for all joints, or one for each; if not given, the damping of <dynamics> in the file, or 0",
        example: "0.3",
    },
    KeyInfo {
        key: "friction",
        meaning: "dry friction of the joints of a robot, N m or N; with urdf",
        legal: "a number >= 0 for all joints, or one for each; if not given, the friction of <dynamics> in the file, or 0",
        example: "0.5",
    },
    KeyInfo {
        key: "friction_width",
        meaning: "velocity v0 that smooths the sign of dry friction, v/sqrt(v^2 + v0^2), rad/s or m/s; with urdf",
        legal: "a number >= 1e-6 for all joints, or one for each; 0.01 if not given",
        example: "0.01",
    },
    KeyInfo {
        key: "x0_max",
        meaning: "bounds of |x_i| at the start, 0 for a state at rest",
        legal: "n numbers >= 0; with several outputs in samples also a list for each",
        example: "1,2,5",
    },
    KeyInfo {
        key: "x_max",
        meaning: "bounds of |x_i| at all times",
        legal: "n numbers > 0",
        example: "10,10,10",
    },
    KeyInfo {
        key: "allow",
        meaning: "checks that may fail without refusing the design",
        legal: "names of checks: membership, growth, sampling, deadline, loop, envelope, zeros",
        example: "growth",
    },
];

/// Keys whose names parameters may have too: the keys of a model, and the capitals that plants are full of.
pub const PARAMETERS_TOO: [&str; 17] = [
    "inputs",
    "outputs",
    "inertia",
    "bias",
    "u_min",
    "A",
    "B",
    "C",
    "urdf",
    "base",
    "tip",
    "gravity",
    "payload",
    "rotor",
    "damping",
    "friction",
    "friction_width",
];

/// The functions of a robot: further values of `what`.
pub const ROBOT_FUNCTIONS: [&str; 3] = ["inverse-dynamics", "mass-matrix", "jacobian"];

/// The names of the checks, in the order in which they are run: the values of `allow`.
pub const CHECKS: [&str; 7] =
    ["membership", "growth", "sampling", "deadline", "loop", "envelope", "zeros"];

impl KeyInfo {
    /// The table of a design file that holds the key; none for the top level.
    pub fn table(&self) -> Option<&'static str> {
        match self.key {
            "tau" | "t0" | "eps" | "u_max" | "u_min" => Some("params"),
            "x_max" => Some("envelope"),
            "A" | "B" | "C" => Some("plant"),
            "states" | "input" | "output" | "dynamics" | "inputs" | "outputs" | "inertia"
            | "bias" | "let" => Some("model"),
            "urdf" | "base" | "tip" | "gravity" | "payload" | "rotor" | "damping" | "friction"
            | "friction_width" => Some("robot"),
            _ => None,
        }
    }

    /// Returns true if the value of a key is a text that is taken as it stands, such as a path.
    pub fn is_text(key: &str) -> bool {
        matches!(key.strip_prefix("robot.").unwrap_or(key), "urdf" | "base" | "tip")
    }

    /// Returns true if the value of a key is the path of a file that the design consists of.
    pub fn is_file(key: &str) -> bool {
        key == "urdf"
    }

    /// Whether it is on or off: a boolean of TOML, and a flag that needs no value.
    pub fn is_switch(&self) -> bool {
        self.legal == SWITCH
    }

    /// Returns the meaning in a few words, for a comment beside a value.
    pub fn brief(&self) -> &'static str {
        self.meaning.split(';').next().unwrap_or(self.meaning)
    }

    /// The key called `name`.
    pub fn find(name: &str) -> Option<&'static Self> {
        KEYS.iter().find(|info| info.key == name)
    }
}
