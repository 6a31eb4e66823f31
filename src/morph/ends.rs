//! The two shapes of `morph from A to B` in one document.

use crate::problem::{Patch, PatchCopy, Problem};

/// Source and target of a problem that states a morph; `None` of one that does not.
///
/// A patch that becomes another has in both shapes the name of the one it comes from; patches in no pair are in both, and so
/// are nets and copies: copies of a source follow it, and those of a target, which is no patch of either shape, are left out.
#[must_use]
pub fn ends(problem: &Problem) -> Option<[Problem; 2]> {
    let request = problem.morph.as_ref()?;
    let shape = |which: usize| {
        let mut patches = Vec::new();
        for (index, patch) in problem.patches.iter().enumerate() {
            let pair = request.pairs.iter().find(|pair| pair.contains(&index));
            match pair {
                None => patches.push(patch.clone()),
                // In the order of the sources, so that both shapes have their patches in the same order.
                Some([from, _]) if *from == index => {
                    let end = pair.and_then(|pair| pair.get(which)).and_then(|place| problem.patches.get(*place));
                    patches.extend(end.map(|end| Patch { name: patch.name.clone(), ..end.clone() }));
                }
                Some(_) => {}
            }
        }
        let place = |original: usize| match problem.patches.get(original) {
            Some(patch) => patches.iter().position(|known| known.name == patch.name),
            None => original.checked_sub(problem.patches.len()).map(|net| patches.len() + net),
        };
        let copy = |copy: &PatchCopy| Some(PatchCopy { original: place(copy.original)?, ..copy.clone() });
        let copies = problem.copies.iter().filter_map(copy).collect();
        // Seams name patches by their places in the document, which mean nothing in a shape.
        Problem { patches, copies, seams: Vec::new(), morph: None, ..problem.clone() }
    };
    Some([shape(0), shape(1)])
}
