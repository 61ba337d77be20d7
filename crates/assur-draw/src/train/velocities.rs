//! The velocity triangle of a satellite. The arrows of velocity begin on the line from the main axis through the
//! satellite. Their tips are on a second straight line. The two lines meet at the instant centre.

use assur::Point;
use assur::gears::train::Velocities;
use assur::sorting::sort_by;

use super::Name;
use super::arrows::arrow;
use crate::list::{List, Look, Role};

/// Greatest length of an arrow, in units of the drawing.
const MAX_LENGTH: f64 = 20.0;

/// Draws the triangle up to the distance `reach` from the main axis. The x-axis is the line from the main axis through
/// the satellite. Arrows are scaled to the available room: their lengths show only ratios of velocities.
pub(super) fn draw(list: &mut List, velocities: &Velocities, reach: f64, unit: f64) {
    // Leaves room for the width of arrowheads.
    let reach = reach - 2.0 * unit;
    let within = |radius: &f64| radius.abs() < reach;
    let places = [velocities.sun, velocities.centre, velocities.ring];
    let shown = places.into_iter().filter(|place| within(&place.radius));
    let fastest = shown
        .clone()
        .fold(0.0, |most: f64, place| most.max(place.velocity.abs()));
    if fastest == 0.0 {
        return;
    }
    let room = |radius: f64| (reach * reach - radius * radius).sqrt();
    let longest = shown.clone().fold(MAX_LENGTH * unit, |least, place| {
        least.min(room(place.radius))
    });
    let scale = longest / fastest;
    let centre = velocities.instantaneous_centre.filter(within);
    let on_line = |radius: f64| Point::new(radius, 0.0);
    let ends: Vec<[Point; 2]> = shown
        .map(|place| {
            let foot = on_line(place.radius);
            [foot, Point::new(place.radius, scale * place.velocity)]
        })
        .collect();
    let line = |row: usize| {
        let points = ends.iter().map(move |ends| ends[row]);
        let mut points: Vec<Point> = points.chain(centre.map(on_line)).collect();
        sort_by(&mut points, |a, b| a.x.total_cmp(&b.x));
        points
    };
    list.polyline(Role::Velocity, Look::Thin, &line(0));
    list.polyline(Role::Velocity, Look::Thin, &line(1));
    let arrows = ends.iter().filter_map(|[from, to]| arrow(*from, *to, unit));
    let arrows: Vec<Vec<Point>> = arrows.collect();
    list.polygons(Role::Velocity, Look::Solid, &arrows);
    if let Some(centre) = centre {
        let at = on_line(centre);
        list.circle(Role::Velocity, Look::Hollow, at, unit);
        list.name(Role::Velocity, Name::Pole as usize, at, [0.8, -0.8]);
    }
}
