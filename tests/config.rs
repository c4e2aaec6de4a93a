//! `psdl.toml`: what holds where, what is refused, and the schema that editors of TOML use.

use psdl::check::finding::{Code, Severity};
use psdl::config::settings::{self, Value};
use psdl::config::{ConfigError, Resolved, Resolver, schema, show};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What holds for a program among some configuration files.
fn resolve(files: &[(&str, &str)], program: &str) -> Result<Resolved, Arc<ConfigError>> {
    let read = |path: &Path| Ok(files.iter().find(|(name, _)| Path::new(name) == path).map(|(_, text)| (*text).to_string()));
    Resolver::new(read).resolve(Path::new(program))
}

/// The problems of a file, each with the text that is underlined.
fn problems(text: &str) -> Vec<(String, String)> {
    let error = resolve(&[("/p/psdl.toml", text)], "/p/a.psdl").expect_err("it is refused");
    assert_eq!(error.path, PathBuf::from("/p/psdl.toml"));
    error.problems.iter().map(|problem| (text[problem.range].to_string(), problem.message.clone())).collect()
}

#[test]
fn without_a_file_the_defaults_hold() {
    let resolved = resolve(&[], "/p/a.psdl").unwrap();
    assert_eq!(resolved.options, psdl::analysis::Options::default());
    assert!(show(&resolved, &|path| path.display().to_string()).contains("tolerance = 0.01"));
}

#[test]
fn the_nearest_file_above_holds_and_what_it_extends_under_it() {
    let files = [
        ("/psdl.toml", "[check]\ntolerance = 0.5"),
        ("/p/psdl.toml", "extend = \"base/strict.toml\"\n[check]\ntolerance = 0.02\n"),
        (
            "/p/base/strict.toml",
            "[check]\ntolerance = 0.001\nwall-tolerance = 0.1\n[severity]\noverlap = \"warning\"\nunplaced = \"off\"\n",
        ),
    ];
    let resolved = resolve(&files, "/p/scenes/deep/a.psdl").unwrap();
    assert_eq!((resolved.options.rules.tolerance, resolved.options.rules.wall_tolerance), (0.02, 0.1));
    assert_eq!(resolved.options.severities.of(Code::Overlap), Some(Severity::Warning));
    assert_eq!(resolved.options.severities.of(Code::Unplaced), None);
    assert_eq!(resolved.options.severities.of(Code::Standing), Some(Severity::Error));
    assert_eq!(resolved.files, [PathBuf::from("/p/base/strict.toml"), PathBuf::from("/p/psdl.toml")]);
    let shown = show(&resolved, &|path| path.display().to_string());
    let line = |key: &str| shown.lines().find(|line| line.starts_with(key)).unwrap_or_default().to_string();
    assert!(line("tolerance").ends_with("# /p/psdl.toml:3"), "{shown}");
    assert!(line("overlap = \"warning\"").ends_with("# /p/base/strict.toml:5"), "{shown}");
    assert!(line("standing = \"error\"").ends_with("# default"), "{shown}");
    let reread = resolve(&[("/q/psdl.toml", &shown)], "/q/a.psdl").unwrap();
    assert_eq!(reread.options, resolved.options, "what is shown says the same when it is read");
}

#[test]
fn overrides_hold_for_their_paths_and_exclusion_is_known() {
    let text = "exclude = [\"old/\", \"*.draft.psdl\"]\n[limits]\nsteps = 5000\n[[override]]\npaths = [\"generated/**\"]\nlimits.steps = 6_000\nseverity.overlap = \"info\"\n";
    let resolve = |program| resolve(&[("/p/psdl.toml", text)], program).unwrap();
    assert_eq!(resolve("/p/a.psdl").options.limits.steps, 5_000);
    assert_eq!(resolve("/p/generated/x/a.psdl").options.limits.steps, 6_000);
    assert_eq!(resolve("/p/generated/a.psdl").options.severities.of(Code::Overlap), Some(Severity::Info));
    let excluded = ["/p/a.psdl", "/p/old/a.psdl", "/p/x/b.draft.psdl"].map(|program| resolve(program).excluded);
    assert_eq!(excluded, [false, true, true]);
}

#[test]
fn what_is_wrong_is_refused_at_its_place() {
    let cases = [
        ("[check]\ntolerence = 0.1", "tolerence", "there is no setting \"tolerence\" in \"check\"; did you mean \"tolerance\"?"),
        ("[chek]\n", "chek", "did you mean \"check\"?"),
        ("extends = \"x\"", "extends", "did you mean \"extend\"?"),
        ("[severity]\noverlap = \"fatal\"", "\"fatal\"", "\"severity.overlap\" takes \"error\", \"warning\", \"info\" or \"off\""),
        ("[severity]\nsideways = \"error\"", "sideways", "there is no setting \"sideways\" in \"severity\""),
        ("[check]\ntolerance = -1", "-1", "\"check.tolerance\" takes a number from 0 to 1000"),
        ("[check]\ntolerance = nan", "nan", "takes a number"),
        ("[check]\ntolerance = \"thin\"", "\"thin\"", "takes a number"),
        ("[limits]\nsteps = 1.5", "1.5", "\"limits.steps\" takes an integer"),
        ("check = 3", "3", "\"check\" is a table of settings"),
        ("exclude = \"old\"", "\"old\"", "a list of texts"),
        ("[[override]]\nlimits.steps = 5000", "[[override]]", "\"paths\""),
        ("extend = \"none.toml\"", "\"none.toml\"", "does not exist"),
        ("extend = \"psdl.toml\"", "\"psdl.toml\"", "in a circle"),
        ("exclude = [\"a{\"]\n[check]\ntolerance = 2_000.0", "2_000.0", "takes a number"),
    ];
    for (text, underlined, message) in cases {
        let found = problems(text);
        assert_eq!(found.len(), 1, "{text}: {found:?}");
        assert_eq!(found[0].0, underlined, "{text}: {found:?}");
        assert!(found[0].1.contains(message), "{text}: {found:?}");
    }
    assert!(!problems("[check\ntolerance = = 3").is_empty());
}

#[test]
fn no_text_is_too_strange_to_be_read() {
    for text in ["\u{0}", "=", "[[[[", "a.b.c.d = 1", &"[a".repeat(5_000), &"x = [".repeat(5_000), "\u{feff}[check]\n", "override = [1]"] {
        let _ = resolve(&[("/p/psdl.toml", text)], "/p/a.psdl");
    }
}

#[test]
fn the_resolver_remembers_until_it_forgets() {
    let steps = std::sync::atomic::AtomicU64::new(5_000);
    let read = |path: &Path| {
        let steps = steps.load(std::sync::atomic::Ordering::Relaxed);
        Ok((path == Path::new("/p/psdl.toml")).then(|| format!("[limits]\nsteps = {steps}")))
    };
    let resolver = Resolver::new(read);
    let resolved = || resolver.resolve(Path::new("/p/a.psdl")).unwrap().options.limits.steps;
    assert_eq!(resolved(), 5_000);
    steps.store(7_000, std::sync::atomic::Ordering::Relaxed);
    assert_eq!(resolved(), 5_000);
    resolver.forget();
    assert_eq!(resolved(), 7_000);
}

#[test]
fn every_setting_can_be_set_and_read() {
    let mut options = psdl::analysis::Options::default();
    for setting in settings::all() {
        let value = match setting.get(&options) {
            Value::Number(number) => Value::Number(number + 0.25),
            Value::Count(count) => Value::Count(count + 1),
            Value::Severity(severity) => Value::Severity(if severity == Some(Severity::Info) { None } else { Some(Severity::Info) }),
        };
        let before = options.clone();
        setting.set(&mut options, value);
        assert_eq!(setting.get(&options), value, "{}", setting.key);
        let others = settings::all().into_iter().filter(|other| other.key != setting.key);
        assert!(others.into_iter().all(|other| other.get(&options) == other.get(&before)), "{} changes another setting", setting.key);
    }
}

#[test]
fn the_schema_takes_what_the_reader_takes() {
    let validator = jsonschema::validator_for(&schema()).expect("it is a schema");
    let cases = [
        ("", true),
        ("extend = \"a.toml\"\nexclude = [\"old/\"]\n[check]\ntolerance = 0\nweights.overlap = 1e3\n[severity]\noverlap = \"off\"", true),
        ("[[override]]\npaths = [\"a\"]\ncheck.clearance.door = 0.75", true),
        ("[check]\ntolerence = 1.0", false),
        ("[check]\ntolerance = -1.0", false),
        ("[severity]\noverlap = \"fatal\"", false),
        ("[limits]\nsteps = 1.5", false),
        ("[[override]]\nlimits.steps = 5000", false),
    ];
    for (text, good) in cases {
        let document: toml::Table = text.parse().expect("it is TOML");
        let document = serde_json::to_value(document).expect("it is JSON too");
        assert_eq!(validator.is_valid(&document), good, "{text}");
        let files = [("/p/psdl.toml", text), ("/p/a.toml", "")];
        assert_eq!(resolve(&files, "/p/a.psdl").is_ok(), good, "{text}");
    }
}
