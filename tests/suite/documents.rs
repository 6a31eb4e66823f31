//! The documentation says what the code does.

use trimline::diagnostic::Code;

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
