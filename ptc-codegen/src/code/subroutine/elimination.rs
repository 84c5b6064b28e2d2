//! The solution of linear equations.

use super::{at, each, set, set_at};
use crate::code::{Expr, For, Index, Operator, Shape, Statement, Test};
use crate::expression::Function;

/// Gaussian elimination of `m` equations with the largest pivot of each column, the first of equals.
pub(super) fn body(m: usize) -> Vec<Statement> {
    let [k, i, j] = ["k", "i", "j"].map(Index::of);
    let (first, end) = (|| Index::at(0), || Index::at(m));
    let behind = || k.clone() + Index::at(1);
    let a = |row: &Index, column: &Index| {
        row.clone() * i32::try_from(m).unwrap_or(i32::MAX) + column.clone()
    };
    let real = |name: &str, value| Statement::Let(name.to_owned(), Shape::Real, value);
    let less = |from: Expr, x: Expr, y: Expr| {
        Expr::binary(Operator::Sub, from, Expr::binary(Operator::Mul, x, y))
    };
    let size = |place: Index| Expr::Call(Function::Abs, Box::new(at("a", place)));
    let (largest, most) = (|| Expr::local("largest"), || Expr::local("most"));

    let search = vec![
        real("size", size(a(&i, &k))),
        Statement::If(
            Test::Less(largest(), Expr::local("size")),
            vec![set("largest", Expr::local("size")), set("most", Expr::local("i"))],
            Vec::new(),
        ),
    ];
    // The indices of all loops are known to a compiler that unrolls them, which `most` as an index would not be.
    let swap = Statement::If(
        Test::CountEqual(most(), Expr::local("i")),
        vec![
            real("kept", at("b", k.clone())),
            set_at("b", k.clone(), at("b", i.clone())),
            set_at("b", i.clone(), Expr::local("kept")),
            each(
                "j",
                k.clone(),
                end(),
                vec![
                    real("entry", at("a", a(&k, &j))),
                    set_at("a", a(&k, &j), at("a", a(&i, &j))),
                    set_at("a", a(&i, &j), Expr::local("entry")),
                ],
            ),
        ],
        Vec::new(),
    );
    let factor = || Expr::local("factor");
    let eliminate = vec![
        real("factor", Expr::binary(Operator::Div, at("a", a(&i, &k)), at("a", a(&k, &k)))),
        each(
            "j",
            behind(),
            end(),
            vec![set_at("a", a(&i, &j), less(at("a", a(&i, &j)), factor(), at("a", a(&k, &j))))],
        ),
        set_at("b", i.clone(), less(at("b", i.clone()), factor(), at("b", k.clone()))),
    ];
    let down = vec![
        Statement::Begin("most".to_owned(), Shape::Count, Expr::local("k")),
        Statement::Begin("largest".to_owned(), Shape::Real, size(a(&k, &k))),
        each("i", behind(), end(), search),
        each("i", behind(), end(), vec![swap]),
        set_at("a", a(&k, &k), Expr::Divisor(Box::new(at("a", a(&k, &k))))),
        each("i", behind(), end(), eliminate),
    ];
    let up = vec![
        each(
            "j",
            behind(),
            end(),
            vec![set_at(
                "b",
                k.clone(),
                less(at("b", k.clone()), at("a", a(&k, &j)), at("b", j.clone())),
            )],
        ),
        set_at("b", k.clone(), Expr::binary(Operator::Div, at("b", k.clone()), at("a", a(&k, &k)))),
    ];
    let back = For { down: true, ..For::each("k", first(), end(), up) };
    vec![each("k", first(), end(), down), Statement::For(back)]
}
