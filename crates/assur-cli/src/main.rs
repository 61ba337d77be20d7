//! Assur in the terminal: the mechanisms of the catalogue and of files as tables,
//! as Assur groups, by their mobility and as drawings; four-bars from positions,
//! differentials from numbers of teeth.
//!
//! A file for each command; `source.rs` finds what a NAME stands for, `words.rs` makes sentences of problems.

mod assemblies;
mod circuits;
mod csv;
mod differential;
mod exact;
mod mobility;
mod plot;
mod source;
mod structure;
mod sweep;
mod synth;
mod words;

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use assur_file::LinkageProblem;
use clap::{Parser, Subcommand};
use source::Name;

/// Planar mechanisms: tables of their motion, their Assur groups, drawings.
///
/// NAME is a name of the catalogue (see `assur list`) or a file: a state saved by
/// the page, or a linkage alone; docs/file-format.md describes both. It may also be
/// a Linkage file (`.linkage2`) or, in quotes, a PMKS+ or PMKS link: anything that could
/// not be imported unchanged is reported on standard error.
///
/// Exit status: 0 done, 1 a file could not be read or written, 2 bad input.
#[derive(Parser)]
#[command(name = "assur", version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Lists the names of the catalogue.
    List,
    /// Writes the motion as a table (CSV).
    ///
    /// One row for each input, ascending, over the motion's own range (see `assur structure`). A crank that turns
    /// fully has rows from 0° to 360°, or to as many turns as the motion takes to repeat, the last one where the
    /// steps meet it. A driver that turns back has rows at the multiples of the step between its dead points, and at
    /// the dead points themselves; a driven slide over its whole range. A requested angle outside the range is brought
    /// into it by whole turns.
    ///
    /// The first column is the input: `phi_deg`, degrees of a crank, or `s`, the length of a driven slide. Then for
    /// each link LINK.angle (radians, never folded), LINK.dangle, LINK.ddangle; for each point P.x, P.y, P.dx, P.dy,
    /// P.ddx, P.ddy, in the unit of the file's lengths. Derivatives are with respect to the input, a crank's in radians.
    /// With --omega they are with respect to time, in seconds: LINK.omega, LINK.epsilon, P.vx, P.vy, P.ax, P.ay. With
    /// --degrees angles are in degrees, and derivatives with respect to degrees of a crank. The last column, `reason`,
    /// says why there is no pose or no derivative.
    Sweep(sweep::Asked),
    /// Shows mobility, class, formula, passive wheels, the Assur groups in their order, and the range of the motion
    /// with its dead points and change points.
    ///
    /// Then for each output its swing or stroke, its travel there and back and, where it goes there and back once a turn,
    /// its time ratio (outputs are those plotted by the file, or else all angles and the points that slide on the frame); the Grashof class of each four-bar;
    /// the minimum transmission angle of each dyad RRR, the maximum pressure angle of each dyad RRP.
    ///
    /// A drawing whose redundant constraints hold only nearly is locked; with --make-exact it is written to standard output
    /// with its points moved as little as possible so that it moves; standard error gives the greatest move.
    Structure {
        /// Catalogue name or file.
        name: Name,
        /// Prints JSON.
        #[arg(long)]
        json: bool,
        /// Writes the drawing made exact, as a file, instead of the structure
        #[arg(long, conflicts_with = "json")]
        make_exact: bool,
    },
    /// Writes all assemblies at an input as a table (CSV): every way in which the links can be joined.
    ///
    /// One row for each, numbered from 1 by the angle of the output from 0 to 2π: the link whose angle the file plots
    /// first, or else the link placed last. Dyads are joined in closed form; the equations of groups of Class III
    /// and higher are solved over the complex numbers, so that none is missed. Then for each link LINK.angle, radians
    /// from 0 to 2π. Wheels in mesh stay as they are mounted.
    ///
    /// A linkage that does not close as drawn, such as one with only known lengths, also has assemblies; with
    /// --assemble N it is written to standard output, drawn in the assembly with that number.
    Assemblies(assemblies::Asked),
    /// Shows every motion of the linkage, and which of them can be reached from each other.
    ///
    /// A branch is a piece of motion between two dead points, or a whole cycle. In a fold, a dead point, two branches
    /// meet; at a crossing, a change point, they pass through one pose. Branches that meet belong to one circuit: the links
    /// need not be taken apart to get from one to the other. Branches and circuits are numbered by their least input, and
    /// there as `assur assemblies` numbers assemblies.
    Circuits {
        /// Catalogue name or file.
        name: Name,
        /// Prints JSON.
        #[arg(long)]
        json: bool,
    },
    /// Counts mobility and redundant constraints, and judges them by the rank of the constraints.
    ///
    /// NAME is a scheme of links and pairs, or any linkage, even a drawing that is locked, lacks drivers or does not
    /// close: it is taken as drawn. Pairs are cut until every contour is open: W is the sum of
    /// the freedoms of the remaining pairs, less the constraints of the cut ones. q counts the constraints that are
    /// redundant in space. If places and axes are known the rank gives the true number of motions, which
    /// pairs carry redundant constraints, which links move by themselves, and which pairs to replace.
    Mobility {
        /// Catalogue name or file.
        name: Name,
        /// Pairs to cut; for a hinge of more than two links with one of these, as in Q:3 [default:
        /// those of the file, or else automatic ones]
        #[arg(long, value_name = "PAIR,PAIR", value_delimiter = ',')]
        cut: Option<Vec<String>>,
        /// Prints JSON.
        #[arg(long)]
        json: bool,
    },
    /// Shows speeds, transmission ratios and conditions of an epicyclic train with two degrees of freedom.
    ///
    /// Sun 1, satellite 2, carrier 3, ring 4, with gears in contact or magnets with gaps. Two of the speeds w1, w3,
    /// w4 and ties determine all; i/j(k) is the ratio of wi to wj with k held.
    Differential(differential::Asked),
    /// Draws the mechanism as it is drawn in its file, with its traces, and its plots below.
    Plot {
        /// Catalogue name or file.
        name: Name,
        /// The file to write, `-` for standard output.
        #[arg(long, value_name = "OUT")]
        svg: PathBuf,
        /// The assembly with this number at the drawn input (see `assur assemblies`) [default: the
        /// drawn one]
        #[arg(long, value_name = "N")]
        assembly: Option<usize>,
    },
    /// Finds the four-bars for given positions, with a verdict on each.
    ///
    /// l0 is the frame, l1 the coupler, l2 the output link, l3 the driver. Two positions leave a family, three one
    /// linkage, more the best compromise with l1, l2, l3 from a tenth of l0 to ten times l0. With --function the positions
    /// lie on a function y = f(x), and the greatest error of y is given with its x.
    Synth(synth::Asked),
}

/// A failure, with its message.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Reading or writing: exit status 1.
    Io(String),
    /// The input is bad: exit status 2.
    Input(String),
    /// Nobody reads on, as after `| head`: done, exit status 0.
    Unread,
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::Unread,
            _ => Self::Io(error.to_string()),
        }
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Self::Io(format!("a problem cannot be put into words: {error}"))
    }
}

fn main() -> ExitCode {
    // clap answers --help with 0 and arguments it does not know with 2 by itself.
    let arguments = Arguments::parse();
    let (said, status) = match run(arguments.command) {
        Ok(()) | Err(Failure::Unread) => return ExitCode::SUCCESS,
        Err(Failure::Io(said)) => (said, 1),
        Err(Failure::Input(said)) => (said, 2),
    };
    // Without standard error nobody can be informed.
    let _ = writeln!(io::stderr(), "assur: {said}");
    ExitCode::from(status)
}

fn run(command: Command) -> Result<(), Failure> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    match command {
        Command::List => {
            for name in assur_file::catalogue().chain(assur_file::schemes()) {
                writeln!(out, "{name}")?;
            }
        }
        Command::Sweep(asked) => sweep::write(&mut out, &asked)?,
        Command::Structure {
            name,
            make_exact: true,
            ..
        } => exact::write(&mut out, &name)?,
        Command::Structure { name, json, .. } => {
            structure::write(&mut out, &source::moved(&name)?, &name, json)?;
        }
        Command::Assemblies(asked) => assemblies::write(&mut out, &asked)?,
        Command::Circuits { name, json } => {
            circuits::write(&mut out, &source::moved(&name)?, &name, json)?;
        }
        Command::Mobility { name, cut, json } => {
            mobility::write(&mut out, &name, cut.as_deref(), json)?;
        }
        Command::Differential(asked) => differential::write(&mut out, &asked)?,
        Command::Synth(asked) => synth::write(&mut out, &asked)?,
        Command::Plot {
            name,
            svg,
            assembly,
        } => {
            let drawn = source::moved(&name)?;
            let moved = match assembly {
                Some(number) => source::in_assembly(drawn, &name, number, None)?,
                None => drawn,
            };
            let text = plot::svg(&moved, &name)?;
            if let Err(turns) = moved.motion.searchable() {
                let said = words::Words::english()?.sentence(&LinkageProblem::from(turns))?;
                // Without standard error nobody can be informed.
                let _ = writeln!(io::stderr(), "{name}: zeros and extrema: {said}");
            }
            if svg.as_os_str() == "-" {
                out.write_all(text.as_bytes())?;
            } else {
                std::fs::write(&svg, text)
                    .map_err(|error| Failure::Io(format!("{}: {error}", svg.display())))?;
            }
        }
    }
    out.flush()?;
    Ok(())
}
