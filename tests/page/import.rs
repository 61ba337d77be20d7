//! What other programs made: links of PMKS+ that are pasted or dropped, files of Linkage that are chosen or dropped;
//! what could not be taken over by name, and damaged ones.

use std::fs;

use assur_tests::files::root;
use serde_json::json;

use crate::browser::Page;

/// The punch press of PMKS+, with a force and masses; `crates/assur-import/tests/published/pmks.txt` says where it is from.
const LINK: &str = "https://app.pmksplus.com/?2P.Ay,1E8.K,0.1011.MA,A,0,0,0.GB,B,0,Im,0.GC,C,0,0r8,0.LP,P,0,0r8,OZ..\
    YRAB,Crank,VG,o,0,9O,c5cae9,A,B,,.YRBC,Connecting rod,ku,6G,0,0HC,303e9f,B,C,,.YPCP,CP,1Tm,0,0,0,,C,P,,..\
    2F1,BC,F1,0,0r8,0,0bW,1Xg0..N_J";

/// The four-bar of issue 91 of PMKS+, in the first form.
const FIRST: &str = "https://pmksplus.mech.website/?j=A,4.1,3.75,AB,R,t,0,0.1,t,%0AB,1.244,0.196,AB%7CCBE,R,f,0,0.1,f,%0A\
    C,-2.32,-2.293,DC%7CCBE,R,f,0,0.1,f,%0AD,0.165,1.322,DC,R,t,0,0.1,f,%0AE,-2.591,1.657,CBE,R,f,0,0.1,f,%0A\
    &l=AB,1,1,1.9,3.2,A%7CB,,l%0ADC,1,1,2.0,2.5,C%7CD,,l%0ACBE,1,1,1.5,2.2,B%7CC%7CE,,et&f=&pp=&tp=&s=10,false,false,cm";

fn of_linkage(name: &str) -> String {
    let folder = root().join("crates/assur-import/tests/published/linkage2");
    fs::read_to_string(folder.join(name)).unwrap()
}

/// Pastes a text where an element is, as a browser tells of it; whether the page took it.
async fn paste(page: &Page, text: &str, into: &str) -> bool {
    let script = format!(
        "const data = new DataTransfer(); data.setData('text/plain', {});
         const event = new ClipboardEvent('paste', {{ bubbles: true, cancelable: true }});
         // Not every browser takes it from a script.
         Object.defineProperty(event, 'clipboardData', {{ value: data }});
         return !document.querySelector({}).dispatchEvent(event);",
        json!(text),
        json!(into)
    );
    page.ask(&script).await.as_bool().unwrap()
}

/// Drops a file, or a text where it has no name, on the drawing.
async fn drop_on(page: &Page, name: Option<&str>, text: &str) {
    let add = match name {
        Some(name) => format!(
            "data.items.add(new File([{}], {}))",
            json!(text),
            json!(name)
        ),
        None => format!("data.setData('text/plain', {})", json!(text)),
    };
    let script = format!(
        "const data = new DataTransfer(); {add};
         const at = {{ dataTransfer: data, bubbles: true, cancelable: true }};
         const stage = document.querySelector('#mechanism');
         const over = !stage.dispatchEvent(new DragEvent('dragover', at));
         return over && !stage.dispatchEvent(new DragEvent('drop', at));"
    );
    assert_eq!(page.ask(&script).await, json!(true));
}

async fn told(page: &Page, part: &str) -> String {
    page.until(part, async || page.text("notice-text").await.contains(part))
        .await;
    page.text("notice-text").await
}

/// What is open, as it is kept.
async fn kept(page: &Page) -> serde_json::Value {
    page.settle().await;
    let script = "return JSON.parse(localStorage.getItem('assur.state'))";
    page.ask(script).await
}

/// The document that is open.
async fn document(page: &Page) -> serde_json::Value {
    kept(page).await["document"].clone()
}

#[tokio::test]
async fn a_link_of_pmks_is_pasted() {
    let page = Page::open().await;
    let before = page.text("mechanism-name").await;
    assert!(paste(&page, LINK, "body").await);
    let said = told(&page, "PMKS+").await;
    for part in [
        "PMKS+, app.pmksplus.com was opened",
        "Forces are left out: F1.",
        "Crank was driven at −20 rpm",
    ] {
        assert!(said.contains(part), "{said}");
    }
    page.until("the mechanism", async || {
        document(&page).await["links"].is_array()
    })
    .await;
    let links = document(&page).await["links"].clone();
    let names: Vec<_> = links
        .as_array()
        .unwrap()
        .iter()
        .map(|link| link["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["Crank", "Connecting rod", "C"]);
    // What is told follows the language, and what is opened keeps it.
    page.choose("lang", "ru").await;
    told(&page, "Силы опущены: F1.").await;
    assert!(paste(&page, FIRST, "body").await);
    told(&page, "pmksplus.mech.website): ").await;
    page.click("undo").await;
    page.choose("lang", "en").await;
    page.click("undo").await;
    page.until("the one before", async || {
        page.text("mechanism-name").await == before
    })
    .await;
    page.close().await;
}

#[tokio::test]
async fn a_link_of_the_first_form_is_dropped() {
    let page = Page::open().await;
    drop_on(&page, None, FIRST).await;
    let said = told(&page, "pmksplus.mech.website").await;
    assert!(said.contains("AB was driven at 10 rpm"), "{said}");
    page.until("the mechanism", async || {
        document(&page).await["unit"] == "cm"
    })
    .await;
    page.close().await;
}

#[tokio::test]
async fn files_of_linkage_are_chosen_and_dropped() {
    let page = Page::open().await;
    let path = page.downloads().join("Jansen’s leg.linkage2");
    fs::write(&path, of_linkage("jansen.linkage2")).unwrap();
    page.choose_file("file", &path).await;
    told(&page, "Jansen’s leg.linkage2 was opened").await;
    page.until("its title", async || {
        document(&page).await["title"] == "Jansen’s leg"
    })
    .await;
    let document_of = document(&page).await;
    assert_eq!(document_of["source"], "Linkage (.linkage2)");
    assert_eq!(document_of["links"].as_array().unwrap().len(), 7);

    drop_on(
        &page,
        Some("piston.linkage2"),
        &of_linkage("piston.linkage2"),
    )
    .await;
    let said = told(&page, "piston.linkage2").await;
    assert!(said.contains("only drawings: 6"), "{said}");
    // Our own files are dropped in the same way.
    let mut own = kept(&page).await;
    own["view"]["lang"] = json!("uk");
    drop_on(&page, Some("own.assur.json"), &own.to_string()).await;
    page.until("our own", async || {
        page.lang().await.as_deref() == Some("uk")
    })
    .await;
    assert_eq!(page.text("notice-text").await, "");
    page.close().await;
}

#[tokio::test]
async fn damaged_ones_change_nothing() {
    let page = Page::open().await;
    let before = page.text("mechanism-name").await;
    let jansen = of_linkage("jansen.linkage2");
    let cut = &LINK[..LINK.len() - 12];
    assert!(paste(&page, cut, "body").await);
    let said = told(&page, "check character").await;
    assert!(
        said.starts_with("The pasted text could not be opened"),
        "{said}"
    );
    for (name, text, part) in [
        (
            "<img src=x>.linkage2",
            jansen.replace("352", "<img src=x>"),
            "<img src=x>.linkage2",
        ),
        (
            "d.pmks",
            "2P.Fe.K,0.1011.MA,A,0,0,0...N_9".to_owned(),
            "check character",
        ),
    ] {
        drop_on(&page, Some(name), &text).await;
        told(&page, part).await;
        assert!(page.text("notice-text").await.contains(name), "{name}");
        page.click("notice-close").await;
    }
    drop_on(&page, None, "some other text").await;
    told(&page, "neither a PMKS+ link nor a Linkage file").await;
    page.click("notice-close").await;
    assert_eq!(page.count("#notice img").await, 0);
    assert_eq!(page.text("mechanism-name").await, before);
    // Other texts, and what is pasted into a field, are none of ours.
    assert!(!paste(&page, "some other text", "body").await);
    assert!(!paste(&page, LINK, "#field-l2").await);
    assert_eq!(page.text("notice-text").await, "");
    // What does not move is a drawing, and says why.
    let still = jansen.replace(" input=\"true\"", "");
    drop_on(&page, Some("e.linkage2"), &still).await;
    page.until("the reason", async || {
        page.count("#draw-reasons [data-code=no_driver]").await == 1
    })
    .await;
    page.close().await;
}
