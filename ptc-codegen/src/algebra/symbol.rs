//! The symbols of the field, each with one spelling in text and one in LaTeX.

/// Meaning of a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// The circle constant.
    Pi,
    /// Prescribed settling time tau.
    Tau,
    /// Rate a of stretched time.
    A,
    /// Exponent m of the power family.
    M,
    /// Rate a_i of one term of `exp_sum`.
    Rate,
    /// Gain k_i of the linear infinite-time law.
    Gain,
    /// Scaled gain K_i: gain k_i in units of the rate of stretched time.
    ScaledGain,
    /// i-th derivative of the abstract mapping s (= kappa) with respect to elapsed time.
    Derivative,
    /// r_k: k-th derivative of mu at stretched time.
    R,
    /// Time-to-go T = tau - Dt.
    TimeToGo,
    /// P = (T/tau)^m of the power family.
    PowerRatio,
    /// q = (T/tau)^-m = 1/P of the power family.
    InversePowerRatio,
    /// E = exp(-2 a t) of the tanh family.
    Decay,
    /// L = 1/(1 + E) of the tanh family.
    Logistic,
    /// y = a t, the stretched time in units of its rate.
    StretchedAngle,
    /// V = 1/(1 + y^2) of the tan family.
    Lorentz,
    /// h = 1/sqrt(1 + y^2) of the algebraic family.
    Cosine,
    /// e_i = exp(-a_i t) of one term of `exp_sum`.
    Mode,
    /// 1/T, the tick quantity in which the time-to-go families are evaluated.
    InverseTimeToGo,
    /// 1/T^2, which is kappa' of the rational family but for a factor.
    InverseSquare,
    /// 2 tau/(T (2 tau - T)), which is kappa' of the tanh family but for a factor.
    InverseProduct,
    /// 1 + E, the inverse of L.
    OnePlusDecay,
    /// 1 + y^2, the inverse of V.
    OnePlusSquare,
    /// sqrt(1 + y^2) = 1/h of the algebraic family.
    Secant,
    /// h^2 of the algebraic family.
    CosineSquare,
    /// y h^2 = y/(1 + y^2) of the algebraic family.
    AngleOverSquare,
    /// 1/h^3, which is kappa' of the algebraic family but for a factor.
    InverseCube,
    /// (pi/(2 tau)) cot(th) of the tan family, which is 1/T at the deadline.
    CotangentRate,
    /// (pi/(2 tau)) (1 + y^2) = kappa'/a of the tan family.
    Slope,
    /// H = r_1/a of the soft family.
    Lag,
    /// 1/H = a kappa' of the soft family.
    InverseLag,
    /// y = (1 - start) E/S^2 of the soft family.
    Bend,
    /// z, the generator of a user-defined mapping.
    Generator,
    /// F(z), the denominator of its D ln r_1.
    Denominator,
    /// V = 1/F.
    InverseDenominator,
    /// B = r_1 F but for a factor.
    Base,
    /// 1/B.
    InverseBase,
    /// A part of a user's expression that no polynomial holds: a name, or a call.
    Kernel,
}

/// A symbol: a kind and, for indexed ones, its index (1-based; 0 where there is none).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol {
    /// Meaning.
    pub kind: Kind,
    /// Index, from 1; 0 for a symbol without one.
    pub index: u16,
}

impl Symbol {
    /// The symbol of a kind without index.
    pub const fn plain(kind: Kind) -> Self {
        Self { kind, index: 0 }
    }

    /// The `index`-th symbol of a kind, counted from 1.
    pub fn indexed(kind: Kind, index: usize) -> Self {
        Self { kind, index: u16::try_from(index).unwrap_or(u16::MAX) }
    }

    /// Spelling in plain text; also the stem of identifiers in emitted code, where derivatives of
    /// the abstract mapping, the only spelling that is not an identifier, never occur.
    pub fn text(self) -> String {
        if self.kind == Kind::Derivative {
            return match self.index {
                1 => "s'".to_owned(),
                2 => "s''".to_owned(),
                index => format!("s^({index})"),
            };
        }
        let stem = match self.kind {
            Kind::Pi => "pi",
            Kind::Tau => "tau",
            Kind::A => "a",
            Kind::M => "m",
            Kind::Rate => "a",
            Kind::Gain => "k",
            Kind::ScaledGain => "K",
            Kind::Derivative => "s",
            Kind::R => "r",
            Kind::TimeToGo => "T",
            Kind::PowerRatio => "P",
            Kind::InversePowerRatio => "q",
            Kind::Decay => "E",
            Kind::Logistic => "L",
            Kind::StretchedAngle => "y",
            Kind::Lorentz => "V",
            Kind::Cosine => "h",
            Kind::Mode => "e",
            Kind::InverseTimeToGo => "inv_T",
            Kind::InverseSquare => "inv_T_squared",
            Kind::InverseProduct => "inv_TL",
            Kind::OnePlusDecay => "one_plus_E",
            Kind::OnePlusSquare => "one_plus_y2",
            Kind::Secant => "sec",
            Kind::CosineSquare => "h2",
            Kind::AngleOverSquare => "y_h2",
            Kind::InverseCube => "inv_h3",
            Kind::CotangentRate => "cot_rate",
            Kind::Slope => "slope",
            Kind::Lag => "H",
            Kind::InverseLag => "inv_H",
            Kind::Bend => "y",
            Kind::Generator => "z",
            Kind::Denominator => "F",
            Kind::InverseDenominator => "V",
            Kind::Base => "B",
            Kind::InverseBase => "inv_B",
            Kind::Kernel => "z",
        };
        if self.index == 0 { stem.to_owned() } else { format!("{stem}{}", self.index) }
    }

    /// Spelling in LaTeX.
    pub fn latex(self) -> String {
        let index = self.index;
        match self.kind {
            Kind::Pi => r"\pi".to_owned(),
            Kind::Tau => r"\tau".to_owned(),
            Kind::Derivative => match index {
                1 => "s'".to_owned(),
                2 => "s''".to_owned(),
                _ => format!("s^{{({index})}}"),
            },
            Kind::InverseTimeToGo => "T^{-1}".to_owned(),
            Kind::InverseSquare => "T^{-2}".to_owned(),
            Kind::InverseLag => "H^{-1}".to_owned(),
            Kind::InverseProduct => "(TL)^{-1}".to_owned(),
            Kind::OnePlusDecay => "(1+E)".to_owned(),
            Kind::OnePlusSquare => "(1+y^2)".to_owned(),
            Kind::Secant => r"h^{-1}".to_owned(),
            Kind::CosineSquare => "(h^2)".to_owned(),
            Kind::AngleOverSquare => "(y h^2)".to_owned(),
            Kind::InverseCube => "(h^{-3})".to_owned(),
            Kind::CotangentRate => r"\tfrac{\pi}{2\tau}y".to_owned(),
            Kind::Slope => r"\tfrac{\kappa'}{a}".to_owned(),
            _ if index == 0 => self.text(),
            _ => {
                let stem = Symbol::plain(self.kind).text();
                format!("{stem}_{{{index}}}")
            }
        }
    }

    /// Returns the definition of a quantity that is computed in place of the atoms; `None` for every other symbol.
    pub fn definition(self) -> Option<&'static str> {
        match self.kind {
            Kind::InverseTimeToGo => Some("1/T"),
            Kind::InverseSquare => Some("1/T^2"),
            Kind::InverseLag => Some("1/H = a*kappa'"),
            Kind::InversePowerRatio => Some("(T/tau)^-m"),
            Kind::InverseProduct => Some("1/(T*L) = 2*tau/(T*(2*tau - T))"),
            Kind::OnePlusDecay => Some("1 + E"),
            Kind::OnePlusSquare => Some("1 + y^2"),
            Kind::Secant => Some("sqrt(1 + y^2)"),
            Kind::CosineSquare => Some("h^2 = T*(2*tau - T)/tau^2"),
            Kind::AngleOverSquare => Some("y*h^2 = (1 - T/tau)*h"),
            Kind::InverseCube => Some("1/h^3 = a*tau*kappa'"),
            Kind::CotangentRate => Some("(pi/(2*tau))*y = (pi/(2*tau))*cot(th)"),
            Kind::Slope => Some("(pi/(2*tau))*(1 + y^2) = kappa'/a"),
            _ => None,
        }
    }
}
