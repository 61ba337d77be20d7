//! Somebody who does whatever comes to hand: clicks, drags, types, turns the wheel,
//! presses keys, changes the window, follows wrong addresses. Nothing may be thrown, no
//! number may be none, and what the browser keeps must open again.
//!
//! `ASSUR_SCALE` says for how long, `ASSUR_SEED` where the dice begin; a failure names the seed and the last acts.

mod means;

use std::collections::VecDeque;
use std::env;

use assur_file::State;
use assur_tests::scaled;
use serde_json::{Value, json};

use crate::browser::Page;
use crate::browser::setting::lacking;
use crate::dice::Dice;
use crate::host::home;
use means::{ADDRESSES, KEPT, KEYS, NONSENSE, SIZES, TWICE, TYPED, WITHIN_REACH};

/// What is not to be used here: it leaves the page, or hands over to the system.
const LEFT_ALONE: &[&str] = &["print", "file-open"];

struct Hand<'a> {
    page: &'a Page,
    dice: Dice,
    done: VecDeque<String>,
}

/// Whatever fails, what was done last is told.
impl Drop for Hand<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("done last: {:#?}", self.done);
        }
    }
}

impl Hand<'_> {
    fn note(&mut self, what: String) {
        self.done.push_back(what);
        if self.done.len() > 12 {
            self.done.pop_front();
        }
    }

    async fn mouse(&self, what: &str, (x, y): (f64, f64), more: Value) {
        let mut event = json!({ "type": what, "x": x, "y": y, "button": "left", "clickCount": 1 });
        for (key, value) in more.as_object().into_iter().flatten() {
            event[key] = value.clone();
        }
        self.page.tool("Input.dispatchMouseEvent", event).await;
    }

    async fn click(&self, at: (f64, f64)) {
        for what in ["mouseMoved", "mousePressed", "mouseReleased"] {
            self.mouse(what, at, json!({})).await;
        }
    }

    async fn key(&self, (key, code): (&str, i64), modifiers: i64) {
        for what in ["rawKeyDown", "keyUp"] {
            let event = json!({ "type": what, "key": key, "windowsVirtualKeyCode": code,
                "modifiers": modifiers });
            self.page.tool("Input.dispatchKeyEvent", event).await;
        }
    }

    /// Does one thing.
    async fn act(&mut self) {
        let found = self.page.ask(WITHIN_REACH).await;
        let found = found.as_array().unwrap();
        match self.dice.below(20) {
            0 => {
                let size = *self.dice.one(SIZES);
                self.note(format!("window {size:?}"));
                self.page.screen(size, 1.0).await;
            }
            1 => {
                let address = *self.dice.one(ADDRESSES);
                self.note(format!("address {address}"));
                let script = format!("location.hash = {};", json!(address));
                self.page.ask(&script).await;
            }
            2..=5 => {
                let key = *self.dice.one(KEYS);
                let control = if self.dice.below(4) == 0 { 2 } else { 0 };
                self.note(format!("key {control} {}", key.0));
                self.key(key, control).await;
            }
            _ if found.is_empty() => self.key(("Escape", 27), 0).await,
            _ => {
                let one = self.dice.one(found).clone();
                self.use_one(&one).await;
            }
        }
    }

    async fn use_one(&mut self, one: &Value) {
        let id = one["id"].as_str().unwrap().to_owned();
        let kind = one["kind"].as_str().unwrap().to_owned();
        if kind == "file" || LEFT_ALONE.contains(&id.as_str()) {
            return;
        }
        let number = |key: &str| one[key].as_f64().unwrap();
        let at = (number("x"), number("y"));
        let (width, height) = (number("width"), number("height"));
        let within = |dice: &mut Dice| {
            let part = |dice: &mut Dice| dice.below(1000) as f64 / 1000.0 - 0.5;
            (at.0 + width * part(dice), at.1 + height * part(dice))
        };
        match kind.as_str() {
            "canvas" | "range" => {
                let (from, to) = (within(&mut self.dice), within(&mut self.dice));
                self.note(format!("drag {id} {from:?} {to:?}"));
                if self.dice.below(5) == 0 {
                    let by = *self.dice.one(&[-240, 240]);
                    let wheel = json!({ "deltaX": 0, "deltaY": by });
                    self.mouse("mouseWheel", from, wheel).await;
                    return;
                }
                self.mouse("mouseMoved", from, json!({})).await;
                self.mouse("mousePressed", from, json!({})).await;
                for step in 1..=4 {
                    let part = f64::from(step) / 4.0;
                    let on = |a: f64, b: f64| a + (b - a) * part;
                    let held = json!({ "buttons": 1 });
                    self.mouse("mouseMoved", (on(from.0, to.0), on(from.1, to.1)), held)
                        .await;
                }
                self.mouse("mouseReleased", to, json!({})).await;
            }
            "text" | "search" | "textarea" => {
                let text = *self.dice.one(TYPED);
                self.note(format!("type {id} {text}"));
                self.click(at).await;
                self.key(("a", 65), 2).await;
                let mark = "document.activeElement?.setAttribute?.('data-typed', '');";
                self.page.ask(mark).await;
                self.page
                    .tool("Input.insertText", json!({ "text": text }))
                    .await;
                let end = *self.dice.one(&[("Enter", 13), ("Tab", 9)]);
                self.key(end, 0).await;
            }
            "select" => {
                let turn = self.dice.below(1000);
                self.note(format!("choose {id} {turn}"));
                // The list itself is the system's: what is chosen there comes as these events.
                let script = format!(
                    "const select = document.getElementById({});
                    if (!select || select.options.length === 0) return;
                    select.selectedIndex = {turn} % select.options.length;
                    for (const kind of ['input', 'change']) select.dispatchEvent(new Event(kind, {{ bubbles: true }}));",
                    json!(id)
                );
                self.page.ask(&script).await;
            }
            _ => {
                self.note(format!("click {kind} {id}"));
                self.click(at).await;
            }
        }
    }

    /// What has gone wrong, if anything has.
    async fn wrong(&self) -> Option<String> {
        let said = self.page.said().await;
        if !said.is_empty() {
            return Some(format!("on the console: {said:#?}"));
        }
        let nonsense = self.page.ask(NONSENSE).await;
        if nonsense != json!([]) {
            return Some(format!("on the page: {nonsense}"));
        }
        let twice = self.page.ask(TWICE).await;
        if twice != json!([]) {
            return Some(format!("ids that are not one's own: {twice}"));
        }
        let alive = self
            .page
            .ask("return document.documentElement.dataset.ready === 'true' && !document.getElementById('app').hidden")
            .await;
        if alive != json!(true) {
            return Some("the page is gone".to_owned());
        }
        let kept = self.page.ask(KEPT).await;
        for text in kept.as_array().unwrap() {
            let text = text.as_str().unwrap();
            match State::parse(text).map_err(|problem| vec![problem]) {
                Ok(state) => {
                    if let Err(problems) = state.check() {
                        return Some(format!("kept {text}: {problems:?}"));
                    }
                }
                Err(problems) => return Some(format!("kept {text}: {problems:?}")),
            }
        }
        None
    }
}

/// The acts after which the page is looked over.
const ROUND: u32 = 10;

/// Rounds in the quick run.
const ROUNDS: u32 = 5;

/// A synthesis of two positions.
const SYNTHESIS: &str = "#2&kind=synthesis&d.frame=10.4&d.positions=%5B%7B%22output_deg%22:240,%22input_deg%22:45%7D,\
    %7B%22output_deg%22:253,%22input_deg%22:60%7D%5D&v.phi_deg=50&v.playing=true&v.direction=1&v.speed=1&v.traces=true&v.lang=en";

/// A four-bar as a scheme, cut in D.
const SCHEME: &str = "#2&kind=scheme&d.planar=true&d.ground=%220%22&d.cut=%5B%22D%22%5D&d.look_deg=%5B-30,25%5D&d.pairs=\
    %5B%7B%22name%22:%22A%22,%22kind%22:%22revolute%22,%22links%22:%5B%220%22,%221%22%5D,%22at%22:%5B0,0\
    %5D%7D,%7B%22name%22:%22B%22,%22kind%22:%22revolute%22,%22links%22:%5B%221%22,%222%22%5D,%22at%22:%5\
    B1,2%5D%7D,%7B%22name%22:%22C%22,%22kind%22:%22revolute%22,%22links%22:%5B%222%22,%223%22%5D,%22at%2\
    2:%5B5,3%5D%7D,%7B%22name%22:%22D%22,%22kind%22:%22revolute%22,%22links%22:%5B%223%22,%220%22%5D,%22\
    at%22:%5B6,0%5D%7D%5D\
    &v.phi_deg=50&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en";

/// A differential under load, near its limit.
const TRAIN: &str = "#2&kind=gear-train&d.z1=20&d.z2=10&d.z4=43&d.loaded=true\
    &d.drives=%5B%7B%22shaft%22:%22sun%22,%22rpm%22:60%7D,%7B%22shaft%22:%22ring%22,%22rpm%22:12%7D%5D\
    &d.load=%5B%5B1,0%5D,%5B3,10%5D,%5B4.5,10%5D,%5B5,0%5D%5D&v.phi_deg=0&v.t=1&v.plot=%22load%22\
    &v.playing=true&v.direction=1&v.speed=1&v.traces=true&v.lang=en";

/// Lines over a mechanism, measures, one quantity against another.
const OVER: &str = "#crank-rocker&v.polygons=true&v.centrodes=true&v.instant_centres=true&v.curvature=true\
    &v.measures=%5B%22A-C.distance%22,%22A-B-C.corner%22%5D&v.against=%7B%22x%22:%22C.x%22,%22y%22:%22C.y%22%7D";

#[tokio::test]
async fn nothing_breaks_whatever_somebody_does() {
    wander("", &[]).await;
}

#[tokio::test]
async fn nothing_breaks_in_a_drawing() {
    wander("#crank-rocker&v.drawing=true", &[]).await;
}

#[tokio::test]
async fn nothing_breaks_in_a_lesson_that_is_written() {
    wander("#jansen&v.playing=false", &["menu", "write-lesson"]).await;
}

#[tokio::test]
async fn nothing_breaks_in_a_lesson() {
    let lesson = "v.lesson=%7B%22id%22%3A%22class4-dwell%22%2C%22step%22%3A4%7D";
    wander(&format!("#class4-dwell&v.playing=false&{lesson}"), &[]).await;
}

#[tokio::test]
async fn nothing_breaks_over_a_mechanism() {
    wander(OVER, &[]).await;
}

#[tokio::test]
async fn nothing_breaks_in_a_synthesis() {
    wander(SYNTHESIS, &[]).await;
}

#[tokio::test]
async fn nothing_breaks_in_poses() {
    wander("#poses-three&v.playing=false", &[]).await;
}

#[tokio::test]
async fn nothing_breaks_along_a_path() {
    wander("#path-nine&v.playing=false", &[]).await;
}

#[tokio::test]
async fn nothing_breaks_in_a_scheme() {
    wander(SCHEME, &[]).await;
}

#[tokio::test]
async fn nothing_breaks_in_a_train() {
    wander(TRAIN, &[]).await;
}

/// Does whatever comes to hand, beginning at an address and with these presses.
async fn wander(address: &str, presses: &[&str]) {
    if lacking("mouse and keys that nothing waits for") {
        return;
    }
    let given = env::var("ASSUR_SEED").ok();
    let seed = given.map_or(20_261_122, |seed| seed.parse().unwrap());
    let page = Page::playing_at(&format!("{}{address}", home()), "en-US").await;
    for press in presses {
        page.click(press).await;
        page.settle().await;
    }
    let mut hand = Hand {
        page: &page,
        dice: Dice(seed),
        done: VecDeque::new(),
    };
    for round in 1..=scaled(ROUNDS) {
        for _ in 0..ROUND {
            hand.act().await;
        }
        page.settle().await;
        if let Some(wrong) = hand.wrong().await {
            panic!("seed {seed}, round {round}: {wrong}");
        }
    }
    // What the browser keeps is what a next visit opens with, without a word of complaint.
    page.reload().await;
    if let Some(wrong) = hand.wrong().await {
        panic!("seed {seed}, opened again: {wrong}");
    }
    drop(hand);
    page.close().await;
}
