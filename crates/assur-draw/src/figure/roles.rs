//! Colours of links.

use assur::mechanism::{LinkId, LinkSpec, Mechanism};
use assur::structure::{Step, Structure};

use crate::annotations::Annotations;
use crate::list::{IN_TURN, Role};

/// Returns the colour of each link: as annotated, or by default the crank's colour for a driven link, the colour of the
/// carrying link for a link fixed to another, and the next colour in turn for any other link.
pub(super) fn own(mechanism: &Mechanism, annotations: &Annotations) -> Vec<Role> {
    let draft = mechanism.spec();
    let driven = |name: &String| {
        let mut drivers = draft.drivers.iter();
        drivers.any(|driver| draft.driven(driver) == Some(name))
    };
    let noted = |name: &String| {
        let mut roles = annotations.roles.iter();
        roles.find(|(link, _)| link == name).map(|(_, role)| *role)
    };
    let mut turn = IN_TURN.into_iter().cycle();
    let mut first = |link: &LinkSpec| {
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
    let links = mechanism.link_ids().zip(&draft.links);
    let role = |(link, of): (LinkId, &LinkSpec)| {
        let root = mechanism.root_of(link);
        noted(&of.name).unwrap_or(root.map_or(Role::Secondary, |root| roles[root.index()]))
    };
    links.map(role).collect()
}

/// Returns the colours of the terms of the structural formula. The term of a doubled link has the colour of its body.
pub(super) fn of_terms(mechanism: &Mechanism) -> impl Iterator<Item = Role> {
    let of_links = of_groups(mechanism);
    let doubled = mechanism.doubled().iter();
    let doubled = doubled.map(move |one| of_links[one.link.index()]);
    of_steps(mechanism.structure()).chain(doubled)
}

/// Returns the colours of drivers and Assur groups, in the order of the structure.
fn of_steps(structure: &Structure) -> impl Iterator<Item = Role> {
    let mut turn = IN_TURN.into_iter().cycle();
    structure.steps.iter().map(move |step| match step {
        Step::Driver { .. } => Role::Crank,
        Step::Group(_) => turn.next().unwrap_or(Role::Coupler),
    })
}

/// Returns the colour of each link's driver or Assur group; links fixed to the frame have the secondary colour.
pub(super) fn of_groups(mechanism: &Mechanism) -> Vec<Role> {
    let structure = mechanism.structure();
    let roles: Vec<Role> = of_steps(structure).collect();
    let of_body = |name: &str| {
        let mut bodies = mechanism.bodies();
        let body = bodies.find(|body| mechanism.body_name(*body) == name)?;
        roles.get(structure.step_of[body.index()]?).copied()
    };
    let role = |link: LinkId| of_body(mechanism.link_name(mechanism.root_of(link)?));
    let links = mechanism.link_ids();
    links
        .map(|link| role(link).unwrap_or(Role::Secondary))
        .collect()
}
