//! Standard surfaces: definitions in the language itself, read when a document uses their names.

use rustc_hash::FxHashSet;

use super::declarations;
use super::reading::Reading;
use super::scope::Scope;
use crate::diagnostic::Source;
use crate::syntax::ast::Tree;
use crate::syntax::parse;

/// One definition on each line.
const TEXT: &str = include_str!("../../grammar/prelude.trim");

/// Makes the standard surfaces that `tree` names known in `scope`.
pub fn provide(tree: &Tree, scope: &mut Scope<'_>, reading: &mut Reading<'_>) {
    let used: FxHashSet<&str> = tree.names().collect();
    let wanted: Vec<&str> = TEXT.lines().filter(|line| name_of(line).is_some_and(|name| used.contains(name))).collect();
    if wanted.is_empty() {
        return;
    }
    // Checked by a test: the text is without fault.
    let Ok(document) = parse(&Source::new("prelude", wanted.join("\n")), reading.limits) else { return };
    let mut own = Reading::new(&document.tree, std::mem::take(&mut reading.graph), reading.limits);
    for definition in &document.shared.definitions {
        let meaning = declarations::meaning(definition, scope, &mut own);
        scope.provide(&definition.name.text, meaning);
    }
    reading.graph = own.graph;
    own.found.into_iter().for_each(|finding| reading.report(finding));
}

/// The name that a line of the text defines.
fn name_of(line: &str) -> Option<&str> {
    line.strip_prefix("let ")?.split('(').next()
}
