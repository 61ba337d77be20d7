//! The scripts of the built page, put together: all of the first view into one, and into one each what
//! is loaded later together. In `www/` every module stays a file of its own.
//!
//! Modules find each other by bare names (`assur/…`). A script that is imported by `import(…)` keeps
//! its name and its exports; what several of those share goes into a script that all of them import.
//! Every name of the top of a module gets the module's number, so no two modules mean the same name.

mod module;

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result, bail};

use self::module::Module;
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
        let given = self.given(name, members, chunks)?;
        let imports = taken.iter().map(|(other, names)| {
            format!("import {{ {} }} from \"{PREFIX}{other}\";\n", listed(names))
        });
        Ok(format!(
            "{}{text}export {{ {} }};\n",
            imports.collect::<String>(),
            listed(&given)
        ))
    }

    /// What a script exports: what others import of its modules, and what is loaded by its own name.
    fn given(&self, name: &str, members: &[&str], chunks: &Chunks<'_>) -> Result<BTreeSet<String>> {
        let own = self.0[name].exports.iter();
        let own = own.map(|(given, own)| format!("{} as {given}", self.0[name].unique(own)));
        let mut given: BTreeSet<String> = own.collect();
        let others = chunks.iter().filter(|(other, _)| **other != name);
        for other in others.flat_map(|(_, others)| others) {
            for (_, from, theirs) in &self.0[other].imports {
                if members.contains(from) {
                    given.insert(self.exported(other, from, theirs)?);
                }
            }
        }
        Ok(given)
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
