//! A mouse, a wheel and fingers on elements of the page.

use serde_json::json;

use crate::browser::{Page, in_firefox};

impl Page {
    /// Drags with the pointer over a control, from and to shares of its width.
    pub(crate) async fn drag(&self, id: &str, from: f64, to: f64) {
        let element = self.element(id).await;
        let area = element.rect().await.unwrap();
        let y = area.y + area.height / 2.0;
        let x = |share: f64| (area.x + share * area.width).round() as i64;
        self.hand()
            .move_to(x(from), y as i64)
            .click_and_hold()
            .move_to(x(0.5 * (from + to)), y as i64)
            .move_to(x(to), y as i64)
            .release()
            .perform()
            .await
            .unwrap();
        self.settle().await;
    }

    /// Moves the pointer to a place of an element, in pixels from its corner.
    pub(crate) async fn hover(&self, id: &str, (x, y): (f64, f64)) {
        let area = self.element(id).await.rect().await.unwrap();
        let at = ((area.x + x).round() as i64, (area.y + y).round() as i64);
        let chain = self.hand();
        chain.move_to(at.0, at.1).perform().await.unwrap();
        self.settle().await;
    }

    pub(crate) async fn double_click(&self, id: &str, place: (f64, f64)) {
        self.hover(id, place).await;
        let chain = self.hand();
        chain.double_click().perform().await.unwrap();
        self.settle().await;
    }

    /// Drags with the mouse along places of an element.
    pub(crate) async fn drag_along(&self, id: &str, places: &[(f64, f64)]) {
        let area = self.element(id).await.rect().await.unwrap();
        let at = |(x, y): (f64, f64)| ((area.x + x).round() as i64, (area.y + y).round() as i64);
        let (x, y) = at(places[0]);
        let mut chain = self.hand().move_to(x, y).click_and_hold();
        for place in &places[1..] {
            let (x, y) = at(*place);
            chain = chain.move_to(x, y);
        }
        chain.release().perform().await.unwrap();
        self.settle().await;
    }

    /// Puts fingers on places of an element, moves them and lifts them: every
    /// entry is where all of them are.
    pub(crate) async fn fingers(&self, id: &str, moments: &[Vec<(f64, f64)>]) {
        let script = "const area = document.getElementById(arguments[0]).getBoundingClientRect();
            return [area.x, area.y];";
        let corner = self.driver.execute(script, vec![id.into()]).await.unwrap();
        let [left, top]: [f64; 2] = corner.convert().unwrap();
        if in_firefox() {
            self.act(hands(moments, [left, top])).await;
            return;
        }
        let tools = self.driver.cdp();
        for (index, moment) in moments.iter().enumerate() {
            let points: Vec<_> = moment
                .iter()
                .enumerate()
                .map(|(id, (x, y))| json!({ "x": left + x, "y": top + y, "id": id }))
                .collect();
            let kind = if index == 0 {
                "touchStart"
            } else {
                "touchMove"
            };
            let event = json!({ "type": kind, "touchPoints": points });
            let sent = tools.send_raw("Input.dispatchTouchEvent", event);
            sent.await.unwrap();
        }
        let lifted = json!({ "type": "touchEnd", "touchPoints": [] });
        let sent = tools.send_raw("Input.dispatchTouchEvent", lifted);
        sent.await.unwrap();
        self.settle().await;
    }

    /// Taps the middle of an element with a finger.
    pub(crate) async fn tap(&self, id: &str) {
        let area = self.element(id).await.rect().await.unwrap();
        self.fingers(id, &[vec![(area.width / 2.0, area.height / 2.0)]])
            .await;
    }

    /// Turns the wheel over a place of an element; away from the person is below 0.
    pub(crate) async fn wheel(&self, id: &str, (x, y): (f64, f64), by: f64) {
        let area = self.element(id).await.rect().await.unwrap();
        if in_firefox() {
            let whole = |number: f64| number.round() as i64;
            let turn = json!({ "type": "scroll", "x": whole(area.x + x), "y": whole(area.y + y),
                "deltaX": 0, "deltaY": whole(by) });
            self.act(json!([{ "type": "wheel", "id": "wheel", "actions": [turn] }]))
                .await;
            return;
        }
        let event = json!({ "type": "mouseWheel", "x": area.x + x, "y": area.y + y,
            "deltaX": 0, "deltaY": by });
        self.tool("Input.dispatchMouseEvent", event).await;
        self.settle().await;
    }

    /// Places of the drawing where something can be taken hold of.
    pub(crate) async fn handles(&self) -> Vec<(f64, f64)> {
        let script = "const canvas = document.getElementById('mechanism');
            const { left, top, width, height } = canvas.getBoundingClientRect();
            const found = [];
            for (let x = 4; x < width; x += 20) for (let y = 4; y < height; y += 20) {
                canvas.dispatchEvent(new PointerEvent('pointermove', { clientX: left + x, clientY: top + y, pointerType: 'mouse' }));
                if (canvas.dataset.hand === 'open') found.push([x, y]);
            }
            return found;";
        serde_json::from_value(self.ask(script).await).unwrap()
    }
}

/// Fingers as sequences of actions: each is put down at the first moment it is there, moved, and lifted at the end.
fn hands(moments: &[Vec<(f64, f64)>], [left, top]: [f64; 2]) -> serde_json::Value {
    let most = moments.iter().map(Vec::len).max().unwrap_or(0);
    let finger = |finger: usize| {
        let mut down = false;
        let mut actions = Vec::new();
        for moment in moments {
            let Some((x, y)) = moment.get(finger) else {
                actions.extend([json!({ "type": "pause" }), json!({ "type": "pause" })]);
                continue;
            };
            actions.push(json!({ "type": "pointerMove", "x": (left + x).round(), "y": (top + y).round(), "duration": 0 }));
            actions.push(if down {
                json!({ "type": "pause" })
            } else {
                json!({ "type": "pointerDown", "button": 0 })
            });
            down = true;
        }
        actions.push(json!({ "type": "pointerUp", "button": 0 }));
        json!({ "type": "pointer", "id": format!("finger {finger}"), "parameters": { "pointerType": "touch" },
            "actions": actions })
    };
    (0..most).map(finger).collect()
}
