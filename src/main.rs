//! The program `psdl`; everything it does stands in the library.

fn main() -> std::process::ExitCode {
    psdl::cli::main()
}
