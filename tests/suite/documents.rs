//! The documentation says what the code does.

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostics, Source};
use trimline::expr::Notation;
use trimline::method::Options;

use crate::spec::{BOUNDARY, patch, problem, problem_within, told, with_data};

const LANGUAGE: &str = include_str!("../../docs/language.md");
const MORPHING: &str = include_str!("../../docs/morphing.md");
const TUTORIAL: &str = include_str!("../../docs/tutorial.md");

/// Specs of a page: what stands behind the word `trim` of each block, and the block.
fn specs(page: &str) -> Vec<(String, String)> {
    let mut specs = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        let Some(about) = line.strip_prefix("```trim") else { continue };
        let body: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
        let text = body.join("\n") + "\n";
        let is_complete = ["at u = ", "u &= ", "bspline "].iter().any(|words| text.contains(words));
        specs.push((about.trim().to_owned(), if is_complete { text } else { text + BOUNDARY }));
    }
    specs
}

/// Solves every patch of a text at the first instant; solutions that miss their promise are errors.
fn solve(text: &str) -> Result<(), Diagnostics> {
    let patches = problem_within(text, &Options::default().limits)?.patches.len();
    let blend = Blend::compile(&Source::new("spec", text), &Options::default())?;
    for patch in 0..patches {
        blend.solve(patch, 0.0).map_err(|finding| vec![finding])?;
    }
    for net in 0..blend.nets.len() {
        blend.fill(net, 0.0).map_err(|finding| vec![finding])?;
    }
    Ok(())
}

#[test]
fn specs_of_language_reference_tutorial_and_morphing_are_solved_or_answered_as_the_page_says() {
    for (page, fewest) in [(LANGUAGE, 12), (TUTORIAL, 6), (MORPHING, 1)] {
        let specs = specs(page);
        assert!(specs.len() >= fewest, "{}", specs.len());
        for (about, text) in specs {
            match (about.split_once(' ').filter(|_| about.starts_with('E')), solve(&text)) {
                (None, Ok(())) => {}
                (Some((code, words)), Err(found)) => {
                    let told = told(&text, &found);
                    assert!(told.contains(code) && told.contains(words), "{about}\n{text}\n{told}");
                }
                (None, Err(found)) => panic!("{text}\n{}", told(&text, &found)),
                (Some(_), Ok(())) => panic!("no finding: {about}\n{text}"),
            }
        }
    }
}

#[test]
fn expressions_of_the_language_reference_are_read_as_the_page_says() {
    const PARAMS: &str =
        "param a = 2, b = 3, b1 = 4, beta1 = 5, h0 = 6, k = 7\nlet beta = 8 v\npde d4S/du4 + d4S/dv4 = 0\n";
    let table = LANGUAGE.split("| written | read as |\n").nth(1).and_then(|rest| rest.split("\n\n").next());
    let rows: Vec<&str> = table.expect("the table of expressions").lines().skip(1).collect();
    assert!(rows.len() >= 25, "{}", rows.len());
    let text = |data: &str| format!("{PARAMS}{}", with_data(data));
    let read = |data: &str| {
        let problem = problem(&text(data));
        let value = patch(&problem).conditions[0].value[0];
        problem.graph.text(value, Notation::Ascii, 1 << 12).expect("short")
    };
    for row in rows {
        let cells: Vec<&str> = row.trim_matches(['|', ' ']).split(" | ").collect();
        let [written, meaning] = cells[..] else { panic!("{row}") };
        let written = written.trim_matches('`');
        if meaning.starts_with('E') {
            let found = problem_within(&text(written), &Options::default().limits).expect_err(written);
            assert_eq!(found[0].code.as_str(), meaning, "{row}");
        } else {
            assert_eq!(read(written), read(meaning.trim_matches('`')), "{row}");
        }
    }
}

#[test]
fn every_diagnostic_code_has_its_paragraph() {
    let page = include_str!("../../docs/diagnostics.md");
    for code in Code::ALL {
        let row = page.lines().find(|line| line.starts_with(&format!("| {code} |")));
        let row = row.unwrap_or_else(|| panic!("docs/diagnostics.md lacks {code}"));
        let class = format!("| {} |", format!("{:?}", code.class()).to_lowercase());
        assert!(row.contains(&class) && row.contains(code.summary()), "{row}");
    }
    assert_eq!(
        page.lines()
            .filter(|line| line.starts_with("| E") || line.starts_with("| W") || line.starts_with("| N"))
            .count(),
        Code::ALL.len()
    );
}

#[test]
fn codes_are_distinct() {
    let mut codes: Vec<&str> = Code::ALL.iter().map(|code| code.as_str()).collect();
    codes.sort_unstable();
    codes.dedup();
    assert_eq!(codes.len(), Code::ALL.len());
}
