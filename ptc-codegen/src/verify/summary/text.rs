//! Result of a summary, and how it is printed.

use super::super::trajectory::{Trajectory, table};
use super::super::{Campaign, Verdict};
use super::{APART, Judged, Sides, Summary};

/// Result of a verification.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Every objective holds.
    Holds,
    /// An objective fails.
    Fails,
    /// None fails, and not every one is known to hold.
    Undecided,
}

impl Judged {
    /// The verdict in words.
    pub fn verdict(&self) -> String {
        match self.verdict {
            Verdict::Proved => {
                format!("holds, proved {}", self.scope)
            }
            Verdict::Sampled { .. } => "holds, by sampling".to_owned(),
            Verdict::Met => "met within rounding".to_owned(),
            Verdict::Undecided(_) => "undecided".to_owned(),
            Verdict::Fails => "fails".to_owned(),
        }
    }
}

impl Summary {
    /// Returns the result: an objective that fails decides it.
    pub fn end(&self) -> End {
        let any = |wanted: &dyn Fn(Verdict) -> bool| {
            self.objectives.iter().any(|judged| wanted(judged.verdict))
        };
        if any(&|verdict| verdict == Verdict::Fails) {
            End::Fails
        } else if self.sides.as_ref().is_some_and(|sides| sides.apart)
            || any(&|verdict| !verdict.holds())
        {
            End::Undecided
        } else {
            End::Holds
        }
    }

    /// Returns true if every objective is proved.
    fn is_proved(&self) -> bool {
        self.objectives.iter().all(|judged| judged.verdict == Verdict::Proved)
    }

    /// As it is printed.
    pub fn text(&self, campaign: &Campaign) -> String {
        let mut text = format!("{}: {}\n", campaign.spec.name(), self.run);
        text.push_str(&format!("draws: {}\n", self.distribution));
        text.push_str(&format!("design {}\n", campaign.design.spec.fingerprint()));
        for line in campaign.design.lines() {
            text.push_str(&format!("  {line}\n"));
        }
        text.push('\n');
        let judged = campaign.objectives.iter().zip(&self.objectives);
        for (number, (objective, judged)) in (1..).zip(judged) {
            text.push_str(&format!("objective {number}, {objective}: {}\n", judged.verdict()));
            judged.details.iter().for_each(|detail| text.push_str(&format!("  {detail}\n")));
        }
        if let Some(Sides { told, apart }) = &self.sides {
            text.push_str(&format!("\n{told}\n"));
            if *apart {
                text.push_str(&format!("  {APART}\n"));
            }
        }
        if let Some(Trajectory { told, instants, ended, .. }) = &self.trajectory {
            text.push_str(&format!(
                "\nworst trajectory, {told}\n{}",
                table(&campaign.spec, instants)
            ));
            text.extend(ended.iter().map(|ended| format!("  it ends early: {ended}\n")));
        }
        text.push_str(match self.end() {
            End::Holds if self.is_proved() => "\nevery objective holds\n",
            End::Holds => "\nevery objective holds, by sampling where it says so: nothing is claimed of its worst case\n",
            End::Fails => "\nnot verified\n",
            End::Undecided => "\nundecided\n",
        });
        text
    }
}
