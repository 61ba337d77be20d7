//! Smaller scripts and style sheet for the built page: it is read by browsers, `www/` by people.

use anyhow::{Context, Result, bail};
use oxc_allocator::Allocator;
use oxc_codegen::{Codegen, CodegenOptions};
use oxc_minifier::{CompressOptions, MangleOptions, Minifier, MinifierOptions};
use oxc_parser::Parser;
use oxc_span::SourceType;

/// A module without comments and free space, in fewer statements, its private names short. What it exports and imports
/// keeps its name, so modules stay separate files.
pub(crate) fn module(name: &str, source: &str) -> Result<String> {
    let allocator = Allocator::default();
    let mut parsed = Parser::new(&allocator, source, SourceType::mjs()).parse();
    if let Some(error) = parsed.errors.first() {
        bail!("{name} is no module: {error}");
    }
    let minifier = Minifier::new(MinifierOptions {
        mangle: Some(MangleOptions {
            top_level: true,
            ..MangleOptions::default()
        }),
        compress: Some(CompressOptions::smallest()),
    });
    let minified = minifier.minify(&allocator, &mut parsed.program);
    let codegen = Codegen::new()
        .with_options(CodegenOptions::minify())
        .with_scoping(minified.scoping)
        .with_private_member_mappings(minified.class_private_mappings);
    Ok(codegen.build(&parsed.program).code)
}

/// A style sheet without comments and indentation.
pub(crate) fn style(source: &str) -> Result<String> {
    let mut bare = String::with_capacity(source.len());
    let mut rest = source;
    while let Some((before, comment)) = rest.split_once("/*") {
        // No string of ours holds the sign of a comment; one that does is not cut in silence.
        if before.lines().last().is_some_and(within_string) {
            bail!("the style sheet has `/*` within a string");
        }
        bare.push_str(before);
        let closed = comment.split_once("*/");
        (_, rest) = closed.context("a comment of the style sheet does not end")?;
    }
    bare.push_str(rest);
    let lines = bare.lines().map(str::trim).filter(|line| !line.is_empty());
    Ok(lines.collect::<Vec<_>>().join("\n"))
}

/// Whether a string of this line has not ended.
fn within_string(line: &str) -> bool {
    ['"', '\'']
        .iter()
        .any(|quote| line.matches(*quote).count() % 2 == 1)
}

#[cfg(test)]
mod tests {
    use super::{module, style};

    #[test]
    fn a_module_says_the_same_in_less() {
        for (source, small) in [
            (
                "// Counts.\nimport { one } from \"assur/one.js\";\n/** Two. */\nexport const two = one + one;\n",
                "import{one as e}from\"assur/one.js\";export const two=e+e;",
            ),
            (
                "export class Box {\n  #inside = 1;\n  get() {\n    return this.#inside;\n  }\n}\n",
                "export class Box{#e=1;get(){return this.#e}}",
            ),
            (
                "export const pattern = (a) => a.replace(/[/*\"']+\\/\\//gu, \"//\") / 2 / 3;",
                "export const pattern=e=>e.replace(/[/*\"']+\\/\\//gu,`//`)/2/3;",
            ),
            (
                "export const text = (a) => `/* ${a /* b */}  // \n  c`;",
                "export const text=e=>`/* ${e}  // \n  c`;",
            ),
            (
                "export const pick = (a) => {\n  if (a) return 1;\n  return 2;\n};",
                "export const pick=e=>e?1:2;",
            ),
            (
                "export const late = () => import(\"assur/late.js\");",
                "export const late=()=>import(`assur/late.js`);",
            ),
        ] {
            assert_eq!(module("a.js", source).unwrap(), small);
        }
    }

    #[test]
    fn what_is_no_module_is_named() {
        let error = module("a.js", "export const = 1;").unwrap_err();
        assert!(error.to_string().starts_with("a.js is no module: "));
    }

    #[test]
    fn a_style_sheet_keeps_its_rules() {
        let source = "/* Page. */\nbody {\n  color: red; /* \"so\" */\n\n  a::before { content: \"/ *\"; }\n}\n";
        let expected = "body {\ncolor: red;\na::before { content: \"/ *\"; }\n}";
        assert_eq!(style(source).unwrap(), expected);
        assert!(style("body {} /* no end").is_err());
        assert!(style("a::before { content: \"/*\"; }").is_err());
    }
}
