//! Which vector instructions a kernel is compiled for, and the one place where that is chosen at run time.

/// A set of vector instructions that this processor has: whoever holds one may run the code compiled for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InstructionSet(Kind);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    #[cfg(target_arch = "x86_64")]
    Avx512,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    Baseline,
}

impl InstructionSet {
    /// What every processor of the target has.
    pub const BASELINE: InstructionSet = InstructionSet(Kind::Baseline);

    /// The widest set of this processor. Cheap: the processor is asked once per process.
    #[must_use]
    #[inline]
    pub fn best() -> InstructionSet {
        #[cfg(target_arch = "x86_64")]
        {
            if has_avx512() {
                return InstructionSet(Kind::Avx512);
            }
            if has_avx2() {
                return InstructionSet(Kind::Avx2);
            }
        }
        InstructionSet::BASELINE
    }

    /// Every set of this processor, the widest first.
    #[must_use]
    pub fn available() -> Vec<InstructionSet> {
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(has_avx512().then_some(InstructionSet(Kind::Avx512)));
            all.extend(has_avx2().then_some(InstructionSet(Kind::Avx2)));
        }
        all.push(InstructionSet::BASELINE);
        all
    }

    /// The name processor manuals use.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            Kind::Avx512 => "AVX-512",
            #[cfg(target_arch = "x86_64")]
            Kind::Avx2 => "AVX2 and FMA",
            Kind::Baseline => "baseline",
        }
    }

    #[doc(hidden)]
    #[cfg(target_arch = "x86_64")]
    #[must_use]
    #[inline]
    pub fn is_avx512(self) -> bool {
        self.0 == Kind::Avx512
    }

    #[doc(hidden)]
    #[cfg(target_arch = "x86_64")]
    #[must_use]
    #[inline]
    pub fn is_avx2(self) -> bool {
        self.0 == Kind::Avx2
    }
}

/// The features that [`multiversion!`](crate::kernels::multiversion) compiles its widest version with.
#[cfg(target_arch = "x86_64")]
#[inline]
fn has_avx512() -> bool {
    use std::arch::is_x86_feature_detected as has;
    has!("avx512f") && has!("avx512dq") && has!("avx512vl") && has!("avx512bw") && has_avx2()
}

#[cfg(target_arch = "x86_64")]
#[inline]
fn has_avx2() -> bool {
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

/// Compiles a safe function once per instruction set; its first parameter, an [`InstructionSet`], says which one runs.
///
/// The body is ordinary code, which the compiler vectorises for each set. What it calls must be `#[inline(always)]`
/// to be compiled with it.
macro_rules! multiversion {
    ($(#[$meta:meta])* $visibility:vis fn $name:ident($($argument:ident: $type:ty),* $(,)?) $(-> $result:ty)? $body:block) => {
        $(#[$meta])*
        #[inline]
        $visibility fn $name(set: $crate::kernels::InstructionSet, $($argument: $type),*) $(-> $result)? {
            #[inline(always)]
            fn every_set($($argument: $type),*) $(-> $result)? $body

            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
                fn avx512($($argument: $type),*) $(-> $result)? {
                    every_set($($argument),*)
                }
                #[target_feature(enable = "avx2,fma")]
                fn avx2($($argument: $type),*) $(-> $result)? {
                    every_set($($argument),*)
                }
                if set.is_avx512() {
                    // SAFETY: the only set for which `is_avx512` holds is made after the processor was found to have
                    // every feature named above (`has_avx512`).
                    return unsafe { avx512($($argument),*) };
                }
                if set.is_avx2() {
                    // SAFETY: as above, with `has_avx2`.
                    return unsafe { avx2($($argument),*) };
                }
            }
            // The baseline needs no choice.
            let _ = set;
            every_set($($argument),*)
        }
    };
}

pub(crate) use multiversion;
