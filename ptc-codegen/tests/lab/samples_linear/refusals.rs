//! Refused designs: plants without digits to spare, and mistakes in the keys.

use ptc_codegen::request;

use super::support::entries;
use super::{ABOVE, read};

#[test]
fn what_is_hardly_controllable_or_observable_is_refused() {
    let with = |above: &str, plant: &str| {
        read(&format!("tau = \"100*{above}\"\nsample_time = {above}\n{plant}"))
            .map(|_| ())
            .map_err(|found| format!("{}: {}", found[0].key, found[0].message))
    };
    let twin = |gap: &str| format!("[plant]\nA = [[-1,0],[0,-1{gap}]]\nB = [1,1]\n");
    assert_eq!(with("0.01", &twin(".1")), Ok(()));
    assert_eq!(with("0.01", &twin(".001")), Ok(()));
    let refused = with("0.01", &twin(".0000001")).expect_err("nearly equal modes");
    assert!(refused.contains("B: the sampled plant is not controllable"), "{refused}");
    assert!(refused.contains("condition number 4e9"), "{refused}");
    assert!(refused.contains("the mode s = -1 1/s"), "{refused}");
    // A mode that the input does not reach, in other coordinates.
    let hidden = "[plant]\nA = [[-2,1],[0,-3]]\nB = [1,0]\n";
    let refused = with("0.01", hidden).expect_err("a mode without input");
    assert!(refused.contains("infinite condition number"), "{refused}");
    assert!(refused.contains("s = -3 1/s"), "{refused}");
    // Half a period of an oscillation in a sample.
    let swing = "[plant]\nA = [[0,314.159265358979],[-314.159265358979,0]]\nB = [0,1]\n";
    let refused = with("0.01", swing).expect_err("aliased");
    assert!(refused.contains("s = 0 +- 314.2i 1/s"), "{refused}");
    assert_eq!(with("0.009", swing), Ok(()));
    // Speed and current do not show the angle.
    let motor = "[plant]\nA = [[0,1,0],[0,-0.5,1500],[0,-15,-600]]\nB = [0,0,500]\n";
    let poles = "observer_poles = [-4,-5,-6]\n";
    let refused = with("0.001", &format!("measured = [\"x2\",\"x3\"]\n{poles}{motor}"));
    let refused = refused.expect_err("no angle");
    assert!(refused.contains("measured: the sampled plant is not observable"), "{refused}");
    assert!(refused.contains("the mode s = 0 1/s"), "{refused}");
    assert_eq!(with("0.001", &format!("measured = [\"x3\",\"x1\"]\n{poles}{motor}")), Ok(()));
    // A washout passes no constant on.
    let washout =
        "disturbance = \"constant\"\nobserver_poles = [-4,-5]\n[plant]\nA = [[-1]]\nB = [0]\n";
    let refused = with("0.001", washout).expect_err("no input at all");
    assert!(refused.contains("not controllable"), "{refused}");
    let speed = "disturbance = \"constant\"\nmeasured = [\"x2\"]\nobserver_poles = [-4,-5,-6]\n\
                 [plant]\nA = [[0,1],[-1,-1]]\nB = [0,1]\n";
    let refused = with("0.01", speed).expect_err("a zero at 0");
    assert!(refused.contains("not observable"), "{refused}");
    assert!(refused.contains("the mode s = 0 1/s"), "{refused}");
    let fast = with("1", "[plant]\nA = [[-5000]]\nB = [1]\n").expect_err("a fast mode");
    assert!(fast.contains("more than e^1000"), "{fast}");
    // Single precision takes fewer digits.
    let single = format!("precision = \"f32\"\n{}", twin(".001"));
    assert!(with("0.01", &single).is_err());
}

#[test]
fn mistakes_are_named() {
    let above = "sample_time = 0.01\ntau = 1\n";
    let plant = "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1]\n";
    let cases = [
        ("", "[plant]\nB = [0,1]\n", "`B` without `A`"),
        ("", "[plant]\nA = [[0,1],[-1,0]]\n", "`B` is missing"),
        ("n = 3\n", plant, "A has 2 rows for order n = 3"),
        ("", "[plant]\nA = [[0,1],[-1]]\nB = [0,1]\n", "a row of A has 1 number"),
        ("", "[plant]\nA = [[0,1],[-1,inf]]\nB = [0,1]\n", "A holds `inf`"),
        ("", "[plant]\nA = [[0,1],[-1,0]]\nB = [0,\"x1\"]\n", "B holds `x1`"),
        ("", "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1,2]\n", "a row of B has 3 numbers"),
        ("", "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1]\nC = [[1,0],[0,1],[1,1]]\n", "C has 3 rows"),
        (
            "",
            "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1]\nC = [[1,2],[2,4]]\n",
            "a row of C is a combination",
        ),
        (
            "measured = [\"x1\"]\n",
            "[plant]\nA = [[0,1],[-1,0]]\nB = [0,1]\nC = [1,0]\n",
            "`measured` beside `C`",
        ),
        ("measured = [\"x3\"]\n", plant, "unknown state `x3`"),
        ("measured = [\"x1\",\"x1\"]\n", plant, "not a choice of states"),
        ("measured = [\"x1\"]\n", plant, "`observer_poles` is missing"),
        ("g = 2\n", plant, "`g` beside `A`"),
        ("f = 2\n", plant, "`f` beside `A`"),
        ("delay = 1\npoles = [-3]\n", plant, "1 pole for n + delay = 3"),
        ("observer_poles = [-3,-4]\n", plant, "`observer_poles` without an observer"),
        (
            "measured = [\"x1\"]\nobserver_poles = [-3,-4]\nafter_observer = [-3]\n",
            plant,
            "1 pole for 2",
        ),
        (
            "measured = [\"x1\"]\nobserver_poles = [-3,-4]\nafter_observer = [-3,1]\n",
            plant,
            "a real part of 1",
        ),
        ("after_observer = [-3,-4]\n", plant, "`after_observer` without an observer"),
    ];
    for (top, table, wanted) in cases {
        let found = read(&format!("{top}{above}{table}")).expect_err(wanted);
        let shown: Vec<_> = found.iter().map(|d| format!("{}; {}", d.message, d.help)).collect();
        assert!(shown.iter().any(|text| text.contains(wanted)), "{wanted}: {shown:?}");
    }
    let open = read(plant).expect_err("no period");
    assert!(open.iter().any(|d| d.message == "`sample_time` is missing"), "{open:?}");
    let timed = request::read(&entries(&format!("mu = \"exp(a=1)\"\n{plant}"))).expect_err("time");
    assert!(timed.iter().any(|d| d.message == "`A` needs a clock in samples"), "{timed:?}");
    let nine = format!("[{}]", ["0"; 9].join(","));
    let nine = format!("{above}[plant]\nA = [{}]\nB = {nine}\n", vec![nine.clone(); 9].join(","));
    let found = read(&nine).expect_err("order 9");
    assert!(found[0].message.contains("A has 9 rows"), "{found:?}");
    // The plant of a simulation is that of the controller.
    let both = entries(&format!("{ABOVE}{above}{plant}f = \"-x2\"\n"));
    let spec = request::read(&both).expect("a controller");
    let found = ptc_codegen::plant::read(&both, &spec).expect_err("two plants");
    assert!(found[0].message.contains("`f` beside `A`"), "{found:?}");
}
