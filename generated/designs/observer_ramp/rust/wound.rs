//! Prescribed-time controller wound: order n = 2, clock in samples.
//!
//! ```text
//! DO NOT EDIT. Made by:
//!   ptc-codegen emit --lang rust --n 2 --mu "exp(a=1)" --name wound --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --C="[[1,0]]" --disturbance ramp --observer=stationary --disturbance-walk=5 --tau=0.3 --eps=0.01 --u-max=10 --poles=least-energy --sample-time=0.001 --sensor-step=1e-5
//! Version 0.1.0, design 6978bbac7216.
//!
//! Plant: x' = A x + B (u + d), d an unknown ramp of --A and --B above; u held from sample to
//!       sample, y = C x.
//! Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
//!       sample period, as long as u is not clipped and nothing else acts on the plant. What d
//!       does within a sample remains, of order h^(4-i) in x_i.
//! Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
//!       sum of u^2. The gains are a table of 2128 bytes: exact below 64 samples to go, and
//!       before it those of a grid of 133 nodes, interpolated in a line. The gains of 10
//!       samples to go stay.
//!
//! Parameters:
//!   samples = 300 [samples], fixed: samples N from the start to rest
//!   h = 0.001 [s], fixed: sample period
//!   eps = 0.01 [s], fixed: time-to-go at which the gains are held
//!   u_max = 10 [unit of u], fixed: bound of |u|
//!   a = 1 [1/s], fixed: rate of stretched time
//!
//! k counts samples and may wrap; arm again within 2^32 - N samples.
//! From sample N on the last gains are held (status HOLD).
//! The estimates approach the state from the first sample on: the observer has the gains of
//!       the stationary Kalman filter for the noise and disturbance_walk.
//! |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
//!       lasts.
//! Guard full: what is measured is finite, or the call is refused (INPUT).
//! Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
//!       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
//!
//! Checks of the design (details: ptc-codegen check):
//!   membership: sound: exp is of class M for all its parameters.
//!   growth: sound: near rest at sample 300, not at rest: the gains are held from 10 samples
//!       to go, and |u| is bounded; so does what the stationary observer leaves of its error.
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
pub struct Control<R = f64> {
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

/// Run-time parameters of [`Wound`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct WoundParams {}

/// Prescribed-time controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Wound {
    /// tick at which it was armed.
    start: u32,
    /// input of the last sample.
    u1: f64,
    /// 1 once y has been measured.
    seen: u32,
    /// estimate of x1.
    x1_hat: f64,
    /// prediction of x1 without u.
    x1_next: f64,
    /// estimate of x2.
    x2_hat: f64,
    /// prediction of x2 without u.
    x2_next: f64,
    /// estimate of d.
    d_hat: f64,
    /// prediction of d without u.
    d_next: f64,
    /// estimate of d_rate.
    d_rate_hat: f64,
    /// prediction of d_rate without u.
    d_rate_next: f64,
}

#[allow(
    non_snake_case,
    dead_code,
    unused_variables,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Wound {
    /// Prediction from u.
    const GAMMA1: f64 = 1.9966708291701364e-5;
    /// Prediction from u.
    const GAMMA2: f64 = 0.03990016645854149;
    /// Prediction of x1 from x2.
    const PHI1_2: f64 = 0.0009975041614635374;
    /// Prediction of x1 from d.
    const PHI1_3: f64 = 1.9966708291701364e-5;
    /// Prediction of x1 from d_rate.
    const PHI1_4: f64 = 6.65834165972718e-9;
    /// Prediction of x2 from x2.
    const PHI2_2: f64 = 0.9950124791926823;
    /// Prediction of x2 from d.
    const PHI2_3: f64 = 0.03990016645854149;
    /// Prediction of x2 from d_rate.
    const PHI2_4: f64 = 1.9966708291701364e-5;
    /// Prediction of d from d_rate.
    const PHI3_4: f64 = 0.001;
    /// 1/2000, weight of d_rate in d0.
    const D0_D_RATE: f64 = 0.0005;
    /// Samples from the start to rest.
    const SAMPLES: u32 = 300;
    /// Bound of |u|.
    const U_MAX: f64 = 10.0;
    /// Samples to go at which the gains are held.
    const HOLD: f64 = 10.0;

    /// Gains of least energy of each state, a row for the samples to go of a node.
    #[rustfmt::skip]
    const GAINS: &'static [[f64; 2]; 133] = &[
        [-25062.55208331163, -37.45838539928387],
        [-12531.276041655816, -27.02091153629504],
        [-7518.771890597572, -21.17512730136674],
        [-5012.522947839163, -17.41685454673074],
        [-3580.382484960281, -14.791921685154502],
        [-2685.29581446331, -12.853004827701644],
        [-2088.572113309308, -11.361511337588555],
        [-1670.8660445699165, -10.178253886647713],
        [-1367.0801924248185, -9.216462472334808],
        [-1139.2410880456976, -8.419192302134173],
        [-963.9804575280741, -7.7475056835855245],
        [-826.2758484653018, -7.173867479447892],
        [-716.1122988456777, -6.678251755867355],
        [-626.6045265894896, -6.245743125016565],
        [-552.8923356192942, -5.8650030366739845],
        [-491.46558651746074, -5.527257508159454],
        [-439.73786238226137, -5.225610425046795],
        [-395.76935174979474, -4.954566395590321],
        [-358.08210395224614, -4.709692126318068],
        [-325.53406691464073, -4.487371545828679],
        [-297.2314613108345, -4.284625719832186],
        [-272.4667122832038, -4.098978394427451],
        [-250.67376029944174, -3.9283542217508476],
        [-231.3954037153636, -3.7710007577691615],
        [-214.2591080907677, -3.625427994983439],
        [-198.9588631838909, -3.490360996044272],
        [-185.24141929776482, -3.3647024313193445],
        [-172.89573515015255, -3.2475026852219093],
        [-161.7448084859356, -3.1379358050018875],
        [-151.63929374570083, -3.0352800015816697],
        [-142.45247356429783, -2.938901727848315],
        [-134.0762655507691, -2.8482425912471],
        [-126.41802771362536, -2.7628085288985127],
        [-119.39798505450041, -2.682160801615334],
        [-112.9471430233356, -2.6059084599124938],
        [-107.00558533779206, -2.533702008723079],
        [-101.52107732283747, -2.4652280540296214],
        [-96.4479136663855, -2.4002047583056494],
        [-91.74596289998007, -2.3383779656868584],
        [-87.37987113303078, -2.2795178844715838],
        [-83.31839541198548, -2.2234162356068197],
        [-79.53384313623167, -2.1698837925359418],
        [-76.00159867616605, -2.118748251137814],
        [-72.69972202781202, -2.0698523792108214],
        [-69.60860724242359, -2.0230524036126596],
        [-66.71069066856059, -1.9782166001907233],
        [-63.990200873971226, -1.935224057363983],
        [-61.43294357850104, -1.8939635889065702],
        [-59.02611610609145, -1.854332775340262],
        [-56.75814681446088, -1.8162371165287596],
        [-54.618555732244545, -1.7795892807083726],
        [-52.597833261740725, -1.7443084373888083],
        [-50.68733431953344, -1.7103196633950737],
        [-48.87918570957591, -1.6775534128620255],
        [-47.166204871543165, -1.6459450432891332],
        [-45.54182843544784, -1.6154343908569635],
        [-44.00004925285312, -1.5859653891331444],
        [-42.53536077446738, -1.5574857260822101],
        [-41.14270781065835, -1.5299465349637833],
        [-39.81744285128224, -1.5033021152758699],
        [-38.55528723888131, -1.4775096803902563],
        [-37.35229658857752, -1.4525291289479483],
        [-36.20482993199029, -1.4283228374450154],
        [-34.06325919005944, -1.3820938155806135],
        [-32.106536803142006, -1.338564431477856],
        [-30.313985513026402, -1.297505701218112],
        [-28.667740477433156, -1.2587138257138495],
        [-27.152302410418812, -1.2220068207829147],
        [-25.754171416504423, -1.1872216742436565],
        [-24.46154528468084, -1.1542119363133219],
        [-23.264069592318712, -1.1228456681669643],
        [-22.152629694858003, -1.0930036880472276],
        [-21.119176765645577, -1.0645780657608817],
        [-20.156581661606076, -1.0374708254679725],
        [-19.258511641816636, -1.0115928238994039],
        [-18.419325944014677, -0.9868627769342994],
        [-17.63398699291158, -0.9632064121390287],
        [-16.89798462206792, -0.9405557286528212],
        [-16.207271174315228, -0.9188483488839579],
        [-15.558205731836736, -0.8980269489982304],
        [-14.947506037085217, -0.8780387572491501],
        [-14.372206915882634, -0.8588351109048781],
        [-13.829624216800774, -0.8403710639392016],
        [-13.317323445964547, -0.8226050388280604],
        [-12.833092411325039, -0.8054985167729085],
        [-12.374917301162197, -0.7890157614927269],
        [-11.940961712785693, -0.7731235724159998],
        [-11.529548222820779, -0.7577910636853106],
        [-11.139142153050017, -0.7429894658788976],
        [-10.768337237893562, -0.728691947770666],
        [-10.415842943146174, -0.714873455805111],
        [-10.080473222075732, -0.7015105692665033],
        [-9.761136525661026, -0.6885813693808883],
        [-9.456826909609179, -0.6760653208118154],
        [-9.16661610266188, -0.6639431642020094],
        [-8.625124415267713, -0.6408092925783974],
        [-8.130537323271147, -0.6190477039605723],
        [-7.67758988647958, -0.5985413585332934],
        [-7.261735669555908, -0.5791861530901838],
        [-6.879032210126091, -0.5608891815779076],
        [-6.5260472340516715, -0.5435672689587614],
        [-6.1997814312332595, -0.5271457295661145],
        [-5.897604532320134, -0.5115573108473565],
        [-5.617202131130627, -0.49674129098509934],
        [-5.35653123684372, -0.48264270486283967],
        [-5.113782955729232, -0.46921167757142107],
        [-4.887351024780353, -0.4564028484192852],
        [-4.67580517153525, -0.4441748714258962],
        [-4.477868472289474, -0.43248998070631994],
        [-4.2923980372763735, -0.421313611120303],
        [-4.118368475621753, -0.4106140661574739],
        [-3.954857692083967, -0.400362226336105],
        [-3.801034647206928, -0.3905312924645114],
        [-3.6561487767130783, -0.3810965589973729],
        [-3.5195208179677313, -0.372035213450151],
        [-3.3905348336558507, -0.36332615844198357],
        [-3.2686312573789826, -0.35494985344378815],
        [-3.153300814234341, -0.34688817373208025],
        [-3.0440791927863806, -0.33912428440490333],
        [-2.9405423641389032, -0.3316425276161462],
        [-2.8423024598226094, -0.32442832143802014],
        [-2.749004133535985, -0.3174680689764142],
        [-2.660321342903319, -0.31074907654665324],
        [-2.575954496734587, -0.3042594798730975],
        [-2.495627921104846, -0.2979881774093737],
        [-2.4190876041728377, -0.2919247699903831],
        [-2.3460991852392303, -0.28605950612555253],
        [-2.2099282641741778, -0.27488734794385006],
        [-2.085569571646548, -0.2644048657952509],
        [-1.9716947441056276, -0.2545528356422077],
        [-1.8671570099165657, -0.2452785920601236],
        [-1.7709621952622956, -0.23653514437701323],
        [-1.6822449906745098, -0.22828043202923856],
    ];

    /// Takes the parameters and arms at tick 0.
    ///
    /// # Errors
    /// `Param`: a parameter is outside its domain, or the coefficients derived from it leave the range.
    pub fn new(params: WoundParams) -> Result<Self, Error> {
        Ok(Self {
            start: 0,
            u1: 0.0,
            seen: 0,
            x1_hat: 0.0,
            x1_next: 0.0,
            x2_hat: 0.0,
            x2_next: 0.0,
            d_hat: 0.0,
            d_next: 0.0,
            d_rate_hat: 0.0,
            d_rate_next: 0.0,
        })
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    #[inline]
    pub fn arm(&mut self, k: u32) {
        self.start = k;
        let s1 = (self.x1_next).abs() + (self.x2_next).abs() + (self.d_next).abs();
        let size = s1 + (self.d_rate_next).abs();
        if !(size <= 1e150) {
            self.seen = 0;
            self.x1_hat = 0.0;
            self.x1_next = 0.0;
            self.x2_hat = 0.0;
            self.x2_next = 0.0;
            self.d_hat = 0.0;
            self.d_next = 0.0;
            self.d_rate_hat = 0.0;
            self.d_rate_next = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick.
    ///
    /// # Errors
    /// `Input`: an argument is not finite or out of its domain. `Range`: u is not finite.
    #[inline]
    pub fn step(&mut self, k: u32, y: &[f64; 1]) -> Result<Control<f64>, Error> {
        if !y[0].is_finite() {
            return Err(Error::Input);
        }
        let elapsed = k.wrapping_sub(self.start);

        // The estimates; at first what y shows.
        let x1: f64;
        let x2: f64;
        let d: f64;
        let d_rate: f64;
        if self.seen == 0 {
            x1 = y[0];
            x2 = 0.0;
            d = 0.0;
            d_rate = 0.0;
        } else {
            x1 = self.x1_next + (Self::GAMMA1 * self.u1);
            x2 = self.x2_next + (Self::GAMMA2 * self.u1);
            d = self.d_next;
            d_rate = self.d_rate_next;
        }

        // Prediction of the next sample.
        let miss1 = y[0] - x1;
        let off1 = miss1;
        let l1: f64 = 0.5585637305501465;
        let l2: f64 = 139.80905203556958;
        let l3: f64 = 543.231381268175;
        let l4: f64 = 41388.00314050849;
        let s1 = x1 + (Self::PHI1_2 * x2) + (Self::PHI1_3 * d);
        let x1_on = s1 + (Self::PHI1_4 * d_rate) + (l1 * off1);
        let s2 = (Self::PHI2_2 * x2) + (Self::PHI2_3 * d);
        let x2_on = s2 + (Self::PHI2_4 * d_rate) + (l2 * off1);
        let d_on = d + (Self::PHI3_4 * d_rate) + (l3 * off1);
        let d_rate_on = d_rate + (l4 * off1);

        // The disturbance while each input acts.
        let d0 = d + (Self::D0_D_RATE * d_rate);
        let left = Self::SAMPLES.saturating_sub(elapsed);
        let to_go: u32;
        if left > 10 {
            to_go = left;
        } else {
            to_go = 10;
        }

        // Its place between the nodes of the table.
        let row: u32;
        let part: f64;
        if to_go < 64 {
            row = to_go.wrapping_sub(2);
            part = 0.0;
        } else if to_go < 128 {
            row = (to_go / 2) + 30;
            part = (0.5 * (to_go as f64)) - ((to_go / 2) as f64);
        } else if to_go < 256 {
            row = (to_go / 4) + 62;
            part = (0.25 * (to_go as f64)) - ((to_go / 4) as f64);
        } else {
            row = (to_go / 8) + 94;
            part = (0.125 * (to_go as f64)) - ((to_go / 8) as f64);
        }

        // The law of least energy.
        let above = row + 1;
        let v: f64;
        let s3 = part * (Self::GAINS[above as usize][0] - Self::GAINS[row as usize][0]);
        let s4 = part * (Self::GAINS[above as usize][1] - Self::GAINS[row as usize][1]);
        let s5 = (Self::GAINS[row as usize][0] + s3) * x1;
        v = (s5 + ((Self::GAINS[row as usize][1] + s4) * x2)) - d0;
        if !(v.is_finite()
            && x1_on.is_finite()
            && x2_on.is_finite()
            && d_on.is_finite()
            && d_rate_on.is_finite())
        {
            return Err(Error::Range);
        }
        let u_now: f64;
        if v > Self::U_MAX {
            u_now = Self::U_MAX;
        } else if v < -Self::U_MAX {
            u_now = -Self::U_MAX;
        } else {
            u_now = v;
        }
        self.u1 = u_now;
        self.x1_hat = x1;
        self.x1_next = x1_on;
        self.x2_hat = x2;
        self.x2_next = x2_on;
        self.d_hat = d;
        self.d_next = d_on;
        self.d_rate_hat = d_rate;
        self.d_rate_next = d_rate_on;
        self.seen = 1;
        let status = if (v > Self::U_MAX) || (v < -Self::U_MAX) {
            Status::Saturated
        } else if (left as f64) <= Self::HOLD {
            Status::Hold
        } else {
            Status::Ok
        };
        Ok(Control { u: u_now, status })
    }

    /// The estimate of the state at the last sample.
    #[inline]
    pub fn estimate(&self) -> [f64; 2] {
        [self.x1_hat, self.x2_hat]
    }

    /// The estimate of the ramp that is added to u.
    #[inline]
    pub fn disturbance(&self) -> f64 {
        self.d_hat
    }
}
