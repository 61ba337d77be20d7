//! Keys that scripts compose, and the sources of their parts.

/// Keys that scripts build: how they begin, and the sources in one of which the
/// rest of every such key is named.
pub(super) const BUILT: [(&str, &[&str]); 90] = [
    ("under_load.motor.", &["www/under-load/fields.js"]),
    ("about.", &["crates/assur-file/src/catalogue.rs"]),
    ("assembly.", &["www/kinds/mixer/rail.js"]),
    ("become.", &["crates/assur-file/src/kinds/mod.rs"]),
    ("compare.", &["www/controls/comparing.js"]),
    (
        "field.",
        &[
            "crates/assur-file/src/kinds/mod.rs",
            "crates/assur-file/src/lesson.rs",
            "crates/assur-file/src/lesson/varied.rs",
            "crates/assur-file/src/picture.rs",
            "crates/assur-file/src/problem.rs",
            "crates/assur-file/src/kinds/mod.rs",
            "crates/assur-file/src/state.rs",
            "crates/assur-file/src/view.rs",
            "crates/assur-web/src/measures.rs",
            "crates/assur-web/src/moving.rs",
            "crates/assur-web/src/pair.rs",
            "www/kinds/mixer/rail.js",
            "www/kinds/mixer/lists.js",
            "www/kinds/linkage/rail.js",
            "www/kinds/linkage/course.js",
            "www/kinds/linkage/design.js",
            "www/forces/masses.js",
        ],
    ),
    ("field.points.", &["www/kinds/linkage/rail.js"]),
    ("field.body.", &["crates/assur-file/src/kinds/poses.rs"]),
    ("field.region.", &["crates/assur-file/src/kinds/poses.rs"]),
    // Masses and loads: names of fields, of links and of forces.
    ("field.bars.", MASSES),
    ("field.dampers.", SPRINGS),
    ("field.friction.", FRICTION),
    ("field.loads.", LOADS),
    ("field.masses.", MASSES),
    ("field.springs.", SPRINGS),
    ("field.terms.", LOADS),
    ("name.bars.", MASSES),
    ("name.dampers.", SPRINGS),
    ("name.friction.", FRICTION),
    ("name.loads.", LOADS),
    ("name.masses.", MASSES),
    ("name.springs.", SPRINGS),
    ("name.terms.", LOADS),
    (
        "forces.",
        &[
            "www/forces/friction-list.js",
            "www/forces/load-list.js",
            "www/forces/loads.js",
            "www/forces/panel.js",
        ],
    ),
    ("forces.drive.", REACTIONS),
    ("forces.gravity.", MASSES),
    ("forces.law.", LOADS),
    ("forces.loads.", LOADS),
    ("forces.of.", REACTIONS),
    ("forces.plot.", &["crates/assur-web/src/chart.rs"]),
    ("forces.unit.", &["www/forces/fields.js"]),
    ("field.tracers.", &["www/kinds/mixer/lists.js"]),
    ("dead.", &["crates/assur/src/motion/dead_point.rs"]),
    (
        "dwell.",
        &[
            "crates/assur-web/src/profile.rs",
            "www/kinds/linkage/course.js",
        ],
    ),
    ("draw.", &["www/drawing/rail.js"]),
    ("draw.act.", &["www/drawing/rail.js"]),
    ("draw.mend.", &["www/drawing/reasons.js"]),
    ("draw.picture.", &["www/drawing/picture-options.js"]),
    ("draw.prompt.", &["www/drawing/tools.js"]),
    ("draw.short.", &["www/drawing/tools.js"]),
    ("draw.tool.", &["www/drawing/tools.js"]),
    ("equations.", &["www/kinds/linkage/equations.js"]),
    ("gallery.", &["crates/assur-file/src/catalogue.rs"]),
    ("gallery.group.", &["www/gallery/cards.js"]),
    ("grashof.", &["crates/assur/src/four_bar/grashof.rs"]),
    ("lang.", &["www/core/words.js"]),
    // Verdicts of answers.
    ("lesson.", &["www/lesson/panel.js"]),
    // Whether an item of a paper holds.
    ("lesson.printed.", &["crates/xtask/build/papers.js"]),
    ("lesson.instead.", &["crates/xtask/build/papers.js"]),
    // What the mechanisms of the catalogue call their links.
    ("link.", LINKS),
    ("import.", &["crates/assur-import/src/left_out.rs"]),
    ("kind.", &["crates/assur-file/src/kinds/mod.rs"]),
    // By what the input is.
    ("axes.physical.", MOVES),
    ("input.", &[]),
    ("input.epsilon.", MOVES),
    ("input.instant.", MOVES),
    ("input.omega.", MOVES),
    ("input.true_time.", MOVES),
    ("readouts.input.", MOVES),
    ("told.axis.", MOVES),
    ("told.now.", MOVES),
    ("transport.", &["www/controls/transport.js"]),
    ("transport.input.", MOVES),
    ("transport.scrubber.", MOVES),
    ("transport.true_time.", MOVES),
    (
        "unit.",
        &[
            "www/controls/lengths.js",
            "www/lessons/mixer-forces/lesson.js",
        ],
    ),
    ("mesh.", &["www/kinds/mixer/rail.js"]),
    (
        "name.",
        &[
            "www/kinds/mixer/rail.js",
            "www/kinds/mixer/lists.js",
            "www/kinds/linkage/course.js",
            "www/kinds/linkage/design.js",
            "www/kinds/linkage/rail.js",
            "www/forces/masses.js",
        ],
    ),
    ("name.tracers.", &["www/kinds/mixer/lists.js"]),
    ("notice.", &["www/app/opening.js", "www/app/notices.js"]),
    // Of a panel: its kind, by what its derivatives are, its order.
    ("plots.", &[]),
    ("plots.overview.", MOVES),
    ("plots.angle.by_time.", ORDERS),
    ("plots.angle.analogue.", ORDERS),
    ("plots.angle.value.", ORDERS),
    ("plots.length.by_time.", ORDERS),
    ("plots.length.analogue.", ORDERS),
    ("plots.length.value.", ORDERS),
    ("preset.", &["crates/assur-file/src/catalogue.rs"]),
    (
        "problem.",
        &[
            "crates/assur/src/linkage/spec.rs",
            "crates/assur-file/src/kinds/linkage/problem.rs",
            "crates/assur-file/src/problem.rs",
            "crates/assur-file/src/lesson/problem.rs",
            "crates/assur-file/src/picture.rs",
            "crates/assur-import/src/problem.rs",
            "www/app/notices.js",
            "www/drawing/edit.js",
            "www/drawing/picture.js",
            "www/drawing/picture-options.js",
            "www/drawing/tools.js",
            "www/embed/embed.js",
            "www/state/codec.js",
            "www/engine.js",
            "www/state/model.js",
            "www/app/opening.js",
        ],
    ),
    (
        "readouts.",
        &["www/plots/readouts.js", "www/core/symbols.js"],
    ),
    (
        "slider.",
        &[
            "www/kinds/mixer/rail.js",
            "www/kinds/mixer/lists.js",
            "www/kinds/linkage/rail.js",
        ],
    ),
    ("source.", &["crates/assur-file/src/catalogue.rs"]),
    (
        "status.",
        &["www/kinds/mixer/status.js", "www/kinds/linkage/status.js"],
    ),
    ("told.", &["www/app/description.js"]),
    // The form of a lecturer: its fields and buttons.
    (
        "write.",
        &[
            "www/lesson/asking.js",
            "www/lesson/fields.js",
            "www/lesson/results.js",
            "www/lesson/writer.js",
        ],
    ),
    ("write.sort.", &["www/lesson/steps.js"]),
    ("write.vary.", &["www/lesson/varying.js"]),
    ("write.whole.", &["www/lesson/tasks.js"]),
    ("tracers.", &["www/kinds/mixer/lists.js"]),
];

/// Who names the fields of masses, loads, springs and dampers, and forces.
const MASSES: &[&str] = &["www/forces/masses.js"];
const LOADS: &[&str] = &["www/forces/load-list.js"];
const SPRINGS: &[&str] = &["www/forces/spring-list.js"];
const FRICTION: &[&str] = &["www/forces/friction-list.js"];
const REACTIONS: &[&str] = &["crates/assur-web/src/reactions.rs"];

/// Who says what the input is, an angle, a length or time, and what is plotted by it.
pub(super) const MOVES: &[&str] = &[
    "crates/assur-web/src/summary.rs",
    "crates/assur-web/src/kinds/gear_train/summary.rs",
];

/// Who counts the orders of derivatives.
pub(super) const ORDERS: &[&str] = &["crates/assur-draw/src/chart.rs"];

/// Who names links: the mechanisms of the catalogue, the mixer, the engine its frame.
pub(super) const LINKS: &[&str] = &[
    "crates/assur/src/linkage/spec.rs",
    "crates/assur-edit/src/masses.rs",
    "crates/assur-file/src/kinds/mixer.rs",
    "crates/assur-file/catalogue/cardan-trammel.json",
    "crates/assur-file/catalogue/chebyshev.json",
    "crates/assur-file/catalogue/class3-platform.json",
    "crates/assur-file/catalogue/coupled-cranks.json",
    "crates/assur-file/catalogue/elliptic-trammel.json",
    "crates/assur-file/catalogue/evans.json",
    "crates/assur-file/catalogue/jaw-crusher.json",
    "crates/assur-file/catalogue/jansen.json",
    "crates/assur-file/catalogue/klann.json",
    "crates/assur-file/catalogue/oldham.json",
    "crates/assur-file/catalogue/planetary.json",
    "crates/assur-file/catalogue/pump-jack.json",
    "crates/assur-file/catalogue/scotch-yoke.json",
    "crates/assur-file/catalogue/slider-crank.json",
    "crates/assur-file/catalogue/sun-and-planet.json",
    "crates/assur-file/catalogue/toggle-press.json",
    "crates/assur-file/catalogue/triple-rocker.json",
    "crates/assur-file/catalogue/v-twin.json",
    "crates/assur-file/catalogue/watt-2.json",
    "crates/assur-file/catalogue/whitworth.json",
    "crates/assur-file/catalogue/wiper.json",
    "www/lessons/mobility/presets.json",
];
