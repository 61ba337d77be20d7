//! The mechanism that a name stands for.

use std::io;

use assur::motion::Motion;
use assur_file::{LinkageDocument, Problem};

use crate::Failure;
use crate::words::Words;

/// No larger file is read: the largest linkage that is taken is far smaller.
const LARGEST: u64 = 4 << 20;

/// A mechanism in motion, with the document it is from.
pub(crate) struct Moved {
    pub(crate) document: LinkageDocument,
    pub(crate) motion: Motion,
}

/// The motion of a name in an assembly, counted from 1; none: the one that the
/// document says, or else the drawn one.
///
/// # Errors
/// No such name or file; every reason why it is no mechanism; no such assembly.
pub(crate) fn moved(name: &str, assembly: Option<usize>) -> Result<Moved, Failure> {
    let mut document = document(name)?;
    let refuse = |problems: Vec<Problem>| refused(name, &problems);
    if let Some(number) = assembly {
        // Counted from the drawing, whichever the document names.
        document.assembly = None;
        let count = document.mechanism().map_err(refuse)?.assemblies();
        if !(1..=count).contains(&number) {
            let said = format!("{name}: there is no assembly {number}, only 1 to {count}");
            return Err(Failure::Input(said));
        }
        document.assembly = Some(number);
    }
    let motion = document.motion().map_err(refuse)?;
    Ok(Moved { document, motion })
}

fn document(name: &str) -> Result<LinkageDocument, Failure> {
    let found = match assur_file::from_catalogue(name) {
        Some(found) => found,
        None => assur_file::from_text(&text(name)?),
    };
    found.map_err(|problems| refused(name, &problems))
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
    let size = std::fs::metadata(name).map_err(unread)?.len();
    if size > LARGEST {
        return Err(Failure::Input(format!("{name}: too large to be a linkage")));
    }
    let bytes = std::fs::read(name).map_err(unread)?;
    String::from_utf8(bytes).map_err(|_| Failure::Input(format!("{name}: this is no text")))
}

/// One line for each problem.
pub(crate) fn refused(name: &str, problems: &[Problem]) -> Failure {
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
