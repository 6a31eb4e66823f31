//! `morph from A to B by both, steps = 9`: names of patches to places, words to their meaning.

use super::reading::Reading;
use crate::diagnostic::{Code, Diagnostic};
use crate::problem::{MorphKind, MorphRequest, Patch};
use crate::syntax::ast::{Morph, Name, Setting};

/// The document's morph, if it states one that is without fault.
pub fn request(stated: &[Morph], patches: &[Patch], reading: &mut Reading<'_>) -> Option<MorphRequest> {
    let (morph, others) = stated.split_first()?;
    if let Some(other) = others.first() {
        let finding = Diagnostic::new(Code::DuplicateStatement, "a document states one morph").at(other.span);
        reading.report(finding.label(morph.span, "first stated here").hint("pairs are separated by commas"));
    }
    let found_before = reading.found.len();
    let mut pairs: Vec<[usize; 2]> = Vec::with_capacity(morph.pairs.len());
    for names in &morph.pairs {
        let places = names.each_ref().map(|name| {
            let place = place(name, patches, &pairs);
            reading.keep(place)
        });
        if let [Some(from), Some(to)] = places {
            if from == to {
                let message = format!("the patch `{}` would become itself", names[0].text);
                let finding = Diagnostic::new(Code::ShapesDiffer, message).at(names[0].span.to(names[1].span));
                reading.report(finding.hint("a morph is between two patches"));
            }
            pairs.push([from, to]);
        }
    }
    let kind = morph.by.as_ref().map(|by| {
        let known = MorphKind::ALL.iter().find(|(word, _)| *word == by.text).map(|(_, kind)| *kind);
        reading.keep(known.ok_or_else(|| {
            let message = format!("a morph is by boundary, modes or both, not by `{}`", by.text);
            Diagnostic::new(Code::UnknownSetting, message).at(by.span)
        }))
    });
    let steps = steps(&morph.settings, reading);
    (reading.found.len() == found_before).then(|| MorphRequest {
        pairs,
        kind: kind.flatten(),
        steps,
        origin: Some(morph.span),
    })
}

fn place(name: &Name, patches: &[Patch], pairs: &[[usize; 2]]) -> Result<usize, Diagnostic> {
    let Some(place) = patches.iter().position(|patch| patch.name == name.text) else {
        let known: Vec<&str> = patches.iter().map(|patch| patch.name.as_str()).collect();
        let finding = Diagnostic::new(Code::UnknownName, format!("there is no patch `{}`", name.text)).at(name.span);
        return Err(finding.hint(format!("patches: {}", known.join(", "))));
    };
    if pairs.iter().flatten().any(|taken| *taken == place) {
        let message = format!("the patch `{}` stands in the morph twice", name.text);
        return Err(Diagnostic::new(Code::DuplicateStatement, message).at(name.span));
    }
    Ok(place)
}

fn steps(settings: &[Setting], reading: &mut Reading<'_>) -> Option<usize> {
    let mut steps = None;
    for setting in settings {
        let finding = match setting.value.parse::<usize>() {
            _ if setting.key.text != "steps" => {
                let message = format!("a morph has no setting `{}`", setting.key.text);
                Diagnostic::new(Code::UnknownSetting, message).at(setting.key.span).hint("its setting: steps")
            }
            Ok(number) if number > 0 && steps.is_none() => {
                steps = Some(number);
                continue;
            }
            Ok(number) if number > 0 => {
                Diagnostic::new(Code::DuplicateStatement, "`steps` is given twice").at(setting.key.span)
            }
            _ => Diagnostic::new(Code::UnknownSetting, format!("`{}` is no number of steps", setting.value))
                .at(setting.span)
                .hint("write a whole number from 1, for example `steps = 9`"),
        };
        reading.report(finding);
    }
    steps
}
