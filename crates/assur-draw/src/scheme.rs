//! The drawing of a scheme of links and pairs, in the plane or in space, closed or cut open.

mod labels;
mod opening;
mod places;
mod symbols;

use assur::Point;
use assur::mobility::{Cut, Point3, Scheme};
use assur::sorting::sort_by;

use crate::list::{List, Look, Role};
use crate::parts;
use crate::projection::Projection;
use opening::{Chain, Displacement};
use places::{around, placed};
use symbols::Pen;

/// Half the width of a bar, in symbol units.
const BAR: f64 = 0.75;

/// Margin for names around the scheme, in symbol units.
const ROOM: f64 = 10.0;

/// Colours of the moving links, in order. They are repeated if there are more links than colours.
const ROLES: [Role; 9] = [
    Role::Crank,
    Role::Coupler,
    Role::Rocker,
    Role::Accent2,
    Role::Accent3,
    Role::Accent4,
    Role::Accent5,
    Role::Accent6,
    Role::Accent7,
];

/// View of a scheme.
#[derive(Clone, Debug, Default)]
pub struct SchemeView {
    /// Cuts, in the order in which they open.
    pub cuts: Vec<Cut>,
    /// Further points of links, in addition to their pairs.
    pub ends: Vec<(usize, Point3)>,
    /// Direction from which a spatial scheme is viewed: angle about z and angle above the horizontal, radians.
    pub look: [f64; 2],
    /// Highlighted pairs, such as those of a contour that is still closed.
    pub marked: Vec<usize>,
    /// Whether the freedoms of each remaining pair and the constraints of each cut pair are written beside the pair.
    pub counted: bool,
}

/// A handle, which is a pair or one link of a compound hinge.
#[derive(Clone, Debug, PartialEq)]
pub struct SchemeHandle {
    /// Name of the cut made at this handle, such as `D` or `Q:3`.
    pub name: String,
    /// Index of the pair.
    pub pair: usize,
    /// Colour of the link that the cut detaches from the pair.
    pub role: Role,
}

/// The drawing of a scheme.
#[derive(Clone, Debug)]
pub struct SchemeFigure {
    scheme: Scheme,
    view: SchemeView,
    projection: Projection,
    /// Positions of all pairs.
    places: Vec<Point3>,
    names: Vec<String>,
    size: f64,
    unit: f64,
    bounds: [f64; 4],
}

/// A link as it is drawn.
struct Body {
    link: usize,
    /// Positions of the link's pairs and further points, after displacement.
    nodes: Vec<Point3>,
}

impl SchemeFigure {
    /// Makes the drawing of a scheme.
    pub fn new(scheme: &Scheme, view: SchemeView) -> Self {
        let projection = if scheme.is_planar() {
            Projection::plane()
        } else {
            Projection::space(view.look)
        };
        let places = placed(scheme);
        let nodes = places.iter().chain(view.ends.iter().map(|(_, at)| at));
        let size = around(nodes.map(|at| projection.place(*at))).1;
        let pairs = scheme.pairs().iter().enumerate();
        let named = pairs.map(|(index, pair)| {
            if !view.counted {
                return pair.name.clone();
            }
            // A compound hinge counts as several pairs and may be cut several times.
            let cut = view.cuts.iter().filter(|cut| cut.pair == index).count();
            let left = usize::from(scheme.freedoms(index)) * pair.count().saturating_sub(cut);
            let removed = usize::from(scheme.constraints(index)) * cut;
            let signed = [("+", left), ("−", removed)].into_iter();
            let signed = signed.filter(|(_, number)| *number > 0);
            let signed = signed.map(|(sign, number)| format!(" {sign}{number}"));
            pair.name.clone() + &signed.collect::<String>()
        });
        let names = named.chain(scheme.links().iter().cloned()).collect();
        let mut figure = Self {
            scheme: scheme.clone(),
            projection,
            names,
            size,
            unit: size / 100.0,
            bounds: [0.0; 4],
            places,
            view,
        };
        figure.bounds = figure.measured();
        figure
    }

    /// Returns the rectangle that holds the drawing, closed and open: left, bottom, right, top.
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// Returns the names to which labels refer by index.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Returns the colour of a link.
    pub fn role(&self, link: usize) -> Role {
        match link {
            0 => Role::Secondary,
            moving => ROLES[(moving - 1) % ROLES.len()],
        }
    }

    /// Returns the handles of the scheme.
    pub fn handles(&self) -> Vec<SchemeHandle> {
        let pairs = self.scheme.pairs().iter().enumerate();
        let handles = pairs.flat_map(|(index, pair)| {
            let compound = pair.links.len() > 2;
            let links = pair.links.iter().filter(move |_| compound).copied();
            let whole = (!compound).then(|| pair.links.iter().copied().max().unwrap_or(0));
            links.chain(whole).map(move |link| (index, link))
        });
        let handles = handles.map(|(pair, link)| SchemeHandle {
            name: self.scheme.cut_name(Cut { pair, link }),
            pair,
            role: self.role(link),
        });
        handles.collect()
    }

    /// Returns the positions of the handles with the last cut open by the share `opened` (0 to 1) of its full gap.
    pub fn held_at(&self, opened: f64) -> Vec<Point> {
        let moved = self.opened(opened);
        let held = self.scheme.pairs().iter().enumerate();
        let held = held.flat_map(|(index, pair)| {
            let at = |link: usize| self.projection.place(moved[link] * self.places[index]);
            if pair.links.len() == 2 {
                return vec![at(self.holder(index))];
            }
            // The handles of a compound hinge are apart, each on its link.
            let aside = |link: &usize| at(*link) + self.inward(index, *link, &moved) * 4.0;
            pair.links.iter().map(aside).collect()
        });
        held.collect()
    }

    /// Returns the position in space of a pair that is dragged to a point on the sheet.
    pub fn dragged(&self, pair: usize, to: Point) -> Point3 {
        self.projection.raised(to, self.places[pair])
    }

    /// Returns the drawing with its last cut open by the share `opened`: the number of bodies, 1; the pose x = 0,
    /// y = 0, θ = 0 of this body, the sheet; then a display list.
    pub fn frame(&self, opened: f64) -> Vec<f32> {
        let moved = self.opened(opened);
        let mut list = List::default();
        self.draw(&mut list, &moved);
        let sheet = [1.0, 0.0, 0.0, 0.0];
        sheet
            .into_iter()
            .chain(list.numbers().iter().copied())
            .collect()
    }

    fn opened(&self, share: f64) -> Vec<Displacement> {
        let share = if share.is_finite() {
            share.clamp(0.0, 1.0)
        } else {
            1.0
        };
        Chain::new(&self.scheme, &self.places, &self.view.cuts, self.size).opened(share)
    }

    /// Returns the link at which the symbol of a pair is drawn: the first that no cut detaches from the pair.
    fn holder(&self, pair: usize) -> usize {
        let links = &self.scheme.pairs()[pair].links;
        let left = |&&link: &&usize| !self.view.cuts.contains(&Cut { pair, link });
        let holder = links.iter().find(left).or(links.first());
        holder.copied().unwrap_or(0)
    }

    /// Returns a vector of one symbol unit on the sheet, from a pair towards the rest of a link.
    fn inward(&self, pair: usize, link: usize, moved: &[Displacement]) -> assur::Vector {
        let here = self.projection.place(moved[link] * self.places[pair]);
        let rest = self.seen(&self.body(link, moved));
        let rest = rest.into_iter().map(|at| at - here);
        let rest = rest.sum::<assur::Vector>();
        rest.try_normalize(1e-9)
            .unwrap_or_else(assur::Vector::zeros)
            * self.unit
    }

    fn body(&self, link: usize, moved: &[Displacement]) -> Body {
        let pairs = self.scheme.pairs().iter().zip(&self.places);
        let joined = pairs.filter(|(pair, _)| pair.links.contains(&link));
        let joined = joined.map(|(_, at)| at);
        let ends = self.view.ends.iter().filter(|(of, _)| *of == link);
        let nodes = joined.chain(ends.map(|(_, at)| at));
        Body {
            link,
            nodes: nodes.map(|at| moved[link] * at).collect(),
        }
    }

    /// Returns the nodes of a body, projected onto the sheet.
    fn seen(&self, body: &Body) -> Vec<Point> {
        let nodes = body.nodes.iter();
        nodes.map(|at| self.projection.place(*at)).collect()
    }

    fn draw(&self, list: &mut List, moved: &[Displacement]) {
        let unit = self.unit;
        list.body(0);
        for index in self.grounded() {
            let at = self.projection.place(moved[0] * self.places[index]);
            parts::support(list, at, 1.4 * unit);
        }
        let links = 1..self.scheme.links().len();
        let mut bodies: Vec<Body> = links.map(|link| self.body(link, moved)).collect();
        let near = |body: &Body| {
            let all = body.nodes.iter().map(|at| self.projection.nearness(*at));
            all.sum::<f64>() / body.nodes.len().max(1) as f64
        };
        sort_by(&mut bodies, |a, b| near(a).total_cmp(&near(b)));
        for body in &bodies {
            self.draw_body(list, body);
        }
        for index in 0..self.scheme.pairs().len() {
            self.draw_pair(list, index, moved);
        }
        self.label(list, &bodies, moved);
    }

    /// Returns the pairs with a support, which are those of the frame.
    fn grounded(&self) -> impl Iterator<Item = usize> + '_ {
        let pairs = self.scheme.pairs().iter().enumerate();
        pairs
            .filter(|(_, pair)| pair.links.contains(&0))
            .map(|(index, _)| index)
    }

    fn draw_body(&self, list: &mut List, body: &Body) {
        let (role, half) = (self.role(body.link), BAR * self.unit);
        let nodes = self.seen(body);
        match parts::hull(nodes.clone())[..] {
            [] => {}
            [only] => list.circle(role, Look::Solid, only, half),
            [from, to] => parts::bar(list, role, from, to, half),
            ref corners => {
                parts::plate(list, role, corners, half);
                // Pairs inside the plate are joined to the middle of the plate.
                let middle = parts::centroid(corners);
                for (node, middle) in nodes.iter().zip(middle.into_iter().cycle()) {
                    if !corners.contains(node) {
                        list.polyline(role, Look::Line, &[middle, *node]);
                    }
                }
            }
        }
    }

    fn draw_pair(&self, list: &mut List, index: usize, moved: &[Displacement]) {
        let pair = &self.scheme.pairs()[index];
        let (place, holder) = (self.places[index], self.holder(index));
        let cuts = self.view.cuts.iter().filter(|cut| cut.pair == index);
        let here = self.projection.place(moved[holder] * place);
        if self.view.marked.contains(&index) {
            list.circle(Role::Acceleration, Look::Soft, here, 3.0 * self.unit);
        }
        for cut in cuts {
            let there = self.projection.place(moved[cut.link] * place);
            list.polyline(Role::Acceleration, Look::Dashed, &[here, there]);
            let role = self.role(cut.link);
            let off = &moved[cut.link];
            Pen::new(list, &self.projection, self.unit, role, pair, place, off).stump();
        }
        let held = &moved[holder];
        Pen::new(
            list,
            &self.projection,
            self.unit,
            Role::Ink,
            pair,
            place,
            held,
        )
        .draw(pair.kind);
    }

    /// Returns the rectangle around the scheme, with room for symbols.
    fn measured(&self) -> [f64; 4] {
        let shares = [0.0, 1.0];
        let seen = shares.iter().flat_map(|share| {
            let moved = self.opened(*share);
            let links = 0..self.scheme.links().len();
            let seen = links.flat_map(|link| self.seen(&self.body(link, &moved)));
            seen.collect::<Vec<Point>>()
        });
        let ([left, bottom, right, top], _) = around(seen);
        let room = ROOM * self.unit;
        [left - room, bottom - room, right + room, top + room]
    }
}
