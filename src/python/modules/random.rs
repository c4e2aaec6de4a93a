//! `_random`: the Mersenne Twister under `random`, whose distributions are in `lib/random.py`.

use super::Item;
use crate::python::classes::Builtin;
use crate::python::error::R;
use crate::python::native::{Args, Native};
use crate::python::numbers;
use crate::python::types::iterator::positional;
use crate::python::value::Value;
use crate::python::vm::Vm;
use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{Signed, ToPrimitive};
use rand_mt::Mt;
use sha2::{Digest, Sha512};

/// The numbers that a state is told by: as many as the Twister looks back.
const WORDS: usize = 624;

/// A generator of random numbers.
#[derive(Clone, Debug)]
pub struct Generator {
    twister: Mt,
    /// Numbers that come before the Twister's own: those of a restored state, the next one last.
    restored: Vec<u32>,
}

impl Default for Generator {
    /// Seeded with 0.
    fn default() -> Generator {
        Generator::seeded(&BigUint::ZERO)
    }
}

impl Generator {
    /// As `random.seed(n)` of CPython.
    pub fn seeded(seed: &BigUint) -> Generator {
        let mut key = seed.to_u32_digits();
        if key.is_empty() {
            key.push(0);
        }
        Generator { twister: Mt::new_with_key(key), restored: Vec::new() }
    }

    fn word(&mut self) -> u32 {
        self.restored.pop().unwrap_or_else(|| self.twister.next_u32())
    }

    /// A float of 53 random bits in [0, 1).
    pub fn float(&mut self) -> f64 {
        let (a, b) = (self.word() >> 5, self.word() >> 6);
        (f64::from(a) * 67_108_864.0 + f64::from(b)) * (1.0 / 9_007_199_254_740_992.0)
    }

    /// An int of `k` random bits.
    pub fn bits(&mut self, k: usize) -> BigUint {
        if k == 0 {
            return BigUint::ZERO;
        }
        let mut words = Vec::with_capacity(k.div_ceil(32));
        for left in (1..=k).rev().step_by(32) {
            let word = self.word();
            words.push(if left < 32 { word >> (32 - left) } else { word });
        }
        BigUint::new(words)
    }

    /// The numbers to come: they tell the state.
    fn state(&self) -> Vec<u32> {
        let mut copy = self.clone();
        (0..WORDS).map(|_| copy.word()).collect()
    }

    /// The generator whose next numbers are these.
    fn with_state(words: Vec<u32>) -> Option<Generator> {
        let twister = Mt::recover(words.iter().copied()).ok()?;
        Some(Generator { twister, restored: words.into_iter().rev().collect() })
    }
}

/// The generator that a number of `lib/random.py` means: 0 for the module's own.
fn generator<'a>(vm: &'a mut Vm<'_>, number: Value) -> &'a mut Generator {
    let number = match number {
        Value::Int(n, _) if n > 0 => n as usize,
        _ => 0,
    };
    match number.checked_sub(1).filter(|&at| at < vm.randoms.len()) {
        Some(at) => &mut vm.randoms[at],
        None => vm.random.get_or_insert_default(),
    }
}

/// `new()`: the number of a new generator.
fn new(vm: &mut Vm<'_>, _: Args<'_>) -> R<Value> {
    let bytes = std::mem::size_of::<Generator>() + 4 * WORDS;
    vm.reserve(bytes)?;
    if vm.randoms.len() >= 10_000 {
        return Err(vm.error(Builtin::MemoryError, String::new()));
    }
    vm.randoms.push(Generator::default());
    Ok(Value::int(vm.randoms.len() as i64))
}

/// `seed(generator, value)`; None means 0.
fn seed(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let value = vm.pin(args.at(1));
    let seed = match vm.plain(value) {
        Value::None => BigUint::ZERO,
        Value::Int(..) | Value::Bool(_) | Value::Big(_) => vm.index_big(value)?.magnitude().clone(),
        Value::Float(..) => (numbers::hash_number(vm, value).unwrap_or(0) as u64).into(),
        Value::Str(s) => of_bytes(vm.heap[s].text.clone().as_bytes()),
        Value::Bytes(b) => of_bytes(&vm.heap[b].0),
        Value::ByteArray(b) => of_bytes(&vm.heap[b].0),
        _ => {
            let message = "The only supported seed types are: None,\nint, float, str, bytes, and bytearray.";
            return Err(vm.type_error(message));
        }
    };
    *generator(vm, args.at(0)) = Generator::seeded(&seed);
    Ok(Value::None)
}

/// A seed that is text: its bytes and their SHA-512, as one number.
fn of_bytes(text: &[u8]) -> BigUint {
    BigUint::from_bytes_be(&[text, &Sha512::digest(text)[..]].concat())
}

fn random(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    positional(vm, "random", &args, 1, 1)?;
    Ok(Value::float(generator(vm, args.at(0)).float()))
}

fn bits(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let k = vm.index_big(args.at(1))?;
    if k.is_negative() {
        return Err(vm.value_error("number of bits must be non-negative"));
    }
    let Some(k) = k.to_i32() else {
        return Err(vm.error(Builtin::OverflowError, "Python int too large to convert to C int".into()));
    };
    vm.reserve(k as usize / 8)?;
    vm.charge(k as u64 / 64)?;
    let bits = generator(vm, args.at(0)).bits(k as usize);
    Ok(vm.heap.big(BigInt::from_biguint(Sign::Plus, bits)))
}

/// `below(generator, n)`: an int in 0..n, drawn as CPython draws it.
fn below(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let n = vm.index_big(args.at(1))?;
    let k = n.bits() as usize;
    if n.sign() != Sign::Plus {
        return Ok(Value::int(0));
    }
    vm.reserve(k / 8)?;
    loop {
        vm.charge(1 + k as u64 / 64)?;
        let r = BigInt::from_biguint(Sign::Plus, generator(vm, args.at(0)).bits(k));
        if r < n {
            return Ok(vm.heap.big(r));
        }
    }
}

fn get_state(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    vm.charge(WORDS as u64)?;
    let words: Vec<Value> = generator(vm, args.at(0)).state().into_iter().map(|w| Value::int(w.into())).collect();
    Ok(vm.new_tuple(words))
}

fn set_state(vm: &mut Vm<'_>, args: Args<'_>) -> R<Value> {
    let items = vm.collect(args.at(1))?;
    let mut words = Vec::with_capacity(items.len());
    for item in items {
        let word = vm.index(item)?;
        words.push(word as u32);
    }
    match Generator::with_state(words) {
        Some(restored) => *generator(vm, args.at(0)) = restored,
        None => return Err(vm.value_error("state vector is the wrong size")),
    }
    Ok(Value::None)
}

macro_rules! functions {
    ($($name:literal, $arity:literal, $body:expr;)*) => {
        /// What `import _random` brings.
        pub const ITEMS: &[(&str, Item)] = &[$(($name, {
            static NATIVE: Native = Native::function($name, $arity, $arity, $body);
            Item::Native(&NATIVE)
        }),)*];
    };
}

functions! {
    "new", 0, new;
    "seed", 2, seed;
    "random", 1, random;
    "getrandbits", 2, bits;
    "below", 2, below;
    "getstate", 1, get_state;
    "setstate", 2, set_state;
}

#[cfg(test)]
mod tests {
    use super::Generator;

    #[test]
    fn the_numbers_of_cpython() {
        let mut generator = Generator::default();
        assert_eq!(generator.float(), 0.844_421_851_525_048_1);
        assert_eq!(generator.float(), 0.757_954_402_940_302_5);
        let mut generator = Generator::seeded(&(1u64 << 40).into());
        assert_eq!(generator.bits(70).to_string(), "781279065922817498497");
    }

    #[test]
    fn a_state_is_restored() {
        let mut generator = Generator::default();
        generator.word();
        let mut again = Generator::with_state(generator.state()).unwrap();
        for _ in 0..2000 {
            assert_eq!(generator.word(), again.word());
        }
    }
}
