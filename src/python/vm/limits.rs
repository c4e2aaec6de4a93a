//! What a run may use.

/// The budget of a run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Instructions, roughly; native loops count per item.
    pub steps: u64,
    /// Bytes of live objects.
    pub memory: usize,
    /// Activations of Python functions.
    pub recursion: usize,
    /// Bytes of printed text.
    pub output: u64,
}

impl Default for Limits {
    /// More than any scene needs, less than a person waits for: a loop without end meets the step limit in about 150 ms.
    fn default() -> Limits {
        Limits { steps: 20_000_000, memory: 256 << 20, recursion: 1000, output: 1 << 20 }
    }
}
