//! Memory: sampling a motion allocates nothing, and a whole motion with its drawing takes little.

use std::fs;
use std::hint::black_box;

use allocation_counter::measure;
use assur::mechanism::Quantity;
use assur::motion::{InputRate, Motion};
use assur_draw::chart::Settings;
use assur_draw::{Figure, View};
use assur_file::{from_catalogue, from_text};
use assur_tests::files::root;

/// What is allocated while a motion is sampled all around, with two derivatives of
/// every place and angle, in a pose that was made before.
fn allocated(name: &str) -> u64 {
    let mechanism = from_catalogue(name).unwrap().unwrap().mechanism().unwrap();
    let motion = Motion::new(mechanism);
    let mechanism = motion.mechanism();
    let [from, to] = motion.cycle().axis();
    let mut pose = mechanism.blank::<3>();
    let mut sample = |input: f64| {
        motion.place(input, &mut pose).unwrap();
        for point in mechanism.point_ids() {
            black_box(mechanism.place(&pose, point));
        }
        for link in mechanism.link_ids() {
            black_box(mechanism.angle(&pose, link));
        }
    };
    // The first sample makes the room.
    sample(from);
    let around = measure(|| {
        for k in 0..3600 {
            sample(from + (to - from) * f64::from(k) / 3600.0);
        }
    });
    around.count_total
}

#[test]
fn samples_allocate_nothing() {
    for name in [
        "watt-1",
        "stephenson-3",
        "jansen",
        "slider-crank",
        "class3-platform",
        "class4-order2",
        "class4-dwell",
        "class5",
    ] {
        assert_eq!(allocated(name), 0, "{name}");
    }
}

/// Motions of very many turns and of very short steps were kept with every sample, and drawn with every pose, in
/// hundreds of megabytes.
#[test]
fn motions_and_their_drawings_take_little_room() {
    for name in [
        "hunting-wheels",
        "followed-far",
        "many-turns",
        "offset-10000",
    ] {
        let path = root().join(format!("tests/data/drawings/{name}.json"));
        let text = fs::read_to_string(path).unwrap();
        let room = measure(|| {
            let motion = from_text(&text).unwrap().motion().unwrap();
            let figure = Figure::new(&motion, &View::default()).unwrap();
            let mechanism = motion.mechanism();
            let angles = mechanism.link_ids().map(Quantity::Angle);
            let settings = Settings {
                input: InputRate::ANALOGUES,
                physical: false,
                differenced: false,
            };
            black_box(figure.chart(&angles.collect::<Vec<_>>(), settings));
        });
        assert!(room.bytes_max < 56 << 20, "{name}: {}", room.bytes_max);
    }
}

/// The counter counts.
#[test]
fn allocations_are_counted() {
    let info = measure(|| {
        black_box(vec![black_box(1.0)]);
    });
    assert_eq!(info.count_total, 1);
}
