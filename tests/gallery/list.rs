//! The list of the linkages of the gallery.

/// Name, structural formula, and whether its crank turns fully.
pub(super) const GALLERY: [(&str, &str, bool); 45] = [
    ("crank-rocker", "I(frame,crank) → II₂(coupler,rocker)", true),
    (
        "double-crank",
        "I(frame,crank) → II₂(coupler,follower)",
        true,
    ),
    (
        "double-rocker",
        "I(left rocker,coupler) → II₂(left rocker+coupler,right rocker)",
        true,
    ),
    (
        "triple-rocker",
        "I(frame,left rocker) → II₂(coupler,right rocker)",
        false,
    ),
    (
        "parallelogram",
        "I(frame,crank) → II₂(coupler,follower)",
        true,
    ),
    (
        "antiparallelogram",
        "I(frame,crank) → II₂(coupler,follower)",
        true,
    ),
    (
        "coupled-cranks",
        "I(frame,crank) → II₂(rod,second crank) → q₁(third crank)",
        true,
    ),
    ("pump-jack", "I(frame,crank) → II₂(pitman,beam)", true),
    ("slider-crank", "I(frame,crank) → II₂(rod,slider)", true),
    (
        "slider-crank-offset",
        "I(frame,crank) → II₂(rod,slider)",
        true,
    ),
    (
        "inverted-slider-crank",
        "I(frame,crank) → II₂(block,lever)",
        true,
    ),
    (
        "whitworth",
        "I(frame,crank) → II₂(block,lever) → II₂(rod,ram)",
        true,
    ),
    ("scotch-yoke", "I(frame,crank) → II₂(block,yoke)", true),
    (
        "elliptic-trammel",
        "I(horizontal slider,rod) → II₂(horizontal slider+rod,vertical slider)",
        true,
    ),
    (
        "oldham",
        "I(frame,input shaft) → II₂(disc,output shaft)",
        true,
    ),
    (
        "shaper",
        "I(frame,crank) → II₂(block,lever) → II₂(rod,ram)",
        true,
    ),
    (
        "jaw-crusher",
        "I(frame,crank) → II₂(pitman,rear toggle) → II₂(front toggle,jaw)",
        true,
    ),
    (
        "toggle-press",
        "I(frame,crank) → II₂(rod,upper toggle) → II₂(lower toggle,slider)",
        true,
    ),
    (
        "v-twin",
        "I(frame,crank) → II₂(right rod,right piston) → II₂(left rod,left piston)",
        true,
    ),
    (
        "wiper",
        "I(frame,crank) → II₂(rod,left wiper) → II₂(link,right wiper)",
        true,
    ),
    (
        "watt-1",
        "I(frame,crank) → II₂(coupler,rocker) → II₂(EG,FG)",
        true,
    ),
    (
        "watt-2",
        "I(frame,crank) → II₂(coupler,rocker) → II₂(link,output)",
        true,
    ),
    (
        "stephenson-1",
        "I(frame,crank) → II₂(coupler,rocker) → II₂(EG,FG)",
        true,
    ),
    (
        "stephenson-2",
        "I(frame,crank) → III₃(BP,EQ,platform,rocker)",
        true,
    ),
    (
        "stephenson-3",
        "I(frame,crank) → II₂(coupler,rocker) → II₂(link,output)",
        true,
    ),
    ("chebyshev", "I(frame,lever) → II₂(coupler,follower)", false),
    ("hoeken", "I(frame,crank) → II₂(coupler,rocker)", true),
    (
        "roberts",
        "I(frame,left rocker) → II₂(coupler,right rocker)",
        false,
    ),
    (
        "watt-line",
        "I(frame,left rocker) → II₂(coupler,right rocker)",
        false,
    ),
    (
        "evans",
        "I(frame,short rocker) → II₂(beam,long rocker)",
        false,
    ),
    ("scott-russell", "I(frame,crank) → II₂(rod,slider)", true),
    (
        "cardan-trammel",
        "I(frame,crank) → II₂(bar,slider) → q₁(second slider)",
        true,
    ),
    (
        "peaucellier",
        "I(frame,crank) → II₂(OB,CB) → II₂(OD,CD) → II₂(BE,DE)",
        false,
    ),
    (
        "pantograph",
        "I(frame,crank) → II₂(coupler,rocker) → II₂(OF,EP) → II₂(FQ,PG)",
        true,
    ),
    (
        "klann",
        "I(frame,crank) → II₂(rod,lower rocker) → II₂(leg,upper rocker)",
        true,
    ),
    (
        "jansen",
        "I(frame,crank) → II₂(j,upper triangle) → II₂(k,c) → II₂(f,foot)",
        true,
    ),
    (
        "geared-five-bar",
        "I(frame,crank) → II₂(follower) → II₂(BC,DC)",
        true,
    ),
    (
        "sun-and-planet",
        "I(frame,sun) → III₃(carrier,rod,beam)",
        true,
    ),
    (
        "planetary",
        "I(frame,sun) → III₃(carrier,planet) → II₂(planet 2) → II₂(planet 3)",
        true,
    ),
    (
        "differential",
        "I(frame,sun) → I(frame,ring) → III₃(carrier,planet) → II₂(planet 2) → II₂(planet 3)",
        true,
    ),
    (
        "class3-platform",
        "I(frame,crank) → III₃(BP,platform,GQ,HR)",
        true,
    ),
    (
        "class3-slide",
        "I(frame,crank) → III₃(BP,platform,GQ,slider)",
        true,
    ),
    ("class4-order2", "I(frame,crank) → IV₂(BCE,CF,EH,DFH)", true),
    (
        "class4-dwell",
        "I(frame,AB) → IV₃(BE,EGF,HGL,CLK,FK,CD)",
        true,
    ),
    ("class5", "I(frame,crank) → V₃(BTP,PQ,DQR,RSU,ST,HU)", true),
];
