//! The terminal program run as a process: exit status, tables, structures, drawings.

mod arguments;
mod assemblies;
mod drawings;
mod files;
mod forces;
mod golden;
mod imported;
mod linkages;
mod options;
mod redundant;
mod run;
mod structure;
mod sweep;
