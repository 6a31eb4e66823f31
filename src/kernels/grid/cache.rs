//! How large the last cache of this processor is.

use std::sync::OnceLock;

/// What most processors have at least.
const USUAL: usize = 16 << 20;

/// Bytes of the last cache; a usual size where the processor does not say.
pub(super) fn last_cache() -> usize {
    static BYTES: OnceLock<usize> = OnceLock::new();
    *BYTES.get_or_init(|| stated().unwrap_or(USUAL))
}

/// The largest of the caches that the processor lists.
#[cfg(target_arch = "x86_64")]
fn stated() -> Option<usize> {
    use std::arch::x86_64::__cpuid_count;

    /// Where Intel's processors list their caches, and where AMD's do; both in the same form.
    const LISTS: [u32; 2] = [4, 0x8000_001d];
    /// More caches than any processor has.
    const MOST: u32 = 16;
    let highest = |list: u32| __cpuid_count(list & 0x8000_0000, 0).eax;
    let caches = LISTS.into_iter().filter(|list| highest(*list) >= *list).flat_map(|list| {
        let listed = (0..MOST).map(move |index| __cpuid_count(list, index));
        // Kind 0 ends the list.
        listed.take_while(|cache| cache.eax & 0x1f != 0)
    });
    let size = |cache: std::arch::x86_64::CpuidResult| {
        let part = |from: u32, bits: u32| ((cache.ebx >> from) & ((1 << bits) - 1)) as usize + 1;
        let [line, partitions, ways, sets] = [part(0, 12), part(12, 10), part(22, 10), cache.ecx as usize + 1];
        // Virtual machines may list anything.
        [partitions, ways, sets].into_iter().fold(line, usize::saturating_mul)
    };
    caches.map(size).max()
}

#[cfg(not(target_arch = "x86_64"))]
fn stated() -> Option<usize> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn last_cache_has_the_size_of_one() {
        let bytes = last_cache();
        assert!(((256 << 10)..=(4 << 30)).contains(&bytes), "{bytes}");
    }
}
