//! Failures of random linkages: counted by kind and reported with the seed. The smallest linkage of each kind is kept.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::{env, fs};

use assur::mechanism::{FRAME, LinkageSpec};
use assur_file::LinkageDocument;

use super::subject::Subject;

/// Something that does not hold of a linkage.
pub(crate) struct Failure {
    /// What differs, in a word or two.
    pub(crate) kind: String,
    /// With numbers.
    pub(crate) text: String,
    /// The drawing it was met with, if it is another than the linkage's own.
    pub(crate) drawn: Option<LinkageSpec>,
}

/// What was looked at.
#[derive(Default)]
pub(crate) struct Tally {
    pub(crate) failures: Vec<Failure>,
    pub(crate) held: u64,
    /// What the data do not determine, by what.
    pub(crate) open: BTreeMap<&'static str, u64>,
}

impl Tally {
    pub(crate) fn open(&mut self, what: &'static str) {
        *self.open.entry(what).or_default() += 1;
    }

    pub(crate) fn fail(&mut self, kind: &str, text: String, drawn: Option<&LinkageSpec>) {
        let (kind, drawn) = (kind.to_owned(), drawn.cloned());
        self.failures.push(Failure { kind, text, drawn });
    }
}

/// The smallest linkage that fails in a way.
struct Smallest {
    seed: u64,
    draft: LinkageSpec,
    failure: Failure,
}

#[derive(Default)]
pub(crate) struct Found {
    linkages: u64,
    /// Those with wheels on links that move.
    planetary: u64,
    none: u64,
    held: u64,
    open: BTreeMap<&'static str, u64>,
    failed: BTreeMap<String, u64>,
    seeds: BTreeMap<String, Vec<u64>>,
    smallest: BTreeMap<String, Smallest>,
}

impl Found {
    /// Looks at a linkage; where something fails, at the same with fewer parts as well.
    pub(crate) fn linkage(
        &mut self,
        seed: u64,
        parts: usize,
        holds: impl Fn(&Subject, &mut Tally),
    ) {
        let look = |parts: usize| {
            let mut tally = Tally::default();
            let subject = match Subject::new(seed, parts) {
                Ok(subject) => subject,
                Err(refused) if refused.sound => {
                    let text = format!("{:?}", refused.defects);
                    tally.fail("sound drawing refused", text, None);
                    return Some((refused.draft, tally));
                }
                Err(_) => return None,
            };
            holds(&subject, &mut tally);
            // Other equations, other faults: by the class, and whether whole turns count.
            let class = subject.motion.mechanism().structure().class();
            let geared = if subject.draft.gears.is_empty() {
                ""
            } else {
                ", geared"
            };
            for failure in &mut tally.failures {
                failure.kind += &format!(", class {class}{geared}");
            }
            Some((subject.draft, tally))
        };
        let Some((draft, tally)) = look(parts) else {
            self.none += 1;
            return;
        };
        self.linkages += 1;
        let mut gears = draft.gears.iter();
        self.planetary += u64::from(gears.any(|gear| gear.carrier != FRAME));
        self.held += tally.held;
        for (what, count) in &tally.open {
            *self.open.entry(what).or_default() += count;
        }
        if tally.failures.is_empty() {
            return;
        }
        for failure in &tally.failures {
            let kind = failure.kind.clone();
            *self.failed.entry(kind.clone()).or_default() += 1;
            let seeds = self.seeds.entry(kind).or_default();
            if seeds.last() != Some(&seed) {
                seeds.push(seed);
            }
        }
        self.keep(seed, draft, tally.failures);
        for fewer in 0..parts {
            if let Some((draft, tally)) = look(fewer) {
                self.keep(seed, draft, tally.failures);
            }
        }
    }

    fn keep(&mut self, seed: u64, draft: LinkageSpec, failures: Vec<Failure>) {
        for failure in failures {
            let smaller = |kept: &Smallest| kept.draft.links.len() > draft.links.len();
            if self.smallest.get(&failure.kind).is_none_or(smaller) {
                let draft = draft.clone();
                let kind = failure.kind.clone();
                let smallest = Smallest {
                    seed,
                    draft,
                    failure,
                };
                self.smallest.insert(kind, smallest);
            }
        }
    }

    /// Says what was found, and keeps the smallest linkages as files.
    ///
    /// # Panics
    /// Where anything does not hold, or hardly anything was looked at.
    pub(crate) fn tell(&self, what: &str) {
        println!(
            "{what}: {} linkages, {} with wheels on carriers ({} drawings are none), {} comparisons hold; not determined: {:?}",
            self.linkages, self.planetary, self.none, self.held, self.open
        );
        let folder = env::var("ASSUR_FOUND").map_or_else(
            |_| PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("any_drawing"),
            PathBuf::from,
        );
        let mut said = String::new();
        for (kind, smallest) in &self.smallest {
            let Smallest {
                seed,
                draft,
                failure,
            } = smallest;
            let name = format!(
                "{what}-{}-{seed}",
                kind.replace(", ", "-").replace(' ', "-")
            );
            fs::create_dir_all(&folder).unwrap();
            let write = |draft: &LinkageSpec, name: &str| {
                let text = serde_json::to_string(&LinkageDocument::new(draft)).unwrap();
                fs::write(folder.join(format!("{name}.json")), text).unwrap();
            };
            write(draft, &name);
            if let Some(drawn) = &failure.drawn {
                write(drawn, &format!("{name}-redrawn"));
            }
            said += &format!(
                "{kind}: {} times, seeds {:?}; smallest {name}.json, {} links: {}\n",
                self.failed.get(kind).copied().unwrap_or_default(),
                self.seeds
                    .get(kind)
                    .map_or(&[][..], |seeds| &seeds[..seeds.len().min(12)]),
                draft.links.len(),
                failure.text
            );
        }
        assert!(
            said.is_empty(),
            "{what}: files in {}\n{said}",
            folder.display()
        );
        let open: u64 = self.open.values().sum();
        assert!(
            self.held > 4 * open,
            "{} hold, {open} are left open",
            self.held
        );
        assert!(self.linkages > 2 * self.none, "{} are none", self.none);
        assert!(
            5 * self.planetary > self.linkages,
            "{} with wheels on carriers",
            self.planetary
        );
    }
}
