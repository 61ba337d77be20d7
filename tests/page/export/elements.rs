//! Elements of a saved picture.

use roxmltree::{Document, Node};

use crate::browser::plain;

/// The elements of a picture. Only these kinds are in one, and nothing that runs
/// or loads.
pub(super) fn elements<'a>(svg: &'a Document<'_>) -> Vec<Node<'a, 'a>> {
    let found: Vec<_> = svg.descendants().filter(Node::is_element).collect();
    for element in &found {
        assert_eq!(
            element.tag_name().namespace(),
            Some("http://www.w3.org/2000/svg")
        );
        let kind = element.tag_name().name();
        assert!(
            ["svg", "title", "rect", "path", "text"].contains(&kind),
            "{kind}"
        );
        for attribute in element.attributes() {
            let name = attribute.name();
            assert!(
                !name.starts_with("on") && name != "href" && name != "style",
                "{name}"
            );
        }
    }
    found
}

/// What can be read in a picture, halos of texts aside.
pub(super) fn texts(elements: &[Node<'_, '_>]) -> Vec<String> {
    let texts = elements.iter().filter(|e| e.has_tag_name("text"));
    let read = texts.filter(|e| e.attribute("aria-hidden").is_none());
    read.map(|e| plain(e.text().unwrap())).collect()
}

/// How many paths are filled or stroked with a colour.
pub(super) fn painted(elements: &[Node<'_, '_>], attribute: &str, colour: &str) -> usize {
    let paths = elements.iter().filter(|e| e.has_tag_name("path"));
    paths
        .filter(|e| e.attribute(attribute) == Some(colour))
        .count()
}

/// Width and height of a picture, as its file states them.
pub(super) fn size(elements: &[Node<'_, '_>]) -> (f64, f64) {
    let side = |name| elements[0].attribute(name).unwrap().parse().unwrap();
    (side("width"), side("height"))
}

pub(super) fn check_head(elements: &[Node<'_, '_>], width: f64, height: f64) {
    let [root, title, ground, ..] = elements else {
        panic!("an empty picture")
    };
    assert_eq!(
        root.attribute("viewBox").unwrap(),
        format!("0 0 {width} {height}")
    );
    assert_eq!(root.attribute("width").unwrap(), format!("{width}"));
    assert_eq!(root.attribute("height").unwrap(), format!("{height}"));
    assert!(title.has_tag_name("title"));
    assert!(ground.has_tag_name("rect"));
    assert_eq!(ground.attribute("fill"), Some("#ffffff"));
    assert_eq!(ground.attribute("width").unwrap(), format!("{width}"));
}
