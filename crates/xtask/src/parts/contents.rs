//! The contents of a WebAssembly module that must be known to divide the module into two parts.

use std::collections::BTreeSet;

use anyhow::{Result, bail};
use wasmparser::{
    ElementItems, ExternalKind, FuncType, FunctionBody, GlobalType, MemoryType, Operator, Parser,
    Payload, TableType, TypeRef,
};

#[derive(Default)]
pub(super) struct Contents<'a> {
    pub(super) types: Vec<FuncType>,
    /// Number of imported functions. They come before the defined ones.
    pub(super) imported: u32,
    /// Type of each function, as an index into `types`.
    pub(super) functions: Vec<u32>,
    bodies: Vec<FunctionBody<'a>>,
    pub(super) tables: Vec<TableType>,
    pub(super) memories: Vec<MemoryType>,
    pub(super) globals: Vec<GlobalType>,
    /// Functions that are exported or in a table.
    pub(super) entries: BTreeSet<u32>,
}

impl<'a> Contents<'a> {
    pub(super) fn read(wasm: &'a [u8]) -> Result<Self> {
        let mut contents = Self::default();
        for payload in Parser::new(0).parse_all(wasm) {
            contents.add(payload?)?;
        }
        Ok(contents)
    }

    fn add(&mut self, payload: Payload<'a>) -> Result<()> {
        match payload {
            Payload::TypeSection(types) => {
                for one in types.into_iter_err_on_gc_types() {
                    self.types.push(one?);
                }
            }
            Payload::ImportSection(imports) => {
                for import in imports.into_imports() {
                    let TypeRef::Func(function) = import?.ty else {
                        bail!("the module imports more than functions");
                    };
                    self.functions.push(function);
                    self.imported += 1;
                }
            }
            Payload::FunctionSection(functions) => {
                for function in functions {
                    self.functions.push(function?);
                }
            }
            Payload::TableSection(tables) => {
                for table in tables {
                    self.tables.push(table?.ty);
                }
            }
            Payload::MemorySection(memories) => {
                for memory in memories {
                    self.memories.push(memory?);
                }
            }
            Payload::GlobalSection(globals) => {
                for global in globals {
                    self.globals.push(global?.ty);
                }
            }
            Payload::ExportSection(exports) => {
                for export in exports {
                    let export = export?;
                    if export.kind == ExternalKind::Func {
                        self.entries.insert(export.index);
                    }
                }
            }
            Payload::ElementSection(elements) => {
                for element in elements {
                    let ElementItems::Functions(functions) = element?.items else {
                        bail!("a table holds more than functions");
                    };
                    for function in functions {
                        self.entries.insert(function?);
                    }
                }
            }
            Payload::StartSection { .. } => bail!("the module has a start function"),
            Payload::CodeSectionEntry(body) => self.bodies.push(body),
            _ => {}
        }
        Ok(())
    }

    /// Numbers of the functions that are not imported.
    pub(super) fn defined(&self) -> impl Iterator<Item = u32> + use<> {
        self.imported..self.functions.len() as u32
    }

    /// Body of a defined function.
    pub(super) fn body(&self, function: u32) -> &FunctionBody<'a> {
        &self.bodies[(function - self.imported) as usize]
    }

    /// Functions that a defined function calls directly.
    pub(super) fn called(&self, function: u32) -> Result<Vec<u32>> {
        let mut called = Vec::new();
        let mut operators = self.body(function).get_operators_reader()?;
        while !operators.eof() {
            match operators.read()? {
                Operator::Call { function_index } | Operator::ReturnCall { function_index } => {
                    called.push(function_index)
                }
                // The second part has no segments.
                Operator::RefFunc { .. }
                | Operator::MemoryInit { .. }
                | Operator::DataDrop { .. }
                | Operator::TableInit { .. }
                | Operator::ElemDrop { .. } => {
                    bail!("function {function} uses a segment or a reference to a function")
                }
                _ => {}
            }
        }
        Ok(called)
    }
}
