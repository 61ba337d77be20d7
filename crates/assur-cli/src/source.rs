//! The mechanism that a name stands for.

use std::fs::File;
use std::io::{self, Read, Write};

use assur::circuits::NoAssembly;
use assur::mechanism::LinkId;
use assur::mobility::{Cut, Scheme, SchemeDraft};
use assur::motion::Motion;
use assur_file::{Document, LinkageDocument, LinkageProblem, Problem, SchemeProblem};
use assur_import::Imported;
use serde::Serialize;

use crate::Failure;
use crate::words::Words;

/// No larger file is read: the largest linkage that is taken is far smaller.
const LARGEST: u64 = 4 << 20;

/// A mechanism in motion, with the document it is from.
pub(crate) struct Moved {
    pub(crate) document: LinkageDocument,
    pub(crate) motion: Motion,
}

/// The motion of a name in the assembly that its document says, or else the drawn one.
///
/// # Errors
/// No such name or file; every reason why it is no mechanism.
pub(crate) fn moved(name: &str) -> Result<Moved, Failure> {
    moving(name, &any(name)?)
}

fn moving(name: &str, whole: &Document) -> Result<Moved, Failure> {
    let refuse = |problems: Vec<Problem>| refused(name, &problems);
    Ok(Moved {
        document: whole.linkage().map_err(refuse)?,
        motion: whole.motion().map_err(refuse)?,
    })
}

impl Moved {
    /// The link by whose angle assemblies are numbered.
    ///
    /// # Errors
    /// A mechanism without links.
    pub(crate) fn output(&self, name: &str) -> Result<LinkId, Failure> {
        let output = self.document.output(self.motion.mechanism());
        output.ok_or_else(|| Failure::Input(format!("{name}: there are no links")))
    }
}

/// The same in the assembly of a number, from 1, at an input; none: at the drawn one.
///
/// # Errors
/// There is no such assembly.
pub(crate) fn in_assembly(
    drawn: Moved,
    name: &str,
    number: usize,
    input: Option<f64>,
) -> Result<Moved, Failure> {
    let output = drawn.output(name)?;
    let Moved { document, motion } = drawn;
    let mechanism = motion.mechanism();
    let input = input.unwrap_or(motion.home());
    let none = |NoAssembly { of, whole }| {
        let at = at(mechanism.turns(), input);
        let more = if whole { "" } else { ", and there may be more" };
        Failure::Input(match of {
            0 => format!("{name}: there is no assembly at {at}{more}"),
            1 => format!("{name}: there is no assembly {number} at {at}, only 1{more}"),
            _ => format!("{name}: there is no assembly {number} at {at}, only 1 to {of}{more}"),
        })
    };
    let index = number.checked_sub(1).unwrap_or(usize::MAX);
    let other = motion.in_assembly(input, output, index);
    let motion = Motion::new(other.map_err(none)?);
    Ok(Moved { document, motion })
}

/// An input as people read it: degrees of a crank, else the way of a slide.
pub(crate) fn at(turns: bool, input: f64) -> String {
    if turns {
        format!("{}°", (input.to_degrees() * 1e6).round() / 1e6 + 0.0)
    } else {
        format!("s = {}", (input * 1e6).round() / 1e6 + 0.0)
    }
}

/// A scheme with the cuts that its document has.
pub(crate) struct Schemed {
    pub(crate) scheme: Scheme,
    pub(crate) cuts: Vec<Cut>,
}

/// The scheme of a name; a linkage as it is drawn.
///
/// # Errors
/// No such name or file; every reason why it is no scheme.
pub(crate) fn schemed(name: &str) -> Result<Schemed, Failure> {
    let refuse = |problems: Vec<Problem>| refused(name, &problems);
    // Read once: a pipe has nothing more to give.
    let whole = any(name)?;
    if let Document::Scheme(document) = whole {
        let scheme = document.scheme().map_err(refuse)?;
        let cuts = document.cuts(&scheme).map_err(refuse)?;
        return Ok(Schemed { scheme, cuts });
    }
    let motion = moving(name, &whole)?.motion;
    let mechanism = motion.mechanism();
    let pose = motion
        .pose::<1>(motion.home())
        .map_err(|reason| refuse(vec![LinkageProblem::unsolved(&reason, mechanism).into()]))?;
    let defective = |defects| refuse(SchemeProblem::all(defects));
    let scheme = Scheme::new(&SchemeDraft::of(mechanism, &pose)).map_err(defective)?;
    let cuts = Vec::new();
    Ok(Schemed { scheme, cuts })
}

/// What a name stands for, of any kind: a name of the catalogue, a link of another program, a file.
fn any(name: &str) -> Result<Document, Failure> {
    // Nothing is fetched: what is in the address of the link itself is all there is to read.
    if name.contains("://") {
        let (place, _) = name.split_once('?').unwrap_or((name, ""));
        return imported(place, name);
    }
    let found = match assur_file::document(name) {
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

/// What another program made. What could not be taken over is said beside the output.
fn imported(name: &str, text: &str) -> Result<Document, Failure> {
    let Imported { document, left_out } =
        assur_import::read(text).map_err(|problem| refused(name, &[problem]))?;
    let words = Words::english()?;
    for told in left_out {
        let _ = writeln!(io::stderr(), "{name}: {}", words.left_out(&told)?);
    }
    Ok(Document::Linkage(document))
}

fn text(name: &str) -> Result<String, Failure> {
    let unread = |error: io::Error| {
        // A bare word was meant as a name of the catalogue.
        if error.kind() == io::ErrorKind::NotFound && !name.contains(['/', '\\', '.']) {
            let said = format!("{name}: no such name; `assur list` shows the names there are");
            Failure::Input(said)
        } else {
            Failure::Io(format!("{name}: {error}"))
        }
    };
    // Not by its size: devices and pipes have none.
    let mut bytes = Vec::new();
    let file = File::open(name).map_err(unread)?;
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
        // Linkage writes names in the code page of its machine; all else of a file is in ASCII.
        Err(other) if other.as_bytes().starts_with(b"<") => {
            Ok(String::from_utf8_lossy(other.as_bytes()).into_owned())
        }
        Err(_) => Err(Failure::Input(format!("{name}: this is no text"))),
    }
}

/// One line for each problem.
pub(crate) fn refused(name: &str, problems: &[impl Serialize]) -> Failure {
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
