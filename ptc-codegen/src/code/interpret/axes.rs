//! A call for several axes: `tick` once, then `axis` for each.

use super::{Argument, Instance, Outcome};
use crate::code::{AXIS, Function, Shape, Status};
use crate::collect::map;

/// What `function` gives for so many axes, as [`Finish::Axes`](crate::code::Finish::Axes) says.
pub(super) fn each(
    controller: &mut Instance<'_>,
    function: &Function,
    count: usize,
    arguments: &[Argument<'_>],
) -> Outcome {
    let ticked = controller.call("tick", arguments);
    let mut status = ticked.status;
    let (mut u, mut axes) = (vec![0.0; count], vec![status; count]);
    if status.number() >= 0 {
        let mut gains = controller.gains(&ticked);
        gains.taken = controller.taken.take();
        for index in 0..count {
            let number = [u32::try_from(index).map_or(f64::NAN, f64::from)];
            let own = of_axis(function, index, arguments);
            let own: Vec<_> = own.chain([(AXIS, number.as_slice())]).collect();
            let found = gains.call("axis", &own);
            u[index] = found.results.get("u").map_or(0.0, |u| u[0]);
            axes[index] = found.status;
            let decides = found.status.number() < 0 || found.status == Status::Saturated;
            if status.number() >= 0 && decides {
                status = found.status;
            }
        }
        controller.taken = gains.taken;
    }
    if status.number() < 0 {
        u.fill(0.0);
    }
    let axes = axes.into_iter().map(|status| f64::from(status.number())).collect();
    let results = function.results.iter().map(|result| result.name.clone()).zip([u, axes]);
    Outcome { status, results: map(results) }
}

/// The part of each array of arrays that belongs to one axis.
fn of_axis<'b>(
    function: &Function,
    index: usize,
    arguments: &[Argument<'b>],
) -> impl Iterator<Item = Argument<'b>> {
    arguments.iter().filter_map(move |&(name, values)| {
        let shape = function.arguments.iter().find(|a| a.name == name)?.shape;
        let Shape::Lists(_, length) = shape else { return None };
        Some((name, values.get(length * index..length * (index + 1)).unwrap_or_default()))
    })
}
