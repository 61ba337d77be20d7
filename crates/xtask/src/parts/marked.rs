//! A module that marks each function when it is called.

use std::convert::Infallible;

use wasm_encoder::reencode::{Error, Reencode, utils};
use wasm_encoder::{
    CodeSection, ConstExpr, ExportKind, ExportSection, GlobalSection, GlobalType, Instruction,
    ValType,
};
use wasmparser::{ExportSectionReader, FunctionBody, GlobalSectionReader};

use super::contents::Contents;

pub(super) struct Marked<'a> {
    contents: &'a Contents<'a>,
    /// Number of the global that marks the next function.
    next: u32,
}

impl<'a> Marked<'a> {
    pub(super) fn new(contents: &'a Contents) -> Self {
        let next = contents.globals.len() as u32;
        Self { contents, next }
    }
}

impl Reencode for Marked<'_> {
    type Error = Infallible;

    fn parse_global_section(
        &mut self,
        globals: &mut GlobalSection,
        section: GlobalSectionReader,
    ) -> Result<(), Error> {
        utils::parse_global_section(self, globals, section)?;
        let mark = GlobalType {
            val_type: ValType::I32,
            mutable: true,
            shared: false,
        };
        for _ in self.contents.defined() {
            globals.global(mark, &ConstExpr::i32_const(0));
        }
        Ok(())
    }

    fn parse_export_section(
        &mut self,
        exports: &mut ExportSection,
        section: ExportSectionReader,
    ) -> Result<(), Error> {
        utils::parse_export_section(self, exports, section)?;
        for (function, global) in self
            .contents
            .defined()
            .zip(self.contents.globals.len() as u32..)
        {
            exports.export(&format!("called.{function}"), ExportKind::Global, global);
        }
        Ok(())
    }

    fn parse_function_body(
        &mut self,
        code: &mut CodeSection,
        body: FunctionBody,
    ) -> Result<(), Error> {
        let mut function = self.new_function_with_parsed_locals(&body)?;
        function.instruction(&Instruction::I32Const(1));
        function.instruction(&Instruction::GlobalSet(self.next));
        self.next += 1;
        let mut operators = body.get_operators_reader()?;
        while !operators.eof() {
            function.instruction(&self.parse_instruction(&mut operators)?);
        }
        code.function(&function);
        Ok(())
    }
}
