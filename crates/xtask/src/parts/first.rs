//! The first part of a divided module: the whole module without the functions of the second part. Each of those that
//! the first part may call is replaced by a stub.

use std::convert::Infallible;

use wasm_encoder::reencode::{Error, Reencode, utils};
use wasm_encoder::{
    BlockType, CodeSection, EntityType, ExportKind, ExportSection, Function, FunctionSection,
    ImportSection, TableSection, TypeSection,
};
use wasmparser::{
    CodeSectionReader, ExportSectionReader, FunctionSectionReader, ImportSectionReader,
    TableSectionReader, TypeSectionReader,
};

use super::contents::Contents;
use super::{Division, numbered};

pub(super) struct First<'a> {
    contents: &'a Contents<'a>,
    division: &'a Division,
    numbers: Vec<u32>,
}

impl<'a> First<'a> {
    pub(super) fn new(contents: &'a Contents, division: &'a Division) -> Self {
        let imported = (0..contents.imported).map(Some);
        let defined = division.first.iter().chain(&division.stubs).copied();
        // The import that loads the second part follows the imports of the whole module.
        let order = imported.chain([None]).chain(defined.map(Some));
        Self {
            contents,
            division,
            numbers: numbered(contents.functions.len(), order),
        }
    }

    /// Number of the table through which the second part is called.
    fn table(&self) -> u32 {
        self.contents.tables.len() as u32
    }

    /// Stub of a function of the second part, whose place in the table is `place`. It calls the function through the
    /// table, after loading the second part if the place is empty.
    fn stub(&self, place: i32, function: u32) -> Function {
        let kind = self.contents.functions[function as usize];
        let parameters = self.contents.types[kind as usize].params().len() as u32;
        let mut stub = Function::new([]);
        let mut code = stub.instructions();
        code.i32_const(place).table_get(self.table()).ref_is_null();
        code.if_(BlockType::Empty)
            .call(self.contents.imported)
            .end();
        for parameter in 0..parameters {
            code.local_get(parameter);
        }
        code.i32_const(place)
            .call_indirect(self.table(), kind)
            .end();
        stub
    }
}

impl Reencode for First<'_> {
    type Error = Infallible;

    fn function_index(&mut self, function: u32) -> Result<u32, Error> {
        Ok(self.numbers[function as usize])
    }

    fn parse_type_section(
        &mut self,
        types: &mut TypeSection,
        section: TypeSectionReader,
    ) -> Result<(), Error> {
        utils::parse_type_section(self, types, section)?;
        types.ty().function([], []);
        Ok(())
    }

    fn parse_import_section(
        &mut self,
        imports: &mut ImportSection,
        section: ImportSectionReader,
    ) -> Result<(), Error> {
        utils::parse_import_section(self, imports, section)?;
        let load = EntityType::Function(self.contents.types.len() as u32);
        imports.import("second", "load", load);
        Ok(())
    }

    fn parse_function_section(
        &mut self,
        functions: &mut FunctionSection,
        _: FunctionSectionReader,
    ) -> Result<(), Error> {
        for function in self.division.first.iter().chain(&self.division.stubs) {
            functions.function(self.contents.functions[*function as usize]);
        }
        Ok(())
    }

    fn parse_table_section(
        &mut self,
        tables: &mut TableSection,
        section: TableSectionReader,
    ) -> Result<(), Error> {
        utils::parse_table_section(self, tables, section)?;
        tables.table(self.division.table());
        Ok(())
    }

    fn parse_export_section(
        &mut self,
        exports: &mut ExportSection,
        section: ExportSectionReader,
    ) -> Result<(), Error> {
        utils::parse_export_section(self, exports, section)?;
        let Contents {
            tables,
            memories,
            globals,
            ..
        } = self.contents;
        for (letter, kind, count) in [
            ('t', ExportKind::Table, tables.len() + 1),
            ('m', ExportKind::Memory, memories.len()),
            ('g', ExportKind::Global, globals.len()),
        ] {
            for number in 0..count as u32 {
                exports.export(&format!("{letter}{number}"), kind, number);
            }
        }
        for function in &self.division.shared {
            exports.export(
                &format!("f{function}"),
                ExportKind::Func,
                self.function_index(*function)?,
            );
        }
        Ok(())
    }

    fn parse_code_section(
        &mut self,
        code: &mut CodeSection,
        _: CodeSectionReader,
    ) -> Result<(), Error> {
        for function in &self.division.first {
            let body = self.contents.body(*function).clone();
            self.parse_function_body(code, body)?;
        }
        for (place, function) in (0..).zip(&self.division.stubs) {
            code.function(&self.stub(place, *function));
        }
        Ok(())
    }
}
