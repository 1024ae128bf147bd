//! What a rule is: names, verdicts, clauses and its page.

use crate::diagnostic::Severity;
use crate::format::Standard;

/// One rule. Its check stands in the same file, its page in `tests/rules`.
#[derive(Debug)]
pub struct Rule {
    /// Names the bad pattern, in lower case with hyphens.
    pub name: &'static str,
    /// What is wrong, in a few words.
    pub title: &'static str,
    /// What each standard says of it.
    pub verdicts: Verdicts,
    /// What it rests on; empty where the playground itself thought it worth saying.
    pub clauses: &'static [Clause],
    /// The page, Markdown.
    pub page: &'static str,
}

/// What one standard says of a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// The rule's id under this standard. An id is never used for anything else.
    pub id: &'static str,
    /// How much it weighs there.
    pub severity: Severity,
}

/// The verdicts of the standards; `None` where a standard has nothing against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Verdicts {
    iso2539: Option<Verdict>,
    iso1058: Option<Verdict>,
    rs274: Option<Verdict>,
    iso3592: Option<Verdict>,
}

impl Verdicts {
    /// The same verdict under every standard.
    pub const fn all(id: &'static str, severity: Severity) -> Verdicts {
        let verdict = Some(Verdict { id, severity });
        Verdicts { iso2539: verdict, iso1058: verdict, rs274: verdict, iso3592: None }
    }

    /// A verdict of ISO 2539, and so of RS-274; none of ISO 1058.
    pub const fn contouring(id: &'static str, severity: Severity) -> Verdicts {
        let verdict = Some(Verdict { id, severity });
        Verdicts { iso2539: verdict, iso1058: None, rs274: verdict, iso3592: None }
    }

    /// A verdict of ISO 1058 only.
    pub const fn positioning(id: &'static str, severity: Severity) -> Verdicts {
        Verdicts { iso2539: None, iso1058: Some(Verdict { id, severity }), rs274: None, iso3592: None }
    }

    /// A verdict of RS-274 only.
    pub const fn eia(id: &'static str, severity: Severity) -> Verdicts {
        Verdicts { iso2539: None, iso1058: None, rs274: Some(Verdict { id, severity }), iso3592: None }
    }

    /// A verdict of ISO 3592, on CLDATA; none on tapes.
    pub const fn cldata(id: &'static str, severity: Severity) -> Verdicts {
        Verdicts { iso2539: None, iso1058: None, rs274: None, iso3592: Some(Verdict { id, severity }) }
    }

    /// The same, but with another verdict of ISO 1058.
    pub const fn and_iso1058(self, id: &'static str, severity: Severity) -> Verdicts {
        Verdicts { iso1058: Some(Verdict { id, severity }), ..self }
    }

    /// The same, but weighing `severity` under RS-274.
    pub const fn rs274_as(self, severity: Severity) -> Verdicts {
        match self.rs274 {
            Some(verdict) => Verdicts { rs274: Some(Verdict { id: verdict.id, severity }), ..self },
            None => self,
        }
    }

    /// The same, but without a verdict under RS-274.
    pub const fn not_rs274(self) -> Verdicts {
        Verdicts { rs274: None, ..self }
    }

    /// The verdict of ISO 3592.
    pub const fn on_cldata(&self) -> Option<Verdict> {
        self.iso3592
    }

    /// The verdict of one standard.
    pub const fn under(&self, standard: Standard) -> Option<Verdict> {
        match standard {
            Standard::Iso2539 => self.iso2539,
            Standard::Iso1058 => self.iso1058,
            Standard::Rs274 => self.rs274,
        }
    }
}

/// A clause that a rule rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clause {
    /// The same clause number in ISO 2539 and ISO 1058.
    Both(&'static str),
    /// A clause of ISO 2539.
    Iso2539(&'static str),
    /// A clause of ISO 1058.
    Iso1058(&'static str),
    /// The tables of ISO 1056.
    Iso1056(&'static str),
    /// Y-1702 (Miskell, 1969), for RS-274.
    Y1702(&'static str),
    /// A clause of ISO 3592.
    Iso3592(&'static str),
}

impl Clause {
    /// The clause as it is cited under a standard; `None` where it says nothing there.
    ///
    /// RS-274 was not at hand: there the clauses of ISO 2539 are cited, whose verdicts it follows here.
    pub fn under(self, standard: Standard) -> Option<String> {
        match (self, standard) {
            (Clause::Both(clause), Standard::Iso1058) | (Clause::Iso1058(clause), Standard::Iso1058) => {
                Some(format!("ISO 1058 {clause}"))
            }
            (Clause::Both(clause) | Clause::Iso2539(clause), Standard::Iso2539 | Standard::Rs274) => {
                Some(format!("ISO 2539 {clause}"))
            }
            (Clause::Iso1056(clause), _) => Some(format!("ISO 1056 {clause}")),
            (Clause::Iso3592(clause), _) => Some(format!("ISO 3592 {clause}")),
            (Clause::Y1702(clause), Standard::Rs274) => Some(format!("Y-1702 {clause}")),
            _ => None,
        }
    }

    /// All citations of the clause.
    pub fn all(self) -> Vec<String> {
        match self {
            Clause::Both(clause) => vec![format!("ISO 2539 {clause}"), format!("ISO 1058 {clause}")],
            Clause::Iso2539(clause) => vec![format!("ISO 2539 {clause}")],
            Clause::Iso1058(clause) => vec![format!("ISO 1058 {clause}")],
            Clause::Iso1056(clause) => vec![format!("ISO 1056 {clause}")],
            Clause::Iso3592(clause) => vec![format!("ISO 3592 {clause}")],
            Clause::Y1702(clause) => vec![format!("Y-1702 {clause}")],
        }
    }
}

impl Rule {
    /// The id by which the rule is listed: that of the first standard with a verdict.
    pub fn id(&self) -> &'static str {
        self.ids().next().unwrap_or("")
    }

    /// The ids under the other standards, where they differ.
    pub fn aliases(&self) -> Vec<&'static str> {
        let id = self.id();
        let mut aliases: Vec<&'static str> = self.ids().filter(|alias| *alias != id).collect();
        aliases.dedup();
        aliases
    }

    /// The family: the letters of the id.
    pub fn family(&self) -> &'static str {
        self.id().split('-').next().unwrap_or("")
    }

    fn ids(&self) -> impl Iterator<Item = &'static str> {
        let on_tapes = Standard::ALL.iter().filter_map(|(standard, ..)| self.verdicts.under(*standard));
        on_tapes.chain(self.verdicts.on_cldata()).map(|verdict| verdict.id)
    }
}
