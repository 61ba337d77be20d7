//! Which colour each link has.

use assur::mechanism::{Draft, DraftDriver, DraftLink, Mechanism};
use assur::structure::{Step, Structure};

use super::layout;
use crate::annotations::Annotations;
use crate::list::Role;

/// Colours of links that are not driven, or of Assur groups, in turn.
const ROLES: [Role; 6] = [
    Role::Coupler,
    Role::Rocker,
    Role::Accent2,
    Role::Accent3,
    Role::Accent5,
    Role::Accent6,
];

/// The colour that is noted for a link; else the driven link is a crank by its
/// colour, the others take theirs in turn, and what is fixed to a link has its.
pub(super) fn own(draft: &Draft, annotations: &Annotations) -> Vec<Role> {
    let driven = |name: &String| {
        draft.drivers.iter().any(|driver| match driver {
            DraftDriver::Crank { link, .. } => link == name,
            DraftDriver::Slide { slide, .. } => {
                let slide = draft.slides.get(*slide);
                slide.is_some_and(|slide| slide.link == *name)
            }
        })
    };
    let noted = |name: &String| {
        let mut roles = annotations.roles.iter();
        roles.find(|(link, _)| link == name).map(|(_, role)| *role)
    };
    let mut turn = ROLES.into_iter().cycle();
    let mut first = |link: &DraftLink| {
        noted(&link.name).unwrap_or_else(|| {
            if link.fixed_to.is_some() {
                Role::Secondary
            } else if driven(&link.name) {
                Role::Crank
            } else {
                turn.next().unwrap_or(Role::Coupler)
            }
        })
    };
    let roles: Vec<Role> = draft.links.iter().map(&mut first).collect();
    let links = draft.links.iter().enumerate();
    let role = |(link, of): (usize, &DraftLink)| {
        let body = layout::body_of(draft, Some(link));
        noted(&of.name).unwrap_or(body.map_or(Role::Secondary, |body| roles[body]))
    };
    links.map(role).collect()
}

/// The colours of drivers and Assur groups, in the order of the structure.
pub(super) fn of_steps(structure: &Structure) -> impl Iterator<Item = Role> {
    let mut turn = ROLES.into_iter().cycle();
    structure.steps.iter().map(move |step| match step {
        Step::Driver { .. } => Role::Crank,
        Step::Group(_) => turn.next().unwrap_or(Role::Coupler),
    })
}

/// Of each link the colour of the step that places it; what is fixed to the frame
/// has none.
pub(super) fn of_groups(draft: &Draft, mechanism: &Mechanism) -> Vec<Role> {
    let structure = mechanism.structure();
    let roles: Vec<Role> = of_steps(structure).collect();
    let of_body = |name: &str| {
        let mut bodies = 1..structure.step_of.len();
        let body = bodies.find(|body| mechanism.body_name(*body) == name)?;
        roles.get(structure.step_of[body]?).copied()
    };
    let role = |link: usize| {
        let body = layout::body_of(draft, Some(link))?;
        of_body(&draft.links[body].name)
    };
    let links = 0..draft.links.len();
    links
        .map(|link| role(link).unwrap_or(Role::Secondary))
        .collect()
}
