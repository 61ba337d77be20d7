//! The command `assur`: mechanisms of the catalogue and of files as tables, drawings, Assur groups and circuits; their
//! forces, motion under load and mobility; four-bars for given positions; differentials from numbers of teeth.
//!
//! Each command has its own file. `source.rs` finds what NAME denotes; `words.rs` turns problems into sentences.

mod assemblies;
mod circuits;
mod csv;
mod cycle;
mod differential;
mod exact;
mod forces;
mod mobility;
mod plot;
mod run;
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

/// Shows planar mechanisms: tables of their motion, their Assur groups, drawings.
///
/// NAME is a name of the catalogue (see `assur list`) or a file: a state saved by the page, or a linkage alone, both
/// described in docs/file-format.md. NAME may also be a file of the program Linkage (`.linkage2`) or, in quotes, a URL
/// of PMKS+ or PMKS. Standard error lists anything that could not be imported unchanged.
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
    /// Rows are in ascending order of the input, over the range of the motion (see `assur structure`). A crank that
    /// turns fully has rows from 0° to 360°, or over as many turns as the motion takes to repeat; the end of the range
    /// has a row only if a step falls on it. A driver that turns back has rows at its dead points and, between them, at
    /// the multiples of the step. A driven slide has rows over its whole range. A requested angle outside the range is
    /// brought into it by whole turns.
    ///
    /// The first column is the input: `phi_deg`, the crank angle in degrees, or `s`, the displacement of a driven
    /// slide. Each link has the columns LINK.angle (radians, not reduced to one turn), LINK.dangle, LINK.ddangle. Each
    /// point has P.x, P.y, P.dx, P.dy, P.ddx, P.ddy, in the file's unit of length. Derivatives are with respect to the
    /// input, in radians for a crank. With --omega they are with respect to time, in seconds: LINK.omega, LINK.epsilon,
    /// P.vx, P.vy, P.ax, P.ay. With --degrees, angles are in degrees, and derivatives are with respect to degrees of
    /// the crank. The last column, `reason`, says why there is no pose or no derivative.
    Sweep(sweep::Asked),
    /// Writes a table (CSV) of the reactions in all pairs and of the torques or forces that balance the drivers.
    ///
    /// Masses, gravity, loads, springs, dampers and friction are those of the file (docs/file-format.md). The driver moves at a
    /// constant speed, or as --omega and --epsilon say. Rows are those of `assur sweep`.
    ///
    /// After the input come DRIVER.torque, or DRIVER.force of a driven slide, then for each pair the force on one link
    /// from the other and its opposite: PAIR.ON.FROM.x and PAIR.ON.FROM.y, where ON and FROM are links. Slides and
    /// meshes have also PAIR.ON.FROM.moment, about the sliding point. Forces are in newtons, torques in newton metres,
    /// positive counter-clockwise; without a unit of lengths they are in the consistent unit. A cell is empty if
    /// redundant constraints leave it undetermined, or if there is no pose; `reason` says why there is none.
    ///
    /// Then come the force and moment (about the origin) with which the moving links shake the frame, shaking.x,
    /// shaking.y and shaking.moment; with friction also the power lost (watts) and the efficiency of the first driver.
    ///
    /// With --json: {"rows": [{"input", "drivers": [{"name", "torque" or "force"}], "reactions": [{"pair", "on", "from",
    /// "x", "y", "moment"}], "shaking": {"x", "y", "moment"}}]}, with null for what is undetermined.
    ///
    /// Example: assur forces crank.json --step 10 --omega 20
    Forces(forces::Asked),
    /// Writes the motion under load over time as a table (CSV).
    ///
    /// The driver is free, or moved by the motor of the file, and the linkage moves under its loads from the pose of the
    /// drawing at the initial rate of the file. Columns are t (seconds), input (radians, or a length for a
    /// slide), rate and acceleration of the input, then in joules the kinetic and potential energy, the work of the
    /// motor and of the given forces, and the energy lost in resistances, dampers and friction. Friction may stop the
    /// linkage; then it stays. If the motion ends at a dead point, or the linkage locks itself by friction, the last row
    /// is there, and standard error says so.
    ///
    /// With several drivers each is a freedom of its own, with a motor of its own or a rate that it keeps. Columns after
    /// t are then input, rate, acceleration and torque (newton metres; of a slide the force, newtons) of each driver,
    /// named after its link: AB.input, AB.rate, … Dry friction is not counted with several drivers.
    ///
    /// Example: assur run crank.json --until 3 --every 0.01
    Run(run::Asked),
    /// Writes a table (CSV) of the steady cycle under load, without and with a flywheel for a wanted non-uniformity.
    ///
    /// The crank turns fully, driven by the motor of the file. Without a motor, a constant torque is found that keeps
    /// the mean rate of --omega, or else the initial rate of the file. With --delta, flywheels are found by Wittenbauer's
    /// diagram and by Mertsalov's method, and the cycle is run with each: `delta` is what it really reaches.
    ///
    /// Columns are the method (given: the flywheel of the file, if any), flywheel (moment of inertia on the crank, kg·m²),
    /// delta (coefficient of non-uniformity), the mean, least and greatest rate of the crank (rad/s), torque (of the
    /// drive at the mean rate, N·m) and period (seconds). `reason` says why a row has no cycle. With --json: {"rows":
    /// [{"method", "flywheel", "delta", "mean", "least", "greatest", "torque", "period"}]}.
    ///
    /// Example: assur cycle press.json --omega 12 --delta 0.02
    Cycle(cycle::Asked),
    /// Shows mobility, class, formula, passive wheels, the Assur groups in their order, and the range of the motion
    /// with its dead points and change points.
    ///
    /// The report then gives, for each output, its swing or stroke, its travel in both directions and, if it moves
    /// there and back once per turn, its time ratio. Outputs are the quantities plotted by the file, or else all angles
    /// and all points that slide on the frame. Last come the Grashof class of each four-bar, the minimum transmission
    /// angle of each RRR dyad and the maximum pressure angle of each RRP dyad.
    ///
    /// A drawing whose redundant constraints hold only approximately is locked. With --make-exact its points are moved
    /// as little as possible to make it movable; the corrected drawing goes to standard output, the greatest
    /// displacement to standard error.
    Structure {
        /// Catalogue name or file.
        name: Name,
        /// Prints JSON.
        #[arg(long)]
        json: bool,
        /// Instead of the structure, writes the drawing corrected so that it moves, as a file
        #[arg(long, conflicts_with = "json")]
        make_exact: bool,
    },
    /// Writes a table (CSV) of all assemblies at an input: every way in which the links can be joined.
    ///
    /// There is one row per assembly: its number, then LINK.angle for each link, radians from 0 to 2π. Assemblies are
    /// numbered from 1 by the angle of the output from 0 to 2π; the output is the link whose angle the file plots
    /// first, or else the link placed last. Dyads are solved in closed form; groups of Class III and higher are solved
    /// over the complex numbers, so that no assembly is missed. Wheels in mesh keep their mounting.
    ///
    /// A linkage that does not close as drawn, such as one known only by its lengths, also has assemblies. --assemble N
    /// writes the linkage, drawn in assembly N, to standard output.
    Assemblies(assemblies::Asked),
    /// Shows all motions of the linkage, and which of them can be reached from one another.
    ///
    /// A branch is a piece of motion between two dead points, or a whole cycle. Two branches meet at a fold, which is a
    /// dead point of both, or at a crossing, a change point through which both pass. Branches that meet belong to one
    /// circuit: the linkage can go from one to the other without being taken apart. Branches and circuits are numbered
    /// by their least input, and at equal inputs by the numbers of their assemblies (see `assur assemblies`).
    Circuits {
        /// Catalogue name or file.
        name: Name,
        /// Prints JSON.
        #[arg(long)]
        json: bool,
    },
    /// Counts mobility and redundant constraints, and checks both by the rank of the constraints.
    ///
    /// NAME is a scheme of links and pairs, or any linkage, taken as drawn even if it is locked, lacks drivers or does
    /// not close. Pairs are cut until every contour is open. W is then the sum of the freedoms of the remaining pairs,
    /// less the constraints of the cut pairs; q counts the constraints that are redundant in space. If the positions
    /// and axes of pairs are known, the rank gives the true mobility. It also shows which pairs carry redundant
    /// constraints, which links can move while all others are at rest, and which pairs to replace.
    Mobility {
        /// Catalogue name or file.
        name: Name,
        /// Pairs to cut. At a hinge of three or more links, the link to detach follows a colon, as in Q:3 [default: the
        /// cuts of the file, or else automatic ones]
        #[arg(long, value_name = "PAIR,PAIR", value_delimiter = ',')]
        cut: Option<Vec<String>>,
        /// Prints JSON.
        #[arg(long)]
        json: bool,
    },
    /// Shows speeds, transmission ratios and conditions of an epicyclic train with two degrees of freedom.
    ///
    /// The members are sun 1, satellite 2, carrier 3 and ring 4; the wheels are gears in contact or magnets with gaps.
    /// Two inputs, each a speed (--w1, --w3, --w4) or a --tie, determine all speeds; i/j(k) is the ratio of wi to wj
    /// with k held.
    Differential(differential::Asked),
    /// Draws the mechanism in the pose of its file, with its traced paths, and its plots below.
    Plot {
        /// Catalogue name or file.
        name: Name,
        /// Output file; `-` for standard output.
        #[arg(long, value_name = "OUT")]
        svg: PathBuf,
        /// Number of the assembly to draw, as listed by `assur assemblies` at the drawn input [default: the drawn
        /// assembly]
        #[arg(long, value_name = "N")]
        assembly: Option<usize>,
    },
    /// Finds the four-bars for given positions, with a verdict on each.
    ///
    /// The lengths are l0 of the frame, l1 of the coupler, l2 of the output link and l3 of the driver. Two positions
    /// leave a family of linkages, and three leave one linkage. For more than three, the best compromise is found, with
    /// l1, l2 and l3 from a tenth of l0 to ten times l0. With --function the positions lie on a function y = f(x); the
    /// greatest error of y is shown with the x at which it occurs.
    ///
    /// With --pose the linkages guide a body through two to five poses. A dyad is a link hinged to frame and body (RR),
    /// a slider on the frame (PR) or a block on the frame through which a line of the body slides (RP); points of the
    /// body are given in the first pose. Five poses have up to four dyads, Burmester's pairs. Every two dyads are a
    /// linkage with its verdict: the order of the poses, whether they are on one circuit and one branch, the Grashof type and
    /// the minimum transmission angle between them.
    ///
    /// With --pose and --json: {"solutions": [{"points", "links", "dyads", "verdict": {"order", "circuit", "branch",
    /// "grashof", "transmission"}}], "count", "complete"}, with the transmission angle in radians.
    ///
    /// Example: assur synth --pose 0,0,0 --pose 1,0.6,30 --pose 2,0.5,65 --pivot 0,-2 --pivot 2,-2
    ///
    /// With --through the coupler point P passes through points. Of the 1,442 coupler curves through nine points the
    /// real ones are listed, each with its three cognates, those first that pass through all points in one motion.
    /// `complete` says that all 1,442 are found and proved by interval arithmetic. For another number of points, with
    /// crank angles, for a curve or with slider-cranks, a search lists up to six linkages, the nearest to the path first,
    /// with their greatest distance from it. `exact` says that the points are met within rounding.
    ///
    /// With --through and --json: {"solutions": [{"points", "links", "dyads", "verdict": {"order", "circuit", "branch",
    /// "grashof", "transmission"}}], "count", "complete"}, with the transmission angle in radians. Four-bars through nine
    /// points also have "curve", "residual" and "error", beside "curves" and "unproved" of them all; linkages of a search
    /// have "mechanism", "greatest" and "root_mean_square", beside "candidates", "exact" and "special".
    ///
    /// Example: assur synth --through 0.9,-0.1 --through 1.2,-1.2 --through 1.5,-0.9 --through 1.7,-0.5
    /// --through 1.72,-0.3 --through 1.73,0 --through 1.66,0.33 --through 1.5,0.74 --through 1.3,0.92
    ///
    /// Example: assur synth --through 0,0 --through 1,0.6 --through 2,0.4 --through 1.5,-0.5 --course closed
    Synth(Box<synth::Asked>),
}

/// A failure, with its message.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A file could not be read or written: exit status 1.
    Io(String),
    /// Invalid input: exit status 2.
    Input(String),
    /// The reader has closed the pipe, as `head` does: exit status 0.
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
    // clap itself exits with 0 after --help and with 2 after unknown arguments.
    let arguments = Arguments::parse();
    let (said, status) = match run(arguments.command) {
        Ok(()) | Err(Failure::Unread) => return ExitCode::SUCCESS,
        Err(Failure::Io(said)) => (said, 1),
        Err(Failure::Input(said)) => (said, 2),
    };
    // A failure to write to standard error cannot be reported.
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
        Command::Forces(asked) => forces::write(&mut out, &asked)?,
        Command::Run(asked) => run::write(&mut out, &asked)?,
        Command::Cycle(asked) => cycle::write(&mut out, &asked)?,
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
                // A failure to write to standard error cannot be reported.
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
