//! One module: what it takes, what it gives, and its text with other names.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Result, bail};
use oxc_allocator::Allocator;
use oxc_ast::ast::{Program, Statement};
use oxc_codegen::Codegen;
use oxc_parser::{Parser, ParserReturn};
use oxc_semantic::SemanticBuilder;
use oxc_span::SourceType;
use oxc_syntax::module_record::{ExportExportName, ImportImportName, ModuleRecord};

use super::Sources;
use crate::bundle::PREFIX;

/// What a module takes and gives.
pub(super) struct Module<'a> {
    number: usize,
    source: &'a str,
    /// The modules that it imports, in order.
    pub(super) requests: Vec<&'a str>,
    /// Of each name that it imports: its own name for it, the module, the module's.
    pub(super) imports: Vec<(String, &'a str, String)>,
    /// Its own names for what it exports.
    pub(super) exports: BTreeMap<String, String>,
    /// The modules that it imports later.
    pub(super) later: BTreeSet<&'a str>,
}

impl<'a> Module<'a> {
    pub(super) fn read(
        number: usize,
        name: &str,
        source: &'a str,
        sources: &'a Sources,
    ) -> Result<Self> {
        let allocator = Allocator::default();
        let ParserReturn { module_record, .. } = parsed(&allocator, name, source)?;
        Self::of(number, source, &module_record, sources)
    }

    fn of(
        number: usize,
        source: &'a str,
        record: &ModuleRecord<'_>,
        sources: &'a Sources,
    ) -> Result<Self> {
        if !record.indirect_export_entries.is_empty() || !record.star_export_entries.is_empty() {
            bail!("it exports what it imports: import that where it is");
        }
        let mut requests: Vec<_> = record.requested_modules.iter().collect();
        requests
            .sort_by_key(|(_, places)| places.iter().map(|place| place.statement_span.start).min());
        let requests = requests
            .iter()
            .filter_map(|(request, _)| script(request, sources));
        let mut imports = Vec::new();
        for entry in &record.import_entries {
            let Some(from) = script(&entry.module_request.name, sources) else {
                continue;
            };
            let ImportImportName::Name(theirs) = &entry.import_name else {
                bail!("it imports all of {from} by one name: import what is needed by its name");
            };
            imports.push((
                entry.local_name.name.to_string(),
                from,
                theirs.name.to_string(),
            ));
        }
        let mut exports = BTreeMap::new();
        for entry in &record.local_export_entries {
            let (ExportExportName::Name(given), Some(own)) =
                (&entry.export_name, entry.local_name.name())
            else {
                bail!("it has a default export: give it a name");
            };
            exports.insert(given.name.to_string(), own.to_string());
        }
        let dynamic = record.dynamic_imports.iter();
        let later =
            dynamic.flat_map(|import| meant(import.module_request.source_text(source), sources));
        Ok(Self {
            number,
            source,
            requests: requests.collect(),
            imports,
            exports,
            later: later.collect(),
        })
    }

    /// The name that a name of the top of the module has wherever it is put.
    pub(super) fn unique(&self, name: &str) -> String {
        format!("{name}${}", self.number)
    }
}

/// The script of ours that a module is imported by.
fn script<'a>(request: &str, sources: &'a Sources) -> Option<&'a str> {
    let (name, _) = sources.get_key_value(request.strip_prefix(PREFIX)?)?;
    Some(name)
}

/// The scripts that the argument of `import(…)` may mean: a name, or one with a place for a part of it.
fn meant<'a>(argument: &str, sources: &'a Sources) -> Vec<&'a str> {
    let argument = argument.trim_matches(['"', '\'', '`']);
    match argument.split_once("${") {
        None => script(argument, sources).into_iter().collect(),
        Some((start, rest)) => {
            let end = rest.split_once('}').map_or("", |(_, end)| end);
            let start = start.strip_prefix(PREFIX).unwrap_or(start);
            let names = sources.keys().map(String::as_str);
            names
                .filter(|name| name.starts_with(start) && name.ends_with(end))
                .collect()
        }
    }
}

fn parsed<'a>(allocator: &'a Allocator, name: &str, source: &'a str) -> Result<ParserReturn<'a>> {
    let parsed = Parser::new(allocator, source, SourceType::mjs()).parse();
    match parsed.errors.first() {
        Some(error) => bail!("{name} is no module: {error}"),
        None => Ok(parsed),
    }
}

impl Module<'_> {
    /// The module's text without imports from scripts and without the word `export`, the names of its
    /// top those of `names`, else unique.
    pub(super) fn renamed(&self, name: &str, names: &BTreeMap<&str, String>) -> Result<String> {
        let allocator = Allocator::default();
        let mut program = parsed(&allocator, name, self.source)?.program;
        let mut scoping = SemanticBuilder::new()
            .build(&program)
            .semantic
            .into_scoping();
        let root = scoping.root_scope_id();
        let top: Vec<_> = scoping.iter_bindings_in(root).collect();
        for symbol in top {
            let own = scoping.symbol_name(symbol);
            let unique = names.get(own).cloned().unwrap_or_else(|| self.unique(own));
            scoping.set_symbol_name(symbol, &unique);
        }
        bare(&allocator, &mut program, &self.requests);
        Ok(Codegen::new()
            .with_scoping(Some(scoping))
            .build(&program)
            .code)
    }
}

/// Takes imports from scripts and the word `export` away.
fn bare<'a>(allocator: &'a Allocator, program: &mut Program<'a>, requests: &[&str]) {
    let statements = std::mem::replace(&mut program.body, oxc_allocator::Vec::new_in(allocator));
    for statement in statements {
        match statement {
            Statement::ImportDeclaration(import)
                if import
                    .source
                    .value
                    .strip_prefix(PREFIX)
                    .is_some_and(|name| requests.contains(&name)) => {}
            Statement::ExportNamedDeclaration(export) => {
                program
                    .body
                    .extend(export.unbox().declaration.map(Statement::from));
            }
            other => program.body.push(other),
        }
    }
}
