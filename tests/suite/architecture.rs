//! The rules of docs/ARCHITECTURE.md, read off the sources: who imports whom, and what may stand where.
//!
//! A reader of text, not of Rust: paths are found by their first words, comments and strings are left out, and
//! the tests of the checker plant every violation once.

use std::fmt;
use std::path::{Path, PathBuf};

/// Modules by rank; a module imports lower ranks and itself.
const RANKS: &[(u8, &[&str])] = &[
    (0, &["limits", "diagnostic", "kernels", "threads"]),
    (1, &["expr", "numeric"]),
    (2, &["syntax", "problem", "eval", "trial", "curves"]),
    (3, &["decompose", "surface", "multisided", "features"]),
    (4, &["resolve", "method", "verify", "tessellate", "net", "fit", "morph"]),
    (5, &["blend", "emit", "export", "render"]),
];

/// Never, whatever the ranks say: importer and imported.
const FORBIDDEN: &[(&str, &str)] = &[
    ("eval", "syntax"),
    ("eval", "resolve"),
    ("trial", "syntax"),
    ("trial", "resolve"),
    ("surface", "syntax"),
    ("surface", "resolve"),
    ("export", "syntax"),
    ("export", "resolve"),
    ("verify", "method"),
];

/// Crates that belong to one place: the crate and the beginning of the paths that may name it.
const CONFINED: &[(&str, &str)] =
    &[("pest", "syntax/"), ("cranelift", "eval/jit"), ("clap", "bin/"), ("rayon", "threads.rs")];

/// Where `unsafe` may stand.
const UNSAFE: &[&str] = &["eval/jit", "kernels/"];

const EMPTY_NOUNS: &[&str] = &["util", "utils", "common", "helpers", "types", "manager", "engine", "context"];

const LONGEST_FILE: usize = 500;

/// A broken rule: file relative to src, line from 1, what is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Violation {
    file: String,
    line: usize,
    rule: String,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "src/{}:{}: {}", self.file, self.line, self.rule)
    }
}

fn rank(module: &str) -> Option<u8> {
    RANKS.iter().find(|(_, modules)| modules.contains(&module)).map(|(rank, _)| *rank)
}

/// The top-level module of a file: `eval` for `eval/jit.rs`; `None` for `lib.rs` and the binary.
fn module_of(file: &str) -> Option<&str> {
    let first = file.split('/').next().unwrap_or(file);
    let name = first.strip_suffix(".rs").unwrap_or(first);
    (!matches!(name, "lib" | "main" | "bin")).then_some(name)
}

/// `text` with comments, strings and characters blanked, line breaks kept.
fn code_only(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let skip = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if rest.starts_with("r\"") && !code.ends_with(is_word) {
            rest[2..].find('"').map_or(rest.len(), |end| end + 3)
        } else if rest.starts_with("r#\"") && !code.ends_with(is_word) {
            rest[3..].find("\"#").map_or(rest.len(), |end| end + 5)
        } else if c == '"' {
            closing_quote(rest)
        } else if c == '\'' {
            character_literal(rest)
        } else {
            0
        };
        if skip > 0 {
            code.extend(rest[..skip].chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
            rest = &rest[skip..];
        } else {
            code.push(c);
            rest = &rest[c.len_utf8()..];
        }
    }
    code
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn closing_quote(text: &str) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return at + 1,
            _ => {}
        }
    }
    text.len()
}

/// The length of `'x'` or `'\n'`; zero for a lifetime.
fn character_literal(text: &str) -> usize {
    let mut letters = text.char_indices().skip(1);
    match (letters.next(), letters.next()) {
        (Some((_, '\\')), Some((at, _))) => text[at + 1..].find('\'').map_or(0, |end| at + end + 2),
        (Some(_), Some((at, '\''))) => at + 1,
        _ => 0,
    }
}

/// The words after every `prefix::` in `code`, with their lines; those of a group `{a, b::c}` each.
fn paths_after(code: &str, prefix: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices(prefix) {
        if code[..at].ends_with(is_word) || code[..at].ends_with(':') {
            continue;
        }
        let line = code[..at].matches('\n').count() + 1;
        let rest = code[at + prefix.len()..].trim_start();
        let first_word = |text: &str| text.trim_start().chars().take_while(|c| is_word(*c)).collect::<String>();
        match rest.strip_prefix('{') {
            None => found.push((line, first_word(rest))),
            Some(group) => {
                let mut depth = 0_usize;
                let mut start = 0;
                for (index, c) in group.char_indices() {
                    match c {
                        '{' => depth += 1,
                        '}' if depth == 0 => {
                            found.push((line, first_word(&group[start..])));
                            break;
                        }
                        '}' => depth -= 1,
                        ',' if depth == 0 => {
                            found.push((line, first_word(&group[start..])));
                            start = index + 1;
                        }
                        _ => {}
                    }
                }
            }
        }
    }
    found.retain(|(_, word)| !word.is_empty());
    found
}

/// Lines on which `word` stands as a whole word, or begins one when `open_end`.
fn lines_with(code: &str, word: &str, open_end: bool) -> Vec<usize> {
    let hits = code.match_indices(word).filter(|(at, _)| {
        !code[..*at].ends_with(is_word) && (open_end || !code[at + word.len()..].starts_with(is_word))
    });
    hits.map(|(at, _)| code[..at].matches('\n').count() + 1).collect()
}

/// Everything wrong with one file.
fn check(file: &str, text: &str) -> Vec<Violation> {
    let code = code_only(text);
    let mut found = Vec::new();
    let mut add = |line: usize, rule: String| found.push(Violation { file: file.to_owned(), line, rule });
    if let Some(module) = module_of(file) {
        match rank(module) {
            None => add(1, format!("the module `{module}` has no rank")),
            Some(own) => {
                for (line, other) in paths_after(&code, "crate::") {
                    let is_forbidden = FORBIDDEN.contains(&(module, &other));
                    let is_allowed = other == module;
                    match rank(&other) {
                        _ if is_forbidden => add(line, format!("`{module}` must never see `{other}`")),
                        _ if is_allowed => {}
                        Some(rank) if rank < own => {}
                        Some(rank) => add(line, format!("`{module}` of rank {own} imports `{other}` of rank {rank}")),
                        None => {
                            add(line, format!("`{module}` imports `{other}`, which `lib.rs` would have to provide"))
                        }
                    }
                }
            }
        }
        for (line, word) in paths_after(&code, "trimline::") {
            add(line, format!("`{module}` imports `{word}` through lib.rs"));
        }
    }
    for &(name, place) in CONFINED {
        if !file.starts_with(place) {
            lines_with(&code, name, true)
                .into_iter()
                .for_each(|line| add(line, format!("`{name}` belongs under {place}")));
        }
    }
    for line in lines_with(&code, "unsafe", false) {
        if !UNSAFE.iter().any(|place| file.starts_with(place)) {
            add(line, format!("`unsafe` belongs in {}", UNSAFE.join(" or ")));
        } else if !only_declares(&code, line) && !is_explained(text, line) {
            add(line, "`unsafe` without a `// SAFETY:` line before it".to_owned());
        }
    }
    for part in file.split('/').map(|part| part.strip_suffix(".rs").unwrap_or(part)) {
        if EMPTY_NOUNS.contains(&part) {
            add(1, format!("`{part}` is no noun of the field"));
        }
    }
    for noun in EMPTY_NOUNS {
        for line in lines_with(&code, &format!("mod {noun}"), false) {
            add(line, format!("`{noun}` is no noun of the field"));
        }
    }
    let lines = text.lines().count();
    if lines > LONGEST_FILE {
        add(lines, format!("{lines} lines are more than {LONGEST_FILE}"));
    }
    found
}

/// Whether `unsafe` on this line declares a function, a trait or a function pointer's type, which runs nothing: the
/// compiler is told to ask for a block of its own for each call in the function's body.
fn only_declares(code: &str, line: usize) -> bool {
    let line = code.lines().nth(line - 1).unwrap_or("");
    line.split("unsafe").skip(1).all(|rest| {
        let rest = rest.trim_start();
        rest.starts_with("fn ") || rest.starts_with("trait ") || (rest.starts_with("extern") && rest.contains("fn("))
    })
}

/// Whether the comment right above `line`, or the statement it belongs to, says why it is safe.
fn is_explained(text: &str, line: usize) -> bool {
    let lines: Vec<&str> = text.lines().take(line).collect();
    let above = lines.iter().rev().skip(1);
    // A block may begin in the middle of a statement of a line or two.
    let mut code_lines = 0;
    for line in above {
        let line = line.trim();
        if line.starts_with("//") {
            if line.contains("SAFETY:") {
                return true;
            }
            continue;
        }
        code_lines += 1;
        if code_lines > 2 || line.ends_with(';') || line.ends_with('{') || line.ends_with('}') || line.is_empty() {
            return false;
        }
    }
    false
}

fn sources() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut pending: Vec<PathBuf> = vec![root.clone()];
    let mut found = Vec::new();
    while let Some(folder) = pending.pop() {
        for entry in std::fs::read_dir(&folder).expect("a readable folder") {
            let path = entry.expect("a readable entry").path();
            if path.is_dir() {
                pending.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let name = path.strip_prefix(&root).expect("under src").to_string_lossy().replace('\\', "/");
                found.push((name, std::fs::read_to_string(&path).expect("a text")));
            }
        }
    }
    found.sort();
    found
}

#[test]
fn sources_follow_the_rules_of_the_architecture() {
    let sources = sources();
    assert!(sources.len() > 50, "{}", sources.len());
    let found: Vec<String> =
        sources.iter().flat_map(|(file, text)| check(file, text)).map(|violation| violation.to_string()).collect();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

#[test]
fn every_module_of_the_library_has_a_rank() {
    let lib = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).expect("lib.rs");
    let code = code_only(&lib);
    let modules: Vec<&str> =
        code.lines().filter_map(|line| line.trim().strip_prefix("pub mod ")?.strip_suffix(';')).collect();
    assert!(modules.len() >= 15, "{modules:?}");
    for module in modules {
        assert!(rank(module).is_some(), "{module}");
    }
}

#[test]
fn library_without_default_features_has_no_dependency_of_the_command_line() {
    let manifest =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml")).expect("a manifest");
    for name in [
        "clap",
        "annotate-snippets",
        "anstream",
        "indicatif",
        "csv",
        "cranelift-jit",
        "gif",
        "npyz",
        "png",
        "quick-xml",
        "rayon",
        "zip",
    ] {
        let line = manifest.lines().find(|line| line.starts_with(&format!("{name} = "))).expect("a dependency");
        assert!(line.contains("optional = true"), "{line}");
    }
}

/// Checks a planted file and gives what is said about it.
fn rules(file: &str, text: &str) -> Vec<String> {
    check(file, text).into_iter().map(|violation| format!("{}: {}", violation.line, violation.rule)).collect()
}

#[test]
fn planted_import_of_a_higher_rank_is_found() {
    let expected = ["2: `expr` of rank 1 imports `method` of rank 4"];
    assert_eq!(rules("expr/graph.rs", "use crate::limits::Limits;\nuse crate::method::Options;\n"), expected);
    let grouped = "use crate::{\n    limits::Limits,\n    expr::{Graph, Node},\n    verify,\n};\n";
    assert_eq!(rules("problem/mod.rs", grouped), ["1: `problem` of rank 2 imports `verify` of rank 4"]);
    let inline = "fn f() -> crate::surface::Basis {}\n";
    assert_eq!(rules("trial/sine.rs", inline), ["1: `trial` of rank 2 imports `surface` of rank 3"]);
    assert_eq!(rules("numeric/mod.rs", "use crate::expr::Graph;").len(), 1, "same rank");
}

#[test]
fn planted_forbidden_sights_are_found() {
    for (importer, imported) in FORBIDDEN {
        let text = format!("use crate::{imported}::X;");
        let expected = format!("1: `{importer}` must never see `{imported}`");
        assert_eq!(rules(&format!("{importer}/mod.rs"), &text), [expected]);
    }
}

#[test]
fn planted_import_through_the_tour_is_found() {
    assert_eq!(rules("export/obj.rs", "use trimline::tessellate::Mesh;").len(), 1);
    assert_eq!(rules("export/obj.rs", "use crate::Mesh;").len(), 1);
    assert_eq!(rules("bin/trimline/main.rs", "use trimline::tessellate::Mesh;"), Vec::<String>::new());
}

#[test]
fn planted_crates_outside_their_place_are_found() {
    assert_eq!(rules("resolve/mod.rs", "use pest::Parser;"), ["1: `pest` belongs under syntax/"]);
    assert_eq!(rules("eval/mod.rs", "\nuse cranelift_jit::JITModule;"), ["2: `cranelift` belongs under eval/jit"]);
    assert_eq!(rules("method/mod.rs", "#[derive(clap::Args)]"), ["1: `clap` belongs under bin/"]);
    assert!(rules("syntax/parser.rs", "#[derive(pest_derive::Parser)]").is_empty());
}

#[test]
fn planted_unsafe_is_found_unless_explained_in_the_jit() {
    assert_eq!(rules("eval/interpreter.rs", "unsafe { f() }"), ["1: `unsafe` belongs in eval/jit or kernels/"]);
    let bare = "fn f() {\n    let x = 1;\n    unsafe { g(x) }\n}";
    assert_eq!(rules("eval/jit.rs", bare), ["3: `unsafe` without a `// SAFETY:` line before it"]);
    let explained = "fn f() {\n    // SAFETY: g accepts every number.\n    unsafe { g(1) }\n}";
    assert!(rules("eval/jit.rs", explained).is_empty());
    assert!(rules("kernels/mod.rs", "unsafe trait Lanes {\n    unsafe fn load();\n}").is_empty());
    assert_eq!(rules("kernels/mod.rs", "fn f() { unsafe { g() } }").len(), 1);
    assert!(rules("eval/jit.rs", "type Entry = unsafe extern \"C\" fn(usize);").is_empty());
}

#[test]
fn planted_empty_nouns_and_long_files_are_found() {
    assert_eq!(rules("expr/util.rs", "").len(), 1);
    assert_eq!(rules("expr/mod.rs", "mod helpers;"), ["1: `helpers` is no noun of the field"]);
    assert_eq!(rules("nonsense/mod.rs", ""), ["1: the module `nonsense` has no rank"]);
    assert!(rules("expr/mod.rs", &"\n".repeat(500)).is_empty());
    assert_eq!(rules("expr/mod.rs", &"\n".repeat(501)), ["501: 501 lines are more than 500"]);
}

#[test]
fn comments_strings_and_lifetimes_are_no_violations() {
    let text = r##"// use crate::method::X; unsafe pest
/// [`crate::method`] and `clap`
fn f<'a>(x: &'a str) -> char { let _ = "unsafe \" crate::method::X"; let _ = r"pest"; let _ = r#"clap "unsafe" "#; '"' }
/* cranelift */ const C: char = '\''; const D: &str = "clap";
"##;
    assert_eq!(rules("expr/mod.rs", text), Vec::<String>::new());
    // What follows a quote in a character is code again.
    assert_eq!(rules("expr/mod.rs", "const Q: char = '\"'; use crate::method::X;").len(), 1);
}
