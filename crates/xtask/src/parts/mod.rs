//! The engine's module in two parts, so that a first view need not wait for the whole module: the first part holds the
//! functions that a first view calls, the second part the others.
//!
//! The two parts work as one module. The second part imports the memory, tables, globals and functions of the first. The
//! first part calls the second through a table: for each function of the second part that it may call, it has a stub. A
//! stub whose place in the table is empty first calls the import `second.load`, which instantiates the second part.

use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};

use anyhow::Result;
use wasm_encoder::reencode::Reencode as _;
use wasm_encoder::{CustomSection, Module, RefType, TableType};
use wasmparser::Parser;

use self::contents::Contents;
use self::first::First;
use self::marked::Marked;
use self::second::Second;

mod contents;
mod first;
mod marked;
mod second;

/// Name of the custom section with the hash of the whole module and its division, the same in both parts.
const BUILD: &str = "build";

/// Marks the functions of a module: the export `called.N` is a global that becomes 1 when function N is called.
pub(crate) fn marked(wasm: &[u8]) -> Result<Vec<u8>> {
    let contents = Contents::read(wasm)?;
    let mut module = Module::new();
    let mut marked = Marked::new(&contents);
    marked.parse_core_module(&mut module, Parser::new(0), wasm)?;
    Ok(module.finish())
}

/// Divides a module into two parts. `first` has the numbers of the functions that the first part holds.
pub(crate) fn divided(wasm: &[u8], first: &BTreeSet<u32>) -> Result<[Vec<u8>; 2]> {
    let contents = Contents::read(wasm)?;
    let division = Division::new(&contents, first)?;
    let mut hasher = DefaultHasher::new();
    (wasm, first).hash(&mut hasher);
    let build = hasher.finish().to_le_bytes();

    let mut parts = [Module::new(), Module::new()];
    let [one, other] = &mut parts;
    First::new(&contents, &division).parse_core_module(one, Parser::new(0), wasm)?;
    Second::new(&contents, &division).parse_core_module(other, Parser::new(0), wasm)?;
    Ok(parts.map(|mut part| {
        part.section(&CustomSection {
            name: BUILD.into(),
            data: build.as_slice().into(),
        });
        part.finish()
    }))
}

/// Functions of a module by part. Functions are given by their numbers in the whole module.
struct Division {
    /// Functions of the first part, without imported ones, in order.
    first: Vec<u32>,
    /// Functions of the second part, in order.
    second: Vec<u32>,
    /// Functions of the second part that the first may call. The first part has a stub for each; the index is the place
    /// in the table.
    stubs: Vec<u32>,
    /// Functions of the first part and imported ones that the second part calls.
    shared: Vec<u32>,
}

impl Division {
    fn new(contents: &Contents, first: &BTreeSet<u32>) -> Result<Self> {
        let (mut entered, mut called_by_second) = (contents.entries.clone(), BTreeSet::new());
        let (first, second): (Vec<u32>, Vec<u32>) = contents
            .defined()
            .partition(|function| first.contains(function));
        for (functions, called) in [(&first, &mut entered), (&second, &mut called_by_second)] {
            for function in functions {
                called.extend(contents.called(*function)?);
            }
        }
        let is_second = |function: &u32| second.binary_search(function).is_ok();
        Ok(Self {
            stubs: entered.into_iter().filter(is_second).collect(),
            shared: called_by_second
                .into_iter()
                .filter(|function| !is_second(function))
                .collect(),
            first,
            second,
        })
    }

    /// Type of the table through which the first part calls the second.
    fn table(&self) -> TableType {
        let size = self.stubs.len() as u64;
        TableType {
            element_type: RefType::FUNCREF,
            table64: false,
            minimum: size,
            maximum: Some(size),
            shared: false,
        }
    }
}

/// New numbers of functions, by their numbers in the whole module. `order` lists the functions in their new order;
/// `None` stands for a function that the whole module lacks. A function that is not in `order` gets `u32::MAX`, which
/// no module accepts.
fn numbered(count: usize, order: impl Iterator<Item = Option<u32>>) -> Vec<u32> {
    let mut numbers = vec![u32::MAX; count];
    for (new, old) in (0..).zip(order) {
        if let Some(old) = old {
            numbers[old as usize] = new;
        }
    }
    numbers
}

#[cfg(test)]
mod tests {
    use wasm_encoder::{
        CodeSection, ConstExpr, ElementSection, Elements, EntityType, ExportKind, ExportSection,
        Function, FunctionSection, GlobalSection, GlobalType, ImportSection, MemorySection,
        MemoryType, TableSection, TypeSection, ValType,
    };
    use wasmparser::{Payload, Validator};

    use super::*;

    /// A module with the functions 0 (imported), 1 (exported, calls 2), 2 (calls 0 and 3), 3 and 4 (in the table).
    fn whole() -> Vec<u8> {
        let mut types = TypeSection::new();
        types.ty().function([ValType::I32], [ValType::I32]);
        let mut imports = ImportSection::new();
        imports.import("page", "ask", EntityType::Function(0));
        let mut functions = FunctionSection::new();
        let mut code = CodeSection::new();
        for called in [&[2][..], &[0, 3], &[], &[]] {
            functions.function(0);
            let mut function = Function::new([]);
            let mut body = function.instructions();
            body.local_get(0);
            for one in called {
                body.call(*one);
            }
            body.end();
            code.function(&function);
        }
        let mut tables = TableSection::new();
        tables.table(TableType {
            element_type: RefType::FUNCREF,
            table64: false,
            minimum: 1,
            maximum: None,
            shared: false,
        });
        let mut memories = MemorySection::new();
        memories.memory(MemoryType {
            minimum: 1,
            maximum: None,
            memory64: false,
            shared: false,
            page_size_log2: None,
        });
        let mut globals = GlobalSection::new();
        globals.global(
            GlobalType {
                val_type: ValType::I32,
                mutable: true,
                shared: false,
            },
            &ConstExpr::i32_const(7),
        );
        let mut exports = ExportSection::new();
        exports.export("answer", ExportKind::Func, 1);
        let mut elements = ElementSection::new();
        elements.active(
            None,
            &ConstExpr::i32_const(0),
            Elements::Functions([4][..].into()),
        );
        let mut module = Module::new();
        module
            .section(&types)
            .section(&imports)
            .section(&functions)
            .section(&tables)
            .section(&memories);
        module
            .section(&globals)
            .section(&exports)
            .section(&elements)
            .section(&code);
        module.finish()
    }

    /// Names of imports and exports, with their modules.
    fn names(wasm: &[u8]) -> Vec<String> {
        Validator::new().validate_all(wasm).unwrap();
        let mut names = Vec::new();
        for payload in Parser::new(0).parse_all(wasm) {
            match payload.unwrap() {
                Payload::ImportSection(imports) => {
                    names.extend(imports.into_imports().map(|import| {
                        let import = import.unwrap();
                        format!("{}.{}", import.module, import.name)
                    }));
                }
                Payload::ExportSection(exports) => {
                    names.extend(
                        exports
                            .into_iter()
                            .map(|export| export.unwrap().name.to_owned()),
                    );
                }
                _ => {}
            }
        }
        names
    }

    #[test]
    fn the_second_part_imports_what_it_uses_of_the_first() {
        let [first, second] = divided(&whole(), &[1, 3].into()).unwrap();
        let exported = ["answer", "t0", "t1", "m0", "g0", "f0", "f3"];
        let imported = ["page.ask", "second.load"];
        assert_eq!(names(&first), [&imported[..], &exported].concat());
        assert_eq!(
            names(&second),
            ["f0", "f3", "t0", "t1", "m0", "g0"].map(|name| format!("first.{name}"))
        );
    }

    #[test]
    fn functions_that_are_exported_or_in_a_table_have_stubs() {
        let whole = whole();
        let contents = Contents::read(&whole).unwrap();
        let division = Division::new(&contents, &BTreeSet::new()).unwrap();
        assert!(division.first.is_empty());
        assert_eq!(division.stubs, [1, 4]);
        assert_eq!(division.second, [1, 2, 3, 4]);
        assert_eq!(division.shared, [0]);
    }

    #[test]
    fn each_function_has_a_mark() {
        let marked = marked(&whole()).unwrap();
        let marks = [1, 2, 3, 4].map(|function| format!("called.{function}"));
        assert_eq!(names(&marked)[2..], marks);
    }

    #[test]
    fn damaged_wasm_is_refused() {
        let whole = whole();
        assert!(divided(&whole[..whole.len() - 3], &BTreeSet::new()).is_err());
        assert!(marked(b"no wasm").is_err());
    }
}
