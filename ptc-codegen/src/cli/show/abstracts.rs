//! The closed forms of mappings of which nothing is known, by the selected engine. The
//! library's own has a published sum for them, which is faster than D.

use crate::algebra::{Kind, Poly, Symbol, integer};
use crate::expansion::{bell::bell_table, letter};
use crate::mapping::Mapping;

use super::super::engine::{Engine, Part};
use super::super::report::Failure;

/// r_1, ..., r_n in the derivatives of the abstract mapping.
pub(super) fn r(engine: Engine, n: usize) -> Result<Vec<Poly>, Failure> {
    match engine {
        Engine::Ptc => Ok(letter::r(n)),
        engine => Ok(engine.expand(n, &Mapping::symbolic(n), Part::R)?.r),
    }
}

/// B_{i,j} in the derivatives of the abstract mapping.
pub(super) fn table(engine: Engine, n: usize) -> Result<Vec<Vec<Poly>>, Failure> {
    match engine {
        Engine::Ptc => Ok(letter::table(n)),
        engine => Ok(engine.expand(n, &Mapping::symbolic(n), Part::All)?.bell),
    }
}

/// B_{i,j} in free r_k.
pub(super) fn bell(engine: Engine, n: usize) -> Result<Vec<Vec<Poly>>, Failure> {
    match engine {
        Engine::Ptc => Ok(bell_table(n)),
        engine => Ok(engine.expand(n, &Mapping::free(n), Part::All)?.bell),
    }
}

/// R_{k,m} for 0 <= m <= k < n: `[k][m]`.
pub(super) fn big_r(engine: Engine, n: usize) -> Result<Vec<Vec<Poly>>, Failure> {
    if engine == Engine::Ptc {
        return Ok((0..n).map(|k| (0..=k).map(|m| letter::big_r(k, m)).collect()).collect());
    }
    Ok(r(engine, n)?.iter().enumerate().map(|(k, r)| parts(k, r)).collect())
}

/// R_{k,m} out of r_{k+1} = s'^-(k+1) sum_{m=0..k} (-1)^m s'^-m R_{k,m}.
fn parts(k: usize, r: &Poly) -> Vec<Poly> {
    let by_power = r.collect(Symbol::indexed(Kind::Derivative, 1));
    let part = |m: usize| {
        let power = -i32::try_from(k + 1 + m).unwrap_or(i32::MAX);
        let part = by_power.get(&power).cloned().unwrap_or_default();
        if m.is_multiple_of(2) { part } else { part.scaled(&integer(-1)) }
    };
    (0..=k).map(part).collect()
}
