//! Exploration.
use assur::motion::Motion;
#[test]
fn look() {
    let dir = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/published");
    let text = std::fs::read_to_string(format!("{dir}/pmks.txt")).unwrap();
    let mut all: Vec<(String, String)> = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let [name, _, link] = line.splitn(3, " | ").collect::<Vec<_>>()[..] else {
            panic!("{line}")
        };
        all.push((name.to_owned(), link.to_owned()));
    }
    let mut files: Vec<_> = std::fs::read_dir(format!("{dir}/linkage2"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    files.sort();
    for path in files {
        all.push((
            path.file_name().unwrap().to_str().unwrap().to_owned(),
            std::fs::read_to_string(&path).unwrap(),
        ));
    }
    for (name, text) in all {
        match assur_import::read(&text) {
            Err(problem) => println!("{name}: UNREAD {problem:?}"),
            Ok(read) => {
                println!(
                    "{name}: {} links, left {:?}",
                    read.document.links.len(),
                    read.left_out
                );
                match read.document.mechanism() {
                    Err(problems) => println!(
                        "   PROBLEMS {problems:?}\n {}",
                        serde_json::to_string(&read.document).unwrap()
                    ),
                    Ok(mechanism) => {
                        let turns = mechanism.turns();
                        let start = std::time::Instant::now();
                        let motion = Motion::new(mechanism);
                        println!(
                            "   turns {turns} cycle {:?} {:?}",
                            motion.cycle(),
                            start.elapsed()
                        );
                    }
                }
            }
        }
    }
}
