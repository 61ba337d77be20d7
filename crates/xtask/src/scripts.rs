//! The scripts of the built page, put together: all of the first view into one, and into one each what
//! is loaded later together. In `www/` every module stays a file of its own.
//!
//! Modules find each other by bare names (`assur/…`). A script that is imported by `import(…)` keeps
//! its name and its exports; what several of those share goes into a script that all of them import.
//! Every name of the top of a module gets the module's number, so no two modules mean the same name.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result, bail};
use oxc_allocator::Allocator;
use oxc_ast::ast::{Program, Statement};
use oxc_codegen::Codegen;
use oxc_parser::{Parser, ParserReturn};
use oxc_semantic::SemanticBuilder;
use oxc_span::SourceType;
use oxc_syntax::module_record::{ExportExportName, ImportImportName, ModuleRecord};

use crate::bundle::PREFIX;

/// Scripts by their paths from the root of the page.
pub(crate) type Sources = BTreeMap<String, String>;

/// Puts scripts together, `first` and all that it imports into the script of its name. Scripts that no
/// other imports stay as they are.
pub(crate) fn join(sources: &Sources, first: &str) -> Result<Sources> {
    let modules = sources.iter().enumerate().map(|(number, (name, source))| {
        let module = Module::read(number, name, source, sources);
        Ok((name.as_str(), module.with_context(|| name.clone())?))
    });
    let modules = Modules(modules.collect::<Result<_>>()?);
    let chunks = modules.chunks(first)?;
    let mut joined = Sources::new();
    for (name, members) in &chunks {
        joined.insert((*name).to_owned(), modules.chunk(name, members, &chunks)?);
    }
    let reached: BTreeSet<&str> = chunks.values().flatten().copied().collect();
    for (name, source) in sources {
        if !reached.contains(name.as_str()) {
            if !modules.0[name.as_str()].requests.is_empty() {
                bail!("{name} is imported by no other script");
            }
            joined.insert(name.clone(), source.clone());
        }
    }
    Ok(joined)
}

/// What a module takes and gives.
struct Module<'a> {
    number: usize,
    source: &'a str,
    /// The modules that it imports, in order.
    requests: Vec<&'a str>,
    /// Of each name that it imports: its own name for it, the module, the module's.
    imports: Vec<(String, &'a str, String)>,
    /// Its own names for what it exports.
    exports: BTreeMap<String, String>,
    /// The modules that it imports later.
    later: BTreeSet<&'a str>,
}

impl<'a> Module<'a> {
    fn read(number: usize, name: &str, source: &'a str, sources: &'a Sources) -> Result<Self> {
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
    fn unique(&self, name: &str) -> String {
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

struct Modules<'a>(BTreeMap<&'a str, Module<'a>>);

/// The modules of each script, in the order in which they run.
type Chunks<'a> = BTreeMap<&'a str, Vec<&'a str>>;

impl<'a> Modules<'a> {
    /// Which modules come into which script.
    fn chunks(&self, first: &str) -> Result<Chunks<'a>> {
        let (first, _) = self
            .0
            .get_key_value(first)
            .with_context(|| format!("there is no {first}"))?;
        let early: Vec<&str> = self.reached(first);
        // Who has to have a module before it runs: the first view, else the scripts that are loaded later.
        let mut needed: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        let mut order = early.clone();
        let mut entries = vec![*first];
        let mut at = 0;
        while let Some(entry) = entries.get(at).copied() {
            at += 1;
            for module in self.reached(entry) {
                if !order.contains(&module) {
                    order.push(module);
                }
                let by = if early.contains(&module) {
                    first
                } else {
                    entry
                };
                needed.entry(module).or_default().insert(by);
                for later in &self.0[module].later {
                    if !entries.contains(later) && !early.contains(later) {
                        entries.push(later);
                    }
                }
            }
        }
        let mut groups: BTreeMap<&BTreeSet<&str>, Vec<&'a str>> = BTreeMap::new();
        for module in order {
            groups.entry(&needed[module]).or_default().push(module);
        }
        let mut chunks = Chunks::new();
        for members in groups.into_values() {
            let own: Vec<_> = members
                .iter()
                .filter(|member| entries.contains(member))
                .collect();
            let name = match own[..] {
                [] => members[0],
                [one] => one,
                [one, two, ..] => bail!("{one} and {two} are always loaded together"),
            };
            chunks.insert(name, members);
        }
        Ok(chunks)
    }

    /// A module and all that has to run before it, in the order in which they run.
    fn reached(&self, entry: &'a str) -> Vec<&'a str> {
        fn visit<'a>(
            modules: &Modules<'a>,
            name: &'a str,
            seen: &mut BTreeSet<&'a str>,
            order: &mut Vec<&'a str>,
        ) {
            if seen.insert(name) {
                for request in &modules.0[name].requests {
                    visit(modules, request, seen, order);
                }
                order.push(name);
            }
        }
        let mut order = Vec::new();
        visit(self, entry, &mut BTreeSet::new(), &mut order);
        order
    }

    /// The text of one script.
    fn chunk(&self, name: &str, members: &[&str], chunks: &Chunks<'_>) -> Result<String> {
        let elsewhere = |module: &str| {
            let mut others = chunks.iter().filter(|(other, _)| **other != name);
            others.find_map(|(other, members)| members.contains(&module).then_some(*other))
        };
        let mut taken: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
        let mut text = String::new();
        for member in members {
            let module = &self.0[member];
            let mut names = BTreeMap::new();
            for (own, from, theirs) in &module.imports {
                let unique = self.exported(member, from, theirs)?;
                if let Some(other) = elsewhere(from) {
                    taken.entry(other).or_default().insert(unique.clone());
                }
                names.insert(own.as_str(), unique);
            }
            for request in &module.requests {
                if let Some(other) = elsewhere(request) {
                    taken.entry(other).or_default();
                }
            }
            text += &module.renamed(member, &names)?;
        }
        let mut given: BTreeSet<String> = BTreeSet::new();
        for others in chunks
            .iter()
            .filter(|(other, _)| **other != name)
            .map(|(_, others)| others)
        {
            for other in others {
                for (_, from, theirs) in &self.0[other].imports {
                    if members.contains(from) {
                        given.insert(self.exported(other, from, theirs)?);
                    }
                }
            }
        }
        if let Some(entry) = self.0.get(name) {
            let own = entry.exports.iter();
            given.extend(own.map(|(given, own)| format!("{} as {given}", entry.unique(own))));
        }
        let imports = taken.iter().map(|(other, names)| {
            format!("import {{ {} }} from \"{PREFIX}{other}\";\n", listed(names))
        });
        Ok(format!(
            "{}{text}export {{ {} }};\n",
            imports.collect::<String>(),
            listed(&given)
        ))
    }

    /// The unique name of what a module exports.
    fn exported(&self, importer: &str, from: &str, name: &str) -> Result<String> {
        let module = &self.0[from];
        let own = module.exports.get(name);
        let own = own
            .with_context(|| format!("{importer} imports {name}, which {from} does not export"))?;
        Ok(module.unique(own))
    }
}

fn listed(names: &BTreeSet<String>) -> String {
    names
        .iter()
        .map(String::as_str)
        .collect::<Vec<_>>()
        .join(", ")
}

impl Module<'_> {
    /// The module's text without imports from scripts and without the word `export`, the names of its
    /// top those of `names`, else unique.
    fn renamed(&self, name: &str, names: &BTreeMap<&str, String>) -> Result<String> {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn joined(scripts: &[(&str, &str)]) -> Result<Sources> {
        let sources = scripts.iter();
        let sources = sources.map(|(name, text)| ((*name).to_owned(), (*text).to_owned()));
        join(&sources.collect(), "app/main.js")
    }

    /// Without free space.
    fn dense(text: &str) -> String {
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn modules_of_one_script_keep_their_order_and_their_names_apart() {
        let scripts = [
            (
                "app/main.js",
                "import { one as first } from \"assur/one.js\";\nimport init, * as engine from \"assur/pkg/engine.js\";\nconst two = { first, one: (one) => one + first };\ninit(two, engine);\n",
            ),
            (
                "one.js",
                "export const one = 1;\nconst two = one;\nexport function three() { return two; }\n",
            ),
        ];
        let joined = joined(&scripts).unwrap();
        assert_eq!(joined.keys().collect::<Vec<_>>(), ["app/main.js"]);
        assert_eq!(
            dense(&joined["app/main.js"]),
            "const one$1 = 1; const two$1 = one$1; function three$1() { return two$1; } \
             import init$0, * as engine$0 from \"assur/pkg/engine.js\"; \
             const two$0 = { first: one$1, one: (one) => one + one$1 }; init$0(two$0, engine$0); export { };"
        );
    }

    #[test]
    fn what_is_loaded_later_stays_apart_and_shares() {
        let scripts = [
            (
                "app/main.js",
                "import { a } from \"assur/a.js\";\nimport(\"assur/late.js\");\nimport(`assur/part/${a}.js`);\n",
            ),
            ("a.js", "export const a = 1;\n"),
            (
                "late.js",
                "import { a } from \"assur/a.js\";\nimport \"assur/shared.js\";\nexport const late = a;\n",
            ),
            (
                "part/x.js",
                "import { shared } from \"assur/shared.js\";\nexport const x = shared;\n",
            ),
            ("part/worker.ts", "none of ours"),
            ("shared.js", "export const shared = await 2;\n"),
            ("worker.js", "postMessage(1);\n"),
        ];
        let scripts = scripts.iter().filter(|(name, _)| name.ends_with(".js"));
        let joined = joined(&scripts.copied().collect::<Vec<_>>()).unwrap();
        let names: Vec<&str> = joined.keys().map(String::as_str).collect();
        assert_eq!(
            names,
            [
                "app/main.js",
                "late.js",
                "part/x.js",
                "shared.js",
                "worker.js"
            ]
        );
        assert!(
            joined["app/main.js"].ends_with("export { a$0 };\n"),
            "{}",
            joined["app/main.js"]
        );
        assert_eq!(
            dense(&joined["late.js"]),
            "import { a$0 } from \"assur/app/main.js\"; import { } from \"assur/shared.js\"; \
             const late$2 = a$0; export { late$2 as late };"
        );
        assert_eq!(
            dense(&joined["part/x.js"]),
            "import { shared$4 } from \"assur/shared.js\"; const x$3 = shared$4; export { x$3 as x };"
        );
        assert_eq!(joined["worker.js"], "postMessage(1);\n");
    }

    #[test]
    fn what_cannot_be_put_together_is_a_sentence() {
        for (script, sentence) in [
            (
                "import { b } from \"assur/a.js\";",
                "imports b, which a.js does not export",
            ),
            (
                "import * as a from \"assur/a.js\";",
                "all of a.js by one name",
            ),
            ("export default 1;", "a default export"),
            ("export * from \"assur/a.js\";", "exports what it imports"),
            ("const = 1;", "is no module"),
        ] {
            let error = joined(&[("app/main.js", script), ("a.js", "export const a = 1;")]);
            let error = format!("{:#}", error.unwrap_err());
            assert!(error.contains(sentence), "{error}");
        }
        let lost = [
            ("app/main.js", ""),
            ("a.js", ""),
            ("b.js", "import \"assur/a.js\";"),
        ];
        let error = joined(&lost).unwrap_err().to_string();
        assert!(
            error.contains("b.js is imported by no other script"),
            "{error}"
        );
    }
}
