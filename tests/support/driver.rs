// Runs one controller on the records of standard input; see `Record` and `Outcome` in program.rs.
// A program includes this text, its controllers as modules, and a `main` that picks one.

/// The bytes of the values of one type, from standard input: no more than are there.
fn values<const SIZE: usize>(bytes: &[u8]) -> Vec<[u8; SIZE]> {
    bytes.chunks_exact(SIZE).map(|chunk| chunk.try_into().expect("SIZE bytes")).collect()
}

macro_rules! drive {
    ($module:ident, $type:ident, $real:ident, $n:literal, $params:literal, |$next:ident| $make:expr) => {{
        use std::io::{Read, Write};
        type Outcome = Result<$module::Control<$real>, $module::Error>;
        // The numbers that C gives the same outcomes.
        let code = |outcome: Outcome| -> (i32, $real) {
            match outcome {
                Ok(control) => match control.status {
                    $module::Status::Ok => (0, control.u),
                    $module::Status::Hold => (1, control.u),
                    $module::Status::Saturated => (2, control.u),
                    $module::Status::After => (3, control.u),
                },
                Err($module::Error::Param) => (-1, 0.0),
                Err($module::Error::Input) => (-2, 0.0),
                Err($module::Error::Range) => (-3, 0.0),
            }
        };
        let mut bytes = Vec::new();
        std::io::stdin().read_to_end(&mut bytes).expect("records");
        let numbers: Vec<$real> =
            values(&bytes).into_iter().map($real::from_le_bytes).collect();
        let mut out = Vec::new();
        for record in numbers.chunks_exact($params + 1 + $n) {
            let mut rest = record.iter().copied();
            #[allow(unused)]
            let mut $next = || rest.next().expect("a whole record");
            let built = $module::$type::new($make);
            let t = record[$params];
            let x: [$real; $n] = record[$params + 1..].try_into().expect("n states");
            let (init, step, axis) = match built {
                Err(error) => (code(Err(error)).0, (0, 12345.0), (0, 12345.0)),
                Ok(built) => {
                    (0, code(built.step(t, &x)), code(built.tick(t).and_then(|gains| gains.axis(&x))))
                }
            };
            for status in [init, step.0, axis.0] {
                out.extend(status.to_le_bytes());
            }
            for u in [step.1, axis.1] {
                out.extend(u.to_le_bytes());
            }
        }
        std::io::stdout().write_all(&out).expect("outcomes");
    }};
}
