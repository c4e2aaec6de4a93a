//! Completions and man pages, made from the same arguments as the help.

use super::Outcome;
use super::args::{Args, CompletionsArgs, ManArgs};
use super::output::{self, Failure};
use clap::CommandFactory;

/// `psdl completions SHELL`
pub(super) fn completions(args: &CompletionsArgs) -> Result<Outcome, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "psdl", &mut script);
    output::write(&script)?;
    Ok(Outcome::Clean)
}

/// `psdl man DIR`
pub(super) fn man(args: &ManArgs) -> Result<Outcome, Failure> {
    std::fs::create_dir_all(&args.folder).map_err(|error| Failure::at(&args.folder, &error))?;
    let mut root = Args::command();
    root.build();
    page(&root, "psdl", args)?;
    for command in root.get_subcommands().filter(|command| !command.is_hide_set() && command.get_name() != "help") {
        page(command, &format!("psdl-{}", command.get_name()), args)?;
    }
    Ok(Outcome::Clean)
}

fn page(command: &clap::Command, name: &str, args: &ManArgs) -> Result<(), Failure> {
    let path = args.folder.join(format!("{name}.1"));
    let mut page = Vec::new();
    let command = command.clone().display_name(name).disable_help_subcommand(true);
    clap_mangen::Man::new(command).title(name).render(&mut page).map_err(|error| Failure::at(&path, &error))?;
    output::write_file(&path, &page)
}
