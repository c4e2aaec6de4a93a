//! `psdl --version`

/// One line, or all that a report of a bug should say.
pub(super) fn text(verbose: bool) -> String {
    let version = env!("CARGO_PKG_VERSION");
    if !verbose {
        return format!("psdl {version}\n");
    }
    let commit = option_env!("PSDL_COMMIT").unwrap_or("unknown");
    let profile = if cfg!(debug_assertions) { "debug" } else { "release" };
    let threads = std::thread::available_parallelism().map_or_else(|_| "unknown".to_string(), |n| n.to_string());
    format!(
        "psdl {version}\ncommit: {commit}\nbuilt for: {}\nbuilt by: {} ({profile})\nlanguage: Python 3.11\nthreads: {threads}\nterm: {}\n",
        env!("PSDL_TARGET"),
        env!("PSDL_RUSTC"),
        std::env::var("TERM").unwrap_or_default(),
    )
}
