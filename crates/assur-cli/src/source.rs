//! The mechanism that NAME denotes on the command line.

use std::fmt::{self, Display, Formatter};
use std::fs::File;
use std::io::{self, Read, Write};

use assur::circuits::NoAssembly;
use assur::mechanism::{Defect, FRAME, LinkId, Mechanism, Quantity};
use assur::mobility::{Cut, Scheme, SchemeSpec};
use assur::motion::Motion;
use assur_file::{Document, LinkageDocument, LinkageProblem, Problem};
use assur_import::Imported;
use serde::Serialize;

use crate::Failure;
use crate::words::Words;

/// Maximum size of a file, in bytes: the largest possible linkage is far smaller.
const LARGEST: u64 = 4 << 20;

/// Maximum number of characters shown after the host in a URL of another program.
const SHOWN: usize = 16;
/// Maximum number of characters shown of the host in such a URL.
const MAX_HOST: usize = 60;

/// NAME on the command line: a catalogue name, a file, or a URL of another program (only its beginning is displayed).
#[derive(Clone, Debug)]
pub(crate) struct Name(String);

impl From<String> for Name {
    fn from(name: String) -> Self {
        Self(name)
    }
}

impl Name {
    fn is_link(&self) -> bool {
        self.0.contains("://")
    }
}

impl Display for Name {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Some((scheme, rest)) = self.0.split_once("://") else {
            return f.write_str(&self.0);
        };
        let host = rest.find(['/', '?', '#']).unwrap_or(rest.len());
        let host = rest[..host].chars().count().min(MAX_HOST);
        let most = scheme.chars().count() + "://".len() + host + SHOWN;
        let mut chars = self.0.chars();
        let beginning: String = chars.by_ref().take(most).collect();
        let plain: String = beginning.chars().filter(|c| !c.is_control()).collect();
        f.write_str(&plain)?;
        match chars.next() {
            Some(_) => f.write_str("…"),
            None => Ok(()),
        }
    }
}

/// The motion of a mechanism, with its document.
pub(crate) struct Moved {
    pub(crate) document: LinkageDocument,
    pub(crate) motion: Motion,
}

/// Returns the motion of the named mechanism, in the assembly given by its document or else in the drawn one.
///
/// # Errors
/// An unknown name or file; every reason why the document is not a mechanism.
pub(crate) fn moved(name: &Name) -> Result<Moved, Failure> {
    moving(name, &any(name)?)
}

fn moving(name: &Name, whole: &Document) -> Result<Moved, Failure> {
    let document = whole
        .linkage()
        .map_err(|problems| refused(name, &problems))?;
    let motion = whole
        .motion()
        .map_err(|problems| match refused(name, &problems) {
            Failure::Input(said) if can_be_assembled(&document) => {
                Failure::Input(format!("{said}\n{name}: {ASSEMBLE}"))
            }
            Failure::Input(said) => match document.spec().made_exact() {
                Some(exact) => Failure::Input(format!(
                    "{said}\n{name}: its redundant constraints nearly hold; `assur structure --make-exact` writes the drawing \
                     for which they do (point {} moves by {:.2e})",
                    exact.point, exact.by
                )),
                None => Failure::Input(said),
            },
            failure => failure,
        })?;
    Ok(Moved { document, motion })
}

/// Reads the document of a linkage, movable or not.
///
/// # Errors
/// An unknown name or file; a document that is not a linkage.
pub(crate) fn linkage(name: &Name) -> Result<LinkageDocument, Failure> {
    let linkage = any(name)?.linkage();
    linkage.map_err(|problems| refused(name, &problems))
}

/// Advice for a linkage that does not close as drawn, but may have assemblies.
const ASSEMBLE: &str = "`assur assemblies` lists the ways in which these links can be joined, `--at` at other inputs, \
     and draws the linkage in one of them by `--assemble N`";

/// Whether the only defects of the linkage are those of its drawing, so that it may have assemblies.
fn can_be_assembled(document: &LinkageDocument) -> bool {
    document.assembly.is_none() && document.assembled(None).is_ok()
}

/// Returns the motion of the named mechanism. A linkage that does not close as drawn is assembled from its dimensions
/// alone, at the requested input.
///
/// # Errors
/// An unknown name or file; every reason why the document is not a mechanism even when assembled.
pub(crate) fn laid_out(
    name: &Name,
    asked: impl FnOnce(bool) -> Result<Option<f64>, Failure>,
) -> Result<Moved, Failure> {
    let refuse = |problems: Vec<Problem>| refused(name, &problems);
    let whole = any(name)?;
    let document = whole.linkage().map_err(refuse)?;
    let motion = match whole.motion() {
        Ok(motion) => motion,
        Err(problems) if document.assembly.is_some() => return Err(refuse(problems)),
        Err(_) => {
            let turns = document.drivers.first();
            let turns = turns.is_none_or(|first| first.slide.is_none());
            let input = asked(turns)?;
            let found = document.assembled(input).map_err(refuse)?;
            let Some(mechanism) = found else {
                return match input {
                    Some(input) => Err(unjoined(name, turns, input)),
                    None => moving(name, &whole),
                };
            };
            Motion::new(mechanism)
        }
    };
    Ok(Moved { document, motion })
}

/// Returns the failure of a linkage that has no assembly at an input.
fn unjoined(name: &Name, turns: bool, input: f64) -> Failure {
    let at = at(turns, input);
    Failure::Input(format!("{name}: there is no assembly at {at}"))
}

impl Moved {
    /// Returns the link by whose angle assemblies are numbered.
    ///
    /// # Errors
    /// A mechanism without links.
    pub(crate) fn output(&self, name: &Name) -> Result<LinkId, Failure> {
        let output = self.document.output(self.motion.mechanism());
        output.ok_or_else(|| Failure::Input(format!("{name}: there are no links")))
    }

    /// Returns the quantities plotted by the document. If there are none, returns the angles of all links and the
    /// coordinates of points that slide on the frame.
    pub(crate) fn outputs(&self) -> Vec<Quantity> {
        let mechanism = self.motion.mechanism();
        if !self.document.plots.is_empty() {
            return self.document.outputs(mechanism);
        }
        let on_frame = self.document.slides.iter();
        let on_frame = on_frame.filter(|slide| slide.on == FRAME);
        let sliding = on_frame.filter_map(|slide| mechanism.point(&slide.point));
        let sliding = sliding.flat_map(|point| [Quantity::X(point), Quantity::Y(point)]);
        let angles = mechanism.link_ids().map(Quantity::Angle);
        angles.chain(sliding).collect()
    }
}

/// Returns the motion in the assembly with this number, counted from 1, at the given input or else at the drawn one.
///
/// # Errors
/// A mechanism without links; no assembly with this number.
pub(crate) fn in_assembly(
    drawn: Moved,
    name: &Name,
    number: usize,
    input: Option<f64>,
) -> Result<Moved, Failure> {
    let output = drawn.output(name)?;
    let Moved { document, motion } = drawn;
    let mechanism = motion.mechanism();
    let input = input.unwrap_or(motion.drawn_input());
    let none = |none: NoAssembly| no_assembly(name, mechanism, number, none, input);
    let index = number.checked_sub(1).unwrap_or(usize::MAX);
    let other = motion.in_assembly(input, output, index);
    let motion = Motion::new(other.map_err(none)?);
    Ok(Moved { document, motion })
}

/// Returns the failure of a linkage that has no assembly with this number at an input.
pub(crate) fn no_assembly(
    name: &Name,
    mechanism: &Mechanism,
    number: usize,
    NoAssembly { of, whole }: NoAssembly,
    input: f64,
) -> Failure {
    let at = at(mechanism.turns(), input);
    let more = if whole { "" } else { ", and there may be more" };
    Failure::Input(match of {
        0 => format!("{name}: there is no assembly at {at}{more}"),
        1 => format!("{name}: there is no assembly {number} at {at}, only 1{more}"),
        _ => format!("{name}: there is no assembly {number} at {at}, only 1 to {of}{more}"),
    })
}

/// Formats an input for messages: degrees of a crank, or the displacement of a slide.
pub(crate) fn at(turns: bool, input: f64) -> String {
    if turns {
        format!("{}°", (input.to_degrees() * 1e6).round() / 1e6 + 0.0)
    } else {
        format!("s = {}", (input * 1e6).round() / 1e6 + 0.0)
    }
}

/// A scheme of links and pairs, with the cuts of pairs that its document gives; a linkage gives none.
pub(crate) struct Schemed {
    pub(crate) scheme: Scheme,
    pub(crate) cuts: Vec<Cut>,
}

/// Reads the named scheme, or the scheme of the named linkage as drawn, movable or not. The reasons why a linkage does
/// not move go to standard error, except a lack of drivers, which does not affect the mobility.
///
/// # Errors
/// An unknown name or file; every reason why the document is not a scheme.
pub(crate) fn schemed(name: &Name) -> Result<Schemed, Failure> {
    let refuse = |problems: Vec<Problem>| refused(name, &problems);
    // The document is read only once, because a pipe cannot be read again.
    let whole = any(name)?;
    if let Document::Scheme(document) = whole {
        let scheme = document.scheme().map_err(refuse)?;
        let cuts = document.cuts(&scheme).map_err(refuse)?;
        return Ok(Schemed { scheme, cuts });
    }
    let document = whole.linkage().map_err(refuse)?;
    let draft = match whole.motion() {
        Ok(motion) => {
            let mechanism = motion.mechanism();
            let pose = motion.pose::<1>(motion.drawn_input()).map_err(|reason| {
                refuse(vec![LinkageProblem::unsolved(&reason, mechanism).into()])
            })?;
            SchemeSpec::of(mechanism, &pose)
        }
        Err(problems) => {
            document.check().map_err(refuse)?;
            let draft = SchemeSpec::of_drawing(&document.spec());
            let draft = draft.map_err(|defects| refuse(Problem::all(defects)))?;
            unmoved(name, &problems)?;
            draft
        }
    };
    let defective = |defects| refuse(Problem::all(defects));
    let scheme = Scheme::new(&draft).map_err(defective)?;
    let cuts = Vec::new();
    Ok(Schemed { scheme, cuts })
}

/// Writes to standard error why a linkage does not move, one reason per line. A lack of drivers is not mentioned.
fn unmoved(name: &Name, problems: &[Problem]) -> Result<(), Failure> {
    let words = Words::english()?;
    for problem in problems {
        let undriven = matches!(
            problem,
            Problem::Linkage(LinkageProblem::Defect(
                Defect::NoDriver | Defect::Underdriven { .. }
            ))
        );
        if !undriven {
            // A failure to write to standard error cannot be reported.
            let _ = writeln!(io::stderr(), "{name}: {}", words.sentence(problem)?);
        }
    }
    Ok(())
}

/// Reads a document of any kind from the catalogue, from a URL of another program, or from a file.
fn any(name: &Name) -> Result<Document, Failure> {
    // Nothing is downloaded: the URL itself contains the whole document.
    if name.is_link() {
        return imported(name, &name.0);
    }
    let found = match assur_file::document(&name.0) {
        Some(found) => found,
        None => {
            let text = text(name)?;
            if assur_import::recognised(&text) {
                return imported(name, &text);
            }
            assur_file::document_of(&text)
        }
    };
    found.map_err(|problems| refused(name, &problems))
}

/// Imports a document of another program. Standard error lists anything that could not be imported unchanged.
fn imported(name: &Name, text: &str) -> Result<Document, Failure> {
    let Imported { document, left_out } =
        assur_import::read(text).map_err(|problem| refused(name, &[problem]))?;
    let words = Words::english()?;
    for told in left_out {
        let _ = writeln!(io::stderr(), "{name}: {}", words.left_out(&told)?);
    }
    Ok(Document::Linkage(document))
}

fn text(name: &Name) -> Result<String, Failure> {
    let unread = |error: io::Error| {
        // A word without slash or dot is taken for a misspelt name of the catalogue.
        if error.kind() == io::ErrorKind::NotFound && !name.0.contains(['/', '\\', '.']) {
            let said = format!("{name}: no such name; `assur list` shows the names there are");
            Failure::Input(said)
        } else {
            Failure::Io(format!("{name}: {error}"))
        }
    };
    // The limit applies while reading, because the size of a device or pipe is not known beforehand.
    let mut bytes = Vec::new();
    let file = File::open(&name.0).map_err(unread)?;
    file.take(LARGEST + 1)
        .read_to_end(&mut bytes)
        .map_err(unread)?;
    if bytes.len() as u64 > LARGEST {
        return Err(Failure::Input(format!(
            "{name}: too large to be a mechanism"
        )));
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(text),
        // The program Linkage writes names in the machine's code page; the rest of its file is ASCII.
        Err(other) if other.as_bytes().starts_with(b"<") => {
            Ok(String::from_utf8_lossy(other.as_bytes()).into_owned())
        }
        Err(_) => Err(Failure::Input(format!("{name}: not a text file"))),
    }
}

/// Returns a failure that lists the problems, one per line.
pub(crate) fn refused(name: &Name, problems: &[impl Serialize]) -> Failure {
    let sentences = Words::english().and_then(|words| {
        let sentences = problems.iter().map(|problem| words.sentence(problem));
        sentences.collect::<Result<Vec<_>, _>>()
    });
    match sentences {
        Ok(sentences) => Failure::Input(format!(
            "{name}: {}",
            sentences.join(&format!("\n{name}: "))
        )),
        Err(unsaid) => unsaid.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::Name;

    #[test]
    fn a_link_is_shown_by_its_beginning() {
        let shown = |name: &str| Name(name.to_owned()).to_string();
        let long = "2P.Ay,1E8.".repeat(1000);
        assert_eq!(
            shown(&format!("https://app.pmksplus.com/?{long}")),
            "https://app.pmksplus.com/?2P.Ay,1E8.2P.A…"
        );
        assert_eq!(
            shown("https://example.org/?a=b"),
            "https://example.org/?a=b"
        );
        assert_eq!(
            shown(&format!("a\n://{}", "é".repeat(900))).chars().count(),
            1 + 3 + 60 + 16 + 1
        );
        let file = format!("{}/crank.json", "folder".repeat(100));
        assert_eq!(shown(&file), file);
    }
}
