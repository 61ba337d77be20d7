//! Annotations that a document adds to its drawing.

use assur::Point;
use assur::gears::GearSet;
use assur::mixer::Mixer;

use crate::guidance::Guidance;
use crate::list::Role;

/// Annotations of a drawing. Links and points are identified by name; annotations with unknown names are ignored.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Annotations {
    /// Colours of links; the other links have default colours.
    pub roles: Vec<(String, Role)>,
    /// Numbers of links, also used as subscripts of their angles, as in φ₃. The angle of a link without a
    /// number is named after the link.
    pub numbers: Vec<(String, String)>,
    /// Links whose wheels carry mixing blades, each with the number of blades.
    pub blades: Vec<(String, usize)>,
    /// Numbers written beside wheels.
    pub tags: Vec<Tag>,
    /// Symbol of the input angle, drawn beside its arc. A driven slide has an arrow beside its block instead.
    pub input: Option<String>,
    /// Loop vectors: first and last point, and symbol. If the list is empty, the vectors are found automatically.
    pub loop_vectors: Vec<([String; 2], String)>,
    /// Angles to be drawn: first point, vertex and third point, and the symbol of the angle from first to third.
    pub corners: Vec<([String; 3], String)>,
    /// The given positions of a synthesis.
    pub given: Vec<GivenPosition>,
    /// Poses of the guided body.
    pub guidance: Guidance,
    /// Ordinate of the ground line, which is drawn only if its distance from the drawing is at most the drawing's size.
    pub ground: Option<f64>,
}

impl Annotations {
    /// Returns the annotations of any linkage: the symbol of its input, and its ground, if given.
    pub fn of_linkage(ground: Option<f64>) -> Self {
        Self {
            input: Some("φ₁".to_owned()),
            ground,
            ..Self::default()
        }
    }

    /// Adds the letters of the paper on the combined method (Sakhabutdinova) for the sides of the rigid triangles, for
    /// the angle from the first side of each triangle to the second, and for link DC.
    #[must_use]
    pub fn with_letters_of_combined_method(mut self) -> Self {
        let owned = |letters: &str| letters.chars().map(String::from).collect::<Vec<_>>();
        for (ends, letter) in [
            ("HG", "g"),
            ("HL", "t"),
            ("GE", "e"),
            ("GF", "f"),
            ("CL", "r"),
            ("CK", "p"),
            ("DC", "c"),
        ] {
            if let Ok(ends) = owned(ends).try_into() {
                self.loop_vectors.push((ends, letter.to_owned()));
            }
        }
        for (points, symbol) in [("GHL", "η_H"), ("EGF", "η_G"), ("LCK", "η_C")] {
            if let Ok(points) = owned(points).try_into() {
                self.corners.push((points, symbol.to_owned()));
            }
        }
        self
    }
}

/// A given position of a linkage. Its directions and links are lines, each from its first point to its second.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPosition {
    /// Number of the position.
    pub number: String,
    /// The given directions, each with a handle at its second point.
    pub directions: Vec<([Point; 2], Role)>,
    /// The links in this position.
    pub links: Vec<([Point; 2], Role)>,
}

/// Number of a wheel, written beside its rim. If the wheel's centre is the only point of its link, a plain shaft is
/// drawn there, without hinge or name.
#[derive(Clone, Debug, PartialEq)]
pub struct Tag {
    /// The link of the wheel.
    pub link: String,
    /// The text of the number.
    pub text: String,
    /// Direction from the wheel's centre, radians.
    pub direction: f64,
}

/// Numbers of mixing blades: on wheel 4, and on each wheel around it.
const BLADES: [usize; 2] = [3, 4];

/// Angle from the centre line of a wheel and its mate to the direction of the wheel's number, radians.
const BESIDE_LINE: f64 = 1.9;

/// Colours of wheel 4, and of wheels 5, 6, … around it.
const WHEELS: [Role; 1 + GearSet::MAX_WHEELS] = [
    Role::Accent1,
    Role::Accent2,
    Role::Accent3,
    Role::Accent4,
    Role::Accent5,
    Role::Accent6,
    Role::Accent7,
];

impl From<&Mixer> for Annotations {
    /// Returns the annotations of a mixer, with the symbols of fig. 1 and 4 of the paper by Smelyagin and Prikhodko.
    fn from(mixer: &Mixer) -> Self {
        let links = [
            ("crank", Role::Crank),
            ("coupler", Role::Coupler),
            ("rocker", Role::Rocker),
        ];
        let links = links.map(|(link, role)| (link.to_owned(), role));
        let pairs = mixer.gears.pairs();
        // The direction of the number of wheel 4 is measured from the centre line to the first wheel that it drives.
        let lines = pairs.first().into_iter().chain(pairs);
        let lines: Vec<f64> = lines.map(|pair| pair.centre_line()).collect();
        let wheels = || (0..lines.len()).map(|k| format!("wheel{}", k + 4));
        let blades = |k: usize| BLADES[k.min(1)];
        let tags = wheels().zip(&lines).enumerate();
        let numbers = [("crank", 1), ("coupler", 2), ("rocker", 3)];
        let numbers = numbers.map(|(link, number)| (link.to_owned(), number.to_string()));
        let numbered = wheels().enumerate();
        let numbered = numbered.map(|(k, link)| (link, (k + 4).to_string()));
        let numbers = numbers.into_iter().chain(numbered);
        let vectors = [
            ("A", "B", "l1"),
            ("B", "C", "l2"),
            ("D", "C", "l3"),
            ("A", "D", "l4"),
            ("B", "D", "l5"),
        ];
        let vectors = vectors.map(|(from, to, symbol)| {
            let ends = [from, to].map(str::to_owned);
            (ends, symbol.to_owned())
        });
        Self {
            roles: links.into_iter().chain(wheels().zip(WHEELS)).collect(),
            numbers: numbers.collect(),
            blades: wheels()
                .enumerate()
                .map(|(k, link)| (link, blades(k)))
                .collect(),
            tags: tags
                .map(|(k, (link, line))| Tag {
                    link,
                    text: (k + 4).to_string(),
                    direction: line + BESIDE_LINE,
                })
                .collect(),
            input: Some("φ₁".to_owned()),
            loop_vectors: vectors.to_vec(),
            corners: Vec::new(),
            given: Vec::new(),
            guidance: Guidance::default(),
            ground: None,
        }
    }
}
