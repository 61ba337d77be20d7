//! The kinds of document, a module for each. A kind is added by its module and its line in
//! the registry below.

pub(crate) mod draft;
pub(crate) mod gear_train;
pub(crate) mod linkage;
pub(crate) mod mixer;
pub(crate) mod numbers;
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
use scheme::SchemeDocument;
use synthesis::SynthesisDocument;

/// Properties of a document of any kind.
pub trait Kind {
    /// The mechanism of the catalogue that it came from, by name.
    fn origin(&self) -> Option<&str> {
        None
    }

    /// The linkage that it describes.
    ///
    /// # Errors
    /// Every problem that prevents this.
    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>>;

    /// Unit of its lengths.
    fn unit(&self) -> LengthUnit {
        LengthUnit::None
    }

    /// Whether the document has a field for its unit.
    fn chooses_unit(&self) -> bool {
        false
    }

    /// Its numbers that a lesson may vary.
    ///
    /// # Errors
    /// Every problem that prevents this.
    fn numbers(&self) -> Result<Vec<NumberField>, Vec<Problem>> {
        Ok(Vec::new())
    }

    /// The motion of what it describes; a mixer's over every arc of its crank.
    ///
    /// # Errors
    /// Every problem that prevents its motion.
    fn motion(&self) -> Result<Motion, Vec<Problem>> {
        self.linkage()?.motion()
    }
}

/// A linkage in motion, with its plotted quantities.
#[derive(Clone, Debug)]
pub struct Moved {
    /// The linkage.
    pub document: LinkageDocument,
    /// Its motion.
    pub motion: Motion,
    /// Plotted quantities, of one kind.
    pub plotted: Vec<Quantity>,
}

impl Moved {
    /// A linkage in its motion, with the quantities that a choice of the page names.
    ///
    /// # Errors
    /// Problems that prevent its motion; a choice that names nothing.
    pub fn new(document: LinkageDocument, plot: &str) -> Result<Self, Vec<Problem>> {
        let motion = document.motion()?;
        Self::over(document, motion, plot)
    }

    fn over(document: LinkageDocument, motion: Motion, plot: &str) -> Result<Self, Vec<Problem>> {
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

/// Defines the document of a state by the list of kinds.
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

        /// A document is asked what its kind can be asked.
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
    /// A differential driven by time.
    "gear-train" => GearTrain(GearTrainDocument),
    /// Any linkage.
    "linkage" => Linkage(LinkageDocument),
    /// Crank-rocker and gears.
    "mixer" => Mixer(MixerDocument),
    /// Links and pairs without motion.
    "scheme" => Scheme(SchemeDocument),
    /// A four-bar for given positions.
    "synthesis" => Synthesis(SynthesisDocument),
}

impl Document {
    /// Its motion, with the quantities that a choice of the page names.
    ///
    /// # Errors
    /// Every problem that prevents its motion; a choice that names nothing.
    pub fn moved(&self, plot: &str) -> Result<Moved, Vec<Problem>> {
        Moved::over(self.linkage()?, self.motion()?, plot)
    }
}
