//! The rule pages: each is the documentation of a rule and its test.
//!
//! A page `tests/rules/<id>.md` states formats (` ```json format `) and, behind them, whole tapes: ` ```tape bad `, in
//! which a line of carets marks what the rule must find, and ` ```tape good `. ` ```tape bad open ` is a tape whose
//! last line has no line end. Formats stand for all tapes that follow, up to the next format behind a tape. A rule on
//! the format itself has ` ```json bad PATH "text at fault" ` and ` ```json good ` instead.
//!
//! A rule of the family CONV is about a conversion: its tapes are converted to decimal G-code, and its decimal G-code to
//! a tape, and what that reports is looked at; that on set points has them written for another tape.
//!
//! CLDATA behind a format is posted, and what that reports is looked at: such are the pages of the family POST.
//!
//! A rule on CLDATA has ` ```cldata bad ` and ` ```cldata good `, read as a stream.
//!
//! `catalogue.csv` beside them lists every demand of the standards that was looked at, and what became of it.
//!
//! `cargo test -p nctape --test rules -- number` runs one family.

#[path = "support/page.rs"]
mod page;

use nctape::cldata::{Cldata, Options};
use nctape::convert::{Dialect, convert, from_decimal, to_decimal};
use nctape::format::{FormatDiagnostic, explain, explain_read};
use nctape::post::postprocess;
use nctape::rules::{ALL, Rule};
use nctape::{Diagnostic, Format, Language, Severity, Standard, Tape};
use page::{CldataExample, FormatExample, Page, TapeExample};
use std::collections::BTreeSet;

macro_rules! families {
    ($($test:ident: $family:literal),+ $(,)?) => {
        const FAMILIES: &[&str] = &[$($family),+];
        $(#[test] fn $test() { check_family($family); })+
    };
}

families! {
    tape: "TAPE", control: "CTRL", skip: "SKIP", sequence: "SEQ", word: "WORD", tab: "TAB", number: "NUM",
    function: "FUN", motion: "MOT", feed: "FEED", compensation: "COMP", conversion: "CONV", posting: "POST", format: "SPEC",
    cldata: "CLD",
}

#[test]
fn every_rule_has_a_page_and_every_page_a_rule() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/rules");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let pages: BTreeSet<String> = files.filter_map(|name| name.strip_suffix(".md").map(str::to_owned)).collect();
    let rules: BTreeSet<String> = ALL.iter().map(|rule| rule.id().to_owned()).collect();
    assert_eq!(pages, rules);
}

#[test]
fn ids_and_names_are_unique_and_of_a_known_family() {
    let (mut ids, mut names) = (BTreeSet::new(), BTreeSet::new());
    for rule in ALL {
        for id in rule.aliases().into_iter().chain([rule.id()]) {
            assert!(ids.insert(id), "{id} is the id of two rules");
        }
        assert!(names.insert(rule.name), "{} is the name of two rules", rule.name);
        // The pages of ROW show rows of holes, not tapes under a format: tests/rows.rs runs them.
        let tested = FAMILIES.contains(&rule.family()) || rule.family() == "ROW";
        assert!(tested, "{} is of no family that is tested", rule.id());
    }
}

/// `tests/rules/catalogue.csv` lists what the standards demand, permit or wish, each with what became of it here.
#[test]
fn the_catalogue_and_the_rules_agree() {
    let catalogue = include_str!("rules/catalogue.csv");
    let mut lines = catalogue.lines().map(fields);
    assert_eq!(lines.next().unwrap_or_default(), ["id", "standard", "clause", "severity", "state", "reason"]);
    let mut listed = BTreeSet::new();
    let mut faults = Vec::new();
    for line in lines {
        let [id, .., severity, state, reason] = &line[..] else { panic!("{line:?}") };
        let rule = ALL.iter().find(|rule| rule.id() == id);
        let alias_of = ALL.iter().find(|rule| rule.aliases().contains(&id.as_str()));
        let verdicts = |rule: &&Rule| -> Vec<_> {
            let on_tapes = Standard::ALL.iter().map(|it| rule.verdicts.under(it.0));
            on_tapes.chain([rule.verdicts.on_cldata()]).flatten().collect()
        };
        let weighs = |rule: &Rule, word: &str| verdicts(&rule).iter().any(|verdict| verdict.severity.name() == word);
        if let Some(rule) = rule.filter(|rule| !severity.split(" or ").all(|word| weighs(rule, word))) {
            faults.push(format!("{line:?}: the rule is {:?}", verdicts(rule)));
        }
        let fits = match state.strip_prefix("alias of ") {
            // Either the id of another standard's verdict, or a row that says the same as another.
            Some(other) => match alias_of {
                Some(rule) => rule.id() == other,
                None => rule.is_none() && ALL.iter().any(|rule| rule.id() == other) && !reason.is_empty(),
            },
            None => match state.as_str() {
                "rule" => rule.is_some(),
                "own" => rule.is_some() && !reason.is_empty(),
                // What no tape and no format shows is no rule, and the reason says where it is kept instead.
                "later" | "permission" | "unseen" => rule.is_none() && alias_of.is_none() && !reason.is_empty(),
                _ => false,
            },
        };
        if line.len() != 6 || !fits || !listed.insert(id.clone()) {
            faults.push(format!("{line:?}"));
        }
    }
    let ids = ALL.iter().flat_map(|rule| rule.aliases().into_iter().chain([rule.id()]));
    faults.extend(ids.filter(|id| !listed.contains(*id)).map(|id| format!("{id} is not listed")));
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// The fields of a line of comma-separated values, quoted ones too.
fn fields(line: &str) -> Vec<String> {
    let (mut fields, mut quoted) = (vec![String::new()], false);
    for character in line.chars() {
        match character {
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(String::new()),
            _ => fields.last_mut().expect("a field").push(character),
        }
    }
    fields
}

fn check_family(family: &str) {
    let mut faults = Vec::new();
    for rule in ALL.iter().filter(|rule| rule.family() == family) {
        let say = |fault: String| faults.push(format!("{}.md, {fault}", rule.id()));
        check_page(rule).into_iter().for_each(say);
    }
    assert!(faults.is_empty(), "\n\n{}\n", faults.join("\n\n"));
}

/// What is wrong with a page, or with its rule.
fn check_page(rule: &'static Rule) -> Vec<String> {
    let page = match Page::read(rule.page) {
        Ok(page) => page,
        Err(fault) => return vec![fault],
    };
    let mut faults = Vec::new();
    let title = format!("{} {}", rule.id(), rule.name);
    if page.title != title {
        faults.push(format!("line 1: the title is {:?} and should be {title:?}", page.title));
    }
    if !rule.page.contains("\n## Why a control objects\n") {
        faults.push("there is no heading \"## Why a control objects\"".to_owned());
    }
    for (standard, word, _) in Standard::ALL.iter().filter(|choice| rule.verdicts.under(choice.0).is_some()) {
        let tape = |bad| page.tapes.iter().any(|tape| tape.bad == bad && tape.is_under(*standard));
        let format = |bad| page.formats.iter().any(|it| it.fault.is_some() == bad && it.format.standard == *standard);
        if !(tape(true) && tape(false) || format(true) && format(false)) {
            faults.push(format!("there is no bad and good example for {word}"));
        }
    }
    if rule.verdicts.on_cldata().is_some() {
        let is_there = |bad: bool| page.cldata.iter().any(|example| example.marks.is_empty() != bad);
        if !(is_there(true) && is_there(false)) {
            faults.push("there is no bad and good example of CLDATA".to_owned());
        }
    }
    for example in &page.cldata {
        faults.extend(check_cldata(rule, example).into_iter().map(|fault| format!("line {}: {fault}", example.line)));
    }
    for tape in &page.tapes {
        for under in &tape.formats {
            let place = format!("line {}, under the format of line {}", tape.line, under.line);
            faults.extend(check_tape(rule, tape, under).into_iter().map(|fault| format!("{place}: {fault}")));
        }
    }
    for example in &page.formats {
        faults.extend(check_format(rule, example).into_iter().map(|fault| format!("line {}: {fault}", example.line)));
    }
    faults
}

impl TapeExample {
    fn is_under(&self, standard: Standard) -> bool {
        self.formats.iter().any(|example| example.format.standard == standard)
    }
}

fn check_tape(rule: &'static Rule, example: &TapeExample, under: &FormatExample) -> Vec<String> {
    let mut faults: Vec<String> =
        judge(under).iter().filter(|found| weighs(&found.diagnostic)).map(told_of_format).collect();
    let all = found_in(rule, example.cldata, &example.text, &under.format);
    let (own, others): (Vec<_>, Vec<_>) = all.iter().partition(|found| found.rule.name == rule.name);
    faults.extend(others.iter().filter(|found| weighs(found)).map(|found| told(found, &example.text)));
    if !example.bad || own.len() != example.marks.len() {
        faults.extend(own.iter().map(|found| told(found, &example.text)));
        if example.bad {
            faults.push(format!("the rule is found {} times, {} places are marked", own.len(), example.marks.len()));
        }
        return faults;
    }
    let verdict = rule.verdicts.under(under.format.standard);
    for (found, mark) in own.iter().zip(&example.marks) {
        // Where a finding runs over the line end, carets cannot follow it: its start is enough.
        let ends = found.range.end == mark.range.end || found.range.end > mark.line_end;
        if found.range.start != mark.range.start || !ends {
            faults.push(format!(
                "{:?} is marked, but {}",
                &example.text[mark.range.clone()],
                told(found, &example.text)
            ));
        }
        if verdict.is_none_or(|verdict| (verdict.id, verdict.severity) != (found.id, found.severity)) {
            faults.push(format!("the verdict is {verdict:?}, but {}", told(found, &example.text)));
        }
        for fix in &found.fixes {
            let (text, format) = fixed(fix, &example.text, &under.format);
            if fix.language == Some(Language::Cldata) {
                let left = Cldata::new(&text, &Options::default());
                let left = left.diagnostics().iter().filter(|found| weighs(found));
                faults.extend(left.map(|found| format!("the fix {:?} leads to {}", fix.title, told(found, &text))));
                continue;
            }
            let weight = |found: &[Diagnostic]| -> usize {
                found.iter().filter(|found| found.rule.name == rule.name).map(|found| found.count).sum()
            };
            let after = found_in(rule, example.cldata, &text, &format);
            let new = after.iter().filter(|found| weighs(found) && found.rule.name != rule.name);
            if weight(&after) >= weight(&all) {
                faults.push(format!("the fix {:?} does not remove the finding; it gives {text:?}", fix.title));
            }
            faults.extend(new.map(|found| format!("the fix {:?} leads to {}", fix.title, told(found, &text))));
        }
    }
    faults
}

/// What is found in a tape: by checking it, or by converting it where the rule is of that; from decimal G-code, where
/// that is what the text is; CLDATA by posting it.
fn found_in(rule: &Rule, cldata: bool, text: &str, format: &Format) -> Vec<Diagnostic> {
    if cldata {
        return postprocess(text, format).diagnostics;
    }
    let found = Tape::new(text, format).diagnostics();
    match rule.family() {
        // Another control whose format differs in nothing but where the tool stands.
        "CONV" if rule.name == "other-set-point" => {
            let mut to = format.clone();
            to.itemized.set_point = None;
            convert(text, format, &to).diagnostics
        }
        "CONV" if found.iter().any(|found| found.rule.name == "decimal-sign") => from_decimal(text, format).diagnostics,
        "CONV" => to_decimal(text, format, Dialect::LinuxCnc).diagnostics,
        _ => found,
    }
}

fn check_cldata(rule: &'static Rule, example: &CldataExample) -> Vec<String> {
    let read = |text: &str| Cldata::new(text, &Options::default());
    let cldata = read(&example.text);
    let (own, others): (Vec<_>, Vec<_>) = cldata.diagnostics().iter().partition(|found| found.rule.name == rule.name);
    let mut faults: Vec<String> =
        others.iter().filter(|found| weighs(found)).map(|found| told(found, &example.text)).collect();
    if own.len() != example.marks.len() {
        faults.extend(own.iter().map(|found| told(found, &example.text)));
        faults.push(format!("the rule is found {} times, {} places are marked", own.len(), example.marks.len()));
        return faults;
    }
    for (found, mark) in own.iter().zip(&example.marks) {
        let ends = found.range.end == mark.range.end || found.range.end > mark.line_end;
        if found.range.start != mark.range.start || !ends {
            let marked = &example.text[mark.range.clone()];
            faults.push(format!("{marked:?} is marked, but {}", told(found, &example.text)));
        }
        // Some rules weigh less where the standard's own clause is not public.
        let verdict = rule.verdicts.on_cldata();
        if verdict.is_none_or(|verdict| verdict.id != found.id || verdict.severity < found.severity) {
            faults.push(format!("the verdict is {verdict:?}, but {}", told(found, &example.text)));
        }
        for fix in &found.fixes {
            let mut text = example.text.clone();
            for edit in fix.edits.iter().rev() {
                text.replace_range(edit.range.clone(), &edit.insert);
            }
            let after = read(&text);
            let weight = |cldata: &Cldata| -> usize {
                cldata.diagnostics().iter().filter(|found| found.rule.name == rule.name).map(|found| found.count).sum()
            };
            if weight(&after) >= weight(&cldata) {
                faults.push(format!("the fix {:?} does not remove the finding; it gives {text:?}", fix.title));
            }
            let new = after.diagnostics().iter().filter(|found| weighs(found) && found.rule.name != rule.name);
            faults.extend(new.map(|found| format!("the fix {:?} leads to {}", fix.title, told(found, &text))));
        }
    }
    faults
}

fn check_format(rule: &'static Rule, example: &FormatExample) -> Vec<String> {
    let found = judge(example);
    let (own, others): (Vec<_>, Vec<_>) = found.iter().partition(|found| found.diagnostic.rule.name == rule.name);
    let mut faults: Vec<String> =
        others.iter().filter(|found| weighs(&found.diagnostic)).map(|found| told_of_format(found)).collect();
    let (Some((path, marked)), [only]) = (&example.fault, &own[..]) else {
        faults.extend(own.iter().map(|found| told_of_format(found)));
        if example.fault.is_some() {
            faults.push(format!("the rule is found {} times", own.len()));
        }
        return faults;
    };
    if (&only.path, text_at_fault(only)) != (path, marked.as_str()) {
        faults.push(format!("{path} {marked:?} is marked, but {}", told_of_format(only)));
    }
    let verdict = rule.verdicts.under(example.format.standard);
    if verdict.is_none_or(|verdict| (verdict.id, verdict.severity) != (only.diagnostic.id, only.diagnostic.severity)) {
        faults.push(format!("the verdict is {verdict:?}, but {}", told_of_format(only)));
    }
    for fix in &only.diagnostic.fixes {
        let (_, format) = fixed(fix, "", &example.format);
        let left = explain(&format).diagnostics;
        if left.iter().any(|found| found.diagnostic.rule.name == rule.name || weighs(&found.diagnostic)) {
            faults.push(format!("the fix {:?} does not mend the format; it gives {format:?}", fix.title));
        }
    }
    faults
}

/// All that is found in a format, while reading it and after.
fn judge(example: &FormatExample) -> Vec<FormatDiagnostic> {
    explain_read(&example.format, &example.problems).diagnostics
}

/// A tape and its format after a fix.
fn fixed(fix: &nctape::diagnostic::Fix, text: &str, format: &Format) -> (String, Format) {
    let mut text = text.to_owned();
    for edit in fix.edits.iter().rev() {
        text.replace_range(edit.range.clone(), &edit.insert);
    }
    (text, fix.format.as_deref().unwrap_or(format).clone())
}

fn weighs(found: &Diagnostic) -> bool {
    found.severity >= Severity::Warning
}

fn told(found: &Diagnostic, text: &str) -> String {
    let line = text[..found.range.start].matches('\n').count() + 1;
    let at = &text[found.range.clone()];
    format!("{} ({}) is found at {at:?} in line {line} of the tape: {}", found.id, found.severity.name(), found.message)
}

fn told_of_format(found: &FormatDiagnostic) -> String {
    let (path, at, found) = (&found.path, text_at_fault(found), &found.diagnostic);
    format!("{} ({}) is found at {at:?} in {path} of the format: {}", found.id, found.severity.name(), found.message)
}

/// The part of a field's text that a finding speaks of; empty where the field is no text.
fn text_at_fault(found: &FormatDiagnostic) -> &str {
    found.text.get(found.diagnostic.range.clone()).unwrap_or("a place outside the text")
}
