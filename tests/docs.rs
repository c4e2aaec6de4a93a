//! The pages that are made from the code are those in the repository. `PSDL_UPDATE_DOCS=1 cargo test --test docs` writes them anew.

use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Holds a file against what it should be, or writes it.
fn assert_current(path: &Path, page: &str) {
    let path = root().join(path);
    if std::env::var_os("PSDL_UPDATE_DOCS").is_some() {
        std::fs::create_dir_all(path.parent().expect("the file is in a folder")).expect("the folder can be made");
        std::fs::write(&path, page).expect("the page can be written");
    }
    let there = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(there == page, "{} is stale: run PSDL_UPDATE_DOCS=1 cargo test --test docs", path.display());
}

#[test]
fn every_finding_has_its_page() {
    let folder = Path::new("docs/findings");
    assert_current(&folder.join("README.md"), &psdl::check::codes::index_page());
    let mut names = vec!["README.md".to_string()];
    for info in psdl::check::codes::all() {
        let name = format!("{}.md", info.name);
        assert_current(&folder.join(&name), &info.page());
        names.push(name);
    }
    for entry in std::fs::read_dir(root().join(folder)).expect("the folder is there") {
        let name = entry.expect("it can be listed").file_name().to_string_lossy().into_owned();
        assert!(names.contains(&name), "docs/findings/{name} belongs to no finding");
    }
}

#[test]
fn the_schema_of_the_configuration_is_shipped() {
    let schema = serde_json::to_string_pretty(&psdl::config::schema()).expect("it is JSON") + "\n";
    assert_current(Path::new("docs/psdl.schema.json"), &schema);
}

#[test]
fn the_program_that_models_are_shown_is_clean() {
    let prompt = std::fs::read_to_string(root().join("prompts/scene.md")).unwrap();
    let program = prompt.split("```python\n").nth(1).unwrap().split("```").next().unwrap();
    let input = psdl::analysis::Input { text: program, template: None };
    let analysis = psdl::analysis::analyse(&input, &psdl::analysis::Options::default(), None);
    let findings: Vec<String> = analysis.findings.iter().map(|finding| format!("{}: {}", finding.code, finding.message)).collect();
    assert_eq!(findings, [""; 0]);
    assert_eq!(analysis.object_names().len(), 6);
}
