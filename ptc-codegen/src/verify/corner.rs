//! The joint corners of all that is uncertain, which chance alone does not meet.

use super::course::Course;
use super::{Campaign, Scenario, Tally, Trial};

/// Binary digits of the number of corners that are run: all of them where there are as few, else a
/// two-level design of resolution IV, in which any three quantities meet all eight of their corners.
const DIGITS: u32 = 8;

/// Most corners from which a search goes on.
const STARTS: usize = 8;

/// The corners of a campaign, as they were run.
#[derive(Clone, Debug)]
pub struct Corners {
    /// All of them.
    pub scenarios: Vec<Scenario>,
    /// Tally of them, by their place.
    pub tally: Tally,
    /// For each objective their places, the worst one first.
    order: Vec<Vec<usize>>,
}

impl Corners {
    /// Runs all of them. `done` is called after each.
    pub fn run(campaign: &Campaign, trial: &Trial, done: &(dyn Fn() + Sync)) -> Self {
        let scenarios = campaign.corners();
        let rows = campaign.rows(trial, &scenarios, done);
        let mut tally = Tally::new(campaign);
        rows.iter().for_each(|row| tally.add(row));
        let order = |objective: usize| {
            let mut order: Vec<_> = (0..rows.len()).collect();
            let excess = |place: &usize| tally.worst_of(&rows[*place], objective);
            order.sort_by(|a, b| excess(b).total_cmp(&excess(a)));
            order
        };
        let order = (0..campaign.objectives.len()).map(order).collect();
        Self { scenarios, tally, order }
    }

    /// The worst corners for an objective from which a search goes on: of each corner of tau and the
    /// constants one, as x0 and the disturbances find theirs.
    pub fn starts(&self, campaign: &Campaign, objective: usize) -> Vec<Scenario> {
        let n = campaign.x0.len();
        let rest = |scenario: &Scenario| [&scenario.point[..1], &scenario.point[n + 1..]].concat();
        let mut starts: Vec<Scenario> = Vec::new();
        for scenario in self.order[objective].iter().map(|place| &self.scenarios[*place]) {
            if starts.len() < STARTS && starts.iter().all(|own| rest(own) != rest(scenario)) {
                starts.push(scenario.clone());
            }
        }
        starts
    }
}

impl Campaign {
    /// Corners of the boxes of tau, x0 and the constants with each disturbance at a bound throughout,
    /// and the same with the x0 of the box that is nearest to 0 where that is no corner. The first is
    /// the lower end of everything, and none is there twice.
    pub fn corners(&self) -> Vec<Scenario> {
        let of_x0 = 1..=self.x0.len();
        let nearest: Vec<_> = self.x0.iter().map(|(low, high)| 0f64.clamp(*low, *high)).collect();
        let is_corner = self.x0.iter().zip(&nearest).all(|((low, high), x)| x == low || x == high);
        let sides: Vec<_> = self.sides().collect();
        let free = |place: &usize| sides[*place].0 < sides[*place].1;
        let all: Vec<_> = (0..sides.len()).filter(free).collect();
        let rest: Vec<_> = all.iter().copied().filter(|place| !of_x0.contains(place)).collect();
        let corners = |places: &[usize], x0: Option<&[f64]>| -> Vec<Scenario> {
            let scenario = |row: Vec<bool>| {
                let mut point: Vec<_> = sides.iter().map(|side| side.0).collect();
                if let Some(x0) = x0 {
                    point[1..=x0.len()].copy_from_slice(x0);
                }
                for (place, upper) in places.iter().zip(&row) {
                    point[*place] = if *upper { sides[*place].1 } else { sides[*place].0 };
                }
                let courses = self.disturbances.iter().zip(&row[places.len()..]);
                let course = |((_, bounds, legal), upper): (&(_, _, Vec<_>), &bool)| {
                    Course::extreme((legal, *bounds), *upper)
                };
                Scenario { point, courses: courses.map(course).collect(), seed: 0, at: None }
            };
            two_level(places.len() + self.disturbances.len()).into_iter().map(scenario).collect()
        };
        let mut scenarios = corners(&all, None);
        if !is_corner {
            scenarios.extend(corners(&rest, Some(&nearest)));
        }
        scenarios
    }
}

/// The rows of a two-level design of `count` factors.
fn two_level(count: usize) -> Vec<Vec<bool>> {
    let mut digits = count.min(DIGITS as usize);
    while count > digits && count > 1 << (digits - 1) {
        digits += 1;
    }
    // A factor is the parity of some digits of the row, of an odd number of them: the sum of three
    // different ones is never empty.
    let mut masks: Vec<_> = (0..digits).map(|digit| 1usize << digit).collect();
    let others = (0..1usize << digits).filter(|mask| mask.count_ones() % 2 == 1);
    masks.extend(others.filter(|mask| mask.count_ones() > 1));
    let row = |row: usize| -> Vec<bool> {
        masks[..count].iter().map(|mask| (row & mask).count_ones() % 2 == 1).collect()
    };
    (0..1usize << digits).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::two_level;

    #[test]
    fn every_three_factors_take_all_corners_equally_often() {
        for count in [0, 1, 2, 5, 8, 9, 12, 30] {
            let rows = two_level(count);
            assert!(rows.len() == 1 << count.min(8) && rows[0].iter().all(|upper| !upper));
            assert!(rows.iter().any(|row| row.iter().all(|upper| *upper)), "{count}");
            for a in 0..count {
                for b in 0..a {
                    for c in 0..b {
                        let mut met = [0; 8];
                        for row in &rows {
                            let corner = [a, b, c].map(|factor| usize::from(row[factor]));
                            met[corner[0] + 2 * corner[1] + 4 * corner[2]] += 1;
                        }
                        assert!(met.iter().all(|n| *n == rows.len() / 8), "{count}: {a} {b} {c}");
                    }
                }
            }
        }
        assert_eq!(two_level(200).len(), 512);
    }
}
