//! Mistakes in a URDF file, and in what is asked for of it.

use ptc_codegen::diagnostic::{Diagnostic, Place};
use ptc_codegen::{design, request, robot};

use super::entries;
use super::lagrange::{Joint, tree, urdf};
use crate::support::with_urdf;

/// Replaces a part of the file of the tree, and tries to read it.
fn refused(from: &str, to: &str, keys: &[(&str, &str)]) -> String {
    let text = urdf(&tree());
    assert!(text.contains(from), "{from}");
    let given = [&[("urdf", "test.urdf"), ("what", "inverse-dynamics")], keys].concat();
    let entries = with_urdf(entries(&given), &text.replacen(from, to, 1));
    let request = robot::read(&entries).expect("a request");
    let found = request.robot().expect_err("a mistake");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(!found[0].help.is_empty());
    found[0].message.clone()
}

#[test]
fn mistakes_of_a_file_are_named_with_their_line() {
    let joint = "<joint name=\"joint1\" type=\"revolute\">";
    let parent = "<parent link=\"link0\"/>";
    for (from, to, expected) in [
        (
            joint,
            "<joint name=\"joint1\" type=\"floating\">",
            "test.urdf, line 5: joint `joint1` is floating, which is not supported",
        ),
        (
            joint,
            "<joint name=\"joint1\" type=\"planar\">",
            "test.urdf, line 5: joint `joint1` is planar, which is not supported",
        ),
        (
            joint,
            "<joint name=\"joint1\" type=\"ball\">",
            "test.urdf, line 5: joint `joint1` has the unknown type `ball`",
        ),
        (
            parent,
            "<mimic joint=\"joint2\"/><parent link=\"link0\"/>",
            "test.urdf, line 5: joint `joint1` mimics `joint2`, which is not supported",
        ),
        (
            parent,
            "<parent link=\"link3\"/>",
            "test.urdf, line 5: link `link1` is in a loop of joints",
        ),
        (
            "<link name=\"link0\"/>",
            "<link name=\"link0\"/><link name=\"other\"/>",
            "test.urdf: no joint connects the links link0, other",
        ),
        (
            parent,
            "<parent link=\"nothing\"/>",
            "test.urdf, line 5: joint `joint1` names the unknown link `nothing`",
        ),
        (
            "<child link=\"link2\"/>",
            "<child link=\"link1\"/>",
            "test.urdf, line 7: link `link1` is moved by `joint1` and by `joint2`: a loop",
        ),
        (
            "<axis xyz=\"0 0 1\"/>",
            "<axis xyz=\"0 0 0\"/>",
            "test.urdf, line 5: the axis of joint `joint1` is 0",
        ),
        (
            "<axis xyz=\"0 0 1\"/>",
            "<axis xyz=\"0 0\"/>",
            "test.urdf, line 5: xyz = \"0 0\" of <axis> is not three numbers",
        ),
        (
            "<mass value=\"4\"/>",
            "<mass value=\"heavy\"/>",
            "test.urdf, line 4: value = \"heavy\" of <mass> is not a number",
        ),
        (
            "<mass value=\"4\"/>",
            "<mass value=\"-4\"/>",
            "test.urdf, line 4: the mass of link `link1` is negative",
        ),
        ("<mass value=\"4\"/>", "", "test.urdf, line 4: the inertia of link `link1` has no <mass>"),
        (
            "<link name=\"link2\">",
            "<link name=\"link1\">",
            "test.urdf, line 6: there are two links called `link1`",
        ),
        (
            "<robot name=\"test\">",
            "<model><robot/>",
            "test.urdf: it is not well-formed XML: expected 'model' tag, not 'robot' at 20:1",
        ),
    ] {
        assert_eq!(refused(from, to, &[]), expected);
    }
    let message = refused("link0", "link0", &[("tip", "link9")]);
    assert_eq!(message, "test.urdf: there is no link `link9`, which `tip` names");
    let message = refused("link0", "link0", &[("base", "link5"), ("tip", "link2")]);
    assert_eq!(message, "test.urdf: `link2` is not carried by `link5`");
    let message = refused("link0", "link0", &[("base", "link8")]);
    assert_eq!(message, "test.urdf: no joint moves between `link8` and its end");
}

#[test]
fn loops_of_joints_are_refused() {
    let from = "<joint name=\"joint4\" type=\"continuous\"><parent link=\"link3\"/>";
    let to = "<joint name=\"joint4\" type=\"continuous\"><parent link=\"link5\"/>";
    assert_eq!(refused(from, to, &[]), "test.urdf, line 11: link `link4` is in a loop of joints");
}

#[test]
fn bodies_without_inertia_are_refused_with_their_joint() {
    let text = urdf(&tree()[..1]);
    let start = text.find("<inertial>").expect("an inertia");
    let end = text.find("</inertial>").expect("its end") + "</inertial>".len();
    let text = format!("{}{}", &text[..start], &text[end..]);
    let of = |what: &str| {
        let given = entries(&[("urdf", "test.urdf"), ("what", what)]);
        robot::read(&with_urdf(given, &text)).expect("a request").robot()
    };
    let found = of("mass-matrix").expect_err("no inertia");
    assert_eq!(found[0].message, "test.urdf: what joint `joint1` moves has no inertia");
    assert!(of("jacobian").is_ok(), "the Jacobian needs no inertia");
}

#[test]
fn mistakes_of_a_request_are_reported_at_once() {
    let given = [
        ("urdf", "a.urdf"),
        ("what", "inverse-dynamic"),
        ("gravity", "9.81"),
        ("n", "3"),
        ("guard", "half"),
    ];
    let found = robot::read(&entries(&given)).expect_err("mistakes");
    let messages: Vec<_> = found.iter().map(|own| own.message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "`n` beside `urdf`",
            "what = inverse-dynamic of a robot",
            "gravity = 9.81",
            "guard = `half` is not one of full, result, none",
        ]
    );
    assert_eq!(found[1].help, "did you mean inverse-dynamics?");
    let found = robot::read(&entries(&[("urdf", "a.urdf")])).expect_err("no function");
    assert_eq!(found[0].code, "missing-key");
}

/// A controller of the tree, or of what its keys leave of it.
fn controller(more: &str, urdf: &str) -> Vec<Diagnostic> {
    let head = "mu = \"exp(a=1)\"\npoles = [-3, -4]\nurdf = \"arm.urdf\"\n";
    let (entries, found) = design::read(&format!("{head}{more}"), &mut |_| Place(0));
    assert_eq!(found, []);
    match request::read(&with_urdf(entries.clone(), urdf)) {
        Ok(_) => Vec::new(),
        Err(meaning) => design::mistakes(&found, &entries, meaning),
    }
}

#[test]
fn each_mistake_beside_a_robot_has_one_message() {
    let arm = urdf(&tree());
    assert_eq!(controller("", &arm), []);
    for (more, expected) in [
        ("n = 3", "n = 3, but the relative degree of the output is 2"),
        (
            "states = [\"a\", \"b\"]\ninput = \"u\"\noutput = \"a\"\ndynamics = [\"b\", \"u\"]",
            "`states` beside `urdf`, which gives the plant",
        ),
        ("inertia = [[1]]\nbias = [0]", "`inertia` beside `urdf`, which gives the plant"),
        ("f = \"x1\"", "`f` beside `urdf`, which gives the plant"),
        ("axes = 6", "`axes` beside `urdf`, which gives the plant"),
        ("what = \"associated\"", "such a plant is of a controller"),
        ("what = \"jacobian\"", "what = jacobian is of `emit`"),
        ("tip = \"link9\"", "arm.urdf: there is no link `link9`, which `tip` names"),
        ("gravity = 9.81", "gravity = 9.81"),
        // About one axis the moment of inertia is negative.
        (
            "tip = \"link2\"\npayload = [1, 0, 0, 0, 1, 1, -1, 0, 0, 0]",
            "payload = [1, 0, 0, 0, 1, 1, -1, 0, 0, 0]",
        ),
        (
            "tip = \"link2\"\npayload = [1, 0, 0, 0, 1, 1, 1, 2, 0, 0]",
            "payload = [1, 0, 0, 0, 1, 1, 1, 2, 0, 0]",
        ),
        ("friction = -1", "friction = -1"),
        ("rotor = [1, 2]", "rotor has 2 numbers, and the robot 6 joints"),
        ("reference = [\"0\", \"t\"]", "2 references for 6 outputs"),
        ("limits = [1, 2]", "2 values of `limits` for 6 axes"),
    ] {
        let found = controller(more, &arm);
        assert!(found.len() == 1 && found[0].message == expected, "{more}: {found:?}");
        assert!(!found[0].help.is_empty());
    }
    let found = controller("", &urdf(&tree()[..1]).replace("<mass value=\"4\"/>", ""));
    assert_eq!(found.len(), 1, "{found:?}");
    let long: Vec<_> = (0..9).map(|index| Joint { parent: index, ..tree().remove(0) }).collect();
    let found = controller("", &urdf(&long));
    assert!(found.len() == 1 && found[0].message == "9 joints of a controller", "{found:?}");
}

/// Without files, as in the module of Python, there is no robot.
#[test]
fn a_file_that_has_not_been_read_is_refused() {
    let text = "mu = \"exp(a=1)\"\npoles = [-3, -4]\n[robot]\nurdf = \"arm.urdf\"\n";
    let found = request::read(&crate::support::entries(text)).expect_err("no file");
    assert!(found.len() == 1 && found[0].message == "arm.urdf has not been read", "{found:?}");
}

/// A design without limits has those of the file, if it gives one for every joint.
#[test]
fn efforts_of_all_joints_are_limits() {
    let text =
        "mu = \"exp(a=1)\"\npoles = [-3, -4]\n[params]\ntau = 1\n[robot]\nurdf = \"arm.urdf\"\n";
    let limits = |text: &str, efforts: &[&str]| {
        let mut urdf = urdf(&tree()[..2]);
        for (index, effort) in (1..).zip(efforts) {
            let parent = format!("<parent link=\"link{}\"/>", index - 1);
            urdf = urdf.replace(&parent, &format!("{parent}<limit effort=\"{effort}\"/>"));
        }
        let spec = request::read(&with_urdf(crate::support::entries(text), &urdf));
        let spec = spec.expect("a controller");
        let limits = spec.axes.expect("joints").limits;
        limits.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(limits(text, &["87", "12.5"]), ["87", "12.5"]);
    assert!(limits(text, &["87", "0"]).is_empty());
    assert!(limits(text, &["87"]).is_empty());
    let own = text.replace("[params]", "limits = [5, 6]\n[params]");
    assert_eq!(limits(&own, &["87", "12.5"]), ["5", "6"]);
    let own = text.replace("[params]", "[params]\nu_max = inf");
    assert!(limits(&own, &["87", "12.5"]).is_empty());
}
