//! What a random user presses, types and opens.

/// The centres of all that can be used and is seen, with what it is.
pub(super) const WITHIN_REACH: &str = "
    const found = [];
    const open = document.querySelector('dialog[open]') ?? document;
    for (const one of open.querySelectorAll('button, input, select, summary, a, textarea, canvas')) {
        const box = one.getBoundingClientRect();
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        if (box.width === 0 || x < 0 || y < 0 || x > innerWidth || y > innerHeight || one.disabled) continue;
        const hit = document.elementFromPoint(x, y);
        if (hit !== one && !one.contains(hit) && !hit?.contains(one)) continue;
        // A link that leaves the page ends the visit.
        if (one.localName === 'a' && one.href.split('#')[0] !== location.href.split('#')[0]) continue;
        const kind = one.localName === 'input' ? one.type : one.localName;
        found.push({ id: one.id, kind, x, y, width: box.width, height: box.height });
    }
    return found;";

/// What is written on the page that no reader should see.
pub(super) const NONSENSE: &str = r"
    const text = document.body.innerText;
    const labels = [...document.querySelectorAll('[aria-label], [aria-valuetext]')]
        .map((one) => `${one.ariaLabel} ${one.ariaValueText}`).join(' ');
    const values = [...document.querySelectorAll('input')].map((one) => one.dataset.typed ? '' : `${one.id} ${one.value}`).join(' ');
    // A range may have no end.
    const nonsense = /.{0,30}(?:\bNaN\b|undefined|Infinity|(?<!(?:…|<) )∞|\[object).{0,30}/g;
    return `${text} ${labels} ${values}`.match(nonsense) ?? [];";

/// Names of elements that another has as well.
pub(super) const TWICE: &str = "
    const ids = [...document.querySelectorAll('[id]')].map(({ id }) => id);
    return ids.filter((id, at) => ids.indexOf(id) !== at);";

/// The kept state with its picture, whose image is kept beside it.
pub(super) const KEPT: &str = "
    const text = localStorage.getItem('assur.state');
    if (text === null) return [];
    const { picture, ...rest } = JSON.parse(text);
    const image = localStorage.getItem('assur.image');
    return [JSON.stringify(picture && image ? { ...rest, picture: { ...picture, image } } : rest)];";

/// What is typed into a field.
pub(super) const TYPED: &[&str] = &[
    "0", "1", "-1", "0.5", "1,5", "2", "3", "12", "36", "170", "360", "1e3", "1e-9", "-0", "",
    "abc", "1.5.2", "9999999", "0.37", "π",
];

/// What somebody presses.
pub(super) const KEYS: &[(&str, i64)] = &[
    (" ", 32),
    ("ArrowLeft", 37),
    ("ArrowUp", 38),
    ("ArrowRight", 39),
    ("ArrowDown", 40),
    ("Home", 36),
    ("End", 35),
    ("Tab", 9),
    ("Enter", 13),
    ("Escape", 27),
    ("+", 187),
    ("-", 189),
    ("z", 90),
    ("y", 89),
    ("l", 76),
    ("t", 84),
    ("p", 80),
    ("s", 83),
    ("g", 71),
    ("e", 69),
    ("?", 191),
    ("0", 48),
    ("b", 66),
    ("k", 75),
    ("v", 86),
    ("c", 67),
    ("Delete", 46),
];

/// Sizes of windows.
pub(super) const SIZES: &[(u32, u32)] = &[
    (1280, 800),
    (1920, 1080),
    (360, 640),
    (740, 360),
    (600, 400),
    (1024, 768),
];

/// Addresses that are none, or not quite.
pub(super) const ADDRESSES: &[&str] = &[
    "1",
    "7&lesson=mixer",
    "1&lesson=clock&d.l1=1",
    "1&lesson=mixer&d.l1=NaN",
    "2&kind=linkage&d.points=[]",
    "2&kind=scheme&d.ground=x&d.pairs=[]&d.cut=[]&d.look_deg=[0,0]",
    "jansen",
    "peaucellier&v.playing=false&v.phi_deg=67.1146",
    "class4-dwell&v.lang=ru&v.lesson={\"id\":\"class4-dwell\",\"step\":3}",
    "class4-dwell&v.all_assemblies=true&v.others=true",
    "parallelogram&v.all_assemblies=true&v.playing=true",
    "crank-rocker&v.drawing=true",
    "jansen&v.polygons=true&v.centrodes=true&v.instant_centres=true&v.curvature=true",
    "crank-rocker&compared=%7B%22kind%22:%22linkage%22,%22document%22:%7B%22points%22:%5B%7B%22name%22:%22A%22,%22at%22:%5B0,0%5D%7D,%7B%22name%22:%22B%22,%22at%22:%5B1,1%5D%7D,%7B%22name%22:%22C%22,%22at%22:%5B4.5,4%5D%7D,%7B%22name%22:%22D%22,%22at%22:%5B6,0%5D%7D%5D,%22frame%22:%5B%22A%22,%22D%22%5D,%22links%22:%5B%7B%22name%22:%22crank%22,%22points%22:%5B%22A%22,%22B%22%5D%7D,%7B%22name%22:%22coupler%22,%22points%22:%5B%22B%22,%22C%22%5D%7D,%7B%22name%22:%22rocker%22,%22points%22:%5B%22D%22,%22C%22%5D%7D%5D,%22drivers%22:%5B%7B%22crank%22:%22crank%22%7D%5D%7D%7D",
    "no-such-mechanism",
    "<script>",
    "%%%",
];
