//! The families of time mappings: their names, parameters and formulas, as text.

/// A family of class K/M mappings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// mu = tau (1 - e^{-a t}).
    Exp,
    /// mu = tau a t / (1 + a t).
    Rational,
    /// mu = tau (1 - (1 + a m t)^{-1/m}).
    Power,
    /// mu = (2 tau/pi) atan(a t).
    Tan,
    /// mu = tau tanh(a t).
    Tanh,
    /// mu = tau a t / sqrt(1 + (a t)^2).
    Algebraic,
    /// mu = tau mean_i (1 - e^{-a_i t}).
    ExpSum,
    /// kappa = -ln(1 - r s - (1 - r) s^2)/a with s = Dt/tau: kappa'(0) = r/(a tau).
    Soft,
}

/// Description of a family in help and docs.
#[derive(Clone, Copy, Debug)]
pub struct FamilyInfo {
    /// The family.
    pub family: Family,
    /// Name, in the spec and in file names.
    pub name: &'static str,
    /// mu(t), t the stretched time since t0.
    pub mu: &'static str,
    /// kappa(Dt), in time-to-go form; w = T/tau.
    pub kappa: &'static str,
    /// kappa as an expression in the time-to-go `T`; empty where there is none.
    pub kappa_in_time_to_go: &'static str,
    /// r_k in closed form.
    pub r: &'static str,
    /// The atoms in which the expansions are polynomials.
    pub atoms: &'static str,
    /// Decay rate of mu'.
    pub decay_rate: &'static str,
    /// Keys of its own parameters; [`Parameter`](crate::parameter::Parameter) has the others.
    pub parameters: &'static [&'static str],
}

/// The families, in the order in which they are listed.
pub static FAMILIES: [FamilyInfo; 8] = [
    FamilyInfo {
        family: Family::Exp,
        name: "exp",
        mu: "tau*(1 - exp(-a*t))",
        kappa: "-ln(T/tau)/a",
        kappa_in_time_to_go: "-ln(T/tau)/a",
        r: "(-1)^(k-1) a^k T",
        atoms: "T = time-to-go",
        decay_rate: "a",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::Rational,
        name: "rational",
        mu: "tau*a*t/(1 + a*t)",
        kappa: "Dt/(a*T)",
        kappa_in_time_to_go: "(tau/T - 1)/a",
        r: "(-1)^(k-1) k! (a/tau)^k T^(k+1)",
        atoms: "T = time-to-go",
        decay_rate: "0",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::Power,
        name: "power",
        mu: "tau*(1 - (1 + a*m*t)^(-1/m))",
        kappa: "((T/tau)^-m - 1)/(a*m)",
        kappa_in_time_to_go: "((T/tau)^(-m) - 1)/(a*m)",
        r: "(-1)^(k-1) prod_{i<k}(1 + i*m) a^k T P^k",
        atoms: "T = time-to-go, P = (T/tau)^m",
        decay_rate: "0",
        parameters: &["a", "m"],
    },
    FamilyInfo {
        family: Family::Tan,
        name: "tan",
        mu: "(2*tau/pi)*atan(a*t)",
        kappa: "cot(th)/a, th = pi*T/(2*tau)",
        kappa_in_time_to_go: "1/(a*tan(pi*T/(2*tau)))",
        r: "(-1)^(k-1) (k-1)! (2*tau/pi) a^k sin(k*th) sin(th)^k",
        atoms: "y = cot(th), V = 1/(1 + y^2)",
        decay_rate: "0",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::Tanh,
        name: "tanh",
        mu: "tau*tanh(a*t)",
        kappa: "-ln(E)/(2*a), E = T/(2*tau - T)",
        kappa_in_time_to_go: "-ln(T/(2*tau - T))/(2*a)",
        r: "2*tau*(-2*a)^k Li_{-k}(-E)",
        atoms: "T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), L = 1/(1 + E)",
        decay_rate: "2*a",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::Algebraic,
        name: "algebraic",
        mu: "tau*a*t/sqrt(1 + (a*t)^2)",
        kappa: "y/a, y = (tau - T)/sqrt(T*(2*tau - T))",
        kappa_in_time_to_go: "(tau - T)/(a*sqrt(T*(2*tau - T)))",
        r: "tau a^k v^(1 + k/2) Q_k(s), s = 1 - T/tau, v = 1 - s^2, Q_1 = 1, Q_{k+1} = v Q_k' - (k+2) s Q_k",
        atoms: "y = a*t, h = 1/sqrt(1 + y^2)",
        decay_rate: "0",
        parameters: &["a"],
    },
    FamilyInfo {
        family: Family::ExpSum,
        name: "exp_sum",
        mu: "tau*mean_i(1 - exp(-a_i*t))",
        kappa: "the root t of mean_i(exp(-a_i*t)) = T/tau, by a bracketed iteration",
        kappa_in_time_to_go: "",
        r: "(-1)^(k-1) tau mean_i(a_i^k e_i)",
        atoms: "e_i = exp(-a_i*t)",
        decay_rate: "min_i a_i",
        parameters: &["rates"],
    },
    FamilyInfo {
        family: Family::Soft,
        name: "soft",
        mu: "tau*(1 - 2*exp(-a*t)/(2 - start + sqrt(start^2 + 4*(1 - start)*(1 - exp(-a*t)))))",
        kappa: "-ln(E)/a, E = w*(1 + (1 - start)*(1 - w)), w = T/tau",
        kappa_in_time_to_go: "-ln((T/tau)*(1 + (1 - start)*(1 - T/tau)))/a",
        r: "a^k H p_k(y), p_1 = 1, p_{k+1} = -(1 + 2*y) p_k - y (1 + 4*y) p_k'",
        atoms: "E = exp(-a*t), S = tau*dE/dT, H = tau*E/S, y = (1 - start)*E/S^2",
        decay_rate: "a",
        parameters: &["a", "start"],
    },
];

impl Family {
    /// Everything told about the family.
    pub fn info(self) -> &'static FamilyInfo {
        // The table is in the order of the enum; a test holds it there.
        &FAMILIES[self as usize]
    }

    /// The family's name.
    pub fn name(self) -> &'static str {
        self.info().name
    }

    /// Returns true if kappa needs an iteration at run time.
    pub fn is_iterated(self) -> bool {
        self == Self::ExpSum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_order_of_the_enum() {
        for (index, info) in FAMILIES.iter().enumerate() {
            assert_eq!(info.family as usize, index);
            assert!(std::ptr::eq(info.family.info(), info));
        }
    }
}
