#![allow(clippy::all, clippy::pedantic, missing_docs, clippy::panic)]
use assur::catalog::mixer::{Carrier, Case, Dimensions, Mixer, Tracer};
use assur::gears::{Mate, Mesh};
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur_draw::{Annotations, Figure, LABELS, Overlays, Scene, View};

#[derive(Debug, Clone)]
struct Rec {
    kind: u8,
    role: u8,
    look: u8,
    pts: Vec<[f64; 2]>,
    text: String,
    n: Vec<usize>,
}

fn flat(mut numbers: &[f32], poses: &[[f64; 3]], names: &[String]) -> Vec<Rec> {
    let mut out = Vec::new();
    let mut body = 0;
    while let Some(kind) = numbers.first() {
        let p = poses[body];
        let w = |x: f32, y: f32| {
            let (s, c) = p[2].sin_cos();
            let (x, y) = (x as f64, y as f64);
            [p[0] + c * x - s * y, p[1] + s * x + c * y]
        };
        let len = match *kind as u8 {
            0 => {
                body = numbers[1] as usize;
                2
            }
            1 => {
                let mut l = 4;
                let mut pts = vec![];
                let mut n = vec![];
                for _ in 0..numbers[3] as usize {
                    let c = numbers[l] as usize;
                    n.push(c);
                    for k in 0..c {
                        pts.push(w(numbers[l + 1 + 2 * k], numbers[l + 2 + 2 * k]));
                    }
                    l += 1 + 2 * c;
                }
                out.push(Rec {
                    kind: 1,
                    role: numbers[1] as u8,
                    look: numbers[2] as u8,
                    pts,
                    text: String::new(),
                    n,
                });
                l
            }
            2 => {
                let c = numbers[3] as usize;
                let pts = (0..c)
                    .map(|k| w(numbers[4 + 2 * k], numbers[5 + 2 * k]))
                    .collect();
                out.push(Rec {
                    kind: 2,
                    role: numbers[1] as u8,
                    look: numbers[2] as u8,
                    pts,
                    text: String::new(),
                    n: vec![],
                });
                4 + 2 * c
            }
            3 => {
                out.push(Rec {
                    kind: 3,
                    role: numbers[1] as u8,
                    look: numbers[2] as u8,
                    pts: vec![w(numbers[3], numbers[4]), [numbers[5] as f64, 0.0]],
                    text: String::new(),
                    n: vec![],
                });
                6
            }
            4 => {
                out.push(Rec {
                    kind: 4,
                    role: numbers[1] as u8,
                    look: 0,
                    pts: vec![
                        w(numbers[3], numbers[4]),
                        [numbers[5] as f64, numbers[6] as f64],
                    ],
                    text: names[numbers[2] as usize].clone(),
                    n: vec![],
                });
                7
            }
            _ => panic!(),
        };
        numbers = &numbers[len..];
    }
    out
}

fn all(rigid: &[f32], frame: &[f32], names: &[String]) -> (Vec<Rec>, Vec<Rec>) {
    let n = frame[0] as usize;
    let poses: Vec<[f64; 3]> = (0..n)
        .map(|k| [0, 1, 2].map(|i| frame[1 + 3 * k + i] as f64))
        .collect();
    let mut a = flat(rigid, &poses, names);
    a.extend(flat(&frame[1 + 3 * n..], &poses, names));
    let (labels, shapes) = a.into_iter().partition(|r| r.kind == 4);
    (shapes, labels)
}

fn compare(d: &Dimensions, overlays: Overlays, phis: &[f64], what: &str) {
    let mixer = Mixer::new(d).unwrap();
    let scene = Scene::new(&mixer, overlays);
    let draft = mixer.draft().unwrap();
    let mechanism = Mechanism::new(&draft).unwrap();
    let motion = Motion::new(&mechanism, mechanism.drawn_assembly());
    let traced = ["B", "C"]
        .map(|n| mechanism.points().position(|p| p == n).unwrap())
        .to_vec();
    let figure = Figure::new(
        &draft,
        &motion,
        &View {
            overlays,
            traced,
            annotations: Annotations::from(&mixer),
        },
    )
    .unwrap();
    println!(
        "== {what}: bounds {:?} {:?}",
        scene.bounds(),
        figure.bounds()
    );
    let off = (0..4)
        .map(|i| (scene.bounds()[i] - figure.bounds()[i]).abs())
        .fold(0.0, f64::max);
    println!(
        "   bounds off {off:.2e}; arcs {:?} {:?}",
        mixer.linkage.cycle().arcs(),
        motion.cycle().arcs()
    );
    for phi in phis {
        let (Ok(f), Ok(pose)) = (scene.frame(*phi), motion.pose::<3>(*phi)) else {
            println!("no pose at {phi}");
            continue;
        };
        let names: Vec<String> = LABELS.map(str::to_owned).to_vec();
        let (s, sl) = all(scene.rigid().numbers(), &f, &names);
        let (g, gl) = all(
            figure.rigid().numbers(),
            &figure.frame(&pose),
            figure.names(),
        );
        println!("  at {phi}: shapes {} {}", s.len(), g.len());
        let mut worst = 0.0f64;
        let mut shown = 0;
        // by greedy order
        for (k, (a, b)) in s.iter().zip(&g).enumerate() {
            let same = a.kind == b.kind
                && a.role == b.role
                && a.look == b.look
                && a.pts.len() == b.pts.len()
                && a.n == b.n;
            if !same {
                if shown < 6 {
                    println!(
                        "    {k}: {:?} vs {:?}",
                        (a.kind, a.role, a.look, a.pts.len(), a.pts[0]),
                        (b.kind, b.role, b.look, b.pts.len(), b.pts[0])
                    );
                }
                shown += 1;
                continue;
            }
            // each point of a near some point of b
            let dist = |a: &Rec, b: &Rec| -> f64 {
                if a.kind == 3 {
                    return ((a.pts[0][0] - b.pts[0][0]).hypot(a.pts[0][1] - b.pts[0][1]))
                        .max((a.pts[1][0] - b.pts[1][0]).abs());
                }
                a.pts
                    .iter()
                    .map(|p| {
                        b.pts
                            .iter()
                            .map(|q| (p[0] - q[0]).hypot(p[1] - q[1]))
                            .fold(f64::INFINITY, f64::min)
                    })
                    .fold(0.0, f64::max)
            };
            let e = dist(a, b);
            if e > 2e-6 {
                if shown < 6 {
                    println!(
                        "    {k}: {:?} off {e:.2e}",
                        (a.kind, a.role, a.look, a.pts.len())
                    );
                }
                shown += 1;
            }
            worst = worst.max(e);
        }
        println!("    worst {worst:.2e}, {shown} differ");
        let order = |l: &[Rec]| {
            l.iter()
                .map(|r| r.text.clone())
                .collect::<Vec<_>>()
                .join(" ")
        };
        println!("    labels {} | {}", order(&sl), order(&gl));
        for a in &sl {
            let text = match a.text.as_str() {
                "phi1" => "φ₁=input".to_owned(),
                "mu" => "μ=C.transmission".to_owned(),
                t => t.to_owned(),
            };
            let Some(b) = gl.iter().find(|b| b.text == text) else {
                println!("    label {text} missing");
                continue;
            };
            let e = (0..2)
                .map(|i| (a.pts[i][0] - b.pts[i][0]).hypot(a.pts[i][1] - b.pts[i][1]))
                .fold(0.0, f64::max);
            if e > 1e-5 || a.role != b.role {
                println!(
                    "    label {text}: {:?} {:?} roles {} {}",
                    a.pts, b.pts, a.role, b.role
                );
            }
        }
    }
}

#[test]
fn compares() {
    let o = Overlays {
        traces: true,
        centres: true,
        vectors: true,
        loop_vectors: true,
        transmission: true,
        groups: false,
    };
    for case in Case::ALL {
        compare(
            &case.dimensions(),
            Overlays::default(),
            &[0.3, 1.0, 4.0],
            &format!("{case:?} plain"),
        );
        compare(
            &case.dimensions(),
            o,
            &[0.3, 1.0, 4.0],
            &format!("{case:?}"),
        );
    }
    let mut d = Case::A.dimensions();
    d.mesh = Mesh::Internal;
    compare(&d, o, &[1.0, 3.0], "internal");
    let mut d = Case::C.dimensions();
    d.mesh = Mesh::Internal;
    compare(&d, o, &[1.0, 3.0], "internal C");
    let mut d = Case::A.dimensions();
    d.mesh = Mesh::AsPrinted;
    compare(&d, o, &[1.0, 3.0], "as printed");
    d.wheels = (0..6)
        .map(|i| Mate {
            teeth: 18.0 - f64::from(i),
            centre_line: f64::from(i) * std::f64::consts::TAU / 6.0,
        })
        .collect();
    compare(&d, o, &[1.0, 3.0], "six printed");
    d.mesh = Mesh::External;
    compare(&d, o, &[1.0, 3.0], "six");
    d.tracers = [
        (Carrier::Crank, 0.2, 0.1),
        (Carrier::Coupler, 0.4, 0.25),
        (Carrier::Rocker, 0.3, -0.1),
        (Carrier::Wheel(0), 0.1, 0.0),
        (Carrier::Wheel(5), 0.0, 0.08),
    ]
    .map(|(carrier, x, y)| Tracer { carrier, x, y })
    .to_vec();
    compare(&d, Overlays::default(), &[1.0, 3.0], "six traced");
    for lengths in [[0.6, 0.85, 0.3, 0.85], [0.5; 4], [0.3, 0.6, 0.4, 1.0]] {
        let mut d = Case::A.dimensions();
        d.lengths = lengths;
        compare(&d, o, &[0.2, 1.0, 5.8], &format!("{lengths:?}"));
    }
    let mut d = Case::A.dimensions();
    d.assembly = assur::Assembly::Second;
    compare(&d, o, &[1.0], "second");
}
