//! A scenario as text: what is printed of one is what runs it again, to the last bit.

use super::course::PIECES;
use super::scenario::SEEDS;
use super::{Campaign, Course, Interval, Scenario, Signal};

/// Key of an additional instant at which objectives are examined.
const AT: &str = "T/tau";

/// A number in the fewest digits that are read as it.
fn short(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

impl Campaign {
    /// A scenario as text, such as `tau = 2, x1 = -1, gust = worst(0.1, 0.52)`.
    pub fn text_of(&self, scenario: &Scenario) -> String {
        let of_point = self.names().zip(&scenario.point);
        let of_point = of_point.map(|(name, value)| format!("{name} = {}", short(*value)));
        let courses = self.disturbances.iter().zip(&scenario.courses);
        let of_courses = courses.map(|((symbol, bounds, _), course)| {
            format!("{} = {}", symbol.spelling(), course.text_of(*bounds))
        });
        let seed = self.is_drawn().then(|| format!("seed = {}", scenario.seed));
        let at = scenario.at.map(|share| format!("{AT} = {}", short(share)));
        of_point.chain(of_courses).chain(seed).chain(at).collect::<Vec<_>>().join(", ")
    }

    /// The scenario of a text.
    ///
    /// # Errors
    /// Returns the mistake, and the legal form.
    pub fn replayed(&self, text: &str) -> Result<Scenario, (String, String)> {
        let mut given = Vec::new();
        for item in items(text) {
            let Some((name, value)) = item.split_once('=') else {
                let message = format!("`{}` in the scenario is not NAME = VALUE", item.trim());
                return Err((message, self.form()));
            };
            given.push((name.trim(), value.trim()));
        }
        let mut take = |name: &str| {
            let place = given.iter().position(|(own, _)| *own == name)?;
            Some(given.swap_remove(place).1)
        };
        let mut point = Vec::new();
        for (name, (low, high)) in self.names().zip(self.sides()) {
            let value = match take(&name) {
                None if low == high => Some(low),
                given => given.and_then(|text| text.parse::<f64>().ok()),
            };
            match value {
                Some(value) if (low..=high).contains(&value) => point.push(value),
                _ => {
                    let message = format!("the scenario has no {name} in [{low}, {high}]");
                    return Err((message, self.form()));
                }
            }
        }
        let mut courses = Vec::new();
        for (symbol, bounds, legal) in &self.disturbances {
            let name = symbol.spelling();
            let course = take(&name).and_then(|text| Course::read(text, *bounds, self.span()));
            match course {
                Some(course) if legal.contains(&course.signal()) => courses.push(course),
                _ => {
                    let forms: Vec<_> = legal.iter().map(|signal| signal.form()).collect();
                    let (low, high) = bounds;
                    let message = format!("the scenario has no legal {name}");
                    let help = format!("{name} is {}, in [{low}, {high}]", forms.join(", or "));
                    return Err((message, help));
                }
            }
        }
        let seed = if self.is_drawn() { take("seed") } else { Some("0") };
        let Some(seed) = seed.and_then(|text| text.parse().ok()).filter(|seed| *seed < SEEDS)
        else {
            let message =
                "the scenario has no seed of what its sensors and samples draw".to_owned();
            return Err((message, format!("seed = N, an integer from 0 to {}", SEEDS - 1)));
        };
        let at = match take(AT).map(str::parse::<f64>) {
            None => None,
            Some(Ok(share)) if self.until < share && share < 1.0 => Some(share),
            Some(_) => {
                let message = format!("the scenario has no legal {AT}");
                let help =
                    format!("a number between {} and 1: an instant that is looked at", self.until);
                return Err((message, help));
            }
        };
        match given.first() {
            Some((name, _)) => {
                Err((format!("`{name}` is not a quantity of this scenario"), self.form()))
            }
            None => Ok(Scenario { point, courses, seed, at }),
        }
    }

    fn form(&self) -> String {
        let disturbances = self.disturbances.iter().map(|(symbol, ..)| symbol.spelling());
        let seed = self.is_drawn().then(|| "seed".to_owned());
        let names: Vec<_> = self.names().chain(disturbances).chain(seed).collect();
        format!("give the index of a draw, or NAME = VALUE for each of {}", names.join(", "))
    }
}

/// The parts of a text between its commas, except those in parentheses.
fn items(text: &str) -> Vec<&str> {
    let (mut depth, mut from, mut items) = (0_i32, 0, Vec::new());
    for (place, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                items.push(&text[from..place]);
                from = place + 1;
            }
            _ => {}
        }
    }
    items.push(&text[from..]);
    items
}

impl Signal {
    /// Returns the form in which one is written in a scenario.
    fn form(self) -> &'static str {
        match self {
            Self::Constant => "a number",
            Self::Sine => "sine(PERIODS, PHASE), 1/2 to 50 and 0 to 1",
            Self::Square => "square(HALF PERIODS, PHASE), 1 to 16 and 0 to 1",
            Self::Random => "random(16 LEVELS)",
            Self::Worst => "worst(BOUND, T/tau, ...) from a bound to the other at each T/tau",
        }
    }
}

impl Course {
    fn text_of(&self, (low, high): Interval) -> String {
        let of = |numbers: &mut dyn Iterator<Item = f64>| {
            let numbers: Vec<_> = numbers.map(short).collect();
            format!("{}({})", self.signal().name(), numbers.join(", "))
        };
        match self {
            Self::Constant(value) => short(*value),
            Self::Sine(rate, phase) | Self::Square(rate, phase) => {
                of(&mut [*rate, *phase].into_iter())
            }
            Self::Random(levels) => of(&mut levels.iter().copied()),
            Self::Worst { high: upper, switches } => {
                let first = if *upper { high } else { low };
                of(&mut std::iter::once(first).chain(switches.iter().copied()))
            }
        }
    }

    fn read(text: &str, (low, high): Interval, until: f64) -> Option<Self> {
        let within = |value: &f64| (low..=high).contains(value);
        if let Ok(value) = text.parse::<f64>() {
            return within(&value).then_some(Self::Constant(value));
        }
        let (word, rest) = text.split_once('(')?;
        let numbers = rest.strip_suffix(')')?.split(',').map(|item| item.trim().parse().ok());
        let numbers: Vec<f64> = numbers.collect::<Option<_>>()?;
        let signal = Signal::ALL.into_iter().find(|signal| signal.name() == word.trim())?;
        match (signal, &numbers[..]) {
            (Signal::Sine, [periods, phase]) => {
                let legal = (0.5..=50.0).contains(periods) && (0.0..=1.0).contains(phase);
                legal.then_some(Self::Sine(*periods, *phase))
            }
            (Signal::Square, [count, phase]) => {
                let whole = count.fract() == 0.0 && (1.0..=16.0).contains(count);
                (whole && (0.0..=1.0).contains(phase)).then_some(Self::Square(*count, *phase))
            }
            (Signal::Random, levels) => {
                let legal = levels.len() == PIECES && levels.iter().all(within);
                legal.then(|| Self::Random(levels.to_vec()))
            }
            (Signal::Worst, [first, switches @ ..]) => {
                let falls = switches.windows(2).all(|pair| pair[0] > pair[1]);
                let inside = switches.iter().all(|share| *share > until && *share < 1.0);
                let legal = (*first == low || *first == high) && falls && inside;
                legal.then(|| Self::Worst { high: *first == high, switches: switches.to_vec() })
            }
            _ => None,
        }
    }
}
