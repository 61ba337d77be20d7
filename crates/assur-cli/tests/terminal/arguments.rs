//! Help, and invalid arguments.

use super::run::{refused, said};

#[test]
fn help_and_list() {
    for arguments in [
        &["--help"][..],
        &["sweep", "--help"],
        &["structure", "--help"],
        &["plot", "--help"],
        &["assemblies", "--help"],
        &["circuits", "--help"],
        &["list", "--help"],
    ] {
        assert!(said(arguments).contains("Usage: assur"), "{arguments:?}");
    }
    let names = said(&["list"]);
    assert!(names.starts_with("mixer-a\nmixer-b\nmixer-c\n"), "{names}");
}

#[test]
fn arguments_that_are_none() {
    for (arguments, status, part) in [
        (
            &["sweep", "no-such-mixer"][..],
            2,
            "no-such-mixer: no such name",
        ),
        (
            &["sweep", "./no-such-file.json"],
            1,
            "./no-such-file.json: ",
        ),
        (&["sweep", "mixer-a", "--step", "0"], 2, "--step 0"),
        (&["sweep", "mixer-a", "--step", "NaN"], 2, "--step NaN"),
        (&["sweep", "mixer-a", "--step", "1e-9"], 2, "--step"),
        (&["sweep", "mixer-a", "--assembly", "3"], 2, "only 1 to 2"),
        (&["sweep", "mixer-a", "--assembly", "0"], 2, "only 1 to 2"),
        (
            &["plot", "class4-dwell", "--assembly", "7", "--svg", "-"],
            2,
            "no assembly 7 at 0°, only 1 to 6",
        ),
        (
            &["sweep", "chebyshev", "--assembly", "1", "--from", "0"],
            2,
            "there is no assembly at 0°",
        ),
        (&["assemblies"], 2, "Usage"),
        (&["assemblies", "no-such-mixer"], 2, "no such name"),
        (&["assemblies", "mixer-a", "--at", "NaN"], 2, "--at NaN"),
        (&["assemblies", "mixer-a", "--at", "1e300"], 2, "--at"),
        (&["assemblies", "mobility-1a"], 2, "does not move"),
        (&["circuits", "mobility-1a"], 2, "does not move"),
        (
            &["circuits", "./no-such-file.json"],
            1,
            "./no-such-file.json: ",
        ),
        (&["sweep"], 2, "Usage"),
        (&["fly"], 2, "fly"),
        (&["plot", "mixer-a"], 2, "--svg"),
    ] {
        let (found, said) = refused(arguments);
        assert_eq!(found, status, "{arguments:?}: {said}");
        assert!(said.contains(part), "{arguments:?}: {said}");
    }
}
