//! Prescribed-time controller masses_refuse: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name masses_refuse --clock samples --A="[[0,1],[-400,-2]]" --B="[0,40]" --C="[[1,0]]" --delay-law=predict --late=refuse --reserve=0.1 --disturbance constant --observer=stationary --disturbance-walk=0.5 --precision f32 --tau=0.2 --eps=0.04 --u-max=10 --poles="least-energy(weight=1)" --sample-time=0.01 --delay=1 --sensor-step=1e-5
//! Version 0.1.0, design 4c1e1b44d4b2.
//!
//! Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
//!       sample to sample, one sample late, y = C x.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant.
//! Law of the state x predicted for the time from which u acts, by x and the inputs under way:
//!       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
//!       sum of u^2/M. The gains are a table of 576 bytes: exact below 64 samples to go, and
//!       before it those of a grid of 72 nodes, interpolated in a line. The gains of 5 samples
//!       to go stay.
//!
//! Parameters:
//!   samples = 20 [samples], fixed: samples N from the start to rest
//!   h = 0.01 [s], fixed: sample period
//!   eps = 0.04 [s], fixed: time-to-go at which the gains are held
//!   u_max = 10 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates approach the state from the first sample on: the observer has the gains of
//!       the stationary Kalman filter for the noise and disturbance_walk.
//! In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
//!       else stays as it is.
//! Plan: with M samples to go a table holds u at some samples of the way to rest, as rows
//!       times x; those at all others are combinations of these whose factors add up to at
//!       most 1 in size, which was examined for each M up to 80. If the rows are within the
//!       limits, the smaller one of u_min and u_max, u stay there at every sample to rest,
//!       where plant and state are as they are known. A new plan leaves 5.6 % of the limits,
//!       by which rows between the samples may grow on the way.
//! late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
//! reserve: a new deadline leaves 0.1 of each limit free.
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: near rest at sample 20, not at rest: the gains are held from 4 samples to
//!       go, and |u| is bounded; so does what the stationary observer leaves of its error.
//!   sampling: not checked: the law is exact in samples, at any period.
//!   deadline: not checked: the law is exact in samples, at any period.
//!   loop: not checked: `x0_max` is not given.
//!   envelope: not checked: it does not examine a clock in samples.
//! ```
#![forbid(unsafe_code)]

/// Status of a valid u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Tracking: u is that of the law.
    Ok,
    /// Time-to-go is held at eps: the deadline is near or over.
    Hold,
    /// u was clipped to its limits; wins over `Hold` and `After`.
    Saturated,
    /// The deadline is over: u is 0 or that of the user-defined law.
    After,
    /// A reading was not believed: u by prediction alone; wins over all above.
    Gated,
    /// The deadline was put off, as a limit would have been exceeded.
    Late,
    /// The bounds of a filter cannot be kept from here: u is the nearest to them.
    Infeasible,
}

/// Result of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control<R = f32> {
    /// Input of the plant.
    pub u: R,
    /// Its status.
    pub status: Status,
}

/// Why there is no controller, or no u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// A parameter is outside its domain, or the coefficients derived from it leave the range.
    Param,
    /// x or t is not finite, or t lies before the start.
    Input,
    /// u is not finite.
    Range,
    /// A deadline is too soon for the limits, or none keeps them.
    Soon,
}

impl core::fmt::Display for Error {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Param => "a parameter is outside its domain",
            Self::Input => "x or t is not finite, or t is before t0",
            Self::Range => "u is not finite",
            Self::Soon => "no deadline so soon keeps the limits",
        })
    }
}

impl core::error::Error for Error {}

/// A controller of a chain of N integrators.
pub trait Controller<const N: usize> {
    /// Floating-point type.
    type Real;

    /// Starts again at `t0`, in s.
    ///
    /// # Errors
    /// `Param`: `t0` is not finite.
    fn arm(&mut self, t0: Self::Real) -> Result<(), Error>;

    /// u at time `t`, in s, and state `x`.
    ///
    /// # Errors
    /// `Input`: `t` or `x` is not legal. `Range`: u is not finite.
    fn step(&self, t: Self::Real, x: &[Self::Real; N]) -> Result<Control<Self::Real>, Error>;
}

/// Run-time parameters of [`MassesRefuse`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct MassesRefuseParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct MassesRefuse {
    /// tick at which it was armed.
    start: u32,
    /// samples from the start to rest, as planned now.
    last: u32,
    /// input of the last sample.
    u1: f32,
    /// input of 2 samples ago.
    u2: f32,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f32,
    /// prediction of x1 without u.
    x1_next: f32,
    /// estimate of x2.
    x2_hat: f32,
    /// prediction of x2 without u.
    x2_next: f32,
    /// estimate of d.
    d_hat: f32,
    /// prediction of d without u.
    d_next: f32,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl MassesRefuse {
    /// Prediction from u.
    const GAMMA1: f32 = 0.0019801282;
    /// Prediction from u.
    const GAMMA2: f32 = 0.39339164;
    /// Prediction of x1 from x1.
    const PHI1_1: f32 = 0.98019874;
    /// Prediction of x1 from x2.
    const PHI1_2: f32 = 0.0098347915;
    /// Prediction of x1 from d.
    const PHI1_3: f32 = 0.0019801282;
    /// Prediction of x2 from x1.
    const PHI2_1: f32 = -3.9339166;
    /// Prediction of x2 from x2.
    const PHI2_2: f32 = 0.96052915;
    /// Prediction of x2 from d.
    const PHI2_3: f32 = 0.39339164;
    /// Bound of |u|.
    const U_MAX: f32 = 10.0;
    /// Samples to go at which the gains are held.
    const HOLD: f32 = 4.0;

    /// Gains of least energy of each state, a row for the samples to go of a node.
    #[rustfmt::skip]
    const GAINS: &'static [[f32; 2]; 72] = &[
        [-243.35172, -3.708417],
        [-141.97978, -2.940159],
        [-91.20574, -2.42074],
        [-62.172104, -2.0438325],
        [-44.045025, -1.7562149],
        [-32.00454, -1.5283414],
        [-23.638628, -1.3425357],
        [-17.630842, -1.1876156],
        [-13.212915, -1.0562031],
        [-9.911793, -0.94327444],
        [-7.422871, -0.84533006],
        [-5.5421553, -0.75989294],
        [-4.127859, -0.6851881],
        [-3.0776107, -0.619927],
        [-2.3143728, -0.5631508],
        [-1.7775029, -0.5141103],
        [-1.4170575, -0.47216737],
        [-1.1902988, -0.4367144],
        [-1.059812, -0.40711266],
        [-0.9928262, -0.38265345],
        [-0.96136767, -0.36254746],
        [-0.9428456, -0.34594363],
        [-0.9206555, -0.33197358],
        [-0.88443464, -0.31981143],
        [-0.8297522, -0.30873436],
        [-0.7572071, -0.29817086],
        [-0.6710846, -0.28772703],
        [-0.57782114, -0.27718824],
        [-0.48453298, -0.26649964],
        [-0.39779902, -0.255732],
        [-0.32279754, -0.24504048],
        [-0.26281482, -0.2346226],
        [-0.21909139, -0.22468027],
        [-0.19094585, -0.21538858],
        [-0.17610927, -0.2068729],
        [-0.17120288, -0.19919534],
        [-0.17229171, -0.19235064],
        [-0.1754457, -0.18627104],
        [-0.1772414, -0.18083896],
        [-0.17514436, -0.17590527],
        [-0.1677301, -0.17131026],
        [-0.15472637, -0.16690424],
        [-0.13688827, -0.16256464],
        [-0.11574309, -0.15820758],
        [-0.09325821, -0.15379284],
        [-0.07149021, -0.14932226],
        [-0.052267715, -0.1448327],
        [-0.036947154, -0.14038521],
        [-0.026264861, -0.13605227],
        [-0.020292852, -0.13190511],
        [-0.018491715, -0.12800251],
        [-0.01984327, -0.12438272],
        [-0.023037573, -0.121058784],
        [-0.02668425, -0.11801807],
        [-0.02951691, -0.1152254],
        [-0.030562269, -0.11262923],
        [-0.029252268, -0.110169716],
        [-0.025467185, -0.10778738],
        [-0.019509016, -0.105431035],
        [-0.012015165, -0.1030638],
        [-0.0038306501, -0.100666605],
        [0.0041383314, -0.098238796],
        [0.011066225, -0.09579603],
        [0.019562796, -0.090983264],
        [0.020080505, -0.086493276],
        [0.01536057, -0.08251945],
        [0.010357261, -0.07907682],
        [0.009222333, -0.07600829],
        [0.013146717, -0.073085256],
        [0.020137876, -0.07013505],
        [0.02659536, -0.06712104],
        [0.029559942, -0.06413745],
    ];

    /// U at 11 samples on the way to rest by the state, for each a row for the samples to go of a node.
    #[rustfmt::skip]
    const BOUNDS_U: &'static [[f32; 2]; 374] = &[
        [-63.908497, -2.1009142],
        [-45.27515, -1.8052639],
        [-32.898388, -1.5710262],
        [-24.298826, -1.3800311],
        [-18.123251, -1.2207843],
        [-13.581936, -1.0857016],
        [-10.188618, -0.969619],
        [-7.630183, -0.8689391],
        [-5.696941, -0.78111583],
        [-4.2431455, -0.7043246],
        [-3.1635647, -0.6372408],
        [-2.3790104, -0.57887894],
        [-2.4107165, -0.5865939],
        [-1.4760474, -0.49182296],
        [-1.1039302, -0.4240601],
        [-1.0013878, -0.37763974],
        [-0.9589809, -0.34579313],
        [-0.86429346, -0.3215865],
        [-0.6990208, -0.29970464],
        [-0.50470334, -0.27759358],
        [-0.33623508, -0.25524113],
        [-0.3301639, -0.25063238],
        [-0.18012814, -0.2115938],
        [-0.18128611, -0.18496577],
        [-0.1400121, -0.16627441],
        [-0.053460483, -0.14813784],
        [-0.018913703, -0.13092357],
        [-0.030190496, -0.117854886],
        [-0.019954218, -0.10783701],
        [0.011318761, -0.09798212],
        [0.011434309, -0.09898239],
        [0.010701763, -0.08170707],
        [0.027479973, -0.06935361],
        [0.027479973, -0.06935361],
        [-9.852644, -0.9461501],
        [11.317714, -0.31776413],
        [15.627179, -0.037113816],
        [15.077405, 0.09609934],
        [13.207906, 0.16023542],
        [11.137577, 0.18960647],
        [9.629814, 0.13685694],
        [8.574805, 0.091907494],
        [7.8069615, 0.0544657],
        [7.276275, 0.024998942],
        [6.923118, 0.0030527199],
        [6.692046, -0.012240895],
        [6.829336, 0.06345791],
        [6.57311, 0.041723214],
        [6.3775086, 0.034136914],
        [6.1000013, 0.033269417],
        [5.708217, 0.03277027],
        [5.25434, 0.029251048],
        [4.819917, 0.02267333],
        [4.463072, 0.015104354],
        [4.195939, 0.008875246],
        [4.1201754, 0.008714991],
        [3.7469923, 0.00413436],
        [3.3712885, 0.0048378184],
        [2.9774318, 0.0028410254],
        [2.6778972, -0.0007723669],
        [2.4611864, -0.0016877226],
        [2.244289, -0.00089847273],
        [2.025754, -0.0014293694],
        [1.8523662, -0.0027313065],
        [1.882033, 0.016119104],
        [1.6076154, 0.0136083],
        [1.3550723, 0.01066653],
        [1.3550723, 0.01066653],
        [35.18528, 0.063280575],
        [30.074492, 0.24074553],
        [23.594929, 0.2912596],
        [18.169014, 0.2952634],
        [13.965504, 0.28162426],
        [10.751859, 0.2616331],
        [8.278528, 0.2398803],
        [6.3487806, 0.21820131],
        [4.8192773, 0.19724661],
        [3.5882046, 0.17715181],
        [2.5839076, 0.15784132],
        [1.7562594, 0.13917406],
        [3.9579976, -0.30685163],
        [4.0084534, -0.27593505],
        [3.884136, -0.245644],
        [3.6019578, -0.22130126],
        [3.2497544, -0.20454283],
        [2.9256337, -0.19377314],
        [2.6884778, -0.18574451],
        [2.5414877, -0.1775261],
        [2.448959, -0.16773207],
        [3.5960634, 0.116329454],
        [3.2811058, 0.10022301],
        [3.0043368, 0.09196387],
        [2.6736908, 0.08378302],
        [2.3900928, 0.07352315],
        [2.1969695, 0.065409526],
        [2.0218637, 0.060451776],
        [1.8302581, 0.05557643],
        [1.664946, 0.04984608],
        [1.324021, -0.061155688],
        [1.2338281, -0.04404242],
        [1.1290443, -0.032316945],
        [1.1290443, -0.032316945],
        [-9.852644, -0.9461501],
        [11.317714, -0.31776413],
        [15.627179, -0.037113816],
        [10.133429, -0.15387772],
        [7.0734115, -0.2322754],
        [5.350204, -0.28212222],
        [4.430327, -0.31132188],
        [3.9873326, -0.32561848],
        [3.8191917, -0.3291811],
        [3.7987819, -0.325091],
        [3.8449986, -0.31569016],
        [3.9059415, -0.30281588],
        [5.9015803, -0.14413868],
        [6.2420173, -0.07340424],
        [6.2924743, -0.01326896],
        [6.089511, 0.03751856],
        [5.6508946, 0.07781465],
        [5.048922, 0.10717797],
        [4.3794303, 0.12713924],
        [3.7028143, 0.13953677],
        [3.054284, 0.14646126],
        [2.4047399, -0.16470343],
        [2.221648, -0.14280826],
        [1.9535441, -0.12527047],
        [1.7170742, -0.114411846],
        [1.5791874, -0.10457231],
        [1.4608198, -0.09349118],
        [1.3138874, -0.0841476],
        [1.1842071, -0.07764007],
        [1.0985332, -0.071613856],
        [1.6857659, 0.049895953],
        [1.2033837, 0.057541214],
        [0.7367569, 0.059023138],
        [0.7367569, 0.059023138],
        [-63.908497, -2.1009142],
        [-18.976639, -1.1392865],
        [-1.8490263, -0.6431224],
        [5.110296, -0.36008158],
        [7.909052, -0.18583684],
        [8.8693695, -0.07182444],
        [8.735655, -0.0020745222],
        [8.322191, 0.04806911],
        [7.783767, 0.0855732],
        [7.1881366, 0.11447151],
        [6.5630565, 0.1371161],
        [5.8708973, 0.15088496],
        [6.790253, 0.0018200807],
        [6.488776, 0.05946337],
        [5.9720926, 0.1062262],
        [5.2538166, 0.14247301],
        [4.3679323, 0.16722979],
        [3.3803058, 0.18000613],
        [2.3710818, 0.18164413],
        [1.4098015, 0.17360704],
        [0.5464836, 0.15837318],
        [3.9727356, -0.030111026],
        [3.7468307, 0.0048110588],
        [3.3813386, 0.03465976],
        [2.907688, 0.055208374],
        [2.442639, 0.06764109],
        [2.0265756, 0.0763798],
        [1.6176496, 0.082942836],
        [1.1964084, 0.08578024],
        [0.7985988, 0.08430929],
        [0.9395489, -0.07856828],
        [0.89135, -0.061745144],
        [0.83526033, -0.049978185],
        [0.83526033, -0.049978185],
        [-9.852644, -0.9461501],
        [-12.402011, -0.97279215],
        [-11.678813, -0.95687246],
        [-9.917433, -0.91538286],
        [-7.968791, -0.86264426],
        [-6.1423054, -0.8056963],
        [-4.541984, -0.748177],
        [-3.1913347, -0.69205314],
        [-2.082533, -0.6384448],
        [-1.1962979, -0.5880357],
        [-0.50978315, -0.5412796],
        [0.0006069261, -0.49850005],
        [6.294896, -0.10250406],
        [6.056175, -0.10618217],
        [5.812374, -0.099057436],
        [5.4623003, -0.089577556],
        [5.0220017, -0.08298495],
        [4.5685616, -0.080763385],
        [4.1778803, -0.08140849],
        [3.8837607, -0.08228115],
        [3.6732514, -0.08136916],
        [3.6069257, -0.07989992],
        [3.2864144, -0.07192971],
        [2.9254014, -0.06288348],
        [2.5739539, -0.058666665],
        [2.3296456, -0.055759367],
        [2.143364, -0.050591055],
        [1.9427214, -0.045331933],
        [1.7510395, -0.042270128],
        [1.6083347, -0.039856624],
        [1.7237681, -0.028841756],
        [1.5476234, -0.012083174],
        [1.3478181, -0.000956773],
        [1.3478181, -0.000956773],
        [-9.852644, -0.9461501],
        [11.317714, -0.31776413],
        [15.627179, -0.037113816],
        [15.077405, 0.09609934],
        [11.251614, -8.259406e-5],
        [8.8693695, -0.07182444],
        [7.3491573, -0.12367274],
        [6.411287, -0.15934937],
        [5.855502, -0.1822122],
        [5.541867, -0.19507894],
        [5.372882, -0.20028101],
        [5.2805624, -0.19976482],
        [0.0006150148, -0.50514376],
        [4.0084534, -0.27593505],
        [5.812374, -0.099057436],
        [6.1000013, 0.033269417],
        [5.341037, 0.12254049],
        [3.955257, 0.1704248],
        [2.3264847, 0.18193422],
        [0.7610623, 0.16519785],
        [-0.5374716, 0.12954314],
        [2.582197, 0.15577883],
        [2.3580372, 0.13821632],
        [2.190696, 0.12756096],
        [1.9601712, 0.118142664],
        [1.7389601, 0.1064224],
        [1.5960667, 0.09582701],
        [1.4801904, 0.08852418],
        [1.3420982, 0.08207959],
        [1.2131978, 0.07480586],
        [1.2255828, 0.075569525],
        [1.0562419, 0.06403679],
        [0.8840711, 0.054758515],
        [0.8840711, 0.054758515],
        [-63.908497, -2.1009142],
        [-24.355879, -1.2755091],
        [-7.210728, -0.8142588],
        [0.6998156, -0.5355356],
        [4.119657, -0.36569592],
        [5.990052, -0.24388626],
        [6.818461, -0.15779077],
        [7.1076427, -0.094958045],
        [7.2445083, -0.042337503],
        [7.1203065, -0.0026177324],
        [6.9362545, 0.031231506],
        [6.7395163, 0.06262331],
        [-2.4107165, -0.5865939],
        [-1.4760474, -0.49182296],
        [-1.1039302, -0.4240601],
        [2.2619412, -0.28226244],
        [4.2647123, -0.14449506],
        [5.0354185, -0.02408201],
        [4.8136206, 0.06884027],
        [3.9083161, 0.12960231],
        [2.6296794, 0.15864336],
        [1.5873615, -0.20066103],
        [1.5017395, -0.17218089],
        [1.3080208, -0.15090662],
        [1.1529604, -0.13698474],
        [1.0837638, -0.12393605],
        [1.0112038, -0.110316165],
        [0.90353507, -0.0993243],
        [0.8157803, -0.09135232],
        [0.7662556, -0.083763644],
        [1.8764274, 0.0062811207],
        [1.5821527, 0.02105527],
        [1.2617254, 0.029825458],
        [1.2617254, 0.029825458],
        [-63.908497, -2.1009142],
        [-12.402011, -0.97279215],
        [4.704165, -0.43395564],
        [10.133429, -0.15387772],
        [11.251614, -8.259406e-5],
        [10.735192, 0.087080434],
        [9.629814, 0.13685694],
        [8.3595705, 0.16453211],
        [7.0963264, 0.17848949],
        [5.9058013, 0.18349588],
        [4.8088512, 0.18233599],
        [3.8082888, 0.17667617],
        [-1.3055229, -0.5492626],
        [-0.35393503, -0.45908478],
        [0.06507242, -0.39357242],
        [0.20873643, -0.34774223],
        [0.26509273, -0.31593317],
        [0.34497336, -0.2922105],
        [0.48045805, -0.27169496],
        [0.6443553, -0.25124696],
        [0.793433, -0.23034607],
        [3.9272814, 0.08591191],
        [3.57842, 0.07244071],
        [3.2562397, 0.06651249],
        [2.8900175, 0.059849944],
        [2.5890176, 0.051255327],
        [2.3797784, 0.045142908],
        [2.1830559, 0.04186146],
        [1.9742272, 0.038210116],
        [1.799297, 0.0337168],
        [0.33687577, -0.094537385],
        [0.32249466, -0.077703714],
        [0.316617, -0.065669626],
        [0.316617, -0.065669626],
        [-9.852644, -0.9461501],
        [11.317714, -0.31776413],
        [4.704165, -0.43395564],
        [1.7615404, -0.49755082],
        [0.5751524, -0.5258005],
        [0.27495724, -0.5318703],
        [0.4109991, -0.5238556],
        [0.7427266, -0.5069095],
        [1.1381996, -0.48444209],
        [1.5240626, -0.45880955],
        [1.8599026, -0.4317156],
        [2.124807, -0.40444553],
        [6.4846487, 0.1218059],
        [6.3032413, 0.098491706],
        [6.1780095, 0.08781096],
        [5.9741144, 0.08425915],
        [5.645684, 0.0819096],
        [5.232277, 0.07697861],
        [4.8136206, 0.06884027],
        [4.4560604, 0.059224032],
        [4.1834054, 0.050500706],
        [4.1029873, 0.05057055],
        [3.5141358, 0.0784477],
        [2.85761, 0.10030336],
        [2.1214983, 0.11218047],
        [1.4098085, 0.11388587],
        [0.7928155, 0.10940287],
        [0.25852305, 0.1009795],
        [-0.2122413, 0.08943863],
        [-0.6079261, 0.07457221],
        [0.59425056, 0.08805929],
        [0.51431257, 0.07497706],
        [0.42197603, 0.06484121],
        [0.42197603, 0.06484121],
        [-9.852644, -0.9461501],
        [11.317714, -0.31776413],
        [15.627179, -0.037113816],
        [15.077405, 0.09609934],
        [13.207906, 0.16023542],
        [10.735192, 0.087080434],
        [9.082279, 0.028325032],
        [7.9432693, -0.017688466],
        [7.188263, -0.052017827],
        [6.7043905, -0.0762622],
        [6.4019656, -0.09210404],
        [6.212105, -0.101155914],
        [2.153125, -0.40983573],
        [2.448325, -0.35786077],
        [2.4513035, -0.31455812],
        [2.2619412, -0.28226244],
        [2.0089252, -0.26006767],
        [1.7979859, -0.24459258],
        [1.6760195, -0.23177317],
        [1.6304042, -0.2186839],
        [1.6165504, -0.20435087],
        [3.0855775, -0.12378988],
        [2.8234658, -0.10885633],
        [2.4991386, -0.095471494],
        [2.1965327, -0.08790556],
        [1.9996183, -0.08150282],
        [1.8429323, -0.073285684],
        [1.6646786, -0.06588531],
        [1.4999552, -0.061041232],
        [1.3828483, -0.05676707],
        [1.7681158, 0.04000958],
        [1.3356147, 0.050074544],
        [0.90182984, 0.053947017],
        [0.90182984, 0.053947017],
    ];

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: MassesRefuseParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            last: 20,
            u1: 0.0,
            u2: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x1_next: 0.0,
            x2_hat: 0.0,
            x2_next: 0.0,
            d_hat: 0.0,
            d_next: 0.0,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        self.last = 20;
        let size = (self.x1_next).abs() + (self.x2_next).abs() + (self.d_next).abs();
        if !(size <= 1e18) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x1_next = 0.0;
            self.x2_hat = 0.0;
            self.x2_next = 0.0;
            self.d_hat = 0.0;
            self.d_next = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f32; 1]) -> Result<Control<f32>, Error> {
        if !y[0].is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The estimates; at first what y shows.
        let x1: f32;
        let x2: f32;
        let d: f32;
        if self.seen == 0 {
            x1 = y[0];
            x2 = 0.0;
            d = 0.0;
        } else {
            x1 = self.x1_next + (Self::GAMMA1 * self.u2);
            x2 = self.x2_next + (Self::GAMMA2 * self.u2);
            d = self.d_next;
        }

        // Prediction of the next sample.
        let miss1 = y[0] - x1;
        let off1 = miss1;
        let l1: f32 = 3.739163;
        let l2: f32 = 356.91812;
        let l3: f32 = 456.6237;
        let s1 = (Self::PHI1_1 * x1) + (Self::PHI1_2 * x2);
        let x1_on = s1 + (Self::PHI1_3 * d) + (l1 * off1);
        let s2 = (Self::PHI2_1 * x1) + (Self::PHI2_2 * x2);
        let x2_on = s2 + (Self::PHI2_3 * d) + (l2 * off1);
        let d_on = d + (l3 * off1);
        let left = self.last.saturating_sub(elapsed);
        let planned = left.saturating_sub(1);
        let to_go: u32;
        if planned > 4 {
            to_go = planned;
        } else {
            to_go = 4;
        }

        // Its place between the nodes of the table.
        let row: u32;
        let part: f32;
        if to_go < 64 {
            row = to_go.wrapping_sub(2);
            part = 0.0;
        } else {
            row = (to_go / 2) + 30;
            part = (0.5 * (to_go as f32)) - ((to_go / 2) as f32);
        }

        // The state from which this input acts.
        let s3 = (0.98019874 * x1) + (0.0098347915 * x2);
        let p1 = s3 + (0.0019801282 * (self.u1 + d));
        let s4 = ((-3.9339166) * x1) + (0.96052915 * x2);
        let p2 = s4 + (0.39339164 * (self.u1 + d));

        // The law of least energy.
        let above = row + 1;
        let v: f32;
        let s5 = part * (Self::GAINS[above as usize][0] - Self::GAINS[row as usize][0]);
        let s6 = part * (Self::GAINS[above as usize][1] - Self::GAINS[row as usize][1]);
        let s7 = (Self::GAINS[row as usize][0] + s5) * p1;
        v = (s7 + ((Self::GAINS[row as usize][1] + s6) * p2)) - d;
        if !(v.is_finite() && x1_on.is_finite() && x2_on.is_finite() && d_on.is_finite()) {
            return Err(Error::Range);
        }
        let u_now: f32;
        if v > Self::U_MAX {
            u_now = Self::U_MAX;
        } else if v < -Self::U_MAX {
            u_now = -Self::U_MAX;
        } else {
            u_now = v;
        }
        self.u2 = self.u1;
        self.u1 = u_now;
        self.x1_hat = x1;
        self.x1_next = x1_on;
        self.x2_hat = x2;
        self.x2_next = x2_on;
        self.d_hat = d;
        self.d_next = d_on;
        self.seen = 1;
        let status = if (v > Self::U_MAX) || (v < -Self::U_MAX) {
            Status::Saturated
        } else if (left as f32) - 1.0 <= Self::HOLD {
            Status::Hold
        } else {
            Status::Ok
        };
        Ok(Control { u: u_now, status })
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 3 to 80 samples. Estimates and inputs under way are kept. A deadline before which a limit
    /// could be exceeded is refused (E_SOON).
    ///
    /// # Errors
    /// `Param`: the number of samples is out of its range. `Input`: an argument is not finite or
    /// out of its domain. `Soon`: a limit could be exceeded with so few samples, or with any.
    #[inline]
    pub fn arm_for(&mut self, k: u32, samples: u32) -> Result<(), Error> {
        if !((samples > 2) && (samples < 81)) {
            return Err(Error::Param);
        }
        let x1 = self.x1_next + (Self::GAMMA1 * self.u2);
        let x2 = self.x2_next + (Self::GAMMA2 * self.u2);
        let d = self.d_next;

        // The state from which this input acts.
        let s1 = (0.98019874 * x1) + (0.0098347915 * x2);
        let q1 = s1 + (0.0019801282 * (self.u1 + d));
        let s2 = ((-3.9339166) * x1) + (0.96052915 * x2);
        let q2 = s2 + (0.39339164 * (self.u1 + d));
        let least = (0.8492245 * (-Self::U_MAX)) + d;
        let most = (0.8492245 * Self::U_MAX) + d;
        let within = if -least < most { -least } else { most };
        let tried = samples.saturating_sub(1);
        if !((tried > 4) && (tried < 81)) {
            return Err(Error::Soon);
        }
        let mut fits = 0_u32;

        // Its place between the nodes of the table.
        let node: u32;
        let beyond: f32;
        if tried < 16 {
            node = tried.wrapping_sub(5);
            beyond = 0.0;
        } else if tried < 32 {
            node = (tried / 2) + 4;
            beyond = (0.5 * (tried as f32)) - ((tried / 2) as f32);
        } else if tried < 64 {
            node = (tried / 4) + 13;
            beyond = (0.25 * (tried as f32)) - ((tried / 4) as f32);
        } else {
            node = (tried / 8) + 22;
            beyond = (0.125 * (tried as f32)) - ((tried / 8) as f32);
        }
        let mut bounded = 0_u32;
        let at: u32;
        at = node;
        for _ in 0..11 {
            let next = at + 1;
            if (((1.0 - beyond) * ((Self::BOUNDS_U[at as usize][0] * q1) + (Self::BOUNDS_U[at as usize][1] * q2))) + (beyond * ((Self::BOUNDS_U[next as usize][0] * q1) + (Self::BOUNDS_U[next as usize][1] * q2)))).abs() <= within {
                bounded = bounded + 1;
                at = at + 34;
            } else {
                break;
            }
        }
        if bounded == 11 {
            fits = 1;
        }
        if !(fits == 1) {
            return Err(Error::Soon);
        }
        self.start = k;
        self.last = samples;
        Ok(())
    }

    /// The fewest samples found, from the next call of `step` on, with which the law keeps u and
    /// the states within their limits at every sample to rest, from the estimates as they are
    /// predicted for the next tick, for sure. Give them to `arm_for`.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: a state is too large to
    /// compute with. `Soon`: a limit could be exceeded with so few samples, or with any.
    #[inline]
    pub fn soonest(&self) -> Result<u32, Error> {
        let x1 = self.x1_next + (Self::GAMMA1 * self.u2);
        let x2 = self.x2_next + (Self::GAMMA2 * self.u2);
        let d = self.d_next;

        // The state from which this input acts.
        let s1 = (0.98019874 * x1) + (0.0098347915 * x2);
        let q1 = s1 + (0.0019801282 * (self.u1 + d));
        let s2 = ((-3.9339166) * x1) + (0.96052915 * x2);
        let q2 = s2 + (0.39339164 * (self.u1 + d));
        let mut low = 4_u32;
        let mut top = 81_u32;
        let mut kept = 0_u32;
        let mut tried = 5_u32;
        for _ in 0..64 {
            let least = (0.8492245 * (-Self::U_MAX)) + d;
            let most = (0.8492245 * Self::U_MAX) + d;
            let within = if -least < most { -least } else { most };
            let mut fits = 0_u32;

            // Its place between the nodes of the table.
            let node: u32;
            let beyond: f32;
            if tried < 16 {
                node = tried.wrapping_sub(5);
                beyond = 0.0;
            } else if tried < 32 {
                node = (tried / 2) + 4;
                beyond = (0.5 * (tried as f32)) - ((tried / 2) as f32);
            } else if tried < 64 {
                node = (tried / 4) + 13;
                beyond = (0.25 * (tried as f32)) - ((tried / 4) as f32);
            } else {
                node = (tried / 8) + 22;
                beyond = (0.125 * (tried as f32)) - ((tried / 8) as f32);
            }
            let mut bounded = 0_u32;
            let at: u32;
            at = node;
            for _ in 0..11 {
                let next = at + 1;
                if (((1.0 - beyond) * ((Self::BOUNDS_U[at as usize][0] * q1) + (Self::BOUNDS_U[at as usize][1] * q2))) + (beyond * ((Self::BOUNDS_U[next as usize][0] * q1) + (Self::BOUNDS_U[next as usize][1] * q2)))).abs() <= within {
                    bounded = bounded + 1;
                    at = at + 34;
                } else {
                    break;
                }
            }
            if bounded == 11 {
                fits = 1;
            }
            if fits == 1 {
                kept = tried;
                top = tried;
            } else {
                low = tried;
            }
            let gap = top.saturating_sub(low);
            if gap < 2 {
                break;
            }
            let half = gap / 2;
            if low < half {
                tried = low + low;
            } else {
                tried = low + half;
            }
        }
        if q1.is_finite() && q2.is_finite() {
            if kept > 0 {
                Ok(kept + 1)
            } else {
                Err(Error::Soon)
            }
        } else {
            Err(Error::Range)
        }
    }

    /// The tick at which the loop is to be at rest.
    #[inline]
    pub fn deadline(&self) -> u32 {
        self.start.wrapping_sub(0_u32.wrapping_sub(self.last))
    }

    /// The estimates at the tick of the next call are known: it corrects them by what is measured
    /// then.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn assume(&mut self, xhat: &[f32; 2]) -> Result<(), Error> {
        let n1 = xhat[0] - (Self::GAMMA1 * self.u2);
        let n2 = xhat[1] - (Self::GAMMA2 * self.u2);
        if !(n1.is_finite() && n2.is_finite()) {
            return Err(Error::Input);
        }
        self.x1_next = n1;
        self.x1_hat = xhat[0];
        self.x2_next = n2;
        self.x2_hat = xhat[1];
        self.seen = 1;
        Ok(())
    }

    /// The constant that is added to u is known.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn assume_disturbance(&mut self, d: f32) -> Result<(), Error> {
        if !d.is_finite() {
            return Err(Error::Input);
        }
        self.d_hat = d;
        self.d_next = d;
        Ok(())
    }

    /// The drive applied `u` in place of the u that the last call of `step` gave.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain.
    #[inline]
    pub fn applied(&mut self, u: f32) -> Result<(), Error> {
        if !u.is_finite() {
            return Err(Error::Input);
        }
        self.u1 = u;
        Ok(())
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f32; 2] {
        [self.x1_hat, self.x2_hat]
    }

    /// The estimate of the constant that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f32 {
        self.d_hat
    }
}
