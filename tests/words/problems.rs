//! Problems of the engine and of other programs: each has a message.

use super::*;

/// The variants of an enum of a source, as the codes that they are written as.
fn codes_of(source_name: &str) -> Vec<String> {
    let text = source(source_name);
    let (_, inner) = text.split_once("pub enum ").unwrap();
    let (inner, _) = inner.split_once("\n}").unwrap();
    let lines = inner.lines().filter_map(|line| line.strip_prefix("    "));
    let variants = lines.filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase()));
    let names = variants.map(|line| line.split([' ', ',']).next().unwrap());
    names.map(snake).collect()
}

#[test]
fn what_is_told_of_other_programs_has_words() {
    let problems = codes_of("crates/assur-import/src/problem.rs");
    let left_out = codes_of("crates/assur-import/src/left_out.rs");
    assert!(
        problems.len() > 7 && left_out.len() > 20,
        "{problems:?} {left_out:?}"
    );
    let problems = problems.iter().map(|code| format!("problem.{code}"));
    let left_out = left_out.iter().map(|code| format!("import.{code}"));
    let keys: Vec<String> = problems.chain(left_out).collect();
    for (lang, _, words) in tables(PAGE) {
        for key in &keys {
            assert!(words.contains_key(key), "{lang}: {key}");
        }
    }
}

/// Codes and fields as `assur-file` writes them; those of linkages in their own tables.
#[test]
fn every_problem_has_words() {
    let codes = [
        "not_a_number",
        "not_positive",
        "out_of_range",
        "not_whole",
        "unknown_choice",
        "at_rest",
        "too_long",
        "concentric_wheels",
        "mixed_wheels",
        "apart",
        "inside",
        "undetermined",
        "dead_point",
        "bad_state",
        "unknown_format",
        "key_twice",
        "not_json",
        "trapped",
        "unreadable_link",
    ];
    let of_linkages = [
        "too_many",
        "bad_name",
        "bad_text",
        "length_of_two",
        "bad_length",
        "fixed_as_drawn",
        "bad_driver",
        "nothing_to_plot",
        "nothing_to_trace",
        "twice",
        "unknown_name",
        "not_finite",
        "bare",
        "coincident",
        "repeated",
        "shape",
        "not_on_link",
        "with_itself",
        "not_hinged",
        "teeth",
        "concentric",
        "train_undetermined",
        "mesh_contradicts",
        "no_driver",
        "loose",
        "underdriven",
        "locked",
        "instant",
        "rate",
        "parallel_guides",
        "unsupported",
        "open",
        "open_in_line",
        "open_perpendicular",
        "open_singular",
        "coincident_hinges",
        "range_reversed",
        "range_empty",
        "drawn_beyond_range",
        "misdrawn",
        "beyond_range",
        "unreached",
        "unfollowed",
        "links_apart",
        "out_of_reach",
        "guides_parallel",
        "links_undetermined",
        "links_dead_point",
        "constraint_broken",
        "links_perpendicular",
        "links_singular",
        "bad_wish",
        "no_output",
        "nothing_moves",
        "no_dimension",
        "bad_range",
        "blocked",
    ];
    let fields = [
        "l1",
        "l2",
        "l3",
        "l4",
        "z4",
        "wheels",
        "wheels.z",
        "wheels.centre_line_deg",
        "mesh",
        "module",
        "tracers",
        "tracers.link",
        "tracers.x",
        "tracers.y",
        "assembly",
        "phi_deg",
        "direction",
        "speed",
        "omega",
        "epsilon",
        "plot",
    ];
    for (lang, _, words) in tables(PAGE) {
        for code in codes {
            assert!(
                words.contains_key(&format!("problem.{code}")),
                "{lang}: {code}"
            );
        }
        for field in fields {
            assert!(
                words.contains_key(&format!("field.{field}")),
                "{lang}: {field}"
            );
        }
    }
    for (lang, _, words) in tables(PAGE) {
        for code in of_linkages {
            let key = format!("problem.{code}");
            assert!(words.contains_key(&key), "{lang}: {code}");
        }
    }
}
