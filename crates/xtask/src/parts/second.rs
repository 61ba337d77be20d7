//! The second part of a divided module. It contains only functions, and puts those with stubs into the table.
//! Everything else is imported from the first part.

use std::convert::Infallible;

use wasm_encoder::reencode::{Error, Reencode};
use wasm_encoder::{
    CodeSection, ConstExpr, DataSection, ElementSection, Elements, EntityType, ExportSection,
    FunctionSection, GlobalSection, ImportSection, MemorySection, TableSection,
};
use wasmparser::{
    CodeSectionReader, DataSectionReader, ElementSectionReader, ExportSectionReader,
    FunctionSectionReader, GlobalSectionReader, ImportSectionReader, MemorySectionReader,
    TableSectionReader,
};

use super::contents::Contents;
use super::{Division, numbered};

pub(super) struct Second<'a> {
    contents: &'a Contents<'a>,
    division: &'a Division,
    numbers: Vec<u32>,
}

impl<'a> Second<'a> {
    pub(super) fn new(contents: &'a Contents, division: &'a Division) -> Self {
        let order = division.shared.iter().chain(&division.second).copied();
        Self {
            contents,
            division,
            numbers: numbered(contents.functions.len(), order.map(Some)),
        }
    }
}

impl Reencode for Second<'_> {
    type Error = Infallible;

    fn function_index(&mut self, function: u32) -> Result<u32, Error> {
        Ok(self.numbers[function as usize])
    }

    fn data_count(&mut self, _: u32) -> Result<u32, Error> {
        Ok(0)
    }

    fn parse_import_section(
        &mut self,
        imports: &mut ImportSection,
        _: ImportSectionReader,
    ) -> Result<(), Error> {
        let Contents {
            functions,
            tables,
            memories,
            globals,
            ..
        } = self.contents;
        let mut import = |letter: char, number: usize, kind: EntityType| {
            imports.import("first", &format!("{letter}{number}"), kind);
        };
        for function in &self.division.shared {
            import(
                'f',
                *function as usize,
                EntityType::Function(functions[*function as usize]),
            );
        }
        for (number, table) in tables.iter().enumerate() {
            import('t', number, self.table_type(*table)?.into());
        }
        import('t', tables.len(), self.division.table().into());
        for (number, memory) in memories.iter().enumerate() {
            import('m', number, self.memory_type(*memory)?.into());
        }
        for (number, global) in globals.iter().enumerate() {
            import('g', number, self.global_type(*global)?.into());
        }
        Ok(())
    }

    fn parse_function_section(
        &mut self,
        functions: &mut FunctionSection,
        _: FunctionSectionReader,
    ) -> Result<(), Error> {
        for function in &self.division.second {
            functions.function(self.contents.functions[*function as usize]);
        }
        Ok(())
    }

    fn parse_element_section(
        &mut self,
        elements: &mut ElementSection,
        _: ElementSectionReader,
    ) -> Result<(), Error> {
        let functions: Result<Vec<u32>, Error> = self
            .division
            .stubs
            .iter()
            .map(|function| self.function_index(*function))
            .collect();
        let table = self.contents.tables.len() as u32;
        elements.active(
            Some(table),
            &ConstExpr::i32_const(0),
            Elements::Functions(functions?.into()),
        );
        Ok(())
    }

    fn parse_code_section(
        &mut self,
        code: &mut CodeSection,
        _: CodeSectionReader,
    ) -> Result<(), Error> {
        for function in &self.division.second {
            let body = self.contents.body(*function).clone();
            self.parse_function_body(code, body)?;
        }
        Ok(())
    }

    fn parse_table_section(
        &mut self,
        _: &mut TableSection,
        _: TableSectionReader,
    ) -> Result<(), Error> {
        Ok(())
    }

    fn parse_memory_section(
        &mut self,
        _: &mut MemorySection,
        _: MemorySectionReader,
    ) -> Result<(), Error> {
        Ok(())
    }

    fn parse_global_section(
        &mut self,
        _: &mut GlobalSection,
        _: GlobalSectionReader,
    ) -> Result<(), Error> {
        Ok(())
    }

    fn parse_export_section(
        &mut self,
        _: &mut ExportSection,
        _: ExportSectionReader,
    ) -> Result<(), Error> {
        Ok(())
    }

    fn parse_data_section(
        &mut self,
        _: &mut DataSection,
        _: DataSectionReader,
    ) -> Result<(), Error> {
        Ok(())
    }
}
