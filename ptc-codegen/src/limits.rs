//! Limits of the size of inputs and of the work that they cause: one table, so that every input has a bound in time
//! and memory, and every refusal for a size names its bound.

/// A bound.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// Counted items, in the plural.
    pub what: &'static str,
    /// The largest count that is accepted.
    pub most: u64,
    /// Why the bound is where it is.
    pub why: &'static str,
    /// Advice for a refused input; empty if no input is refused, as work beyond the bound is left undone and the form
    /// stays as it was written.
    pub fix: &'static str,
}

impl Limit {
    /// Returns true if `size` is accepted.
    pub fn admits(&self, size: usize) -> bool {
        u64::try_from(size).is_ok_and(|size| size <= self.most)
    }

    /// The bound as a size in memory.
    pub const fn size(&self) -> usize {
        self.most as usize
    }

    /// `subject` is larger: what it has, and what it may have.
    pub fn exceeded(&self, subject: &str, size: usize) -> String {
        format!("{subject} has {size} {}; the limit is {}", self.what, self.most)
    }

    /// The same where nothing was counted beyond the limit.
    pub fn beyond(&self, subject: &str) -> String {
        format!("{subject} has more than {} {}", self.most, self.what)
    }
}

macro_rules! table {
    ($($(#[$doc:meta])* $name:ident = $most:literal $what:literal, $why:literal, $fix:literal;)*) => {
        $($(#[$doc])* pub const $name: Limit =
            Limit { what: $what, most: $most, why: $why, fix: $fix };)*

        /// All bounds by their names.
        pub const TABLE: &[(&str, Limit)] = &[$((stringify!($name), $name)),*];
    };
}

table! {
    /// Bytes of a design file.
    DESIGN = 1_048_576 "bytes", "a design is a page of TOML",
        "give the design itself: this is some other file";
    /// Lines of a design, and flags of a command.
    ENTRIES = 2_000 "keys and tables", "each may cause a search for what it means",
        "a design has some forty keys: leave the others out";
    /// Bytes of a URDF file.
    URDF = 16_777_216 "bytes", "the file of a humanoid has a few hundred thousand",
        "give the URDF itself, not a mesh or an archive";
    /// Elements, attributes and texts of a URDF file.
    URDF_ELEMENTS = 1_000_000 "elements and texts", "the file of a humanoid has some ten thousand",
        "give the file of one robot";
    /// Moving joints of a robot.
    URDF_JOINTS = 64 "moving joints", "the mass matrix has the square of their number",
        "give `base` and `tip` of the part that moves";
    /// Items of all lists of a design.
    ITEMS = 2_000 "values in lists", "each may be wrong by itself; the order is at most 16",
        "a list has one value for each state";
    /// Characters of the text of a value.
    TEXT = 20_000 "characters", "a law that a person wrote has a few hundred",
        "write it shorter";
    /// Operations on the longest way from the top of an expression to a leaf.
    HEIGHT = 200 "operations in a row", "what walks an expression recurses that deep",
        "brackets join parts of a sum: (a + b) + (c + d)";
    /// Levels of brackets, signs and exponents.
    NESTING = 100 "levels of nesting", "the parser recurses that deep",
        "write it with fewer brackets, calls or signs in each other";
    /// Decimal digits of a number.
    DIGITS = 1_000 "digits", "a double has 17", "round the number";
    /// Decimal exponent of a number.
    EXPONENT = 400 "as a decimal exponent", "that of a double is from -324 to 308",
        "give the number in a unit in which it is nearer to 1";
    /// Arguments of min, max and mean.
    ARGUMENTS = 99 "arguments", "each is an operation in a row",
        "join parts: min(min(a, b), min(c, d))";
    /// Operations and operands of an expression, its families written out; of a derivative, each counted
    /// once, as often as it occurs.
    SIZE = 10_000 "operations and operands", "families in families multiply it",
        "write it shorter";
    /// Operations and operands of a derivative of an output along its model, each counted once however often it occurs.
    CHAIN = 100_000 "operations and operands", "a chain of order 16 whose rates are not linear has some ten thousand",
        "take an output with a lower relative degree, or a simpler model";
    /// Operations on the longest way from the top of such a derivative to a leaf.
    CHAIN_HEIGHT = 400 "operations in a row", "what walks an expression recurses that deep, on stacks of 8 MB",
        "take an output with a lower relative degree, or a simpler model";
    /// Coefficients of the expansion of a mapping: those of a triangle of the order for each operation.
    EXPANSION = 100_000 "coefficients in its expansion", "each is a line of the emitted step",
        "write it shorter, or lower the order";
    /// States of a model.
    STATES = 16 "states", "each is differentiated by in each derivative of the output",
        "leave out states that the output does not depend on";
    /// Inputs of a model, as many as coordinates of a mechanical plant.
    INPUTS = 8 "inputs", "u is a solution of equations with as many unknowns",
        "make several controllers of fewer inputs";
    /// Intermediate values of a model.
    INTERMEDIATES = 1_000 "intermediate values", "each name is looked up among all",
        "write short ones where they are used";
    /// Axes of a controller.
    AXES = 16 "axes", "gains of its own for each are lines of the emitted step",
        "make several controllers, armed at the same t0 with the same tau";
    /// Bits of a constant over or under its fraction bar.
    BITS = 4_096 "bits in a constant", "powers of powers multiply them",
        "write it with constants of fewer digits";
    /// Terms of a polynomial that is multiplied out.
    TERMS = 64 "terms", "a longer normal form is no shorter than what it stands for", "";
    /// Exponent of a polynomial that is multiplied out.
    DEGREE = 4_096 "as its degree", "degrees stay small integers", "";
    /// Names, calls and roots that a normal form distinguishes.
    KERNELS = 200 "names, calls and roots", "each is compared with all", "";
    /// Whole power of a sum that is multiplied out.
    POWER = 24 "as its power", "a sum to it has about as many terms as are kept", "";
    /// Exponents of numbers that are folded.
    FOLDED = 64 "as the exponent of a number", "the digits of a power grow with it, and so does the work on them", "";
    /// Degrees of the roots of numbers that are sought.
    ROOT = 64 "as the degree of a root", "a number of a spec that is a higher power is 1, or written as one", "";
    /// Whole multiples in an exponent: e^(k u) is the power k of e^u.
    MULTIPLE = 1_000 "times an exponent", "powers of one exponential cancel; larger multiples are constants of a fit, which do not", "";
    /// Products of terms that a power of a sum is multiplied out to.
    EXPANDED = 64 "products of terms", "as many terms as a polynomial may have", "";
    /// Growth of a normal form.
    GROWTH = 4 "times the size of what it stands for", "a larger one takes longer to compute, and to read", "";
    /// Degree of the polynomials that the atoms of a user-defined mapping satisfy.
    ATOMS = 2 "as a degree in its generator", "the rows of order n have n times the degree, and powers of a generator that grows leave the range", "";
    /// Size by which a normal form may grow in any case.
    ALWAYS = 48 "operations and operands", "the limit of a short expression is some times as long", "";
    /// Terms of the polynomial part of a fraction.
    PARTS = 16 "terms", "a mapping with more of them is no sum of a constant and what vanishes", "";
    /// Powers of e^u in which 1 + h is put for it, to find a sign.
    LIFTED = 16 "as its power", "a sum to the power k has k + 1 terms, in each of which there may be another", "";
    /// Calls within calls that a sign is looked for in.
    CALLS = 7 "calls in each other", "each takes a normal form, and some take two", "";
    /// Operations on small coefficients of one search for leading terms.
    SEARCH = 4_000 "operations", "a search takes a tenth of a second at most", "";
    /// Size of two coefficients of leading terms that are combined.
    COEFFICIENT = 150 "operations and operands", "the work of a normal form grows faster than what it is taken of", "";
    /// Bounds that are kept of what follows the leading terms.
    BOUNDS = 8 "bounds", "each is compared with all, and more than two are rare", "";
    /// Operations on intervals for the values of one expression, a call counted as some.
    ENCLOSURE = 60_000 "operations", "well below a second", "";
    /// Operations on the cells into which the envelope is cut where one interval of each input is too wide.
    CELLS = 4_000_000 "operations", "well below a second", "";
    /// Steps of the work on one expression, each of about a tenth of a microsecond.
    EFFORT = 5_000_000 "steps", "a refusal takes less than a second and 500 MB",
        "write it with fewer functions, powers and fractions in each other";
    /// Steps of the work on one self-test, each of about a nanosecond.
    SELFTEST = 2_000_000_000 "steps of work", "a refusal takes about two seconds",
        "write mu, kappa, pi0 or g with fewer functions, lower the order, or test the controller by hand";
    /// Samples of a run of `simulate`.
    SAMPLES = 10_000_000 "samples", "what is more is a period that was mistyped; the rows go to the file as they are made, and a run takes less than 500 MB",
        "give a longer --sample-time";
    /// Samples until the deadline for which gains of least energy are computed.
    GAINS = 131_072 "samples", "the Gramian of a linear plant is summed over them in long arithmetic",
        "give a shorter tau, a longer sample_time, or the poles as numbers";
    /// Samples until the deadline of a design that is compared with others.
    COMPARED = 100_000 "samples", "the gains of a finite horizon are kept for each",
        "give a shorter tau, or a longer sample_time";
    /// Scenarios in which a design is compared with others.
    RIVALS = 100_000 "scenarios", "each is run with every controller; some seconds for a thousand",
        "give fewer --scenarios";
    /// Threads of a campaign or a search.
    THREADS = 256 "threads", "more than there are cores make nothing faster; RAYON_NUM_THREADS may give fewer", "";
    /// Messages about one input.
    MESSAGES = 20 "messages", "the first ones are to be mended first", "";
}
