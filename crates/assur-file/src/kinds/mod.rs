//! The kinds of document, with a module for each. A new kind needs a module, and a line in the list of kinds below.

pub(crate) mod draft;
pub(crate) mod gear_train;
pub(crate) mod linkage;
pub(crate) mod mixer;
pub(crate) mod numbers;
pub(crate) mod point_path;
pub(crate) mod poses;
pub(crate) mod scheme;
pub(crate) mod synthesis;

use std::ops::Deref;

use assur::mechanism::Quantity;
use assur::motion::Motion;
use serde::Serialize;
use serde_json::Value;

use crate::text::within;
use crate::{LengthUnit, Problem};
use draft::DraftDocument;
use gear_train::GearTrainDocument;
use linkage::LinkageDocument;
use mixer::MixerDocument;
use numbers::NumberField;
use point_path::PathDocument;
use poses::PosesDocument;
use scheme::SchemeDocument;
use synthesis::SynthesisDocument;

/// Properties of a document of any kind.
pub trait Kind {
    /// Name of the catalogue mechanism from which the document was made, if any.
    fn origin(&self) -> Option<&str> {
        None
    }

    /// The linkage that the document describes.
    ///
    /// # Errors
    /// The reasons why there is no linkage.
    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>>;

    /// Unit of lengths.
    fn unit(&self) -> LengthUnit {
        LengthUnit::None
    }

    /// Whether the document has a field for its unit.
    fn chooses_unit(&self) -> bool {
        false
    }

    /// The numbers of the document that a lesson may vary.
    ///
    /// # Errors
    /// The reasons why the numbers are not known.
    fn numbers(&self) -> Result<Vec<NumberField>, Vec<Problem>> {
        Ok(Vec::new())
    }

    /// The motion of the document's linkage; for a mixer, over every arc of the crank on which its loop closes.
    ///
    /// # Errors
    /// The problems that prevent the motion.
    fn motion(&self) -> Result<Motion, Vec<Problem>> {
        self.linkage()?.motion()
    }
}

/// A linkage in motion, with its plotted quantities.
#[derive(Clone, Debug)]
pub struct Moved {
    /// The linkage.
    pub document: LinkageDocument,
    /// Motion of the linkage.
    pub motion: Motion,
    /// Plotted quantities, either all angles or all lengths.
    pub plotted: Vec<Quantity>,
}

impl Moved {
    /// Makes a linkage in motion, with the quantities selected by the view's field `plot`.
    ///
    /// # Errors
    /// Problems that prevent the motion; an unknown name in `plot`.
    pub fn new(document: LinkageDocument, plot: &str) -> Result<Self, Vec<Problem>> {
        let motion = document.motion()?;
        Self::over(document, motion, plot)
    }

    pub(crate) fn over(
        document: LinkageDocument,
        motion: Motion,
        plot: &str,
    ) -> Result<Self, Vec<Problem>> {
        let Some(plotted) = document.plotted(motion.mechanism(), plot) else {
            let field = "plot".into();
            return Err(vec![Problem::UnknownChoice { field }]);
        };
        Ok(Self {
            document,
            motion,
            plotted,
        })
    }
}

/// Defines [`Document`] from the list of kinds.
macro_rules! kinds {
    ($($(#[$about:meta])+ $name:literal => $kind:ident($document:ty),)+) => {
        /// The document of a state; serialised as `kind` and `document`.
        #[derive(Clone, Debug, PartialEq, Serialize)]
        #[cfg_attr(test, derive(ts_rs::TS))]
        #[serde(tag = "kind", content = "document")]
        pub enum Document {
            $($(#[$about])+ #[serde(rename = $name)] $kind($document),)+
        }

        impl Document {
            /// Reads the document of this kind from a state; `field` is the field that names the kind.
            pub(crate) fn read(field: &str, kind: &str, state: &Value) -> Result<Self, Problem> {
                let missing = || Problem::BadState {
                    path: ".".to_owned(),
                    detail: "missing field `document`".to_owned(),
                };
                match kind {
                    $($name => within(state, "document")?.map(Self::$kind).ok_or_else(missing),)+
                    _ => Err(Problem::BadState {
                        path: field.to_owned(),
                        detail: format!("there is no kind `{kind}`"),
                    }),
                }
            }
        }

        /// Gives a document the methods of its kind.
        impl Deref for Document {
            type Target = dyn Kind;

            fn deref(&self) -> &Self::Target {
                match self {
                    $(Self::$kind(document) => document,)+
                }
            }
        }
    };
}

kinds! {
    /// A linkage that does not move yet.
    "draft" => Draft(DraftDocument),
    /// A differential, whose input is time.
    "gear-train" => GearTrain(GearTrainDocument),
    /// Any linkage.
    "linkage" => Linkage(LinkageDocument),
    /// A mixer: a crank-rocker with gears.
    "mixer" => Mixer(MixerDocument),
    /// A path that a point is to trace.
    "point-path" => Path(PathDocument),
    /// A body in given poses.
    "poses" => Poses(PosesDocument),
    /// Links and pairs without motion.
    "scheme" => Scheme(SchemeDocument),
    /// A four-bar for given positions.
    "synthesis" => Synthesis(SynthesisDocument),
}

impl Document {
    /// The motion of the document, with the quantities selected by the view's field `plot`.
    ///
    /// # Errors
    /// The problems that prevent the motion; an unknown name in `plot`.
    pub fn moved(&self, plot: &str) -> Result<Moved, Vec<Problem>> {
        Moved::over(self.linkage()?, self.motion()?, plot)
    }
}
