use assur::circuits::*;
use assur::mechanism::*;
use assur::motion::*;
use std::time::Instant;
fn main() {
    for name in std::env::args().skip(1) {
        let d = assur_file::document(&name).unwrap().unwrap();
        let l = d.linkage().unwrap();
        let m = l.mechanism().unwrap();
        let output = m.link_ids().next_back().unwrap();
        let t = Instant::now();
        let a = m.assemblies_at(m.home() + 0.1, Method::Usual);
        let ta = t.elapsed();
        let t = Instant::now();
        let mm = Motion::new(m.clone());
        let tm = t.elapsed();
        let t = Instant::now();
        let c = Circuits::of(&m, output);
        let tc = t.elapsed();
        println!(
            "== {name} at {ta:?} motion {tm:?} circuits {tc:?}: {} assemblies {:?}, whole {}, {} circuits",
            a.poses.len(),
            a.complex,
            c.is_whole(),
            c.count()
        );
        let _ = mm;
        for (k, b) in c.branches().iter().enumerate() {
            let cy = b.motion.cycle();
            println!(
                "  {} c{} full {} {:?} {:?}",
                k + 1,
                b.circuit + 1,
                cy.is_full(),
                cy.arcs()
                    .iter()
                    .map(|a| a.map(|x| x.to_degrees()))
                    .collect::<Vec<_>>(),
                b.motion
                    .dead_points()
                    .iter()
                    .map(|d| d.kind.code())
                    .collect::<Vec<_>>()
            );
        }
        for x in c.meetings() {
            println!(
                "  {:?} {:?} {:?} {:?}",
                x.kind,
                x.branches.map(|b| b + 1),
                x.inputs.map(|x| x.to_degrees()),
                x.dead_point.map(|d| c.branches()[x.branches[0]]
                    .motion
                    .links_at(&d)
                    .collect::<Vec<_>>()
                    .join(","))
            );
        }
    }
}
