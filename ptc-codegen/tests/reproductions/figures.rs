//! The figures are those that the commands in the heads of the designs draw.

use std::fs;
use std::path::Path;

use crate::{command, home, simulate};

#[test]
fn the_figures_are_those_that_are_drawn() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("reproductions");
    for name in [
        "arbitrary_time",
        "disturbance",
        "double_integrator",
        "example4",
        "least_settling_bound",
        "linear_decay",
        "parametric_lyapunov",
        "power_scaling",
        "time_base_generator",
    ] {
        let (mut words, picture) = command(name);
        assert_eq!(picture, Some(format!("{name}.svg")));
        let figure = home().join(format!("{name}.svg"));
        let update = std::env::var_os("UPDATE_GOLDEN").is_some();
        let path = if update { figure.clone() } else { folder.join(format!("{name}.svg")) };
        words.extend(["--plot".to_owned(), path.to_str().expect("UTF-8").to_owned()]);
        simulate(&words.iter().map(String::as_str).collect::<Vec<_>>());
        let [drawn, there] = [&path, &figure].map(|path| fs::read(path).unwrap_or_default());
        assert!(
            drawn == there,
            "{} is not what is drawn; UPDATE_GOLDEN=1 writes it",
            figure.display()
        );
    }
}
