//! `show`: the expansions behind a controller, in text, LaTeX or JSON.

mod abstracts;
mod args;
mod coupled;
mod custom;
mod forms;
mod formula;
mod json;
mod latex;
mod law;
#[cfg(feature = "lab")]
mod mathml;
mod samples;
mod sheet;
mod text;

use crate::algebra::Poly;
use crate::check::resolved::Resolved;
use crate::diagnostic::Diagnostic;
use crate::family::Family;
use crate::keys::KeyInfo;
use crate::law::Law;
use crate::mapping::Mapping;
use crate::parameter::{Fixed, Parameter};
use crate::request::{Axes, MAX_ORDER, Spec};
use crate::syntax::{Node, Value};
use num_traits::ToPrimitive;

use args::Format;
pub(crate) use args::{EXAMPLES, Show, Subject};

use super::engine::{Engine, Part};
#[cfg(feature = "lab")]
use super::mathml::Math;
use super::progress::checking;
use super::report::Failure;
use super::source::Source;
use forms::{bell, entries, fixed_values, matrix};
use sheet::{Block, Forms, Layout, Sheet};

/// Largest order of the abstract expansions: r_30 has 4565 terms.
const MAX_ABSTRACT_ORDER: usize = 30;

/// Runs `show`.
pub(crate) fn show(request: &Show) -> Result<String, Failure> {
    let (subject, engine) = (request.subject, request.engine.engine);
    let one = |spec: &Spec| match (spec.family(), spec.ring()) {
        (Some(family), Some(ring)) => of_family(subject, spec, family, &ring, engine),
        _ => custom::sheet(subject, spec, engine),
    };
    let sheets = match ask(request)? {
        Asked::Abstract(n) => vec![of_abstract(subject, n, engine)?],
        Asked::Design(spec) => {
            let design = checking(|| Resolved::of(&spec));
            let spec = &design.spec;
            let mut sheets = match &spec.coupled {
                _ if spec.sampled().is_some() => vec![samples::sheet(&design)],
                Some(coupled) => coupled::sheets(subject, (spec, coupled), one)?,
                None => vec![one(spec)?],
            };
            if let Some(first) = sheets.first_mut().filter(|_| request.design.design.is_some()) {
                first.name(design);
            }
            sheets
        }
    };
    let each = |render: fn(&Sheet) -> String| sheets.iter().map(render).collect::<Vec<_>>();
    Ok(match request.format {
        Format::Text => each(text::render).join("\n"),
        Format::Latex => each(latex::render).join("\n"),
        Format::Json => json::render(&sheets),
    })
}

/// The closed forms of a design as formulas. Those of a mapping of which no ring is known are in
/// the derivatives of an abstract one, and BB_n and b_n in r_k where kappa is found by an iteration.
#[cfg(feature = "lab")]
pub(crate) fn formulas(subject: Subject, spec: &Spec) -> Result<Vec<Math>, Failure> {
    let engine = Engine::Ptc;
    let sheet = match (spec.family(), spec.ring()) {
        (Some(family), Some(ring)) if subject != Subject::Matrix || !family.is_iterated() => {
            of_family(subject, spec, family, &ring, engine)?
        }
        _ if subject == Subject::Matrix => {
            let mut sheet = Sheet::new("");
            matrix(&mut sheet, abstracts::bell(engine, spec.n)?);
            sheet
        }
        _ => of_abstract(subject, spec.n, engine)?,
    };
    Ok(mathml::formulas(&sheet))
}

/// Subject of the expansions.
enum Asked {
    /// The abstract mapping, at an order.
    Abstract(usize),
    /// A mapping at an order, perhaps with parameters fixed, or a whole design.
    Design(Box<Spec>),
}

fn ask(request: &Show) -> Result<Asked, Failure> {
    let mut source = Source::default();
    for (key, value) in [("n", &request.n), ("mu", &request.mu)] {
        if let Some(text) = value {
            source.give(key, text);
        }
    }
    let design = request.design.design.as_deref();
    let source = source.with_design(design)?;
    let flags = source.parse();
    if request.mu.is_none() && design.is_none() {
        let most = if request.subject == Subject::Law { MAX_ORDER } else { MAX_ABSTRACT_ORDER };
        let node = flags.entries.first().map(|entry| &entry.value);
        let order = node.and_then(|node| order(node, most));
        let given = node.zip(request.n.as_deref());
        let found = if order.is_some() { Vec::new() } else { vec![no_order(given, most)] };
        return flags.finish(order, found).map(Asked::Abstract);
    }
    if matches!(request.subject, Subject::BigR | Subject::Tables) {
        return flags.finish(None, vec![only_abstract()]);
    }
    let spec = flags.read()?;
    let own = spec.coupled.is_none() && spec.axes.as_ref().is_some_and(Axes::differ);
    let of_one = if own { spec.needs_one_axis("show") } else { Ok(()) };
    let known = match request.subject {
        Subject::Law => spec.needs_law("show law"),
        _ => spec.needs_time(&format!("show {}", request.subject.name())),
    };
    if let Err(found) = known.and(of_one) {
        return flags.finish(None, found);
    }
    Ok(Asked::Design(Box::new(spec)))
}

fn order(node: &Node, most: usize) -> Option<usize> {
    let Value::Number(Fixed::Number { value, .. }) = &node.value else { return None };
    let order = value.is_integer().then(|| value.to_usize()).flatten()?;
    (1..=most).contains(&order).then_some(order)
}

fn no_order(given: Option<(&Node, &str)>, most: usize) -> Diagnostic {
    let legal = format!("n is an integer 1..={most} here");
    let (code, message, help) = match given {
        Some((_, text)) => {
            let start: String = text.chars().take(40).collect();
            let example = KeyInfo::find("n").map_or("", |info| info.example);
            let message = format!("n = `{start}` is not an order that can be shown");
            ("bad-value", message, format!("{legal}, for example --n {example}"))
        }
        // Each missing key gets its example where it is reported.
        None => ("missing-key", "`n` is missing".to_owned(), legal),
    };
    Diagnostic {
        code,
        key: "n".to_owned(),
        place: given.map(|(node, _)| node.place),
        message,
        help,
    }
}

fn only_abstract() -> Diagnostic {
    Diagnostic {
        code: "bad-value",
        key: "mu".to_owned(),
        place: None,
        message: "R_{k,m} holds the derivatives of an abstract mapping, not of a family".to_owned(),
        help: "leave `--mu` or the design out, or use `show r`, which takes a family too"
            .to_owned(),
    }
}

fn of_abstract(subject: Subject, n: usize, engine: Engine) -> Result<Sheet, Failure> {
    let mut sheet = Sheet::new("s = kappa(Dt), an abstract time mapping, and its derivatives");
    match subject {
        Subject::SmallR => sheet.forms(small_r(abstracts::r(engine, n)?)),
        Subject::BigR => sheet.forms(big_r("R", Layout::List, abstracts::big_r(engine, n)?)),
        Subject::Bell => {
            sheet.heading = vec!["B_{i,j}(r_1, r_2, ...) with r1, r2, ... = r_1, r_2, ...".into()];
            sheet.forms(bell(abstracts::bell(engine, n)?));
        }
        Subject::Matrix => matrix(&mut sheet, abstracts::table(engine, n)?),
        Subject::Law => {
            let mapping = Mapping::symbolic(n);
            let forms = engine.expand(n, &mapping, Part::All)?;
            let law = Law::new(n, &mapping, Some(&forms));
            law::write(&mut sheet, None, &law, &forms.r, |poly| poly.clone());
        }
        Subject::Tables => tables(&mut sheet, engine, n)?,
    }
    Ok(sheet)
}

fn of_family(
    subject: Subject,
    spec: &Spec,
    family: Family,
    mapping: &Mapping,
    engine: Engine,
) -> Result<Sheet, Failure> {
    let info = family.info();
    let mut sheet = Sheet::new(&format!("{}: mu(t) = {}", info.name, info.mu));
    sheet.heading.push(format!("where {}", info.atoms));
    sheet.heading.extend(fixed_values(spec));
    let fixed = |poly: &Poly| {
        poly.substitute(|symbol| {
            let value = spec.fixed.get(&Parameter::of_symbol(symbol)?)?.number()?;
            Some(Poly::constant(value.clone()))
        })
    };
    let fix_all = |polys: Vec<Poly>| polys.iter().map(fixed).collect::<Vec<_>>();
    // The law of a mapping whose r_1 is no single term holds r_k and no B_{i,j}.
    let series = subject == Subject::Law && mapping.r1.inverse().is_none();
    let part = if subject == Subject::SmallR || series { Part::R } else { Part::All };
    let forms = engine.expand(spec.n, mapping, part)?;
    let table = || forms.bell.iter().cloned().map(fix_all).collect::<Vec<_>>();
    match subject {
        Subject::Bell => sheet.forms(bell(table())),
        Subject::Matrix => matrix(&mut sheet, table()),
        Subject::Law => {
            let law = Law::new(spec.n, mapping, Some(&forms));
            law::write(&mut sheet, Some(spec), &law, &forms.r, fixed);
        }
        Subject::SmallR | Subject::BigR | Subject::Tables => {
            sheet.forms(small_r(fix_all(forms.r)));
        }
    }
    Ok(sheet)
}

fn small_r(r: Vec<Poly>) -> Forms {
    Forms::counted("r", &["k"], r)
}

fn big_r(key: &'static str, layout: Layout, table: Vec<Vec<Poly>>) -> Forms {
    let forms = entries(table, 0);
    Forms { key, stem: "R", latex: "R", index: &["k", "m"], forms, layout }
}

fn tables(sheet: &mut Sheet, engine: Engine, n: usize) -> Result<(), Failure> {
    let caption = "Table A1: R_{k,m}";
    let layout = Layout::Table { caption, latex: "Table A1: $R_{k,m}$" };
    sheet.forms(big_r("A1", layout, abstracts::big_r(engine, n)?));
    let caption = "Table A2: r_k, with r_{k+1} = s'^-(k+1) sum_{m=0..k} (-1)^m s'^-m R_{k,m}";
    let latex =
        r"Table A2: $r_k$, with $r_{k+1} = (s')^{-(k+1)} \sum_{m=0}^{k} (-1)^m (s')^{-m} R_{k,m}$";
    let mut r = small_r(abstracts::r(engine, n)?);
    (r.key, r.layout) = ("A2", Layout::Table { caption, latex });
    sheet.blocks.push(Block::Forms(r));
    Ok(())
}
