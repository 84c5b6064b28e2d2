//! The report of [`Growth`].

use super::super::{Outcome, Verdict, to_f64};
use super::{Growth, NAME};
use crate::diagnostic::{digits, digits_down};

impl Growth {
    /// The line Re = -m rho.
    fn line(&self, m: usize) -> f64 {
        -to_f64(m) * self.rho
    }

    /// Says which poles lie right of the line -m rho, and lists those on it. A pole
    /// counts as on the line if it cannot be distinguished from it numerically.
    fn misses(&self, m: usize) -> (Vec<String>, Vec<String>) {
        let line = self.line(m);
        let slack = 1e-6 * self.poles.iter().map(|pole| pole.norm()).fold(line.abs(), f64::max);
        let right: Vec<_> = self.poles.iter().filter(|pole| pole.re > line + slack).collect();
        let all: Vec<_> = right.iter().map(ToString::to_string).collect();
        let right = match right.as_slice() {
            [] => None,
            [one] => {
                let by = digits(one.re - line);
                Some(format!("the pole {one} lies {by} right of {}", digits(line)))
            }
            _ => Some(format!("the poles {} lie right of {}", all.join(", "), digits(line))),
        };
        let on = self.poles.iter().filter(|pole| (pole.re - line).abs() <= slack);
        (right.into_iter().collect(), on.map(ToString::to_string).collect())
    }

    /// Lists the poles that keep x from 0: no pole may lie on the line.
    fn misses_of_x(&self) -> Vec<String> {
        let (mut misses, on) = self.misses(self.n.saturating_sub(1));
        let line = digits(self.line(self.n.saturating_sub(1)));
        misses.extend(on.iter().map(|pole| format!("the pole {pole} is not left of {line}")));
        misses
    }

    /// Lists the poles that make u grow: the exact test has found poles right of the line, or multiple ones on it.
    fn misses_of_u(&self) -> Vec<String> {
        let (mut misses, on) = self.misses(self.n);
        if let (true, Some(pole)) = (misses.is_empty(), on.first()) {
            let line = digits(self.line(self.n));
            misses.push(format!("the pole {pole} is multiple on the line Re = {line}"));
        }
        misses
    }

    /// Lists the poles that leave open whether u grows.
    fn on_the_line(&self) -> Vec<String> {
        let line = digits(self.line(self.n));
        let on = self.misses(self.n).1.into_iter();
        on.map(|pole| format!("the pole {pole} lies on the line Re = {line}")).collect()
    }

    fn fix(&self) -> String {
        // A number that is typed in is to be accepted.
        let line = digits_down(self.line(self.n));
        match self.largest_rho {
            Some(rho) if self.rho > 0.0 => format!(
                "place every pole left of {line}, or, with these gains, take {} of at most {}",
                self.rate,
                digits_down(rho)
            ),
            _ => format!("place every pole left of {line}"),
        }
    }
}

/// Returns the outcome where mu' falls faster than every exponential. With time-to-go T falling so, a mode e^(lambda t)
/// of x_1 gives x_2 = lambda e^(lambda t)/mu' and more, which grows for any lambda but 0.
pub fn too_fast(n: usize) -> Outcome {
    let grows = match n {
        1 => "u is unbounded at the deadline",
        _ => "x does not go to 0 and u is unbounded at the deadline",
    };
    Outcome {
        name: NAME,
        verdict: Verdict::Unsound,
        summary: format!(
            "{grows}: mu' falls faster than every exponential, and no linear law follows it"
        ),
        details: Vec::new(),
        fix: Some("take a mapping whose mu' falls like an exponential or more slowly".to_owned()),
    }
}

/// Returns the outcome where bounds of rho leave open whether x -> 0.
pub fn open(rho: &str) -> Outcome {
    Outcome {
        name: NAME,
        verdict: Verdict::Undecided,
        summary: format!("whether x goes to 0 depends on the exact value of {rho}"),
        details: Vec::new(),
        fix: Some("place every pole further left".to_owned()),
    }
}

/// Returns the outcome where the decay rate of mu' is not found.
pub fn without_rate(largest: Option<f64>) -> Outcome {
    let up_to =
        largest.map(|rho| format!("; x and u go to 0 if it is at most {}", digits_down(rho)));
    Outcome {
        name: NAME,
        verdict: Verdict::Undecided,
        summary: "the decay rate of mu' is not found".to_owned() + &up_to.unwrap_or_default(),
        details: Vec::new(),
        fix: Some("write the mapping with fewer functions within functions".to_owned()),
    }
}

impl From<&Growth> for Outcome {
    fn from(growth: &Growth) -> Self {
        // Where x -> 0 no pole is excepted, so that what u does is decided, or open on the line.
        let (found, misses) = match (growth.x_to_zero, growth.u_bounded) {
            (false, Some(false)) => {
                // The line of u is the one that counts for both.
                let misses = match growth.misses(growth.n).0 {
                    right if right.is_empty() => growth.misses_of_x(),
                    right => right,
                };
                ("x does not go to 0 and u is unbounded at the deadline", misses)
            }
            (false, _) => ("x does not go to 0 at the deadline", growth.misses_of_x()),
            (true, Some(false)) => ("u is unbounded at the deadline", growth.misses_of_u()),
            (true, None) => (
                "x goes to 0 at the deadline; it is open whether u stays bounded",
                growth.on_the_line(),
            ),
            (true, _) if growth.u_to_zero == Some(true) => {
                ("x and u go to 0 at the deadline", Vec::new())
            }
            (true, _) => ("x goes to 0 and u stays bounded at the deadline", Vec::new()),
        };
        let verdict = match (growth.x_to_zero, growth.u_bounded) {
            (true, Some(true)) => Verdict::Sound,
            (true, None) => Verdict::Undecided,
            _ => Verdict::Unsound,
        };
        let mut misses = misses.into_iter();
        let summary = match misses.next() {
            Some(worst) => format!("{found}: {worst}"),
            None => found.to_owned(),
        };
        let mut details: Vec<_> = misses.collect();
        details.extend(growth.excepted.iter().map(|m| {
            format!("the simple pole at -m rho, m = {m}, leaves x{} at a constant", m + 1)
        }));
        if !growth.x_to_zero && growth.u_bounded != Some(false) {
            let bounded = growth.u_bounded.is_some();
            let u = if bounded { "u stays bounded" } else { "it is open whether u stays bounded" };
            details.push(u.to_owned());
        }
        let poles: Vec<_> = growth.poles.iter().map(ToString::to_string).collect();
        let spelling = growth.spelling.as_ref().map(|text| format!("{text} = "));
        let rho = spelling.unwrap_or_default() + &digits(growth.rho);
        details.push(format!("poles {}; rho = {rho}", poles.join(", ")));
        Self {
            name: NAME,
            verdict,
            summary,
            details,
            fix: (verdict != Verdict::Sound).then(|| growth.fix()),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::algebra::{BigRational, integer};
    use crate::check::growth::{Modes, growth, too_fast};
    use crate::check::{Outcome, Verdict};
    use crate::request::{Pole, gains};

    fn told(poles: &[(i64, i64)], rho: BigRational, modes: Modes) -> Outcome {
        let poles: Vec<_> =
            poles.iter().map(|(re, im)| Pole { re: integer(*re), im: integer(*im) }).collect();
        let outcome = Outcome::from(&growth(&gains(&poles).expect("conjugate pairs"), &rho, modes));
        assert_eq!(outcome.verdict == Verdict::Sound, outcome.fix.is_none());
        outcome
    }

    #[test]
    fn poles_left_of_the_lines_are_sound() {
        let outcome = told(&[(-3, 0), (-4, 0)], integer(1), Modes::Polynomial);
        assert_eq!(outcome.summary, "x and u go to 0 at the deadline");
        assert_eq!(outcome.details, ["poles -3, -4; rho = 1"]);
        let outcome = told(&[(-2, 0), (-3, 0)], integer(1), Modes::Polynomial);
        assert_eq!(outcome.summary, "x goes to 0 and u stays bounded at the deadline");
    }

    #[test]
    fn poles_between_the_lines_leave_u_unbounded() {
        let rho = BigRational::new(3.into(), 2.into());
        let outcome = told(&[(-2, 5), (-2, -5)], rho, Modes::Analytic);
        assert_eq!(
            outcome.summary,
            "u is unbounded at the deadline: the poles -2+5i, -2-5i lie right of -3"
        );
        assert_eq!(
            outcome.fix.as_deref(),
            Some("place every pole left of -3, or, with these gains, take 2 a of at most 0.999")
        );
    }

    #[test]
    fn poles_on_the_lines_are_reported() {
        let outcome = told(&[(-2, 0), (-2, 0)], integer(1), Modes::Polynomial);
        assert_eq!(
            outcome.summary,
            "u is unbounded at the deadline: the pole -2 is multiple on the line Re = -2"
        );
        let outcome = told(&[(-1, 0), (-3, 0)], integer(1), Modes::Other);
        assert_eq!(
            outcome.summary,
            "x does not go to 0 at the deadline: the pole -1 is not left of -1"
        );
        assert_eq!(
            outcome.details,
            [
                "the simple pole at -m rho, m = 1, leaves x2 at a constant",
                "it is open whether u stays bounded",
                "poles -1, -3; rho = 1",
            ]
        );
    }

    #[test]
    fn growth_beyond_every_exponential_is_unsound() {
        assert!(too_fast(1).summary.starts_with("u is unbounded"));
        assert!(too_fast(2).summary.starts_with("x does not go to 0 and u is unbounded"));
    }

    #[test]
    fn zero_decay_rate_requires_poles_left_of_zero() {
        let outcome = told(&[(1, 0), (-1, 0)], integer(0), Modes::Other);
        assert_eq!(
            outcome.summary,
            "x does not go to 0 and u is unbounded at the deadline: the pole 1 lies 1 right of 0"
        );
        assert_eq!(outcome.fix.as_deref(), Some("place every pole left of 0"));
    }
}
