//! Notes what the program was built from, for `psdl --version --verbose`.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=PSDL_COMMIT");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_string());
    println!("cargo::rustc-env=PSDL_RUSTC={}", said(&rustc, &["--version"]).unwrap_or_else(|| "unknown".to_string()));
    println!("cargo::rustc-env=PSDL_TARGET={}", std::env::var("TARGET").unwrap_or_else(|_| "unknown".to_string()));
    let commit = std::env::var("PSDL_COMMIT").ok().or_else(|| said("git", &["rev-parse", "--short=12", "HEAD"]));
    if let Some(commit) = commit {
        println!("cargo::rustc-env=PSDL_COMMIT={commit}");
    }
}

/// What a command prints in one line.
fn said(command: &str, args: &[&str]) -> Option<String> {
    let output = Command::new(command).args(args).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    (output.status.success() && !text.trim().is_empty()).then(|| text.trim().to_string())
}
